/* A displaced mesh in front of an empty background, for tests of displacement by the driver. */
#ifndef MATC_FRAME_DISPLACED_BODIES_H
#define MATC_FRAME_DISPLACED_BODIES_H
#include "runtime/renderer/renderer.h"

enum {
    DISPLACED_EDGE = 64 /* pixels of the picture */,
    DISPLACED_BODIES = 5,
    DISPLACED_VIEWS = 3,
    DISPLACED_VIEW_FLOATS = 4 * DISPLACED_EDGE * DISPLACED_EDGE
};

/* Displaced by `how`, such as "method: grid, level: 3": a box of rock, a ball of tiles, a cylinder
 * that leans, a square of rock, a cube from -1 to 1 that nothing moves but by a millionth; so
 * bright that light is above 0.1. */
Scene *displaced_body(int body, const char *how, const MatcOptions *options,
                      MatcDocument **document);
/* Drawn once, so that its triangles came back. */
Scene *displaced_drawn(GlContext *gl, int body, const char *how, MatcDocument **document);
/* Light of views from all around; or, of the square, from above: DISPLACED_VIEWS times
 * DISPLACED_VIEW_FLOATS. */
void displaced_draw_views(GlContext *gl, int body, const char *how, float *light);
/* How far a point is from those of a displaced shape that were in the same place; INFINITY: none
 * was. */
double displaced_nearest(const Shape *shape, const float position[3], const float base[3]);
/* Pixels of the background where a picture without holes shows the body, as it does two pixels
 * around; `within` counts those that show it. */
int displaced_holes(const float *light, const float *whole, long *within);
/* Counts holes in all views of two bodies that are displaced by `how`, against their meshes divided
 * finely. */
int displaced_holes_of(GlContext *gl, const int bodies[2], const char *how, long *within);
#endif
