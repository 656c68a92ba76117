/* Errors of a driver's texture sampler in the values of a picture. */
#ifndef MATC_VALUE_SAMPLER_H
#define MATC_VALUE_SAMPLER_H
#include "tests/value/points.h"

/* Widens the hulls by the material's values with the texels of its pictures shifted by one 8-bit
 * code up or down, the components together and separately.
 *
 * llvmpipe's weights have 8 bits, so either axis errs by up to 1/256 of the difference of two
 * texels, and interpolations by rows and by columns are rounded to half a code each: 2 / 256 + 2
 * / 510 < 3 / 255, for texels of maximal difference. hull_miss widens a hull by its own width on
 * both sides, so that a shift by one code allows an error of three. */
void sampler_widen(Oracle *oracle, const Graph *graph, int material, const PointSet *points,
                   Hull *hulls);
#endif
