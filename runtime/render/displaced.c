/* Patches to triangles. By grids: patches whose edges have at most n parts are the instances of one draw of (n + 1)(n + 2) / 2 points, in n^2 triangles. By the tessellator: all
 * patches are one draw, and what comes out is counted. */
#include "runtime/render/displaced.h"
#include "runtime/render/spaces.h"
#include "runtime/scene/scene_divide.h"
#include "runtime/scene/scene_matrix.h"
#include <stdlib.h>
#include <string.h>

extern const char render_text_displace_point[], render_text_displace_grid[], render_text_displace_vertex[],
    render_text_displace_control[], render_text_displace_evaluation[];

enum { ROWS_BINDING = 6, PATCHES_BINDING, DRAWN_BINDING, BLOCKS, ROW_FLOATS = 16, PATCH_WORDS = 12 };

static GlContext *context(const Displaced *d) { return store_context(d->material.store); }

bool displaced_there(const GlContext *gl)
{
    GLint vertex = 0, evaluation = 0, control = 0, bindings = 0;
    if (gl->major * 10 + gl->minor < 45 || !gl->BindBufferBase || !gl->BindBufferRange ||
        !gl->TransformFeedbackVaryings || !gl->BeginTransformFeedback || !gl->EndTransformFeedback ||
        !gl->DrawArraysInstanced)
        return false;
    gl->GetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &vertex);
    gl->GetIntegerv(GL_MAX_TESS_EVALUATION_SHADER_STORAGE_BLOCKS, &evaluation);
    gl->GetIntegerv(GL_MAX_TESS_CONTROL_SHADER_STORAGE_BLOCKS, &control);
    gl->GetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &bindings);
    return vertex >= 3 && evaluation >= 3 && control >= 1 && bindings >= BLOCKS;
}

/* -- programs and buffers */

static bool make_material(Store *store, MatcProgram *program, Displaced *made)
{
    static const char version[] = "#version 450 core\n", point[] = "#define DISPLACE_POINT\n",
                      none[] = "void main() {}\n";
    static const char *const captured[] = {"displaced_position", "displaced_normal",   "displaced_texcoord",
                                           "displaced_tangentU", "displaced_tangentV", "displaced_base"};
    const char *displace = matc_output(program, MATC_DISPLACE, NULL);
    ProgramText grid = {.vertex = {version, point, displace, render_text_displace_point, render_text_displace_grid}};
    const ProgramText tessellated = {
        .vertex = {version, render_text_displace_vertex},
        .control = {version, render_text_displace_point, render_text_displace_control},
        .evaluation = {version, point, displace, render_text_displace_point, render_text_displace_evaluation}};
    ProgramText text = made->tessellated ? tessellated : grid;
    text.fragment[0] = version;
    text.fragment[1] = none;
    text.captured = captured;
    text.captured_count = sizeof captured / sizeof *captured;
    return material_make(store, program, &text, &made->material);
}

static void set_spaces(const Scene *scene, Displaced *made)
{
    const SceneMatrix *world = &made->patches->world_from_local;
    Spaces spaces = {.eye_from_world = mat4_identity(), .clip_from_eye = mat4_identity(), .time = (float)scene->time};
    SceneMatrix inverse;
    float local[9];
    for (int i = 0; i < 16; i++)
        spaces.world_from_local.m[i] = (float)world->m[i];
    scene_matrix_invert(world, &inverse); /* scene_displaced_mesh has seen to that */
    for (int i = 0; i < 9; i++)
        local[i] = (float)inverse.m[i / 3 * 4 + i % 3];
    spaces_set(&spaces, &made->material);
    material_set(&made->material, &(MaterialValue){"displace_localFromWorld", 9, local});
}

static bool fill(GlContext *gl, GLuint buffer, const void *bytes, size_t size)
{
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)size, bytes, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    return gl_check(gl, "making a buffer of patches");
}

