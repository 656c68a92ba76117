/* Light on surfaces: its passes, what lights are as numbers, the sky as a light, what stands behind
 * everything. */
#ifndef MATC_LIGHT_LIGHTING_H
#define MATC_LIGHT_LIGHTING_H
#include "runtime/light/light_state.h"
#include "runtime/frame/frame_pass.h"

/* The sky as a light (light_sky.c): whether the scene has a sky that gives light; builds
 * render->light->sky from the cache's sky; sets a pass's uniforms; binds the map. */
bool light_sky_shines(const Scene *scene);
bool light_sky_make(Render *render);
void light_sky_set(const Render *render, int unit, ScreenPass *pass);
void light_sky_bind(const Render *render, int unit);
extern const FramePass pass_gather, pass_light;

/* Surfaces that a pass lights, and the lights: layers of what is transparent by all lights; what is
 * nearest, by all lights but those that indirect light dims; or that by
 * light from all around alone, without any that has a place, and without shadows; nodes of cached
 * radiance, by the lights of what is nearest. */
typedef enum { LIGHTING_layers, LIGHTING_nearest, LIGHTING_around, LIGHTING_nodes } LightingOf;

/* A pass that lights surfaces: its own GLSL stands behind what reads the G-buffer, the surface
 * model and lighting.glsl. */
enum { LIGHTING_PIECES = 7 };
typedef struct {
    const char *body[LIGHTING_PIECES]; /* NULL where there is none */
    bool over;                         /* it is passOver() */
    int block;                         /* of screen_pass.h */
    LightingOf of;
} LightingText;
enum {
    LIGHTING_UNITS = FRAMEBUFFER_COLORS + 10,
    LIGHTING_FREE_UNIT = LIGHTING_UNITS /* for a texture of the pass's own */
};
bool lighting_make(Render *render, const LightingText *text, ScreenPass *made);
/* GLSL of backdropAt(), or "": for the pass tone; for passes that light, if something is
 * transparent. What a pass shows of it may be light. */
const char *backdrop_text(const Render *render);
const char *backdrop_light_text(const Render *render);
void backdrop_set(const Render *render, bool light, ScreenPass *pass);
/* Counts the lights, and writes their numbers. */
bool lighting_lights(Render *render);
/* Numbers of lights: written, or written again; what the lighting's GLSL goes by; handed to a pass
 * that lights; bound to a unit; deleted. */
enum { LIGHT_TABLE_DEFINITION = 64 };
bool light_table_write(Render *render, int unit);
void light_table_define(const Render *render, bool scattered, char defined[LIGHT_TABLE_DEFINITION]);
void light_table_set(const Render *render, int unit, ScreenPass *pass);
void light_table_bind(const Render *render, int unit);
void light_table_delete(Render *render);
/* The sum over kinds of lights (light_sum.c): adds the texts of the scene's kinds to a pass,
 * without those that have a place unless `places`; composes the functions that lighting.glsl
 * declares, which follow it and the texts once more with LIGHT_SENDS defined; sets the numbers that
 * they read. */
enum { LIGHT_SUM_TEXT = 4096 };
void light_sum_texts(const Render *render, bool places, ScreenPassText *text);
void light_sum_compose(const Render *render, bool places, char composed[LIGHT_SUM_TEXT]);
void light_sum_set(const Render *render, ScreenPass *pass);
/* Tells it where the tile is, if it is made. */
void lighting_place(const Render *render, ScreenPass *pass);
/* Update a pass, if it has been built, after a change of the camera or lights (but not of their
 * number), and after objects moved. */
bool lighting_changed(Render *render, unsigned what, ScreenPass *pass);
void lighting_moved(const Render *render, ScreenPass *pass);
/* Runs it over the light, once for each part of shadows' lists. It reads these targets, and a
 * texture of its own, or 0. */
typedef struct {
    FrameTarget surfaces, depth;
    GLuint own;
} LightingSource;
void lighting_run(Render *render, const LightingSource *source, ScreenPass *pass);
/* Binds what it reads, before it runs. */
void lighting_bind(const Render *render, FrameTarget surfaces, FrameTarget depth);
#endif
