/* The renderer's public functions: when resources are made, and which results are read. */
#include "runtime/renderer/renderer.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/indirect/indirect_methods.h"
#include "runtime/indirect/settings/indirect.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/light/light_far.h"
#include "runtime/post/post.h"
#include "runtime/renderer/frame_memory.h"
#include "runtime/renderer/passes.h"
#include "runtime/renderer/renderer_state.h"
#include "runtime/scene/scene_area.h"
#include "runtime/tessellate/scene_displace.h"
#include "runtime/scene/scene_origin.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/shadow_method.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

Slot renderer_find_slot(const char *name)
{
    int slot = 0;
    while (slot < SLOT_COUNT && strcmp(slot_table[slot].name, name) != 0)
        slot++;
    return (Slot)slot;
}

/* Returns a debug view; NULL for any other view. */
static const FrameLook *look_of(const char *view)
{
    static const FrameLook wireframe = {"wireframe", FRAME_LOOK_lines, FRAME_LOOK_none};
    return view && !strcmp(view, wireframe.name) ? &wireframe
                                                 : shadow_methods_look(shadow_methods, view);
}

bool renderer_view_is_picture(const char *view)
{
    return !strcmp(view, "final") || look_of(view) != NULL;
}

static bool is_target(const char *view)
{
    return renderer_view_is_picture(view) || !strcmp(view, "light") || !strcmp(view, "depth") ||
           !strcmp(view, "shadow") || voxels_view_level(view) >= 0 ||
           pass_positions_is_view(view) || indirect_view_components(view);
}

static Renderer *compose(RendererState *state)
{
    Renderer *renderer = &state->renderer;
    renderer->light = &state->light;
    renderer->shadows = &state->shadows;
    renderer->voxels = &state->voxels;
    renderer->radiance = &state->radiance;
    renderer->indirect = &state->indirect;
    renderer->positions = &state->positions;
    renderer->post = &state->post;
    renderer->transparent = &state->transparent;
    return renderer;
}

const char *renderer_view_canonical(const char *view)
{
    static const struct {
        const char *old, *name;
    } aliases[] = {{"shown", "final"}, {"open", "ao"}};
    for (size_t i = 0; view && i < sizeof aliases / sizeof *aliases; i++)
        if (!strcmp(view, aliases[i].old))
            return aliases[i].name;
    return view;
}

static bool is_view(const char *view)
{
    return !view || is_target(view) || renderer_find_slot(view) < SLOT_COUNT;
}

Renderer *renderer_open(GlContext *gl, const RendererOptions *options)
{
    RendererOptions named = *options;
    const char *view = named.view = renderer_view_canonical(options->view);
    options = &named;
    if (!is_view(view))
        return gl_fail(
                   gl,
                   "unknown view '%s'; expected final, wireframe, volume, light, depth, shadow, "
                   "positions, voxels, ao, indirect, bent, visibility, or a slot",
                   view),
               NULL;
    if (!transparency_check(gl, options) || !light_far_check(gl, options))
        return NULL;
    if (options->samples < 0 || options->samples > RENDERER_SAMPLES_MAX)
        return gl_fail(gl, "samples are 1 to %d, not %d", RENDERER_SAMPLES_MAX, options->samples),
               NULL;
    RendererState *state = calloc(1, sizeof *state);
    if (!state)
        return gl_fail(gl, "out of memory"), NULL;
    Renderer *renderer = compose(state);
    renderer->gl = gl;
    renderer->options = *options;
    renderer->look = look_of(view);
    if (renderer->look)
        renderer->options.view = NULL; /* a debug view is a variant of the picture */
    renderer->samples = options->samples ? options->samples : 1;
    renderer->surface = options->surface ? options->surface : &surface_model_phong;
    renderer->compile = *options->compile;
    renderer->compile.normals = "eye"; /* lighting happens in eye space */
    renderer->compute = !options->fragment && gl->major * 10 + gl->minor >= 43 &&
                        gl->DispatchCompute && gl->BindImageTexture && gl->MemoryBarrier;
    renderer->zero_to_one = gl->ClipControl != NULL && gl->major * 10 + gl->minor >= 45;
    renderer->store = shadow_methods_open(renderer, shadow_methods) ? store_new(gl) : NULL;
    renderer->has_screen = renderer->store && screen_make(gl, &renderer->screen);
    if (renderer->has_screen)
        return renderer;
    renderer_close(renderer);
    return NULL;
}

