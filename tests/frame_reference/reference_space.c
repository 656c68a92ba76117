#include "tests/frame_reference/reference_space.h"
#include <math.h>
#include <string.h>

double reference_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void reference_cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

void reference_normalize(double v[3])
{
    const double length = sqrt(reference_dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

void reference_image(const SceneMatrix *m, const double v[3], double w, double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = m->m[i] * v[0] + m->m[4 + i] * v[1] + m->m[8 + i] * v[2] + m->m[12 + i] * w;
}

/* By Cramer's rule. */
void reference_preimage(const SceneMatrix *m, const double v[3], double w, double out[3])
{
    double moved[3], cross[3];
    for (int i = 0; i < 3; i++)
        moved[i] = v[i] - m->m[12 + i] * w;
    const double *c[3] = {m->m, m->m + 4, m->m + 8};
    reference_cross(c[1], c[2], cross);
    const double determinant = reference_dot(c[0], cross);
    for (int i = 0; i < 3; i++) {
        reference_cross(c[(i + 1) % 3], c[(i + 2) % 3], cross);
        out[i] = reference_dot(moved, cross) / determinant;
    }
}

/* The inverse transpose, up to length: its columns are cross products of the matrix's columns. */
void reference_across(const SceneMatrix *m, const double n[3], double out[3])
{
    const double *c[3] = {m->m, m->m + 4, m->m + 8};
    double cross[3], determinant[3];
    reference_cross(c[1], c[2], determinant);
    const double sign = reference_dot(c[0], determinant) < 0 ? -1 : 1;
    memset(out, 0, 3 * sizeof *out);
    for (int i = 0; i < 3; i++) {
        reference_cross(c[(i + 1) % 3], c[(i + 2) % 3], cross);
        for (int component = 0; component < 3; component++)
            out[component] += sign * n[i] * cross[component];
    }
}

void reference_normal(const SceneMatrix *m, const double n[3], double out[3])
{
    reference_across(m, n, out);
    reference_normalize(out);
}
