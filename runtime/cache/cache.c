/* Builds the cache in one walk over the scene: equal solids become one mesh, materials that
 * differ only in constants one kind. */
#include "runtime/cache/cache_trace.h"
#include "compiler/base/hash_index.h"
#include "runtime/cache/seen_text.h"
#include "runtime/scene/scene_matrix.h"
#include <stdlib.h>
#include <string.h>

/* Elements found by the hash of their contents. */
typedef struct {
    HashIndex index;
    Key *keys;
} Known;

/* Hash of an imported mesh's contents. */
static Key shape_key(const Shape *shape)
{
    const Key parts[] = {
        key_of_bytes(shape->vertices, (size_t)shape->vertex_count * sizeof *shape->vertices),
        key_of_bytes(shape->indices, (size_t)shape->index_count * sizeof *shape->indices),
        key_of_bytes(shape->base,
                     shape->base ? (size_t)shape->vertex_count * sizeof *shape->base : 0)};
    return key_of_bytes(parts, sizeof parts);
}

typedef struct {
    Store *store;
    GlContext *gl;
    const CacheSource *source;
    Cache *before, *cache;
    Known meshes, kinds, casters;
    Key *file_keys; /* hashes of the scene's meshes */
    TransparencyText transparency;
    SeenTextAround seen;
    int *kind_of, *row_of;    /* by material; kind_of -1: not yet used */
    int *used_as[CACHE_USES]; /* by material, index in Cache.casters; -1: no such program */
} Maker;

/* Returns the element's number, or -1. */
static int find(const Known *known, Key key)
{
    HashProbe probe = hash_probe(&known->index, (uint32_t)key.low);
    while (hash_probe_next(&probe))
        if (key_equal(known->keys[probe.number], key))
            return (int)probe.number;
    return -1;
}

static void add(Known *known, Key key, int number)
{
    known->keys[number] = key;
    hash_index_add(NULL, &known->index, (uint32_t)key.low, (uint32_t)number);
}

/* Hash of an object's mesh: objects with equal keys share a mesh, also with the next scene. */
static Key mesh_key(const Maker *m, const SceneObject *object)
{
    double parts[SCENE_NUMBERS + 1] = {object->kind};
    memcpy(parts + 1, object->numbers, sizeof object->numbers);
    return object->kind == SCENE_Mesh ? m->file_keys[object->mesh]
                                      : key_of_bytes(parts, sizeof parts);
}

/* Moves the mesh with that key out of the previous cache. */
static bool take_mesh(Maker *m, Key key)
{
    Cache *before = m->before, *cache = m->cache;
    for (int i = 0; before && i < before->mesh_count; i++)
        if (before->meshes[i].array && key_equal(before->mesh_keys[i], key)) {
            cache->meshes[cache->mesh_count] = before->meshes[i];
            cache->boxes[cache->mesh_count++] = before->boxes[i];
            before->meshes[i] = (Mesh){0};
            return true;
        }
    return false;
}

/* Returns the index of the object's mesh in the cache; -1 on failure. */
static int mesh_of(Maker *m, const SceneObject *object)
{
    const Key key = mesh_key(m, object);
    const int known = find(&m->meshes, key);
    if (known >= 0)
        return known;
    const bool patches =
        object->kind == SCENE_Mesh && m->source->scene->meshes[object->mesh].patches;
    if ((patches || !take_mesh(m, key)) && !cache_mesh_make(m->store, m->source, m->cache, object))
        return -1;
    add(&m->meshes, key, m->cache->mesh_count - 1);
    return m->cache->mesh_count - 1;
}

static bool make_material(Maker *m, const SetProgram *program, CacheUse use, Material *made)
{
    const Set *set = m->source->set;
    ProgramText text = {.vertex = {set_vertex(set, program)},
                        .fragment = {set_fragment(set, program)}};
    if (program->transparent && use == CACHE_USE_seen)
        transparency_wrap(&m->transparency, !strcmp(program->pass, "plane"), &text);
    if (use == CACHE_USE_cut)
        transparency_wrap_cut(m->gl, &text);
    if (use == CACHE_USE_cast && set->uses.casts == SET_CASTS_colored)
        transparency_wrap_caster(m->gl, &text);
    if (m->source->written && !program->transparent && !strcmp(program->pass, "gbuffer"))
        seen_text_wrap(&m->seen, &text);
    return material_make(m->store, program->program, &text, made) ||
           set_fail(m->gl, m->source->scene, program->material);
}

