/* True displacement by meshes: triangles are divided, alike, and each place is moved once, by the C reference in double. What draws the scene then sees meshes
 * like any other, whatever it draws them for: shadows of each method, voxels, edges of the picture.
 *
 * No crack: triangles that share an edge divide it alike (scene_divide.c), and all vertices of one place move together: along the unit sum of their normals, where
 * those are several, and by the texture coordinates and tangents of the first. So what was closed stays closed, bit for bit. */
#include "runtime/scene/scene_displacement.h"
#include "compiler/base/hash_index.h"
#include "runtime/scene/scene_divide.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene/scene_part.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    SceneReader *r;
    const MatcOptions *options;
    MatcMoves *moves; /* by material */
    HashIndex index;  /* of meshes made, by their keys */
    Key *keys;        /* by mesh of the scene */
    size_t key_room;
    int64_t triangles;
} Maker;

/* v by the upper left part; by its transposed inverse for normals. */
static void turn(const SceneMatrix *m, bool transposed, const float v[3], double result[3])
{
    for (int row = 0; row < 3; row++) {
        result[row] = 0;
        for (int column = 0; column < 3; column++)
            result[row] += m->m[transposed ? 4 * row + column : 4 * column + row] * (double)v[column];
    }
}

static void copy(const float from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = (double)from[i];
}

static MatcPoint point_of(const ShapeVertex *vertex, const SceneMatrix *m, const SceneMatrix *inverse)
{
    MatcPoint point;
    turn(m, false, vertex->position, point.position);
    for (int i = 0; i < 3; i++)
        point.position[i] += m->m[12 + i];
    turn(inverse, true, vertex->normal, point.normal);
    turn(m, false, vertex->tangentU, point.tangent_u);
    turn(m, false, vertex->tangentV, point.tangent_v);
    copy(vertex->position, point.local);
    copy(vertex->tangentU, point.local_u);
    copy(vertex->tangentV, point.local_v);
    point.uv[0] = (double)vertex->uv[0];
    point.uv[1] = (double)vertex->uv[1];
    return point;
}

/* The unit sum of different normals of a place is its first vertex' for displacement. */
static void join_normals(const Shape *shape, const int *first, ShapeVertex *joined)
{
    for (int i = 0; i < shape->vertex_count; i++) {
        const float *n = shape->vertices[i].normal;
        if (first[i] == i)
            joined[i] = shape->vertices[i];
        else if (memcmp(n, shape->vertices[first[i]].normal, sizeof shape->vertices[i].normal) != 0)
            for (int lane = 0; lane < 3; lane++)
                joined[first[i]].normal[lane] += n[lane];
    }
}

/* The points of all places, moved; `at` tells the place of a vertex. */
static MatcPoint *moved_places(const SceneDisplacing *how, const Shape *shape, const int *first, int *at)
{
    SceneMatrix inverse;
    ShapeVertex *joined = calloc((size_t)shape->vertex_count + 1, sizeof *joined);
    MatcPoint *points = calloc((size_t)shape->vertex_count + 1, sizeof *points);
    int count = 0;
    bool fine = joined && points && scene_matrix_invert(&how->world_from_local, &inverse);
    if (fine)
        join_normals(shape, first, joined);
    for (int i = 0; fine && i < shape->vertex_count; i++) {
        at[i] = first[i] == i ? count : at[first[i]];
        if (first[i] == i)
            points[count++] = point_of(&joined[i], &how->world_from_local, &inverse);
    }
    fine = fine && matc_move(how->document, how->material, how->options, points, count);
    for (int i = 0; fine && i < count; i++) { /* back to the object's space */
        double from[3], to[3];
        for (int lane = 0; lane < 3; lane++)
            from[lane] = points[i].position[lane] - how->world_from_local.m[12 + lane];
        for (int lane = 0; lane < 3; lane++)
            to[lane] = inverse.m[lane] * from[0] + inverse.m[4 + lane] * from[1] + inverse.m[8 + lane] * from[2];
        memcpy(points[i].position, to, sizeof to);
    }
    free(joined);
    if (!fine)
        free(points);
    return fine ? points : NULL;
}

static bool move_shape(const SceneDisplacing *how, Shape *shape)
{
    int *first = scene_places(shape), *at = calloc((size_t)shape->vertex_count + 1, sizeof *at);
    MatcPoint *points = first && at ? moved_places(how, shape, first, at) : NULL;
    shape->base = calloc((size_t)shape->vertex_count + 1, sizeof *shape->base);
    const bool fine = points && shape->base;
    for (int i = 0; fine && i < shape->vertex_count; i++) {
        memcpy(shape->base[i], shape->vertices[i].position, sizeof shape->base[i]);
        for (int lane = 0; lane < 3; lane++)
            shape->vertices[i].position[lane] = (float)points[at[i]].position[lane];
    }
    free(points);
    free(at);
    free(first);
    return fine;
}

