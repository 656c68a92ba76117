/* Distance of drawn numbers from the expected ones. */
#ifndef MATC_VALUE_APART_H
#define MATC_VALUE_APART_H
#include <math.h>
#include <stdbool.h>

/* Updates the greatest error. */
static inline double note(double error, double *worst)
{
    *worst = fmax(*worst, error);
    return error;
}

/* Greatest difference of three components; infinite for NaN. */
static inline double apart(const float *drawn, const double *want)
{
    double most = 0;
    for (int i = 0; i < 3; i++)
        most = isnan(drawn[i]) ? INFINITY : fmax(most, fabs(drawn[i] - want[i]));
    return most;
}

/* Angle between unit vectors in degrees. */
static inline double angle(const float *drawn, const double *want)
{
    double square = 0;
    for (int i = 0; i < 3; i++)
        square += pow(drawn[i] - want[i], 2);
    return 2 * asin(fmin(sqrt(square) / 2, 1)) * 180 / 3.14159265358979323846;
}

/* True if a Checker of x may have either color. */
static inline bool at_border(double x, double reach)
{
    return fabs(2 * x - round(2 * x)) < 2 * reach;
}
#endif
