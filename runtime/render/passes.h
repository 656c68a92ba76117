/* The passes of a frame, in their order; what makes, counts and draws it; the passes that rasterise surfaces. */
#ifndef MATC_RENDER_PASSES_H
#define MATC_RENDER_PASSES_H
#include "runtime/frame/frame.h"

/* Sets what was set before in a scene that is made again; forgets it. render_param.c */
void render_param_again(Render *render);
/* Keeps what the scene's lights are, as all is made for it: render_lights.c. Whether they are so still. */
bool render_lights_keep(Render *render);
bool render_lights_kept(const Render *render);
void render_param_forget(Render *render);

Slot render_find_slot(const char *name); /* SLOT_COUNT: there is none */

/* A pass, as a row: frame.c has the list. */
typedef struct {
    FramePlanPass plan;
    bool (*needed)(const Render *render); /* there is something to do */
    bool (*make)(Render *render);         /* its programs; NULL: the cache has them */
    void (*draw)(Render *render);
    const char *when; /* it is needed, in words */
    /* How much there is to do, where that is counted, and counted again when the scene has changed; or NULL. */
    bool (*count)(Render *render, FrameCount step);
} FramePass;

extern const FramePass frame_passes[];
int frame_pass_count(void);
/* The same, and in buffers of far lights and of sheets: all memory there is, but for lists. frame_forms.c */
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
/* Brings up to date what depends on that (a sum of RenderChange), but for the cache. */
bool frame_change(Render *render, unsigned what);
void frame_delete(Render *render);
/* Why a pass does not run; NULL: it does. */
const char *frame_reason(const Render *render, const FramePlanRequest *request, int pass);
/* What the plan was asked for. */
void frame_request(const Render *render, FramePlanRows *made);

/* The passes' own functions. */
bool pass_surface_needed(const Render *render);
void pass_surface_draw(Render *render);
bool pass_plane_needed(const Render *render);
void pass_plane_draw(Render *render);
bool pass_sky_needed(const Render *render);
void pass_sky_draw(Render *render);
#endif
