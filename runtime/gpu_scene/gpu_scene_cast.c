/* Shadow casters of a GPU scene, drawn for each light's view. Opaque casters are grouped by mesh
 * alone. */
#include "runtime/gpu_scene/gpu_scene_trace.h"
#include "runtime/gpu_scene/instances.h"
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

static Cast cast_of(const GpuScene *gpu_scene, uint32_t number)
{
    const GpuScenePlace *place = &gpu_scene->places[number];
    return (Cast){place->caster, place->cut, place->mesh, place->mirrored, number};
}

bool gpu_scene_arrange_casters(GlContext *gl, GpuScene *gpu_scene)
{
    Cast *casts = malloc((size_t)gpu_scene->place_count * sizeof *casts + 1);
    if (!casts)
        return gl_fail(gl, "out of memory");
    gpu_scene->cast_count = 0;
    for (int i = 0; i < gpu_scene->place_count; i++)
        if (!gpu_scene->places[i].transparent || gpu_scene->places[i].caster >= 0 ||
            gpu_scene->places[i].cut >= 0)
            casts[gpu_scene->cast_count++] = cast_of(gpu_scene, (uint32_t)i);
    qsort(casts, (size_t)gpu_scene->cast_count, sizeof *casts, compare);
    for (int i = 0; i < gpu_scene->cast_count; i++)
        gpu_scene->cast_order[i] = casts[i].place;
    free(casts);
    return true;
}

static bool is_wanted(const GpuScenePlace *place, const GpuSceneLight *light, bool transparent)
{
    return light->cut ? place->cut >= 0
                      : place->transparent == transparent && (!transparent || place->caster >= 0);
}

/* Lists the places in the light's view, in drawing order. Returns how many. */
static int list_seen(const GpuSceneSource *source, GpuScene *gpu_scene, const GpuSceneLight *light,
                     bool transparent)
{
    uint32_t *list = gpu_scene->list + (GPU_SCENE_LISTS - 1) * gpu_scene->place_count;
    int count = 0;
    for (int i = 0; i < gpu_scene->cast_count; i++) {
        const GpuScenePlace *place = &gpu_scene->places[gpu_scene->cast_order[i]];
        if (is_wanted(place, light, transparent) &&
            (!light->waves || light->waves[gpu_scene->cast_order[i]] == light->wave) &&
            !(light->varying && place->even) &&
            cull_sees(light->volume, &gpu_scene->boxes[place->mesh],
                      &source->scene->objects[place->object].world_from_local))
            list[count++] = gpu_scene->cast_order[i];
    }
    return count;
}

static void write_buffers(const GlContext *gl, const GpuScene *gpu_scene, const Spaces *spaces,
                          int count)
{
    const InstanceView view = instance_view(spaces);
    const size_t start =
        sizeof *gpu_scene->list * (GPU_SCENE_LISTS - 1) * (size_t)gpu_scene->place_count;
    gl->BindBuffer(GL_UNIFORM_BUFFER, gpu_scene->views[1]);
    gl->BufferData(GL_UNIFORM_BUFFER, sizeof view, &view, GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_ARRAY_BUFFER, gpu_scene->words);
    gl->BufferSubData(GL_ARRAY_BUFFER, (GLintptr)start, (GLsizeiptr)sizeof *gpu_scene->list * count,
                      gpu_scene->list + (GPU_SCENE_LISTS - 1) * gpu_scene->place_count);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, INSTANCE_MATRICES, gpu_scene->matrices);
    gl->BindBufferBase(GL_UNIFORM_BUFFER, UNIFORMS_VIEW, gpu_scene->views[1]);
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
static int group_of(const GpuScene *gpu_scene, const uint32_t *list, int count, bool by_kind)
{
    const int kind = gpu_scene->places[list[0]].kind;
    const Cast head = cast_of(gpu_scene, list[0]);
    int group = 1;
    for (; group < count && gpu_scene->instances; group++) {
        const Cast next = cast_of(gpu_scene, list[group]);
        if (next.caster != head.caster || next.cut != head.cut || next.mesh != head.mesh ||
            next.mirrored != head.mirrored ||
            (by_kind && gpu_scene->places[list[group]].kind != kind))
            break;
    }
    return group;
}

static void use(GlContext *gl, GpuSceneKind *caster, Material *material, const Material *before)
{
    material_use_after(material, before);
    if (material != before && caster && caster->numbers)
        gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, INSTANCE_NUMBERS, caster->numbers);
}

static bool is_traced(const GpuScene *gpu_scene, const GpuSceneLight *light,
                      const GpuScenePlace *place)
{
    const DisplacedTrace *trace = displaced_traced(&gpu_scene->displaced[place->mesh]);
    return light->traced && gpu_scene->tracing && !place->transparent &&
           gpu_scene->traced[place->kind].store && trace && !trace->parallax;
}

/* Returns the light's clip space with the camera's eye. */
static Spaces spaces_of(const GpuSceneSource *source, const GpuSceneLight *light)
{
    Spaces spaces = source->space->spaces;
    spaces.eye_from_world = mat4_identity();
    for (int i = 0; i < 16; i++)
        spaces.clip_from_eye.m[i] = (float)light->clip_from_world[i];
    return spaces;
}

void gpu_scene_cast(GlContext *gl, const GpuSceneSource *source, GpuScene *gpu_scene,
                    const GpuSceneLight *light, bool transparent)
{
    const int start = (GPU_SCENE_LISTS - 1) * gpu_scene->place_count;
    const int count = list_seen(source, gpu_scene, light, transparent);
    const uint32_t *list = gpu_scene->list + start;
    const Material *before = NULL;
    Spaces spaces = spaces_of(source, light);
    if (gpu_scene->instances && count)
        write_buffers(gl, gpu_scene, &spaces, count);
    for (int i = 0, group; i < count; i += group) {
        const GpuScenePlace *place = &gpu_scene->places[list[i]];
        const int number = light->cut ? place->cut : place->caster;
        GpuSceneKind *caster = light->kept  ? &gpu_scene->kinds[place->kind]
                               : number < 0 ? NULL
                                            : &gpu_scene->casters[number];
        Material *material = light->kept ? &light->kept[place->kind]
                             : caster    ? &caster->material
                                         : light->solid;
        group = group_of(gpu_scene, list + i, count - i, light->kept != NULL);
        gl->FrontFace(place->mirrored != light->mirrored ? GL_CW : GL_CCW);
        if (is_traced(gpu_scene, light, place)) {
            gpu_scene_trace_cast(gl, gpu_scene, place->mesh,
                                 &(GpuSceneTraceCast){light, start + i, group});
            before = NULL;
            continue;
        }
        if (material != before || !gpu_scene->instances)
            set_object(source->scene, place->object, &spaces, material);
        material_set_number(material, "glass_map", (float)light->number);
        use(gl, caster, material, before);
        before = material;
        material_feed(material, &gpu_scene->meshes[place->mesh]);
        if (gpu_scene->instances)
            mesh_draw_instances(gl, &gpu_scene->meshes[place->mesh], start + i, group);
        else
            mesh_draw(gl, &gpu_scene->meshes[place->mesh]);
    }
    gl->FrontFace(GL_CCW);
}