bool scene_displaced_shape(const SceneDisplacing *how, const Shape *from, Shape *made)
{
    const double parts = ceil(sqrt((double)how->triangles / fmax(from->index_count / 3., 1)));
    if (!scene_divide(from, parts > 1 ? (int)parts : 1, made))
        return false;
    if (move_shape(how, made))
        return true;
    shape_free(made);
    return false;
}

/* What the shape depends on: the object's own, the material, and of the matrix what it measures, to a millionth, which turns and places leave as it is;
 * or all of it. */
static Key key_of(const Maker *k, const SceneObject *object)
{
    const double *m = object->world_from_local.m, parts_of_one = 1e6;
    double measure[12] = {0}, size = 0;
    for (int i = 0; i < 3; i++)
        size += scene_vector_dot(&m[4 * i], &m[4 * i]);
    if (k->moves[object->material] == MATC_MOVES_world)
        for (int i = 0; i < 12; i++)
            measure[i] = m[i / 3 * 4 + i % 3];
    else
        for (int i = 0; i < 9; i++)
            measure[i] = rint(parts_of_one * scene_vector_dot(&m[i / 3 * 4], &m[i % 3 * 4]) / size) + 0.;
    measure[9] += k->moves[object->material] == MATC_MOVES_world ? 0 : rint(parts_of_one * log(size));
    const Key parts[] = {scene_solid_key(object), {(uint64_t)object->material, 0}, key_of_bytes(measure, sizeof measure)};
    return key_of_bytes(parts, sizeof parts);
}

static int known_mesh(const Maker *k, Key key)
{
    HashProbe probe = hash_probe(&k->index, (uint32_t)key.low);
    while (hash_probe_next(&probe))
        if (key_equal(k->keys[probe.number], key))
            return (int)probe.number;
    return -1;
}

static bool fail(Maker *k, const SceneObject *object, const char *why)
{
    const SceneMaterial *of = &k->r->scene->materials[object->material];
    diag_add(k->r->session, NO_SPAN, DIAG_scene_displaced, matc_material_name(of->document, of->index), why);
    return false;
}

static bool make_mesh(Maker *k, const SceneObject *object, Shape *made)
{
    Scene *scene = k->r->scene;
    const SceneMaterial *of = &scene->materials[object->material];
    const SceneDisplacing how = {of->document, of->index, k->options, object->world_from_local, scene->displaced_triangles};
    Shape solid = {0};
    const bool own = object->kind != SCENE_Mesh;
    if (own && !scene_solid(object, &solid))
        return fail(k, object, "takes more memory than there is");
    const bool fine = scene_displaced_shape(&how, own ? &solid : &scene->meshes[object->mesh].shape, made);
    shape_free(&solid);
    k->triangles += fine ? made->index_count / 3 : 0;
    if (k->triangles > SCENE_TRIANGLES) {
        shape_free(made);
        return fail(k, object, "makes too many triangles: `displacement: { triangles: 10000 }` makes fewer of each mesh");
    }
    return fine || fail(k, object, "takes too many operations, or more memory than there is");
}

static bool displace(Maker *k, SceneObject *object)
{
    Scene *scene = k->r->scene;
    const Key key = key_of(k, object);
    SceneMesh mesh = {.path = ""};
    int number = known_mesh(k, key);
    if (number < 0) {
        size_t count = (size_t)scene->mesh_count;
        if (!make_mesh(k, object, &mesh.shape))
            return false;
        ARENA_PUSH(k->r->session->arena, scene->meshes, count, k->r->mesh_room, mesh);
        number = scene->mesh_count;
        scene->mesh_count = (int)count;
        k->keys = arena_reach(k->r->session->arena, k->keys, (size_t)number, &k->key_room, sizeof *k->keys);
        k->keys[number] = key;
        hash_index_add(k->r->session->arena, &k->index, (uint32_t)key.low, (uint32_t)number);
    }
    object->kind = SCENE_Mesh;
    object->mesh = number;
    scene->displaced++;
    return true;
}

bool scene_displace(SceneReader *r, const MatcOptions *options)
{
    Scene *scene = r->scene;
    Maker k = {.r = r, .options = options, .moves = ARENA_ARRAY(r->session->arena, MatcMoves, scene->material_count + 1)};
    bool fine = true;
    for (int i = 0; i < scene->material_count; i++)
        k.moves[i] = matc_moves(scene->materials[i].document, scene->materials[i].index, options);
    for (int i = 0; fine && i < scene->object_count; i++)
        if (scene->objects[i].kind != SCENE_Plane && k.moves[scene->objects[i].material] != MATC_MOVES_none)
            fine = displace(&k, &scene->objects[i]);
    return fine;
}
