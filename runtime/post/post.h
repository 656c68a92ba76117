/* Passes that turn the lit frame into the picture: edge antialiasing, tools (overlays), tone
 * mapping. */
#ifndef MATC_POST_POST_H
#define MATC_POST_POST_H
#include "runtime/frame_graph/frame_pass.h"
#include "runtime/post/post_state.h"
#include "runtime/light/lighting.h"

bool pass_edge_needed(const Renderer *renderer);
/* Returns the reason why the requested edge pass is missing; NULL: not requested, or present. */
const char *pass_edge_missing(const Renderer *renderer);
/* Returns whether the tools pass runs and the frame has its render target. */
bool pass_tools_enabled(const Renderer *renderer);
/* Called by passes that blend transparent surfaces over the lit frame: make and draw the part
 * that attenuates the tools behind those surfaces. `text` is the pass's lighting text without
 * emitted light. Without tools both functions do nothing. */
bool pass_tools_make_veil(Renderer *renderer, const LightingText *text);
void pass_tools_draw_veil(Renderer *renderer);
/* Passes of the frame graph. */
extern const FramePass pass_edge, pass_tools, pass_tone;
#endif
