/* Lighting of surfaces: its passes, the lights' texels, the sky as a light, and the backdrop. */
#ifndef MATC_LIGHT_LIGHTING_H
#define MATC_LIGHT_LIGHTING_H
#include "runtime/light/light_state.h"
#include "runtime/frame_graph/frame_pass.h"

/* The sky as a light (light_sky.c): reports whether the scene's sky gives light; builds
 * render->light->sky from the GPU scene's sky; sets a pass's uniforms; binds the cube map. */
bool light_sky_shines(const Scene *scene);
bool light_sky_make(Renderer *renderer);
void light_sky_set(const Renderer *renderer, int unit, ScreenPass *pass);
void light_sky_bind(const Renderer *renderer, int unit);
extern const FramePass pass_light_cluster, pass_light;

/* Surfaces that a pass lights, and the lights that it sums. layers: transparent layers, by all
 * lights. nearest: the nearest surface, by all lights except those that ambient occlusion dims.
 * around: the nearest surface, by ambient lights alone, without shadows. nodes: nodes of the
 * radiance cache, by the lights of nearest. */
typedef enum { LIGHTING_layers, LIGHTING_nearest, LIGHTING_around, LIGHTING_nodes } LightingOf;

/* A pass that lights surfaces: its own GLSL follows the unpacking of the G-buffer, the surface
 * model and lighting.glsl. */
enum { LIGHTING_PIECES = 7 };
typedef struct {
    const char *body[LIGHTING_PIECES]; /* texts of the body; NULL for unused pieces */
    bool over;                         /* the body defines passOver() */
    int block;                         /* binding of a block, as in screen_pass.h */
    LightingOf of;
} LightingText;
enum {
    LIGHTING_UNITS = FRAMEBUFFER_COLORS + 10,
    LIGHTING_FREE_UNIT = LIGHTING_UNITS /* unit for a texture of the pass itself */
};
bool lighting_make(Renderer *renderer, const LightingText *text, ScreenPass *made);
/* Backdrop: GLSL of backdropAt(), or "", for the pass tone, and for passes that light if the
 * scene has transparent surfaces. With `light` the backdrop is scaled to radiance. */
const char *backdrop_text(const Renderer *renderer);
const char *backdrop_light_text(const Renderer *renderer);
void backdrop_set(const Renderer *renderer, bool light, ScreenPass *pass);
/* Counts the lights, and writes their texels. */
bool lighting_lights(Renderer *renderer);
/* The lights' texels: writes them; writes the definitions of the lighting's GLSL; sets a pass's
 * uniforms; binds the texture to a unit; frees them. */
enum { LIGHT_TABLE_DEFINITION = 64 };
bool light_table_write(Renderer *renderer, int unit);
void light_table_define(const Renderer *renderer, bool scattered,
                        char defined[LIGHT_TABLE_DEFINITION]);
void light_table_set(const Renderer *renderer, int unit, ScreenPass *pass);
void light_table_bind(const Renderer *renderer, int unit);
void light_table_delete(Renderer *renderer);
/* The sum over kinds of lights (light_sum.c): adds the texts of the scene's kinds to a pass,
 * without those with a position unless `places`; composes the functions that lighting.glsl
 * declares, which follow it and the texts once more with LIGHT_SENDS defined; sets their
 * uniforms. */
enum { LIGHT_SUM_TEXT = 4096 };
void light_sum_texts(const Renderer *renderer, bool places, ScreenPassText *text);
void light_sum_compose(const Renderer *renderer, bool places, char composed[LIGHT_SUM_TEXT]);
void light_sum_set(const Renderer *renderer, ScreenPass *pass);
/* Sets the tile's position in a pass, if it has been built. */
void lighting_place(const Renderer *renderer, ScreenPass *pass);
/* Update a pass, if it has been built, after a change of the camera or lights (but not of their
 * number), and after objects moved. */
bool lighting_changed(Renderer *renderer, unsigned what, ScreenPass *pass);
void lighting_moved(const Renderer *renderer, ScreenPass *pass);
/* Runs a pass over the target light, once for each tile of shadow lists. The source has its
 * G-buffer and depth targets, and a texture of the pass itself; 0: none. */
typedef struct {
    FrameTarget surfaces, depth;
    GLuint own;
} LightingSource;
void lighting_run(Renderer *renderer, const LightingSource *source, ScreenPass *pass);
/* Binds the textures that such a pass reads, before it runs. */
void lighting_bind(const Renderer *renderer, FrameTarget surfaces, FrameTarget depth);
#endif
