/* Points, and hulls of the oracle's values around them. */
#include "points.h"
#include <stdio.h>
#include <string.h>

const double point_ior = 1.25, point_viewer[4] = {0.8, -1.9, 3.4, 1}, point_time = 2.75;
const Reach reach_float = {4. / (1 << 23), 4. / (1 << 23)};
const Reach reach_steep = {12. / (1 << 23), 12. / (1 << 23)};
const Reach reach_double = {1e-13, 1e-13};

/* A low-discrepancy sequence in [0, 1) for each dimension: multiples of an irrational number. */
typedef struct {
    int index;
} Spread;

static double spread(const Spread *s, int dimension)
{
    static const double root[] = {
        0.41421356237309505, 0.7320508075688772, 0.2360679774997898, 0.6457513110645907,
        0.3166247903554,     0.605551275463989,  0.1231056256176605, 0.358898943540674,
        0.795831523312719,   0.385164807134504,  0.567764362830022,  0.08276253029821967,
        0.4031242374328485,  0.5574385243020004, 0.8556546004010439, 0.2801098892805187};
    return fraction((s->index + 1) * root[dimension]);
}

static void random_direction(float v[3], const Spread *s, int dimension, float length)
{
    double z = 2 * spread(s, dimension) - 1, angle = 2 * M_PI * spread(s, dimension + 1),
           r = sqrt(1 - z * z);
    v[0] = (float)(length * r * cos(angle));
    v[1] = (float)(length * r * sin(angle));
    v[2] = (float)(length * z);
}

enum {
    DIMENSION_U = 0,
    DIMENSION_X = 2,
    DIMENSION_P = 5,
    DIMENSION_N = 8,
    DIMENSION_DU = 10,
    DIMENSION_DV = 13
};

/* A point in [-size, size] with a normal, and tangents at any angle to the normal, of any
 * length. */
static Point random_point(int index, double size)
{
    static const float lengths[] = {1, 1, 1, 0.25f, 7};
    Spread s = {index};
    Point p;
    memset(&p, 0, sizeof p);
    for (int i = 0; i < 3; i++) {
        if (i < 2)
            p.input[INPUT_U][i] = (float)(size * (2 * spread(&s, DIMENSION_U + i) - 1));
        p.input[INPUT_X][i] = (float)(size * (2 * spread(&s, DIMENSION_X + i) - 1));
        p.input[INPUT_P][i] = (float)(size * (2 * spread(&s, DIMENSION_P + i) - 1));
        p.input[INPUT_DU][i] = (float)(4 * spread(&s, DIMENSION_DU + i) - 2);
        p.input[INPUT_DV][i] = (float)(4 * spread(&s, DIMENSION_DV + i) - 2);
        p.input[INPUT_XU][i] = (float)(3 * spread(&s, DIMENSION_DV + 2 - i) - 1);
        p.input[INPUT_XV][i] = (float)(3 * spread(&s, DIMENSION_DU + 2 - i) - 2);
    }
    random_direction(p.input[INPUT_N], &s, DIMENSION_N, lengths[index % 5]);
    random_direction(p.input[INPUT_ray], &s, DIMENSION_DU, 1);
    memcpy(p.input[INPUT_eyeN], p.input[INPUT_N], sizeof p.input[INPUT_N]);
    return p;
}

/* Sets all coordinates of one axis: u, x and px, or v, y and py, or z and pz. */
static void set_axis(Point *p, int axis, float value)
{
    if (axis < 2)
        p->input[INPUT_U][axis] = value;
    p->input[INPUT_X][axis] = p->input[INPUT_P][axis] = value;
}

static void set_all(Point *p, float value)
{
    for (int axis = 0; axis < 3; axis++)
        set_axis(p, axis, value);
}

typedef struct {
    Point *at;
    int count, first; /* number of points; index in the sequence */
} Points;

static Point *add(Points *points, double size)
{
    if (points->count == POINT_COUNT)
        return &points->at[POINT_COUNT - 1];
    points->at[points->count] = random_point(points->first + points->count, size);
    return &points->at[points->count++];
}

/* A border value or an adjacent float. */
static float beside(float border, int side)
{
    return side < 0   ? nextafterf(border, -INFINITY)
           : side > 0 ? nextafterf(border, INFINITY)
                      : border;
}

static void add_borders(Points *points)
{
    static const float borders[] = {-2, -1.5f, -1, -0.5f, 0.25f, 0.5f, 1, 1.5f, 3, 1.f / 3};
    for (int i = 0; i < (int)(sizeof borders / sizeof *borders); i++)
        for (int side = -1; side <= 1; side++) {
            for (int axis = 0; axis < 3; axis++)
                set_axis(add(points, 2), axis, beside(borders[i], side));
            set_all(add(points, 2), beside(borders[i], side));
        }
}

