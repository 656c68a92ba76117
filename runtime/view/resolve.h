/* From samples to a picture's bytes. */
#ifndef MATC_VIEW_RESOLVE_H
#define MATC_VIEW_RESOLVE_H

/* One row of `width` pixels from n rows of width * n RGBA samples, linear: the mean of each box of n x n, as sRGB bytes. */
void resolve_row(const float *samples, int width, int n, unsigned char *rgb);

/* A linear value as an sRGB byte; NaN is 0. */
unsigned char resolve_encode(double linear);
#endif
