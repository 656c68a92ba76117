/* The ball's curvature is 1 all over; the torus' is 1 / r around the tube and cos b / (R + r cos
 * b) around the axis. */
#include "tests/draw/curved.h"
#include "tests/vectors.h"
#include <math.h>
#include <string.h>

static const double ring = 1, tube = 0.5, twist = 2;

static void set(Surface *surface, Group group, const double v[3])
{
    memcpy(&surface->root[channel_id(group, 0)], v, 3 * sizeof *v);
}

/* A point of the base: its position, normal, unit directions of principal curvature, and the
 * curvatures. */
typedef struct {
    double at[3], n[3], along[2][3], bends[2];
} Base;

static Base base_at(CurvedBody body, double a, double b)
{
    const double ca = cos(a), sa = sin(a), cb = cos(b), sb = sin(b);
    Base base = {.n = {cb * ca, cb * sa, sb},
                 .along = {{-sa, ca, 0}, {-sb * ca, -sb * sa, cb}},
                 .bends = {1, 1}};
    for (int i = 0; i < 3; i++)
        base.at[i] = body != CURVED_torus ? base.n[i]
                                          : tube * base.n[i] + (i == 0   ? ring * ca
                                                                : i == 1 ? ring * sa
                                                                         : 0);
    if (body == CURVED_torus) {
        base.bends[0] = cb / (ring + tube * cb);
        base.bends[1] = 1 / tube;
    }
    return base;
}

static Base base_near(CurvedBody body, const double place[3])
{
    const double across = hypot(place[0], place[1]) - (body == CURVED_torus ? ring : 0);
    return base_at(body, atan2(place[1], place[0]), atan2(place[2], across));
}

/* Second derivatives of ((R + r cos b) cos a, (R + r cos b) sin a, r sin b), a = 2 pi u and b =
 * 2 pi v; for a ball b advances half as fast. */
static void set_turns(CurvedBody body, double a, double b, double slopes[2][2][3])
{
    const bool ball = body != CURVED_torus;
    const double big = ball ? 0 : ring, small = ball ? 1 : tube, by_u = 2 * M_PI,
                 by_v = ball ? M_PI : 2 * M_PI, out = big + small * cos(b);
    const double uu[3] = {-out * cos(a), -out * sin(a), 0},
                 uv[3] = {small * sin(b) * sin(a), -small * sin(b) * cos(a), 0},
                 vv[3] = {-small * cos(b) * cos(a), -small * cos(b) * sin(a), -small * sin(b)};
    for (int i = 0; i < 3; i++) {
        slopes[0][0][i] = by_u * by_u * uu[i];
        slopes[0][1][i] = slopes[1][0][i] = by_u * by_v * uv[i];
        slopes[1][1][i] = by_v * by_v * vv[i];
    }
}

/* With s = 2 pi u + twist v and t = v the ball's longitude and pole-to-pole parameter: d/dv =
 * twist / (2 pi) d/du + d/dv of the ball. A ball's normal is its position. */
static void twist_surface(Surface *surface, double tangent[2][3])
{
    const double k = twist / (2 * M_PI);
    double(*slopes)[2][3] = surface->tangent_slopes;
    for (int i = 0; i < 3; i++) {
        tangent[1][i] += k * tangent[0][i];
        surface->normal_v[i] = surface->local_v[i] = tangent[1][i];
        slopes[1][1][i] += 2 * k * slopes[0][1][i] + k * k * slopes[0][0][i];
        slopes[0][1][i] += k * slopes[0][0][i];
        slopes[1][0][i] = slopes[0][1][i];
    }
}

void curved_surface(CurvedBody body, double u, double v, Surface *surface)
{
    if (body == CURVED_twisted)
        u += twist * v / (2 * M_PI);
    const double turn = 2 * M_PI, by_v = body != CURVED_torus ? M_PI : turn;
    const Base base = base_at(body, turn * u, body != CURVED_torus ? by_v * (v - 0.5) : by_v * v);
    double tangent[2][3];
    const double length[2] = {turn * hypot(base.at[0], base.at[1]),
                              by_v * (body != CURVED_torus ? 1 : tube)};
    oracle_surface_default(surface);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++) {
            tangent[k][i] = length[k] * base.along[k][i];
            (k ? surface->normal_v : surface->normal_u)[i] = base.bends[k] * tangent[k][i];
            (k ? surface->local_v : surface->local_u)[i] = tangent[k][i];
        }
    set_turns(body, turn * u, body != CURVED_torus ? by_v * (v - 0.5) : by_v * v,
              surface->tangent_slopes);
    if (body == CURVED_twisted)
        twist_surface(surface, tangent);
    set(surface, GROUP_P, base.at);
    set(surface, GROUP_X, base.at);
    set(surface, GROUP_N, base.n);
    set(surface, GROUP_DU, tangent[0]);
    set(surface, GROUP_DV, tangent[1]);
    set(surface, GROUP_U, (double[3]){body == CURVED_twisted ? u - twist * v / turn : u, v, 0});
}

void curved_base(CurvedBody body, const double place[3], double normal[3])
{
    const Base base = base_near(body, place);
    memcpy(normal, base.n, sizeof base.n);
}

