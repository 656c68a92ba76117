/* Errors of a driver's texture sampler in the values of a picture. */
#ifndef MATC_VALUE_SAMPLER_H
#define MATC_VALUE_SAMPLER_H
#include "tests/value/points.h"

/* Takes in what the material has where every texel of its pictures is a code of 8 bits more or
 * less, the components together and apart.
 *
 * llvmpipe's weights have 8 bits, so either axis errs by up to 1/256 of the difference of two
 * texels, and the mixes by rows and by columns are rounded to half a code each: 2 / 256 + 2 / 510 <
 * 3 / 255, of texels as far apart as can be. hull_miss takes a hull to be wider by its own width on
 * both sides, so that one code either way allows three. */
void sampler_widen(Oracle *oracle, const Graph *graph, int material, const PointSet *points,
                   Hull *hulls);
#endif
