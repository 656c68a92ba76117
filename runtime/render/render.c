/* The renderer's public functions: when resources are made, and which results are read. */
#include "runtime/render/render.h"
#include "runtime/frame/transparency_draw.h"
#include "runtime/indirect/indirect_methods.h"
#include "runtime/indirect/settings/indirect.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/light/light_far.h"
#include "runtime/post/post.h"
#include "runtime/render/frame_memory.h"
#include "runtime/render/passes.h"
#include "runtime/render/render_state.h"
#include "runtime/scene/scene_area.h"
#include "runtime/tessellate/scene_displace.h"
#include "runtime/scene/scene_origin.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/shadow_method.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

Slot render_find_slot(const char *name)
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

bool render_view_is_picture(const char *view)
{
    return !strcmp(view, "shown") || look_of(view) != NULL;
}

static bool is_target(const char *view)
{
    return render_view_is_picture(view) || !strcmp(view, "light") || !strcmp(view, "depth") ||
           !strcmp(view, "shadow") || voxels_view_level(view) >= 0 ||
           pass_positions_is_view(view) || indirect_view_lanes(view);
}

static Render *compose(RenderState *state)
{
    Render *render = &state->render;
    render->light = &state->light;
    render->shadows = &state->shadows;
    render->voxels = &state->voxels;
    render->radiance = &state->radiance;
    render->indirect = &state->indirect;
    render->positions = &state->positions;
    render->picture = &state->picture;
    render->glass = &state->glass;
    return render;
}

Render *render_open(GlContext *gl, const RenderOptions *options)
{
    if (options->view && !is_target(options->view) && render_find_slot(options->view) == SLOT_COUNT)
        return gl_fail(gl,
                       "there is no view '%s': shown, wireframe, volume, light, depth, shadow, "
                       "positions, voxels, open, "
                       "indirect, bent, visibility, or a slot",
                       options->view),
               NULL;
    if (!transparency_check(gl, options) || !light_far_check(gl, options))
        return NULL;
    if (options->samples < 0 || options->samples > RENDER_SAMPLES_MOST)
        return gl_fail(gl, "samples are 1 to %d, not %d", RENDER_SAMPLES_MOST, options->samples),
               NULL;
    RenderState *state = calloc(1, sizeof *state);
    if (!state)
        return gl_fail(gl, "out of memory"), NULL;
    Render *render = compose(state);
    render->gl = gl;
    render->options = *options;
    render->look = look_of(options->view);
    if (render->look)
        render->options.view = NULL; /* a debug view is a variant of the picture */
    render->samples = options->samples ? options->samples : 1;
    render->surface = options->surface ? options->surface : &surface_model_phong;
    render->compile = *options->compile;
    render->compile.normals = "eye"; /* lighting happens in eye space */
    render->compute = !options->fragment && gl->major * 10 + gl->minor >= 43 &&
                      gl->DispatchCompute && gl->BindImageTexture && gl->MemoryBarrier;
    render->zero_to_one = gl->ClipControl != NULL && gl->major * 10 + gl->minor >= 45;
    render->store = shadow_methods_open(render, shadow_methods) ? store_new(gl) : NULL;
    render->has_screen = render->store && screen_make(gl, &render->screen);
    if (render->has_screen)
        return render;
    render_close(render);
    return NULL;
}

/* Frees all resources that depend on the scene. */
static void forget_scene(Render *render)
{
    if (render->has_reader)
        reader_delete(&render->reader);
    render->has_reader = false;
    frame_clear(render);
    gpu_scene_delete(render->gl, &render->gpu_scene);
    material_set_free(&render->set);
    render->scene = NULL;
}

void render_close(Render *render)
{
    if (!render)
        return;
    GlContext *gl = render->gl;
    if (render->store) {
        gl->UseProgram(0);
        gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
        forget_scene(render);
        frame_retired_delete(render);
        material_delete(&render->shadows->solid);
    }
    if (render->has_screen)
        screen_delete(gl, &render->screen);
    shadow_methods_close(render);
    store_free(render->store);
    gl->ActiveTexture(GL_TEXTURE0);
    render_param_forget(render);
    free(render->kept_lights);
    free(render);
}

static Target target_of(const MaterialSet *set)
{
    int target = 0;
    while (strcmp(target_table[target].name, set->target) != 0)
        target++;
    return (Target)target;
}

/* Makes the program that reads a slot, if the view is one. */
static bool make_reader(Render *render)
{
    const char *view = render->options.view;
    if (!view || is_target(view) || !render->set.unpack)
        return true;
    const LayoutRow *layout = material_set_layout(&render->set, &render->compile);
    const ReaderSource source = {render->set.unpack, target_of(&render->set), layout,
                                 render->size[0], render->size[1]};
    render->has_reader = reader_make(render->store, &source, &render->reader);
    return render->has_reader;
}

