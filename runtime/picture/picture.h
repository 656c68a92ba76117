/* The picture of what was lit: edges, tools, tone mapping. */
#ifndef MATC_PICTURE_PICTURE_H
#define MATC_PICTURE_PICTURE_H
#include "runtime/light/lighting.h"

bool pass_edge_needed(const Render *render);
/* What is asked for and not there; NULL: nothing. */
const char *pass_edge_lacks(const Render *render);
bool pass_edge_make(Render *render);
/* The camera or objects have moved: looks for the lines again. */
bool pass_edge_change(Render *render);
void pass_edge_place(Render *render);
void pass_edge_draw(Render *render);
void pass_edge_delete(Render *render);
bool pass_tools_needed(const Render *render);
bool pass_tools_make(Render *render);
/* The camera or lights are others. */
bool pass_tools_change(Render *render);
void pass_tools_place(Render *render);
void pass_tools_draw(Render *render);
void pass_tools_delete(Render *render);
/* The pass runs, and has its target. */
bool pass_tools_are_there(const Render *render);
/* In tiles, what tone mapping asks of the whole picture. */
bool pass_tone_count(Render *render, FrameCount step);
bool pass_tone_make(Render *render);
void pass_tone_draw(Render *render);
void pass_tone_delete(Render *render);
/* For a pass that lays something transparent over the light, with the text of it that gives no light: and over the tools, where there are some. */
bool pass_tools_make_veil(Render *render, const LightingText *text);
void pass_tools_draw_veil(Render *render);
void pass_tone_place(Render *render);
#endif
