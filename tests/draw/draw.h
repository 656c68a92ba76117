/* Draws emitted fragment programs at given points: one fragment per point, its inputs the exact
 * floats of the point. */
#ifndef MATC_VALUE_DRAW_H
#define MATC_VALUE_DRAW_H
#include "compiler/graph/graph.h"
#include "compiler/matc.h"
#include "tests/value/points.h"
#include "runtime/gpu_material/field.h"
#include "runtime/gl/framebuffer.h"

/* A context with points in it, and a target for each of them. */
typedef struct {
    GlContext *gl;
    Store *store;
    bool core;
    int count; /* points */
    int width; /* of the grid of points */
    Framebuffer target;
    /* seen from the front; around the same pixels' middles, seen from behind */
    Field points, triangles;
    char error[4096];
} Drawer;

/* The first `count` of the points, in rows of GRID_WIDTH, or in a square when there are more than
 * POINT_COUNT; a colour target of RGBA32F. False: see error. */
bool drawer_open(Drawer *d, bool core, const Point *points, int count);
/* Opens with several targets, of RGBA16F. */
bool drawer_open_half(Drawer *d, bool core, const Point *points, int count, int targets);
void drawer_close(Drawer *d);

/* A fragment program and what it reads. */
typedef struct {
    const char *fragment;
    const char *library; /* more GLSL to be linked in, or NULL */
    Target target;
    MatcProgram *program; /* its textures and uniforms, or NULL */
    const Graph *graph;   /* the uniforms' values, by name; or NULL: their defaults */
} Shading;

/* False: see error. Delete it in any case. */
bool drawer_material(Drawer *d, const Shading *shading, Material *made);
/* Again, where the graph's values have changed. */
void drawer_set_uniforms(const Shading *shading, Material *material);
/* All points: as points, which are seen from the front, or as triangles that are seen from behind.
 * Four floats a point in rgba[target]. */
bool drawer_draw(Drawer *d, Material *material, bool front, float *const *rgba, int targets);
/* Draws into another framebuffer, which is not read. */
bool drawer_draw_to(Drawer *d, Material *material, bool front, const Framebuffer *target);
/* One triangle over all of the target, seen from the front: what its corners have at (-1, -1), (3,
 * -1) and (-1, 3) of clip space changes evenly from pixel to pixel. Four floats a pixel of the
 * first target, from the lower left. */
bool drawer_fill(Drawer *d, Material *material, const Point corners[3], float *rgba);
#endif
