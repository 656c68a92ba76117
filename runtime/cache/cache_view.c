/* Parts of a cache that depend on the positions of objects and on the camera: order, matrices,
 * visibility. */
#include "runtime/cache/cache_trace.h"
#include "runtime/cache/instances.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/gpu_material/material_feed.h"
#include "runtime/tessellate/scene_scatter.h"
#include <stdlib.h>
#include <string.h>

/* -- objects */

/* Sorts opaque places first, then by cost of a change: of program, of textures and constants, of
 * mesh. */
static int compare(const void *a, const void *b)
{
    const CachePlace *x = a, *y = b;
    if (x->transparent != y->transparent)
        return x->transparent ? 1 : -1;
    if (x->program != y->program)
        return x->program < y->program ? -1 : 1;
    if (x->kind != y->kind)
        return x->kind < y->kind ? -1 : 1;
    if (x->mesh != y->mesh)
        return x->mesh < y->mesh ? -1 : 1;
    if (x->mirrored != y->mirrored)
        return x->mirrored ? 1 : -1;
    return x->object < y->object ? -1 : 1;
}

static bool is_mirrored(const SceneObject *object)
{
    return scene_matrix_determinant(&object->world_from_local) < 0;
}

static void find_groups(Cache *cache)
{
    cache->surface_count = cache->opaque_count = 0;
    for (int i = 0; i < cache->place_count; i++) {
        const CachePlace *place = &cache->places[i];
        Drawable *last = &cache->surfaces[cache->surface_count - (cache->surface_count > 0)];
        if (!i || last->kind != place->kind || last->mesh != place->mesh ||
            last->mirrored != place->mirrored)
            cache->surfaces[cache->surface_count++] =
                (Drawable){place->kind, place->mesh, place->mirrored, i, 1, 0, 0, false};
        else
            last->count++;
        if (!place->transparent)
            cache->opaque_count = cache->surface_count;
        cache->place_of[place->object] = i;
        cache->list[i] = (uint32_t)i;
    }
}

/* Sets the plane's origin and its x and y axes in world space. */
static void set_plane(const SceneMatrix *matrix, Spaces *spaces)
{
    static const int columns[3] = {12, 0, 4};
    for (int i = 0; i < 9; i++)
        spaces->plane[i / 3][i % 3] = (float)matrix->m[columns[i / 3] + i % 3];
}

static Spaces spaces_of(const CacheSource *source, int object)
{
    const SceneMatrix *matrix = &source->scene->objects[object].world_from_local;
    Spaces spaces = source->space->spaces;
    spaces.object = scene_object_random(object);
    for (int i = 0; i < 16; i++)
        spaces.world_from_local.m[i] = (float)matrix->m[i];
    set_plane(matrix, &spaces);
    if (source->scene->objects[object].kind == SCENE_Plane &&
        source->scene->camera.kind == SCENE_Orthographic)
        view_space_parallels(&source->scene->camera, source->size, matrix, &spaces);
    return spaces;
}

/* Sets the uniforms that do not come from buffers. */
static void set_object(const CacheSource *source, Cache *cache, int object)
{
    const Spaces spaces = spaces_of(source, object);
    const int place = cache->place_of[object];
    for (int i = 0; i < cache->plane_count; i++)
        if (cache->planes[i].object == object)
            spaces_set(&spaces, &cache->planes[i].material);
    if (place >= 0 && !cache->instances)
        spaces_set(&spaces, &cache->kinds[cache->places[place].kind].material);
}

static bool write_places(GlContext *gl, const CacheSource *source, const Cache *cache, int first,
                         int count)
{
    Instance *rows = malloc((size_t)count * sizeof *rows + 1);
    if (!rows)
        return gl_fail(gl, "out of memory");
    for (int i = 0; i < count; i++) {
        const CachePlace *place = &cache->places[first + i];
        rows[i] = instance_of(source->scene, place->object, place->row);
    }
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, cache->matrices);
    if (count == cache->place_count)
        gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)sizeof *rows * count, rows,
                       GL_DYNAMIC_DRAW);
    else
        gl->BufferSubData(GL_SHADER_STORAGE_BUFFER, (GLintptr)sizeof *rows * first,
                          (GLsizeiptr)sizeof *rows * count, rows);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    free(rows);
    return true;
}

