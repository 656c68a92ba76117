/* Visibility queries of bisection_reference.c for a camera. */
#ifndef TESTS_BISECTION_SEEN_H
#define TESTS_BISECTION_SEEN_H
#include "runtime/scene/scene.h"

/* Around a triangle's points, wherever they are moved. */
typedef struct {
    double low[3], high[3];
    const double (*normal)[3]; /* of its three corners */
    double longest;            /* of the normals at corners of its base */
    bool closed;
} BisectionBox;

/* As far as it counts: its distance, eight times that where it is not seen, or less for its
 * shadow's sake. */
double bisection_seen_far(const Scene *scene, const BisectionBox *box);
#endif
