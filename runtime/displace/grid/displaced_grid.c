/* Displacement by grids: patches whose edges have at most n parts are the instances of one draw
 * of (n + 1)(n + 2) / 2 points, which form n^2 triangles. */
#include "gen/render_text.h"
#include "runtime/displace/displaced_method.h"
#include "runtime/tessellate/scene_divide.h"
#include <stdlib.h>

static bool make(const DisplacedMaking *making, Displaced *made)
{
    ProgramText text = {.vertex = {displaced_version, "#define DISPLACE_POINT\n", making->displace,
                                   render_text_displace_point, render_text_displace_grid}};
    return displaced_program(making, &text, &made->material);
}

static size_t points_of(int n) { return (size_t)(n + 1) * (size_t)(n + 2) / 2; }

/* Indices of consecutive grids. From malloc; NULL: out of memory. */
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

static bool write_grids(Displaced *d, const int first[SCENE_PATCH_PARTS + 2], Mesh *mesh)
{
    const GlContext *gl = displaced_context(d);
    size_t points = 0, triangles = 0, at = 0;
    for (int n = 1; n <= SCENE_PATCH_PARTS; n++) {
        points += (size_t)(first[n + 1] - first[n]) * points_of(n);
        triangles += (size_t)(first[n + 1] - first[n]) * (size_t)(n * n);
    }
    uint32_t *indices = make_indices(first, 3 * triangles);
    const bool fine = displaced_indices(d, mesh, indices, 3 * triangles);
    free(indices);
    if (!fine)
        return false;
    displaced_reserve(d, mesh, 0, points * sizeof(MeshCaptured));
    displaced_begin(d);
    for (int n = 1; n <= SCENE_PATCH_PARTS; n++) {
        const size_t patches = (size_t)(first[n + 1] - first[n]),
                     bytes = patches * points_of(n) * sizeof(MeshCaptured);
        if (!patches)
            continue;
        material_set_number(&d->material, "displace_first", (float)first[n]);
        material_set_number(&d->material, "displace_parts", (float)n);
        material_use(&d->material);
        gl->BindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, mesh->buffers[0], (GLintptr)at,
                            (GLsizeiptr)bytes);
        gl->BeginTransformFeedback(GL_POINTS);
        gl->DrawArraysInstanced(GL_POINTS, 0, (GLsizei)points_of(n), (GLsizei)patches);
        gl->EndTransformFeedback();
        at += bytes;
    }
    d->points = (int)points;
    return displaced_end(d);
}

static bool write(Displaced *d, const DisplacedView *view, Mesh *mesh)
{
    int first[SCENE_PATCH_PARTS + 2];
    return displaced_parts(d, view, first) && (!d->anew || write_grids(d, first, mesh));
}

const DisplacedMethod displaced_grid = {KEYWORD_Displacing_grid, false, NULL, make, write, NULL};
