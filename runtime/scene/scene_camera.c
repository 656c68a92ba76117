/* Where the picture is taken from. */
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene/scene_part.h"
#include <math.h>
#include <string.h>

#define RADIANS (3.14159265358979323846 / 180)

SceneAim scene_camera_aim(SceneCamera *camera)
{
    double up[3];
    for (int i = 0; i < 3; i++) {
        camera->back[i] = camera->position[i] - camera->target[i];
        up[i] = camera->upright[i];
    }
    const bool looks = scene_vector_normalize(camera->back);
    const bool upright = scene_vector_normalize(up);
    scene_vector_cross(up, camera->back, camera->right);
    const bool stands = scene_vector_dot(camera->right, camera->right) > 1e-18 &&
                        scene_vector_normalize(camera->right);
    scene_vector_cross(camera->back, camera->right, camera->up);
    return !looks ? SCENE_AIM_view : upright && stands ? SCENE_AIM_fine : SCENE_AIM_up;
}

static void look(SceneReader *r, const SceneThing *thing, const int params[3], SceneCamera *camera)
{
    scene_thing_vector(thing, params[0], camera->position);
    scene_thing_vector(thing, params[1], camera->target);
    scene_thing_vector(thing, params[2], camera->upright);
    const SceneAim aim = scene_camera_aim(camera);
    if (aim == SCENE_AIM_view)
        diag_add(r->session, scene_thing_span(thing, params[1]), DIAG_no_direction,
                 "the way from position to target");
    else if (aim == SCENE_AIM_up)
        diag_add(r->session, scene_thing_span(thing, params[2]), DIAG_no_direction,
                 "up, seen along the view,");
    r->fine &= aim == SCENE_AIM_fine;
}

/* How far behind the camera's own plane the parallel through a corner of the picture meets a
 * plane. */
static double behind(const Scene *scene, const SceneCamera *camera, const SceneMatrix *plane,
                     int corner)
{
    const double shorter = scene->width < scene->height ? scene->width : scene->height,
                 *m = plane->m;
    const double right = (corner & 1 ? 1 : -1) * camera->half * scene->width / shorter;
    const double up = (corner & 2 ? 1 : -1) * camera->half * scene->height / shorter;
    double normal[3], from[3];
    scene_vector_cross(m, m + 4, normal);
    scene_vector_normalize(normal);
    for (int i = 0; i < 3; i++)
        from[i] = m[12 + i] - camera->position[i] - right * camera->right[i] - up * camera->up[i];
    const double facing = scene_vector_dot(normal, camera->back);
    return fabs(facing) > 1e-6 ? scene_vector_dot(normal, from) / facing : -INFINITY;
}

bool scene_camera_sees_plane(const Scene *scene, const SceneCamera *camera,
                             const SceneMatrix *plane)
{
    for (int corner = 0; camera->kind == SCENE_Orthographic && corner < 4; corner++)
        if (behind(scene, camera, plane, corner) > 0)
            return false;
    return true;
}

void scene_camera_read(SceneReader *r, Tree *tree)
{
    SceneThing thing;
    SceneCamera *camera = &r->scene->camera;
    if (!tree)
        scene_thing_default(r, SCENE_SORT_camera, &thing);
    else if (!scene_thing_read(r, tree, SCENE_SORT_camera, &thing))
        return;
    camera->kind = thing.kind;
    if (thing.kind == SCENE_Perspective) {
        look(r, &thing,
             (const int[]){S_Perspective_position, S_Perspective_target, S_Perspective_up}, camera);
        camera->half = tan(scene_thing_number(&thing, S_Perspective_angle) / 2 * RADIANS);
        camera->near = scene_thing_number(&thing, S_Perspective_near);
    } else {
        look(r, &thing,
             (const int[]){S_Orthographic_position, S_Orthographic_target, S_Orthographic_up},
             camera);
        camera->half = scene_thing_number(&thing, S_Orthographic_size) / 2;
        camera->depth = scene_thing_number(&thing, S_Orthographic_depth);
    }
}
