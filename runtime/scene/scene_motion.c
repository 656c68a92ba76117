/* How the camera moves from frame to frame. A path is a cubic Hermite spline through its keys: the
 * slope at a key is that of the chord between its neighbours, at an end that to the one neighbour;
 * so two keys are joined by a straight line.
 *
 *     x is 0, 1, 4 at the times 0, 1, 2: the slopes are 1, 2, 3, and at the time 1/2 x = (1 + 2 t)
 *     (1 - t)^2 0 + t (1 - t)^2 1 + t^2 (3 - 2 t) 1 + t^2 (t - 1) 2 = 1/8 + 1/2 - 1/4 = 3/8 */
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene/scene_part.h"
#include <math.h>

#define RADIANS (3.14159265358979323846 / 180)

enum { LEAST_KEYS = 2, POINT = 3 };

static bool fault(SceneReader *r, Span span, const char *what)
{
    diag_add(r->session, span, DIAG_scene_path, what);
    return r->fine = false;
}

/* -- the camera of a frame */

/* Rodrigues' formula: v turned by an angle around a unit vector. */
static void turn(const double axis[3], double angle, double v[3])
{
    double across[3];
    const double along = scene_vector_dot(axis, v) * (1 - cos(angle));
    scene_vector_cross(axis, v, across);
    for (int i = 0; i < 3; i++)
        v[i] = v[i] * cos(angle) + across[i] * sin(angle) + axis[i] * along;
}

static void turn_camera(const SceneMotion *motion, double share, SceneCamera *camera)
{
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = camera->position[i] - camera->target[i];
    turn(motion->axis, motion->angle * share, from);
    turn(motion->axis, motion->angle * share, camera->upright);
    for (int i = 0; i < 3; i++)
        camera->position[i] = camera->target[i] + from[i];
}

/* A number of key i: of its position, then of its target. */
static double number(const SceneMotion *motion, int i, int lane)
{
    const SceneKey *key = &motion->keys[i];
    return lane < POINT ? key->position[lane] : key->target[lane - POINT];
}

static double slope(const SceneMotion *motion, int i, int lane)
{
    const int before = i > 0 ? i - 1 : i, after = i + 1 < motion->key_count ? i + 1 : i;
    return (number(motion, after, lane) - number(motion, before, lane)) /
           (motion->keys[after].time - motion->keys[before].time);
}

static double at_time(const SceneMotion *motion, double time, int lane)
{
    int i = 0,
        /* a frame may be one of many, as may a key: the last that is not behind `time` */
        end = motion->key_count - 1;
    while (i + 1 < end) {
        const int middle = (i + end) / 2;
        if (motion->keys[middle].time <= time)
            i = middle;
        else
            end = middle;
    }
    const double length = motion->keys[i + 1].time - motion->keys[i].time,
                 t = (time - motion->keys[i].time) / length;
    return (1 + 2 * t) * (1 - t) * (1 - t) * number(motion, i, lane) +
           t * (1 - t) * (1 - t) * length * slope(motion, i, lane) +
           t * t * (3 - 2 * t) * number(motion, i + 1, lane) +
           t * t * (t - 1) * length * slope(motion, i + 1, lane);
}

static void place_camera(const SceneMotion *motion, double share, SceneCamera *camera)
{
    const double first = motion->keys[0].time, last = motion->keys[motion->key_count - 1].time;
    const double time = first + (last - first) * share;
    for (int i = 0; i < POINT; i++) {
        camera->position[i] = at_time(motion, time, i);
        camera->target[i] = at_time(motion, time, POINT + i);
    }
}

bool scene_motion_camera(const Scene *scene, int frame, int frames, SceneCamera *camera)
{
    *camera = scene->camera;
    if (scene->motion.kind == SCENE_Turntable)
        turn_camera(&scene->motion, (double)frame / frames, camera);
    else
        place_camera(&scene->motion, frames > 1 ? (double)frame / (frames - 1) : 0, camera);
    return scene_camera_aim(camera) == SCENE_AIM_fine;
}

/* -- reading */

static bool read_turntable(SceneReader *r, const SceneThing *thing, SceneMotion *motion)
{
    motion->frames = (int)scene_thing_number(thing, S_Turntable_frames);
    motion->angle = scene_thing_number(thing, S_Turntable_degrees) * RADIANS;
    scene_thing_vector(thing, S_Turntable_axis, motion->axis);
    if (scene_vector_normalize(motion->axis))
        return true;
    diag_add(r->session, scene_thing_span(thing, S_Turntable_axis), DIAG_no_direction, "axis");
    return r->fine = false;
}

static bool read_key(SceneReader *r, Tree *tree, SceneMotion *motion, size_t *room)
{
    SceneThing thing;
    SceneKey key;
    if (!scene_thing_read(r, tree, SCENE_SORT_key, &thing))
        return false;
    key.time = scene_thing_number(&thing, S_Key_time);
    scene_thing_vector(&thing, S_Key_position, key.position);
    scene_thing_vector(&thing, S_Key_target, key.target);
    if (motion->key_count && key.time <= motion->keys[motion->key_count - 1].time)
        return fault(r, scene_thing_span(&thing, S_Key_time), "the times of keys rise");
    size_t count = (size_t)motion->key_count;
    ARENA_PUSH(r->session->arena, motion->keys, count, *room, key);
    motion->key_count = (int)count;
    return true;
}

static bool read_path(SceneReader *r, const SceneThing *thing, SceneMotion *motion)
{
    const Tree *keys = scene_thing_given(thing, S_Path_keys);
    size_t room = 0;
    motion->frames = (int)scene_thing_number(thing, S_Path_frames);
    for (uint32_t i = 0; keys && i < keys->count; i++)
        if (!read_key(r, keys->items[i], motion, &room))
            return false;
    return motion->key_count >= LEAST_KEYS ||
           fault(r, scene_thing_span(thing, S_Path_keys), "a path has two keys or more");
}

/* The camera can be lost on the way: where it meets its target, or looks straight up. */
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
    SceneThing thing;
    SceneMotion *motion = &r->scene->motion;
    if (!scene_thing_read(r, tree, SCENE_SORT_motion, &thing))
        return;
    motion->kind = thing.kind;
    if ((thing.kind == SCENE_Turntable ? read_turntable : read_path)(r, &thing, motion) && r->fine)
        check_frames(r, tree);
}
