/* Transparent surfaces: per-pixel linked lists of fragments, or depth peeling, composited over
 * the light. */
#ifndef MATC_TRANSPARENCY_TRANSPARENCY_PASSES_H
#define MATC_TRANSPARENCY_TRANSPARENCY_PASSES_H
#include "compiler/base/text.h"
#include "runtime/frame_graph/frame_pass.h"
#include "runtime/transparency/transparency_state.h"

/* Appends a line about the lists' memory, for --stats. */
void transparency_put_lists(Text *out, const Renderer *renderer);

/* The passes of transparent surfaces, as rows of the frame graph. */
extern const FramePass pass_lists, pass_blend, pass_peel;
#endif
