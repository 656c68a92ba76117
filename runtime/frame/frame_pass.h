/* A pass of the frame graph is a row of functions, defined beside the pass's code.
 * runtime/render/frame.c lists the rows in the order of a frame; docs/design/add-a-pass.md shows
 * how to add one. */
#ifndef MATC_FRAME_FRAME_PASS_H
#define MATC_FRAME_FRAME_PASS_H
#include "runtime/frame/frame.h"

/* Bits of targets, for the columns of FramePlanPass. */
#define FRAME_BIT(target) (1u << FRAME_TARGET_##target)

/* Flags that join those of RenderChange: together they tell a pass which parts of the scene
 * have changed. */
typedef enum {
    FRAME_SHAPES = 1 << 8 /* displaced meshes were tessellated again */
} FrameChange;

/* Steps in which a pass counts its work by drawing: fragments, layers, or the brightness of the
 * picture.
 *   wanted  whether there is something to count
 *   begin
 *   tile    counts one tile, in which the earlier passes have been drawn
 *   again   whether all tiles have to be drawn once more
 *   end */
typedef enum {
    FRAME_COUNT_wanted,
    FRAME_COUNT_begin,
    FRAME_COUNT_tile,
    FRAME_COUNT_again,
    FRAME_COUNT_end
} FrameCount;

/* A function may be NULL if there is nothing to do. Every function but make, count and draw is
 * called whether the pass runs or not, in the order of the passes. make, recount, changed and moved
 * return false on failure, with a reason in the context's error. */
typedef struct {
    FramePlanPass plan;
    const char *when; /* text for --stats: when the pass runs */
    bool (*needed)(const Render *render);
    /* Why the driver or the options rule out the pass although it is wanted; NULL if they do
     * not. */
    const char *(*lacks)(const Render *render);
    /* Adapts a copy of `plan` to the scene. */
    void (*request)(const Render *render, FramePlanPass *row);

    bool (*make)(Render *render); /* creates programs and buffers if the pass is needed */
    bool (*count)(Render *render, FrameCount step);
    bool (*recount)(Render *render); /* counts what needs no drawn tile */
    void (*draw)(Render *render);
    void (*drawn)(Render *render); /* the frame is complete */

    void (*place)(Render *render);                       /* the tile has moved within the picture */
    bool (*changed)(Render *render, unsigned what);      /* a set of FrameChange */
    bool (*moved)(Render *render, int first, int count); /* these objects have moved */
    /* out of memory: a rebuild will take less */
    bool (*fall_back)(Render *render);
    void (*forget)(Render *render); /* frees all resources of the scene */
} FramePass;
#endif