void curved_normal(CurvedBody body, double scale, const double place[3], bool stay,
                   double normal[3])
{
    const Base base = base_near(body, place);
    const double p = 3 * base.at[0] + 1, q = 2 * base.at[1] + base.at[2],
                 height = scale * sin(p) * cos(q);
    const double gradient[3] = {3 * scale * cos(p) * cos(q), -2 * scale * sin(p) * sin(q),
                                -scale * sin(p) * sin(q)};
    memcpy(normal, base.n, sizeof base.n);
    for (int k = 0; k < 2; k++) {
        const double leans = dot(gradient, base.along[k]) / (stay ? 1 : 1 + height * base.bends[k]);
        for (int i = 0; i < 3; i++)
            normal[i] -= leans * base.along[k][i];
    }
    const double size = sqrt(dot(normal, normal));
    for (int i = 0; i < 3; i++)
        normal[i] /= size;
}

/* The three components of the displacement vector, and their derivatives along a direction. */
static void vector_at(const double p[3], double scale, double components[3])
{
    components[0] = scale * sin(3 * p[0] + 1) * cos(2 * p[1] + p[2]);
    components[1] = scale * cos(2 * p[0] - p[2] + 1);
    components[2] = scale * sin(p[1] + 2 * p[2]);
}

static void vector_along(const double p[3], const double way[3], double scale, double components[3])
{
    const double first = 3 * p[0] + 1, second = 2 * p[1] + p[2];
    const double gradients[3][3] = {
        {3 * cos(first) * cos(second), -2 * sin(first) * sin(second), -sin(first) * sin(second)},
        {-2 * sin(2 * p[0] - p[2] + 1), 0, sin(2 * p[0] - p[2] + 1)},
        {0, cos(p[1] + 2 * p[2]), 2 * cos(p[1] + 2 * p[2])}};
    for (int i = 0; i < 3; i++)
        components[i] = scale * dot(gradients[i], way);
}

/* The twisted ball's point at (s, v), s = 2 pi u, displaced along its unit tangents and normal. */
static void moved_twisted(double s, double v, double scale, double at[3])
{
    const Base base = base_at(CURVED_twisted, s + twist * v, M_PI * (v - 0.5));
    double m[3], across[3];
    const double around = twist * hypot(base.at[0], base.at[1]), length = hypot(around, M_PI);
    vector_at(base.at, scale, m);
    for (int i = 0; i < 3; i++) {
        across[i] = (around * base.along[0][i] + M_PI * base.along[1][i]) / length;
        at[i] = base.at[i] + m[0] * base.along[0][i] + m[1] * across[i] + m[2] * base.n[i];
    }
}

static void twisted_normal(double scale, const double place[3], double normal[3])
{
    const double step = 1e-5, v = asin(place[2] / sqrt(dot(place, place))) / M_PI + 0.5,
                 s = atan2(place[1], place[0]) - twist * v;
    double ends[2][2][3], by[2][3];
    for (int i = 0; i < 2; i++) {
        moved_twisted(s + (i ? -step : step), v, scale, ends[0][i]);
        moved_twisted(s, v + (i ? -step : step), scale, ends[1][i]);
    }
    for (int i = 0; i < 6; i++)
        by[i / 3][i % 3] = ends[i / 3][0][i % 3] - ends[i / 3][1][i % 3];
    for (int i = 0; i < 3; i++)
        normal[i] =
            by[0][(i + 1) % 3] * by[1][(i + 2) % 3] - by[0][(i + 2) % 3] * by[1][(i + 1) % 3];
    const double size = sqrt(dot(normal, normal));
    for (int i = 0; i < 3; i++)
        normal[i] /= size;
}

void curved_vector_normal(CurvedBody body, double scale, const double place[3], double normal[3])
{
    if (body == CURVED_twisted) {
        twisted_normal(scale, place, normal);
        return;
    }
    const Base base = base_near(body, place);
    const double *n = base.n, *e = base.along[0], *f = base.along[1];
    const double cb = n[0] * e[1] - n[1] * e[0], sb = n[2];
    const double small = body != CURVED_torus ? 1 : tube,
                 out = (body != CURVED_torus ? 0 : ring) + small * cb;
    double m[3], way[3], a[3], b[3], by_a[3], by_b[3];
    vector_at(base.at, scale, m);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 3; i++)
            way[i] = k ? small * f[i] : out * e[i];
        vector_along(base.at, way, scale, k ? by_b : by_a);
    }
    for (int i = 0; i < 3; i++) {
        a[i] = (out + by_a[0] - m[1] * sb + m[2] * cb) * e[i] + (by_a[1] + m[0] * sb) * f[i] +
               (by_a[2] - m[0] * cb) * n[i];
        b[i] = by_b[0] * e[i] + (small + by_b[1] + m[2]) * f[i] + (by_b[2] - m[1]) * n[i];
    }
    for (int i = 0; i < 3; i++)
        normal[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    const double size = sqrt(dot(normal, normal));
    for (int i = 0; i < 3; i++)
        normal[i] /= size;
}

double curved_angle(const double a[3], const double b[3])
{
    const double cross[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                             a[0] * b[1] - a[1] * b[0]};
    return 180 / M_PI * atan2(sqrt(dot(cross, cross)), dot(a, b));
}
