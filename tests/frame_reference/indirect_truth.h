/* Reference of ambient occlusion and indirect light at places of a picture, by many rays in
 * double (open_ray.h), and the error of a picture against it. */
#ifndef MATC_INDIRECT_TRUTH_H
#define MATC_INDIRECT_TRUTH_H
#include "tests/frame/indirect_scenes.h"
#include "tests/frame_reference/open_ray.h"

/* pixels between places; max places: those of 512 x 512 pixels */
enum { INDIRECT_TRUTH_APART = 8, INDIRECT_TRUTH_MAX = 4096 };

typedef struct {
    int pixel;
    Open open;
} IndirectPlace;

typedef struct {
    IndirectPlace places[INDIRECT_TRUTH_MAX];
    int count;
    double light; /* mean over places and components */
} IndirectTruth;

/* Finds the truth at places in rows and columns, except at edges of objects, where a pixel's
 * center may be on either side. The state of `rays` is set for each place. */
void indirect_truth_find(const Scene *scene, const OpenRays *rays, const MatcOptions *options,
                         IndirectTruth *truth);
/* Root mean square error of a view of the whole picture: of ambient occlusion, or of light
 * relative to its mean. */
double indirect_truth_off(const IndirectTruth *truth, const float *rgba, bool light);
/* Relative excess of the picture's mean light over the truth. */
double indirect_truth_more(const IndirectTruth *truth, const float *rgba);
#endif
