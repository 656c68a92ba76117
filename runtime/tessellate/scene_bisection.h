/* A mesh that is refined by bisecting triangles, and has no T-junction after any step.
 * scene_bisection.c explains why. */
#ifndef MATC_SCENE_BISECTION_H
#define MATC_SCENE_BISECTION_H
#include "runtime/gl/shape.h"
#include <stddef.h>

enum {
    /* Sum of the barycentric weights of a point in one of the shape's triangles. */
    SCENE_BISECTION_PARTS = 1 << 20,
    /* every second bisection halves edges, so no edge gets more than SCENE_BISECTION_PARTS parts */
    SCENE_BISECTION_DEPTH = 38
};

/* A triangle with the winding of the shape's triangle. Edge i goes from corner i to the next
 * one; edge 0 is bisected next, and corner 2 is the newest. */
typedef struct {
    int base;           /* the shape's triangle that contains this one */
    int weights[3][3];  /* indexed by corner: barycentric weights of the base's corners */
    uint32_t vertex[3]; /* indexed by corner: index in SceneBisection.vertices */
    /* Ring of each edge: 3 triangle + edge of the next half-edge between the same two places; a
     * boundary edge refers to itself. */
    uint32_t across[3];
    uint32_t behind[3]; /* the ring in reverse */
    int depth;          /* number of bisections since the base */
} SceneBisectionTriangle;

/* Data shared by vertices at one position: the displacement of the first vertex moves them,
 * along the normalized sum of their normals. */
typedef struct {
    uint32_t first;
    float normal[3];
} SceneBisectionPlace;

typedef struct SceneBisection {
    const Shape *shape;
    SceneBisectionTriangle *triangles;
    ShapeVertex *vertices;
    uint32_t *place_of; /* indexed by vertex: index of its place */
    SceneBisectionPlace *places;
    /* scratch: edges that are divided together, and triangles that wait for others */
    uint32_t *ring, *waiting;
    size_t count, capacity, vertex_count, vertex_capacity, place_of_capacity, place_count,
        place_capacity, ring_capacity, waiting_capacity;
    /* Called for each triangle that was bisected; NULL: no calls. */
    void (*divided)(void *user, uint32_t triangle, uint32_t made);
    void *user;
} SceneBisection;

/* Begins with the shape's triangles, without degenerate ones. The shape is borrowed. False: out
 * of memory; *made is empty. */
bool scene_bisection_begin(const Shape *shape, SceneBisection *made);
/* Divides a triangle, and others as needed to keep the mesh conforming. False: out of memory;
 * the mesh is conforming, and must be ended. */
bool scene_bisection_split(SceneBisection *b, uint32_t triangle);
/* Converts to a shape whose places were moved to `to`; nearby triangles are adjacent in memory,
 * for vertex caches. False: out of memory; *made is empty. */
bool scene_bisection_shape(const SceneBisection *b, const double (*to)[3], Shape *made);
/* Returns twice the signed area of a triangle within its base, in parts squared; the sign is the
 * winding. */
double scene_bisection_turn(const int a[3], const int b[3], const int c[3]);
/* Returns the area of the triangle in object space. */
double scene_bisection_area(const SceneBisection *b, uint32_t triangle);
/* Frees all memory; also valid for a zeroed struct. */
void scene_bisection_end(SceneBisection *b);
#endif
