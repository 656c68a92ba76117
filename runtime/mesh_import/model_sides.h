/* Splits vertices between mirrored and unmirrored texture coordinates. */
#ifndef MATC_SCENE_MODEL_SIDES_H
#define MATC_SCENE_MODEL_SIDES_H
#include "runtime/mesh_import/model.h"

/* Returns twice the signed area of a triangle in (u, v): negative for mirrored coordinates, 0 if
 * too small for tangents (below 1e-12). */
float model_area(const float a[2], const float b[2], const float c[2]);

/* Duplicates every vertex shared by mirrored and unmirrored triangles; duplicates are appended.
 * `kept`: NULL, or a row per vertex with capacity for twice as many; the row of a duplicated
 * vertex is copied. Returns false if memory runs out. */
bool model_part_sides(Shape *shape, float (*kept)[3]);
#endif
