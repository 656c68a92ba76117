/* Footprints of pixels, for --aa. */
#ifndef MATC_STRESS_PIXEL_H
#define MATC_STRESS_PIXEL_H
#include "compiler/ir/ir.h"

/* Change of every varying toward the next pixel on the right and upward, as a multiple of
 * itself: a program whose dFdx and dFdy are such products computes the values of its IR, at any
 * point. */
typedef struct {
    double right, up;
} Pixel;

/* A sequence of pixels: none, ordinary, tiny and huge ones in turn. */
Pixel pixel_number(long index);
/* Sets the changes of the existing inputs. */
void pixel_inputs(Pixel pixel, double inputs[INPUT_COUNT][4]);
/* A fragment program with those products for dFdx and dFdy; free it. */
char *pixel_program(Pixel pixel, const char *fragment);
#endif
