/* Transparent surfaces: per-pixel linked lists of fragments, or depth peeling, composited over
 * the light. */
#ifndef MATC_GLASS_GLASS_H
#define MATC_GLASS_GLASS_H
#include "compiler/base/text.h"
#include "runtime/frame/frame_pass.h"
#include "runtime/glass/glass_state.h"

/* Appends a line about the lists' memory, for --stats. */
void glass_put_lists(Text *out, const Render *render);

/* The passes of transparent surfaces, as rows of the frame graph. */
extern const FramePass pass_lists, pass_blend, pass_peel;
#endif
