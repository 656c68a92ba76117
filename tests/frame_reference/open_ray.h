/* Reference of ambient occlusion and one bounce of indirect light at a point, by many rays in
 * double, for tests: Embree finds the hits, reference_light computes their light. No code of the
 * renderer takes part.
 *
 *   a point on a floor, a wall as high as the point is far from it: the wall occludes
 *   (1 - 1 / sqrt(2)) / 2 of the cosine-weighted hemisphere, so that ambient occlusion is 0.854 */
#ifndef MATC_OPEN_RAY_H
#define MATC_OPEN_RAY_H
#include "tests/frame_reference/reference_light.h"

/* Rays of a point. */
typedef struct {
    int across;     /* across * across of them, one for each cell of the unit square: 64 are 4096 */
    double radius;  /* how far they go; INFINITY: without end */
    int power;      /* what is met at a share t of the radius keeps off 1 - t^power; 0: 1 */
    bool uniform;   /* as dense everywhere; else as the cosine */
    int bounces;    /* of light: 1 is what surfaces send that lights reach */
    uint64_t state; /* of what is random in it */
} OpenRays;

typedef struct {
    double open; /* from 0 to 1 */
    double light
        /* the mean of what rays meet: what a Lambertian surface's diffuse is times, as a light's
         * intensity times a cosine is; 0 without options */
        [3];
    /* the mean direction of rays that meet nothing, of length 1; 0 where there are none */
    double way[3];
} Open;

/* Result for a point that a ray met. `options` compile its material, and others'; NULL: no light.
 * */
Open open_ray(const Tracer *tracer, const Hit *hit, OpenRays *rays, const MatcOptions *options);
#endif
