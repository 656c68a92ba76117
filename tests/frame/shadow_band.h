/* Classifies a point as lit or in shadow, except within a band around shadow boundaries. */
#ifndef MATC_SHADOW_BAND_H
#define MATC_SHADOW_BAND_H
#include "tests/frame_reference/shadow_ray.h"

/* By Embree's rays to the first light: 1 or 0; -1: an end is near, as it is otherwise for one of 24
 * points beside, at most `step` across the light's way. */
int shadow_band_expected(const Tracer *tracer, const Hit *hit, double step);
#endif