static void put_row(const ShapeVertex *v, float row[ROW_FLOATS])
{
    const float lanes[ROW_FLOATS] = {v->position[0], v->position[1], v->position[2], v->uv[0],
                                     v->normal[0],   v->normal[1],   v->normal[2],   v->uv[1],
                                     v->tangentU[0], v->tangentU[1], v->tangentU[2], 0,
                                     v->tangentV[0], v->tangentV[1], v->tangentV[2], 0};
    memcpy(row, lanes, sizeof lanes);
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

static bool make_buffers(GlContext *gl, Displaced *made)
{
    const ScenePatches *patches = made->patches;
    float(*rows)[ROW_FLOATS] = calloc((size_t)patches->row_count + 1, sizeof *rows);
    _Static_assert(sizeof(ScenePatch) == PATCH_WORDS * sizeof(uint32_t), "a patch lies in a buffer as it stands");
    made->parts = calloc((size_t)patches->count + 1, sizeof *made->parts);
    for (int i = 0; rows && i < patches->row_count; i++)
        put_row(&patches->rows[i], rows[i]);
    gl->GenBuffers(3, made->buffers);
    gl->GenVertexArrays(1, &made->array);
    make_framebuffer(gl, made);
    const bool fine = rows && made->parts
                          ? fill(gl, made->buffers[0], rows, (size_t)patches->row_count * sizeof *rows) &&
                                fill(gl, made->buffers[1], patches->at, (size_t)patches->count * sizeof *patches->at)
                          : gl_fail(gl, "out of memory");
    free(rows);
    return fine;
}

bool displaced_make(Store *store, const Scene *scene, const MatcOptions *compile, int mesh, Displaced *made)
{
    GlContext *gl = store_context(store);
    const ScenePatches *patches = scene->meshes[mesh].patches;
    const SceneMaterial *of = &scene->materials[patches->material];
    MatcOptions options = *compile;
    options.target = "glsl450";
    options.pass = "depth";
    options.moved = options.instances = options.validate = false;
    *made = (Displaced){.patches = patches,
                        .mesh = mesh,
                        .tessellated = patches->method == WORD_Displacing_tessellation};
    scene_displace_params(scene, patches->material);
    MatcProgram *program = matc_compile(of->document, of->index, MATC_FRAGMENT | MATC_DISPLACE, &options);
    scene_displace_params(scene, patches->material);
    bool fine = matc_ok(program) || gl_fail(gl, "%s", matc_program_diagnostics(program, MATC_TEXT));
    fine = fine && make_material(store, program, made) && make_buffers(gl, made);
    matc_program_free(program);
    if (fine)
        set_spaces(scene, made);
    else
        displaced_delete(made);
    return fine;
}

void displaced_delete(Displaced *d)
{
    if (d->material.store) {
        GlContext *gl = context(d);
        gl->DeleteBuffers(3, d->buffers); /* GL ignores the name 0 */
        gl->DeleteVertexArrays(1, &d->array);
        gl->DeleteFramebuffers(1, &d->framebuffer);
        gl->DeleteTextures(1, &d->pixel);
        material_delete(&d->material);
    }
    free(d->parts);
    *d = (Displaced){0};
}

/* -- triangles */

/* New memory for a buffer of the mesh: what is still drawn keeps the old one. */
static void reserve(const Displaced *d, const Mesh *mesh, int buffer, size_t bytes)
{
    const GlContext *gl = context(d);
    gl->BindBuffer(GL_ARRAY_BUFFER, mesh->buffers[buffer]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)bytes, NULL, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
}

/* Patches by the parts of their insides: `first` of each number of parts, and behind the last. */
static bool write_drawn(Displaced *d, int first[SCENE_PATCH_PARTS + 2])
{
    const int count = d->patches->count;
    uint32_t(*drawn)[2] = calloc((size_t)count + 1, sizeof *drawn);
    int next[SCENE_PATCH_PARTS + 2] = {0};
    if (!drawn)
        return gl_fail(context(d), "out of memory");
    for (int t = 0; t < count; t++)
        next[scene_patch_parts(d->parts[t]) + 1]++;
    for (int n = 1; n < SCENE_PATCH_PARTS + 2; n++)
        next[n] += next[n - 1];
    memcpy(first, next, sizeof next);
    for (int t = 0; t < count; t++) {
        const uint8_t *parts = d->parts[t];
        const int inside = scene_patch_parts(parts);
        uint32_t *row = drawn[next[inside]++];
        row[0] = (uint32_t)t;
        row[1] = parts[0] | (uint32_t)parts[1] << 8 | (uint32_t)parts[2] << 16 | (uint32_t)inside << 24;
    }
    const bool fine = fill(context(d), d->buffers[2], drawn, (size_t)count * sizeof *drawn);
    free(drawn);
    return fine;
}

static size_t points_of(int n) { return (size_t)(n + 1) * (size_t)(n + 2) / 2; }

/* Of grids as they lie one behind the other. From malloc; NULL: memory ran out. */
static uint32_t *make_indices(const int first[SCENE_PATCH_PARTS + 2], size_t count)
{
    uint32_t *indices = malloc((count + 1) * sizeof *indices), *next = indices, place = 0;
    uint32_t rows[(SCENE_PATCH_PARTS + 1) * (SCENE_PATCH_PARTS + 2) / 2];
    for (int n = 1; indices && n <= SCENE_PATCH_PARTS; n++)
        for (int patch = first[n]; patch < first[n + 1]; patch++) {
            for (size_t i = 0; i < points_of(n); i++)
                rows[i] = place++;
            next = scene_divide_rows(rows, n, next);
        }
    return indices;
}

static bool write_indices(Displaced *d, Mesh *mesh, const uint32_t *indices, size_t count)
{
    const GlContext *gl = context(d);
    if (!indices)
        return gl_fail(context(d), "out of memory");
    reserve(d, mesh, 1, count * sizeof *indices);
    gl->BindBuffer(GL_ARRAY_BUFFER, mesh->buffers[1]);
    gl->BufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)(count * sizeof *indices), indices);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    mesh->index_count = (GLsizei)count;
    return true;
}

