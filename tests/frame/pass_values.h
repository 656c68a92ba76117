/* Reads back values that a full-screen pass computes: for tests of GLSL. */
#ifndef MATC_PASS_VALUES_H
#define MATC_PASS_VALUES_H
#include "runtime/gpu_material/screen_pass.h"

/* Draws a square of side x side pixels, row 0 at the bottom; `text` has the format RGBA32F. An
 * error fails the test. */
void pass_values(GlContext *gl, const ScreenPassText *text, int side, float (*values)[4]);
#endif
