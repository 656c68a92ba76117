/* Scenes of many lights, for tests. */
#ifndef MATC_FRAME_LAMPS_H
#define MATC_FRAME_LAMPS_H
#include "runtime/scene/scene.h"

typedef struct {
    const char *name, *head; /* objects, camera, tone mapping */
    const char *kind;        /* kind of the lights, or: */
#define FRAME_LAMPS_BOTH "spots among points"
    int count;
    /* range of heights; max distance to the sides; sum of intensities */
    double low, high, reach, sum;
    int bright; /* the first light is brighter by this factor */
} FrameLamps;

#define FRAME_LAMPS_CAMERA                                                                         \
    "camera: { camera: Perspective, position: [.5, -6, 3], target: [0, 0, 0] }\n"
/* So narrow a view that a block's pixels see a light from nearly equal directions. */
#define FRAME_LAMPS_ZOOM                                                                           \
    "camera: { camera: Perspective, position: [.5, -6, 3], target: [0, 0, 0], angle: 4 }\n"
/* A square of 12 by 12 at height 0. */
#define FRAME_LAMPS_FLOOR(slots)                                                                   \
    "{ object: Parallelogram, u: [12, 0, 0], v: [0, 12, 0], transform: { translation: [-6, -6, "   \
    "0] }, material: { "                                                                           \
    "material: Phong, " slots " } }"

/* The document, with lights without shadows at random places. From malloc. */
char *frame_lamps_text(const FrameLamps *lamps, int width, int height);
/* Displayed value of light, in [0, 1], by the formulas of matc --list=scenes; `greatest` is the
 * pixel's greatest component for Exponential, the picture's for Linear. Then the value encoded
 * by IEC 61966-2-1; and both combined, for mappings of a single component: Clamp, Filmic,
 * Shoulder. */
double frame_lamps_mapped(SceneKind tone, double light, double greatest);
double frame_lamps_encoded(double mapped);
double frame_lamps_shown(SceneKind tone, double exposure, double light);
#endif
