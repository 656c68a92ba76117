/* Any point near the camera is precise enough as origin. The chosen point is named by the
 * document: the position of an infinite plane, or else the most frequent position of top-level
 * objects and groups. A scene that is moved as a whole, by a group around the scene or object by
 * object, then gets the same coordinates as before, hence the same floats and the same picture.
 * If no such point is near, the origin is the camera's own position. */
#include "runtime/scene/scene_origin.h"
#include "compiler/base/memory.h"
#include "runtime/scene/scene_displacer.h"
#include "runtime/scene/scene_patches.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The distances below are multiples of the camera's distance from its target, or of half the
 * width of an orthographic picture. At these distances a float has an error of 1e-6 and 6e-5 of
 * that unit. */
/* distance from the world's origin below which a camera keeps that origin */
static const double near_reach = 16;
/* max distance of a camera from the origin before the origin moves */
static const double travel_reach = 1024;

enum { POINT = 3 };

static double scale_of(const SceneCamera *camera)
{
    double square = 0;
    for (int i = 0; i < POINT; i++)
        square += pow(camera->position[i] - camera->target[i], 2);
    return camera->kind == SCENE_Orthographic ? fmax(sqrt(square), camera->half) : sqrt(square);
}

static bool is_within(const double at[3], const double around[3], double reach)
{
    double most = 0;
    for (int i = 0; i < POINT; i++)
        most = fmax(most, fabs(at[i] - around[i]));
    return most <= reach;
}

/* Sorts by position, then by order in the document. */
static int by_place(const void *a, const void *b)
{
    const SceneRoot *x = a, *y = b;
    for (int i = 0; i < POINT; i++)
        if (x->at[i] != y->at[i])
            return x->at[i] < y->at[i] ? -1 : 1;
    return (x->number > y->number) - (x->number < y->number);
}

static bool same_place(const SceneRoot *a, const SceneRoot *b)
{
    return a->at[0] == b->at[0] && a->at[1] == b->at[1] && a->at[2] == b->at[2];
}

/* Returns the most frequent position; of equally frequent ones the first in the document. */
static const SceneRoot *most_frequent(SceneRoot *roots, int count)
{
    const SceneRoot *best = NULL;
    int most = 0;
    qsort(roots, (size_t)count, sizeof *roots, by_place);
    for (int i = 0, end; i < count; i = end) {
        for (end = i + 1; end < count && same_place(&roots[end], &roots[i]);)
            end++;
        if (end - i > most || (end - i == most && roots[i].number < best->number)) {
            best = &roots[i];
            most = end - i;
        }
    }
    return best;
}

static void choose(const Scene *scene, const SceneCamera *camera, double origin[3])
{
    const double reach = near_reach * scale_of(camera);
    SceneRoot *near = malloc(((size_t)scene->root_count + 1) * sizeof *near);
    const SceneRoot *best = NULL;
    int count = 0;
    if (!near)
        memory_exhausted();
    for (int i = 0; i < scene->root_count; i++)
        if (is_within(scene->roots[i].at, camera->position, reach))
            near[count++] = scene->roots[i];
    for (int i = 0; i < count && !best; i++)
        best = near[i].plane ? &near[i] : NULL;
    best = best ? best : most_frequent(near, count);
    memcpy(origin, best ? best->at : camera->position, POINT * sizeof *origin);
    free(near);
}

static void subtract(const double by[3], double at[3])
{
    for (int i = 0; i < POINT; i++)
        at[i] -= by[i];
}

static void shift_camera(const double by[3], SceneCamera *camera)
{
    subtract(by, camera->position);
    subtract(by, camera->target);
}

static void shift(Scene *scene, const double by[3])
{
    shift_camera(by, &scene->camera);
    for (int i = 0; i < scene->motion.key_count; i++) {
        subtract(by, scene->motion.keys[i].position);
        subtract(by, scene->motion.keys[i].target);
    }
    for (int i = 0; i < scene->root_count; i++)
        subtract(by, scene->roots[i].at);
    for (int i = 0; i < scene->light_count; i++)
        subtract(by, scene->lights[i].position);
    for (int i = 0; i < scene->object_count; i++)
        subtract(by, scene->objects[i].world_from_local.m + 12);
    for (int i = 0; i < scene->mesh_count; i++)
        if (scene->meshes[i].patches)
            subtract(by, scene->meshes[i].patches->world_from_local.m + 12);
    SceneDisplacer *displacer = scene->displacer;
    for (int i = 0; displacer && i < displacer->seen.count; i++)
        shift_camera(by, &displacer->seen.cameras[i]);
    for (int i = 0; displacer && i < displacer->detail.eye_count; i++)
        subtract(by, displacer->detail.eyes[i].center);
    for (int i = 0; i < POINT; i++)
        scene->origin[i] += by[i];
}

void scene_origin_find(Scene *scene)
{
    double origin[POINT];
    const double world[POINT] = {0};
    if (is_within(scene->camera.position, world, near_reach * scale_of(&scene->camera)))
        return;
    choose(scene, &scene->camera, origin);
    shift(scene, origin);
}

bool scene_origin_used(const Scene *scene)
{
    return scene->origin[0] != 0 || scene->origin[1] != 0 || scene->origin[2] != 0;
}

bool scene_origin_follow(Scene *scene, SceneCamera *camera)
{
    double origin[POINT];
    const double here[POINT] = {0};
    if (is_within(camera->position, here, travel_reach * scale_of(camera)))
        return false;
    choose(scene, camera, origin);
    shift(scene, origin);
    if (camera != &scene->camera)
        shift_camera(origin, camera);
    return true;
}

void scene_origin_to(const Scene *scene, const double world[3], double at[3])
{
    for (int i = 0; i < POINT; i++)
        at[i] = world[i] - scene->origin[i];
}

void scene_origin_from(const Scene *scene, const double at[3], double world[3])
{
    for (int i = 0; i < POINT; i++)
        world[i] = at[i] + scene->origin[i];
}
