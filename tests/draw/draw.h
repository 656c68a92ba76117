/* Draws emitted fragment programs at given points: one fragment per point, its inputs the exact
 * floats of the point. */
#ifndef MATC_VALUE_DRAW_H
#define MATC_VALUE_DRAW_H
#include "compiler/graph/graph.h"
#include "compiler/matc.h"
#include "tests/value/points.h"
#include "runtime/gpu_material/field.h"
#include "runtime/gl/framebuffer.h"

/* A context with a set of points, and one target pixel per point. */
typedef struct {
    GlContext *gl;
    Store *store;
    bool core;
    int count; /* number of points */
    int width; /* width of the grid of points */
    Framebuffer target;
    /* points seen from the front; triangles around the same pixel centers, seen from behind */
    Field points, triangles;
    char error[4096];
} Drawer;

/* Opens with the first `count` of the points, in rows of GRID_WIDTH, or in a square if there are
 * more than POINT_COUNT; the color target is RGBA32F. Returns false with a message in `error`. */
bool drawer_open(Drawer *d, bool core, const Point *points, int count);
/* Opens with several targets of RGBA16F. */
bool drawer_open_half(Drawer *d, bool core, const Point *points, int count, int targets);
void drawer_close(Drawer *d);

/* A fragment program and its inputs. */
typedef struct {
    const char *fragment;
    const char *library; /* further GLSL to link, or NULL */
    Target target;
    MatcProgram *program; /* source of textures and uniforms, or NULL */
    const Graph *graph;   /* uniform values by name; NULL: their defaults */
} Shading;

/* Returns false with a message in `error`. Delete the material in any case. */
bool drawer_material(Drawer *d, const Shading *shading, Material *made);
/* Updates the uniforms after the graph's values changed. */
void drawer_set_uniforms(const Shading *shading, Material *material);
/* Draws all points: as points, whose front is seen, or as triangles seen from behind. Four
 * floats per point in rgba[target]. */
bool drawer_draw(Drawer *d, Material *material, bool front, float *const *rgba, int targets);
/* Draws into another framebuffer without reading it back. */
bool drawer_draw_to(Drawer *d, Material *material, bool front, const Framebuffer *target);
/* Draws one triangle over the whole target, seen from the front: attributes given at (-1, -1),
 * (3, -1) and (-1, 3) of clip space are linear over the pixels. Four floats per pixel of the
 * first target, from the lower left. */
bool drawer_fill(Drawer *d, Material *material, const Point corners[3], float *rgba);
#endif
