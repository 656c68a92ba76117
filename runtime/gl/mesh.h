/* A shape on the GPU: one interleaved vertex buffer, one index buffer, one vertex array. */
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
    MESH_ATTRIBUTE_instance = MESH_ATTRIBUTE_count, /* attribute of an integer per instance */
    /* Attributes for displacement: as the four above, but equal for all vertices at one
     * position. */
    MESH_ATTRIBUTE_displacementNormal,
    MESH_ATTRIBUTE_displacementTexcoord,
    MESH_ATTRIBUTE_displacementTangentU,
    MESH_ATTRIBUTE_displacementTangentV,
    /* Position before displacement; for shapes without displacement, the position. */
    MESH_ATTRIBUTE_basePosition,
    MESH_ATTRIBUTE_end
};

/* Names such as "position", for programs that declare no locations. NULL: such programs draw no
 * instances. */
extern const char *const mesh_attribute_names[MESH_ATTRIBUTE_end];

typedef struct {
    GLuint array; /* vertex array of GL */
    /* buffers of vertices, indices, and base positions if they differ */
    GLuint buffers[3];
    GLuint extras[SHAPE_EXTRAS]; /* buffers of four components per vertex; 0: the shape has none */
    ShapeNames names;            /* names of the extras */
    GLsizei index_count;
    ShapeBody body; /* class of the mesh: open, closed or solid */
} Mesh;

/* Makes a mesh of a preview shape. Returns false on failure, with *made empty; see gl->error. */
bool mesh_make(GlContext *gl, ShapeKind kind, Mesh *made);
/* Makes a mesh of any shape, which is copied. */
bool mesh_make_of(GlContext *gl, const Shape *shape, Mesh *made);

/* A vertex in the buffer of a mesh that the GPU writes. */
typedef struct {
    ShapeVertex vertex;
    float base[3]; /* position before displacement */
} MeshCaptured;
/* Makes a mesh without triangles: its first buffer is for rows of MeshCaptured, its second for
 * indices, both written by the caller. Returns false on failure, with *made empty. */
bool mesh_make_captured(GlContext *gl, Mesh *made);

/* Points the attributes of the bound vertex array into the bound buffer of ShapeVertex: those
 * for shading, and those for displacement, which are the same. */
void mesh_point_attributes(const GlContext *gl);

/* An attribute that a program reads by a name from the document. */
typedef struct MeshFeed {
    char name[SHAPE_NAME];
    GLuint location;
    float initial[4]; /* value for meshes without such an attribute */
} MeshFeed;
/* Points the program's named attributes to those of the mesh, before the mesh is drawn. */
void mesh_feed(const GlContext *gl, const Mesh *mesh, const MeshFeed *feeds, int count);

/* Draws with the current program into the current framebuffer. */
void mesh_draw(const GlContext *gl, const Mesh *mesh);

/* Instances read their number from a buffer of words, from the first instance of a draw on.
 * Needs OpenGL 4.2. */
void mesh_attach(const GlContext *gl, const Mesh *mesh, GLuint buffer);
void mesh_draw_instances(const GlContext *gl, const Mesh *mesh, int first, int count);

/* Frees the mesh and leaves it empty; safe on an empty one. */
void mesh_delete(const GlContext *gl, Mesh *mesh);
#endif
