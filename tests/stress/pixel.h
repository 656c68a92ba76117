/* Footprints of pixels, for --aa. */
#ifndef MATC_STRESS_PIXEL_H
#define MATC_STRESS_PIXEL_H
#include "compiler/ir/ir.h"

/* Change of every varying toward the next pixel on the right and upward, as a multiple of itself: a
 * program whose dFdx and dFdy are such products computes the values of its IR, at any point. */
typedef struct {
    double right, up;
} Pixel;

/* None, ordinary, tiny and huge ones in turn. */
Pixel pixel_number(long index);
/* The changes of the inputs that are there. */
void pixel_inputs(Pixel pixel, double inputs[INPUT_COUNT][4]);
/* A fragment program with dFdx and dFdy as those products; to be freed. */
char *pixel_program(Pixel pixel, const char *fragment);
#endif
