/* Reference of ambient occlusion and indirect light at a point, by many rays in
 * double, for tests: Embree finds the hits, reference_light computes their light. No code of the
 * renderer takes part.
 *
 *   a point on a floor, a wall as high as the point is far from it: the wall occludes
 *   (1 - 1 / sqrt(2)) / 2 of the cosine-weighted hemisphere, so that ambient occlusion is 0.854 */
#ifndef MATC_OPEN_RAY_H
#define MATC_OPEN_RAY_H
#include "tests/frame_reference/reference_light.h"

/* Settings of a point's rays. */
typedef struct {
    int across;     /* across * across rays, one for each cell of the unit square: 64 are 4096 */
    double radius;  /* ray length; INFINITY: unbounded */
    int power;      /* a hit at the share t of the radius occludes 1 - t^power; 0: 1 */
    bool uniform;   /* uniform directions; else cosine-weighted */
    int bounces;    /* bounces of light: 1 is light from surfaces that lights reach directly */
    uint64_t state; /* state of the random numbers */
} OpenRays;

typedef struct {
    double open; /* ambient occlusion, in [0, 1] */
    double light
        /* mean light of the rays' hits, which multiplies a Lambertian surface's diffuse like a
         * light's intensity times a cosine; 0 without options */
        [3];
    /* bent normal: the mean direction of rays that miss, of length 1; 0 if no ray misses */
    double way[3];
} Open;

/* Result for a ray's hit point. `options` compile its material, and those of other hits; NULL:
 * no light. */
Open open_ray(const Tracer *tracer, const Hit *hit, OpenRays *rays, const MatcOptions *options);
#endif