static void set_size(Render *render, const Scene *scene)
{
    const RenderOptions *options = &render->options;
    const int whole[2] = {options->width ? options->width : scene->width,
                          options->height ? options->height : scene->height};
    for (int i = 0; i < 2; i++) {
        render->whole[i] = whole[i] * render->samples;
        render->at[i] = 0;
    }
}

static void look(Render *render)
{
    const SceneCamera *camera = &render->scene->camera;
    view_space_make(camera, render->whole, render->zero_to_one, &render->space);
    view_space_place(&render->space, render->whole, render->at);
    render->space.spaces.time = (float)render->scene->time;
    for (int i = 0; i < 3; i++)
        render->space.spaces.origin[i] = (float)render->scene->origin[i];
    cull_volume(camera, render->whole, &render->volume);
}

static bool make_set(Render *render, const Scene *scene)
{
    const MaterialSetUses uses = {shadow_casts(render),
                                  pass_voxels_needed(render) && transparency_has_lists(render->gl),
                                  shadow_methods_need(render).even};
    render->compile.origin = scene_origin_used(scene);
    if (!material_set_make(render->gl, scene, &render->compile, uses, &render->set))
        return false;
    /* a scene with only a sky has no surface */
    const LayoutRow *layout =
        render->set.unpack ? material_set_layout(&render->set, &render->compile) : NULL;
    if (!render->options.surface)
        render->surface = surface_model_of(layout, scene_models(scene));
    surface_model_define(scene_models(scene), render->surface_lacks);
    for (int i = 0; render->options.opaque && i < render->set.count; i++) {
        render->set.programs[i].transparent = false;
        render->set.programs[i].caster = render->set.programs[i].cut = -1;
    }
    return true;
}

static bool wants_triangles(const Render *render)
{
    return pass_edge_needed(render) || pass_voxels_needed(render) ||
           shadow_methods_need(render).triangles;
}

/* Converts patches into meshes if the driver cannot displace them. */
static bool settle_patches(Render *render, const Scene *scene)
{
    const SceneMaterial *material;
    render->triangles = wants_triangles(render);
    render->beside = shadow_methods_need(render).beside;
    if (!scene->displaced || displaced_there(render->gl, scene->displaced_by) ||
        scene_displace_patches(scene))
        return true;
    const char *why = scene_displace_fault(scene, &material);
    return gl_fail(render->gl, "the material '%s': its displacement %s",
                   matc_material_name(material->document, material->index), why);
}

static bool make_scene(Render *render, const Scene *scene, GpuScene *before)
{
    render->scene = scene;
    indirect_methods_select(render);
    if (!render_lights_keep(render))
        return false;
    set_size(render, scene);
    look(render);
    if (indirect_lacks_view(render))
        return gl_fail(render->gl, "there is nothing to see of view '%s': %s", render->options.view,
                       indirect_lacks_view(render));
    if (!settle_patches(render, scene) || !make_set(render, scene) || !shadow_sheet_check(render))
        return false;
    if (shadow_sheet_needed(render))
        render->transparency = TRANSPARENCY_peeling;
    const ShadowMethod *sees = shadow_method_seen(render);
    render->seen_text = sees ? sees->seen : NULL;
    const GpuSceneSource source = frame_source(render);
    return gpu_scene_make(render->store, &source, before, &render->gpu_scene) &&
           shadow_make_views(render) && shadow_methods_make(render) && frame_make(render) &&
           make_reader(render);
}

static bool make_next(Render *render, const Scene *scene, GpuScene *before)
{
    render->transparency = transparency_first(render);
    render->parted = false;
    while (!make_scene(render, scene, before)) {
        const bool again = frame_fall_back(render);
        forget_scene(render);
        if (!again)
            return false;
    }
    return true;
}

/* Builds the new scene before freeing the old, so that shared programs and textures survive. */
static bool make_again(Render *render, const Scene *scene)
{
    GpuScene before = render->gpu_scene;
    render->gpu_scene = (GpuScene){0};
    forget_scene(render);
    const bool done = make_next(render, scene, &before);
    gpu_scene_delete(render->gl, &before);
    if (!done)
        forget_scene(render);
    frame_retired_delete(render);
    return done;
}

bool render_scene(Render *render, const Scene *scene)
{
    render_param_forget(render);
    return make_again(render, scene);
}

