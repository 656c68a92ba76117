/* Interface of shadows for the passes: shadow maps, lists of transparent fragments, infinite
 * planes; and data that the lighting reads. */
#ifndef MATC_SHADOW_SHADOW_H
#define MATC_SHADOW_SHADOW_H
#include "runtime/frame_graph/frame_pass.h"
#include "compiler/base/text.h"
#include "runtime/gpu_material/screen_pass.h"
#include "runtime/shadow/shadow_state.h"
#include "runtime/frame_graph/renderer_options.h"

/* Returns whether shadows are enabled, and some light of the scene casts them. */
bool shadow_is_cast(const Renderer *renderer);
/* Returns whether shadows are enabled, and some area light casts them. */
bool shadow_is_soft(const Renderer *renderer);
/* Returns the method by which transparent surfaces cast shadows. */
MaterialSetCasts shadow_casts(const Renderer *renderer);

/* -- The buffer of transparent fragments (shadow_glass.c) -------------------------------------- */

enum { SHADOW_GLASS_LISTS = 3 /* binding point of the lists' buffer */ };
/* Returns whether some caster has colored shadows. */
bool shadow_glass_needed(const Renderer *renderer);
/* Returns the part with all texels of the maps, with 0 fragments. */
ShadowPart shadow_glass_whole(const Renderer *renderer);
/* Returns the bytes of a part's lists. */
size_t shadow_glass_bytes(const ShadowPart *part);
bool shadow_glass_make(Renderer *renderer, size_t bytes);
/* Clears a part's lists before they are drawn. A buffer too small for the heads only counts. */
void shadow_glass_begin(const Renderer *renderer, const ShadowPart *part);
void shadow_glass_end(const Renderer *renderer);
/* Reports the number of fragments drawn since the begin, listed or not. */
bool shadow_glass_count(Renderer *renderer, GLuint *count);
void shadow_glass_delete(Renderer *renderer);

/* -- Drawing maps (shadow_draw.c) -------------------------------------------------------------- */

/* Draws all maps, without casters that are in lists. */
void shadow_draw_depths(Renderer *renderer);
/* Draws a part's lists of transparent fragments. */
void shadow_draw_lists(Renderer *renderer, const ShadowPart *part);
/* Attaches a view's layer as the depth target. */
void shadow_draw_layer(const Renderer *renderer, int view);
/* Draws the opaque or the transparent casters of a view into the attached layer. */
void shadow_draw_cast(Renderer *renderer, const GpuSceneSource *source, int view, bool transparent);

/* -- Lists in one piece, or tiled to limit memory (shadow_tables.c) ---------------------------- */

bool shadow_parts_make(Renderer *renderer);
/* Counts fragments and allocates the lists, in one piece also draws them. False: they exceed the
 * memory limit; if tiled, even those of a single texel. */
bool shadow_parts_count(Renderer *renderer);
/* Returns whether the lists exceed the memory limit in one piece, so that tiles should be tried. */
bool shadow_parts_fall_back(const Renderer *renderer);
/* Returns the number of tiles. */
int shadow_parts_number(const Renderer *renderer);
/* Draws the lists of one of several tiles. */
void shadow_parts_load(Renderer *renderer, int part);

/* -- Infinite planes of varying transparency (plane_transmittance.c) -------------------------- */

/* Returns whether the light has a layer of the planes' transmittance. */
bool plane_transmittance_reads(const SceneLight *light);
/* Returns whether some plane of varying transparency casts shadows. */
bool plane_transmittance_needed(const Renderer *renderer);
/* Reports an error if the chosen transparency method cannot be combined with such planes. */
bool plane_transmittance_check(const Renderer *renderer);
/* Returns the bytes per pixel of the layers. */
int plane_transmittance_bytes(const Renderer *renderer);
/* Appends a line for --stats. */
void plane_transmittance_put(Text *out, const Renderer *renderer);
bool plane_transmittance_make(Renderer *renderer);
/* Updates uniforms after a change of the camera, lights or planes. */
void plane_transmittance_change(const Renderer *renderer);
/* Updates uniforms for another tile. */
void plane_transmittance_place(const Renderer *renderer);
/* Sets a uniform of a material's programs. False: none has that uniform. */
bool plane_transmittance_set(const Renderer *renderer, int material, const MaterialValue *value);
/* Draws the layers, for surfaces at the depths of the texture `depth`. */
void plane_transmittance_draw(const Renderer *renderer, GLuint depth);
void plane_transmittance_delete(Renderer *renderer);

/* -- Views, tables and the lighting ------------------------------------------------------------ */

/* Sets the equation of an infinite plane in eye space, from its matrix: the unit normal, and the
 * offset that makes points of the plane 0. */
void shadow_plane(const Renderer *renderer, const SceneMatrix *m, float texel[4]);
/* Computes the shadow views of lights, before any pass is made. */
bool shadow_make_views(Renderer *renderer);
/* Updates shadows after a change of the camera; `drawn_again`: of lights or objects, so that
 * maps are fitted and drawn again. False: failed, or lights need another number of maps. */
bool shadow_change(Renderer *renderer, bool drawn_again);
/* GLSL of shadows for a program that lights surfaces (shadow_text.c). The pieces are valid as
 * long as the struct; no pieces: no light casts shadows. `nearest`: the surfaces in the depth
 * buffer are lit. */
enum {
    SHADOW_TEXT_CHARS = 1536,
    SHADOW_TEXT_PIECES = 12,
    SHADOW_OWN_UNITS = 2, /* texture units for the samplers of techniques */
    SHADOW_UNITS = 5 + SHADOW_OWN_UNITS
};
typedef struct {
    char defined[SHADOW_TEXT_CHARS], calls[SHADOW_TEXT_CHARS];
    const char *pieces[SHADOW_TEXT_PIECES];
} ShadowText;
void shadow_text(const Renderer *renderer, bool nearest, ShadowText *made);
/* Returns whether infinite planes cast shadows. */
bool shadow_has_planes(const Renderer *renderer);
/* Returns the number of planes with constant transparency. */
int shadow_count_panes(const Renderer *renderer);
/* Makes the textures that lighting reads, of views and planes. */
bool shadow_make_tables(Renderer *renderer);
/* Stores shadow data in a light's texels. LIGHT_CONE zw: the first of its views, and their
 * number; 0: only planes; -1: no shadows. LIGHT_POWER w: 1 + the layer of plane transmittance,
 * or 0. LIGHT_AXIS w: the number of its technique, plus SHADOW_METHODS_MAX for each earlier
 * light of the same technique. */
void shadow_put_lights(const Renderer *renderer, const int counts[VIEW_SPACE_SECTIONS],
                       float (*texels)[4]);
/* Sets samplers for SHADOW_UNITS texture units from `unit` on, and uniforms, after each change. */
void shadow_set(const Renderer *renderer, int unit, ScreenPass *pass);
/* Binds textures and buffers to these units. */
void shadow_bind(const Renderer *renderer, int unit);
/* Returns whether any light has a shadow map. */
bool shadow_has_maps(const Renderer *renderer);
extern const FramePass pass_shadow;
#endif
