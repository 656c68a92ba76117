/* Assigns meshes to displaced objects: one for all that are displaced alike. Later changes of a
 * param or an object's matrix give the affected objects another mesh, and free meshes without
 * users. */
#include "compiler/base/hash_index.h"
#include "compiler/base/session.h"
#include "runtime/tessellate/scene_displace.h"
#include "runtime/tessellate/scene_displace_param.h"
#include "runtime/tessellate/scene_displacement.h"
#include "runtime/tessellate/scene_fine.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/tessellate/scene_solid.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A pass over all objects: their new meshes, before any is assigned. */
typedef struct {
    const Scene *scene;
    SceneDisplacer *by;
    HashIndex index; /* index of meshes by their keys */
    int *next;       /* indexed by object: its new mesh */
    int64_t triangles;
    int mesh_count;
} Maker;

/* Returns the key of a displaced shape: the object's own shape, the material, and the matrix:
 * either its scales to a millionth, which are invariant under rotations and translations, or all
 * of it. */
static Key key_of(const Scene *scene, const SceneObject *object, const SceneBase *base)
{
    const SceneDisplacer *by = scene->displacer;
    const double *m = object->world_from_local.m, parts_of_one = 1e6;
    double measure[12] = {0}, size = 0;
    SceneObject before = *object;
    before.kind = base->kind, before.mesh = base->mesh;
    const SceneFineness fine = scene_fine_of(scene, &before);
    if (fine.steps)
        before.numbers[scene_detail_number(before.kind)] = fine.steps;
    for (int i = 0; i < 3; i++)
        size += vec3_dot(&m[4 * i], &m[4 * i]);
    if (by->moves[object->material] == MATC_MOVES_world)
        for (int i = 0; i < 12; i++)
            measure[i] = m[i / 3 * 4 + i % 3];
    else
        for (int i = 0; i < 9; i++)
            measure[i] = rint(parts_of_one * vec3_dot(&m[i / 3 * 4], &m[i % 3 * 4]) / size) + 0.;
    if (by->moves[object->material] == MATC_MOVES_local)
        measure[9] += fine.share > 0 ? fine.number : rint(parts_of_one * log(size));
    const Key parts[] = {scene_solid_key(&before),
                         scene_displacer_param_key(by, object->material),
                         key_of_bytes(measure, sizeof measure),
                         key_of_bytes(&fine.share, sizeof fine.share),
                         {(uint64_t)by->method, (uint64_t)fine.triangles}};
    return key_of_bytes(parts, sizeof parts);
}

static int known_mesh(const Maker *k, Key key)
{
    HashProbe probe = hash_probe(&k->index, (uint32_t)key.low);
    while (hash_probe_next(&probe))
        if (key_equal(k->by->keys[probe.number], key))
            return (int)probe.number;
    return -1;
}

static SceneMatrix resized(const SceneMatrix *matrix, double by)
{
    SceneMatrix made = *matrix;
    for (int i = 0; i < 12; i++)
        made.m[i] *= by;
    return made;
}

static bool make_mesh(Maker *k, const SceneObject *object, const SceneBase *base, SceneMesh *made)
{
    const Scene *scene = k->scene;
    const SceneMaterial *of = &scene->materials[object->material];
    SceneObject before = *object;
    before.kind = base->kind, before.mesh = base->mesh;
    const SceneFineness fineness = scene_fine_of(scene, &before);
    const SceneDisplacing how = {.document = of->document,
                                 .material = of->index,
                                 .options = &k->by->options,
                                 .world_from_local =
                                     resized(&object->world_from_local, fineness.scale),
                                 .origin = scene->origin,
                                 .method = k->by->method,
                                 .level = scene->displaced_level,
                                 .dividing = scene->dividing,
                                 .triangles = fineness.triangles,
                                 /* set for bisection only */
                                 .seen = scene->displaced_pixels > 0 ? &k->by->seen : NULL,
                                 .pixels = scene->displaced_pixels,
                                 .processor = k->by->processor};
    Shape solid = {0};
    if (fineness.steps)
        before.numbers[scene_detail_number(before.kind)] = fineness.steps;
    if (base->kind != SCENE_Mesh && !scene_solid(&before, &solid))
        return scene_displacer_fail(k->by, object->material, "needs too much memory");
    scene_displace_params(scene, object->material);
    const bool fine = scene_displaced_mesh(
        &how, base->kind != SCENE_Mesh ? &solid : &scene->meshes[base->mesh].shape, made);
    scene_displace_params(scene, object->material);
    shape_free(&solid);
    if (made->patches)
        made->patches->material = object->material;
    k->triangles += fine ? scene_displaced_triangles(made) : 0;
    if (k->triangles > SCENE_TRIANGLES) {
        scene_mesh_free(made);
        return scene_displacer_fail(k->by, object->material,
                                    "makes too many triangles: `displacement: { triangles: 10000 "
                                    "}` makes fewer of each mesh");
    }
    return fine || scene_displacer_fail(k->by, object->material,
                                        "needs too many operations or too much memory");
}

