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
    float input[POINT_VARYINGS][3]; /* by Input */
} Point;

enum { GRID_WIDTH = 32, GRID_HEIGHT = 20, POINT_COUNT = GRID_WIDTH * GRID_HEIGHT };

/* Quasi-random ones in [-2, 2], large ones to 1e6, borders of cells with their neighbours, zeros,
 * tiny ones; normals and tangents of any length, some of them zero. Always the same. */
void points_make(Point points[POINT_COUNT]);
/* Others of the same kinds; of seed 0 those. */
void points_make_others(Point points[POINT_COUNT], int seed);
/* Some position or coordinate is farther from 0. */
bool point_is_far(const Point *point, float distance);

/* u v  x y z  px py pz. */
void point_describe(const Point *point, char *text, size_t capacity);

extern const double point_ior, point_viewer[4], point_time; /* of every point */
void point_surface(const Point *point, bool front, Surface *surface);
/* The normal's changes by u and by v there, where a test wants a surface that is curved. */
void point_bends(const Point *point, double by_u[3], double by_v[3]);
/* Derivatives of the tangents dP/du (0) and dP/dv (1), by u (0) and by v (1). */
void point_swings(const Point *point, double slopes[2][2][3]);

/* A coordinate is so large that floats cannot tell the parts of a pattern: of a shader it is only
 * asked to write numbers. */
bool point_is_extreme(const Point *point);

/* How far the coordinates of a point are moved to see what lies around it: by `relative` of their
 * size, by `least` if that is more. */
typedef struct {
    double relative, least;
} Reach;
extern const Reach reach_float; /* four ulp of a float, of 1 at least */
extern const Reach
    /* twelve: for simplex noise, whose grain is finer, and which is 0 right where checkers have
     * edges */
    reach_steep;
extern const Reach reach_double; /* for values that were computed in double precision */

/* The value of every slot, and between what it varies nearby: where a function jumps or is steep,
 * rounding alone leads from one to the other. */
typedef struct {
    SlotValues value, low, high;
} Hull;

/* Points of one side, and how far around each is looked. */
typedef struct {
    const Point *at;
    int count;
    bool front;
    const Reach *reach;
    bool bent; /* point_bends */
} PointSet;

/* A hull for every point. */
void points_hulls(Oracle *oracle, const Node *material, const PointSet *points, Hull *hulls);

/* Takes in what the material has at the points themselves once something else has moved: a uniform,
 * a picture. */
void points_widen(Oracle *oracle, const Node *material, const PointSet *points, Hull *hulls);

/* How far a number lies outside of the hull of a component, in units of max(1, |value|). The hull
 * is a sample of the neighbourhood: it is taken to be wider by its own width on both sides. */
double hull_miss(const Hull *hull, Slot slot, int component, double number);
#endif
