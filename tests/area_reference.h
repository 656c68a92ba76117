/* Reference for area lights, in double: the light of a parallelogram of radiance 1 at a point.
 * Integer exponents use Arvo's double axis moments (Irradiance Tensors, SIGGRAPH 1995) by
 * recurrence. Any exponent can use adaptive quadrature over triangles of the light, which shares
 * no formula with the moments. */
#ifndef MATC_AREA_REFERENCE_H
#define MATC_AREA_REFERENCE_H
#include <math.h>
#include <stdbool.h>
#include <string.h>

#define AREA_PI 3.14159265358979323846
enum { AREA_MAX = 12 /* max corners after clipping */ };

typedef struct {
    double corner[3], u[3], v[3]; /* corner and edges, relative to the lit point */
    bool both_sides;
    double normal[3], w[3]; /* the lit surface's normal; the lobe's axis; unit length */
    double exponent;
} AreaCase;

typedef struct {
    double corners[AREA_MAX][3];
    int count;
} AreaPolygon;

static double area_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void area_cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Normalizes v and returns its former length. */
static double area_normalize(double v[3])
{
    const double length = sqrt(area_dot(v, v));
    for (int i = 0; i < 3 && length > 0; i++)
        v[i] /= length;
    return length;
}

/* The visible part of the light, clockwise as seen from the point; empty behind a one-sided
 * light. */
static AreaPolygon area_seen(const AreaCase *c)
{
    AreaPolygon polygon = {.count = 4};
    double face[3];
    area_cross(c->u, c->v, face);
    const double height = -area_dot(face, c->corner);
    if (height == 0 || (height < 0 && !c->both_sides))
        polygon.count = 0;
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++) {
            const double first = height > 0 ? c->v[i] : c->u[i],
                         last = height > 0 ? c->u[i] : c->v[i];
            polygon.corners[k][i] =
                c->corner[i] + (k == 1 || k == 2 ? first : 0) + (k >= 2 ? last : 0);
        }
    return polygon;
}

static AreaPolygon area_clip(const AreaPolygon *polygon, const double normal[3])
{
    AreaPolygon left = {.count = 0};
    for (int i = 0; i < polygon->count; i++) {
        const double *a = polygon->corners[i], *b = polygon->corners[(i + 1) % polygon->count];
        const double high = area_dot(a, normal), next = area_dot(b, normal);
        if (high >= 0)
            memcpy(left.corners[left.count++], a, sizeof left.corners[0]);
        if ((high >= 0) != (next >= 0)) {
            for (int k = 0; k < 3; k++)
                left.corners[left.count][k] = a[k] + (b[k] - a[k]) * high / (high - next);
            left.count++;
        }
    }
    return left;
}

/* An arc between adjacent corners on the unit sphere: the inward normal of its plane. With s the
 * angle from the arc's point nearest to w, w.u is cosine * cos s. */
typedef struct {
    double m[3], angle, cosine, off, s[2];
} AreaArc;

static bool area_arc(const double a[3], const double b[3], const double w[3], AreaArc *arc)
{
    double beside[3], near[3], e[3];
    for (int i = 0; i < 3; i++)
        e[i] = b[i] - a[i];
    area_cross(a, e, arc->m);
    const double sine = area_normalize(arc->m);
    if (sine == 0)
        return false;
    arc->angle = atan2(sine, area_dot(a, b));
    arc->off = area_dot(w, arc->m);
    for (int i = 0; i < 3; i++)
        near[i] = w[i] - arc->off * arc->m[i];
    arc->cosine = sqrt(area_dot(near, near));
    if (arc->cosine < 1e-12)
        memcpy(near, a, sizeof near);
    area_cross(arc->m, near, beside);
    arc->s[0] = atan2(area_dot(beside, a), area_dot(near, a));
    arc->s[1] = arc->s[0] + arc->angle;
    return true;
}

/* van Oosterom and Strackee */
static double area_solid_angle(const AreaPolygon *p)
{
    double sum = 0;
    for (int i = 1; i + 1 < p->count; i++) {
        double a[3], b[3], c[3], cross[3];
        memcpy(a, p->corners[0], sizeof a);
        memcpy(b, p->corners[i], sizeof b);
        memcpy(c, p->corners[i + 1], sizeof c);
        area_normalize(a);
        area_normalize(b);
        area_normalize(c);
        area_cross(b, c, cross);
        sum += 2 * atan2(area_dot(a, cross), 1 + area_dot(a, b) + area_dot(b, c) + area_dot(c, a));
    }
    return sum;
}

/* Integrals of (cosine cos s)^k over the arc for k = first, first + 2, ... last: returns the sum
 * for k < last, and the integral for `last` separately. Integration by parts: C(k) = [cos^(k-1)
 * sin] / k + (k-1) / k C(k-2). */
static void area_powers(const AreaArc *arc, int first, int last, double *sum, double *top)
{
    const double c[2] = {cos(arc->s[0]), cos(arc->s[1])}, s[2] = {sin(arc->s[0]), sin(arc->s[1])};
    const double square = arc->cosine * arc->cosine;
    double integral = first ? s[1] - s[0] : arc->angle, scale = first ? arc->cosine : 1;
    /* cos^(k-1) of the next k, at both ends */
    double power[2] = {first ? c[0] * c[0] : c[0], first ? c[1] * c[1] : c[1]};
    *sum = 0;
    for (int k = first; k < last; k += 2) {
        *sum += integral * scale;
        integral = (power[1] * s[1] - power[0] * s[0]) / (k + 2) + (k + 1.) / (k + 2) * integral;
        scale *= square;
        for (int i = 0; i < 2; i++)
            power[i] *= c[i] * c[i];
    }
    *top = integral * scale;
}

