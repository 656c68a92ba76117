/* What a frame's light should be, in double, for tests: the material at what a ray meets is the C
 * oracle's, the light is summed by the formulas of semantics.md 4.1 and scene.def. No shader and no
 * compiler has a part in it. */
#ifndef MATC_REFERENCE_LIGHT_H
#define MATC_REFERENCE_LIGHT_H
#include "compiler/matc.h"
#include "tests/frame_reference/reference_ray.h"

typedef struct {
    double light[3]; /* linear */
    bool edge;       /* something else is within a pixel of it */
    bool nothing;    /* no object is there */
} Sample;

enum { REFERENCE_LAYERS = 64 };

/* What a ray sees: front to back, until nothing passes, the sky last. Returns how many surfaces
 * count, and behind them what ends it. */
int reference_pixel(const Tracer *tracer, const Ray *ray, const MatcOptions *options, double sum[3],
                    Hit hits[REFERENCE_LAYERS]);
/* What a surface that a ray met sends back along it, of what lights send to it and of its own. */
void reference_surface_light(const Tracer *tracer, const Hit *hit, const Ray *ray,
                             const MatcOptions *options, double light[3]);
/* Its slot diffuse, as far as it is opaque. */
void reference_surface_diffuse(const Tracer *tracer, const Hit *hit, const MatcOptions *options,
                               double diffuse[3]);
/* What pixel x, y should be. */
Sample reference_sample(const Tracer *tracer, int x, int y, const MatcOptions *options);
#endif
