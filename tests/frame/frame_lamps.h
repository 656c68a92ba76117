/* Scenes of many lights, for tests. */
#ifndef MATC_FRAME_LAMPS_H
#define MATC_FRAME_LAMPS_H
#include "runtime/scene/scene.h"

typedef struct {
    const char *name, *head; /* objects, camera, tone mapping */
    const char *kind;        /* of lights, or: */
#define FRAME_LAMPS_BOTH "spots among points"
    int count;
    double low, high, reach, sum; /* their heights; how far to the sides; of their intensities */
    int bright;                   /* so many times as bright as the others is the first */
} FrameLamps;

#define FRAME_LAMPS_CAMERA                                                                         \
    "camera: { camera: Perspective, position: [.5, -6, 3], target: [0, 0, 0] }\n"
/* A view so narrow that a block's pixels see a light from nearly the same side. */
#define FRAME_LAMPS_ZOOM                                                                           \
    "camera: { camera: Perspective, position: [.5, -6, 3], target: [0, 0, 0], angle: 4 }\n"
/* An object 12 by 12 at the height 0. */
#define FRAME_LAMPS_FLOOR(slots)                                                                   \
    "{ object: Parallelogram, u: [12, 0, 0], v: [0, 12, 0], transform: { translation: [-6, -6, "   \
    "0] }, material: { "                                                                           \
    "material: Phong, " slots " } }"

/* The document, the lights at random places, without shadows. From malloc. */
char *frame_lamps_text(const FrameLamps *lamps, int width, int height);
/* Display value of light, from 0 to 1, by the formulas that matc --list=scenes gives; `greatest` is
 * the pixel's greatest component for Exponential, the picture's for Linear. The value encoded by
 * IEC 61966-2-1; and both, for mappings that depend on one component: Clamp, Filmic, Shoulder. */
double frame_lamps_mapped(SceneKind tone, double light, double greatest);
double frame_lamps_encoded(double mapped);
double frame_lamps_shown(SceneKind tone, double exposure, double light);
#endif
