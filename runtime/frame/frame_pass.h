/* A pass of the frame graph, as a row. Each pass defines its row beside its code; runtime/render/frame.c lists them in
 * the order of a frame. docs/add-a-pass.md shows how to add one. */
#ifndef MATC_FRAME_FRAME_PASS_H
#define MATC_FRAME_FRAME_PASS_H
#include "runtime/frame/frame.h"

/* Bits of targets, for the columns of FramePlanPass. */
#define FRAME_BIT(target) (1u << FRAME_TARGET_##target)

/* What is another in the scene that is drawn: a sum of RenderChange, and of these. */
typedef enum {
    FRAME_SHAPES = 1 << 8 /* displaced meshes were tessellated anew */
} FrameChange;

/* Counting what a pass will have to do, as far as that needs drawing: whether there is something to count; begin; one tile, in
 * which the passes before it were drawn; whether all tiles are to be drawn once more; end. */
typedef enum { FRAME_COUNT_wanted, FRAME_COUNT_begin, FRAME_COUNT_tile, FRAME_COUNT_again, FRAME_COUNT_end } FrameCount;

/* Functions may be NULL: there is nothing to do. All but draw and count are called whether the pass runs or not, in the order of the
 * passes. Those that return bool fail with false and a reason in the context's error. */
typedef struct {
    FramePlanPass plan;
    const char *when; /* it runs, in words, for --stats */
    bool (*needed)(const Render *render);
    /* The reason why what was asked for is not there; NULL: it is. */
    const char *(*lacks)(const Render *render);
    /* Adapts a copy of `plan` to the scene. */
    void (*request)(const Render *render, FramePlanPass *row);

    bool (*make)(Render *render); /* creates programs and buffers, if the pass runs */
    bool (*count)(Render *render, FrameCount step);
    bool (*recount)(Render *render); /* as count, of what needs no picture */
    void (*draw)(Render *render);
    void (*drawn)(Render *render); /* the frame is complete */

    void (*place)(Render *render);                       /* the tile is elsewhere in the picture */
    bool (*changed)(Render *render, unsigned what);      /* a sum of FrameChange */
    bool (*moved)(Render *render, int first, int count); /* these objects stand elsewhere */
    bool (*fall_back)(Render *render); /* memory ran out: true, if it will take less when made again */
    void (*forget)(Render *render);    /* frees all that was made for the scene */
} FramePass;
#endif
