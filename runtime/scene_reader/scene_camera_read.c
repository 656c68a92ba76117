/* Reads the camera. */
#include "runtime/scene_reader/scene_part.h"
#include <math.h>

#define RADIANS (3.14159265358979323846 / 180)

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