static void add_specials(Points *points)
{
    static const float special[] = {
        0,    -0.f,      1e-8f, -1e-8f, 1e-30f,     -1e-30f,    65535,  65536,  -65536,
        1e6f, -1e6f,     1e5f,  1e3f,   123456.78f, -98765.43f, 1e-4f,  2e-4f,  -3e-4f,
        0.1f, 16777216., -1e9f, 1e12f,  -1e18f,     1e30f,      -1e30f, 1e-38f, -1e-40f};
    for (int i = 0; i < (int)(sizeof special / sizeof *special); i++) {
        set_axis(add(points, 2), i % 3, special[i]);
        set_all(add(points, 2), special[i]);
    }
    memset(add(points, 2)->input[INPUT_N], 0, sizeof points->at->input[INPUT_N]);
    memset(add(points, 2)->input[INPUT_DU], 0, sizeof points->at->input[INPUT_DU]);
    memset(add(points, 2)->input[INPUT_DV], 0, sizeof points->at->input[INPUT_DV]);
}

bool point_is_far(const Point *point, float distance)
{
    bool is = false;
    for (int i = 0; i < 3; i++)
        is |= fabsf(point->input[INPUT_X][i]) > distance ||
              fabsf(point->input[INPUT_P][i]) > distance ||
              fabsf(point->input[INPUT_U][i]) > distance;
    return is;
}

void points_make_others(Point points[POINT_COUNT], int seed)
{
    Points made = {points, 0, seed * POINT_COUNT};
    add_borders(&made);
    add_specials(&made);
    for (int i = 0; i < 60; i++)
        add(&made, (double[]){1e3, 1e5, 1e6}[i % 3]);
    for (int i = 0; i < 60; i++)
        add(&made, (double[]){0.1, 10, 40}[i % 3]);
    while (made.count < POINT_COUNT)
        add(&made, 2);
    /* the normal is equal in eye and world space: eyeFromWorld is the identity */
    for (int i = 0; i < POINT_COUNT; i++)
        memcpy(points[i].input[INPUT_eyeN], points[i].input[INPUT_N],
               sizeof points[i].input[INPUT_N]);
}

void points_make(Point points[POINT_COUNT]) { points_make_others(points, 0); }

void point_surface(const Point *point, bool front, Surface *surface)
{
    static const Input input[] = {[GROUP_P] = INPUT_P,   [GROUP_N] = INPUT_N, [GROUP_DU] = INPUT_DU,
                                  [GROUP_DV] = INPUT_DV, [GROUP_U] = INPUT_U, [GROUP_X] = INPUT_X};
    *surface = (Surface){.front = front};
    for (Group group = 0; group < GROUP_R; group++)
        for (int component = 0; component < type_table[input_table[input[group]].type].components;
             component++)
            surface->root[channel_id(group, component)] = point->input[input[group]][component];
    surface->root[channel_id(GROUP_IOR, 0)] = point_ior;
    surface->root[channel_id(GROUP_T, 0)] = point_time;
    memcpy(&surface->root[channel_id(GROUP_E, 0)], point_viewer, sizeof point_viewer);
    for (int component = 0; component < 3; component++) {
        surface->local_u[component] = point->input[INPUT_XU][component];
        surface->local_v[component] = point->input[INPUT_XV][component];
    }
}

void point_bends(const Point *point, double by_u[3], double by_v[3])
{
    for (int component = 0; component < 3; component++) {
        by_u[component] = 0.75 * point->input[INPUT_XV][component];
        by_v[component] = -0.5 * point->input[INPUT_XU][(component + 1) % 3];
    }
}

void point_swings(const Point *point, double slopes[2][2][3])
{
    for (int i = 0; i < 12; i++)
        slopes[i / 6][i / 3 % 2][i % 3] =
            0.3 * point->input[i / 3 % 2 ? INPUT_XU : INPUT_XV][(i + i / 6) % 3] -
            0.2 * point->input[INPUT_N][i % 3];
}

static void surface_of(const PointSet *points, int i, Surface *surface)
{
    point_surface(&points->at[i], points->front, surface);
    if (points->bent)
        point_bends(&points->at[i], surface->normal_u, surface->normal_v);
    if (points->bent)
        point_swings(&points->at[i], surface->tangent_slopes);
}

enum { AXES = 8, FRAME_COMPONENTS = 3 * COMPONENTS_OF_GROUP, CORNERS = 16, MANY_CORNERS = 96 };

/* Signs of a corner, from rows of a Hadamard matrix: any two of the eight axes occur in all four
 * combinations of signs. */
static double corner_sign(int corner, int axis)
{
    return __builtin_parity((unsigned)(corner & (axis + 1))) ? -1 : 1;
}

static void shift(double *number, double part, const Reach *reach, double least)
{
    *number += part * fmax(reach->relative * fabs(*number), least);
}

/* Moves coordinates to the corners of boxes whose sizes are incommensurable with patterns'
 * periods; normal and tangents move by rounding errors only: a zero vector stays zero. */
