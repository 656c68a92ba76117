/* Cases as texels of a texture, and the results of a screen pass for them as pixels. */
#ifndef MATC_FRAME_CASES_H
#define MATC_FRAME_CASES_H
#include "runtime/gpu_material/screen_pass.h"

/* Runs the shader over width x height pixels of RGBA32F; its sampler `cases` reads the texture,
 * and rgba receives the result. Fails the test on an error. */
void frame_cases(GlContext *gl, const ScreenPassText *text, const TextureSpec *cases,
                 const int size[2], float *rgba);
#endif