static bool has_scene(const Render *render)
{
    return render->scene || gl_fail(render->gl, "there is no scene to change");
}

/* Reports whether the origin of the scene's coordinates has moved since the last rebuild, which
 * invalidates all resources. */
static bool origin_moved(const Render *render)
{
    bool moved = false;
    for (int i = 0; i < 3; i++)
        moved |= render->space.spaces.origin[i] != (float)render->scene->origin[i];
    return moved;
}

bool render_changed(Render *render, unsigned what)
{
    if (!has_scene(render))
        return false;
    if (origin_moved(render))
        return render_changed_meshes(render);
    if (what & RENDER_LIGHTS && !render_lights_kept(render))
        return render_changed_meshes(render);
    if (what & (RENDER_CAMERA | RENDER_TIME) ||
        (what & RENDER_LIGHTS && gpu_scene_mesh_by_lights(&render->gpu_scene))) {
        look(render);
        const GpuSceneSource source = frame_source(render);
        if (!gpu_scene_view(render->gl, &source, &render->gpu_scene))
            return false;
        if ((render->gpu_scene.displaced_anew && source.triangles) || !frame_memory_fits(render))
            return render_changed_meshes(render);
        what |= render->gpu_scene.displaced_anew ? FRAME_SHAPES : 0;
        render->gpu_scene.displaced_anew = false;
    }
    /* the number of alpha-tested fragments may have changed */
    render->uncounted |= (what & (RENDER_CAMERA | RENDER_TIME)) != 0;
    return frame_changed(render, what) && gl_check(render->gl, "changing a scene");
}

bool render_changed_objects(Render *render, int first, int count)
{
    if (!has_scene(render))
        return false;
    const GpuSceneSource source = frame_source(render);
    if (first < 0 || count < 0 || first > render->scene->object_count - count)
        return gl_fail(render->gl, "there are no objects %d to %d", first, first + count - 1);
    if (origin_moved(render))
        return render_changed_meshes(render);
    render->uncounted = true;
    return gpu_scene_move(render->gl, &source, &render->gpu_scene, first, count) &&
           frame_objects_moved(render, first, count) && gl_check(render->gl, "moving objects");
}

bool render_again(Render *render, const Scene *scene)
{
    if (!make_again(render, scene))
        return false;
    render_param_again(render);
    return true;
}

bool render_resize(Render *render, int width, int height)
{
    char why[sizeof render->gl->error];
    const int before[2] = {render->options.width, render->options.height};
    const Scene *scene = render->scene;
    render->options.width = width;
    render->options.height = height;
    if (!scene || render_again(render, scene))
        return true;
    snprintf(why, sizeof why, "%s", render->gl->error);
    render->options.width = before[0];
    render->options.height = before[1];
    render_again(render, scene);
    return gl_fail(render->gl, "%s", why);
}

bool render_changed_meshes(Render *render)
{
    return has_scene(render) && render_again(render, render->scene);
}

/* Measures again: a change may bring more transparent fragments, or layers. If the linked lists
 * would be too long, the scene is rebuilt. */
static bool recount(Render *render)
{
    render->uncounted = false;
    return frame_count(render) || (frame_fall_back(render) && render_changed_meshes(render));
}

bool render_frame(Render *render)
{
    if (!render->scene)
        return gl_fail(render->gl, "there is no scene to draw");
    if (render->uncounted && !recount(render))
        return false;
    frame_draw(render);
    return true;
}

int render_lanes(const Render *render)
{
    const char *view = render->options.view;
    if (view && indirect_view_lanes(view))
        return indirect_view_lanes(view);
    if (!view || !strcmp(view, "shown") || !strcmp(view, "light") || voxels_view_level(view) >= 0 ||
        pass_positions_is_view(view))
        return 4;
    const int lanes = strcmp(view, "depth") && strcmp(view, "shadow")
                          ? type_table[slot_table[render_find_slot(view)].type].lanes
                          : 1;
    return lanes == 2 ? 3 : lanes;
}

void render_move(Render *render, int x, int y)
{
    const int at[2] = {x * render->samples - render->margin, y * render->samples - render->margin};
    if (render->at[0] == at[0] && render->at[1] == at[1])
        return;
    memcpy(render->at, at, sizeof render->at);
    frame_place(render);
}

int render_width(const Render *render) { return render->whole[0] / render->samples; }
int render_height(const Render *render) { return render->whole[1] / render->samples; }
int render_tile_width(const Render *render)
{
    return (render->size[0] - 2 * render->margin) / render->samples;
}
int render_tile_height(const Render *render)
{
    return (render->size[1] - 2 * render->margin) / render->samples;
}
