/* The pass shadow: draws depth maps from the lights. The maps are kept until the scene changes;
 * further frames reuse them. shadow.glsl reads them. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/scene/scene_area.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/shadow_method.h"

enum { SHADOW_MAPS_MIB = 4096 };

/* Limits the memory: some drivers overcommit, and terminate the program when the memory is
 * written. */
static bool check_maps(const Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    const int size = renderer->scene->shadow_size, count = renderer->shadows->views.count;
    const int64_t mib = (int64_t)count * size * size * (int64_t)sizeof(float) >> 20;
    GLint most = 0;
    gl->GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    if (count > most || size > gl->max_texture_size)
        return gl_fail(gl, "%d shadow maps of %d x %d are asked for, the driver has %d of %d x %d",
                       count, size, size, most, gl->max_texture_size, gl->max_texture_size);
    return mib <= SHADOW_MAPS_MIB ||
           gl_fail(gl, "%d shadow maps of %d x %d take %d MiB; at most %d are made", count, size,
                   size, (int)mib, SHADOW_MAPS_MIB);
}

static bool make_maps(Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    ShadowMaps *maps = renderer->shadows;
    const int size = renderer->scene->shadow_size, count = maps->views.count;
    if (!check_maps(renderer))
        return false;
    gl->GenTextures(1, &maps->maps);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, maps->maps);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    gl->TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, size, size, count, 0,
                   GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    gl->GenFramebuffers(1, &maps->framebuffer);
    return gl_check(gl, "making shadow maps");
}

static bool make_solid(Renderer *renderer)
{
    ShadowMaps *maps = renderer->shadows;
    const bool instances = renderer->gpu_scene.instances,
               modern = renderer->gl->major * 10 + renderer->gl->minor >= 45;
    const char *head = modern ? "#version 450 core\n" : "#version 330 core\n";
    const ProgramText text = {
        .vertex = {head, instances ? "#define INSTANCES\n" : "", render_text_shadow_depth},
        .fragment = {head, "void main() {}\n"}};
    return maps->solid.store || material_make(renderer->store, NULL, &text, &maps->solid);
}

/* Draws the depth maps, and allocates their lists of transparent fragments. */
static bool pass_shadow_count(Renderer *renderer)
{
    if (!shadow_glass_needed(renderer) || !renderer->shadows->maps || renderer->shadows->drawn)
        return true;
    shadow_draw_depths(renderer);
    renderer->shadows->drawn = shadow_parts_count(renderer);
    return renderer->shadows->drawn;
}

static bool pass_shadow_make(Renderer *renderer)
{
    bool fine = make_maps(renderer) && make_solid(renderer);
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        fine = fine && (!(*row)->make_maps || (*row)->make_maps(renderer));
    return fine && shadow_parts_make(renderer) && pass_shadow_count(renderer);
}

static void pass_shadow_draw(Renderer *renderer)
{
    if (renderer->shadows->drawn)
        return;
    shadow_draw_depths(renderer);
    if (shadow_glass_needed(renderer) && !renderer->tiled)
        shadow_draw_lists(renderer, renderer->shadows->glass.parts);
    renderer->shadows->drawn = true;
}

static void pass_shadow_forget(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    ShadowMaps *maps = renderer->shadows;
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        if ((*row)->forget)
            (*row)->forget(renderer);
    gl->DeleteFramebuffers(1, &maps->framebuffer); /* GL ignores the name 0 */
    gl->DeleteTextures(1, &maps->maps);
    gl->DeleteTextures(1, &maps->table);
    gl->DeleteTextures(1, &maps->planes);
    shadow_views_free(&maps->views);
    shadow_glass_delete(renderer);
    plane_transmittance_delete(renderer);
    *maps = (ShadowMaps){.solid = maps->solid, .methods = maps->methods};
}

/* -- the pass's row, which also updates the techniques' state */

static void pass_shadow_place(Renderer *renderer)
{
    renderer->shadows->seen = false;
    plane_transmittance_place(renderer);
}

static bool pass_shadow_changed(Renderer *renderer, unsigned what)
{
    const bool fitted = what & RENDERER_CAMERA &&
                        (renderer->scene->shadow_cascades > 1 || scene_area_cuts(renderer->scene));
    if (what & (RENDERER_TIME | FRAME_SHAPES)) /* alpha-tested casters may have changed */
        renderer->shadows->drawn = false;
    if (what & RENDERER_CAMERA)
        renderer->shadows->seen = false;
    bool fine = shadow_change(renderer, fitted || what & RENDERER_LIGHTS);
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        fine = fine && (!(*row)->changed || (*row)->changed(renderer, what));
    return fine;
}

static bool pass_shadow_moved(Renderer *renderer, int first, int count)
{
    bool fine = shadow_change(renderer, true);
    renderer->shadows->seen = false;
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        fine = fine && (!(*row)->moved || (*row)->moved(renderer, first, count));
    return fine;
}

static bool pass_shadow_fall_back(Renderer *renderer)
{
    if (!shadow_parts_fall_back(renderer))
        return false;
    renderer->tiled = true;
    return true;
}

const FramePass pass_shadow = {
    .plan = {"shadow", .fills = FRAME_BIT(shadow)},
    .when = "a light's shadows are cast; once, then they are kept",
    .needed = shadow_has_maps,
    .make = pass_shadow_make,
    .recount = pass_shadow_count,
    .draw = pass_shadow_draw,
    .place = pass_shadow_place,
    .changed = pass_shadow_changed,
    .moved = pass_shadow_moved,
    .fall_back = pass_shadow_fall_back,
    .forget = pass_shadow_forget,
};
