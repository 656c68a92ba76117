/* Parts of a GPU scene that depend on the positions of objects and on the camera: order, matrices,
 * visibility. */
#include "runtime/gpu_scene/gpu_scene_trace.h"
#include "runtime/gpu_scene/instances.h"
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
    const GpuScenePlace *x = a, *y = b;
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

static void find_groups(GpuScene *gpu_scene)
{
    gpu_scene->surface_count = gpu_scene->opaque_count = 0;
    for (int i = 0; i < gpu_scene->place_count; i++) {
        const GpuScenePlace *place = &gpu_scene->places[i];
        Drawable *last =
            &gpu_scene->surfaces[gpu_scene->surface_count - (gpu_scene->surface_count > 0)];
        if (!i || last->kind != place->kind || last->mesh != place->mesh ||
            last->mirrored != place->mirrored)
            gpu_scene->surfaces[gpu_scene->surface_count++] =
                (Drawable){place->kind, place->mesh, place->mirrored, i, 1, 0, 0, false};
        else
            last->count++;
        if (!place->transparent)
            gpu_scene->opaque_count = gpu_scene->surface_count;
        gpu_scene->place_of[place->object] = i;
        gpu_scene->list[i] = (uint32_t)i;
    }
}

/* Sets the plane's origin and its x and y axes in world space. */
static void set_plane(const SceneMatrix *matrix, Spaces *spaces)
{
    static const int columns[3] = {12, 0, 4};
    for (int i = 0; i < 9; i++)
        spaces->plane[i / 3][i % 3] = (float)matrix->m[columns[i / 3] + i % 3];
}

static Spaces spaces_of(const GpuSceneSource *source, int object)
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
static void set_object(const GpuSceneSource *source, GpuScene *gpu_scene, int object)
{
    const Spaces spaces = spaces_of(source, object);
    const int place = gpu_scene->place_of[object];
    for (int i = 0; i < gpu_scene->plane_count; i++)
        if (gpu_scene->planes[i].object == object)
            spaces_set(&spaces, &gpu_scene->planes[i].material);
    if (place >= 0 && !gpu_scene->instances)
        spaces_set(&spaces, &gpu_scene->kinds[gpu_scene->places[place].kind].material);
}

static bool write_places(GlContext *gl, const GpuSceneSource *source, const GpuScene *gpu_scene,
                         int first, int count)
{
    Instance *rows = malloc((size_t)count * sizeof *rows + 1);
    if (!rows)
        return gl_fail(gl, "out of memory");
    for (int i = 0; i < count; i++) {
        const GpuScenePlace *place = &gpu_scene->places[first + i];
        rows[i] = instance_of(source->scene, place->object, place->row);
    }
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, gpu_scene->matrices);
    if (count == gpu_scene->place_count)
        gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)sizeof *rows * count, rows,
                       GL_DYNAMIC_DRAW);
    else
        gl->BufferSubData(GL_SHADER_STORAGE_BUFFER, (GLintptr)sizeof *rows * first,
                          (GLsizeiptr)sizeof *rows * count, rows);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    free(rows);
    return true;
}

bool gpu_scene_arrange(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene)
{
    const size_t bytes = sizeof *gpu_scene->list * (size_t)gpu_scene->place_count;
    for (int i = 0; i < source->scene->object_count; i++)
        gpu_scene->place_of[i] = -1;
    for (int i = 0; i < gpu_scene->place_count; i++)
        gpu_scene->places[i].mirrored =
            is_mirrored(&source->scene->objects[gpu_scene->places[i].object]);
    qsort(gpu_scene->places, (size_t)gpu_scene->place_count, sizeof *gpu_scene->places, compare);
    find_groups(gpu_scene);
    if (!gpu_scene_arrange_casters(gl, gpu_scene))
        return false;
    gpu_scene->seen = -1;
    if (gpu_scene->instances) {
        gl->BindBuffer(GL_ARRAY_BUFFER, gpu_scene->words);
        gl->BufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)bytes, gpu_scene->list);
        gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    }
    return (!gpu_scene->instances ||
            write_places(gl, source, gpu_scene, 0, gpu_scene->place_count)) &&
           gpu_scene_view(gl, source, gpu_scene) && gl_check(gl, "writing instances");
}

/* -- visibility */

/* Lists the places in view. Returns false if the list has not changed. */
static bool list_seen(const GpuSceneSource *source, GpuScene *gpu_scene)
{
    uint32_t *list = gpu_scene->list + gpu_scene->place_count;
    int next = 0;
    for (int i = 0; i < gpu_scene->surface_count; i++) {
        Drawable *drawable = &gpu_scene->surfaces[i];
        const int first = next;
        drawable->first_seen = gpu_scene->place_count + first;
        drawable->solid = gpu_scene->meshes[drawable->mesh].body == SHAPE_BODY_solid;
        for (int k = drawable->first; k < drawable->first + drawable->count; k++) {
            const SceneMatrix *matrix =
                &source->scene->objects[gpu_scene->places[k].object].world_from_local;
            if (source->volume &&
                !cull_sees(source->volume, &gpu_scene->boxes[drawable->mesh], matrix))
                continue;
            drawable->solid =
                drawable->solid &&
                cull_is_outside(source->view, &gpu_scene->boxes[drawable->mesh], matrix);
            list[next++] = (uint32_t)k;
        }
        drawable->seen = next - first;
        if (i >= gpu_scene->opaque_count && source->transparency == TRANSPARENCY_lists)
            gpu_scene_order(source, gpu_scene, drawable, list + first, drawable->seen);
    }
    const bool changed = next != gpu_scene->seen ||
                         memcmp(list, gpu_scene->seen_list, (size_t)next * sizeof *list) != 0;
    memcpy(gpu_scene->seen_list, list, (size_t)next * sizeof *list);
    gpu_scene->seen = next;
    return changed;
}

