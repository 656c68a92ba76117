/* Sorts objects into bodies and surfaces, and bodies into waves that are drawn together. Makes
 * no GL calls.
 *
 *     A room of six boxes that overlap in its corners: floor and ceiling do not overlap, wave 1;
 *         two opposite walls, wave 2; the others, wave 3. */
#include "runtime/frame_graph/frame.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/tessellate/scene_solid.h"
#include <math.h>
#include <stdlib.h>

/* Min thickness of a body in voxels. In a flat wall of that thickness or more, each line through
 * voxel centers along the axis nearest to the wall's normal has a center inside. */
#define THINNEST 1.5
/* Max edge in voxels of a surface whose triangles are rasterized one per invocation. The bound
 * limits the work of an invocation, and keeps areas within 32-bit integers. */
#define FINEST 8

/* -- meshes */

static void cross(const float *a, const float *b, const float *c, double out[3])
{
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        out[k] = ((double)b[i] - a[i]) * ((double)c[j] - a[j]) -
                 ((double)b[j] - a[j]) * ((double)c[i] - a[i]);
    }
}

static double distance_of(const Shape *shape, uint32_t a, uint32_t b)
{
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        const double off = (double)shape->vertices[a].position[k] - shape->vertices[b].position[k];
        sum += off * off;
    }
    return sqrt(sum);
}

/* Measures a mesh. Its volume is the sum of pyramids from the first vertex over all triangles. */
static VoxelShape measure(const Shape *shape, ShapeBody body)
{
    VoxelShape made = {.closed = body != SHAPE_BODY_none};
    for (int i = 0; i < shape->index_count; i += 3) {
        const float *first = shape->vertices[0].position,
                    *a = shape->vertices[shape->indices[i]].position;
        double face[3];
        cross(a, shape->vertices[shape->indices[i + 1]].position,
              shape->vertices[shape->indices[i + 2]].position, face);
        for (int k = 0; k < 3; k++)
            made.longest = fmax(made.longest, distance_of(shape, shape->indices[i + k],
                                                          shape->indices[i + (k + 1) % 3]));
        made.area += sqrt(face[0] * face[0] + face[1] * face[1] + face[2] * face[2]) / 2;
        for (int k = 0; k < 3; k++)
            made.volume += face[k] * ((double)a[k] - first[k]) / 6;
    }
    made.volume = fabs(made.volume);
    return made;
}

/* Measures each mesh, by the first object that uses it. */
bool voxel_bodies_measure(const Renderer *renderer, FrameVoxels *voxels)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    const size_t meshes = (size_t)gpu_scene->mesh_count + 1;
    bool *known = calloc(meshes, sizeof *known), fine;
    voxels->shapes = calloc(meshes, sizeof *voxels->shapes);
    voxels->waves = calloc((size_t)gpu_scene->place_count + 1, sizeof *voxels->waves);
    fine = known && voxels->shapes && voxels->waves;
    for (int i = 0; fine && i < gpu_scene->place_count; i++) {
        const SceneObject *object = &renderer->scene->objects[gpu_scene->places[i].object];
        const int mesh = gpu_scene->places[i].mesh;
        Shape made = {0};
        if (known[mesh])
            continue;
        known[mesh] = true;
        fine = object->kind == SCENE_Mesh || scene_solid(object, &made);
        if (fine)
            voxels->shapes[mesh] = measure(
                object->kind == SCENE_Mesh ? &renderer->scene->meshes[object->mesh].shape : &made,
                gpu_scene->meshes[mesh].body);
        shape_free(&made);
    }
    free(known);
    return fine;
}

/* -- objects */

/* Returns the thickness in world units: volume over half the area; a lower bound if the matrix
 * scales axes differently. */
static double thickness(const VoxelShape *shape, const SceneMatrix *world_from_local)
{
    const double *m = world_from_local->m;
    double lengths[3], least = INFINITY, product = 1;
    for (int k = 0; k < 3; k++) {
        lengths[k] =
            sqrt(m[4 * k] * m[4 * k] + m[4 * k + 1] * m[4 * k + 1] + m[4 * k + 2] * m[4 * k + 2]);
        least = fmin(least, lengths[k]);
        product *= lengths[k];
    }
    const double determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) -
                               m[4] * (m[1] * m[10] - m[2] * m[9]) +
                               m[8] * (m[1] * m[6] - m[2] * m[5]);
    return product > 0 && shape->area > 0
               ? 2 * shape->volume / shape->area * fabs(determinant) / (product / least)
               : 0;
}

/* Returns an upper bound of the scale of a matrix; exact if its axes stay orthogonal. */
static double stretch(const SceneMatrix *world_from_local)
{
    double most = 0;
    for (int i = 0; i < 3; i++) {
        double sum = 0;
        for (int j = 0; j < 3; j++) {
            const double *a = world_from_local->m + 4 * i, *b = world_from_local->m + 4 * j;
            sum += fabs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
        }
        most = fmax(most, sum);
    }
    return sqrt(most);
}

bool voxel_bodies_is_body(const FrameVoxels *voxels, int place)
{
    return voxels->waves[place] && voxels->waves[place] <= VOXELS_WAVES_MAX;
}

/* Alpha-tested surfaces evaluate their material, and triangles displaced on the GPU exist only
 * there: both are drawn by the rasterizer. */
