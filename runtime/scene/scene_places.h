/* Which vertices of a shape stand in one place. */
#ifndef MATC_SCENE_PLACES_H
#define MATC_SCENE_PLACES_H
#include "runtime/gl/shape.h"

/* By vertex: the first that stands in the same place. From malloc; NULL: memory ran out. */
int *scene_places(const Shape *shape);
/* By such a vertex: what all of its place are moved by, which is the first with the sum of their
 * different normals. Others are left alone. */
void scene_places_join(const Shape *shape, const int *first, ShapeVertex *joined);
#endif
