/* Triangles of exact shadows. Corners are transformed to world space in double. A first loop
 * over all objects finds their center; a second one writes the corners relative to it. */
#include "runtime/exact/exact_triangles.h"
#include "runtime/tessellate/scene_solid.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>

/* Shapes of meshes, made for the first object of each mesh; those from files are borrowed. */
typedef struct {
    const Scene *scene;
    const GpuScene *gpu_scene;
    Shape *shapes;
    bool *made;
} Shapes;

static bool shapes_open(const Scene *scene, const GpuScene *gpu_scene, Shapes *shapes)
{
    const size_t count = (size_t)gpu_scene->mesh_count + 1;
    *shapes = (Shapes){scene, gpu_scene, calloc(count, sizeof *shapes->shapes),
                       calloc(count, sizeof *shapes->made)};
    return shapes->shapes && shapes->made;
}

static void shapes_close(Shapes *shapes)
{
    for (int i = 0; shapes->made && shapes->shapes && i < shapes->gpu_scene->mesh_count; i++)
        if (shapes->made[i])
            shape_free(&shapes->shapes[i]);
    free(shapes->shapes);
    free(shapes->made);
}

/* Returns the shape of an object; NULL: out of memory. */
static const Shape *shape_of(Shapes *shapes, int number)
{
    const GpuScenePlace *place = &shapes->gpu_scene->places[shapes->gpu_scene->place_of[number]];
    const SceneObject *object = &shapes->scene->objects[number];
    if (object->kind == SCENE_Mesh)
        return &shapes->scene->meshes[object->mesh].shape;
    if (!shapes->made[place->mesh])
        shapes->made[place->mesh] = scene_solid(object, &shapes->shapes[place->mesh]);
    return shapes->made[place->mesh] ? &shapes->shapes[place->mesh] : NULL;
}

static void to_world(const SceneMatrix *matrix, const float local[3], double world[3])
{
    const double *m = matrix->m;
    for (int i = 0; i < 3; i++)
        world[i] = m[i] * local[0] + m[4 + i] * local[1] + m[8 + i] * local[2] + m[12 + i];
}

/* Grid to which the center is rounded, as a share of the reach rounded to a power of two. */
static const double grid = 1.0 / 32;

