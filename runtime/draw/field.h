/* Vertices that carry all that a fragment program may ask for, so that any can be drawn with them:
 * points, a fragment each, whose inputs are the very floats that were given; or triangles, over
 * which they change evenly. */
#ifndef MATC_DRAW_FIELD_H
#define MATC_DRAW_FIELD_H
#include "grammar/tables.h"
#include "runtime/draw/material.h"

enum { FIELD_VARYINGS = INPUT_front }; /* inputs.def lists the varyings first */
_Static_assert(INPUT_P == 0 && INPUT_XV == FIELD_VARYINGS - 1, "the varyings come first");

typedef struct {
    float at[4];                    /* clip space */
    float input[FIELD_VARYINGS][3]; /* by Input */
} FieldVertex;

typedef struct {
    GLuint array, buffer;
    GLenum mode; /* GL_POINTS, GL_TRIANGLES, GL_TRIANGLE_STRIP */
    int count;   /* vertices */
} Field;

/* Vertices on the driver's side. Delete in any case. */
bool field_make(GlContext *gl, const FieldVertex *vertices, int count, GLenum mode, Field *made);
void field_draw(const GlContext *gl, const Field *field);
void field_delete(const GlContext *gl, Field *field);

typedef struct {
    Target target;        /* whose GLSL it is in */
    const char *fragment; /* NULL: that of the program */
    const char *library;  /* more GLSL to be linked in, or NULL */
} FieldText;

enum { FIELD_DEFAULT_ROOM = 128 };
/* The default of an attribute that a document names, in GLSL: vec2(0.5, 1). */
void field_default(const MatcAttribute *attribute, char text[FIELD_DEFAULT_ROOM]);

/* A material whose vertex program hands over what the vertices carry; its uniform vec2 field_jitter
 * moves the picture, in clip space. The rest is as material_make has it. */
bool field_material(Store *store, MatcProgram *program, const FieldText *text, Material *made);
#endif