/* Returns a free mesh slot: each displaced object may have two meshes, the old one until the new
 * one is made. */
static int vacant_mesh(SceneDisplacer *by)
{
    while (by->users[by->vacant])
        by->vacant++;
    return by->vacant;
}

static bool displace(Maker *k, int number)
{
    SceneDisplacer *by = k->by;
    const SceneObject *object = &k->scene->objects[number];
    const Key key = key_of(k->scene, object, &by->bases[number]);
    int mesh = known_mesh(k, key);
    if (mesh < 0) {
        SceneMesh made;
        if (!make_mesh(k, object, &by->bases[number], &made))
            return false;
        mesh = vacant_mesh(by);
        k->scene->meshes[mesh] = made;
        k->mesh_count = mesh < k->mesh_count ? k->mesh_count : mesh + 1;
        by->keys[mesh] = key;
        hash_index_add(NULL, &k->index, (uint32_t)key.low, (uint32_t)mesh);
    }
    by->users[mesh]++;
    k->next[number] = mesh;
    return true;
}

/* Releases an object's mesh; the last user frees the mesh. */
static void leave(Scene *scene, int mesh)
{
    SceneDisplacer *by = scene->displacer;
    if (--by->users[mesh])
        return;
    by->vacant = mesh < by->vacant ? mesh : by->vacant;
    scene_mesh_free(&scene->meshes[mesh]);
}

/* Assigns the new meshes to objects; after a failure objects keep theirs. Returns true if any
 * mesh changed. */
static bool settle(Scene *scene, const Maker *k, bool fine)
{
    bool changed = false;
    scene->mesh_count = k->mesh_count;
    for (int i = 0; i < scene->object_count; i++) {
        if (k->next[i] < 0)
            continue;
        SceneObject *object = &scene->objects[i];
        const bool first = object->kind != SCENE_Mesh || object->mesh < k->by->first;
        if (!fine || (!first && object->mesh == k->next[i])) {
            leave(scene, k->next[i]); /* the mesh was counted twice */
            continue;
        }
        if (!first)
            leave(scene, object->mesh);
        object->kind = SCENE_Mesh;
        object->mesh = k->next[i];
        changed = true;
    }
    return changed;
}

/* Displaces those of `count` objects from `first` on that have the material, or, for material
 * -1, any. */
static SceneDisplaced displace_objects(Scene *scene, int material, int first, int count)
{
    SceneDisplacer *by = scene->displacer;
    Maker k = {.scene = scene,
               .by = by,
               .next = malloc(((size_t)scene->object_count + 1) * sizeof *k.next),
               .mesh_count = scene->mesh_count};
    bool fine = k.next != NULL ||
                scene_displacer_fail(by, scene->objects[first].material, "needs too much memory"),
         changed = false;
    for (int i = by->first; fine && i < scene->mesh_count; i++)
        if (by->users[i]) {
            hash_index_add(NULL, &k.index, (uint32_t)by->keys[i].low, (uint32_t)i);
            k.triangles += scene_displaced_triangles(&scene->meshes[i]);
        }
    for (int i = 0; k.next && i < scene->object_count; i++)
        k.next[i] = -1;
    for (int i = first; fine && i < first + count; i++)
        if (by->bases[i].kind != SCENE_Plane &&
            (material < 0 || scene->objects[i].material == material))
            fine = displace(&k, i);
    if (k.next)
        changed = settle(scene, &k, fine);
    hash_index_free(&k.index);
    free(k.next);
    return !fine     ? SCENE_DISPLACED_failed
           : changed ? SCENE_DISPLACED_rebuilt
                     : SCENE_DISPLACED_same;
}

/* Finds the shapes of objects before displacement; returns the number of displaced objects. */
static int find_bases(Scene *scene, const MatcOptions *options)
{
    SceneDisplacer *by = scene->displacer;
    int count = 0;
    for (int i = 0; i < scene->material_count; i++)
        by->moves[i] = matc_moves(scene->materials[i].document, scene->materials[i].index, options);
    for (int i = 0; scene->displaced_pixels > 0 && i < scene->material_count; i++)
        /* view-dependent division depends on the place in the world */
        by->moves[i] = by->moves[i] == MATC_MOVES_none ? MATC_MOVES_none : MATC_MOVES_world;
    for (int i = 0; i < scene->object_count; i++) {
        const SceneObject *object = &scene->objects[i];
        const bool moves = by->moves[object->material] != MATC_MOVES_none;
        by->bases[i] =
            moves ? (SceneBase){object->kind, object->mesh} : (SceneBase){SCENE_Plane, 0};
        count += by->bases[i].kind != SCENE_Plane;
    }
    return count;
}