/* Frees all resources that depend on the scene. */
static void forget_scene(Renderer *renderer)
{
    if (renderer->has_reader)
        reader_delete(&renderer->reader);
    renderer->has_reader = false;
    frame_clear(renderer);
    gpu_scene_delete(renderer->gl, &renderer->gpu_scene);
    material_set_free(&renderer->set);
    renderer->scene = NULL;
}

void renderer_close(Renderer *renderer)
{
    if (!renderer)
        return;
    GlContext *gl = renderer->gl;
    if (renderer->store) {
        gl->UseProgram(0);
        gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
        forget_scene(renderer);
        frame_retired_delete(renderer);
        material_delete(&renderer->shadows->solid);
    }
    if (renderer->has_screen)
        screen_delete(gl, &renderer->screen);
    shadow_methods_close(renderer);
    store_free(renderer->store);
    gl->ActiveTexture(GL_TEXTURE0);
    renderer_param_forget(renderer);
    free(renderer->kept_lights);
    free(renderer);
}

static Target target_of(const MaterialSet *set)
{
    int target = 0;
    while (strcmp(target_table[target].name, set->target) != 0)
        target++;
    return (Target)target;
}

/* Makes the program that reads a slot, if the view is one. */
static bool make_reader(Renderer *renderer)
{
    const char *view = renderer->options.view;
    if (!view || is_target(view) || !renderer->set.unpack)
        return true;
    const LayoutRow *layout = material_set_layout(&renderer->set, &renderer->compile);
    const ReaderSource source = {renderer->set.unpack, target_of(&renderer->set), layout,
                                 renderer->size[0], renderer->size[1]};
    renderer->has_reader = reader_make(renderer->store, &source, &renderer->reader);
    return renderer->has_reader;
}

static void set_size(Renderer *renderer, const Scene *scene)
{
    const RendererOptions *options = &renderer->options;
    const int whole[2] = {options->width ? options->width : scene->width,
                          options->height ? options->height : scene->height};
    for (int i = 0; i < 2; i++) {
        renderer->whole[i] = whole[i] * renderer->samples;
        renderer->at[i] = 0;
    }
}

static void look(Renderer *renderer)
{
    const SceneCamera *camera = &renderer->scene->camera;
    view_space_make(camera, renderer->whole, renderer->zero_to_one, &renderer->space);
    view_space_place(&renderer->space, renderer->whole, renderer->at);
    renderer->space.spaces.time = (float)renderer->scene->time;
    for (int i = 0; i < 3; i++)
        renderer->space.spaces.origin[i] = (float)renderer->scene->origin[i];
    cull_volume(camera, renderer->whole, &renderer->volume);
}

static bool make_set(Renderer *renderer, const Scene *scene)
{
    const MaterialSetUses uses = {shadow_casts(renderer),
                                  pass_voxels_needed(renderer) &&
                                      transparency_has_lists(renderer->gl),
                                  shadow_methods_need(renderer).even};
    renderer->compile.origin = scene_origin_used(scene);
    if (!material_set_make(renderer->gl, scene, &renderer->compile, uses, &renderer->set))
        return false;
    /* a scene with only a sky has no surface */
    const LayoutRow *layout =
        renderer->set.unpack ? material_set_layout(&renderer->set, &renderer->compile) : NULL;
    if (!renderer->options.surface)
        renderer->surface = surface_model_of(layout, scene_models(scene));
    surface_model_define(scene_models(scene), renderer->surface_missing);
    for (int i = 0; renderer->options.opaque && i < renderer->set.count; i++) {
        renderer->set.programs[i].transparent = false;
        renderer->set.programs[i].caster = renderer->set.programs[i].cut = -1;
    }
    return true;
}

