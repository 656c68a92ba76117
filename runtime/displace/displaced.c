/* Converts patches to triangles, by one of the methods in the table below; each method has its
 * own folder. */
#include "runtime/displace/displaced.h"
#include "runtime/displace/displaced_method.h"
#include "runtime/tessellate/scene_displace.h"
#include <stdlib.h>
#include <string.h>

/* The table of methods; displaced_method.h explains the members of a row. */
static const DisplacedMethod *const methods[] = {
    &displaced_grid,     &displaced_tessellation, &displaced_geometry,   &displaced_points,
    &displaced_feedback, &displaced_bisection,    &displaced_by_tracing, &displaced_by_parallax};

/* Returns the displacement method of a keyword; `auto` selects the grid. */
static const DisplacedMethod *method_of(Keyword word)
{
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++)
        if (methods[i]->word == word)
            return methods[i];
    return &displaced_grid;
}

bool displaced_supported(const GlContext *gl, Keyword method)
{
    GLint vertex = 0, bindings = 0;
    if (gl->major * 10 + gl->minor < 45 || !gl->BindBufferBase || !gl->BindBufferRange ||
        !gl->TransformFeedbackVaryings || !gl->BeginTransformFeedback ||
        !gl->EndTransformFeedback || !gl->DrawArraysInstanced)
        return false;
    const DisplacedMethod *by = method_of(method);
    gl->GetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &vertex);
    gl->GetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &bindings);
    return vertex >= DISPLACED_BUFFERS && bindings >= DISPLACED_BINDINGS &&
           (!by->there || by->there(gl));
}

bool displaced_make(Store *store, const Scene *scene, const MatcOptions *compile, int mesh,
                    Displaced *made)
{
    GlContext *gl = store_context(store);
    const ScenePatches *patches = scene->meshes[mesh].patches;
    const SceneMaterial *of = &scene->materials[patches->material];
    MatcOptions options = *compile;
    options.target = "glsl450";
    options.pass = "depth";
    options.moved = options.instances = options.validate = false;
    *made = (Displaced){.patches = patches, .mesh = mesh, .method = method_of(patches->method)};
    made->volume = matc_has_volume(of->document, of->index);
    scene_displace_params(scene, patches->material);
    MatcProgram *program =
        matc_compile(of->document, of->index, MATC_FRAGMENT | MATC_DISPLACE, &options);
    scene_displace_params(scene, patches->material);
    const DisplacedMaking making = {store, scene, patches, program,
                                    matc_output(program, MATC_DISPLACE, NULL)};
    const bool fine =
        (matc_ok(program) || gl_fail(gl, "%s", matc_program_diagnostics(program, MATC_TEXT))) &&
        made->method->make(&making, made) && displaced_buffers(gl, made);
    matc_program_free(program);
    if (!fine)
        displaced_delete(made);
    return fine;
}

void displaced_delete(Displaced *d)
{
    if (d->material.store) {
        GlContext *gl = displaced_context(d);
        if (d->method->forget)
            d->method->forget(d);
        gl->DeleteBuffers(DISPLACED_BUFFERS, d->buffers); /* GL ignores the name 0 */
        gl->DeleteVertexArrays(1, &d->array);
        gl->DeleteFramebuffers(1, &d->framebuffer);
        gl->DeleteTextures(1, &d->pixel);
        material_delete(&d->material);
    }
    free(d->parts);
    *d = (Displaced){0};
}

bool displaced_by_view(const Displaced *d)
{
    return d->material.store && (d->method->by_view || d->patches->pixels > 0);
}

bool displaced_by_lights(const Displaced *d)
{
    return d->material.store &&
           (d->method == &displaced_bisection || scene_patches_hide(d->patches));
}

bool displaced_write(Displaced *d, const DisplacedView *view, Mesh *mesh)
{
    d->anew = true;
    d->written = d->method->write(d, view, mesh);
    return d->written;
}

static bool is_gap(const Shape *shape, const uint32_t *index)
{
    const float *p = shape->vertices[index[0]].position;
    return !memcmp(p, shape->vertices[index[1]].position, 3 * sizeof *p) &&
           !memcmp(p, shape->vertices[index[2]].position, 3 * sizeof *p);
}

/* Removes degenerate triangles, which merging and empty parts of a volume leave in the buffer. */
static void close_gaps(Shape *shape)
{
    int count = 0;
    for (int i = 0; i < shape->index_count; i += 3) {
        uint32_t *index = &shape->indices[i];
        if (!is_gap(shape, index)) {
            memmove(&shape->indices[count], index, 3 * sizeof *index);
            count += 3;
        }
    }
    shape->index_count = count;
}

bool displaced_read(const Displaced *d, const Mesh *mesh, Shape *made)
{
    GlContext *gl = displaced_context(d);
    MeshCaptured *points = malloc((size_t)d->points * sizeof *points + 1);
    *made = (Shape){.vertices = calloc((size_t)d->points + 1, sizeof *made->vertices),
                    .indices = calloc((size_t)mesh->index_count + 1, sizeof *made->indices),
                    .base = calloc((size_t)d->points + 1, sizeof *made->base),
                    .vertex_count = d->points,
                    .index_count = mesh->index_count};
    bool fine =
        (points && made->vertices && made->indices && made->base) || gl_fail(gl, "out of memory");
    if (fine) {
        gl->BindBuffer(GL_ARRAY_BUFFER, mesh->buffers[0]);
        gl->GetBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)((size_t)d->points * sizeof *points),
                             points);
        gl->BindBuffer(GL_ARRAY_BUFFER, mesh->buffers[1]);
        gl->GetBufferSubData(GL_ARRAY_BUFFER, 0,
                             (GLsizeiptr)((size_t)mesh->index_count * sizeof *made->indices),
                             made->indices);
        gl->BindBuffer(GL_ARRAY_BUFFER, 0);
        fine = gl_check(gl, "reading a displaced mesh");
    }
    for (int i = 0; fine && i < d->points; i++) {
        made->vertices[i] = points[i].vertex;
        memcpy(made->base[i], points[i].base, sizeof made->base[i]);
    }
    free(points);
    if (fine && (d->volume || d->method == &displaced_bisection))
        close_gaps(made);
    if (!fine)
        shape_free(made);
    return fine;
}
