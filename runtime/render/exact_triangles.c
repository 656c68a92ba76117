/* Corners go to the world in double. Their middle is known after a first turn over all of them; a second writes what they are from there. */
#include "runtime/render/exact_triangles.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>

/* Shapes of meshes, made when the first object of each is met; those of files are borrowed. */
typedef struct {
    const Scene *scene;
    const Cache *cache;
    Shape *shapes;
    bool *made;
} Shapes;

static bool shapes_open(const Scene *scene, const Cache *cache, Shapes *shapes)
{
    const size_t count = (size_t)cache->mesh_count + 1;
    *shapes = (Shapes){scene, cache, calloc(count, sizeof *shapes->shapes), calloc(count, sizeof *shapes->made)};
    return shapes->shapes && shapes->made;
}

static void shapes_close(Shapes *shapes)
{
    for (int i = 0; shapes->made && shapes->shapes && i < shapes->cache->mesh_count; i++)
        if (shapes->made[i])
            shape_free(&shapes->shapes[i]);
    free(shapes->shapes);
    free(shapes->made);
}

/* Of an object that is opaque; NULL: memory ran out. */
static const Shape *shape_of(Shapes *shapes, const CachePlace *place)
{
    const SceneObject *object = &shapes->scene->objects[place->object];
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

typedef struct {
    double low[3], high[3];
} Range;

static void add_range(const Shape *shape, const SceneMatrix *matrix, Range *range)
{
    double world[3];
    for (int i = 0; i < shape->index_count; i++) {
        to_world(matrix, shape->vertices[shape->indices[i]].position, world);
        for (int k = 0; k < 3; k++) {
            range->low[k] = fmin(range->low[k], world[k]);
            range->high[k] = fmax(range->high[k], world[k]);
        }
    }
}

static void add_triangles(const Shape *shape, const SceneMatrix *matrix, ExactTriangles *made)
{
    double world[3];
    for (int i = 0; i < shape->index_count; i++) {
        float *corner = made->corners[made->count + i / 3][i % 3];
        to_world(matrix, shape->vertices[shape->indices[i]].position, world);
        for (int k = 0; k < 3; k++)
            corner[k] = (float)(world[k] - made->origin[k]);
    }
    made->count += shape->index_count / 3;
}

static void set_origin(const Range *range, ExactTriangles *made)
{
    for (int k = 0; k < 3; k++) {
        made->origin[k] = (range->low[k] + range->high[k]) / 2;
        made->reach = fmax(made->reach, (range->high[k] - range->low[k]) / 2);
    }
}

static bool make(Shapes *shapes, ExactTriangles *made)
{
    const Cache *cache = shapes->cache;
    Range range = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    size_t count = 0;
    for (int i = 0; i < cache->place_count; i++) {
        const Shape *shape = cache->places[i].transparent ? NULL : shape_of(shapes, &cache->places[i]);
        if (shape)
            add_range(shape, &shapes->scene->objects[cache->places[i].object].world_from_local, &range);
        else if (!cache->places[i].transparent)
            return false;
        count += shape ? (size_t)shape->index_count / 3 : 0;
    }
    made->corners = count <= INT_MAX / 9 ? malloc(count * sizeof *made->corners + 1) : NULL;
    if (!made->corners)
        return false;
    if (count)
        set_origin(&range, made);
    for (int i = 0; i < cache->place_count; i++)
        if (!cache->places[i].transparent)
            add_triangles(shape_of(shapes, &cache->places[i]),
                          &shapes->scene->objects[cache->places[i].object].world_from_local, made);
    return true;
}

bool exact_triangles_make(const Scene *scene, const Cache *cache, ExactTriangles *made)
{
    Shapes shapes;
    *made = (ExactTriangles){.reach = 0};
    const bool done = shapes_open(scene, cache, &shapes) && make(&shapes, made);
    shapes_close(&shapes);
    if (!done)
        exact_triangles_free(made);
    return done;
}

void exact_triangles_free(ExactTriangles *triangles)
{
    free(triangles->corners);
    *triangles = (ExactTriangles){.reach = 0};
}
