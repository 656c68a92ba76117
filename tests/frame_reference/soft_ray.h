/* Visible share of an area light from a point, by Embree's rays to all of the light. */
#ifndef MATC_SOFT_RAY_H
#define MATC_SOFT_RAY_H
#include "tests/frame_reference/reference_ray.h"

typedef struct {
    int edge; /* edge x edge rays, each to a random position in its cell of the light */
    uint64_t seed;
    bool glass; /* rays continue through transparent surfaces: glass_ray.h */
} SoftRays;

/* Arriving share of a diffuse surface's unshadowed light: each ray is weighted by its cosines
 * and distance. */
void soft_shares(const Tracer *tracer, const SceneLight *light, const Hit *hit,
                 const SoftRays *rays, double shares[3]);
#endif
