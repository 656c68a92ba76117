/* Motion since rays were kept: previous positions, and the boxes around objects, then and now. */
#ifndef MATC_INDIRECT_INDIRECT_MOTION_H
#define MATC_INDIRECT_INDIRECT_MOTION_H
#include "runtime/indirect/settings/indirect_state.h"
#include "gen/history_layout.h"
#include "runtime/frame/render_options.h"

/* False: memory ran out, or see the context's error. */
bool indirect_motion_make(Render *render);
void indirect_motion_delete(Render *render);
/* So many objects stand elsewhere. */
void indirect_motion_add(Render *render, int first, int count);
/* Draws what moved since, and fills counts, boxes, steps and motions of the block History. `was` is
 * the eye space of the history. False: nothing moved. */
bool indirect_motion_draw(Render *render, const double was[16], float (*block)[4]);
/* The rays kept now belong to the objects' current positions. */
void indirect_motion_end(Render *render);
#endif
