/* Builds the GPU scene in one walk over the scene: equal solids become one mesh, materials that
 * differ only in constants one kind. */
#include "runtime/gpu_scene/gpu_scene_trace.h"
#include "compiler/base/hash_index.h"
#include "runtime/gpu_scene/triangle_id_text.h"
#include "runtime/scene/scene_matrix.h"
#include <stdlib.h>
#include <string.h>

/* Elements found by the hash of their contents. */
typedef struct {
    HashIndex index;
    Key *keys;
} Known;

/* Returns the hash of an imported mesh's contents. */
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
    const GpuSceneSource *source;
    GpuScene *before, *gpu_scene;
    Known meshes, kinds, casters;
    Key *file_keys; /* hashes of the scene's meshes */
    TransparencyText transparency;
    TriangleIdTextParts seen;
    int *kind_of, *row_of; /* indexed by material; kind_of -1: not yet used */
    /* indexed by material: index in GpuScene.casters; -1: no such program */
    int *used_as[GPU_SCENE_USES];
} Maker;

/* Returns the element's number; -1: none. */
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

/* Returns the hash of an object's mesh: objects with equal keys share a mesh, also with the next
 * scene. */
static Key mesh_key(const Maker *m, const SceneObject *object)
{
    double parts[SCENE_NUMBERS + 1] = {object->kind};
    memcpy(parts + 1, object->numbers, sizeof object->numbers);
    return object->kind == SCENE_Mesh ? m->file_keys[object->mesh]
                                      : key_of_bytes(parts, sizeof parts);
}

/* Moves the mesh with that key out of the previous GPU scene. */
static bool take_mesh(Maker *m, Key key)
{
    GpuScene *before = m->before, *gpu_scene = m->gpu_scene;
    for (int i = 0; before && i < before->mesh_count; i++)
        if (before->meshes[i].array && key_equal(before->mesh_keys[i], key)) {
            gpu_scene->meshes[gpu_scene->mesh_count] = before->meshes[i];
            gpu_scene->boxes[gpu_scene->mesh_count++] = before->boxes[i];
            before->meshes[i] = (Mesh){0};
            return true;
        }
    return false;
}

/* Returns the index of the object's mesh in the GPU scene; -1 on failure. */
static int mesh_of(Maker *m, const SceneObject *object)
{
    const Key key = mesh_key(m, object);
    const int known = find(&m->meshes, key);
    if (known >= 0)
        return known;
    const bool patches =
        object->kind == SCENE_Mesh && m->source->scene->meshes[object->mesh].patches;
    if ((patches || !take_mesh(m, key)) &&
        !gpu_scene_mesh_make(m->store, m->source, m->gpu_scene, object))
        return -1;
    add(&m->meshes, key, m->gpu_scene->mesh_count - 1);
    return m->gpu_scene->mesh_count - 1;
}

static bool make_material(Maker *m, const PassProgram *program, GpuSceneUse use, Material *made)
{
    const MaterialSet *set = m->source->set;
    ProgramText text = {.vertex = {material_set_vertex(set, program)},
                        .fragment = {material_set_fragment(set, program)}};
    if (program->transparent && use == GPU_SCENE_USE_seen)
        transparency_wrap(&m->transparency, !strcmp(program->pass, "plane"), &text);
    if (use == GPU_SCENE_USE_cut)
        transparency_wrap_cut(m->gl, &text);
    if (use == GPU_SCENE_USE_cast && set->uses.casts == SET_CASTS_colored)
        transparency_wrap_caster(m->gl, &text);
    if (m->source->written && !program->transparent && !strcmp(program->pass, "gbuffer"))
        triangle_id_text_wrap(&m->seen, &text);
    return material_make(m->store, program->program, &text, made) ||
           material_set_fail(m->gl, m->source->scene, program->material);
}

/* Returns the index of the program that draws a surface for a use; -1: none. */
static int drawn_as(const MaterialSet *set, int program, GpuSceneUse use)
{
    const PassProgram *surface = &set->programs[program];
    return use == GPU_SCENE_USE_cast  ? surface->caster
           : use == GPU_SCENE_USE_cut ? surface->cut
                                      : program;
}

