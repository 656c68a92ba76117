/* Uploads a shape and draws it. */
#include "runtime/gl/mesh.h"
#include <stddef.h>
#include <stdint.h>
#include <string.h>

const char *const mesh_attribute_names[MESH_ATTRIBUTE_end] = {
    [MESH_ATTRIBUTE_position] = "position",
    [MESH_ATTRIBUTE_normal] = "normal",
    [MESH_ATTRIBUTE_texcoord] = "texcoord",
    [MESH_ATTRIBUTE_tangentU] = "tangentU",
    [MESH_ATTRIBUTE_tangentV] = "tangentV",
    [MESH_ATTRIBUTE_displacementNormal] = "displacementNormal",
    [MESH_ATTRIBUTE_displacementTexcoord] = "displacementTexcoord",
    [MESH_ATTRIBUTE_displacementTangentU] = "displacementTangentU",
    [MESH_ATTRIBUTE_displacementTangentV] = "displacementTangentV",
    [MESH_ATTRIBUTE_basePosition] = "basePosition",
};

static const struct {
    GLint components;
    size_t offset; /* byte offset in ShapeVertex */
} attributes[MESH_ATTRIBUTE_end] = {
    [MESH_ATTRIBUTE_position] = {3, offsetof(ShapeVertex, position)},
    [MESH_ATTRIBUTE_normal] = {3, offsetof(ShapeVertex, normal)},
    [MESH_ATTRIBUTE_texcoord] = {2, offsetof(ShapeVertex, uv)},
    [MESH_ATTRIBUTE_tangentU] = {3, offsetof(ShapeVertex, tangentU)},
    [MESH_ATTRIBUTE_tangentV] = {3, offsetof(ShapeVertex, tangentV)},
    [MESH_ATTRIBUTE_displacementNormal] = {3, offsetof(ShapeVertex, normal)},
    [MESH_ATTRIBUTE_displacementTexcoord] = {2, offsetof(ShapeVertex, uv)},
    [MESH_ATTRIBUTE_displacementTangentU] = {3, offsetof(ShapeVertex, tangentU)},
    [MESH_ATTRIBUTE_displacementTangentV] = {3, offsetof(ShapeVertex, tangentV)},
    [MESH_ATTRIBUTE_basePosition] = {3, offsetof(ShapeVertex, position)},
};

void mesh_point_attributes(const GlContext *gl)
{
    for (GLuint i = 0; i < MESH_ATTRIBUTE_end; i++) {
        if (!attributes[i].components)
            continue; /* mesh_attach() sets the instance's number */
        gl->EnableVertexAttribArray(i);
        /* GL takes offsets as pointers */
        gl->VertexAttribPointer(i, attributes[i].components, GL_FLOAT, GL_FALSE,
                                sizeof(ShapeVertex), (const void *)(uintptr_t)attributes[i].offset);
    }
}

static void upload(const GlContext *gl, const Mesh *mesh, const Shape *shape)
{
    gl->BindVertexArray(mesh->array);
    gl->BindBuffer(GL_ARRAY_BUFFER, mesh->buffers[0]);
    gl->BufferData(GL_ARRAY_BUFFER,
                   (GLsizeiptr)shape->vertex_count * (GLsizeiptr)sizeof *shape->vertices,
                   shape->vertices, GL_STATIC_DRAW);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh->buffers[1]);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER,
                   (GLsizeiptr)shape->index_count * (GLsizeiptr)sizeof *shape->indices,
                   shape->indices, GL_STATIC_DRAW);
    mesh_point_attributes(gl);
    if (shape->base) {
        gl->BindBuffer(GL_ARRAY_BUFFER, mesh->buffers[2]);
        gl->BufferData(GL_ARRAY_BUFFER,
                       (GLsizeiptr)shape->vertex_count * (GLsizeiptr)sizeof *shape->base,
                       shape->base, GL_STATIC_DRAW);
        gl->VertexAttribPointer(MESH_ATTRIBUTE_basePosition, 3, GL_FLOAT, GL_FALSE, 0, NULL);
    }
    for (int i = 0; i < SHAPE_EXTRAS; i++)
        if (shape->extra[i]) {
            gl->BindBuffer(GL_ARRAY_BUFFER, mesh->extras[i]);
            gl->BufferData(GL_ARRAY_BUFFER,
                           (GLsizeiptr)shape->vertex_count * (GLsizeiptr)sizeof *shape->extra[i],
                           shape->extra[i], GL_STATIC_DRAW);
        }
    /* unbinds the array before the buffers, or the array would lose its index buffer */
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
}

