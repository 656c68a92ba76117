/* The picture of what was lit: edges, tools, tone mapping. */
#ifndef MATC_PICTURE_PICTURE_H
#define MATC_PICTURE_PICTURE_H
#include "runtime/frame/frame_pass.h"
#include "runtime/picture/picture_state.h"
#include "runtime/light/lighting.h"

bool pass_edge_needed(const Render *render);
/* Reason why a requested pass is missing; NULL: none. */
const char *pass_edge_lacks(const Render *render);
/* The pass runs, and has its target. */
bool pass_tools_are_there(const Render *render);
/* For a pass that lays something transparent over the light, with the text of it that gives no
 * light: and over the tools, where there are some. */
bool pass_tools_make_veil(Render *render, const LightingText *text);
void pass_tools_draw_veil(Render *render);
/* The rows of the frame graph. */
extern const FramePass pass_edge, pass_tools, pass_tone;
#endif