static bool wants_triangles(const Renderer *renderer)
{
    return pass_edge_needed(renderer) || pass_voxels_needed(renderer) ||
           shadow_methods_need(renderer).triangles;
}

/* Converts patches into meshes if the driver cannot displace them. */
static bool settle_patches(Renderer *renderer, const Scene *scene)
{
    const SceneMaterial *material;
    renderer->triangles = wants_triangles(renderer);
    renderer->beside = shadow_methods_need(renderer).beside;
    if (!scene->displaced || displaced_supported(renderer->gl, scene->displaced_by) ||
        scene_displace_patches(scene))
        return true;
    const char *why = scene_displace_fault(scene, &material);
    return gl_fail(renderer->gl, "the material '%s': its displacement %s",
                   matc_material_name(material->document, material->index), why);
}

static bool make_scene(Renderer *renderer, const Scene *scene, GpuScene *before)
{
    renderer->scene = scene;
    indirect_methods_select(renderer);
    if (!renderer_lights_keep(renderer))
        return false;
    set_size(renderer, scene);
    look(renderer);
    if (indirect_missing_view(renderer))
        return gl_fail(renderer->gl, "view '%s' is not available: %s", renderer->options.view,
                       indirect_missing_view(renderer));
    if (!settle_patches(renderer, scene) || !make_set(renderer, scene) ||
        !plane_transmittance_check(renderer))
        return false;
    if (plane_transmittance_needed(renderer))
        renderer->transparency = TRANSPARENCY_peeling;
    const ShadowMethod *sees = shadow_method_seen(renderer);
    renderer->triangle_id_text = sees ? sees->seen : NULL;
    const GpuSceneSource source = frame_source(renderer);
    return gpu_scene_make(renderer->store, &source, before, &renderer->gpu_scene) &&
           shadow_make_views(renderer) && shadow_methods_make(renderer) && frame_make(renderer) &&
           make_reader(renderer);
}

static bool make_next(Renderer *renderer, const Scene *scene, GpuScene *before)
{
    renderer->transparency = transparency_first(renderer);
    renderer->tiled = false;
    while (!make_scene(renderer, scene, before)) {
        const bool again = frame_fall_back(renderer);
        forget_scene(renderer);
        if (!again)
            return false;
    }
    return true;
}

/* Builds the new scene before freeing the old, so that shared programs and textures survive. */
static bool make_again(Renderer *renderer, const Scene *scene)
{
    GpuScene before = renderer->gpu_scene;
    renderer->gpu_scene = (GpuScene){0};
    forget_scene(renderer);
    const bool done = make_next(renderer, scene, &before);
    gpu_scene_delete(renderer->gl, &before);
    if (!done)
        forget_scene(renderer);
    frame_retired_delete(renderer);
    return done;
}

bool renderer_set_scene(Renderer *renderer, const Scene *scene)
{
    renderer_param_forget(renderer);
    return make_again(renderer, scene);
}

static bool has_scene(const Renderer *renderer)
{
    return renderer->scene || gl_fail(renderer->gl, "no scene to change");
}

/* Reports whether the origin of the scene's coordinates has moved since the last rebuild, which
 * invalidates all resources. */
static bool origin_moved(const Renderer *renderer)
{
    bool moved = false;
    for (int i = 0; i < 3; i++)
        moved |= renderer->space.spaces.origin[i] != (float)renderer->scene->origin[i];
    return moved;
}

bool renderer_changed(Renderer *renderer, unsigned what)
{
    if (!has_scene(renderer))
        return false;
    if (origin_moved(renderer))
        return renderer_changed_meshes(renderer);
    if (what & RENDERER_LIGHTS && !renderer_lights_kept(renderer))
        return renderer_changed_meshes(renderer);
    if (what & (RENDERER_CAMERA | RENDERER_TIME) ||
        (what & RENDERER_LIGHTS && gpu_scene_mesh_by_lights(&renderer->gpu_scene))) {
        look(renderer);
        const GpuSceneSource source = frame_source(renderer);
        if (!gpu_scene_view(renderer->gl, &source, &renderer->gpu_scene))
            return false;
        if ((renderer->gpu_scene.displaced_rebuilt && source.triangles) ||
            !frame_memory_fits(renderer))
            return renderer_changed_meshes(renderer);
        what |= renderer->gpu_scene.displaced_rebuilt ? FRAME_SHAPES : 0;
        renderer->gpu_scene.displaced_rebuilt = false;
    }
    /* the number of alpha-tested fragments may have changed */
    renderer->uncounted |= (what & (RENDERER_CAMERA | RENDERER_TIME)) != 0;
    return frame_changed(renderer, what) && gl_check(renderer->gl, "changing a scene");
}

