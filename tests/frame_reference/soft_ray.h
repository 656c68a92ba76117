/* Visible share of an area light from a point, by Embree's rays to all of the light. */
#ifndef MATC_SOFT_RAY_H
#define MATC_SOFT_RAY_H
#include "tests/frame_reference/reference_ray.h"

typedef struct {
    int edge; /* a ray to each of so many by so many parts of the light, at random in it */
    uint64_t seed;
    bool glass; /* rays go on through what they meet: glass_ray.h */
} SoftRays;

/* The shares of what a matt surface would get of the light without anything between: each ray
 * counts by the cosines and the distance. */
void soft_shares(const Tracer *tracer, const SceneLight *light, const Hit *hit,
                 const SoftRays *rays, double shares[3]);
#endif
