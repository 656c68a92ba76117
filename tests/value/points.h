/* Surface points that tests shade, every number a float, and the oracle's values at them and in
 * their neighborhood. */
#ifndef MATC_VALUE_POINTS_H
#define MATC_VALUE_POINTS_H
#include "compiler/oracle/oracle.h"

enum { POINT_VARYINGS = INPUT_front }; /* inputs.def lists the varyings first */
_Static_assert(GROUP_DU == GROUP_N + 1 && GROUP_DV == GROUP_N + 2,
               "normal and tangents side by side");
_Static_assert(INPUT_P == 0 && INPUT_XV == POINT_VARYINGS - 1, "the varyings come first");

typedef struct {
    float input[POINT_VARYINGS][3]; /* indexed by Input */
} Point;

enum { GRID_WIDTH = 32, GRID_HEIGHT = 20, POINT_COUNT = GRID_WIDTH * GRID_HEIGHT };

/* Makes quasi-random points in [-2, 2], large ones to 1e6, borders of cells with adjacent
 * floats, zeros, tiny ones; normals and tangents of any length, some of them zero. Equal in
 * every run. */
void points_make(Point points[POINT_COUNT]);
/* Makes other points of the same kinds; seed 0 gives those of points_make. */
void points_make_others(Point points[POINT_COUNT], int seed);
/* True if some coordinate of the position or texture exceeds the distance. */
bool point_is_far(const Point *point, float distance);

/* Prints u v  x y z  px py pz. */
void point_describe(const Point *point, char *text, size_t capacity);

/* inputs that are equal for every point */
extern const double point_ior, point_viewer[4], point_time;
void point_surface(const Point *point, bool front, Surface *surface);
/* Derivatives of the normal by u and v, for tests of curved surfaces. */
void point_bends(const Point *point, double by_u[3], double by_v[3]);
/* Derivatives of the tangents dP/du (0) and dP/dv (1), by u (0) and by v (1). */
void point_swings(const Point *point, double slopes[2][2][3]);

/* True if a coordinate is so large that floats cannot resolve a pattern: a shader then only has
 * to write finite numbers. */
bool point_is_extreme(const Point *point);

/* Size of a point's neighborhood: its coordinates are moved by `relative` of their size, but by
 * at least `least`. */
typedef struct {
    double relative, least;
} Reach;
extern const Reach reach_float; /* four ulp of a float, relative to at least 1 */
extern const Reach
    /* twelve ulp: for simplex noise, whose grain is finer, and which is exactly 0 at edges of
     * checkers */
    reach_steep;
extern const Reach reach_double; /* for values that were computed in double precision */

/* The value of every slot, and its range in the neighborhood: where a function jumps or is
 * steep, rounding alone may reach any value in the range. */
typedef struct {
    SlotValues value, low, high;
} Hull;

/* Points on one side of the surface, and the size of their neighborhoods. */
typedef struct {
    const Point *at;
    int count;
    bool front;
    const Reach *reach;
    bool bent; /* with the derivatives of point_bends */
} PointSet;

/* Computes a hull for every point. */
void points_hulls(Oracle *oracle, const Node *material, const PointSet *points, Hull *hulls);

/* Extends the hulls by the material's values at the points themselves, after a uniform or a
 * picture has changed. */
void points_widen(Oracle *oracle, const Node *material, const PointSet *points, Hull *hulls);

/* Distance of a number from a component's hull, in units of max(1, |value|). The hull is only a
 * sample of the neighborhood, so it is widened by its own width on both sides. */
double hull_miss(const Hull *hull, Slot slot, int component, double number);
#endif
