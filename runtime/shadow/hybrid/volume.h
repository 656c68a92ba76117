/* Hybrid shadows: what a renderer keeps of shadow volumes, and what draws them. */
#ifndef MATC_SHADOW_VOLUME_H
#define MATC_SHADOW_VOLUME_H
#include "runtime/frame/frame_pass.h"
#include "compiler/base/text.h"
#include "runtime/shadow/shadow_state.h"
#include "runtime/frame/render_options.h"

enum {
    VOLUME_LIGHTS = 32,   /* with hybrid shadows, in a scene: bits of the mask */
    VOLUME_AUTO_MIB = 256 /* that the path auto may take for buffers */
};

/* A light casts hybrid shadows; how many do; one does, and there is something that casts.
 * volume_lights.c */
bool volume_lights_has(const Render *render, int light);
int volume_lights_count(const Render *render);
bool volume_lights_cast(const Render *render);

/* Where depths are blurred: what that takes; depth is drawn to what will be; its means to what is
 * drawn to. volume_blur.c */
bool volume_blur_make(Render *render);
void volume_blur_use(const Render *render);
void volume_blur_draw(Render *render);
void volume_blur_delete(Render *render);

/* Vertices by the scene's path: made; written, when maps have been drawn; what the vertex program
 * goes by, which is to be looked at or not; a view's drawn; a line on them; deleted.
 * volume_data.c */
bool volume_data_make(Render *render);
void volume_data_write(Render *render);
const char *volume_data_text(const Render *render, bool shown);
void volume_data_draw(const Render *render, int view, bool shown);
void volume_data_put(Text *out, const Render *render);
void volume_data_delete(Render *render);

/* The same where silhouettes cut volumes: whether they do; the samplers that volume_cells.glsl
 * reads; only cells in lists are drawn, or all of them, in one order, for a view that mixes
 * colours; bytes of the lists. volume_cells.c */
bool volume_cells_are(const Render *render);
bool volume_cells_make(Render *render);
void volume_cells_write(Render *render);
const char *volume_cells_head(bool listed);
const char *volume_cells_maps(void);
void volume_cells_draw(const Render *render, int view, int number);
void volume_cells_draw_all(const Render *render, int view, int number);
size_t volume_cells_bytes(const Render *render);
void volume_cells_delete(Render *render);
/* NULL: it is another view. */
const VolumeView *volume_view_find(const char *name);
/* The view shows them. volume_view.c */
bool volume_view_has_volume(const Render *render);
/* What the pass tools takes for volumes, once maps are made; the view is another; drawn, to light
 * and tools with depth. volume_shown.c */
bool volume_shown_make(Render *render);
void volume_shown_place(const Render *render);
void volume_shown_draw(Render *render);

/* Sets the uniforms of volume_vertex.glsl for a view of a light; begins its text. */
void pass_volume_place(const Render *render, int number, Material *material);
const char *pass_volume_head(const Render *render);
extern const FramePass pass_volume;
#endif