bool cache_arrange(GlContext *gl, const CacheSource *source, Cache *cache)
{
    const size_t bytes = sizeof *cache->list * (size_t)cache->place_count;
    for (int i = 0; i < source->scene->object_count; i++)
        cache->place_of[i] = -1;
    for (int i = 0; i < cache->place_count; i++)
        cache->places[i].mirrored = is_mirrored(&source->scene->objects[cache->places[i].object]);
    qsort(cache->places, (size_t)cache->place_count, sizeof *cache->places, compare);
    find_groups(cache);
    if (!cache_arrange_casters(gl, cache))
        return false;
    cache->seen = -1;
    if (cache->instances) {
        gl->BindBuffer(GL_ARRAY_BUFFER, cache->words);
        gl->BufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)bytes, cache->list);
        gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    }
    return (!cache->instances || write_places(gl, source, cache, 0, cache->place_count)) &&
           cache_view(gl, source, cache) && gl_check(gl, "writing instances");
}

/* -- visibility */

/* Lists the places in view. Returns false if the list has not changed. */
static bool list_seen(const CacheSource *source, Cache *cache)
{
    uint32_t *list = cache->list + cache->place_count;
    int next = 0;
    for (int i = 0; i < cache->surface_count; i++) {
        Drawable *drawable = &cache->surfaces[i];
        const int first = next;
        drawable->first_seen = cache->place_count + first;
        drawable->solid = cache->meshes[drawable->mesh].body == SHAPE_BODY_solid;
        for (int k = drawable->first; k < drawable->first + drawable->count; k++) {
            const SceneMatrix *matrix =
                &source->scene->objects[cache->places[k].object].world_from_local;
            if (source->volume && !cull_sees(source->volume, &cache->boxes[drawable->mesh], matrix))
                continue;
            drawable->solid = drawable->solid &&
                              cull_is_beyond(source->view, &cache->boxes[drawable->mesh], matrix);
            list[next++] = (uint32_t)k;
        }
        drawable->seen = next - first;
        if (i >= cache->opaque_count && source->transparency == TRANSPARENCY_lists)
            cache_order(source, cache, drawable, list + first, drawable->seen);
    }
    const bool changed =
        next != cache->seen || memcmp(list, cache->seen_list, (size_t)next * sizeof *list) != 0;
    memcpy(cache->seen_list, list, (size_t)next * sizeof *list);
    cache->seen = next;
    return changed;
}

static void find_seen(const GlContext *gl, const CacheSource *source, Cache *cache)
{
    if (!list_seen(source, cache) || !cache->instances || !cache->seen)
        return;
    const size_t start = sizeof *cache->list * (size_t)cache->place_count,
                 size = sizeof *cache->list * (size_t)cache->seen;
    gl->BindBuffer(GL_ARRAY_BUFFER, cache->words);
    gl->BufferSubData(GL_ARRAY_BUFFER, (GLintptr)start, (GLsizeiptr)size,
                      cache->list + cache->place_count);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
}

