/* Shadow casters of a cache, drawn for each light's view. Opaque casters are grouped by mesh
 * alone. */
#include "runtime/cache/cache_trace.h"
#include "runtime/cache/instances.h"
#include "runtime/displace/traced/displaced_traced.h"
#include "runtime/gpu_material/material_feed.h"
#include "runtime/tessellate/scene_scatter.h"
#include <stdlib.h>

/* A place with its sort key. */
typedef struct {
    int caster, cut, mesh, mirrored;
    uint32_t place;
} Cast;

static int compare(const void *a, const void *b)
{
    const Cast *x = a, *y = b;
    if (x->caster != y->caster)
        return x->caster < y->caster ? -1 : 1;
    if (x->cut != y->cut)
        return x->cut < y->cut ? -1 : 1;
    if (x->mesh != y->mesh)
        return x->mesh < y->mesh ? -1 : 1;
    if (x->mirrored != y->mirrored)
        return x->mirrored - y->mirrored;
    return x->place < y->place ? -1 : 1;
}

static Cast cast_of(const Cache *cache, uint32_t number)
{
    const CachePlace *place = &cache->places[number];
    return (Cast){place->caster, place->cut, place->mesh, place->mirrored, number};
}

bool cache_arrange_casters(GlContext *gl, Cache *cache)
{
    Cast *casts = malloc((size_t)cache->place_count * sizeof *casts + 1);
    if (!casts)
        return gl_fail(gl, "out of memory");
    cache->cast_count = 0;
    for (int i = 0; i < cache->place_count; i++)
        if (!cache->places[i].transparent || cache->places[i].caster >= 0 ||
            cache->places[i].cut >= 0)
            casts[cache->cast_count++] = cast_of(cache, (uint32_t)i);
    qsort(casts, (size_t)cache->cast_count, sizeof *casts, compare);
    for (int i = 0; i < cache->cast_count; i++)
        cache->cast_order[i] = casts[i].place;
    free(casts);
    return true;
}

static bool is_wanted(const CachePlace *place, const CacheLight *light, bool transparent)
{
    return light->cut ? place->cut >= 0
                      : place->transparent == transparent && (!transparent || place->caster >= 0);
}

/* Lists the places in the light's view, in drawing order. Returns how many. */
static int list_seen(const CacheSource *source, Cache *cache, const CacheLight *light,
                     bool transparent)
{
    uint32_t *list = cache->list + (CACHE_LISTS - 1) * cache->place_count;
    int count = 0;
    for (int i = 0; i < cache->cast_count; i++) {
        const CachePlace *place = &cache->places[cache->cast_order[i]];
        if (is_wanted(place, light, transparent) &&
            (!light->waves || light->waves[cache->cast_order[i]] == light->wave) &&
            !(light->varying && place->even) &&
            cull_sees(light->volume, &cache->boxes[place->mesh],
                      &source->scene->objects[place->object].world_from_local))
            list[count++] = cache->cast_order[i];
    }
    return count;
}

static void write_buffers(const GlContext *gl, const Cache *cache, const Spaces *spaces, int count)
{
    const InstanceView view = instance_view(spaces);
    const size_t start = sizeof *cache->list * (CACHE_LISTS - 1) * (size_t)cache->place_count;
    gl->BindBuffer(GL_UNIFORM_BUFFER, cache->views[1]);
    gl->BufferData(GL_UNIFORM_BUFFER, sizeof view, &view, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, cache->words);
    gl->BufferSubData(GL_ARRAY_BUFFER, (GLintptr)start, (GLsizeiptr)sizeof *cache->list * count,
                      cache->list + (CACHE_LISTS - 1) * cache->place_count);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, INSTANCE_MATRICES, cache->matrices);
    gl->BindBufferBase(GL_UNIFORM_BUFFER, UNIFORMS_VIEW, cache->views[1]);
}

/* Sets matrices of programs without instancing, and the eye's position. */
static void set_object(const Scene *scene, int object, Spaces *spaces, Material *material)
{
    const SceneMatrix *world_from_local = &scene->objects[object].world_from_local;
    spaces->object = scene_object_random(object);
    for (int i = 0; i < 16; i++)
        spaces->world_from_local.m[i] = (float)world_from_local->m[i];
    spaces_set(spaces, material);
}

/* Returns how many places of the list one call draws. */
static int group_of(const Cache *cache, const uint32_t *list, int count, bool by_kind)
{
    const int kind = cache->places[list[0]].kind;
    const Cast head = cast_of(cache, list[0]);
    int group = 1;
    for (; group < count && cache->instances; group++) {
        const Cast next = cast_of(cache, list[group]);
        if (next.caster != head.caster || next.cut != head.cut || next.mesh != head.mesh ||
            next.mirrored != head.mirrored || (by_kind && cache->places[list[group]].kind != kind))
            break;
    }
    return group;
}

static void use(GlContext *gl, CacheKind *caster, Material *material, const Material *before)
{
    material_use_after(material, before);
    if (material != before && caster && caster->numbers)
        gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, INSTANCE_NUMBERS, caster->numbers);
}

static bool is_traced(const Cache *cache, const CacheLight *light, const CachePlace *place)
{
    const DisplacedTrace *trace = displaced_traced(&cache->displaced[place->mesh]);
    return light->traced && cache->tracing && !place->transparent &&
           cache->traced[place->kind].store && trace && !trace->parallax;
}

/* The light's clip space with the camera's eye. */
static Spaces spaces_of(const CacheSource *source, const CacheLight *light)
{
    Spaces spaces = source->space->spaces;
    spaces.eye_from_world = mat4_identity();
    for (int i = 0; i < 16; i++)
        spaces.clip_from_eye.m[i] = (float)light->clip_from_world[i];
    return spaces;
}

void cache_cast(GlContext *gl, const CacheSource *source, Cache *cache, const CacheLight *light,
                bool transparent)
{
    const int start = (CACHE_LISTS - 1) * cache->place_count;
    const int count = list_seen(source, cache, light, transparent);
    const uint32_t *list = cache->list + start;
    const Material *before = NULL;
    Spaces spaces = spaces_of(source, light);
    if (cache->instances && count)
        write_buffers(gl, cache, &spaces, count);
    for (int i = 0, group; i < count; i += group) {
        const CachePlace *place = &cache->places[list[i]];
        const int number = light->cut ? place->cut : place->caster;
        CacheKind *caster = light->kept  ? &cache->kinds[place->kind]
                            : number < 0 ? NULL
                                         : &cache->casters[number];
        Material *material = light->kept ? &light->kept[place->kind]
                             : caster    ? &caster->material
                                         : light->solid;
        group = group_of(cache, list + i, count - i, light->kept != NULL);
        gl->FrontFace(place->mirrored != light->mirrored ? GL_CW : GL_CCW);
        if (is_traced(cache, light, place)) {
            cache_trace_cast(gl, cache, place->mesh, &(CacheTraceCast){light, start + i, group});
            before = NULL;
            continue;
        }
        if (material != before || !cache->instances)
            set_object(source->scene, place->object, &spaces, material);
        material_set_number(material, "glass_map", (float)light->number);
        use(gl, caster, material, before);
        before = material;
        material_feed(material, &cache->meshes[place->mesh]);
        if (cache->instances)
            mesh_draw_instances(gl, &cache->meshes[place->mesh], start + i, group);
        else
            mesh_draw(gl, &cache->meshes[place->mesh]);
    }
    gl->FrontFace(GL_CCW);
}
