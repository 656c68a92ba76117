/* How far around a tile indirect light looks at what the picture shows, so that a tile with so much
 * around it has what the whole picture has. */
#include "runtime/frame/frame.h"
#include "runtime/indirect/indirect_methods.h"
#include "runtime/indirect/rays/pass_rays.h"
#include "runtime/indirect/filter/pass_smooth.h"
#include "runtime/indirect/voxels/voxels.h"
#include <math.h>

/* Pixels of a margin: beyond that a picture is drawn at once. */
enum { MARGIN_MOST = 192, AT_ONCE = -1 };

/* How far rays are followed through the picture, or take light from it, in the world's units. */
static double reach_of(const Render *render)
{
    const unsigned reads = indirect_method(render)->reads;
    if (reads & INDIRECT_READS_radiance)
        return reads & INDIRECT_READS_near ? indirect_near(render) : 0;
    const bool picture = !indirect_reads_voxels(render) || render->scene->indirect.bounces > 0;
    return picture ? voxel_grid_radius(render->scene, &render->cache) : 0;
}

/* The least distance of an object from the eye, along the way in which it looks: of the corners of
 * a box around all. */
static double nearest_of(const Render *render)
{
    const VoxelGrid grid = voxel_grid(render->scene, &render->cache);
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

/* Greatest length in pixels of a ray of length `reach` from a visible surface: at a distance of d,
 * with s the slope of the ray to the picture's corner, an end is seen up to (1 + s) reach / (d -
 * reach) from the origin. Infinite: the surface may be too near. */
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

/* Nothing continues from tile to tile or from frame to frame, or depends on one place of the
 * picture. */
static bool is_whole(const Render *render)
{
    const SceneIndirect *in = &render->scene->indirect;
    const bool planes = render->cache.plane_count > 0,
               shown = reach_of(render) > 0 || in->bounces > 0;
    return indirect_keeps(render) || indirect_is_repeated(render) || indirect_moving(render) ||
           indirect_shows(render, "visibility") || (planes && shown);
}

int indirect_margin(const Render *render)
{
    const double off = 2; /* rays begin beside their pixel's middle */
    const double reach = reach_of(render),
                 pixels = is_whole(render) ? INFINITY : pixels_of(render, reach);
    const double margin = ceil(pixels + (reach > 0 ? off : 0)) + pass_smooth_reach(render);
    return margin <= MARGIN_MOST ? (int)margin : AT_ONCE;
}