/* The integral of (w.u)^k (n.u) over the light, divided by pi; k an integer above 0. */
static double area_moment(const AreaCase *c)
{
    const int k = (int)c->exponent;
    const AreaPolygon seen = area_seen(c), above = area_clip(&seen, c->normal),
                      left = area_clip(&above, c->w);
    double axial = k % 2 ? area_solid_angle(&left) : 0,
           /* k times the moment of order k - 1; the contribution of the arcs' normals */
        cosine = 0;
    for (int i = 0; i < left.count; i++) {
        AreaArc arc;
        double sum, top;
        if (!area_arc(left.corners[i], left.corners[(i + 1) % left.count], c->w, &arc))
            continue;
        area_powers(&arc, k % 2, k, &sum, &top);
        axial += arc.off * sum;
        cosine += area_dot(arc.m, c->normal) * top;
    }
    return left.count ? (area_dot(c->w, c->normal) * axial + cosine) / (k + 2) / AREA_PI : 0;
}

/* Lambert's formula: the integral of the cosine over the light, divided by pi. */
static double area_lambert(const AreaCase *c)
{
    const AreaPolygon seen = area_seen(c), above = area_clip(&seen, c->normal);
    double sum = 0;
    for (int i = 0; i < above.count; i++) {
        AreaArc arc;
        if (area_arc(above.corners[i], above.corners[(i + 1) % above.count], c->normal, &arc))
            sum += arc.angle * arc.off;
    }
    return sum / (2 * AREA_PI);
}

/* Weight of a point of the light: the solid angle per area, for the light's normal times an area
 * element. */
static double area_density(const AreaCase *c, const double p[3], const double face[3])
{
    const double square = area_dot(p, p), length = sqrt(square);
    const double cosine = fmax(area_dot(c->normal, p) / length, 0),
                 along = fmax(area_dot(c->w, p) / length, 0);
    return fabs(area_dot(face, p)) / (length * square) * cosine *
           (c->exponent > 0 ? pow(along, c->exponent) : 1);
}

/* Three-point quadrature of a triangle, exact for quadratic polynomials. */
static double area_rule(const AreaCase *c, const double t[3][3])
{
    double e[2][3], face[3], sum = 0;
    for (int i = 0; i < 3; i++) {
        e[0][i] = t[1][i] - t[0][i];
        e[1][i] = t[2][i] - t[0][i];
    }
    area_cross(e[0], e[1], face);
    for (int k = 0; k < 3; k++) {
        double p[3];
        for (int i = 0; i < 3; i++)
            p[i] = (t[0][i] + t[1][i] + t[2][i]) / 6 + t[k][i] / 2;
        sum += area_density(c, p, face) / 6;
    }
    return sum;
}

static double area_triangle(const AreaCase *c, const double t[3][3], double whole, int depth)
{
    double m[3][3], parts[4], sum = 0;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            m[k][i] = (t[k][i] + t[(k + 1) % 3][i]) / 2;
    const double quarters[4][3][3] = {
        {{t[0][0], t[0][1], t[0][2]}, {m[0][0], m[0][1], m[0][2]}, {m[2][0], m[2][1], m[2][2]}},
        {{t[1][0], t[1][1], t[1][2]}, {m[1][0], m[1][1], m[1][2]}, {m[0][0], m[0][1], m[0][2]}},
        {{t[2][0], t[2][1], t[2][2]}, {m[2][0], m[2][1], m[2][2]}, {m[1][0], m[1][1], m[1][2]}},
        {{m[0][0], m[0][1], m[0][2]}, {m[1][0], m[1][1], m[1][2]}, {m[2][0], m[2][1], m[2][2]}}};
    for (int k = 0; k < 4; k++)
        sum += parts[k] = area_rule(c, quarters[k]);
    if (depth >= 3 && (depth >= 12 || fabs(sum - whole) <= 1e-11 + 1e-6 * sum))
        return sum;
    sum = 0;
    for (int k = 0; k < 4; k++)
        sum += area_triangle(c, quarters[k], parts[k], depth + 1);
    return sum;
}

/* The integral of the lobe, divided by pi (exponent 0: of the cosine), by adaptive quadrature
 * over triangles of the light. */
static double area_integral(const AreaCase *c)
{
    const AreaPolygon seen = area_seen(c), above = area_clip(&seen, c->normal);
    const AreaPolygon left = c->exponent > 0 ? area_clip(&above, c->w) : above;
    double sum = 0;
    for (int i = 1; i + 1 < left.count; i++) {
        double t[3][3];
        memcpy(t[0], left.corners[0], sizeof t[0]);
        memcpy(t[1], left.corners[i], sizeof t[1]);
        memcpy(t[2], left.corners[i + 1], sizeof t[2]);
        sum += area_triangle(c, (const double(*)[3])t, area_rule(c, (const double(*)[3])t), 0);
    }
    return sum / AREA_PI;
}
#endif