/* Returns the index of the program that draws a surface for a use; -1: none. */
static int drawn_as(const Set *set, int program, CacheUse use)
{
    const SetProgram *surface = &set->programs[program];
    return use == CACHE_USE_cast ? surface->caster : use == CACHE_USE_cut ? surface->cut : program;
}

/* Reports whether two materials share their texts, both for the picture and for a use. */
static bool are_alike(const Set *set, int a, int b, CacheUse use)
{
    const int x = drawn_as(set, a, use), y = drawn_as(set, b, use);
    return set->programs[a].text == set->programs[b].text && x >= 0 && y >= 0 &&
           set->programs[x].text == set->programs[y].text;
}

/* Makes the buffer of the constants of all programs with one text. Programs for a use are in the
 * order of their surfaces. */
static bool make_numbers(Maker *m, int surface, CacheUse use, GLuint *buffer)
{
    const Set *set = m->source->set;
    const GlContext *gl = m->gl;
    const SetProgram *head = &set->programs[set->programs[drawn_as(set, surface, use)].text];
    const size_t size = (size_t)matc_constant_bytes(head->program);
    const int count = set_rows(set, set->programs[surface].text);
    char *rows = calloc((size_t)count + 1, size);
    if (!rows)
        return gl_fail(m->gl, "out of memory");
    for (int i = 0; i < set->count; i++)
        if (are_alike(set, surface, i, use))
            matc_constant_block(set->programs[drawn_as(set, i, use)].program,
                                rows + size * (size_t)set->programs[i].row);
    gl->GenBuffers(1, buffer);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, *buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)size * count, rows, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    free(rows);
    return gl_check(m->gl, "making a buffer of numbers");
}

/* Returns the buffer of a material's constants, which materials with the same text share. 0: it
 * has no constants. */
static bool find_numbers(Maker *m, int surface, CacheUse use, GLuint *found)
{
    const Set *set = m->source->set;
    int first = 0;
    *found = 0;
    if (!m->cache->instances ||
        !matc_constant_count(set->programs[drawn_as(set, surface, use)].program))
        return true;
    while (!are_alike(set, surface, first, use))
        first++;
    GLuint *numbers = &m->cache->numbers[drawn_as(set, first, use)];
    const bool done = *numbers || make_numbers(m, surface, use, numbers);
    *found = *numbers;
    return done;
}

/* An array of kinds, with its hash table. */
typedef struct {
    CacheKind *kinds;
    int *count;
    Known *known;
} Kinds;

/* Adds a kind with a material's program, or returns the existing one that would be drawn in the
 * same way. */
static int add_kind(Maker *m, const SetProgram *program, const CacheKind *kind, const Kinds *to)
{
    const int own = matc_uniform_count(program->program) || !m->cache->instances ? *to->count : -1;
    /* kinds whose uniforms are set one by one are not shared */
    const Key parts[] = {material_key(&kind->material), {(uint64_t)(int64_t)own, kind->numbers}};
    const Key key = key_of_bytes(parts, sizeof parts);
    const int known = find(to->known, key);
    if (known >= 0) {
        Material same = kind->material;
        material_delete(&same);
        return known;
    }
    to->kinds[*to->count] = *kind; /* the cache owns the kind from here on */
    add(to->known, key, *to->count);
    return (*to->count)++;
}

static int make_kind(Maker *m, const SetProgram *surface, CacheUse use, const Kinds *to)
{
    const Set *set = m->source->set;
    const int number = (int)(surface - set->programs);
    const SetProgram *program = &set->programs[drawn_as(set, number, use)];
    CacheKind kind = {.transparent = surface->transparent};
    if (!find_numbers(m, number, use, &kind.numbers) ||
        !make_material(m, program, use, &kind.material))
        return -1;
    return add_kind(m, program, &kind, to);
}

/* Makes the programs that draw a material into shadow maps and voxels. */
static bool find_uses(Maker *m, int material, const SetProgram *surface)
{
    Cache *cache = m->cache;
    const Kinds casters = {cache->casters, &cache->caster_count, &m->casters};
    bool fine = true;
    for (int use = 0; fine && use < CACHE_USES; use++) {
        const bool none =
            drawn_as(m->source->set, (int)(surface - m->source->set->programs), (CacheUse)use) < 0;
        m->used_as[use][material] = none ? -1 : make_kind(m, surface, (CacheUse)use, &casters);
        fine = none || m->used_as[use][material] >= 0;
    }
    return fine;
}

/* Returns the index of a material's kind in the cache; -1 on failure. Without instancing each
 * object has its own, for its matrices. */
