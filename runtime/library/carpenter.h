/* The relief of the Carpenter map. */
#ifndef MATC_CARPENTER_H
#define MATC_CARPENTER_H
#include <stdint.h>

/* Fills width x height texels, row 0 at the bottom, each from 1 to 2048. All are finite. */
void carpenter_bake(double color, double noise, double roughness, int64_t seed, int width, int height, float *texels);
#endif
