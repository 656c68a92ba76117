/* A displaced body over nothing, as tests of displacement by the driver look at it. */
#ifndef MATC_FRAME_DISPLACED_BODIES_H
#define MATC_FRAME_DISPLACED_BODIES_H
#include "runtime/render/render.h"

enum { DISPLACED_EDGE = 64 /* pixels of the picture */, DISPLACED_BODIES = 4 };

/* Displaced by `how`, such as "method: grid, level: 3": a box of rock, a ball of tiles, a cylinder that leans, a square of rock; so bright that light is above 0.1. */
Scene *displaced_body(int body, const char *how, const MatcOptions *options, MatcDocument **document);
/* Of so many views from all around; or, of the square, from above. */
void displaced_look_from(Scene *scene, int body, int view, int views);
/* Pixels of the background where a picture without holes shows the body, as it does all around; `within` counts those that show it. */
int displaced_holes(const float *light, const float *whole, long *within);
#endif
