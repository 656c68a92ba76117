/* Which passes of a frame run, which targets there are, and which of these lie in the same memory. No GL.
 *
 * Worked example: passes a (fills x), b (reads x, fills y), c (reads y, fills z), d (reads x, fills v), all allowed, z wanted. From the
 * end: d writes nothing that is needed, c does, so b, so a. x lives from a to b, y from b to c, z from c on: x and z share. */
#ifndef MATC_FRAME_PLAN_H
#define MATC_FRAME_PLAN_H
#include <stdbool.h>

enum { FRAME_PLAN_MOST = 32 /* passes, and targets */ };

/* Sets of targets have a bit for each. */
typedef struct {
    const char *name;
    unsigned reads;
    unsigned fills;   /* every pixel is written, whatever was there */
    unsigned changes; /* some are, and the others stay */
} FramePlanPass;

typedef struct {
    const FramePlanPass *passes; /* in the order of a frame */
    int pass_count;
    unsigned allowed; /* passes for which there is something to do */
    unsigned wanted;  /* targets that are read when the frame is done */
    int target_count;
    const int *classes; /* of each target: only targets of one class can share memory */
} FramePlanRequest;

typedef struct {
    unsigned runs;                     /* passes */
    unsigned there;                    /* targets */
    int memory[FRAME_PLAN_MOST];       /* of each target: which piece; -1 where it is not there */
    int memory_class[FRAME_PLAN_MOST]; /* of each piece */
    int memory_count;
} FramePlan;

void frame_plan(const FramePlanRequest *request, FramePlan *plan);
/* Why a pass does not run: "nothing to do", "nobody needs it"; NULL: it does. */
const char *frame_plan_reason(const FramePlanRequest *request, const FramePlan *plan, int pass);
#endif
