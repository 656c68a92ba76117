/* Vertices drawn as points, one per pixel, so that the outputs of a vertex program are read back
 * without interpolation. */
#ifndef MATC_VALUE_VERTICES_H
#define MATC_VALUE_VERTICES_H
#include "runtime/gl/mesh.h"
#include "scene.h"

enum { VERTICES = 64 };
typedef struct {
    ShapeVertex vertex[VERTICES]; /* attributes of any length and angle */
    Surface surface[VERTICES];    /* expected world space values */
    int pixel[VERTICES];          /* pixels at which they are drawn */
    GLuint array, buffer;
} Vertices;

/* Evenly spread numbers in [-2, 2). */
float spread(int index);
/* `side` is the picture's width and height in pixels, at least 64. The matrices of the space
 * must be invertible. */
void vertices_make(Vertices *vertices, const Space *space, int side);
/* Uploads the vertices to a context. */
void vertices_upload(Vertices *vertices, const GlContext *gl);
void vertices_draw(const Vertices *vertices, const GlContext *gl);
void vertices_delete(Vertices *vertices, const GlContext *gl);
#endif
