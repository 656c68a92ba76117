/* Gradients and box means of the closed-form volume maps. */
#include "compiler/library/reference.h"

static double sinc(double x) { return fabs(x) < 1e-9 ? 1 : sin(x) / x; }

/* Returns the mean of (sum of sin)^2 = (sum of means)^2 + sum of variances, as the axes are
 * independent over a box. */
static double leopard_mean(const double *args, double *sum)
{
    double variance = 0;
    *sum = 0;
    for (int i = 0; i < 3; i++) {
        double mean = sin(args[i]) * sinc(args[3 + i] / 2);
        *sum += mean;
        variance += .5 - .5 * cos(2 * args[i]) * sinc(args[3 + i]) - mean * mean;
    }
    return fmax(*sum * *sum + variance, 0) / 9; /* max(): rounding may give less than 0 */
}

REFERENCE(leopardFiltered)
{
    double sum;
    (void)context;
    result[0] = leopard_mean(args, &sum);
}

/* Derivative by x: (2 sum mean' - 2 mean mean' + sin(2 x) sinc(edge)) / 9. */
REFERENCE(leopardFilteredGradient)
{
    double sum;
    (void)context;
    result[3] = leopard_mean(args, &sum);
    for (int i = 0; i < 3; i++) {
        double left = sinc(args[3 + i] / 2), mean = sin(args[i]) * left;
        result[i] =
            (2 * (sum - mean) * cos(args[i]) * left + sin(2 * args[i]) * sinc(args[3 + i])) / 9;
    }
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
