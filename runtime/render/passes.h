/* The passes of a frame, in their order; what makes, counts and draws it; the passes that rasterise
 * surfaces. */
#ifndef MATC_RENDER_PASSES_H
#define MATC_RENDER_PASSES_H
#include "runtime/frame/frame_pass.h"
#include "runtime/shadow/shadow_views.h"

/* Sets what was set before in a scene that is made again; forgets it. render_param.c */
void render_param_again(Render *render);
/* Keeps what the scene's lights are, as all is made for it: render_lights.c. Whether they are so
 * still. */
bool render_lights_keep(Render *render);
bool render_lights_kept(const Render *render);
void render_param_forget(Render *render);

Slot render_find_slot(const char *name); /* SLOT_COUNT: there is none */

/* The passes in the order of a frame. */
const FramePass *frame_pass(int pass);
int frame_pass_count(void);
/* All memory of a frame, with buffers of light clustering and of planes, but without lists.
 * frame_forms.c */
int frame_all_bytes(const Render *render);
/* Fills render->targets.forms. frame_forms.c */
void frame_forms_find(Render *render);
/* Tells the passes where the tile is. */
void frame_place(Render *render);

/* Decides what runs, and makes targets and programs of that. */
bool frame_make(Render *render);
/* Counts what there is to do; the scene has changed. */
bool frame_count(Render *render);
void frame_draw(Render *render);
/* Update the passes, after the cache, for a set of FrameChange and for moved objects. */
bool frame_changed(Render *render, unsigned what);
bool frame_objects_moved(Render *render, int first, int count);
/* After memory ran out: true if some pass will take less memory in a rebuild. */
bool frame_fall_back(Render *render);
/* Frees everything that passes hold for the scene. */
void frame_clear(Render *render);
/* Why a pass does not run; NULL: it does. */
const char *frame_reason(const Render *render, const FramePlanRequest *request, int pass);
/* Request of the current plan. */
void frame_request(const Render *render, FramePlanRows *made);

extern const FramePass pass_surface, pass_plane, pass_sky;
/* The shadow techniques, up to NULL. shadow_methods.c */
extern const ShadowMethod *const shadow_methods[];
#endif
