/* Functions that all methods share: buffers of patches, a program that writes rows of
 * MeshCaptured, and the mesh that receives them. */
#include "runtime/displace/displaced_method.h"
#include "runtime/gpu_material/spaces.h"
#include "runtime/scene/scene_matrix.h"
#include <stdlib.h>
#include <string.h>

enum { ROWS_BINDING = DISPLACED_BINDINGS - DISPLACED_BUFFERS, ROW_FLOATS = 16, PATCH_WORDS = 12 };

const char displaced_version[] = "#version 450 core\n";

GlContext *displaced_context(const Displaced *d) { return store_context(d->material.store); }

static void set_spaces(const Scene *scene, const ScenePatches *patches, Material *made)
{
    const SceneMatrix *world = &patches->world_from_local;
    Spaces spaces = {.eye_from_world = mat4_identity(),
                     .clip_from_eye = mat4_identity(),
                     .time = (float)scene->time};
    SceneMatrix inverse;
    float local[9];
    for (int i = 0; i < 16; i++)
        spaces.world_from_local.m[i] = (float)world->m[i];
    for (int i = 0; i < 3; i++)
        spaces.origin[i] = (float)scene->origin[i];
    /* scene_displaced_mesh() has checked that the matrix is invertible */
    scene_matrix_invert(world, &inverse);
    for (int i = 0; i < 9; i++)
        local[i] = (float)inverse.m[i / 3 * 4 + i % 3];
    spaces_set(&spaces, made);
    material_set(made, &(MaterialValue){"displace_localFromWorld", 9, local});
}

bool displaced_program(const DisplacedMaking *making, ProgramText *text, Material *made)
{
    static const char *const captured[] = {"displaced_position", "displaced_normal",
                                           "displaced_texcoord", "displaced_tangentU",
                                           "displaced_tangentV", "displaced_base"};
    if (!text->compute[0] && !text->fragment[0]) {
        text->fragment[0] = displaced_version;
        text->fragment[1] = "void main() {}\n";
        text->captured = captured;
        text->captured_count = sizeof captured / sizeof *captured;
    }
    if (!material_make(making->store, making->program, text, made))
        return false;
    set_spaces(making->scene, making->patches, made);
    material_set_number(made, "displace_push", (float)making->patches->dividing.push);
    material_set_number(made, "displace_bulge", (float)making->patches->dividing.bulge);
    material_set_number(made, "displace_depth", (float)making->patches->bound);
    return true;
}

bool displaced_fill(GlContext *gl, GLuint buffer, const void *bytes, size_t size)
{
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)size, bytes, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    return gl_check(gl, "making a buffer of patches");
}

static void put_row(const ShapeVertex *v, float row[ROW_FLOATS])
{
    const float components[ROW_FLOATS] = {v->position[0], v->position[1], v->position[2], v->uv[0],
                                          v->normal[0],   v->normal[1],   v->normal[2],   v->uv[1],
                                          v->tangentU[0], v->tangentU[1], v->tangentU[2], 0,
                                          v->tangentV[0], v->tangentV[1], v->tangentV[2], 0};
    memcpy(row, components, sizeof components);
}

static void make_framebuffer(const GlContext *gl, Displaced *made)
{
    gl->GenTextures(1, &made->pixel);
    gl->BindTexture(GL_TEXTURE_2D, made->pixel);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_R8, 1, 1, 0, GL_RED, GL_UNSIGNED_BYTE, NULL);
    gl->GenFramebuffers(1, &made->framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, made->framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, made->pixel, 0);
}

bool displaced_buffers(GlContext *gl, Displaced *made)
{
    const ScenePatches *patches = made->patches;
    float(*rows)[ROW_FLOATS] = calloc((size_t)patches->row_count + 1, sizeof *rows);
    _Static_assert(sizeof(ScenePatch) == PATCH_WORDS * sizeof(uint32_t),
                   "a patch lies in a buffer as it stands");
    made->parts = calloc((size_t)patches->count + 1, sizeof *made->parts);
    for (int i = 0; rows && i < patches->row_count; i++)
        put_row(&patches->rows[i], rows[i]);
    gl->GenBuffers(DISPLACED_BUFFERS, made->buffers);
    gl->GenVertexArrays(1, &made->array);
    make_framebuffer(gl, made);
    const bool fine = rows && made->parts
                          ? displaced_fill(gl, made->buffers[0], rows,
                                           (size_t)patches->row_count * sizeof *rows) &&
                                displaced_fill(gl, made->buffers[1], patches->at,
                                               (size_t)patches->count * sizeof *patches->at)
                          : gl_fail(gl, "out of memory");
    free(rows);
    return fine;
}

void displaced_reserve(Displaced *d, const Mesh *mesh, int buffer, size_t bytes)
{
    enum { TOO_MUCH = 4 };
    const GlContext *gl = displaced_context(d);
    if (d->capacity[buffer] >= bytes && d->capacity[buffer] / TOO_MUCH <= bytes)
        return;
    d->capacity[buffer] = bytes;
    d->numbered = buffer == 1 ? 0 : d->numbered;
    gl->BindBuffer(GL_ARRAY_BUFFER, mesh->buffers[buffer]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)bytes, NULL, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
}

bool displaced_indices(Displaced *d, Mesh *mesh, const uint32_t *indices, size_t count)
{
    const GlContext *gl = displaced_context(d);
    if (!indices)
        return gl_fail(displaced_context(d), "out of memory");
    displaced_reserve(d, mesh, 1, count * sizeof *indices);
    gl->BindBuffer(GL_ARRAY_BUFFER, mesh->buffers[1]);
    gl->BufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)(count * sizeof *indices), indices);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    mesh->index_count = (GLsizei)count;
    return true;
}

bool displaced_unshared(Displaced *d, Mesh *mesh, int triangles)
{
    const size_t count = 3 * (size_t)triangles;
    d->points = mesh->index_count = (GLsizei)count;
    if (d->numbered >= count && d->capacity[1] / sizeof(uint32_t) >= count)
        return true;
    uint32_t *indices = malloc((count + 1) * sizeof *indices);
    for (size_t i = 0; indices && i < count; i++)
        indices[i] = (uint32_t)i;
    const bool fine = displaced_indices(d, mesh, indices, count);
    free(indices);
    d->numbered = fine ? count : 0;
    return fine;
}

void displaced_begin(const Displaced *d)
{
    const GlContext *gl = displaced_context(d);
    for (GLuint i = 0; i < DISPLACED_BUFFERS; i++)
        gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, ROWS_BINDING + i, d->buffers[i]);
    gl->BindFramebuffer(GL_FRAMEBUFFER, d->framebuffer);
    gl->BindVertexArray(d->array);
    gl->Enable(GL_RASTERIZER_DISCARD);
}

void displaced_capture(Displaced *d, const Mesh *mesh, size_t first, size_t points)
{
    const GlContext *gl = displaced_context(d);
    material_use(&d->material);
    gl->BindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, mesh->buffers[0],
                        (GLintptr)(first * sizeof(MeshCaptured)),
                        (GLsizeiptr)(points * sizeof(MeshCaptured)));
    gl->BeginTransformFeedback(GL_TRIANGLES);
}

bool displaced_end(const Displaced *d)
{
    const GlContext *gl = displaced_context(d);
    gl->Disable(GL_RASTERIZER_DISCARD);
    gl->BindVertexArray(0);
    gl->BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    return gl_check(displaced_context(d), "displacing a mesh");
}
