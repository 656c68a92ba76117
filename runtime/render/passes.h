/* The passes of a frame in their order; functions that make, measure and draw a frame; the
 * passes that rasterize surfaces. */
#ifndef MATC_RENDER_PASSES_H
#define MATC_RENDER_PASSES_H
#include "runtime/frame/frame_pass.h"
#include "runtime/shadow/shadow_views.h"

/* Sets the stored material parameters again after a rebuild; frees them. render_param.c */
void render_param_again(Render *render);
/* Stores the lights' properties at a rebuild; compares the current lights with them.
 * render_lights.c */
bool render_lights_keep(Render *render);
bool render_lights_kept(const Render *render);
void render_param_forget(Render *render);

Slot render_find_slot(const char *name); /* SLOT_COUNT: unknown name */

/* The passes in the order of a frame. */
const FramePass *frame_pass(int pass);
int frame_pass_count(void);
/* Returns the bytes per pixel of a frame, including the buffers of light clustering and of
 * transparent planes' shadows, but without linked lists. frame_forms.c */
int frame_all_bytes(const Render *render);
/* Fills render->targets.forms. frame_forms.c */
void frame_forms_find(Render *render);
/* Passes the tile's position to all passes. */
void frame_place(Render *render);

/* Plans the frame, and makes the targets and programs of the passes that run. */
bool frame_make(Render *render);
/* Lets the passes measure their work after a change of the scene. */
bool frame_count(Render *render);
void frame_draw(Render *render);
/* Update the passes, after the GPU scene: for a set of FrameChange, and for moved objects. */
bool frame_changed(Render *render, unsigned what);
bool frame_objects_moved(Render *render, int first, int count);
/* Called after memory ran out. Returns true if some pass will take less memory in a rebuild. */
bool frame_fall_back(Render *render);
/* Frees all resources that passes hold for the scene. */
void frame_clear(Render *render);
/* Returns the reason why a pass does not run; NULL if it runs. */
const char *frame_reason(const Render *render, const FramePlanRequest *request, int pass);
/* Fills the request of the current plan. */
void frame_request(const Render *render, FramePlanRows *made);

extern const FramePass pass_surface, pass_plane, pass_sky;
/* The shadow techniques; NULL ends the list. shadow_methods.c */
extern const ShadowMethod *const shadow_methods[];
#endif