static void find_seen(const GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene)
{
    if (!list_seen(source, gpu_scene) || !gpu_scene->instances || !gpu_scene->seen)
        return;
    const size_t start = sizeof *gpu_scene->list * (size_t)gpu_scene->place_count,
                 size = sizeof *gpu_scene->list * (size_t)gpu_scene->seen;
    gl->BindBuffer(GL_ARRAY_BUFFER, gpu_scene->words);
    gl->BufferSubData(GL_ARRAY_BUFFER, (GLintptr)start, (GLsizeiptr)size,
                      gpu_scene->list + gpu_scene->place_count);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
}

bool gpu_scene_view(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene)
{
    if (!gpu_scene_mesh_view(gl, source, gpu_scene))
        return false;
    const Spaces *spaces = &source->space->spaces;
    if (gpu_scene->instances) {
        const InstanceView view = instance_view(spaces);
        gl->BindBuffer(GL_UNIFORM_BUFFER, gpu_scene->views[0]);
        gl->BufferData(GL_UNIFORM_BUFFER, sizeof view, &view, GL_DYNAMIC_DRAW);
        for (int i = 0; i < gpu_scene->kind_count; i++)
            spaces_set(spaces, &gpu_scene->kinds[i].material);
        gpu_scene_trace_view(source, gpu_scene);
    } else {
        for (int i = 0; i < gpu_scene->place_count; i++)
            set_object(source, gpu_scene, gpu_scene->places[i].object);
    }
    for (int i = 0; i < gpu_scene->plane_count; i++) {
        const Spaces own = spaces_of(source, gpu_scene->planes[i].object);
        spaces_set(&own, &gpu_scene->planes[i].material);
    }
    const Spaces sky = view_space_of_sky(source->space);
    if (gpu_scene->has_sky)
        spaces_set(&sky, &gpu_scene->sky);
    find_seen(gl, source, gpu_scene);
    return true;
}

bool gpu_scene_move(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene, int first,
                    int count)
{
    int low = gpu_scene->place_count, high = -1;
    for (int object = first; object < first + count; object++) {
        const int place = gpu_scene->place_of[object];
        if (place >= 0 &&
            gpu_scene->places[place].mirrored != is_mirrored(&source->scene->objects[object]))
            return gpu_scene_arrange(gl, source, gpu_scene);
        set_object(source, gpu_scene, object);
        low = place >= 0 && place < low ? place : low;
        high = place > high ? place : high;
    }
    find_seen(gl, source, gpu_scene);
    return !gpu_scene->instances || high < 0 ||
           write_places(gl, source, gpu_scene, low, high - low + 1);
}

bool gpu_scene_set(const GpuSceneSource *source, GpuScene *gpu_scene, int material,
                   const MaterialValue *value)
{
    const Scene *scene = source->scene;
    bool found = false;
    for (int i = 0; i < gpu_scene->place_count; i++)
        if (scene->objects[gpu_scene->places[i].object].material == material) {
            const GpuScenePlace *place = &gpu_scene->places[i];
            found |= material_set(&gpu_scene->kinds[place->kind].material, value);
            if (gpu_scene->tracing && gpu_scene->traced[place->kind].store)
                material_set(&gpu_scene->traced[place->kind], value);
            found |= place->caster >= 0 &&
                     material_set(&gpu_scene->casters[place->caster].material, value);
            found |=
                place->cut >= 0 && material_set(&gpu_scene->casters[place->cut].material, value);
        }
    for (int i = 0; i < gpu_scene->plane_count; i++)
        if (scene->objects[gpu_scene->planes[i].object].material == material)
            found |= material_set(&gpu_scene->planes[i].material, value);
    return (gpu_scene->has_sky && scene->sky == material && material_set(&gpu_scene->sky, value)) ||
           found;
}

/* -- drawing */

void gpu_scene_draw(GlContext *gl, GpuScene *gpu_scene, bool transparent)
{
    const int first = transparent ? gpu_scene->opaque_count : 0;
    const int end = transparent ? gpu_scene->surface_count : gpu_scene->opaque_count;
    const Material *before = NULL;
    bool mirrored = false, solid = false;
    if (gpu_scene->instances) {
        gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, INSTANCE_MATRICES, gpu_scene->matrices);
        gl->BindBufferBase(GL_UNIFORM_BUFFER, UNIFORMS_VIEW, gpu_scene->views[0]);
    }
    for (int i = first; i < end; i++) {
        const Drawable *drawable = &gpu_scene->surfaces[i];
        GpuSceneKind *kind = &gpu_scene->kinds[drawable->kind];
        if (!drawable->seen || gpu_scene_traces(gpu_scene, drawable))
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
        material_feed(&kind->material, &gpu_scene->meshes[drawable->mesh]);
        if (gpu_scene->instances)
            mesh_draw_instances(gl, &gpu_scene->meshes[drawable->mesh], drawable->first_seen,
                                drawable->seen);
        else
            mesh_draw(gl, &gpu_scene->meshes[drawable->mesh]);
    }
    if (mirrored)
        gl->FrontFace(GL_CCW);
    if (solid)
        gl->Disable(GL_CULL_FACE);
}