/* Measures an object's box. False: out of memory. */
static bool measure(Shapes *shapes, ExactObject *object)
{
    const Shape *shape = shape_of(shapes, object->object);
    const SceneMatrix *matrix = &shapes->scene->objects[object->object].world_from_local;
    double world[3];
    object->box = (ExactBox){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    object->count = shape ? shape->index_count / 3 : 0;
    for (int i = 0; i < 3 * object->count; i++) {
        to_world(matrix, shape->vertices[shape->indices[i]].position, world);
        for (int k = 0; k < 3; k++) {
            object->box.low[k] = fmin(object->box.low[k], world[k]);
            object->box.high[k] = fmax(object->box.high[k], world[k]);
        }
    }
    return shape;
}

/* Sets the origin to the center of all boxes, rounded to a grid. Boxes of 0 to 2 and of 0 to 4:
 * their center is 2, their reach 2, the grid 1/16. If the second grows to 4.01, the origin stays
 * 2. */
static void set_origin(ExactTriangles *made)
{
    ExactBox all = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    double widest = 0;
    for (int i = 0; i < made->object_count; i++)
        for (int k = 0; k < 3; k++) {
            all.low[k] = fmin(all.low[k], made->objects[i].box.low[k]);
            all.high[k] = fmax(all.high[k], made->objects[i].box.high[k]);
        }
    for (int k = 0; k < 3; k++)
        widest = fmax(widest, all.high[k] - all.low[k]);
    const double step = widest > 0 ? exp2(floor(log2(widest / 2))) * grid : 1;
    made->reach = 0;
    for (int k = 0; k < 3; k++) {
        made->origin[k] = made->count ? round((all.low[k] + all.high[k]) / 2 / step) * step : 0;
        if (made->count)
            made->reach = fmax(made->reach,
                               fmax(all.high[k] - made->origin[k], made->origin[k] - all.low[k]));
    }
}

static bool measure_all(Shapes *shapes, ExactTriangles *made)
{
    const GpuScene *gpu_scene = shapes->gpu_scene;
    size_t count = 0;
    made->objects = calloc((size_t)gpu_scene->place_count + 1, sizeof *made->objects);
    for (int i = 0; made->objects && i < gpu_scene->place_count; i++) {
        ExactObject *object = &made->objects[made->object_count];
        if (!exact_triangles_have(&gpu_scene->places[i]))
            continue;
        made->object_count++;
        made->opaque_count += !gpu_scene->places[i].transparent;
        *object = (ExactObject){.object = gpu_scene->places[i].object, .first = (int)count};
        count += measure(shapes, object) ? (size_t)object->count : INT_MAX;
        if (count > INT_MAX / sizeof(ExactCorners))
            return false;
    }
    made->count = (int)count;
    return made->objects;
}

bool exact_triangles_have(const GpuScenePlace *place) { return !place->transparent || place->even; }

bool exact_triangles_make(const Scene *scene, const GpuScene *gpu_scene, ExactTriangles *made)
{
    Shapes shapes;
    *made = (ExactTriangles){.reach = 0};
    const bool done = shapes_open(scene, gpu_scene, &shapes) && measure_all(&shapes, made);
    shapes_close(&shapes);
    if (done)
        set_origin(made);
    else
        exact_triangles_free(made);
    return done;
}

bool exact_triangles_move(const Scene *scene, const GpuScene *gpu_scene, const int range[2],
                          ExactTriangles *triangles)
{
    Shapes shapes;
    bool done = shapes_open(scene, gpu_scene, &shapes);
    for (int i = range[0]; done && i < range[1]; i++)
        done = measure(&shapes, &triangles->objects[i]);
    shapes_close(&shapes);
    if (done)
        set_origin(triangles);
    return done;
}

/* Returns the transmittance of a component; 0 or 1 if shadows are alpha-tested. */
static float share_of(const Scene *scene, const GpuScenePlace *place, int component)
{
    const float *t = place->even;
    if (!place->transparent)
        return 0;
    return scene->shadow_colored ? fminf(fmaxf(t[component], 0), 1) : t[0] + t[1] + t[2] > 1.5f;
}

static void put_shares(const Scene *scene, const GpuScenePlace *place, int count,
                       ExactCorners *corners)
{
    for (int i = 0; i < 3 * count; i++)
        corners[i / 3][i % 3][3] = share_of(scene, place, i % 3);
}

static void put_corners(const Shape *shape, const SceneMatrix *matrix, const double origin[3],
                        ExactCorners *corners)
{
    double world[3];
    for (int i = 0; i < shape->index_count; i++) {
        to_world(matrix, shape->vertices[shape->indices[i]].position, world);
        for (int k = 0; k < 3; k++)
            corners[i / 3][i % 3][k] = (float)(world[k] - origin[k]);
    }
}

bool exact_triangles_corners(const Scene *scene, const GpuScene *gpu_scene,
                             const ExactTriangles *triangles, const int range[2],
                             ExactCorners *corners)
{
    Shapes shapes;
    bool done = shapes_open(scene, gpu_scene, &shapes);
    for (int i = range[0]; done && i < range[1]; i++) {
        const ExactObject *object = &triangles->objects[i];
        const Shape *shape = shape_of(&shapes, object->object);
        ExactCorners *to = corners + object->first - triangles->objects[range[0]].first;
        done = shape != NULL;
        if (done) {
            put_corners(shape, &scene->objects[object->object].world_from_local, triangles->origin,
                        to);
            put_shares(scene, &gpu_scene->places[gpu_scene->place_of[object->object]],
                       object->count, to);
        }
    }
    shapes_close(&shapes);
    return done;
}

void exact_triangles_free(ExactTriangles *triangles)
{
    free(triangles->objects);
    *triangles = (ExactTriangles){.reach = 0};
}
