/* The geometry of preview shapes, as plain numbers: z is up, front faces turn counterclockwise, and
 * at every vertex the normal and both derivatives of the position are those of the mathematical
 * surface. */
#ifndef MATC_GL_SHAPE_H
#define MATC_GL_SHAPE_H
#include <stdbool.h>
#include <stdint.h>

enum { SHAPE_HORIZON = 500 }; /* half an edge of the ground */

typedef enum {
    /* radius 1; u = longitude / 2 pi from the x axis, v from the south pole to the north pole */
    SHAPE_sphere,
    SHAPE_plane, /* [-1, 1] squared in z = 0, facing up; u along x, v along y */
    SHAPE_cube,  /* [-1, 1] cubed; every face has the whole of u and v, v upwards on the sides */
    /* around the z axis; u around the axis, v around the tube, from its outer rim upwards */
    SHAPE_torus,
    /* a sheet that hangs in folds, [-1, 1] along x and z; u along x, v upwards, v = 1 is its upper
     * hem */
    SHAPE_cloth,
    SHAPE_ground, /* z = 0 to the horizon, facing up; u and v as on the plane, and on beyond it */
    SHAPE_count
} ShapeKind;

typedef struct {
    float position[3];
    float normal[3]; /* unit length */
    float uv[2];
    float tangentU[3]; /* dP/du: not of unit length, zero at a pole of the sphere */
    float tangentV[3]; /* dP/dv */
} ShapeVertex;

/* Attributes of the mesh that materials can read, if a file has them: two that each glTF may have,
 * and those that its author named. */
enum { SHAPE_NAMED = 8, SHAPE_NAME = 64 /* bytes of a name, with its end */ };
typedef enum {
    SHAPE_EXTRA_color,
    SHAPE_EXTRA_uv1,
    SHAPE_EXTRA_named,
    SHAPE_EXTRAS = SHAPE_EXTRA_named + SHAPE_NAMED
} ShapeExtra;
typedef char ShapeNames[SHAPE_NAMED][SHAPE_NAME]; /* small letters; "": none */

typedef struct {
    ShapeVertex *vertices;
    uint32_t *indices; /* triangles */
    int vertex_count, index_count;
    /* by vertex: where it was before the shape was displaced; NULL: it was not */
    float (*base)[3];
    float (*extra[SHAPE_EXTRAS])[4]; /* by vertex; NULL: it has none */
    ShapeNames names;                /* of the extras from SHAPE_EXTRA_named on */
} Shape;

/* The name of a kind ("sphere") and back; false for a name that is none. */
const char *shape_name(ShapeKind kind);
bool shape_find(const char *name, ShapeKind *kind);

/* False when memory ran out; *made is empty then. */
bool shape_make(ShapeKind kind, Shape *made);
/* Makes a shape with another number of steps along u and v, each at least 1. */
bool shape_make_detailed(ShapeKind kind, const int steps[2], Shape *made);
/* Vertices `to` on of one shape have what `from` has of the other; its extras have room for it, or
 * are not there. */
void shape_copy_extras(Shape *made, uint32_t to, const Shape *shape, uint32_t from);
/* Room for as many vertices, in extras that are there; those beyond the old ones are as they come.
 * False: out of memory. */
bool shape_grow_extras(Shape *shape, int vertices);
void shape_free(Shape *shape);
/* Whether an extra has the name that a document says: "color", "uv1", or one of `names`, whatever
 * its letters' case. */
bool shape_extra_is(const char (*names)[SHAPE_NAME], int extra, const char *name);

/* Whether a shape's triangles are closed, with vertices at one position taken together. Wrong for
 * one in 2^63 of those that are not. shape_closed.c */
typedef enum {
    SHAPE_BODY_none,
    /* each edge has an even number of triangles: of two bodies that touch, or cross, each does */
    SHAPE_BODY_closed,
    /* each edge has as many triangles one way as the other, and all triangles of each part, which
     * share corners, show their backs to the part's middle: from outside the first that a ray meets
     * shows its front, also where parts cross */
    SHAPE_BODY_solid
} ShapeBody;
ShapeBody shape_body(const Shape *shape);
#endif
