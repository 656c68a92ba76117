/* Classifies a point as lit or in shadow, except within a band around shadow boundaries. */
#ifndef MATC_SHADOW_BAND_H
#define MATC_SHADOW_BAND_H
#include "tests/frame_reference/shadow_ray.h"

/* Expected light by Embree's rays to the first light: 1 or 0; -1 near a shadow boundary: one of
 * 24 points around, at most `step` away across the light's direction, has another result. */
int shadow_band_expected(const Tracer *tracer, const Hit *hit, double step);
#endif
