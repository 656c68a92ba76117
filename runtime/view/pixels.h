/* From samples to a picture's bytes. */
#ifndef MATC_VIEW_PIXELS_H
#define MATC_VIEW_PIXELS_H
#include <stdbool.h>

/* One row of `width` pixels from n rows of width * n RGBA samples, linear: the mean of each box of n x n, as sRGB bytes; not encoded:
 * as bytes of 255 times the mean. */
void pixels_row(const float *samples, int width, int n, bool encoded, unsigned char *rgb);

/* A linear value as an sRGB byte; NaN is 0. */
unsigned char pixels_encode(double linear);
#endif
