/* What a surface's slots go through: exponents, unit vectors, and the encodings of the G-buffer. */
#include "runtime/reference.h"
#include <string.h>

#define EXPONENT_LIMIT 65504. /* the greatest half float */
#define LEAST_LENGTH   1e-37
#define PAIR_SCALE     127.5 /* the greatest code is 127 */

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

/* For a unit vector the radius |n.xy| / sqrt(8 n.z + 8) is sqrt((1 - n.z) / 8), which keeps its digits below the equator. */
REFERENCE(encodeSpheremap)
{
    (void)context;
    double x = args[0], y = args[1], z = args[2], length = hypot(x, y);
    double scale = z < 0 ? sqrt((1 - z) / 8) : length / sqrt(8 * z + 8);
    bool directed = length > 1e-15;
    result[0] = clamp((directed ? x / length : 1) * scale + .5, 0, 1);
    result[1] = clamp((directed ? y / length : 0) * scale + .5, 0, 1);
}

REFERENCE(decodeSpheremap)
{
    (void)context;
    double x = 4 * args[0] - 2, y = 4 * args[1] - 2, d = fmin(x * x + y * y, 4), scale = sqrt(1 - d / 4);
    result[0] = x * scale;
    result[1] = y * scale;
    result[2] = 1 - d / 2;
}

REFERENCE(packPair)
{
    (void)context;
    double x = floor(PAIR_SCALE * clamp(args[0], 0, 1)), y = floor(PAIR_SCALE * clamp(args[1], 0, 1));
    result[0] = ldexp(1 + fraction(x / 8) + y / 1024, (int)floor(x / 8));
}

REFERENCE(unpackPair)
{
    (void)context;
    int exponent;
    double m = 8 * (2 * frexp(clamp(args[0], 1, EXPONENT_LIMIT), &exponent) - 1);
    result[0] = (floor(m) + 8 * (exponent - 1)) / PAIR_SCALE;
    result[1] = 128 * fraction(m) / PAIR_SCALE;
}

/* The oracle's eye space is the world. */
REFERENCE(eyeFromWorld)
{
    (void)context;
    memmove(result, args, 3 * sizeof(double));
}
