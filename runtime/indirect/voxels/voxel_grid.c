/* Fits the voxel grid to a scene. Makes no GL calls.
 *
 *     Objects from (0, 0, 0) to (4, 2, 1), 64 voxels: 62 voxels span the length 4, so that each
 *         is 4 / 62 wide, and one is left on each side. */
#include "runtime/indirect/voxels/voxels.h"
#include <math.h>
#include <string.h>

void voxel_grid_add(const CullBox *box, const SceneMatrix *world_from_local, VoxelRange *range)
{
    const double *m = world_from_local->m;
    for (int corner = 0; corner < 8; corner++) {
        double local[3];
        for (int k = 0; k < 3; k++)
            local[k] = corner >> k & 1 ? box->high[k] : box->low[k];
        for (int k = 0; k < 3; k++) {
            const double world =
                m[k] * local[0] + m[4 + k] * local[1] + m[8 + k] * local[2] + m[12 + k];
            range->low[k] = fmin(range->low[k], world);
            range->high[k] = fmax(range->high[k], world);
        }
    }
}

bool voxels_have(const GpuScenePlace *place) { return !place->transparent || place->cut >= 0; }

static VoxelRange range_of(const Scene *scene, const GpuScene *gpu_scene)
{
    VoxelRange range = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (int i = 0; i < gpu_scene->place_count; i++)
        if (voxels_have(&gpu_scene->places[i]))
            voxel_grid_add(&gpu_scene->boxes[gpu_scene->places[i].mesh],
                           &scene->objects[gpu_scene->places[i].object].world_from_local, &range);
    if (!(range.low[0] <= range.high[0]))
        memset(&range, 0, sizeof range);
    return range;
}

VoxelGrid voxel_grid(const Scene *scene, const GpuScene *gpu_scene)
{
    /* min voxel edge relative to the largest coordinate, so that floats resolve the grid */
    const double least = 1e-6;
    const VoxelRange range = range_of(scene, gpu_scene);
    VoxelGrid grid = {.size = scene->voxel_size};
    double longest = 1e-30;
    for (int k = 0; k < 3; k++) {
        longest = fmax(longest, range.high[k] - range.low[k]);
        longest = fmax(longest, least * grid.size * fmax(fabs(range.high[k]), fabs(range.low[k])));
    }
    grid.edge = longest / (grid.size - 2);
    for (int k = 0; k < 3; k++)
        grid.low[k] = (range.low[k] + range.high[k]) / 2 - grid.size / 2. * grid.edge;
    return grid;
}

void voxel_grid_clip(const VoxelGrid *grid, int axis, bool zero_to_one, double clip[16])
{
    const double over = 1 / (grid->edge * grid->size);
    memset(clip, 0, 16 * sizeof *clip);
    clip[15] = 1;
    for (int row = 0; row < 3; row++) {
        const int from = (axis + 1 + row) % 3;
        const bool parts = row == 2 && zero_to_one; /* maps to depths from 0, else from -1 */
        clip[4 * from + row] = parts ? over : 2 * over;
        clip[12 + row] = -grid->low[from] * over * (parts ? 1 : 2) - (parts ? 0 : 1);
    }
}

double voxel_grid_radius(const Scene *scene, const GpuScene *gpu_scene)
{
    /* the grid without its outer layers is as wide as the objects */
    const VoxelGrid grid = voxel_grid(scene, gpu_scene);
    const double longest = grid.edge * (grid.size - 2);
    if (scene->indirect.radius > 0)
        return scene->indirect.radius;
    return gpu_scene->place_count && longest > 1e-9 ? longest / 4 : 1;
}
