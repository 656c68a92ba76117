/* A mesh that is refined by bisecting triangles, and has no T-junction after any step.
 * scene_bisection.c says why. */
#ifndef MATC_SCENE_BISECTION_H
#define MATC_SCENE_BISECTION_H
#include "runtime/gl/shape.h"
#include <stddef.h>

enum {
    /* of an edge of the shape: weights of a point within one of its triangles sum up to so many */
    SCENE_BISECTION_PARTS = 1 << 20,
    /* every second bisection halves edges: none is divided into more parts than that */
    SCENE_BISECTION_DEPTH = 38
};

/* Corners turn as those of the shape's triangle. Edge i goes from corner i to the next one; edge 0
 * is bisected next, and corner 2 is the newest. */
typedef struct {
    int base;           /* of the shape's triangles: the one that it lies in */
    int weights[3][3];  /* by corner: of the base's corners */
    uint32_t vertex[3]; /* by corner: in SceneBisection.vertices */
    /* by edge: 3 triangle + edge of another one of the same two places; all of them are in a ring,
     * one alone its own */
    uint32_t across[3];
    uint32_t behind[3]; /* the ring backwards */
    int depth;          /* so many bisections of the base have led to it */
} SceneBisectionTriangle;

/* Data shared by vertices at one position: the first one's displacement moves it, along the unit
 * sum of their normals. */
typedef struct {
    uint32_t first;
    float normal[3];
} SceneBisectionPlace;

typedef struct SceneBisection {
    const Shape *shape;
    SceneBisectionTriangle *triangles;
    ShapeVertex *vertices;
    uint32_t *place_of; /* by vertex */
    SceneBisectionPlace *places;
    /* room for edges that are divided together, and for triangles that wait for others */
    uint32_t *ring, *waiting;
    size_t count, room, vertex_count, vertex_room, place_of_room, place_count, place_room,
        ring_room, waiting_room;
    /* is told of each triangle that became two; or NULL */
    void (*divided)(void *user, uint32_t triangle, uint32_t made);
    void *user;
} SceneBisection;

/* The first triangles are the shape's; those with two corners in one place are left out. The shape
 * is kept. False: memory ran out; *made is empty. */
bool scene_bisection_begin(const Shape *shape, SceneBisection *made);
/* Divides a triangle, and what else has to be so that the whole conforms. False: memory ran out;
 * what there is conforms, and is to be ended. */
bool scene_bisection_split(SceneBisection *b, uint32_t triangle);
/* As a shape whose places were moved to `to`; neighbours stand near each other, for caches of
 * vertices. False: memory ran out; *made is empty. */
bool scene_bisection_shape(const SceneBisection *b, const double (*to)[3], Shape *made);
/* Twice the area of a triangle within its base, in parts squared; its sign tells how it turns. */
double scene_bisection_turn(const int a[3], const int b[3], const int c[3]);
/* Area of the triangle in the shape. */
double scene_bisection_area(const SceneBisection *b, uint32_t triangle);
/* Safe on an empty one. */
void scene_bisection_end(SceneBisection *b);
#endif
