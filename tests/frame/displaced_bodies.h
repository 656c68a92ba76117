/* A displaced mesh in front of an empty background, for tests of displacement by the driver. */
#ifndef MATC_FRAME_DISPLACED_BODIES_H
#define MATC_FRAME_DISPLACED_BODIES_H
#include "runtime/renderer/renderer.h"

enum {
    DISPLACED_EDGE = 64 /* width and height of the picture in pixels */,
    DISPLACED_BODIES = 5,
    DISPLACED_VIEWS = 3,
    DISPLACED_VIEW_FLOATS = 4 * DISPLACED_EDGE * DISPLACED_EDGE
};

/* Reads a scene displaced by `how`, such as "method: grid, level: 3": a box of rock, a ball of
 * tiles, a slanted cylinder, a square of rock, or a cube from -1 to 1 displaced by only a
 * millionth. The material is so bright that the light exceeds 0.1. */
Scene *displaced_body(int body, const char *how, const MatcOptions *options,
                      MatcDocument **document);
/* Draws a scene once, so that its triangles are captured. */
Scene *displaced_drawn(GlContext *gl, int body, const char *how, MatcDocument **document);
/* Draws views from all around, or of the square from above: DISPLACED_VIEWS times
 * DISPLACED_VIEW_FLOATS. */
void displaced_draw_views(GlContext *gl, int body, const char *how, float *light);
/* Distance of a point from the nearest point of a displaced shape with the same base point;
 * INFINITY if none has. */
double displaced_nearest(const Shape *shape, const float position[3], const float base[3]);
/* Counts background pixels where a picture without holes shows the mesh, also two pixels around;
 * `within` counts the pixels that show it. */
int displaced_holes(const float *light, const float *whole, long *within);
/* Counts holes in all views of two meshes displaced by `how`, against finely subdivided meshes. */
int displaced_holes_of(GlContext *gl, const int bodies[2], const char *how, long *within);
#endif