unsigned char voxel_bodies_surface(const Renderer *renderer, int number)
{
    const FrameVoxels *voxels = renderer->voxels;
    const GpuScenePlace *place = &renderer->gpu_scene.places[number];
    const double longest = voxels->shapes[place->mesh].longest *
                           stretch(&renderer->scene->objects[place->object].world_from_local) /
                           voxels->grid.edge;
    return renderer->compute && !place->transparent &&
                   !renderer->gpu_scene.displaced[place->mesh].patches && longest <= FINEST
               ? VOXELS_FINE
               : 0;
}

typedef struct {
    VoxelRange range;
    double low; /* lower end along the sweep axis */
    int place;
} Body;

static int compare(const void *a, const void *b)
{
    const Body *x = a, *y = b;
    return x->low != y->low ? (x->low < y->low ? -1 : 1) : x->place - y->place;
}

static bool meets(const VoxelRange *a, const VoxelRange *b)
{
    for (int k = 0; k < 3; k++)
        if (!(a->low[k] < b->high[k] && b->low[k] < a->high[k]))
            return false;
    return true;
}

VoxelKind voxel_bodies_kind(const Renderer *renderer, int number)
{
    const FrameVoxels *voxels = renderer->voxels;
    const GpuScenePlace *place = &renderer->gpu_scene.places[number];
    const VoxelShape *shape = &voxels->shapes[place->mesh];
    if (!shape->closed)
        return VOXEL_open;
    const double thick =
        thickness(shape, &renderer->scene->objects[place->object].world_from_local);
    if (!(thick >= THINNEST * voxels->grid.edge))
        return VOXEL_thin;
    return voxel_bodies_is_body(voxels, number) ? VOXEL_body : VOXEL_crossing;
}

static int list_bodies(const Renderer *renderer, const FrameVoxels *voxels, Body *bodies)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    int count = 0;
    for (int i = 0; i < gpu_scene->place_count; i++) {
        const GpuScenePlace *place = &gpu_scene->places[i];
        const VoxelShape *shape = &voxels->shapes[place->mesh];
        const SceneMatrix *matrix = &renderer->scene->objects[place->object].world_from_local;
        if (place->transparent || !shape->closed ||
            !(thickness(shape, matrix) >= THINNEST * voxels->grid.edge))
            continue;
        bodies[count] =
            (Body){{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}}, 0, i};
        voxel_grid_add(&gpu_scene->boxes[place->mesh], matrix, &bodies[count++].range);
    }
    return count;
}

/* Returns the axis along which the boxes' centers are spread most, so that few boxes overlap in
 * the sweep. */
static int axis_of(const Body *bodies, int count)
{
    double spread[3] = {0};
    for (int k = 0; k < 3; k++) {
        double low = INFINITY, high = -INFINITY;
        for (int i = 0; i < count; i++) {
            low = fmin(low, bodies[i].range.low[k] + bodies[i].range.high[k]);
            high = fmax(high, bodies[i].range.low[k] + bodies[i].range.high[k]);
        }
        spread[k] = high - low;
    }
    return spread[0] >= spread[1] && spread[0] >= spread[2] ? 0 : spread[1] >= spread[2] ? 1 : 2;
}

/* Returns the first wave without a body whose box overlaps this one; 0 if all waves are taken.
 * Removes boxes from the sweep's list that end before this body. */
static int wave_of(const FrameVoxels *voxels, const Body *body, int axis, Body *list, int *count)
{
    const unsigned all = (1u << VOXELS_WAVES_MAX) - 1;
    unsigned taken = 0;
    int kept = 0, wave = 0;
    for (int i = 0; i < *count; i++) {
        if (list[i].range.high[axis] <= body->low)
            continue;
        if (taken != all && meets(&list[i].range, &body->range))
            taken |= 1u << (voxels->waves[list[i].place] - 1);
        list[kept++] = list[i];
    }
    *count = kept;
    while (wave < VOXELS_WAVES_MAX && taken >> wave & 1)
        wave++;
    return wave < VOXELS_WAVES_MAX ? wave + 1 : 0;
}

bool voxel_bodies_sort(const Renderer *renderer, FrameVoxels *voxels)
{
    const size_t places = (size_t)renderer->gpu_scene.place_count + 1;
    Body *bodies = malloc(places * sizeof *bodies), *list = malloc(places * sizeof *list);
    const bool fine = bodies && list;
    const int count = fine ? list_bodies(renderer, voxels, bodies) : 0,
              axis = axis_of(bodies, count);
    int listed = 0;
    for (int i = 0; i < count; i++)
        bodies[i].low = bodies[i].range.low[axis];
    if (count)
        qsort(bodies, (size_t)count, sizeof *bodies, compare);
    for (int i = 0; fine && i < renderer->gpu_scene.place_count; i++)
        voxels->waves[i] = voxel_bodies_surface(renderer, i);
    voxels->wave_count = 0;
    for (int i = 0; i < count; i++) {
        const int wave = wave_of(voxels, &bodies[i], axis, list, &listed);
        if (wave)
            voxels->waves[bodies[i].place] = (unsigned char)wave;
        voxels->wave_count = wave > voxels->wave_count ? wave : voxels->wave_count;
        if (wave)
            list[listed++] = bodies[i];
    }
    free(bodies);
    free(list);
    return fine;
}

bool voxel_bodies_has(const FrameVoxels *voxels, const GpuScene *gpu_scene, int wave)
{
    for (int i = 0; i < gpu_scene->place_count; i++)
        if (voxels_have(&gpu_scene->places[i]) && voxels->waves[i] == wave)
            return true;
    return false;
}
