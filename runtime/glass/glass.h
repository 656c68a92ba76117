/* What is transparent: lists of fragments, or layers that are peeled, laid over the light. */
#ifndef MATC_GLASS_GLASS_H
#define MATC_GLASS_GLASS_H
#include "runtime/frame/frame.h"

bool pass_lists_needed(const Render *render);
bool pass_lists_make(Render *render);
bool pass_lists_count(Render *render, FrameCount step);
bool pass_peel_count(Render *render, FrameCount step);
void pass_lists_draw(Render *render);
void pass_lists_delete(Render *render);
bool pass_blend_make(Render *render);
void pass_blend_draw(Render *render);
bool pass_peel_needed(const Render *render);
bool pass_peel_make(Render *render);
void pass_peel_draw(Render *render);
void pass_peel_delete(Render *render);
#endif
