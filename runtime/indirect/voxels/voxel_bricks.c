/* Bricks: the voxel grid as rays read it, 4 x 4 x 4 voxels in 64 bits, with coarser levels up to
 * a single brick. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/indirect/voxels/voxels.h"

enum { BRICKS_BINDING = 2, MAP_UNIT = 0, BRICK = 4, GROUP = 4 };

/* Returns the base 2 logarithm of the finest level's bricks along an edge. */
static int log_of(const FrameVoxels *voxels)
{
    int log = 0;
    while (voxels->grid.size / BRICK >> log > 1)
        log++;
    return log;
}

/* Returns the size of all levels: eight bytes per brick. The coarsest level comes first. */
static GLsizeiptr bytes_of(const FrameVoxels *voxels)
{
    return (GLsizeiptr)(((size_t)1 << 3 * (log_of(voxels) + 1)) / 7 * 2 * sizeof(GLuint));
}

bool voxel_bricks_make(Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    FrameVoxels *voxels = renderer->voxels;
    const bool modern = gl->major * 10 + gl->minor >= 45;
    const ProgramText text = {.compute = {modern ? "#version 450 core\n" : "#version 430 core\n",
                                          render_text_voxel_bricks}};
    gl->GenBuffers(1, &voxels->buffer);
    gl->BindBuffer(GL_TEXTURE_BUFFER, voxels->buffer);
    gl->BufferData(GL_TEXTURE_BUFFER, bytes_of(voxels), NULL, GL_STATIC_COPY);
    gl->GenTextures(1, &voxels->bricks);
    gl->BindTexture(GL_TEXTURE_BUFFER, voxels->bricks);
    gl->TexBuffer(GL_TEXTURE_BUFFER, GL_RG32UI, voxels->buffer);
    gl->BindBuffer(GL_TEXTURE_BUFFER, 0);
    if (!material_make(renderer->store, NULL, &text, &voxels->brick))
        return false;
    material_set_number(&voxels->brick, "brick_map", MAP_UNIT);
    return gl_check(gl, "making room for bricks of voxels");
}

void voxel_bricks_draw(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    FrameVoxels *voxels = renderer->voxels;
    const int lowest = log_of(voxels);
    gl->ActiveTexture(GL_TEXTURE0 + MAP_UNIT);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, voxels->map);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, BRICKS_BINDING, voxels->buffer);
    for (int log = lowest; log >= 0; log--) {
        const GLuint groups = ((1u << log) + GROUP - 1) / GROUP;
        material_set_number(&voxels->brick, "brick_log", (float)log);
        material_set_number(&voxels->brick, "brick_lowest", (float)(log == lowest));
        material_use(&voxels->brick);
        gl->DispatchCompute(groups, groups, log == lowest ? 1 : groups);
        gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    }
}

void voxel_bricks_bind(const Renderer *renderer, int unit)
{
    renderer->gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    renderer->gl->BindTexture(GL_TEXTURE_BUFFER, renderer->voxels->bricks);
}

void voxel_bricks_delete(Renderer *renderer)
{
    FrameVoxels *voxels = renderer->voxels;
    if (voxels->brick.store)
        material_delete(&voxels->brick);
    renderer->gl->DeleteTextures(1, &voxels->bricks); /* GL ignores the name 0 */
    renderer->gl->DeleteBuffers(1, &voxels->buffer);
}
