/* The pass shadow: draws depth maps from the lights. The maps are kept until the scene changes;
 * further frames reuse them. shadow.glsl reads them. */
#include "gen/render_text.h"
#include "runtime/frame/frame.h"
#include "runtime/scene/scene_area.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/shadow_method.h"

enum { SHADOW_MAPS_MIB = 4096 };

/* Limits the memory: some drivers overcommit, and terminate the program when the memory is
 * written. */
static bool check_maps(const Render *render)
{
    GlContext *gl = render->gl;
    const int size = render->scene->shadow_size, count = render->shadows->views.count;
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

static bool make_maps(Render *render)
{
    GlContext *gl = render->gl;
    ShadowMaps *maps = render->shadows;
    const int size = render->scene->shadow_size, count = maps->views.count;
    if (!check_maps(render))
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

static bool make_solid(Render *render)
{
    ShadowMaps *maps = render->shadows;
    const bool instances = render->gpu_scene.instances,
               modern = render->gl->major * 10 + render->gl->minor >= 45;
    const char *head = modern ? "#version 450 core\n" : "#version 330 core\n";
    const ProgramText text = {
        .vertex = {head, instances ? "#define INSTANCES\n" : "", render_text_shadow_depth},
        .fragment = {head, "void main() {}\n"}};
    return maps->solid.store || material_make(render->store, NULL, &text, &maps->solid);
}

/* Draws the depth maps, and allocates their lists of transparent fragments. */
static bool pass_shadow_count(Render *render)
{
    if (!shadow_glass_needed(render) || !render->shadows->maps || render->shadows->drawn)
        return true;
    shadow_draw_depths(render);
    render->shadows->drawn = shadow_parts_count(render);
    return render->shadows->drawn;
}

static bool pass_shadow_make(Render *render)
{
    bool fine = make_maps(render) && make_solid(render);
    for (const ShadowMethod *const *row = shadow_methods_of(render); *row; row++)
        fine = fine && (!(*row)->make_maps || (*row)->make_maps(render));
    return fine && shadow_parts_make(render) && pass_shadow_count(render);
}

static void pass_shadow_draw(Render *render)
{
    if (render->shadows->drawn)
        return;
    shadow_draw_depths(render);
    if (shadow_glass_needed(render) && !render->parted)
        shadow_draw_lists(render, render->shadows->glass.parts);
    render->shadows->drawn = true;
}

static void pass_shadow_forget(Render *render)
{
    const GlContext *gl = render->gl;
    ShadowMaps *maps = render->shadows;
    for (const ShadowMethod *const *row = shadow_methods_of(render); *row; row++)
        if ((*row)->forget)
            (*row)->forget(render);
    gl->DeleteFramebuffers(1, &maps->framebuffer); /* GL ignores the name 0 */
    gl->DeleteTextures(1, &maps->maps);
    gl->DeleteTextures(1, &maps->table);
    gl->DeleteTextures(1, &maps->planes);
    shadow_views_free(&maps->views);
    shadow_glass_delete(render);
    shadow_sheet_delete(render);
    *maps = (ShadowMaps){.solid = maps->solid, .methods = maps->methods};
}

/* -- the pass's row, which also updates the techniques' state */

static void pass_shadow_place(Render *render)
{
    render->shadows->seen = false;
    shadow_sheet_place(render);
}

static bool pass_shadow_changed(Render *render, unsigned what)
{
    const bool fitted = what & RENDER_CAMERA &&
                        (render->scene->shadow_cascades > 1 || scene_area_cuts(render->scene));
    if (what & (RENDER_TIME | FRAME_SHAPES)) /* alpha-tested casters may have changed */
        render->shadows->drawn = false;
    if (what & RENDER_CAMERA)
        render->shadows->seen = false;
    bool fine = shadow_change(render, fitted || what & RENDER_LIGHTS);
    for (const ShadowMethod *const *row = shadow_methods_of(render); *row; row++)
        fine = fine && (!(*row)->changed || (*row)->changed(render, what));
    return fine;
}

static bool pass_shadow_moved(Render *render, int first, int count)
{
    bool fine = shadow_change(render, true);
    render->shadows->seen = false;
    for (const ShadowMethod *const *row = shadow_methods_of(render); *row; row++)
        fine = fine && (!(*row)->moved || (*row)->moved(render, first, count));
    return fine;
}

static bool pass_shadow_fall_back(Render *render)
{
    if (!shadow_parts_fall_back(render))
        return false;
    render->parted = true;
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
