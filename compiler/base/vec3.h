/* Vectors of three doubles. Sums are taken in the order x, y, z, so that results are
 * bit-identical everywhere.
 *
 *     vec3_cross(x, y, z)      z = x cross y; z may alias x or y
 *     vec3_length(v)           sqrt(v . v); overflows above 1e154, vec3_normalize does not */
#ifndef MATC_VEC3_H
#define MATC_VEC3_H
#include <math.h>
#include <stdbool.h>
#include <string.h>

static inline double vec3_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double vec3_length(const double v[3]) { return sqrt(vec3_dot(v, v)); }

static inline void vec3_cross(const double a[3], const double b[3], double result[3])
{
    const double cross[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                             a[0] * b[1] - a[1] * b[0]};
    memcpy(result, cross, sizeof cross);
}

/* Returns false and leaves the vector unchanged if its length is 0 or not finite. */
static inline bool vec3_normalize(double v[3])
{
    const double length = hypot(hypot(v[0], v[1]), v[2]);
    if (!(length > 0) || !isfinite(length))
        return false;
    for (int i = 0; i < 3; i++)
        v[i] /= length;
    return true;
}

/* Returns true if both vectors have a length and are not collinear. */
static inline bool vec3_span(const double u[3], const double v[3])
{
    double a[3] = {u[0], u[1], u[2]}, b[3] = {v[0], v[1], v[2]}, cross[3];
    if (!vec3_normalize(a) || !vec3_normalize(b))
        return false;
    vec3_cross(a, b, cross);
    return vec3_dot(cross, cross) > 1e-12;
}
#endif
