/* Half floats, for tests of values in RGBA16F targets. */
#ifndef MATC_VALUE_HALF_H
#define MATC_VALUE_HALF_H
#include <math.h>
#include <stdbool.h>

/* Distance between adjacent half floats near a number. */
static inline double half_step(double v)
{
    const int exponent = ilogb(fmax(fabs(v), 1e-30));
    return ldexp(1, (exponent > -14 ? exponent : -14) - 10);
}
/* Zero or a normal number: neither infinity nor NaN nor denormal. */
static inline bool half_is_plain(double v)
{
    return v == 0 || (isfinite(v) && fabs(v) >= ldexp(1, -14) && fabs(v) <= 65504);
}
#endif
