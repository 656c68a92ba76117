/* What moved since rays were kept: where it was, and the boxes around it, then and now. */
#ifndef MATC_INDIRECT_INDIRECT_MOTION_H
#define MATC_INDIRECT_INDIRECT_MOTION_H
#include "runtime/indirect/settings/indirect_state.h"
#include "runtime/frame/render_options.h"

enum { INDIRECT_MOTIONS_MOST = 128, INDIRECT_BOXES_MOST = 16 };

/* From the eye's space of now to where the same point of an object was in that of before, and how
 * far its middle has come since; around what moved. In the order and the form of the block
 * History. */
typedef struct {
    float counts[4];                        /* x: of boxes; y: of motions */
    float boxes[INDIRECT_BOXES_MOST][2][4]; /* the lowest corner, the highest; in the world */
    float steps[INDIRECT_MOTIONS_MOST]
               /* xyz: from where the middle of its box is now to where it was, in the eye's space
                * of before */
               [4];
    float motions[INDIRECT_MOTIONS_MOST][4][4]; /* columns */
} IndirectMoved;

/* False: memory ran out, or see the context's error. */
bool indirect_motion_make(Render *render);
void indirect_motion_delete(Render *render);
/* So many objects stand elsewhere. */
void indirect_motion_add(Render *render, int first, int count);
/* Draws what moved since; how it did. `was` is the eye's space of what is kept. False: nothing
 * moved. */
bool indirect_motion_draw(Render *render, const double was[16], IndirectMoved *moved);
/* What is kept now was found where objects stand now. */
void indirect_motion_end(Render *render);
#endif