/* Reports whether two materials share their texts, both for the picture and for a use. */
static bool are_alike(const MaterialSet *set, int a, int b, GpuSceneUse use)
{
    const int x = drawn_as(set, a, use), y = drawn_as(set, b, use);
    return set->programs[a].text == set->programs[b].text && x >= 0 && y >= 0 &&
           set->programs[x].text == set->programs[y].text;
}

/* Makes the buffer of the constants of all programs with one text. Programs for a use are in the
 * order of their surfaces. */
static bool make_numbers(Maker *m, int surface, GpuSceneUse use, GLuint *buffer)
{
    const MaterialSet *set = m->source->set;
    const GlContext *gl = m->gl;
    const PassProgram *head = &set->programs[set->programs[drawn_as(set, surface, use)].text];
    const size_t size = (size_t)matc_constant_bytes(head->program);
    const int count = material_set_rows(set, set->programs[surface].text);
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
static bool find_numbers(Maker *m, int surface, GpuSceneUse use, GLuint *found)
{
    const MaterialSet *set = m->source->set;
    int first = 0;
    *found = 0;
    if (!m->gpu_scene->instances ||
        !matc_constant_count(set->programs[drawn_as(set, surface, use)].program))
        return true;
    while (!are_alike(set, surface, first, use))
        first++;
    GLuint *numbers = &m->gpu_scene->numbers[drawn_as(set, first, use)];
    const bool done = *numbers || make_numbers(m, surface, use, numbers);
    *found = *numbers;
    return done;
}

/* An array of kinds, with its hash table. */
typedef struct {
    GpuSceneKind *kinds;
    int *count;
    Known *known;
} Kinds;

/* Adds a kind with a material's program, or returns the existing one that would be drawn in the
 * same way. */
static int add_kind(Maker *m, const PassProgram *program, const GpuSceneKind *kind, const Kinds *to)
{
    const int own =
        matc_uniform_count(program->program) || !m->gpu_scene->instances ? *to->count : -1;
    /* kinds whose uniforms are set one by one are not shared */
    const Key parts[] = {material_key(&kind->material), {(uint64_t)(int64_t)own, kind->numbers}};
    const Key key = key_of_bytes(parts, sizeof parts);
    const int known = find(to->known, key);
    if (known >= 0) {
        Material same = kind->material;
        material_delete(&same);
        return known;
    }
    to->kinds[*to->count] = *kind; /* the GPU scene owns the kind from here on */
    add(to->known, key, *to->count);
    return (*to->count)++;
}

static int make_kind(Maker *m, const PassProgram *surface, GpuSceneUse use, const Kinds *to)
{
    const MaterialSet *set = m->source->set;
    const int number = (int)(surface - set->programs);
    const PassProgram *program = &set->programs[drawn_as(set, number, use)];
    GpuSceneKind kind = {.transparent = surface->transparent};
    if (!find_numbers(m, number, use, &kind.numbers) ||
        !make_material(m, program, use, &kind.material))
        return -1;
    return add_kind(m, program, &kind, to);
}

/* Makes the programs that draw a material into shadow maps and voxels. */
static bool find_uses(Maker *m, int material, const PassProgram *surface)
{
    GpuScene *gpu_scene = m->gpu_scene;
    const Kinds casters = {gpu_scene->casters, &gpu_scene->caster_count, &m->casters};
    bool fine = true;
    for (int use = 0; fine && use < GPU_SCENE_USES; use++) {
        const bool none = drawn_as(m->source->set, (int)(surface - m->source->set->programs),
                                   (GpuSceneUse)use) < 0;
        m->used_as[use][material] = none ? -1 : make_kind(m, surface, (GpuSceneUse)use, &casters);
        fine = none || m->used_as[use][material] >= 0;
    }
    return fine;
}

/* Returns the index of a material's kind in the GPU scene; -1 on failure. Without instancing each
 * object has its own, for its matrices. */
static int kind_of(Maker *m, int material)
{
    GpuScene *gpu_scene = m->gpu_scene;
    const PassProgram *program = material_set_find(m->source->set, material, "gbuffer");
    const Kinds kinds = {gpu_scene->kinds, &gpu_scene->kind_count, &m->kinds};
    if (gpu_scene->instances && m->kind_of[material] >= 0)
        return m->kind_of[material];
    m->row_of[material] = program->row;
    if (!find_uses(m, material, program))
        return -1;
    return m->kind_of[material] = make_kind(m, program, GPU_SCENE_USE_seen, &kinds);
}

static bool add_surface(Maker *m, int number)
{
    const SceneObject *object = &m->source->scene->objects[number];
    const PassProgram *surface = material_set_find(m->source->set, object->material, "gbuffer");
    GpuScenePlace place = {.object = number};
    place.kind = kind_of(m, object->material);
    place.mesh = place.kind < 0 ? -1 : mesh_of(m, object);
    if (place.mesh < 0)
        return false;
    place.row = m->row_of[object->material];
    place.caster = m->used_as[GPU_SCENE_USE_cast][object->material];
    place.cut = m->used_as[GPU_SCENE_USE_cut][object->material];
    place.even = surface->even ? surface->through : NULL;
    place.program = m->gpu_scene->kinds[place.kind].material.program->name;
    place.transparent = m->gpu_scene->kinds[place.kind].transparent;
    m->gpu_scene->places[m->gpu_scene->place_count++] = place;
    return true;
}

static bool add_plane(Maker *m, int number)
{
    GpuScenePlane *plane = &m->gpu_scene->planes[m->gpu_scene->plane_count];
    const int material = m->source->scene->objects[number].material;
    const PassProgram *program = material_set_find(m->source->set, material, "plane");
    plane->object = number;
    plane->transparent = program->transparent;
    plane->program = program;
    if (!make_material(m, program, GPU_SCENE_USE_seen, &plane->material))
        return false;
    m->gpu_scene->plane_count++;
    m->gpu_scene->opaque_plane_count += !plane->transparent;
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
    GpuScene *gpu_scene = m->gpu_scene;
    const int sky = m->source->scene->sky;
    PassProgram program =
        sky < 0 ? (PassProgram){.material = -1} : *material_set_find(m->source->set, sky, "sky");
    program.transparent = false; /* the background is never transparent */
    gpu_scene->has_sky =
        sky >= 0 && make_material(m, &program, GPU_SCENE_USE_seen, &gpu_scene->sky);
    return sky < 0 || gpu_scene->has_sky;
}

static bool make_capacity(Maker *m)
{
    GpuScene *gpu_scene = m->gpu_scene;
    const Scene *scene = m->source->scene;
    const size_t objects = (size_t)scene->object_count + 1,
                 materials = (size_t)scene->material_count + 1;
    const size_t kinds = gpu_scene->instances ? materials : objects;
    gpu_scene->number_count = m->source->set->count;
    gpu_scene->kinds = calloc(kinds, sizeof *gpu_scene->kinds);
    gpu_scene->casters = calloc(GPU_SCENE_USES * kinds, sizeof *gpu_scene->casters);
    gpu_scene->numbers = calloc((size_t)gpu_scene->number_count + 1, sizeof *gpu_scene->numbers);
    gpu_scene->meshes = calloc(objects, sizeof *gpu_scene->meshes);
    gpu_scene->boxes = calloc(objects, sizeof *gpu_scene->boxes);
    gpu_scene->displaced = calloc(objects, sizeof *gpu_scene->displaced);
    gpu_scene->places = calloc(objects, sizeof *gpu_scene->places);
    gpu_scene->place_of = calloc(objects, sizeof *gpu_scene->place_of);
    gpu_scene->surfaces = calloc(objects, sizeof *gpu_scene->surfaces);
    gpu_scene->planes = calloc(objects, sizeof *gpu_scene->planes);
    gpu_scene->list = calloc(GPU_SCENE_LISTS * objects, sizeof *gpu_scene->list);
    gpu_scene->seen_list = calloc(objects, sizeof *gpu_scene->seen_list);
    gpu_scene->order = calloc(objects, sizeof *gpu_scene->order);
    gpu_scene->cast_order = calloc(objects, sizeof *gpu_scene->cast_order);
    gpu_scene->mesh_keys = m->meshes.keys = calloc(objects, sizeof *m->meshes.keys);
    m->file_keys = calloc((size_t)scene->mesh_count + 1, sizeof *m->file_keys);
    m->kinds.keys = calloc(kinds, sizeof *m->kinds.keys);
    m->casters.keys = calloc(GPU_SCENE_USES * kinds, sizeof *m->casters.keys);
    m->kind_of = calloc(materials, sizeof *m->kind_of);
    m->row_of = calloc(materials, sizeof *m->row_of);
    m->used_as[0] = calloc(GPU_SCENE_USES * materials, sizeof *m->used_as[0]);
    for (int use = 1; use < GPU_SCENE_USES; use++)
        m->used_as[use] = m->used_as[0] + (m->used_as[0] ? materials * (size_t)use : 0);
    return (gpu_scene->kinds && gpu_scene->casters && gpu_scene->numbers && gpu_scene->meshes &&
            gpu_scene->boxes && gpu_scene->displaced && gpu_scene->places && gpu_scene->place_of &&
            gpu_scene->surfaces && gpu_scene->planes && gpu_scene->list && gpu_scene->seen_list &&
            gpu_scene->order && gpu_scene->cast_order && m->meshes.keys && m->kinds.keys &&
            m->casters.keys && m->kind_of && m->row_of && m->used_as[0] && m->file_keys) ||
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
    GpuScene *gpu_scene = m->gpu_scene;
    const GlContext *gl = m->gl;
    if (!gpu_scene->instances)
        return true;
    gl->GenBuffers(1, &gpu_scene->matrices);
    gl->GenBuffers(1, &gpu_scene->words);
    gl->GenBuffers(2, gpu_scene->views);
    gl->BindBuffer(GL_ARRAY_BUFFER, gpu_scene->words);
    gl->BufferData(GL_ARRAY_BUFFER,
                   (GLsizeiptr)sizeof *gpu_scene->list * GPU_SCENE_LISTS * gpu_scene->place_count,
                   NULL, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    for (int i = 0; i < gpu_scene->mesh_count; i++)
        mesh_attach(gl, &gpu_scene->meshes[i], gpu_scene->words);
    return gl_check(m->gl, "making buffers of instances") &&
           gpu_scene_trace_make(m->store, m->source, gpu_scene);
}

bool gpu_scene_make(Store *store, const GpuSceneSource *source, GpuScene *before, GpuScene *made)
{
    Maker maker = {.store = store,
                   .gl = store_context(store),
                   .source = source,
                   .before = before,
                   .gpu_scene = made};
    *made = (GpuScene){.instances = source->set->instances};
    transparency_text(maker.gl, source->set, source->transparency, &maker.transparency);
    triangle_id_text_make(maker.gl, source->set, source->written, &maker.seen);
    const bool done = make_capacity(&maker) && add_objects(&maker) && make_sky(&maker) &&
                      make_buffers(&maker) && gpu_scene_arrange(maker.gl, source, made);
    /* all passes are built after this, so the first tessellation is no change */
    made->displaced_rebuilt = false;
    forget(&maker);
    if (!done)
        gpu_scene_delete(maker.gl, made);
    return done;
}

void gpu_scene_delete(GlContext *gl, GpuScene *gpu_scene)
{
    for (int i = 0; i < gpu_scene->kind_count; i++)
        material_delete(&gpu_scene->kinds[i].material);
    for (int i = 0; i < gpu_scene->caster_count; i++)
        material_delete(&gpu_scene->casters[i].material);
    gpu_scene_trace_delete(gpu_scene);
    for (int i = 0; i < gpu_scene->plane_count; i++)
        material_delete(&gpu_scene->planes[i].material);
    for (int i = 0; i < gpu_scene->mesh_count; i++) {
        mesh_delete(gl, &gpu_scene->meshes[i]);
        displaced_delete(&gpu_scene->displaced[i]);
    }
    material_delete(&gpu_scene->sky);
    if (gpu_scene->numbers)
        gl->DeleteBuffers(gpu_scene->number_count, gpu_scene->numbers); /* GL ignores the name 0 */
    gl->DeleteBuffers(2, (const GLuint[]){gpu_scene->matrices, gpu_scene->words});
    gl->DeleteBuffers(2, gpu_scene->views);
    free(gpu_scene->kinds);
    free(gpu_scene->casters);
    free(gpu_scene->numbers);
    free(gpu_scene->meshes);
    free(gpu_scene->boxes);
    free(gpu_scene->displaced);
    free(gpu_scene->mesh_keys);
    free(gpu_scene->places);
    free(gpu_scene->place_of);
    free(gpu_scene->surfaces);
    free(gpu_scene->planes);
    free(gpu_scene->list);
    free(gpu_scene->seen_list);
    free(gpu_scene->order);
    free(gpu_scene->cast_order);
    *gpu_scene = (GpuScene){0};
}
