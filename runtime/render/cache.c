/* The scene is walked once; equal solids become one mesh. */
#include "runtime/render/cache.h"
#include "compiler/base/hash.h"
#include "compiler/base/hash_index.h"
#include "runtime/scene/scene_matrix.h"
#include <stdlib.h>
#include <string.h>

typedef struct {
    Store *store;
    GlContext *gl;
    const CacheSource *source;
    Cache *cache;
    HashIndex meshes; /* by what makes them alike */
    Key *keys;        /* of the meshes */
} Maker;

/* Objects with one key have one mesh. */
static Key mesh_key(const SceneObject *object)
{
    const double parts[SCENE_NUMBERS + 2] = {object->kind,       object->mesh,       object->numbers[0],
                                             object->numbers[1], object->numbers[2], object->numbers[3],
                                             object->numbers[4], object->numbers[5]};
    return key_of_bytes(parts, sizeof parts);
}

static bool make_mesh(Maker *m, const SceneObject *object, Mesh *made)
{
    if (object->kind == SCENE_Mesh)
        return mesh_make_of(m->gl, &m->source->scene->meshes[object->mesh].shape, made);
    Shape shape;
    if (!scene_solid(object, &shape))
        return gl_fail(m->gl, "out of memory");
    const bool done = mesh_make_of(m->gl, &shape, made);
    shape_free(&shape);
    return done;
}

/* The place of its mesh among the cache's, or -1. */
static int mesh_of(Maker *m, const SceneObject *object)
{
    Cache *cache = m->cache;
    const Key key = mesh_key(object);
    HashProbe probe = hash_probe(&m->meshes, (uint32_t)key.low);
    while (hash_probe_next(&probe))
        if (key_equal(m->keys[probe.number], key))
            return (int)probe.number;
    if (!make_mesh(m, object, &cache->meshes[cache->mesh_count]))
        return -1;
    m->keys[cache->mesh_count] = key;
    hash_index_add(NULL, &m->meshes, (uint32_t)key.low, (uint32_t)cache->mesh_count);
    return cache->mesh_count++;
}

static bool make_material(Maker *m, int material, const char *pass, Material *made)
{
    const Set *set = m->source->set;
    const SetProgram *program = set_find(set, material, pass);
    const ProgramText text = {.vertex = {set_vertex(set, program)}, .fragment = {set_fragment(set, program)}};
    return material_make(m->store, program->program, &text, made);
}

/* Images of the origin, and of the steps of x and y. */
static void set_plane(const SceneMatrix *matrix, Spaces *spaces)
{
    static const int columns[3] = {12, 0, 4};
    for (int i = 0; i < 9; i++)
        spaces->plane[i / 3][i % 3] = (float)matrix->m[columns[i / 3] + i % 3];
}

static bool make_drawable(Maker *m, int number, Drawable *made)
{
    const SceneObject *object = &m->source->scene->objects[number];
    const bool plane = object->kind == SCENE_Plane;
    Spaces spaces = m->source->space->spaces;
    *made = (Drawable){.mesh = -1, .object = number};
    for (int i = 0; i < 16; i++)
        spaces.world_from_local.m[i] = (float)object->world_from_local.m[i];
    made->mirrored = scene_matrix_determinant(&object->world_from_local) < 0;
    if (plane)
        set_plane(&object->world_from_local, &spaces);
    if (!make_material(m, object->material, plane ? "plane" : "gbuffer", &made->material))
        return false;
    spaces_set(&spaces, &made->material);
    if (plane)
        return true;
    made->mesh = mesh_of(m, object);
    if (made->mesh >= 0)
        return true;
    material_delete(&made->material);
    return false;
}

static bool make_drawables(Maker *m)
{
    Cache *cache = m->cache;
    for (int i = 0; i < m->source->scene->object_count; i++) {
        const bool plane = m->source->scene->objects[i].kind == SCENE_Plane;
        int *count = plane ? &cache->plane_count : &cache->surface_count;
        Drawable *drawable = (plane ? cache->planes : cache->surfaces) + *count;
        if (!make_drawable(m, i, drawable))
            return false;
        cache->triangles += plane ? 0 : cache->meshes[drawable->mesh].index_count / 3;
        ++*count;
    }
    return true;
}

static bool make_sky(Maker *m)
{
    Cache *cache = m->cache;
    if (m->source->scene->sky < 0)
        return true;
    cache->has_sky = make_material(m, m->source->scene->sky, "sky", &cache->sky);
    if (cache->has_sky)
        spaces_set(&m->source->space->spaces, &cache->sky);
    return cache->has_sky;
}

static bool make_room(Maker *m)
{
    const size_t count = (size_t)m->source->scene->object_count + 1;
    m->cache->meshes = calloc(count, sizeof *m->cache->meshes);
    m->cache->surfaces = calloc(count, sizeof *m->cache->surfaces);
    m->cache->planes = calloc(count, sizeof *m->cache->planes);
    m->keys = calloc(count, sizeof *m->keys);
    return (m->cache->meshes && m->cache->surfaces && m->cache->planes && m->keys) || gl_fail(m->gl, "out of memory");
}

/* A change of program costs most, then one of textures and buffers, which each has, then one of the mesh. */
static int compare(const void *a, const void *b)
{
    const Drawable *x = a, *y = b;
    const GLuint p = x->material.program->name, q = y->material.program->name;
    if (p != q)
        return p < q ? -1 : 1;
    if (x->mesh != y->mesh)
        return x->mesh < y->mesh ? -1 : 1;
    return x->object < y->object ? -1 : 1;
}

bool cache_make(Store *store, const CacheSource *source, Cache *made)
{
    Maker maker = {.store = store, .gl = store_context(store), .source = source, .cache = made};
    *made = (Cache){0};
    const bool done = make_room(&maker) && make_drawables(&maker) && make_sky(&maker);
    hash_index_free(&maker.meshes);
    free(maker.keys);
    if (!done) {
        cache_delete(maker.gl, made);
        return false;
    }
    qsort(made->surfaces, (size_t)made->surface_count, sizeof *made->surfaces, compare);
    return true;
}

void cache_delete(GlContext *gl, Cache *cache)
{
    for (int i = 0; i < cache->surface_count; i++)
        material_delete(&cache->surfaces[i].material);
    for (int i = 0; i < cache->plane_count; i++)
        material_delete(&cache->planes[i].material);
    for (int i = 0; i < cache->mesh_count; i++)
        mesh_delete(gl, &cache->meshes[i]);
    if (cache->has_sky)
        material_delete(&cache->sky);
    free(cache->meshes);
    free(cache->surfaces);
    free(cache->planes);
    *cache = (Cache){0};
}