bool mesh_make_of(GlContext *gl, const Shape *shape, Mesh *made)
{
    memset(made, 0, sizeof *made);
    gl->GenVertexArrays(1, &made->array);
    gl->GenBuffers(shape->base ? 3 : 2, made->buffers);
    for (int i = 0; i < SHAPE_EXTRAS; i++)
        if (shape->extra[i])
            gl->GenBuffers(1, &made->extras[i]);
    memcpy(made->names, shape->names, sizeof made->names);
    upload(gl, made, shape);
    made->index_count = shape->index_count;
    made->body = shape_body(shape);
    if (shape->base && made->body == SHAPE_BODY_solid)
        /* a displaced mesh may intersect itself and show its back faces */
        made->body = SHAPE_BODY_closed;
    if (gl_check(gl, "making a mesh"))
        return true;
    mesh_delete(gl, made);
    return false;
}

bool mesh_make_captured(GlContext *gl, Mesh *made)
{
    memset(made, 0, sizeof *made);
    gl->GenVertexArrays(1, &made->array);
    gl->GenBuffers(2, made->buffers);
    gl->BindVertexArray(made->array);
    gl->BindBuffer(GL_ARRAY_BUFFER, made->buffers[0]);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, made->buffers[1]);
    for (GLuint i = 0; i < MESH_ATTRIBUTE_end; i++) {
        const size_t offset =
            i == MESH_ATTRIBUTE_basePosition ? offsetof(MeshCaptured, base) : attributes[i].offset;
        if (i >= MESH_ATTRIBUTE_count && i != MESH_ATTRIBUTE_basePosition)
            continue; /* attributes for displacement are no longer needed */
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribPointer(i, attributes[i].components, GL_FLOAT, GL_FALSE,
                                sizeof(MeshCaptured), (const void *)(uintptr_t)offset);
    }
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    if (gl_check(gl, "making a mesh"))
        return true;
    mesh_delete(gl, made);
    return false;
}

bool mesh_make(GlContext *gl, ShapeKind kind, Mesh *made)
{
    Shape shape;
    memset(made, 0, sizeof *made);
    if (!shape_make(kind, &shape))
        return gl_fail(gl, "no such shape, or out of memory");
    bool done = mesh_make_of(gl, &shape, made);
    shape_free(&shape);
    return done;
}

/* Returns the buffer of a named attribute; 0: missing. `_COLOR` is "color" if the file has no
 * COLOR_0. */
static GLuint extra_of(const Mesh *mesh, const char *name)
{
    for (int i = 0; i < SHAPE_EXTRAS; i++)
        if (mesh->extras[i] && shape_extra_is(mesh->names, i, name))
            return mesh->extras[i];
    return 0;
}

/* An attribute without an array takes the context's current value. */
void mesh_feed(const GlContext *gl, const Mesh *mesh, const MeshFeed *feeds, int count)
{
    if (!count)
        return;
    gl->BindVertexArray(mesh->array);
    for (int i = 0; i < count; i++) {
        const GLuint buffer = extra_of(mesh, feeds[i].name);
        if (!buffer) {
            gl->DisableVertexAttribArray(feeds[i].location);
            gl->VertexAttrib4fv(feeds[i].location, feeds[i].initial);
            continue;
        }
        gl->BindBuffer(GL_ARRAY_BUFFER, buffer);
        gl->EnableVertexAttribArray(feeds[i].location);
        gl->VertexAttribPointer(feeds[i].location, 4, GL_FLOAT, GL_FALSE, 0, NULL);
    }
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
}

void mesh_draw(const GlContext *gl, const Mesh *mesh)
{
    gl->BindVertexArray(mesh->array);
    gl->DrawElements(GL_TRIANGLES, mesh->index_count, GL_UNSIGNED_INT, NULL);
    gl->BindVertexArray(0);
}

void mesh_attach(const GlContext *gl, const Mesh *mesh, GLuint buffer)
{
    gl->BindVertexArray(mesh->array);
    gl->BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl->EnableVertexAttribArray(MESH_ATTRIBUTE_instance);
    gl->VertexAttribIPointer(MESH_ATTRIBUTE_instance, 1, GL_UNSIGNED_INT, 0, NULL);
    gl->VertexAttribDivisor(MESH_ATTRIBUTE_instance, 1);
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
}

void mesh_draw_instances(const GlContext *gl, const Mesh *mesh, int first, int count)
{
    gl->BindVertexArray(mesh->array);
    gl->DrawElementsInstancedBaseInstance(GL_TRIANGLES, mesh->index_count, GL_UNSIGNED_INT, NULL,
                                          count, (GLuint)first);
    gl->BindVertexArray(0);
}

void mesh_delete(const GlContext *gl, Mesh *mesh)
{
    gl->DeleteVertexArrays(1, &mesh->array); /* GL ignores the name 0 */
    gl->DeleteBuffers(3, mesh->buffers);
    gl->DeleteBuffers(SHAPE_EXTRAS, mesh->extras);
    memset(mesh, 0, sizeof *mesh);
}