static void begin(Displaced *d)
{
    const GlContext *gl = context(d);
    for (GLuint i = 0; i < 3; i++)
        gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, ROWS_BINDING + i, d->buffers[i]);
    gl->BindFramebuffer(GL_FRAMEBUFFER, d->framebuffer);
    gl->BindVertexArray(d->array);
    gl->Enable(GL_RASTERIZER_DISCARD);
}

static bool end(const Displaced *d)
{
    const GlContext *gl = context(d);
    gl->Disable(GL_RASTERIZER_DISCARD);
    gl->BindVertexArray(0);
    gl->BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    return gl_check(context(d), "displacing a mesh");
}

static bool write_grids(Displaced *d, const int first[SCENE_PATCH_PARTS + 2], Mesh *mesh)
{
    const GlContext *gl = context(d);
    size_t points = 0, triangles = 0, at = 0;
    for (int n = 1; n <= SCENE_PATCH_PARTS; n++) {
        points += (size_t)(first[n + 1] - first[n]) * points_of(n);
        triangles += (size_t)(first[n + 1] - first[n]) * (size_t)(n * n);
    }
    uint32_t *indices = make_indices(first, 3 * triangles);
    const bool fine = write_indices(d, mesh, indices, 3 * triangles);
    free(indices);
    if (!fine)
        return false;
    reserve(d, mesh, 0, points * sizeof(MeshCaptured));
    begin(d);
    for (int n = 1; n <= SCENE_PATCH_PARTS; n++) {
        const size_t patches = (size_t)(first[n + 1] - first[n]), bytes = patches * points_of(n) * sizeof(MeshCaptured);
        if (!patches)
            continue;
        material_set_number(&d->material, "displace_first", (float)first[n]);
        material_set_number(&d->material, "displace_parts", (float)n);
        material_use(&d->material);
        gl->BindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, mesh->buffers[0], (GLintptr)at, (GLsizeiptr)bytes);
        gl->BeginTransformFeedback(GL_POINTS);
        gl->DrawArraysInstanced(GL_POINTS, 0, (GLsizei)points_of(n), (GLsizei)patches);
        gl->EndTransformFeedback();
        at += bytes;
    }
    d->points = (int)points;
    return end(d);
}

/* Mesa's software renderers number what comes out of a part of a draw in 16 bits, and lose what is beyond: there, few patches are drawn at a time. */
static void draw_patches(const Displaced *d, const int first[SCENE_PATCH_PARTS + 2])
{
    enum { POINTS = 1 << 15 };
    const GlContext *gl = context(d);
    for (int n = 1, patch = 0; patch < d->patches->count; n += patch == first[n + 1]) {
        const int most = gl->hardware ? d->patches->count : (int)(POINTS / points_of(n)) + 1,
                  end = gl->hardware ? d->patches->count : first[n + 1];
        const int count = end - patch < most ? end - patch : most;
        if (count)
            gl->DrawArrays(GL_PATCHES, 3 * patch, 3 * count);
        patch += count;
    }
}

