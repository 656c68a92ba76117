/* Which passes of a frame run, which targets there are, and which of their textures lie in the same
 * memory. No GL.
 *
 * Worked example: passes a (fills x), b (reads x, fills y), c (reads y, fills z), d (reads x, fills
 * v), all allowed, z wanted, each target of one texture of one class. From the end: d writes
 * nothing that is needed, c does, so b, so a. x lives from a to b, y from b to c, z from c on: x
 * and z share. If b reads of x but the pixel that it writes, y takes the memory of x, and c, if it
 * does the same, gives that to z. */
#ifndef MATC_FRAME_PLAN_H
#define MATC_FRAME_PLAN_H
#include <stdbool.h>

enum {
    FRAME_PLAN_MOST = 32, /* passes, and targets */
    FRAME_PLAN_TEXTURES = 8,
    FRAME_PLAN_PIECES = FRAME_PLAN_MOST * FRAME_PLAN_TEXTURES /* of memory, at most */
};

/* Sets of targets have a bit for each. */
typedef struct {
    const char *name;
    unsigned reads;
    unsigned fills;   /* every pixel is written, whatever was there */
    unsigned changes; /* some are, and the others stay */
    /* of what it reads, targets of which each pixel takes that which it writes, and nothing beside
     * it */
    unsigned own;
} FramePlanPass;

typedef struct {
    int count;                        /* of its textures */
    int classes[FRAME_PLAN_TEXTURES]; /* only textures of one class can share memory */
} FramePlanTarget;

typedef struct {
    const FramePlanPass *passes; /* in the order of a frame */
    int pass_count;
    unsigned allowed; /* passes for which there is something to do */
    unsigned wanted;  /* targets that are read when the frame is done */
    const FramePlanTarget *targets;
    int target_count;
} FramePlanRequest;

/* A request with the rows that it points to. */
typedef struct {
    FramePlanPass passes[FRAME_PLAN_MOST];
    FramePlanTarget targets[FRAME_PLAN_MOST];
    FramePlanRequest request;
} FramePlanRows;

typedef struct {
    unsigned runs;  /* passes */
    unsigned there; /* targets */
    /* of each target's textures: which piece; -1 where there is none */
    int memory[FRAME_PLAN_MOST][FRAME_PLAN_TEXTURES];
    int memory_class[FRAME_PLAN_PIECES]; /* of each piece */
    int memory_count;
} FramePlan;

void frame_plan(const FramePlanRequest *request, FramePlan *plan);
/* Why a pass does not run: "nothing to do", "nobody needs it"; NULL: it does. */
const char *frame_plan_reason(const FramePlanRequest *request, const FramePlan *plan, int pass);
#endif
