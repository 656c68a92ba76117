/* Even subdivision of triangles. */
#ifndef MATC_SCENE_DIVIDE_H
#define MATC_SCENE_DIVIDE_H
#include "runtime/gl/shape.h"

/* Divides every triangle into n^2 triangles in rows, whose vertices are on the triangle's plane:
 * normals have unit length, all else is interpolated. Vertices on an edge are identical for both
 * of its triangles. False: out of memory, *made is empty. */
bool scene_divide(const Shape *shape, int n, Shape *made);
/* Returns the point of a triangle with these barycentric weights, which add up to n, as in a
 * division by scene_divide(). On an edge it is the same for both triangles. */
ShapeVertex scene_divide_point(const Shape *shape, int triangle, const int weights[3], int n);
/* Writes the indices of n^2 triangles whose vertices are in rows: one at corner 0, two in the
 * next row, up to n + 1 from corner 1 to corner 2. Returns the end of the written indices. */
uint32_t *scene_divide_rows(const uint32_t *rows, int n, uint32_t *next);
#endif