static int kind_of(Maker *m, int material)
{
    Cache *cache = m->cache;
    const SetProgram *program = set_find(m->source->set, material, "gbuffer");
    const Kinds kinds = {cache->kinds, &cache->kind_count, &m->kinds};
    if (cache->instances && m->kind_of[material] >= 0)
        return m->kind_of[material];
    m->row_of[material] = program->row;
    if (!find_uses(m, material, program))
        return -1;
    return m->kind_of[material] = make_kind(m, program, CACHE_USE_seen, &kinds);
}

static bool add_surface(Maker *m, int number)
{
    const SceneObject *object = &m->source->scene->objects[number];
    const SetProgram *surface = set_find(m->source->set, object->material, "gbuffer");
    CachePlace place = {.object = number};
    place.kind = kind_of(m, object->material);
    place.mesh = place.kind < 0 ? -1 : mesh_of(m, object);
    if (place.mesh < 0)
        return false;
    place.row = m->row_of[object->material];
    place.caster = m->used_as[CACHE_USE_cast][object->material];
    place.cut = m->used_as[CACHE_USE_cut][object->material];
    place.even = surface->even ? surface->through : NULL;
    place.program = m->cache->kinds[place.kind].material.program->name;
    place.transparent = m->cache->kinds[place.kind].transparent;
    m->cache->places[m->cache->place_count++] = place;
    return true;
}

static bool add_plane(Maker *m, int number)
{
    CachePlane *plane = &m->cache->planes[m->cache->plane_count];
    const int material = m->source->scene->objects[number].material;
    const SetProgram *program = set_find(m->source->set, material, "plane");
    plane->object = number;
    plane->transparent = program->transparent;
    plane->program = program;
    if (!make_material(m, program, CACHE_USE_seen, &plane->material))
        return false;
    m->cache->plane_count++;
    m->cache->opaque_plane_count += !plane->transparent;
    return true;
}

static bool add_objects(Maker *m)
{
    const Scene *scene = m->source->scene;
    for (int i = 0; i < scene->material_count; i++)
        m->kind_of[i] = -1;
    for (int i = 0; i < scene->mesh_count; i++)
        m->file_keys[i] =
            scene->meshes[i].patches ? (Key){(uint64_t)i, 0} : shape_key(&scene->meshes[i].shape);
    for (int i = 0; i < scene->object_count; i++)
        if (!scene->objects[i].hidden &&
            !(scene->objects[i].kind == SCENE_Plane ? add_plane(m, i) : add_surface(m, i)))
            return false;
    return true;
}

static bool make_sky(Maker *m)
{
    Cache *cache = m->cache;
    const int sky = m->source->scene->sky;
    SetProgram program =
        sky < 0 ? (SetProgram){.material = -1} : *set_find(m->source->set, sky, "sky");
    program.transparent = false; /* the background is never transparent */
    cache->has_sky = sky >= 0 && make_material(m, &program, CACHE_USE_seen, &cache->sky);
    return sky < 0 || cache->has_sky;
}

static bool make_room(Maker *m)
{
    Cache *cache = m->cache;
    const Scene *scene = m->source->scene;
    const size_t objects = (size_t)scene->object_count + 1,
                 materials = (size_t)scene->material_count + 1;
    const size_t kinds = cache->instances ? materials : objects;
    cache->number_count = m->source->set->count;
    cache->kinds = calloc(kinds, sizeof *cache->kinds);
    cache->casters = calloc(CACHE_USES * kinds, sizeof *cache->casters);
    cache->numbers = calloc((size_t)cache->number_count + 1, sizeof *cache->numbers);
    cache->meshes = calloc(objects, sizeof *cache->meshes);
    cache->boxes = calloc(objects, sizeof *cache->boxes);
    cache->displaced = calloc(objects, sizeof *cache->displaced);
    cache->places = calloc(objects, sizeof *cache->places);
    cache->place_of = calloc(objects, sizeof *cache->place_of);
    cache->surfaces = calloc(objects, sizeof *cache->surfaces);
    cache->planes = calloc(objects, sizeof *cache->planes);
    cache->list = calloc(CACHE_LISTS * objects, sizeof *cache->list);
    cache->seen_list = calloc(objects, sizeof *cache->seen_list);
    cache->order = calloc(objects, sizeof *cache->order);
    cache->cast_order = calloc(objects, sizeof *cache->cast_order);
    cache->mesh_keys = m->meshes.keys = calloc(objects, sizeof *m->meshes.keys);
    m->file_keys = calloc((size_t)scene->mesh_count + 1, sizeof *m->file_keys);
    m->kinds.keys = calloc(kinds, sizeof *m->kinds.keys);
    m->casters.keys = calloc(CACHE_USES * kinds, sizeof *m->casters.keys);
    m->kind_of = calloc(materials, sizeof *m->kind_of);
    m->row_of = calloc(materials, sizeof *m->row_of);
    m->used_as[0] = calloc(CACHE_USES * materials, sizeof *m->used_as[0]);
    for (int use = 1; use < CACHE_USES; use++)
        m->used_as[use] = m->used_as[0] + (m->used_as[0] ? materials * (size_t)use : 0);
    return (cache->kinds && cache->casters && cache->numbers && cache->meshes && cache->boxes &&
            cache->displaced && cache->places && cache->place_of && cache->surfaces &&
            cache->planes && cache->list && cache->seen_list && cache->order && cache->cast_order &&
            m->meshes.keys && m->kinds.keys && m->casters.keys && m->kind_of && m->row_of &&
            m->used_as[0] && m->file_keys) ||
           gl_fail(m->gl, "out of memory");
}

