/* Vertices with all inputs that a fragment program may read, so that any program can be drawn:
 * points, one fragment each, whose inputs are exactly the given floats; or triangles, over which
 * the inputs are interpolated. */
#ifndef MATC_GPU_MATERIAL_FIELD_H
#define MATC_GPU_MATERIAL_FIELD_H
#include "grammar/tables.h"
#include "runtime/gpu_material/material.h"

enum { FIELD_VARYINGS = INPUT_front }; /* inputs.def lists the varyings first */
_Static_assert(INPUT_P == 0 && INPUT_XV == FIELD_VARYINGS - 1, "the varyings come first");

typedef struct {
    float at[4];                    /* position in clip space */
    float input[FIELD_VARYINGS][3]; /* values of the varyings, indexed by Input */
} FieldVertex;

typedef struct {
    GLuint array, buffer;
    GLenum mode; /* primitive: GL_POINTS, GL_TRIANGLES or GL_TRIANGLE_STRIP */
    int count;   /* number of vertices */
} Field;

/* Uploads vertices. Call field_delete() even after a failure. */
bool field_make(GlContext *gl, const FieldVertex *vertices, int count, GLenum mode, Field *made);
void field_draw(const GlContext *gl, const Field *field);
void field_delete(const GlContext *gl, Field *field);

typedef struct {
    Target target;        /* GLSL version of the texts */
    const char *fragment; /* fragment program; NULL: the one of `program` */
    const char *library;  /* GLSL to link in addition; NULL: none */
} FieldText;

enum { FIELD_DEFAULT_CAPACITY = 128 };
/* Writes the default of a named attribute as GLSL, such as vec2(0.5, 1). */
void field_default(const MatcAttribute *attribute, char text[FIELD_DEFAULT_CAPACITY]);

/* Makes a material whose vertex program passes the vertices' inputs on; its uniform vec2
 * field_jitter shifts the picture in clip space. Otherwise as material_make(). */
bool field_material(Store *store, MatcProgram *program, const FieldText *text, Material *made);
#endif
