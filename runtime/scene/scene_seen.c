/* Finds how many pixels a unit of length covers in the picture, at a given distance. Half of the
 * picture's shorter side shows the length `half` times the distance, or with an orthographic
 * camera the length `half`; `half` is a member of SceneCamera.
 *
 *     600 pixels, a view of 90 degrees, distance 10: 300 pixels show the length tan(45 degrees)
 *         times 10 = 10, so a unit covers 30 pixels */
#include "runtime/scene/scene_seen.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>

/* distance factor for triangles out of view, which mirrors and shadows still show */
static const double out_of_view = 8;
/* scale of the picture's bounds: displaced points enter from outside */
static const double rim = 1.1;

void scene_seen_find(const Scene *scene, SceneViewSet *seen)
{
    const int frames = scene->motion.frames,
              count = frames < SCENE_SEEN_CAMERAS ? frames : SCENE_SEEN_CAMERAS;
    const double sides[2] = {scene->width, scene->height};
    seen->shorter = fmin(sides[0], sides[1]);
    seen->count = 0;
    for (int i = 0; i < 2; i++)
        seen->half[i] = sides[i] / seen->shorter;
    for (int i = 0; i < count; i++) {
        const int frame = count > 1 ? (int)((long)i * (frames - 1) / (count - 1)) : 0;
        seen->count += scene_motion_camera(scene, frame, frames, &seen->cameras[seen->count]);
    }
    if (!seen->count)
        seen->cameras[seen->count++] = scene->camera;
}

static double pixels_of(const SceneViewSet *seen, const SceneCamera *camera, const double at[3])
{
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = at[i] - camera->position[i];
    const bool parallel = camera->kind == SCENE_Orthographic;
    const double depth = -vec3_dot(way, camera->back);
    const double distance = parallel ? 1 : fmax(sqrt(vec3_dot(way, way)), camera->near);
    const double reach = rim * camera->half * (parallel ? 1 : depth);
    const bool inside = depth > 0 && fabs(vec3_dot(way, camera->right)) <= reach * seen->half[0] &&
                        fabs(vec3_dot(way, camera->up)) <= reach * seen->half[1];
    return seen->shorter / 2 / (camera->half * distance * (inside ? 1 : out_of_view));
}

double scene_seen_pixels(const SceneViewSet *seen, const double at[3])
{
    double most = 0;
    for (int i = 0; i < seen->count; i++)
        most = fmax(most, pixels_of(seen, &seen->cameras[i], at));
    return most;
}
