/* Plan of a frame: which passes run, which targets exist, and which of their textures share
 * memory. Makes no GL calls.
 *
 * Worked example: passes a (fills x), b (reads x, fills y), c (reads y, fills z), d (reads x,
 * fills v); all are allowed, z is wanted, and each target has one texture of one class.
 * Backwards from the end: d writes no needed target, so d is dropped; c writes z, so c runs,
 * hence b, hence a. x lives from a to b, y from b to c, z from c on: x and z share memory. If b
 * reads x only at the pixel that b writes, y may take the memory of x; if c does the same, z
 * takes the memory of y. */
#ifndef MATC_FRAME_GRAPH_PLAN_H
#define MATC_FRAME_GRAPH_PLAN_H
#include <stdbool.h>

enum {
    FRAME_PLAN_MAX = 32, /* max passes, and max targets */
    FRAME_PLAN_TEXTURES = 8,
    FRAME_PLAN_PIECES = FRAME_PLAN_MAX * FRAME_PLAN_TEXTURES /* max pieces of memory */
};

/* A pass's inputs and outputs as sets of targets, one bit per target. */
typedef struct {
    const char *name;
    unsigned reads;
    unsigned fills;   /* set of targets of which the pass overwrites every pixel */
    unsigned changes; /* set of targets of which the pass writes some pixels and keeps the others */
    /* Inputs that are read at the written pixel only, so input and output may share memory. */
    unsigned own;
} FramePlanPass;

typedef struct {
    int count;                        /* number of textures of the target */
    int classes[FRAME_PLAN_TEXTURES]; /* textures share memory only within a class */
} FramePlanTarget;

typedef struct {
    const FramePlanPass *passes; /* passes in execution order */
    int pass_count;
    unsigned allowed; /* passes that have work in this scene */
    unsigned wanted;  /* targets that are read after the frame */
    const FramePlanTarget *targets;
    int target_count;
} FramePlanRequest;

/* A request with storage for its rows. */
typedef struct {
    FramePlanPass passes[FRAME_PLAN_MAX];
    FramePlanTarget targets[FRAME_PLAN_MAX];
    FramePlanRequest request;
} FramePlanRows;

typedef struct {
    unsigned runs;  /* set of passes that run */
    unsigned there; /* set of targets that exist */
    /* Piece of memory of each target's textures; -1 if the texture is missing. */
    int memory[FRAME_PLAN_MAX][FRAME_PLAN_TEXTURES];
    int memory_class[FRAME_PLAN_PIECES]; /* memory class of each piece */
    int memory_count;
} FramePlan;

void frame_plan(const FramePlanRequest *request, FramePlan *plan);
/* Returns the reason why a pass does not run: "nothing to do" or "nobody needs it"; NULL if the
 * pass runs. */
const char *frame_plan_reason(const FramePlanRequest *request, const FramePlan *plan, int pass);
#endif
