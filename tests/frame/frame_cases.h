/* Cases as texels of a texture, and the results of a screen pass for them as pixels. */
#ifndef MATC_FRAME_CASES_H
#define MATC_FRAME_CASES_H
#include "runtime/gpu_material/screen_pass.h"

/* Runs the text over width x height pixels of RGBA32F, whose sampler `cases` reads the texture;
 * rgba has what it wrote. Fails the test where it cannot. */
void frame_cases(GlContext *gl, const ScreenPassText *text, const TextureSpec *cases,
                 const int size[2], float *rgba);
#endif
