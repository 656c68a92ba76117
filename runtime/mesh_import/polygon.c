/* Ear clipping, after Meisters (1975): a corner whose triangle contains no other corner is cut off,
 * until three corners are left.
 *     an arrowhead 0 (0, 0)  1 (2, -1)  2 (1, 0)  3 (2, 1), concave at 2
 *     ear 1: 0 1 2; the rest is 0 2 3; a fan from 1 would cover the outside */
#include "runtime/mesh_import/polygon.h"
#include "compiler/base/memory.h"
#include <math.h>
#include <stdlib.h>

void polygon_reserve(Polygon *p, size_t count)
{
    if (count <= p->capacity)
        return;
    p->capacity = count * 2;
    p->points = memory_checked(realloc(p->points, p->capacity * sizeof *p->points));
    p->flat = memory_checked(realloc(p->flat, p->capacity * sizeof *p->flat));
    p->next = memory_checked(realloc(p->next, p->capacity * sizeof *p->next));
    p->previous = memory_checked(realloc(p->previous, p->capacity * sizeof *p->previous));
    p->triangles = memory_checked(realloc(p->triangles, p->capacity * 3 * sizeof *p->triangles));
}

void polygon_free(Polygon *p)
{
    free(p->points);
    free(p->flat);
    free(p->next);
    free(p->previous);
    free(p->triangles);
    *p = (Polygon){0};
}

void polygon_area(const Polygon *p, int count, double area[3])
{
    area[0] = area[1] = area[2] = 0;
    const float *origin = p->points[0];
    for (int i = 1; i + 1 < count; i++)
        for (int k = 0; k < 3; k++) {
            const int a = (k + 1) % 3, b = (k + 2) % 3;
            area[k] +=
                ((double)p->points[i][a] - origin[a]) * ((double)p->points[i + 1][b] - origin[b]) -
                ((double)p->points[i][b] - origin[b]) * ((double)p->points[i + 1][a] - origin[a]);
        }
}

/* Projects the corners along the largest axis of the area, counterclockwise. Returns false if the
 * polygon has no area. */
static bool flatten(Polygon *p, int count)
{
    double area[3];
    polygon_area(p, count, area);
    int axis = 0;
    for (int k = 1; k < 3; k++)
        axis = fabs(area[k]) > fabs(area[axis]) ? k : axis;
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int i = 0; i < count; i++) {
        p->flat[i][area[axis] < 0] = p->points[i][a];
        p->flat[i][!(area[axis] < 0)] = p->points[i][b];
    }
    return area[axis] != 0;
}

/* Twice the signed area of a triangle in the plane; positive: counterclockwise. */
static double turn(const Polygon *p, int a, int b, int c)
{
    const double *o = p->flat[a], *s = p->flat[b], *t = p->flat[c];
    return (s[0] - o[0]) * (t[1] - o[1]) - (s[1] - o[1]) * (t[0] - o[0]);
}

/* A polygon that turns left everywhere and goes around once is convex: its x then changes
 * direction twice. */
static bool is_convex(const Polygon *p, int count)
{
    int changes = 0;
    double last = 0, first = 0;
    for (int i = 0; i < count; i++) {
        const int j = (i + 1) % count, k = (i + 2) % count;
        if (turn(p, i, j, k) < 0)
            return false;
        const double step = p->flat[j][0] - p->flat[i][0];
        changes += step * last < 0;
        first = first != 0 ? first : step;
        last = step != 0 ? step : last;
    }
    return changes + (first * last < 0) <= 2;
}

static bool are_same(const Polygon *p, int a, int b)
{
    return p->flat[a][0] == p->flat[b][0] && p->flat[a][1] == p->flat[b][1];
}

/* Returns true if the triangle at corner b contains none of the other corners. */
static bool is_ear(Polygon *p, int b)
{
    const int a = p->previous[b], c = p->next[b];
    p->tests++;
    if (!(turn(p, a, b, c) > 0))
        return false;
    for (int i = p->next[c]; i != a; i = p->next[i], p->tests++) {
        if (are_same(p, i, a) || are_same(p, i, b) || are_same(p, i, c))
            continue;
        if (turn(p, a, b, i) >= 0 && turn(p, b, c, i) >= 0 && turn(p, c, a, i) >= 0)
            return false;
    }
    return true;
}

static void put(Polygon *p, int triangle, int a, int b, int c)
{
    int *to = p->triangles + 3 * (size_t)triangle;
    to[0] = a, to[1] = b, to[2] = c;
}

/* Cuts one corner after the other. Without an ear, as in a polygon that crosses itself, any corner
 * is cut. */
static bool clip(Polygon *p, int count)
{
    for (int i = 0; i < count; i++) {
        p->next[i] = (i + 1) % count;
        p->previous[i] = (i + count - 1) % count;
    }
    for (int left = count, at = 0, tried = 0, made = 0; left > 2;) {
        if (p->tests > POLYGON_TESTS)
            return false;
        if (left > 3 && tried < left && !is_ear(p, at)) {
            at = p->next[at];
            tried++;
            continue;
        }
        const int a = p->previous[at], c = p->next[at];
        put(p, made++, a, at, c);
        p->next[a] = c;
        p->previous[c] = a;
        at = c, tried = 0, left--;
    }
    return true;
}

bool polygon_split(Polygon *p, int count)
{
    if (count > 3 && flatten(p, count) && !is_convex(p, count))
        return clip(p, count);
    for (int i = 0; i + 2 < count; i++)
        put(p, i, 0, i + 1, i + 2);
    return true;
}
