/* Compares numbers of the C references with expected ones. */
#ifndef TESTS_NEAR_H
#define TESTS_NEAR_H
#include "compiler/library/reference.h"
#include <math.h>

enum { SAMPLES = 20000 };

static const ReferenceContext groimp = {.noise = REFERENCE_GROIMP};

static inline void near(double actual, double expected, double tolerance)
{
    if (!(fabs(actual - expected) <= tolerance))
        fail_msg("%.17g is not %.17g within %g", actual, expected, tolerance);
}

static inline void inside(double value, double low, double high)
{
    if (!(value >= low && value <= high))
        fail_msg("%.17g is not in [%g, %g]", value, low, high);
}

/* Uniform in [-1, 1), equal on every machine. */
static inline double sample(void)
{
    static uint64_t state = 1;
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)state / 9223372036854775808.;
}

static inline double value_of(void (*reference)(const void *, const double *, double *), double a,
                              double b, double c)
{
    const double args[] = {a, b, c};
    double result[4];
    reference(&groimp, args, result);
    return result[0];
}
#endif
