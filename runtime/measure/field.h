/* What is drawn to measure a material: points, a fragment each, whose inputs are given floats; and a plane in perspective up to
 * its horizon. Both are vertices that carry all varyings, so that any fragment program can be drawn with them. */
#ifndef MATC_MEASURE_FIELD_H
#define MATC_MEASURE_FIELD_H
#include "compiler/oracle/oracle.h"
#include "runtime/gl/context.h"

enum { FIELD_VARYINGS = INPUT_front }; /* inputs.def lists the varyings first */
_Static_assert(INPUT_P == 0 && INPUT_XV == FIELD_VARYINGS - 1, "the varyings come first");

typedef struct {
    float at[4];                    /* clip space */
    float input[FIELD_VARYINGS][3]; /* by Input */
} FieldVertex;

typedef struct {
    GLuint array, buffer;
    GLenum mode; /* GL_POINTS, or GL_TRIANGLE_STRIP */
    int count;   /* vertices */
} Field;

enum { POINTS_WIDTH = 64, POINTS_HEIGHT = 32, POINTS = POINTS_WIDTH * POINTS_HEIGHT };

/* Points spread evenly in [-range, range] on every coordinate, with unit normals at any angle and unit tangents at right angles
 * to them. The same ones at every call. */
void field_points(FieldVertex points[POINTS], double range);
/* What the oracle sees there: the very same floats, from the front, ior 1. */
void field_surface(const FieldVertex *point, Surface *surface);

/* Where the plane z = 0 is seen from, one unit above it. The horizon is the picture's upper edge. */
typedef struct {
    double yaw;      /* radians from the x axis */
    double scale;    /* u and v a unit of length */
    double aspect;   /* width over height */
    int height;      /* of the picture, pixels */
    double shift[2]; /* added to x and y, and times scale to u and v: how far from the origin it lies */
} PlaneView;
enum { PLANE_VERTICES = 4 };
void field_plane(FieldVertex vertices[PLANE_VERTICES], const PlaneView *view);

/* Vertices on the driver's side. Delete in any case. */
bool field_make(GlContext *gl, const FieldVertex *vertices, int count, GLenum mode, Field *made);
void field_draw(const GlContext *gl, const Field *field);
void field_delete(const GlContext *gl, Field *field);

enum { FIELD_TEXT = 8192 };
/* The vertex program that gives a fragment program what it declares; uniform vec2 measure_jitter moves the picture, in
 * clip space. `names` are its attributes, for ProgramText. */
void field_vertex_text(const char *fragment, char text[FIELD_TEXT]);
extern const char *const field_attributes[FIELD_VARYINGS + 1];
#endif
