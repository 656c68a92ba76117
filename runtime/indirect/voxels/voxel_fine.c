/* Surfaces whose triangles are small against voxels are rasterized by a compute program: the
 * GPU's rasterizer would take each triangle three times, and mostly produce no fragment. The
 * choice is made per mesh (voxel_bodies.c). */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/indirect/voxels/voxels.h"
#include <stdio.h>
#include <stdlib.h>

enum { PLACES, VERTICES, INDICES, GROUP = 64, GROUPS_MAX = 4096, PLACES_MAX = 65535, ROWS = 3 };

bool voxel_fine_make(Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    const bool modern = gl->major * 10 + gl->minor >= 45;
    char defined[64];
    const ProgramText text = {.compute = {modern ? "#version 450 core\n" : "#version 430 core\n",
                                          defined, render_text_voxel_fine}};
    snprintf(defined, sizeof defined, "#define FINE_STRIDE %d\n",
             (int)(sizeof(ShapeVertex) / sizeof(float)));
    gl->GenBuffers(1, &renderer->voxels->fine_places);
    renderer->voxels->fine_rows =
        malloc((size_t)renderer->gpu_scene.place_count * sizeof *renderer->voxels->fine_rows + 1);
    if (!renderer->voxels->fine_rows)
        return gl_fail(gl, "out of memory");
    return material_make(renderer->store, NULL, &text, &renderer->voxels->fine) &&
           gl_check(gl, "making room for fine surfaces");
}

/* Computes the rows of the matrix from a mesh's local space to voxels. */
static void put_place(const VoxelGrid *grid, const SceneMatrix *world_from_local,
                      float rows[ROWS][4])
{
    const double *m = world_from_local->m;
    for (int k = 0; k < ROWS; k++)
        for (int column = 0; column < 4; column++)
            rows[k][column] =
                (float)((m[4 * column + k] - (column == 3 ? grid->low[k] : 0)) / grid->edge);
}

/* Rasterizes `count` instances of a mesh, whose matrices are in fine_rows. */
static void touch(Renderer *renderer, int mesh, int count)
{
    const GlContext *gl = renderer->gl;
    const FrameVoxels *voxels = renderer->voxels;
    const Mesh *drawn = &renderer->gpu_scene.meshes[mesh];
    const GLuint groups = (GLuint)((drawn->index_count / 3 + GROUP - 1) / GROUP);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, voxels->fine_places);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)sizeof *voxels->fine_rows * count,
                   voxels->fine_rows, GL_STREAM_DRAW);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, PLACES, voxels->fine_places);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, VERTICES, drawn->buffers[0]);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, INDICES, drawn->buffers[1]);
    gl->DispatchCompute(groups < GROUPS_MAX ? groups : GROUPS_MAX, (GLuint)count, 1);
}

/* Draws all places with fine triangles. cast_order is sorted by mesh, so instances of a mesh are
 * drawn together, at most PLACES_MAX at once. */
void voxel_fine_draw(Renderer *renderer)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    FrameVoxels *voxels = renderer->voxels;
    if (!voxel_bodies_has(voxels, gpu_scene, VOXELS_FINE))
        return;
    material_use(&voxels->fine);
    for (int i = 0, count = 0; i < gpu_scene->cast_count; i++) {
        const GpuScenePlace *place = &gpu_scene->places[gpu_scene->cast_order[i]];
        const bool ends = i + 1 == gpu_scene->cast_count ||
                          gpu_scene->places[gpu_scene->cast_order[i + 1]].mesh != place->mesh;
        if (voxels->waves[gpu_scene->cast_order[i]] == VOXELS_FINE)
            put_place(&voxels->grid, &renderer->scene->objects[place->object].world_from_local,
                      voxels->fine_rows[count++]);
        if (count && (ends || count == PLACES_MAX)) {
            touch(renderer, place->mesh, count);
            count = 0;
        }
    }
}
