/* Motion of objects since the last accumulated frame: previous positions, and bounding boxes of
 * moved objects before and after. */
#ifndef MATC_INDIRECT_INDIRECT_MOTION_H
#define MATC_INDIRECT_INDIRECT_MOTION_H
#include "runtime/indirect/settings/indirect_state.h"
#include "gen/temporal_layout.h"
#include "runtime/frame_graph/renderer_options.h"

/* Returns false if memory runs out; see the context's error. */
bool indirect_motion_make(Renderer *renderer);
void indirect_motion_delete(Renderer *renderer);
/* Records that `count` objects from `first` on may have moved. */
void indirect_motion_add(Renderer *renderer, int first, int count);
/* Draws the ids of moved objects, and fills counts, boxes, steps and motions of the block
 * History. `was` is the eye space of the previous frame. Returns false if nothing moved. */
bool indirect_motion_draw(Renderer *renderer, const double was[16], float (*block)[4]);
/* Stores the objects' current matrices as those of the accumulated samples. */
void indirect_motion_end(Renderer *renderer);
#endif
