/* The axes of a camera, and a test for planes behind it. */
#include "runtime/scene/scene_matrix.h"
#include <math.h>

SceneAim scene_camera_aim(SceneCamera *camera)
{
    double up[3];
    for (int i = 0; i < 3; i++) {
        camera->back[i] = camera->position[i] - camera->target[i];
        up[i] = camera->upright[i];
    }
    const bool looks = vec3_normalize(camera->back);
    const bool upright = vec3_normalize(up);
    vec3_cross(up, camera->back, camera->right);
    const bool stands =
        vec3_dot(camera->right, camera->right) > 1e-18 && vec3_normalize(camera->right);
    vec3_cross(camera->back, camera->right, camera->up);
    return !looks ? SCENE_AIM_view : upright && stands ? SCENE_AIM_fine : SCENE_AIM_up;
}

/* Returns how far behind the camera's plane the parallel ray through a corner of the picture
 * hits a plane. */
static double behind(const Scene *scene, const SceneCamera *camera, const SceneMatrix *plane,
                     int corner)
{
    const double shorter = scene->width < scene->height ? scene->width : scene->height,
                 *m = plane->m;
    const double right = (corner & 1 ? 1 : -1) * camera->half * scene->width / shorter;
    const double up = (corner & 2 ? 1 : -1) * camera->half * scene->height / shorter;
    double normal[3], from[3];
    vec3_cross(m, m + 4, normal);
    vec3_normalize(normal);
    for (int i = 0; i < 3; i++)
        from[i] = m[12 + i] - camera->position[i] - right * camera->right[i] - up * camera->up[i];
    const double facing = vec3_dot(normal, camera->back);
    return fabs(facing) > 1e-6 ? vec3_dot(normal, from) / facing : -INFINITY;
}

bool scene_camera_sees_plane(const Scene *scene, const SceneCamera *camera,
                             const SceneMatrix *plane)
{
    for (int corner = 0; camera->kind == SCENE_Orthographic && corner < 4; corner++)
        if (behind(scene, camera, plane, corner) > 0)
            return false;
    return true;
}