bool cache_view(GlContext *gl, const CacheSource *source, Cache *cache)
{
    if (!cache_mesh_view(gl, source, cache))
        return false;
    const Spaces *spaces = &source->space->spaces;
    if (cache->instances) {
        const InstanceView view = instance_view(spaces);
        gl->BindBuffer(GL_UNIFORM_BUFFER, cache->views[0]);
        gl->BufferData(GL_UNIFORM_BUFFER, sizeof view, &view, GL_DYNAMIC_DRAW);
        for (int i = 0; i < cache->kind_count; i++)
            spaces_set(spaces, &cache->kinds[i].material);
        cache_trace_view(source, cache);
    } else {
        for (int i = 0; i < cache->place_count; i++)
            set_object(source, cache, cache->places[i].object);
    }
    for (int i = 0; i < cache->plane_count; i++) {
        const Spaces own = spaces_of(source, cache->planes[i].object);
        spaces_set(&own, &cache->planes[i].material);
    }
    const Spaces sky = view_space_of_sky(source->space);
    if (cache->has_sky)
        spaces_set(&sky, &cache->sky);
    find_seen(gl, source, cache);
    return true;
}

bool cache_move(GlContext *gl, const CacheSource *source, Cache *cache, int first, int count)
{
    int low = cache->place_count, high = -1;
    for (int object = first; object < first + count; object++) {
        const int place = cache->place_of[object];
        if (place >= 0 &&
            cache->places[place].mirrored != is_mirrored(&source->scene->objects[object]))
            return cache_arrange(gl, source, cache);
        set_object(source, cache, object);
        low = place >= 0 && place < low ? place : low;
        high = place > high ? place : high;
    }
    find_seen(gl, source, cache);
    return !cache->instances || high < 0 || write_places(gl, source, cache, low, high - low + 1);
}

bool cache_set(const CacheSource *source, Cache *cache, int material, const MaterialValue *value)
{
    const Scene *scene = source->scene;
    bool found = false;
    for (int i = 0; i < cache->place_count; i++)
        if (scene->objects[cache->places[i].object].material == material) {
            const CachePlace *place = &cache->places[i];
            found |= material_set(&cache->kinds[place->kind].material, value);
            if (cache->tracing && cache->traced[place->kind].store)
                material_set(&cache->traced[place->kind], value);
            found |=
                place->caster >= 0 && material_set(&cache->casters[place->caster].material, value);
            found |= place->cut >= 0 && material_set(&cache->casters[place->cut].material, value);
        }
    for (int i = 0; i < cache->plane_count; i++)
        if (scene->objects[cache->planes[i].object].material == material)
            found |= material_set(&cache->planes[i].material, value);
    return (cache->has_sky && scene->sky == material && material_set(&cache->sky, value)) || found;
}

/* -- drawing */

void cache_draw(GlContext *gl, Cache *cache, bool transparent)
{
    const int first = transparent ? cache->opaque_count : 0;
    const int end = transparent ? cache->surface_count : cache->opaque_count;
    const Material *before = NULL;
    bool mirrored = false, solid = false;
    if (cache->instances) {
        gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, INSTANCE_MATRICES, cache->matrices);
        gl->BindBufferBase(GL_UNIFORM_BUFFER, UNIFORMS_VIEW, cache->views[0]);
    }
    for (int i = first; i < end; i++) {
        const Drawable *drawable = &cache->surfaces[i];
        CacheKind *kind = &cache->kinds[drawable->kind];
        if (!drawable->seen || cache_traces(cache, drawable))
            continue;
        if (drawable->mirrored != mirrored)
            gl->FrontFace((mirrored = drawable->mirrored) ? GL_CW : GL_CCW);
        if ((drawable->solid && !transparent) != solid)
            ((solid = !solid) ? gl->Enable : gl->Disable)(GL_CULL_FACE);
        if (&kind->material != before)
            material_use_after(&kind->material, before);
        if (&kind->material != before && kind->numbers)
            gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, INSTANCE_NUMBERS, kind->numbers);
        before = &kind->material;
        material_feed(&kind->material, &cache->meshes[drawable->mesh]);
        if (cache->instances)
            mesh_draw_instances(gl, &cache->meshes[drawable->mesh], drawable->first_seen,
                                drawable->seen);
        else
            mesh_draw(gl, &cache->meshes[drawable->mesh]);
    }
    if (mirrored)
        gl->FrontFace(GL_CCW);
    if (solid)
        gl->Disable(GL_CULL_FACE);
}
