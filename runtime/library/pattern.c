/* Derivatives and means over a box of the closed-form volume maps. */
#include "runtime/library/reference.h"

static double sinc(double x) { return fabs(x) < 1e-9 ? 1 : sin(x) / x; }

/* E (sum of sin)^2 = (sum of means)^2 + sum of variances, the three axes being independent over a box. */
REFERENCE(leopardFiltered)
{
    (void)context;
    double sum = 0, variance = 0;
    for (int i = 0; i < 3; i++) {
        double mean = sin(args[i]) * sinc(args[3 + i] / 2);
        sum += mean;
        variance += .5 - .5 * cos(2 * args[i]) * sinc(args[3 + i]) - mean * mean;
    }
    result[0] = (sum * sum + variance) / 9;
}

REFERENCE(leopardGradient)
{
    (void)context;
    double mean = (sin(args[0]) + sin(args[1]) + sin(args[2])) / 3;
    for (int i = 0; i < 3; i++)
        result[i] = mean * 2 / 3 * cos(args[i]);
    result[3] = mean * mean;
}

REFERENCE(woodGradient)
{
    (void)context;
    double r = hypot(args[0], args[1]);
    result[0] = r > 0 ? args[0] / r : 0;
    result[1] = r > 0 ? args[1] / r : 0;
    result[2] = 0;
    result[3] = r;
}
