/* A pass of the frame graph is a row of functions, defined next to the pass's code.
 * runtime/renderer/frame.c lists the rows in the order of a frame; docs/design/add-a-pass.md shows
 * how to add one. */
#ifndef MATC_FRAME_GRAPH_FRAME_PASS_H
#define MATC_FRAME_GRAPH_FRAME_PASS_H
#include "runtime/frame_graph/frame.h"

/* A target's bit, for the sets in FramePlanPass. */
#define FRAME_BIT(target) (1u << FRAME_TARGET_##target)

/* Flags that extend RendererChange. A pass gets a set of both: the parts of the scene that have
 * changed. */
typedef enum {
    FRAME_SHAPES = 1 << 8 /* displaced meshes were tessellated again */
} FrameChange;

/* Steps in which a pass measures its work by drawing: fragments, layers, or the brightness of
 * the picture.
 *   wanted  reports whether the pass has to measure
 *   begin   prepares the counters
 *   tile    counts one tile, in which the earlier passes have been drawn
 *   again   reports whether all tiles have to be drawn once more
 *   end     evaluates the counters */
typedef enum {
    FRAME_COUNT_wanted,
    FRAME_COUNT_begin,
    FRAME_COUNT_tile,
    FRAME_COUNT_again,
    FRAME_COUNT_end
} FrameCount;

/* A function that has nothing to do may be NULL. All functions except make, count and draw are
 * called in the order of the passes even if the pass does not run. make, recount, changed and
 * moved return false on failure, with a reason in the context's error. */
typedef struct {
    FramePlanPass plan;
    const char *when; /* condition under which the pass runs, as text for --stats */
    bool (*needed)(const Renderer *renderer);
    /* Returns the reason why the driver or the options rule out a wanted pass; NULL if the pass
     * can run. */
    const char *(*lacks)(const Renderer *renderer);
    /* Adapts the copy *row of `plan` to the scene. */
    void (*request)(const Renderer *renderer, FramePlanPass *row);

    bool (*make)(Renderer *renderer); /* creates programs and buffers if the pass is needed */
    bool (*count)(Renderer *renderer, FrameCount step);
    bool (*recount)(Renderer *renderer); /* measures work that needs no drawn tile */
    void (*draw)(Renderer *renderer);
    void (*drawn)(Renderer *renderer); /* called after the frame is complete */

    void (*place)(Renderer *renderer);                  /* the tile has moved within the picture */
    bool (*changed)(Renderer *renderer, unsigned what); /* `what`: a set of FrameChange */
    /* Updates the pass after these objects have moved. */
    bool (*moved)(Renderer *renderer, int first, int count);
    /* Called when memory runs out: makes a rebuild take less memory. */
    bool (*fall_back)(Renderer *renderer);
    void (*forget)(Renderer *renderer); /* frees all resources of the scene */
} FramePass;
#endif
