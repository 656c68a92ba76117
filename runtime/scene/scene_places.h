/* Vertices of a shape that have equal positions. */
#ifndef MATC_SCENE_PLACES_H
#define MATC_SCENE_PLACES_H
#include "runtime/gl/shape.h"

/* Returns, by vertex, the first vertex with the same position. From malloc; NULL if memory runs
 * out. */
int *scene_places(const Shape *shape);
/* Computes the attributes by which all vertices at a position are displaced: those of the first
 * one, with the sum of the different normals. Stored at the first vertex; other elements are
 * unchanged. */
void scene_places_join(const Shape *shape, const int *first, ShapeVertex *joined);
#endif
