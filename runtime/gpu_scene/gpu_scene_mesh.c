/* Meshes of a GPU scene: of solids, of files, and of surfaces displaced on the GPU. */
#include "runtime/gpu_scene/gpu_scene.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/tessellate/scene_solid.h"
#include <math.h>

static bool make_mesh_of(GlContext *gl, GpuScene *gpu_scene, const Shape *shape)
{
    if (!mesh_make_of(gl, shape, &gpu_scene->meshes[gpu_scene->mesh_count]))
        return false;
    gpu_scene->boxes[gpu_scene->mesh_count++] = cull_box(shape);
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
static void find_box(const GpuSceneSource *source, const GpuScene *gpu_scene, double low[3],
                     double high[3])
{
    for (int i = 0; i < gpu_scene->place_count; i++) {
        const CullBox *box = &gpu_scene->boxes[gpu_scene->places[i].mesh];
        const double *m = source->scene->objects[gpu_scene->places[i].object].world_from_local.m;
        for (int k = 0; k < 3; k++) {
            double middle = m[12 + k], extent = 0;
            for (int component = 0; component < 3; component++) {
                middle += m[4 * component + k] * (box->low[component] + box->high[component]) / 2;
                extent +=
                    fabs(m[4 * component + k]) * (box->high[component] - box->low[component]) / 2;
            }
            low[k] = i ? fmin(low[k], middle - extent) : middle - extent;
            high[k] = i ? fmax(high[k], middle + extent) : middle + extent;
        }
    }
}

enum { GROUNDS_MAX = 8 };

/* Returns the equations of the scene's planes. False if there are too many. */
static bool find_grounds(const GpuSceneSource *source, const GpuScene *gpu_scene,
                         double grounds[GROUNDS_MAX][4])
{
    for (int i = 0; i < gpu_scene->plane_count && i < GROUNDS_MAX; i++) {
        const double *m = source->scene->objects[gpu_scene->planes[i].object].world_from_local.m;
        vec3_cross(m, m + 4, grounds[i]);
        vec3_normalize(grounds[i]);
        grounds[i][3] = -vec3_dot(grounds[i], m + 12);
    }
    return gpu_scene->plane_count <= GROUNDS_MAX;
}

/* Displaces a mesh on the GPU for the view, unless it is up to date. */
static bool displace(const DisplacedView *view, const GpuSceneSource *source, GpuScene *gpu_scene,
                     int mesh)
{
    Displaced *displaced = &gpu_scene->displaced[mesh];
    SceneMesh *of = &source->scene->meshes[gpu_scene->displaced[mesh].mesh];
    Shape shape;
    if (!displaced_write(displaced, view, &gpu_scene->meshes[mesh]))
        return false;
    gpu_scene->displaced_rebuilt |= displaced->anew;
    if (!source->triangles || !displaced->anew)
        return true;
    if (!displaced_read(displaced, &gpu_scene->meshes[mesh], &shape))
        return false;
    shape_free(&of->shape);
    of->shape = shape;
    return true;
}

/* Makes a mesh that the GPU displaces. The surface may intersect itself and show its back there,
 * so a solid mesh counts as merely closed. */
static bool make_displaced(Store *store, const GpuSceneSource *source, GpuScene *gpu_scene,
                           int number)
{
    GlContext *gl = store_context(store);
    const SceneMesh *from = &source->scene->meshes[number];
    const int mesh = gpu_scene->mesh_count;
    if (!mesh_make_captured(gl, &gpu_scene->meshes[mesh]))
        return false;
    const ShapeBody body = shape_body(&from->shape);
    gpu_scene->meshes[mesh].body = from->patches->torn        ? SHAPE_BODY_none
                                   : body == SHAPE_BODY_solid ? SHAPE_BODY_closed
                                                              : body;
    gpu_scene->boxes[mesh] = box_of_patches(from);
    gpu_scene->mesh_count++;
    if (!displaced_make(store, source->scene, source->compile, number, &gpu_scene->displaced[mesh]))
        return material_set_fail(gl, source->scene, from->patches->material);
    if (displaced_by_view(&gpu_scene->displaced[mesh]))
        return true; /* defers to gpu_scene_mesh_view(), which knows all objects */
    if (!displace(
            &(DisplacedView){
                source->scene, {source->size[0], source->size[1]}, {0}, {0}, {.count = 0}},
            source, gpu_scene, mesh))
        return false;
    if (source->triangles)
        gpu_scene->boxes[mesh] = cull_box(&from->shape);
    return true;
}

bool gpu_scene_mesh_make(Store *store, const GpuSceneSource *source, GpuScene *gpu_scene,
                         const SceneObject *object)
{
    GlContext *gl = store_context(store);
    const SceneMesh *mesh =
        object->kind == SCENE_Mesh ? &source->scene->meshes[object->mesh] : NULL;
    Shape shape;
    if (mesh)
        return mesh->patches ? make_displaced(store, source, gpu_scene, object->mesh)
                             : make_mesh_of(gl, gpu_scene, &mesh->shape);
    if (!scene_solid(object, &shape))
        return gl_fail(gl, "out of memory");
    const bool done = make_mesh_of(gl, gpu_scene, &shape);
    shape_free(&shape);
    return done;
}

bool gpu_scene_mesh_by_lights(const GpuScene *gpu_scene)
{
    bool by_lights = false;
    for (int i = 0; i < gpu_scene->mesh_count; i++)
        by_lights |= displaced_by_lights(&gpu_scene->displaced[i]);
    return by_lights;
}

bool gpu_scene_mesh_view(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene)
{
    DisplacedView view = {
        source->scene, {source->size[0], source->size[1]}, {0}, {0}, {.count = 0}};
    double grounds[GROUNDS_MAX][4];
    bool fine = true;
    /* with an infinite plane no box bounds the scene */
    if (gpu_scene_mesh_by_lights(gpu_scene) && !gpu_scene->plane_count)
        find_box(source, gpu_scene, view.low, view.high);
    if (source->alone && source->volume && !source->triangles) {
        view.sight = (SceneFrustums){.planes = source->volume->planes,
                                     .count = source->volume->count,
                                     .casts = source->casts ? source->scene : NULL,
                                     .grounds = (const double(*)[4])grounds,
                                     .ground_count = gpu_scene->plane_count};
        if (find_grounds(source, gpu_scene, grounds))
            find_box(source, gpu_scene, view.sight.low, view.sight.high);
    }
    for (int i = 0; fine && i < gpu_scene->mesh_count; i++)
        if (displaced_by_view(&gpu_scene->displaced[i]))
            fine = displace(&view, source, gpu_scene, i) && gl_check(gl, "displacing a mesh");
    gpu_scene->triangles = 0;
    for (int i = 0; i < gpu_scene->place_count; i++)
        gpu_scene->triangles += gpu_scene->meshes[gpu_scene->places[i].mesh].index_count / 3;
    return fine;
}
