/* Vertices where texture coordinates turn back. */
#ifndef MATC_SCENE_MODEL_SIDES_H
#define MATC_SCENE_MODEL_SIDES_H
#include "runtime/mesh_import/model.h"

/* Twice the area of a triangle in u and v, negative where it is mirrored; 0 where it is too small
 * for tangents: below 1e-12. */
float model_area(const float a[2], const float b[2], const float c[2]);

/* Makes two of every vertex where mirrored triangles meet others; the second ones stand at the end.
 * `kept`: NULL, or a row for each vertex and as many again; the row of a vertex that becomes two is
 * copied. False: out of memory. */
bool model_part_sides(Shape *shape, float (*kept)[3]);
#endif
