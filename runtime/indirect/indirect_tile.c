/* Guard band of indirect light: how many pixels around a tile its rays and filters read, so that
 * the tile equals its part of the whole picture. */
#include "runtime/frame/frame.h"
#include "runtime/indirect/indirect_methods.h"
#include "runtime/indirect/rays/pass_rays.h"
#include "runtime/indirect/filter/pass_smooth.h"
#include "runtime/indirect/voxels/voxels.h"
#include <math.h>

/* Max guard band in pixels; a picture that needs more is not tiled. */
enum { MARGIN_MOST = 192, AT_ONCE = -1 };

/* Max length of a ray in screen space, or whose hit takes light from the screen; in world units. */
static double reach_of(const Render *render)
{
    const unsigned reads = indirect_method(render)->reads;
    if (reads & INDIRECT_READS_radiance)
        return reads & INDIRECT_READS_near ? indirect_near(render) : 0;
    const bool picture = !indirect_reads_voxels(render) || render->scene->indirect.bounces > 0;
    return picture ? voxel_grid_radius(render->scene, &render->gpu_scene) : 0;
}

/* Returns the min distance of the scene from the eye along the viewing direction, over the
 * corners of the voxel grid. */
static double nearest_of(const Render *render)
{
    const VoxelGrid grid = voxel_grid(render->scene, &render->gpu_scene);
    const double *e = render->space.eye_from_world;
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
static double pixels_of(const Render *render, double reach)
{
    const float *ray = render->space.ray;
    const double nearest = nearest_of(render), width = 2 * (double)ray[0];
    const double slope = hypot(render->whole[0], render->whole[1]) * (double)ray[0];
    if (reach == 0)
        return 0;
    if (render->space.depth[1] > 0)
        return reach / width;
    return nearest > 2 * reach ? (1 + slope) * reach / (nearest - reach) / width : INFINITY;
}

/* Reports whether the picture has to be drawn at once: a result continues from tile to tile or
 * from frame to frame, or depends on one point of the picture. */
static bool is_whole(const Render *render)
{
    const SceneIndirect *in = &render->scene->indirect;
    const bool planes = render->gpu_scene.plane_count > 0,
               shown = reach_of(render) > 0 || in->bounces > 0;
    return indirect_keeps(render) || indirect_is_repeated(render) || indirect_moving(render) ||
           indirect_shows(render, "visibility") || (planes && shown);
}

int indirect_margin(const Render *render)
{
    const double off = 2; /* rays begin off their pixel's center */
    const double reach = reach_of(render),
                 pixels = is_whole(render) ? INFINITY : pixels_of(render, reach);
    const double margin = ceil(pixels + (reach > 0 ? off : 0)) + pass_smooth_reach(render);
    return margin <= MARGIN_MOST ? (int)margin : AT_ONCE;
}
