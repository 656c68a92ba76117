/* Vertex attributes, and their transforms by the definitions. */
#include "vertices.h"
#include <math.h>

float spread(int index) { return (float)(4 * fmod((index + 1) * 0.6180339887498949, 1) - 2); }

/* Places a vertex at a pixel's center. */
static void place(Vertices *vertices, int i, const Mat4 *local_from_clip, int side)
{
    int x = i % 8 * 8 + 5, y = i / 8 * 8 + 3;
    double local[4],
        clip[3] = {2 * (x + 0.5) / side - 1, 2 * (y + 0.5) / side - 1, 0.9 + spread(i) / 50};
    space_transform(local_from_clip, clip, 1, local);
    for (int component = 0; component < 3; component++)
        vertices->vertex[i].position[component] = (float)(local[component] / local[3]);
    vertices->pixel[i] = y * side + x;
}

/* Transforms positions and tangents by the matrix. */
static void transform(Surface *surface, Group group, const Mat4 *world_from_local,
                      const float local[3])
{
    double world[4], from[3] = {local[0], local[1], local[2]};
    space_transform(world_from_local, from, group == GROUP_P, world);
    surface_set3(surface, group, world);
    if (group == GROUP_P)
        surface_set3(surface, GROUP_X, from);
}

/* Transforms normals by the inverse transpose. */
static void transform_normal(Surface *surface, const Mat4 *local_from_world, const float local[3])
{
    double world[3] = {0};
    for (int k = 0; k < 9; k++)
        world[k / 3] += (double)local_from_world->m[4 * (k / 3) + k % 3] * local[k % 3];
    surface_set3(surface, GROUP_N, world);
}

void vertices_make(Vertices *vertices, const Space *space, int side)
{
    Mat4 clip_from_world = space_clip_from_world(space), local_from_clip, local_from_world;
    Mat4 clip_from_local = mat4_multiply(&clip_from_world, &space->world_from_local);
    mat4_inverse(&clip_from_local, &local_from_clip);
    mat4_inverse(&space->world_from_local, &local_from_world);
    for (int i = 0; i < VERTICES; i++) {
        ShapeVertex *vertex = &vertices->vertex[i];
        Surface *surface = &vertices->surface[i];
        float *attribute[] = {vertex->normal, vertex->tangentU, vertex->tangentV, vertex->uv};
        for (int k = 0; k < 11; k++)
            attribute[k / 3][k % 3] = spread(11 * i + k);
        place(vertices, i, &local_from_clip, side);
        oracle_surface_default(surface);
        transform(surface, GROUP_P, &space->world_from_local, vertex->position);
        transform(surface, GROUP_DU, &space->world_from_local, vertex->tangentU);
        transform(surface, GROUP_DV, &space->world_from_local, vertex->tangentV);
        transform_normal(surface, &local_from_world, vertex->normal);
        surface_set3(surface, GROUP_U, (double[3]){vertex->uv[0], vertex->uv[1], 0});
    }
}

void vertices_upload(Vertices *vertices, const GlContext *gl)
{
    gl->GenVertexArrays(1, &vertices->array);
    gl->GenBuffers(1, &vertices->buffer);
    gl->BindVertexArray(vertices->array);
    gl->BindBuffer(GL_ARRAY_BUFFER, vertices->buffer);
    gl->BufferData(GL_ARRAY_BUFFER, sizeof vertices->vertex, vertices->vertex, GL_STATIC_DRAW);
    mesh_point_attributes(gl);
}

void vertices_draw(const Vertices *vertices, const GlContext *gl)
{
    gl->BindVertexArray(vertices->array);
    gl->DrawArrays(GL_POINTS, 0, VERTICES);
}

void vertices_delete(Vertices *vertices, const GlContext *gl)
{
    gl->DeleteVertexArrays(1, &vertices->array);
    gl->DeleteBuffers(1, &vertices->buffer);
}
