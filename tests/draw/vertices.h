/* Vertices drawn as points, one per pixel, so that the outputs of a vertex program are read back
 * without interpolation. */
#ifndef MATC_VALUE_VERTICES_H
#define MATC_VALUE_VERTICES_H
#include "runtime/gl/mesh.h"
#include "scene.h"

enum { VERTICES = 64 };
typedef struct {
    ShapeVertex vertex[VERTICES]; /* attributes of any length and angle */
    Surface surface[VERTICES];    /* what they are in the world */
    int pixel[VERTICES];          /* where they are drawn in a picture */
    GLuint array, buffer;
} Vertices;

/* In [-2, 2), spread evenly. */
float spread(int index);
/* `side` is that of the picture in pixels, at least 64. The space's matrices can be inverted. */
void vertices_make(Vertices *vertices, const Space *space, int side);
/* To be drawn by a context. */
void vertices_upload(Vertices *vertices, const GlContext *gl);
void vertices_draw(const Vertices *vertices, const GlContext *gl);
void vertices_delete(Vertices *vertices, const GlContext *gl);
#endif