static void forget(Maker *m)
{
    hash_index_free(&m->meshes.index);
    hash_index_free(&m->kinds.index);
    hash_index_free(&m->casters.index);
    free(m->kinds.keys);
    free(m->casters.keys);
    free(m->file_keys);
    free(m->kind_of);
    free(m->row_of);
    free(m->used_as[0]);
}

/* Makes the instance buffers, and attaches the list of instances to all meshes. */
static bool make_buffers(Maker *m)
{
    Cache *cache = m->cache;
    const GlContext *gl = m->gl;
    if (!cache->instances)
        return true;
    gl->GenBuffers(1, &cache->matrices);
    gl->GenBuffers(1, &cache->words);
    gl->GenBuffers(2, cache->views);
    gl->BindBuffer(GL_ARRAY_BUFFER, cache->words);
    gl->BufferData(GL_ARRAY_BUFFER,
                   (GLsizeiptr)sizeof *cache->list * CACHE_LISTS * cache->place_count, NULL,
                   GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    for (int i = 0; i < cache->mesh_count; i++)
        mesh_attach(gl, &cache->meshes[i], cache->words);
    return gl_check(m->gl, "making buffers of instances") &&
           cache_trace_make(m->store, m->source, cache);
}

bool cache_make(Store *store, const CacheSource *source, Cache *before, Cache *made)
{
    Maker maker = {.store = store,
                   .gl = store_context(store),
                   .source = source,
                   .before = before,
                   .cache = made};
    *made = (Cache){.instances = source->set->instances};
    transparency_text(maker.gl, source->set, source->transparency, &maker.transparency);
    seen_text_make(maker.gl, source->set, source->written, &maker.seen);
    const bool done = make_room(&maker) && add_objects(&maker) && make_sky(&maker) &&
                      make_buffers(&maker) && cache_arrange(maker.gl, source, made);
    made->displaced_anew = false; /* all passes are built after this */
    forget(&maker);
    if (!done)
        cache_delete(maker.gl, made);
    return done;
}

void cache_delete(GlContext *gl, Cache *cache)
{
    for (int i = 0; i < cache->kind_count; i++)
        material_delete(&cache->kinds[i].material);
    for (int i = 0; i < cache->caster_count; i++)
        material_delete(&cache->casters[i].material);
    cache_trace_delete(cache);
    for (int i = 0; i < cache->plane_count; i++)
        material_delete(&cache->planes[i].material);
    for (int i = 0; i < cache->mesh_count; i++) {
        mesh_delete(gl, &cache->meshes[i]);
        displaced_delete(&cache->displaced[i]);
    }
    material_delete(&cache->sky);
    if (cache->numbers)
        gl->DeleteBuffers(cache->number_count, cache->numbers); /* GL ignores the name 0 */
    gl->DeleteBuffers(2, (const GLuint[]){cache->matrices, cache->words});
    gl->DeleteBuffers(2, cache->views);
    free(cache->kinds);
    free(cache->casters);
    free(cache->numbers);
    free(cache->meshes);
    free(cache->boxes);
    free(cache->displaced);
    free(cache->mesh_keys);
    free(cache->places);
    free(cache->place_of);
    free(cache->surfaces);
    free(cache->planes);
    free(cache->list);
    free(cache->seen_list);
    free(cache->order);
    free(cache->cast_order);
    *cache = (Cache){0};
}
