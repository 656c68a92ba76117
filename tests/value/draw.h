/* Draws emitted fragment programs at given points: one fragment a point, its inputs the very floats of the point. */
#ifndef MATC_VALUE_DRAW_H
#define MATC_VALUE_DRAW_H
#include "compiler/front/graph.h"
#include "compiler/matc.h"
#include "points.h"
#include "runtime/gl/context.h"
#include "runtime/gl/framebuffer.h"

/* A context with points in it, and a target for each of them. */
typedef struct {
    GlContext *gl;
    bool core;
    int count; /* points */
    int width; /* of the grid of points */
    Framebuffer target;
    GLuint array, buffer;
    void (*bind_buffer_base)(GLenum target, GLuint index, GLuint buffer);
    GLuint (*block_index)(GLuint program, const char *name);
    void (*uniform_indices)(GLuint program, GLsizei count, const GLchar *const *names, GLuint *indices);
    void (*uniform_values)(GLuint program, GLsizei count, const GLuint *indices, GLenum what, GLint *values);
    char error[4096];
} Drawer;

/* The first `count` of the points, in rows of GRID_WIDTH, or in a square when there are more than POINT_COUNT. `format` is that of `targets` colour targets. False: see error. */
bool drawer_open(Drawer *d, bool core, const Point *points, int count, int targets, GLenum format);
void drawer_close(Drawer *d);

/* A fragment program and what it reads. */
typedef struct {
    const char *fragment;
    const char *library; /* more GLSL to be linked in, or NULL */
    Target target;
    MatcProgram *program; /* its textures and uniforms, or NULL */
    const Graph *graph;   /* the uniforms' values, by name */
} Shading;

/* The program; 0: see error. Delete with gl->DeleteProgram. */
GLuint drawer_program(Drawer *d, const Shading *shading);
/* All points: as points, which are seen from the front, or as triangles that are seen from behind. Its textures and uniforms
 * are set. Four floats a point in rgba[target]. */
bool drawer_draw(Drawer *d, GLuint program, const Shading *shading, bool front, float *const *rgba, int targets);
/* The same into another framebuffer, which is not read. */
bool drawer_draw_to(Drawer *d, GLuint program, const Shading *shading, bool front, const Framebuffer *target);
/* One triangle over all of the target, seen from the front: what its corners have at (-1, -1), (3, -1) and (-1, 3) of clip space
 * changes evenly from pixel to pixel. Four floats a pixel of the first target, from the lower left. */
bool drawer_fill(Drawer *d, GLuint program, const Shading *shading, const Point corners[3], float *rgba);
#endif
