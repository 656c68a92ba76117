/* Reads the camera. */
#include "runtime/scene_reader/scene_part.h"
#include <math.h>

#define RADIANS (3.14159265358979323846 / 180)

static void look(SceneReader *r, const SceneNodeDesc *desc, const int params[3],
                 SceneCamera *camera)
{
    scene_node_vector(desc, params[0], camera->position);
    scene_node_vector(desc, params[1], camera->target);
    scene_node_vector(desc, params[2], camera->upright);
    const SceneAim aim = scene_camera_aim(camera);
    if (aim == SCENE_AIM_view)
        diag_add(r->session, scene_node_span(desc, params[1]), DIAG_no_direction,
                 "the vector from position to target");
    else if (aim == SCENE_AIM_up)
        diag_add(r->session, scene_node_span(desc, params[2]), DIAG_no_direction,
                 "up, seen along the view,");
    r->fine &= aim == SCENE_AIM_fine;
}

void scene_camera_read(SceneReader *r, Tree *tree)
{
    SceneNodeDesc desc;
    SceneCamera *camera = &r->scene->camera;
    if (!tree)
        scene_node_default(r, SCENE_SORT_camera, &desc);
    else if (!scene_node_read(r, tree, SCENE_SORT_camera, &desc))
        return;
    camera->kind = desc.kind;
    if (desc.kind == SCENE_Perspective) {
        look(r, &desc,
             (const int[]){S_Perspective_position, S_Perspective_target, S_Perspective_up}, camera);
        camera->half = tan(scene_node_number(&desc, S_Perspective_angle) / 2 * RADIANS);
        camera->near = scene_node_number(&desc, S_Perspective_near);
    } else {
        look(r, &desc,
             (const int[]){S_Orthographic_position, S_Orthographic_target, S_Orthographic_up},
             camera);
        camera->half = scene_node_number(&desc, S_Orthographic_size) / 2;
        camera->depth = scene_node_number(&desc, S_Orthographic_depth);
    }
}