bool scene_displace(Scene *scene, Session *session, const MatcOptions *options)
{
    Arena *arena = session->arena;
    SceneDisplacer *by = scene->displacer = ARENA_NEW(arena, SceneDisplacer);
    *by = (SceneDisplacer){.options = *options,
                           .method = scene->displaced_by,
                           .first = scene->mesh_count,
                           .vacant = scene->mesh_count};
    if (scene->displaced_pixels > 0)
        scene_seen_find(scene, &by->seen);
    by->moves = ARENA_ARRAY(arena, MatcMoves, scene->material_count + 1);
    by->bases = ARENA_ARRAY(arena, SceneBase, scene->object_count + 1);
    scene->displaced = find_bases(scene, options);
    scene_fine_choose(scene, arena);
    if (!scene->displaced)
        return true;
    const size_t capacity = (size_t)scene->mesh_count + 2 * (size_t)scene->displaced + 1;
    SceneMesh *meshes = ARENA_ARRAY(arena, SceneMesh, capacity);
    if (scene->mesh_count)
        memcpy(meshes, scene->meshes, (size_t)scene->mesh_count * sizeof *meshes);
    scene->meshes = meshes;
    by->keys = ARENA_ARRAY(arena, Key, capacity);
    by->users = ARENA_ARRAY(arena, int, capacity);
    if (displace_objects(scene, -1, 0, scene->object_count) != SCENE_DISPLACED_failed)
        return true;
    const SceneMaterial *of = &scene->materials[by->fault];
    diag_add(session, NO_SPAN, DIAG_scene_displaced, matc_material_name(of->document, of->index),
             by->why);
    return false;
}

const char *scene_displace_fault(const Scene *scene, const SceneMaterial **material)
{
    *material = &scene->materials[scene->displacer->fault];
    return scene->displacer->why;
}

SceneDisplaced scene_displace_by(Scene *scene, Keyword method)
{
    const Keyword before = scene->displaced_by;
    scene->displaced_by = method;
    if (!scene->displaced)
        return SCENE_DISPLACED_none;
    scene->displacer->method = method;
    scene->displacer->processor = false;
    const SceneDisplaced made = displace_objects(scene, -1, 0, scene->object_count);
    if (made == SCENE_DISPLACED_failed)
        scene->displaced_by = scene->displacer->method = before;
    return made;
}

bool scene_displace_patches(const Scene *scene)
{
    SceneDisplacer *by = scene->displacer;
    Maker k = {.scene = scene, .by = by};
    bool fine = true;
    if (!scene->displaced || !scene_displaced_by_driver(by->method, scene->displaced_pixels))
        return true;
    by->processor = true;
    by->method = by->method == KEYWORD_Displacing_bisection ? by->method : KEYWORD_Displacing_mesh;
    for (int i = 0; fine && i < scene->object_count; i++) {
        SceneMesh *mesh = by->bases[i].kind != SCENE_Plane ? &scene->meshes[scene->objects[i].mesh]
                                                           : NULL,
                  made;
        if (!mesh || !mesh->patches)
            continue;
        fine = make_mesh(&k, &scene->objects[i], &by->bases[i], &made);
        if (fine) {
            scene_mesh_free(mesh);
            *mesh = made;
        }
    }
    return fine;
}

SceneDisplaced scene_displace_moved(Scene *scene, int first, int count)
{
    return scene->displaced ? displace_objects(scene, -1, first, count) : SCENE_DISPLACED_none;
}

SceneDisplaced scene_displace_param(Scene *scene, int material, const char *name,
                                    const double *components, int count)
{
    SceneDisplacer *by = scene->displacer;
    double before[4];
    if (!scene->displaced || by->moves[material] == MATC_MOVES_none ||
        !scene_displacer_reads(scene, material, name, count))
        return SCENE_DISPLACED_none;
    SceneDisplacedParam *param = scene_displacer_param(scene, material, name, count);
    if (!param)
        return scene_displacer_fail(by, material, "needs too much memory"), SCENE_DISPLACED_failed;
    memcpy(before, param->components, sizeof before);
    memcpy(param->components, components, (size_t)count * sizeof *components);
    const SceneDisplaced made = displace_objects(scene, material, 0, scene->object_count);
    if (made == SCENE_DISPLACED_failed)
        memcpy(param->components, before, sizeof before);
    return made;
}

SceneDisplaced scene_displace_resized(Scene *scene, int width, int height)
{
    if (!scene->displacer->bounds)
        return SCENE_DISPLACED_none;
    scene_fine_look(scene, width, height);
    return scene->displaced ? displace_objects(scene, -1, 0, scene->object_count)
                            : SCENE_DISPLACED_none;
}