bool renderer_changed_objects(Renderer *renderer, int first, int count)
{
    if (!has_scene(renderer))
        return false;
    const GpuSceneSource source = frame_source(renderer);
    if (first < 0 || count < 0 || first > renderer->scene->object_count - count)
        return gl_fail(renderer->gl, "there are no objects %d to %d", first, first + count - 1);
    if (origin_moved(renderer))
        return renderer_changed_meshes(renderer);
    renderer->uncounted = true;
    return gpu_scene_move(renderer->gl, &source, &renderer->gpu_scene, first, count) &&
           frame_objects_moved(renderer, first, count) && gl_check(renderer->gl, "moving objects");
}

bool renderer_rebuild(Renderer *renderer, const Scene *scene)
{
    if (!make_again(renderer, scene))
        return false;
    renderer_param_rebuild(renderer);
    return true;
}

bool renderer_resize(Renderer *renderer, int width, int height)
{
    char why[sizeof renderer->gl->error];
    const int before[2] = {renderer->options.width, renderer->options.height};
    const Scene *scene = renderer->scene;
    renderer->options.width = width;
    renderer->options.height = height;
    if (!scene || renderer_rebuild(renderer, scene))
        return true;
    snprintf(why, sizeof why, "%s", renderer->gl->error);
    renderer->options.width = before[0];
    renderer->options.height = before[1];
    renderer_rebuild(renderer, scene);
    return gl_fail(renderer->gl, "%s", why);
}

bool renderer_changed_meshes(Renderer *renderer)
{
    return has_scene(renderer) && renderer_rebuild(renderer, renderer->scene);
}

/* Measures again: a change may bring more transparent fragments, or layers. If the linked lists
 * would be too long, the scene is rebuilt. */
static bool recount(Renderer *renderer)
{
    renderer->uncounted = false;
    return frame_count(renderer) ||
           (frame_fall_back(renderer) && renderer_changed_meshes(renderer));
}

bool renderer_frame(Renderer *renderer)
{
    if (!renderer->scene)
        return gl_fail(renderer->gl, "no scene to draw");
    if (renderer->uncounted && !recount(renderer))
        return false;
    frame_draw(renderer);
    return true;
}

int renderer_components(const Renderer *renderer)
{
    const char *view = renderer->options.view;
    if (view && indirect_view_components(view))
        return indirect_view_components(view);
    if (!view || !strcmp(view, "final") || !strcmp(view, "light") || voxels_view_level(view) >= 0 ||
        pass_positions_is_view(view))
        return 4;
    const int components = strcmp(view, "depth") && strcmp(view, "shadow")
                               ? type_table[slot_table[renderer_find_slot(view)].type].components
                               : 1;
    return components == 2 ? 3 : components;
}

void renderer_set_tile(Renderer *renderer, int x, int y)
{
    const int at[2] = {x * renderer->samples - renderer->margin,
                       y * renderer->samples - renderer->margin};
    if (renderer->at[0] == at[0] && renderer->at[1] == at[1])
        return;
    memcpy(renderer->at, at, sizeof renderer->at);
    frame_place(renderer);
}

int renderer_width(const Renderer *renderer) { return renderer->whole[0] / renderer->samples; }
int renderer_height(const Renderer *renderer) { return renderer->whole[1] / renderer->samples; }
int renderer_tile_width(const Renderer *renderer)
{
    return (renderer->size[0] - 2 * renderer->margin) / renderer->samples;
}
int renderer_tile_height(const Renderer *renderer)
{
    return (renderer->size[1] - 2 * renderer->margin) / renderer->samples;
}
