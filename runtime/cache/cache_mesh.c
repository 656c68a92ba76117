/* Meshes of a cache: of solids, of files, and of surfaces displaced on the GPU. */
#include "runtime/cache/cache.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/tessellate/scene_solid.h"
#include <math.h>

static bool make_mesh_of(GlContext *gl, Cache *cache, const Shape *shape)
{
    if (!mesh_make_of(gl, shape, &cache->meshes[cache->mesh_count]))
        return false;
    cache->boxes[cache->mesh_count++] = cull_box(shape);
    return true;
}

/* Returns a bounding box of all positions to which points may be displaced. */
static CullBox box_of_patches(const SceneMesh *mesh)
{
    CullBox box = cull_box(
        &(Shape){.vertices = mesh->patches->rows, .vertex_count = mesh->patches->row_count});
    for (int k = 0; k < 3; k++) {
        box.low[k] -= mesh->patches->reach[k];
        box.high[k] += mesh->patches->reach[k];
    }
    return box;
}

/* Computes the bounding box of all objects except infinite planes. */
static void find_box(const CacheSource *source, const Cache *cache, double low[3], double high[3])
{
    for (int i = 0; i < cache->place_count; i++) {
        const CullBox *box = &cache->boxes[cache->places[i].mesh];
        const double *m = source->scene->objects[cache->places[i].object].world_from_local.m;
        for (int k = 0; k < 3; k++) {
            double middle = m[12 + k], extent = 0;
            for (int lane = 0; lane < 3; lane++) {
                middle += m[4 * lane + k] * (box->low[lane] + box->high[lane]) / 2;
                extent += fabs(m[4 * lane + k]) * (box->high[lane] - box->low[lane]) / 2;
            }
            low[k] = i ? fmin(low[k], middle - extent) : middle - extent;
            high[k] = i ? fmax(high[k], middle + extent) : middle + extent;
        }
    }
}

enum { GROUNDS_MOST = 8 };

/* Returns the equations of the scene's planes. False if there are too many. */
static bool find_grounds(const CacheSource *source, const Cache *cache,
                         double grounds[GROUNDS_MOST][4])
{
    for (int i = 0; i < cache->plane_count && i < GROUNDS_MOST; i++) {
        const double *m = source->scene->objects[cache->planes[i].object].world_from_local.m;
        vec3_cross(m, m + 4, grounds[i]);
        vec3_normalize(grounds[i]);
        grounds[i][3] = -vec3_dot(grounds[i], m + 12);
    }
    return cache->plane_count <= GROUNDS_MOST;
}

/* Displaces a mesh on the GPU for the view, unless it is up to date. */
static bool displace(const DisplacedView *view, const CacheSource *source, Cache *cache, int mesh)
{
    Displaced *displaced = &cache->displaced[mesh];
    SceneMesh *of = &source->scene->meshes[cache->displaced[mesh].mesh];
    Shape shape;
    if (!displaced_write(displaced, view, &cache->meshes[mesh]))
        return false;
    cache->displaced_anew |= displaced->anew;
    if (!source->triangles || !displaced->anew)
        return true;
    if (!displaced_read(displaced, &cache->meshes[mesh], &shape))
        return false;
    shape_free(&of->shape);
    of->shape = shape;
    return true;
}

/* Makes a mesh that the GPU displaces. The surface may intersect itself and show its back there,
 * so a solid mesh counts as merely closed. */
static bool make_displaced(Store *store, const CacheSource *source, Cache *cache, int number)
{
    GlContext *gl = store_context(store);
    const SceneMesh *from = &source->scene->meshes[number];
    const int mesh = cache->mesh_count;
    if (!mesh_make_captured(gl, &cache->meshes[mesh]))
        return false;
    const ShapeBody body = shape_body(&from->shape);
    cache->meshes[mesh].body = from->patches->torn        ? SHAPE_BODY_none
                               : body == SHAPE_BODY_solid ? SHAPE_BODY_closed
                                                          : body;
    cache->boxes[mesh] = box_of_patches(from);
    cache->mesh_count++;
    if (!displaced_make(store, source->scene, source->compile, number, &cache->displaced[mesh]))
        return set_fail(gl, source->scene, from->patches->material);
    if (displaced_by_view(&cache->displaced[mesh]))
        return true; /* cache_mesh_view follows, which knows all objects */
    if (!displace(
            &(DisplacedView){
                source->scene, {source->size[0], source->size[1]}, {0}, {0}, {.count = 0}},
            source, cache, mesh))
        return false;
    if (source->triangles)
        cache->boxes[mesh] = cull_box(&from->shape);
    return true;
}

bool cache_mesh_make(Store *store, const CacheSource *source, Cache *cache,
                     const SceneObject *object)
{
    GlContext *gl = store_context(store);
    const SceneMesh *mesh =
        object->kind == SCENE_Mesh ? &source->scene->meshes[object->mesh] : NULL;
    Shape shape;
    if (mesh)
        return mesh->patches ? make_displaced(store, source, cache, object->mesh)
                             : make_mesh_of(gl, cache, &mesh->shape);
    if (!scene_solid(object, &shape))
        return gl_fail(gl, "out of memory");
    const bool done = make_mesh_of(gl, cache, &shape);
    shape_free(&shape);
    return done;
}

bool cache_mesh_by_lights(const Cache *cache)
{
    bool by_lights = false;
    for (int i = 0; i < cache->mesh_count; i++)
        by_lights |= displaced_by_lights(&cache->displaced[i]);
    return by_lights;
}

bool cache_mesh_view(GlContext *gl, const CacheSource *source, Cache *cache)
{
    DisplacedView view = {
        source->scene, {source->size[0], source->size[1]}, {0}, {0}, {.count = 0}};
    double grounds[GROUNDS_MOST][4];
    bool fine = true;
    if (cache_mesh_by_lights(cache) && !cache->plane_count) /* a plane is infinite */
        find_box(source, cache, view.low, view.high);
    if (source->alone && source->volume && !source->triangles) {
        view.sight = (SceneSight){.planes = source->volume->planes,
                                  .count = source->volume->count,
                                  .casts = source->casts ? source->scene : NULL,
                                  .grounds = (const double(*)[4])grounds,
                                  .ground_count = cache->plane_count};
        if (find_grounds(source, cache, grounds))
            find_box(source, cache, view.sight.low, view.sight.high);
    }
    for (int i = 0; fine && i < cache->mesh_count; i++)
        if (displaced_by_view(&cache->displaced[i]))
            fine = displace(&view, source, cache, i) && gl_check(gl, "displacing a mesh");
    cache->triangles = 0;
    for (int i = 0; i < cache->place_count; i++)
        cache->triangles += cache->meshes[cache->places[i].mesh].index_count / 3;
    return fine;
}
