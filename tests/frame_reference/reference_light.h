/* Expected light of a frame, in double, for tests: the material at a ray's hit is the C
 * oracle's, the light is summed by the formulas of semantics.md 4.1 and scene.def. No shader and
 * no compiler code takes part. */
#ifndef MATC_REFERENCE_LIGHT_H
#define MATC_REFERENCE_LIGHT_H
#include "compiler/matc.h"
#include "tests/frame_reference/reference_ray.h"

typedef struct {
    double light[3]; /* linear light */
    bool edge;       /* another surface is within one pixel */
    bool nothing;    /* no object is hit */
} Sample;

enum { REFERENCE_LAYERS = 64 };

/* Light along a ray: front to back until it is opaque, the sky last. Returns the number of
 * surfaces, and the last hit. */
int reference_pixel(const Tracer *tracer, const Ray *ray, const MatcOptions *options, double sum[3],
                    Hit hits[REFERENCE_LAYERS]);
/* Light that a surface sends back along a ray, reflected and emitted. */
void reference_surface_light(const Tracer *tracer, const Hit *hit, const Ray *ray,
                             const MatcOptions *options, double light[3]);
/* The surface's slot diffuse, times its opacity. */
void reference_surface_diffuse(const Tracer *tracer, const Hit *hit, const MatcOptions *options,
                               double diffuse[3]);
/* Expected value of pixel (x, y). */
Sample reference_sample(const Tracer *tracer, int x, int y, const MatcOptions *options);
#endif
