/* Indirect light as a whole. */
#ifndef MATC_INDIRECT_INDIRECT_METHODS_H
#define MATC_INDIRECT_INDIRECT_METHODS_H
#include "runtime/frame/frame_pass.h"
#include "compiler/base/text.h"

/* Chooses the method for the scene: before anything of indirect light is asked. */
void indirect_methods_select(Render *render);
/* Guard band around a tile in pixels, so that its pixels equal those of the whole picture; -1 if
 * the picture cannot be drawn in tiles. indirect_tile.c */
int indirect_margin(const Render *render);
/* Lines for --stats. */
void indirect_methods_put(Text *out, const Render *render);
/* The row of the frame graph. */
extern const FramePass pass_combine;
#endif
