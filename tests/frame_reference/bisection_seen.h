/* Visibility queries of bisection_reference.c for a camera. */
#ifndef TESTS_BISECTION_SEEN_H
#define TESTS_BISECTION_SEEN_H
#include "runtime/scene/scene.h"

/* Bounding box of a triangle's displaced points. */
typedef struct {
    double low[3], high[3];
    const double (*normal)[3]; /* normals of its three corners */
    double longest;            /* longest normal at the corners of its base */
    bool closed;
} BisectionBox;

/* Effective distance: the distance from the camera, times eight if the box is invisible, or less
 * if its shadow is visible. */
double bisection_seen_far(const Scene *scene, const BisectionBox *box);
#endif