static void move(Surface *surface, int corner, const Reach *reach)
{
    static const int axes[AXES] = {
        COMPONENTS_OF_GROUP * GROUP_U,     COMPONENTS_OF_GROUP * GROUP_U + 1,
        COMPONENTS_OF_GROUP * GROUP_X,     COMPONENTS_OF_GROUP * GROUP_X + 1,
        COMPONENTS_OF_GROUP * GROUP_X + 2, COMPONENTS_OF_GROUP * GROUP_P,
        COMPONENTS_OF_GROUP * GROUP_P + 1, COMPONENTS_OF_GROUP * GROUP_P + 2};
    double part = 1 - fraction(corner * 0.61803398874989485);
    for (int i = 0; i < AXES; i++)
        shift(&surface->root[axes[i]], part * corner_sign(corner, i), reach, reach->least);
    for (int i = 0; i < FRAME_COMPONENTS; i++)
        shift(&surface->root[channel_id(GROUP_N, i)], part * corner_sign(corner, i + 2), reach, 0);
}

/* Number of corners: more where adjacent floats are so far apart that a pattern may vary between
 * them. */
static int corner_count(const Surface *surface)
{
    const double far = 1000;
    for (Group group = GROUP_P; group <= GROUP_X; group++)
        for (int component = 0; component < 3; component++)
            if (fabs(surface->root[channel_id(group, component)]) > far)
                return MANY_CORNERS;
    return CORNERS;
}

static void widen(Hull *hull, const SlotValues *values)
{
    const double *v = &values->component[0][0];
    double *low = &hull->low.component[0][0], *high = &hull->high.component[0][0];
    for (int i = 0; i < SLOT_COUNT * 4; i++) {
        low[i] = fmin(low[i], v[i]);
        high[i] = fmax(high[i], v[i]);
    }
}

/* Flushes denormal numbers to 0, as drivers may. */
static void flush(Surface *surface)
{
    for (int i = 0; i < CHANNEL_ID_COUNT; i++)
        if (fabs(surface->root[i]) < WAVE_LEAST)
            surface->root[i] = 0;
}

static void meet(Oracle *oracle, const Node *material, const Surface *surface, Hull *hull)
{
    SlotValues values;
    oracle_material(oracle, material, surface, &values);
    widen(hull, &values);
}

/* At a crease the slopes of both sides are correct: adds both to the hull. */
static void meet_sides(Oracle *oracle, const Node *material, const Surface *surface, Hull *hull)
{
    oracle_slope_span(oracle, -1, 0);
    meet(oracle, material, surface, hull);
    oracle_slope_span(oracle, 0, 1);
    meet(oracle, material, surface, hull);
    oracle_slope_span(oracle, -1, 1);
}

void points_hulls(Oracle *oracle, const Node *material, const PointSet *points, Hull *hulls)
{
    for (int i = 0; i < points->count; i++) {
        Surface here;
        surface_of(points, i, &here);
        oracle_material(oracle, material, &here, &hulls[i].value);
        hulls[i].low = hulls[i].high = hulls[i].value;
        int corners = corner_count(&here);
        for (int corner = 0; corner < corners; corner++) {
            Surface there = here;
            move(&there, corner, points->reach);
            meet(oracle, material, &there, &hulls[i]);
        }
        flush(&here);
        meet(oracle, material, &here, &hulls[i]);
        meet_sides(oracle, material, &here, &hulls[i]);
    }
}

void points_widen(Oracle *oracle, const Node *material, const PointSet *points, Hull *hulls)
{
    for (int i = 0; i < points->count; i++) {
        Surface here;
        surface_of(points, i, &here);
        meet(oracle, material, &here, &hulls[i]);
    }
}

bool point_is_extreme(const Point *point)
{
    const float limit = 1 << 22;
    const Input inputs[] = {INPUT_U, INPUT_X, INPUT_P};
    for (int i = 0; i < 3; i++)
        for (int component = 0; component < 3; component++)
            if (fabsf(point->input[inputs[i]][component]) >= limit)
                return true;
    return false;
}

void point_describe(const Point *p, char *text, size_t capacity)
{
    const float(*i)[3] = p->input;
    snprintf(text, capacity, "%.9g %.9g  %.9g %.9g %.9g  %.9g %.9g %.9g", i[INPUT_U][0],
             i[INPUT_U][1], i[INPUT_X][0], i[INPUT_X][1], i[INPUT_X][2], i[INPUT_P][0],
             i[INPUT_P][1], i[INPUT_P][2]);
}

double hull_miss(const Hull *hull, Slot slot, int component, double number)
{
    double value = hull->value.component[slot][component],
           low = hull->low.component[slot][component], high = hull->high.component[slot][component];
    double width = high - low, scale = fmax(1, fabs(value));
    if (!isfinite(number))
        return INFINITY;
    return fmax(0, fmax(low - width - number, number - high - width)) / scale;
}
