/* A mesh that casts shadows on itself, for tests of shadows: a tube along a knot. */
#ifndef MATC_SHADOW_KNOT_H
#define MATC_SHADOW_KNOT_H
#include "runtime/gl/shape.h"

/* 69,960 triangles, at most 1.13 from the origin. */
Shape shadow_knot(void);
#endif
