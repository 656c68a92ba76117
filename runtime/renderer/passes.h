/* The passes of a frame in their order; functions that make, measure and draw a frame; the
 * passes that rasterize surfaces. */
#ifndef MATC_RENDERER_PASSES_H
#define MATC_RENDERER_PASSES_H
#include "runtime/frame_graph/frame_pass.h"
#include "runtime/shadow/shadow_views.h"

/* Sets the stored material parameters again after a rebuild; frees them. renderer_param.c */
void renderer_param_rebuild(Renderer *renderer);
/* Stores the lights' properties at a rebuild; compares the current lights with them.
 * renderer_lights.c */
bool renderer_lights_keep(Renderer *renderer);
bool renderer_lights_kept(const Renderer *renderer);
void renderer_param_forget(Renderer *renderer);

Slot renderer_find_slot(const char *name); /* SLOT_COUNT: unknown name */

/* The passes in the order of a frame. */
const FramePass *frame_pass(int pass);
int frame_pass_count(void);
/* Returns the bytes per pixel of a frame, including the buffers of light clustering and of
 * transparent planes' shadows, but without linked lists. frame_forms.c */
int frame_all_bytes(const Renderer *renderer);
/* Fills render->targets.forms. frame_forms.c */
void frame_forms_find(Renderer *renderer);
/* Passes the tile's position to all passes. */
void frame_place(Renderer *renderer);

/* Plans the frame, and makes the targets and programs of the passes that run. */
bool frame_make(Renderer *renderer);
/* Lets the passes measure their work after a change of the scene. */
bool frame_count(Renderer *renderer);
void frame_draw(Renderer *renderer);
/* Update the passes, after the GPU scene: for a set of FrameChange, and for moved objects. */
bool frame_changed(Renderer *renderer, unsigned what);
bool frame_objects_moved(Renderer *renderer, int first, int count);
/* Called after memory ran out. Returns true if some pass will take less memory in a rebuild. */
bool frame_fall_back(Renderer *renderer);
/* Frees all resources that passes hold for the scene. */
void frame_clear(Renderer *renderer);
/* Returns the reason why a pass does not run; NULL if it runs. */
const char *frame_reason(const Renderer *renderer, const FramePlanRequest *request, int pass);
/* Fills the request of the current plan. */
void frame_request(const Renderer *renderer, FramePlanRows *made);

extern const FramePass pass_surface, pass_plane, pass_sky;
/* The shadow techniques; NULL ends the list. shadow_methods.c */
extern const ShadowMethod *const shadow_methods[];
#endif
