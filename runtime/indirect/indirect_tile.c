/* Guard band of indirect light: how many pixels around a tile its rays and filters read, so that
 * the tile equals its part of the whole picture. */
#include "runtime/frame_graph/frame.h"
#include "runtime/indirect/indirect_methods.h"
#include "runtime/indirect/rays/pass_rays.h"
#include "runtime/indirect/filter/pass_denoise.h"
#include "runtime/indirect/voxels/voxels.h"
#include <math.h>

/* Max guard band in pixels; a picture that needs more is not tiled. */
enum { MARGIN_MAX = 192, AT_ONCE = -1 };

/* Returns the max length of a ray in screen space, or whose hit takes light from the screen; in
 * world units. */
static double reach_of(const Renderer *renderer)
{
    const unsigned reads = indirect_method(renderer)->reads;
    if (reads & INDIRECT_READS_radiance)
        return reads & INDIRECT_READS_near ? indirect_near(renderer) : 0;
    const bool picture = !indirect_reads_voxels(renderer) || renderer->scene->indirect.bounces > 0;
    return picture ? voxel_grid_radius(renderer->scene, &renderer->gpu_scene) : 0;
}

/* Returns the min distance of the scene from the eye along the viewing direction, over the
 * corners of the voxel grid. */
static double nearest_of(const Renderer *renderer)
{
    const VoxelGrid grid = voxel_grid(renderer->scene, &renderer->gpu_scene);
    const double *e = renderer->space.eye_from_world;
    double nearest = INFINITY;
    for (int corner = 0; corner < 8; corner++) {
        double z = e[14];
        for (int k = 0; k < 3; k++)
            z += e[4 * k + 2] * (grid.low[k] + (corner >> k & 1 ? grid.edge * grid.size : 0));
        nearest = fmin(nearest, -z);
    }
    return nearest;
}

/* Returns the max length in pixels of a ray of length `reach` from a visible surface. At a
 * distance of d, with s the slope of the ray to the picture's corner, the ray's end is projected
 * up to (1 + s) reach / (d - reach) from its origin. Infinite if the surface may be too near. */
static double pixels_of(const Renderer *renderer, double reach)
{
    const float *ray = renderer->space.ray;
    const double nearest = nearest_of(renderer), width = 2 * (double)ray[0];
    const double slope = hypot(renderer->whole[0], renderer->whole[1]) * (double)ray[0];
    if (reach == 0)
        return 0;
    if (renderer->space.depth[1] > 0)
        return reach / width;
    return nearest > 2 * reach ? (1 + slope) * reach / (nearest - reach) / width : INFINITY;
}

/* Reports whether the picture has to be drawn at once: a result continues from tile to tile or
 * from frame to frame, or depends on one point of the picture. */
static bool is_whole(const Renderer *renderer)
{
    const SceneIndirect *in = &renderer->scene->indirect;
    const bool planes = renderer->gpu_scene.plane_count > 0,
               shown = reach_of(renderer) > 0 || in->bounces > 0;
    return indirect_keeps(renderer) || indirect_is_repeated(renderer) ||
           indirect_moving(renderer) || indirect_shows(renderer, "visibility") || (planes && shown);
}

int indirect_margin(const Renderer *renderer)
{
    const double off = 2; /* max pixels between a ray's start and its pixel's center */
    const double reach = reach_of(renderer),
                 pixels = is_whole(renderer) ? INFINITY : pixels_of(renderer, reach);
    const double margin = ceil(pixels + (reach > 0 ? off : 0)) + pass_denoise_reach(renderer);
    return margin <= MARGIN_MAX ? (int)margin : AT_ONCE;
}
