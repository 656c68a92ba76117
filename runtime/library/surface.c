/* What a surface's slots go through: exponents, unit vectors. */
#include "runtime/library/reference.h"
#include <string.h>

#define EXPONENT_LIMIT 65504. /* the greatest half float */
#define LEAST_LENGTH   1e-37

REFERENCE(phongExponent)
{
    (void)context;
    double y = args[0] * (2 - args[0]), w = (1 - args[0]) * (1 - args[0]);
    if (y <= 0)
        result[0] = 0;
    else if (y >= 1)
        result[0] = EXPONENT_LIMIT;
    /* log1p, as y = 1 - w has lost the digits of a small w. */
    else
        result[0] = fmin(-2 / (w < .5 ? log1p(-w) : log(y)), EXPONENT_LIMIT);
}

REFERENCE(safeNormalize)
{
    (void)context;
    double greatest = fmax(fmax(fabs(args[0]), fabs(args[1])), fabs(args[2]));
    if (greatest < LEAST_LENGTH) {
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
    double length = sqrt(args[0] * args[0] + args[1] * args[1] + args[2] * args[2]), toward = 0, n[3];
    length = fmax(length, 1e-30);
    for (int i = 0; i < 3; i++) {
        n[i] = args[i] / length;
        toward += n[i] * args[3 + i];
    }
    for (int i = 0; i < 3; i++)
        result[i] = (args[3 + i] - n[i] * toward) / length;
}

/* The oracle's eye space is the world. */
REFERENCE(eyeFromWorld)
{
    (void)context;
    memmove(result, args, 3 * sizeof(double));
}
