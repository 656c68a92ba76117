/* Finer triangles. */
#ifndef MATC_SCENE_DIVIDE_H
#define MATC_SCENE_DIVIDE_H
#include "runtime/gl/shape.h"

/* Every triangle as n^2 in rows, its vertices on planes between its corners: normals have unit
 * length, the rest is mixed. Vertices on an edge stand in one place, whichever of its triangles
 * they are of. False: memory ran out, *made is empty. */
bool scene_divide(const Shape *shape, int n, Shape *made);
/* The point of a triangle whose corners count by these weights, which sum up to n: as such a
 * division would have it. On an edge it is the same, whichever of its triangles is asked. */
ShapeVertex scene_divide_point(const Shape *shape, int triangle, const int weights[3], int n);
/* The indices of n^2 triangles whose vertices stand in rows: one at corner 0, two behind it, up to
 * n + 1 from corner 1 to corner 2. The end. */
uint32_t *scene_divide_rows(const uint32_t *rows, int n, uint32_t *next);
#endif
