/* Displacement by hardware tessellation: all patches are one draw, and the resulting triangles
 * are counted by a query. */
#include "gen/render_text.h"
#include "runtime/displace/displaced_method.h"
#include <stdlib.h>

static bool there(const GlContext *gl)
{
    GLint evaluation = 0, control = 0;
    gl->GetIntegerv(GL_MAX_TESS_EVALUATION_SHADER_STORAGE_BLOCKS, &evaluation);
    gl->GetIntegerv(GL_MAX_TESS_CONTROL_SHADER_STORAGE_BLOCKS, &control);
    return evaluation >= DISPLACED_BUFFERS && control >= 1;
}

static bool make(const DisplacedMaking *making, Displaced *made)
{
    ProgramText text = {
        .vertex = {displaced_version, render_text_displace_vertex},
        .control = {displaced_version, render_text_displace_point, render_text_displace_control},
        .evaluation = {displaced_version, "#define DISPLACE_POINT\n", making->displace,
                       render_text_displace_point, render_text_displace_evaluation}};
    return displaced_program(making, &text, &made->material);
}

static size_t points_of(int n) { return (size_t)(n + 1) * (size_t)(n + 2) / 2; }

/* Draws the patches. Mesa's software renderers number the output of a part of a draw with 16
 * bits, and lose the rest: there, few patches are drawn at a time. */
static void draw_patches(const Displaced *d, const int first[SCENE_PATCH_PARTS + 2])
{
    enum { POINTS = 1 << 15 };
    const GlContext *gl = displaced_context(d);
    for (int n = 1, patch = first[1]; patch < d->patches->count; n += patch == first[n + 1]) {
        const int most = gl->hardware ? d->patches->count : (int)(POINTS / points_of(n)) + 1,
                  end = gl->hardware ? d->patches->count : first[n + 1];
        const int count = end - patch < most ? end - patch : most;
        if (count)
            gl->DrawArrays(GL_PATCHES, 3 * patch, 3 * count);
        patch += count;
    }
}

/* Tessellates the patches. Returns the number of generated triangles, of which as many are
 * written as fit into the buffer. */
static int tessellate(Displaced *d, const int first[SCENE_PATCH_PARTS + 2], const Mesh *mesh)
{
    const GlContext *gl = displaced_context(d);
    GLuint query, made = 0;
    displaced_begin(d);
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
    return displaced_end(d) ? (int)made : -1;
}

/* Writes the tessellated mesh. A tessellator makes about 3 / 2 n^2 triangles of a patch: rings
 * of 3 n, 3 (n - 2), ... quads. */
static bool write_tessellated(Displaced *d, const int first[SCENE_PATCH_PARTS + 2], Mesh *mesh)
{
    int capacity, made = 1; /* the capacity is at least 1, since a buffer cannot be empty */
    for (int n = 1; n <= SCENE_PATCH_PARTS; n++)
        made += (first[n + 1] - first[n]) * (3 * n * n / 2 + 2);
    do {
        capacity = made;
        displaced_reserve(d, mesh, 0, 3 * (size_t)capacity * sizeof(MeshCaptured));
        made = tessellate(d, first, mesh);
        if (made < 0)
            return false;
    } while (made > capacity);
    return displaced_unshared(d, mesh, made);
}

static bool write(Displaced *d, const DisplacedView *view, Mesh *mesh)
{
    int first[SCENE_PATCH_PARTS + 2];
    return displaced_parts(d, view, first) && (!d->anew || write_tessellated(d, first, mesh));
}

const DisplacedMethod displaced_tessellation = {
    KEYWORD_Displacing_tessellation, false, there, make, write, NULL};
