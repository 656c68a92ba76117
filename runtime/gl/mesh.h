/* A shape on the driver's side: one interleaved vertex buffer, one index buffer, one vertex
 * array. */
#ifndef MATC_GL_MESH_H
#define MATC_GL_MESH_H
#include "runtime/gl/context.h"
#include "runtime/gl/shape.h"

/* Attribute locations, as matc's vertex programs declare them. */
enum {
    MESH_ATTRIBUTE_position,
    MESH_ATTRIBUTE_normal,
    MESH_ATTRIBUTE_texcoord,
    MESH_ATTRIBUTE_tangentU,
    MESH_ATTRIBUTE_tangentV,
    MESH_ATTRIBUTE_count,
    MESH_ATTRIBUTE_instance = MESH_ATTRIBUTE_count, /* a whole number, one for each instance */
    /* what a vertex is displaced by: as the four above, but the same for all vertices */
    MESH_ATTRIBUTE_displacementNormal,
    MESH_ATTRIBUTE_displacementTexcoord, /* of one position */
    MESH_ATTRIBUTE_displacementTangentU,
    MESH_ATTRIBUTE_displacementTangentV,
    /* where it was, of a shape that was displaced; else its position */
    MESH_ATTRIBUTE_basePosition,
    MESH_ATTRIBUTE_end
};

/* "position", "normal", "texcoord", ...: for programs that declare no locations. NULL: such
 * programs draw no instances. */
extern const char *const mesh_attribute_names[MESH_ATTRIBUTE_end];

typedef struct {
    GLuint array;                /* vertex array */
    GLuint buffers[3];           /* vertices, indices, base positions where they are others */
    GLuint extras[SHAPE_EXTRAS]; /* four lanes a vertex; 0: the shape has none */
    ShapeNames names;            /* the shape's */
    GLsizei index_count;
    ShapeBody body; /* what it encloses */
} Mesh;

/* On false *made is empty, see gl->error. */
bool mesh_make(GlContext *gl, ShapeKind kind, Mesh *made);
/* Makes a mesh of any shape, which is not kept. */
bool mesh_make_of(GlContext *gl, const Shape *shape, Mesh *made);

/* Row of the buffer of a mesh that the GPU writes. */
typedef struct {
    ShapeVertex vertex;
    float base[3]; /* where it was */
} MeshCaptured;
/* A mesh without any triangles, whose first buffer has rows of MeshCaptured, and whose second has
 * indices, both to be written by the caller. On false *made is empty. */
bool mesh_make_captured(GlContext *gl, Mesh *made);

/* Says where attributes lie in the array and the buffer that are bound, a row of ShapeVertex: those
 * that shade, and those of displacement, which are the same. */
void mesh_point_attributes(const GlContext *gl);

/* An attribute that a program reads by a name of a document's. */
typedef struct MeshFeed {
    char name[SHAPE_NAME];
    GLuint location;
    float initial[4]; /* of a mesh that has none of that name */
} MeshFeed;
/* Points the program's attributes at what the mesh has under their names; before it is drawn. */
void mesh_feed(const GlContext *gl, const Mesh *mesh, const MeshFeed *feeds, int count);

/* Draws with the current program into the current framebuffer. */
void mesh_draw(const GlContext *gl, const Mesh *mesh);

/* Where instances find their numbers: words of a buffer, that of the first instance of a draw
 * first. OpenGL 4.2. */
void mesh_attach(const GlContext *gl, const Mesh *mesh, GLuint buffer);
void mesh_draw_instances(const GlContext *gl, const Mesh *mesh, int first, int count);

/* Safe on an empty one. */
void mesh_delete(const GlContext *gl, Mesh *mesh);
#endif
