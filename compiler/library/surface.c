/* Functions of slots: exponents, unit vectors, frames. */
#include "compiler/library/reference.h"
#include <string.h>

#define EXPONENT_LIMIT 65504. /* the largest half float */
#define MIN_LENGTH     1e-37

REFERENCE(phongExponent)
{
    (void)context;
    double y = args[0] * (2 - args[0]), w = (1 - args[0]) * (1 - args[0]);
    if (y <= 0)
        result[0] = 0;
    else if (y >= 1)
        result[0] = EXPONENT_LIMIT;
    /* uses log1p, because y = 1 - w has lost the digits of a small w */
    else
        result[0] = fmin(-2 / (w < .5 ? log1p(-w) : log(y)), EXPONENT_LIMIT);
}

REFERENCE(safeNormalize)
{
    (void)context;
    double greatest = fmax(fmax(fabs(args[0]), fabs(args[1])), fabs(args[2]));
    if (greatest < MIN_LENGTH) {
        memcpy(result, (const double[3]){0, 0, 1}, 3 * sizeof(double));
        return;
    }
    double v[3] = {args[0] / greatest, args[1] / greatest, args[2] / greatest};
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; i++)
        result[i] = v[i] / length;
}

REFERENCE(normalizeAlong)
{
    (void)context;
    double length = sqrt(args[0] * args[0] + args[1] * args[1] + args[2] * args[2]), toward = 0,
           n[3];
    length = fmax(length, 1e-30);
    for (int i = 0; i < 3; i++) {
        n[i] = args[i] / length;
        toward += n[i] * args[3 + i];
    }
    for (int i = 0; i < 3; i++)
        result[i] = (args[3 + i] - n[i] * toward) / length;
}

static double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Rotates by the angle of du in the frame (t, b) of the normal. */
REFERENCE(anisotropyStored)
{
    (void)context;
    const double *n = args + 2, *du = args + 5, *dv = args + 8, flat = n[0] * n[0] + n[1] * n[1];
    /* guards against a rounded n near (0, 0, -1) */
    const double w = 1 / fmax(n[2] < 0 ? flat / (1 - n[2]) : 1 + n[2], 1e-12);
    const double t[3] = {1 - w * n[0] * n[0], -w * n[0] * n[1], -n[0]},
                 b[3] = {-w * n[0] * n[1], 1 - w * n[1] * n[1], -n[1]};
    const double cross[3] = {du[1] * dv[2] - du[2] * dv[1], du[2] * dv[0] - du[0] * dv[2],
                             du[0] * dv[1] - du[1] * dv[0]};
    const double strength = hypot(args[0], args[1]), own = atan2(args[1], args[0]);
    const double turn = 2 * atan2(dot3(du, b), dot3(du, t)) + (dot3(cross, n) < 0 ? -own : own);
    result[0] = strength * cos(turn);
    result[1] = strength * sin(turn);
}

/* The oracle's eye space is world space. */
REFERENCE(eyeFromWorld)
{
    (void)context;
    memmove(result, args, 3 * sizeof(double));
}
