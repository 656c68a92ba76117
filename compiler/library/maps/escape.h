/* Escape-time iteration shared by the references of mandel and julia. */
#ifndef MATC_ESCAPE_H
#define MATC_ESCAPE_H
#include "compiler/library/reference.h"

/* Fraction of the steps z -> z^2 + c with |z| <= 2, scaled to [-1, 1]. */
static inline double escape(const double start[2], const double c[2], double iterations)
{
    double x = start[0], y = start[1];
    int steps = 0, most = whole_between(iterations, 0, REFERENCE_STEPS);
    for (; steps < most; steps++) {
        double next = x * x - y * y + c[0];
        y = 2 * x * y + c[1];
        x = next;
        if (x * x + y * y > 4)
            break;
    }
    return 2 * steps / (iterations > 1 ? iterations : 1) - 1;
}
#endif
