/* Entry points of indirect light: choice of the method, guard band, and lines for --stats. */
#ifndef MATC_INDIRECT_INDIRECT_METHODS_H
#define MATC_INDIRECT_INDIRECT_METHODS_H
#include "runtime/frame_graph/frame_pass.h"
#include "compiler/base/text.h"

/* Chooses the method for the scene. Call before any other function of indirect light. */
void indirect_methods_select(Renderer *renderer);
/* Returns the guard band around a tile in pixels, with which the tile's pixels equal those of
 * the whole picture; -1 if the picture cannot be drawn in tiles. indirect_tile.c */
int indirect_margin(const Renderer *renderer);
/* Writes lines for --stats. */
void indirect_methods_put(Text *out, const Renderer *renderer);
/* The row of the frame graph. */
extern const FramePass pass_combine;
#endif
