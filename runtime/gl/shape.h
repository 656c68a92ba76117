/* Geometry of preview shapes as plain arrays: z is up, front faces are counterclockwise, and at
 * every vertex the normal and both derivatives of the position are exactly those of the
 * mathematical surface. */
#ifndef MATC_GL_SHAPE_H
#define MATC_GL_SHAPE_H
#include <stdbool.h>
#include <stdint.h>

enum { SHAPE_HORIZON = 500 }; /* half the edge of the ground */

typedef enum {
    /* radius 1; u = longitude / 2 pi from the x axis, v from the south pole to the north pole */
    SHAPE_sphere,
    SHAPE_plane, /* [-1, 1] squared in z = 0, facing up; u along x, v along y */
    SHAPE_cube,  /* [-1, 1] cubed; every face has u and v from 0 to 1, v upwards on the sides */
    /* torus around the z axis; u runs around the axis, v around the tube from its outer rim
     * upwards */
    SHAPE_torus,
    /* A curtain with folds, [-1, 1] along x and z; u along x, v upwards, v = 1 at the upper hem. */
    SHAPE_cloth,
    /* plane z = 0 up to the horizon, facing up; u and v extend those of SHAPE_plane */
    SHAPE_ground,
    SHAPE_count
} ShapeKind;

typedef struct {
    float position[3];
    float normal[3]; /* unit normal */
    float uv[2];
    float tangentU[3]; /* dP/du: not normalized, zero at the sphere's poles */
    float tangentV[3]; /* dP/dv: not normalized */
} ShapeVertex;

/* Extra attributes of a mesh that materials can read, if the file has them: two that any glTF
 * file may have, and those that its author named. */
enum { SHAPE_NAMED = 8, SHAPE_NAME = 64 /* bytes of a name, including the terminating null */ };
typedef enum {
    SHAPE_EXTRA_color,
    SHAPE_EXTRA_uv1,
    SHAPE_EXTRA_named,
    SHAPE_EXTRAS = SHAPE_EXTRA_named + SHAPE_NAMED
} ShapeExtra;
typedef char ShapeNames[SHAPE_NAMED][SHAPE_NAME]; /* names in lowercase; "": none */

typedef struct {
    ShapeVertex *vertices;
    uint32_t *indices; /* three indices per triangle */
    int vertex_count, index_count;
    /* Indexed by vertex: position before displacement; NULL: the shape is not displaced. */
    float (*base)[3];
    float (*extra[SHAPE_EXTRAS])[4]; /* indexed by vertex; NULL: missing */
    ShapeNames names;                /* names of the extras from SHAPE_EXTRA_named on */
} Shape;

/* Convert a kind to its name, such as "sphere", and back; false for an unknown name. */
const char *shape_name(ShapeKind kind);
bool shape_find(const char *name, ShapeKind *kind);

/* Makes a shape. Returns false if memory runs out, with *made empty. */
bool shape_make(ShapeKind kind, Shape *made);
/* Makes a shape with other numbers of steps along u and v, each at least 1. */
bool shape_make_detailed(ShapeKind kind, const int steps[2], Shape *made);
/* Copies the extras of vertex `from` of one shape to vertex `to` of another, whose extras are
 * missing or have the capacity. */
void shape_copy_extras(Shape *made, uint32_t to, const Shape *shape, uint32_t from);
/* Grows existing extras to a number of vertices; new elements are uninitialized. False if memory
 * runs out. */
bool shape_grow_extras(Shape *shape, int vertices);
void shape_free(Shape *shape);
/* Reports whether an extra has the name that a document uses: "color", "uv1", or one of `names`,
 * ignoring case. */
bool shape_extra_is(const char (*names)[SHAPE_NAME], int extra, const char *name);

/* Classes of watertight meshes, with vertices at equal positions merged. The test by hashes is
 * wrong for one in 2^63 of the open meshes. shape_closed.c */
typedef enum {
    SHAPE_BODY_none,
    /* Each edge has an even number of triangles, even if two closed meshes touch or intersect. */
    SHAPE_BODY_closed,
    /* Each edge has equally many triangles in both directions, and all triangles of each
     * connected part face away from the part's center. So the first triangle that a ray from
     * outside hits is a front face, even where parts intersect. */
    SHAPE_BODY_solid
} ShapeBody;
ShapeBody shape_body(const Shape *shape);
#endif
