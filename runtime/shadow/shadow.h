/* Shadows, for the passes: maps of lights, what is transparent in them, planes; and what the
 * lighting of surfaces reads of them. */
#ifndef MATC_SHADOW_SHADOW_H
#define MATC_SHADOW_SHADOW_H
#include "runtime/frame/frame_pass.h"
#include "compiler/base/text.h"
#include "runtime/draw/screen_pass.h"
#include "runtime/shadow/shadow_state.h"
#include "runtime/frame/render_options.h"

/* Some light of the scene casts shadows, which are wanted. */
bool shadow_is_cast(const Render *render);
/* Some area light does. */
bool shadow_is_soft(const Render *render);
/* How what is transparent does. */
SetCasts shadow_casts(const Render *render);

/* Shadows are coloured by something (shadow_glass.c): all texels, without fragments; bytes of a
 * part's lists; a buffer of so many; a part's lists begun, which are none where the buffer has no
 * room for their heads, and ended; the fragments that were to be listed then. */
enum { SHADOW_GLASS_LISTS = 3 /* binding point */ };
bool shadow_glass_needed(const Render *render);
ShadowPart shadow_glass_whole(const Render *render);
size_t shadow_glass_bytes(const ShadowPart *part);
bool shadow_glass_make(Render *render, size_t bytes);
void shadow_glass_begin(const Render *render, const ShadowPart *part);
void shadow_glass_end(const Render *render);
bool shadow_glass_count(Render *render, GLuint *count);
void shadow_glass_delete(Render *render);

/* Draws all maps, but for what lists are of; a part's lists (shadow_draw.c). While a map is drawn:
 * its layer becomes the target of depth; casters of a view are drawn, opaque or transparent ones.
 */
void shadow_draw_depths(Render *render);
void shadow_draw_lists(Render *render, const ShadowPart *part);
void shadow_draw_layer(const Render *render, int view);
void shadow_draw_cast(Render *render, const CacheSource *source, int view, bool transparent);

/* The lists, in one piece, or in parts with room for the largest (shadow_tables.c): made; counted,
 * and in one piece drawn. False: there may not be so much, or, in parts, not even for one texel. In
 * parts would do. How many there are; one of them drawn, if there are several. */
bool shadow_parts_make(Render *render);
bool shadow_parts_count(Render *render);
bool shadow_parts_fall_back(const Render *render);
int shadow_parts_number(const Render *render);
void shadow_parts_load(Render *render, int part);

/* Planes whose transparency varies (shadow_sheet.c): a light has a layer of what they let through;
 * some cast shadows; the choice of transparency can be met with that; bytes of a pixel; a line on
 * them; made; told where the camera, lights and planes are, or where the tile is; a uniform of a
 * material, false: none has it; drawn, of what has these depths; deleted. */
bool shadow_sheet_reads(const SceneLight *light);
bool shadow_sheet_needed(const Render *render);
bool shadow_sheet_check(const Render *render);
int shadow_sheet_bytes(const Render *render);
void shadow_sheet_put(Text *out, const Render *render);
bool shadow_sheet_make(Render *render);
void shadow_sheet_change(const Render *render);
void shadow_sheet_place(const Render *render);
bool shadow_sheet_set(const Render *render, int material, const MaterialValue *value);
void shadow_sheet_draw(const Render *render, GLuint depth);
void shadow_sheet_delete(Render *render);

/* An infinite plane in the eye's space, where its matrix says: its normal, and what makes points of
 * it 0. */
void shadow_plane(const Render *render, const SceneMatrix *m, float texel[4]);
/* Makes the views of lights, before any pass is made. */
bool shadow_make_views(Render *render);
/* The view is another; or the lights or objects are, and the maps are drawn again. False: lights
 * cast shadows by more or fewer maps. */
bool shadow_change(Render *render, bool drawn_again);
/* GLSL of shadows for a program that lights surfaces (shadow_text.c): pieces that stay valid as
 * long as this; none if no light casts shadows. `nearest`: what the depth buffer has is lit. */
enum {
    SHADOW_TEXT_CHARS = 1536,
    SHADOW_TEXT_PIECES = 12,
    SHADOW_OWN_UNITS = 2, /* for the samplers of techniques */
    SHADOW_UNITS = 5 + SHADOW_OWN_UNITS
};
typedef struct {
    char defined[SHADOW_TEXT_CHARS], calls[SHADOW_TEXT_CHARS];
    const char *pieces[SHADOW_TEXT_PIECES];
} ShadowText;
void shadow_text(const Render *render, bool nearest, ShadowText *made);
/* Infinite planes cast shadows: how many are transparent by the same everywhere. */
bool shadow_has_planes(const Render *render);
int shadow_count_panes(const Render *render);
bool shadow_make_tables(Render *render);
/* Behind the cone of each light: the first of its views, and how many; 0: planes alone; -1: it
 * casts no shadows. Behind its light: 1 + the layer of what sheets let through of it, or 0. Behind
 * its direction: the number of its technique, plus SHADOW_METHODS_MAX for each light before it that
 * has the same. */
void shadow_put_lights(const Render *render, const int counts[VIEW_SPACE_SECTIONS],
                       float (*texels)[4]);
/* SHADOW_UNITS units from `unit` on, and uniforms, after each change; textures and buffers. */
void shadow_set(const Render *render, int unit, ScreenPass *pass);
void shadow_bind(const Render *render, int unit);
/* Some light has a shadow map. */
bool shadow_has_maps(const Render *render);
extern const FramePass pass_shadow;
#endif
