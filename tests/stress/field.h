/* Hostile surface points with every number a float, equal in every run. */
#ifndef MATC_STRESS_FIELD_H
#define MATC_STRESS_FIELD_H
#include "tests/value/points.h"

enum { FIELD_EDGE = 64, FIELD_COUNT = FIELD_EDGE * FIELD_EDGE };

/* Coordinates 0, -0, denormal, 1e-8 to 1e8, borders of cells and adjacent floats; normals and
 * tangents that are zero, tiny, long, parallel. A quarter of the points is ordinary. */
void hostile_points(Point points[FIELD_COUNT]);
#endif
