/* Shares meshes between displaced copies. Copies of random sizes would each need a mesh, since a
 * height is a length in world space: in the own space of a copy of half the size it is twice as
 * high. If the height is bounded, and a function of object space, copies of similar size share
 * the mesh of the middle size. Heights then have an error by the difference in size, at most
 * SCENE_DETAIL_ERROR of a pixel.
 *
 *     Heights of 0.3 at 20 pixels per unit, 6 pixels: sizes may differ by 1 / 48 from the
 *     middle; intervals of 1 / 32 share a mesh
 *
 * A height that depends on the world position differs on each copy: each has a mesh, with few
 * triangles if the copy is small. */
#include "runtime/tessellate/scene_displacement.h"
#include "runtime/scene/scene_displacer.h"
#include "runtime/tessellate/scene_fine.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/tessellate/scene_solid.h"
#include <math.h>

/* area of an equilateral triangle with edges of 1: sqrt(3) / 4 */
static const double triangle_area = 0.43301270189221932;
static const double sphere_area = 12.566370614359172; /* area of a sphere with radius 1 */
static const double widest_share = .5, narrowest_share = 1e-6;

static int64_t triangles_of(const Scene *scene, int i)
{
    const SceneObject *object = &scene->objects[i];
    return scene->displacer->bases[i].kind != SCENE_Plane ? scene->displaced_triangles
           : object->kind == SCENE_Mesh ? scene->meshes[object->mesh].shape.index_count / 3
                                        : scene_solid_triangles(object);
}

static void choose_steps(const SceneDetail *detail, SceneObject *object)
{
    const SceneBall ball = scene_detail_ball(object, NULL);
    const double unit = scene_detail_unit(detail, &object->world_from_local, &ball, 0);
    const double radius = object->numbers[0] * scene_detail_stretch(&object->world_from_local);
    object->numbers[scene_detail_number(object->kind)] =
        scene_detail_steps(object->kind, radius * unit);
}

void scene_fine_look(Scene *scene, int width, int height)
{
    SceneDisplacer *by = scene->displacer;
    scene_detail_find(scene, (int[]){width, height}, &by->detail);
    for (int i = 0; i < scene->object_count; i++)
        if (scene->objects[i].adapts && by->bases[i].kind == SCENE_Plane)
            choose_steps(&by->detail, &scene->objects[i]);
}

void scene_fine_choose(Scene *scene, Arena *arena)
{
    SceneDisplacer *by = scene->displacer;
    int64_t triangles = 0;
    for (int i = 0; i < scene->object_count; i++)
        triangles += triangles_of(scene, i);
    if (triangles <= SCENE_FINE_TRIANGLES)
        return;
    by->balls = ARENA_ARRAY(arena, SceneBall, scene->mesh_count + 1);
    for (int i = 0; i < scene->mesh_count; i++)
        by->balls[i] =
            scene_detail_ball(&(SceneObject){.kind = SCENE_Mesh}, &scene->meshes[i].shape);
    by->bounds = ARENA_ARRAY(arena, double, scene->material_count + 1);
    for (int i = 0; i < scene->material_count; i++) {
        const SceneMaterial *of = &scene->materials[i];
        const bool fixed =
            by->moves[i] == MATC_MOVES_none || matc_has_volume(of->document, of->index);
        by->bounds[i] =
            fixed ? INFINITY : scene_displaced_bound(of->document, of->index, &by->options);
    }
    scene_fine_look(scene, scene->width, scene->height);
}

/* Chooses the interval of sizes whose middle has an error below the limit; the error is `height`
 * times the relative difference of sizes. */
static void choose_share(const SceneMatrix *matrix, double height, SceneFineness *fine)
{
    const double *m = matrix->m;
    double size = 0;
    for (int i = 0; i < 3; i++)
        size += vec3_dot(&m[4 * i], &m[4 * i]);
    const double length = log(size / 3) / 2, most = 2 * log1p(SCENE_DETAIL_ERROR / height);
    fine->share = exp2(floor(log2(fmin(most, widest_share))));
    if (!(fine->share >= narrowest_share)) {
        fine->share = 0;
        return;
    }
    fine->number = rint(length / fine->share) + 0.;
    fine->scale = exp(fine->number * fine->share - length);
}

SceneFineness scene_fine_of(const Scene *scene, const SceneObject *before)
{
    const SceneDisplacer *by = scene->displacer;
    SceneFineness fine = {.triangles = scene->displaced_triangles, .scale = 1};
    const double bound = by->bounds ? by->bounds[before->material] : INFINITY;
    if (!isfinite(bound) || scene->displaced_level || scene->displaced_pixels > 0 ||
        scene_displaced_by_driver(by->method, scene->displaced_pixels))
        return fine;
    const SceneBall ball =
        before->kind == SCENE_Mesh ? by->balls[before->mesh] : scene_detail_ball(before, NULL);
    const double stretch = scene_detail_stretch(&before->world_from_local);
    const double unit = scene_detail_unit(&by->detail, &before->world_from_local, &ball, bound);
    const double pixels = ball.radius * stretch * unit / SCENE_DETAIL_EDGE;
    while (fine.triangles / 4 >= SCENE_FINE_MIN &&
           fine.triangles / 4 >= sphere_area * pixels * pixels / triangle_area)
        fine.triangles /= 4;
    if (before->adapts)
        fine.steps = scene_detail_steps(before->kind, before->numbers[0] * stretch * unit);
    if (by->moves[before->material] == MATC_MOVES_local && isfinite(unit))
        choose_share(&before->world_from_local, bound * unit, &fine);
    return fine;
}
