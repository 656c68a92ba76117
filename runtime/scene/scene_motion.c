/* Camera motion by frame. A path is a cubic Hermite spline through its keys: the slope at a key
 * is that of the chord between the adjacent keys, at an end that to the single adjacent key; so
 * two keys are joined by a straight line.
 *
 *     x is 0, 1, 4 at the times 0, 1, 2: the slopes are 1, 2, 3, and at the time 1/2
 *     x = (1 + 2 t) (1 - t)^2 0 + t (1 - t)^2 1 + t^2 (3 - 2 t) 1 + t^2 (t - 1) 2
 *       = 1/8 + 1/2 - 1/4 = 3/8 */
#include "runtime/scene/scene_matrix.h"
#include <math.h>

enum { POINT = 3 };

/* Rodrigues' formula: rotates v by an angle about a unit vector. */
static void turn(const double axis[3], double angle, double v[3])
{
    double across[3];
    const double along = vec3_dot(axis, v) * (1 - cos(angle));
    vec3_cross(axis, v, across);
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

/* Returns a component of key i: of its position, then of its target. */
static double number(const SceneMotion *motion, int i, int component)
{
    const SceneKey *key = &motion->keys[i];
    return component < POINT ? key->position[component] : key->target[component - POINT];
}

static double slope(const SceneMotion *motion, int i, int component)
{
    const int before = i > 0 ? i - 1 : i, after = i + 1 < motion->key_count ? i + 1 : i;
    return (number(motion, after, component) - number(motion, before, component)) /
           (motion->keys[after].time - motion->keys[before].time);
}

static double at_time(const SceneMotion *motion, double time, int component)
{
    /* Binary search for the last key not after `time`, since paths may have many keys. */
    int i = 0, end = motion->key_count - 1;
    while (i + 1 < end) {
        const int middle = (i + end) / 2;
        if (motion->keys[middle].time <= time)
            i = middle;
        else
            end = middle;
    }
    const double length = motion->keys[i + 1].time - motion->keys[i].time,
                 t = (time - motion->keys[i].time) / length;
    return (1 + 2 * t) * (1 - t) * (1 - t) * number(motion, i, component) +
           t * (1 - t) * (1 - t) * length * slope(motion, i, component) +
           t * t * (3 - 2 * t) * number(motion, i + 1, component) +
           t * t * (t - 1) * length * slope(motion, i + 1, component);
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