/* How many triangles come out, of which as many are written as there is room for. */
static int tessellate(Displaced *d, const int first[SCENE_PATCH_PARTS + 2], const Mesh *mesh)
{
    const GlContext *gl = context(d);
    GLuint query, made = 0;
    begin(d);
    gl->GenQueries(1, &query);
    material_use(&d->material);
    gl->BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, mesh->buffers[0]);
    gl->BeginQuery(GL_PRIMITIVES_GENERATED, query);
    gl->BeginTransformFeedback(GL_TRIANGLES);
    draw_patches(d, first);
    gl->EndTransformFeedback();
    gl->EndQuery(GL_PRIMITIVES_GENERATED);
    gl->GetQueryObjectuiv(query, GL_QUERY_RESULT, &made);
    gl->DeleteQueries(1, &query);
    return end(d) ? (int)made : -1;
}

/* A tessellator makes about n^2 3 / 2 triangles of a patch: rings of 3 n, 3 (n - 2), ... quads. */
static bool write_tessellated(Displaced *d, const int first[SCENE_PATCH_PARTS + 2], Mesh *mesh)
{
    int room, made = 0;
    for (int n = 1; n <= SCENE_PATCH_PARTS; n++)
        made += (first[n + 1] - first[n]) * (3 * n * n / 2 + 2);
    do {
        room = made;
        reserve(d, mesh, 0, 3 * (size_t)room * sizeof(MeshCaptured));
        made = tessellate(d, first, mesh);
        if (made < 0)
            return false;
    } while (made > room);
    mesh->index_count = d->points = 3 * made;
    const size_t count = (size_t)mesh->index_count;
    uint32_t *indices = malloc((count + 1) * sizeof *indices);
    for (size_t i = 0; indices && i < count; i++)
        indices[i] = (uint32_t)i;
    const bool fine = write_indices(d, mesh, indices, count);
    free(indices);
    return fine;
}

bool displaced_write(Displaced *d, const SceneCamera *camera, const int size[2], Mesh *mesh)
{
    const size_t bytes = (size_t)d->patches->count * sizeof *d->parts;
    uint8_t(*parts)[3] = malloc(bytes + 1);
    int first[SCENE_PATCH_PARTS + 2];
    if (!parts)
        return gl_fail(context(d), "out of memory");
    scene_patches_levels(d->patches, camera, size, parts);
    const bool same = d->written && !memcmp(parts, d->parts, bytes);
    memcpy(d->parts, parts, bytes);
    free(parts);
    d->anew = !same;
    if (same)
        return true;
    d->written =
        write_drawn(d, first) && (d->tessellated ? write_tessellated(d, first, mesh) : write_grids(d, first, mesh));
    return d->written;
}

bool displaced_read(const Displaced *d, const Mesh *mesh, Shape *made)
{
    GlContext *gl = context(d);
    MeshCaptured *points = malloc((size_t)d->points * sizeof *points + 1);
    *made = (Shape){.vertices = calloc((size_t)d->points + 1, sizeof *made->vertices),
                    .indices = calloc((size_t)mesh->index_count + 1, sizeof *made->indices),
                    .base = calloc((size_t)d->points + 1, sizeof *made->base),
                    .vertex_count = d->points,
                    .index_count = mesh->index_count};
    bool fine = (points && made->vertices && made->indices && made->base) || gl_fail(gl, "out of memory");
    if (fine) {
        gl->BindBuffer(GL_ARRAY_BUFFER, mesh->buffers[0]);
        gl->GetBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)((size_t)d->points * sizeof *points), points);
        gl->BindBuffer(GL_ARRAY_BUFFER, mesh->buffers[1]);
        gl->GetBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)((size_t)mesh->index_count * sizeof *made->indices),
                             made->indices);
        gl->BindBuffer(GL_ARRAY_BUFFER, 0);
        fine = gl_check(gl, "reading a displaced mesh");
    }
    for (int i = 0; fine && i < d->points; i++) {
        made->vertices[i] = points[i].vertex;
        memcpy(made->base[i], points[i].base, sizeof made->base[i]);
    }
    free(points);
    if (!fine)
        shape_free(made);
    return fine;
}
