/* Reads the camera's motion. */
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene_reader/scene_part.h"
#include <math.h>

#define RADIANS (3.14159265358979323846 / 180)

enum { MIN_KEYS = 2 };

static bool fault(SceneReader *r, Span span, const char *what)
{
    diag_add(r->session, span, DIAG_scene_path, what);
    return r->fine = false;
}

static bool read_turntable(SceneReader *r, const SceneNodeDesc *desc, SceneMotion *motion)
{
    motion->frames = (int)scene_node_number(desc, S_Turntable_frames);
    motion->angle = scene_node_number(desc, S_Turntable_degrees) * RADIANS;
    scene_node_vector(desc, S_Turntable_axis, motion->axis);
    if (vec3_normalize(motion->axis))
        return true;
    diag_add(r->session, scene_node_span(desc, S_Turntable_axis), DIAG_no_direction, "axis");
    return r->fine = false;
}

static bool read_key(SceneReader *r, Tree *tree, SceneMotion *motion, size_t *capacity)
{
    SceneNodeDesc desc;
    SceneKey key;
    if (!scene_node_read(r, tree, SCENE_SORT_key, &desc))
        return false;
    key.time = scene_node_number(&desc, S_Key_time);
    scene_node_vector(&desc, S_Key_position, key.position);
    scene_node_vector(&desc, S_Key_target, key.target);
    if (motion->key_count && key.time <= motion->keys[motion->key_count - 1].time)
        return fault(r, scene_node_span(&desc, S_Key_time), "the times of keys rise");
    size_t count = (size_t)motion->key_count;
    ARENA_PUSH(r->session->arena, motion->keys, count, *capacity, key);
    motion->key_count = (int)count;
    return true;
}

static bool read_path(SceneReader *r, const SceneNodeDesc *desc, SceneMotion *motion)
{
    const Tree *keys = scene_node_given(desc, S_Path_keys);
    size_t capacity = 0;
    motion->frames = (int)scene_node_number(desc, S_Path_frames);
    for (uint32_t i = 0; keys && i < keys->count; i++)
        if (!read_key(r, keys->items[i], motion, &capacity))
            return false;
    return motion->key_count >= MIN_KEYS ||
           fault(r, scene_node_span(desc, S_Path_keys), "a path has two keys or more");
}

/* Checks all frames: on a path the camera may coincide with its target, or look straight up. */
static void check_frames(SceneReader *r, const Tree *tree)
{
    SceneMotion *motion = &r->scene->motion;
    SceneCamera camera;
    for (int frame = 0; frame < motion->frames; frame++)
        if (!scene_motion_camera(r->scene, frame, motion->frames, &camera)) {
            fault(r, tree->span, "the camera has no direction in some frame, or up is along it");
            return;
        }
}

void scene_motion_read(SceneReader *r, Tree *tree)
{
    SceneNodeDesc desc;
    SceneMotion *motion = &r->scene->motion;
    if (!scene_node_read(r, tree, SCENE_SORT_motion, &desc))
        return;
    motion->kind = desc.kind;
    if ((desc.kind == SCENE_Turntable ? read_turntable : read_path)(r, &desc, motion) && r->fine)
        check_frames(r, tree);
}
