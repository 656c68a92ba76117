/* The list of passes, and the targets between them. */
#include "runtime/glass/glass.h"
#include "runtime/indirect/indirect.h"
#include "runtime/indirect/indirect_motion.h"
#include "runtime/indirect/radiance.h"
#include "runtime/indirect/voxels.h"
#include "runtime/light/light_far.h"
#include "runtime/picture/picture.h"
#include "runtime/render/frame_memory.h"
#include "runtime/render/passes.h"
#include "runtime/shadow/exact.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/volume.h"
#include <string.h>

#define DEPTH    (1u << FRAME_TARGET_depth)
#define GBUFFER  (1u << FRAME_TARGET_gbuffer)
#define TRACED   (1u << FRAME_TARGET_traced)
#define SHADOW   (1u << FRAME_TARGET_shadow)
#define FAR      (1u << FRAME_TARGET_far)
#define VOXELS   (1u << FRAME_TARGET_voxels)
#define CUBES    (1u << FRAME_TARGET_cubes)
#define MESH     (1u << FRAME_TARGET_positions | 1u << FRAME_TARGET_layer_depth)
#define RADIANCE (1u << FRAME_TARGET_radiance)
#define SEEN     (1u << FRAME_TARGET_seen)
#define LIGHT    (1u << FRAME_TARGET_light)
#define RAYS     (1u << FRAME_TARGET_rays)
#define HISTORY  (1u << FRAME_TARGET_history)
#define SMOOTH   (1u << FRAME_TARGET_smooth)
#define OPEN     (1u << FRAME_TARGET_open)
#define EDGE     (1u << FRAME_TARGET_edge)
#define MASK     (1u << FRAME_TARGET_mask)
#define LISTS    (1u << FRAME_TARGET_lists)
#define LAYER    (1u << FRAME_TARGET_layer | 1u << FRAME_TARGET_layer_depth | 1u << FRAME_TARGET_layer_keys)
#define TOOLS    (1u << FRAME_TARGET_tools)
#define SHOWN    (1u << FRAME_TARGET_shown)

const FramePass frame_passes[] = {
    /*  name       reads            fills            changes          own */
    {{"surface", 0, DEPTH | GBUFFER | SEEN | TRACED, 0, 0},
     pass_surface_needed,
     NULL,
     pass_surface_draw,
     "always: what is not drawn is clear",
     NULL},
    {{"plane", 0, 0, DEPTH | GBUFFER, 0}, pass_plane_needed, NULL, pass_plane_draw, "there is an infinite plane", NULL},
    {{"mesh", DEPTH, MESH, 0, 0},
     pass_positions_needed,
     pass_positions_make,
     pass_positions_draw,
     "what the picture knows is looked at from beside",
     NULL},
    {{"shadow", 0, SHADOW, 0, 0},
     pass_shadow_needed,
     pass_shadow_make,
     pass_shadow_draw,
     "a light's shadows are cast; once, then they are kept",
     NULL},
    {{"voxels", 0, VOXELS, 0, 0},
     pass_voxels_needed,
     pass_voxels_make,
     pass_voxels_draw,
     "voxels are looked at; once, then they are kept",
     NULL},
    {{"cubes", VOXELS, CUBES, 0, 0}, pass_cubes_needed, pass_cubes_make, pass_cubes_draw, "voxels are looked at", NULL},
    {{"radiance", VOXELS | SHADOW, RADIANCE, 0, 0},
     radiance_needed,
     pass_radiance_make,
     pass_radiance_draw,
     "indirect light comes from what is not shown; once, then it is kept",
     NULL},
    {{"volume", DEPTH | SHADOW, MASK, 0, 0},
     volume_lights_cast,
     pass_volume_make,
     pass_volume_draw,
     "a light casts hybrid shadows",
     NULL},
    {{"gather", DEPTH | GBUFFER | MASK, FAR, 0, 0},
     pass_gather_needed,
     pass_gather_make,
     pass_gather_draw,
     "lights are many, and far ones are taken together",
     NULL},
    {{"light", DEPTH | GBUFFER | SHADOW | MASK | SEEN | FAR, LIGHT, 0, GBUFFER},
     pass_light_needed,
     pass_light_make,
     pass_light_draw,
     "always: what is not lit is black",
     NULL},
    {{"rays", DEPTH | GBUFFER | LIGHT | VOXELS | RADIANCE, RAYS, 0, 0},
     pass_rays_needed,
     pass_rays_make,
     pass_rays_draw,
     "light is indirect",
     NULL},
    {{"history", DEPTH | GBUFFER | LIGHT | VOXELS | RADIANCE | RAYS, HISTORY, 0, 0},
     indirect_keeps,
     pass_history_make,
     pass_history_draw,
     "rays of several sets, or frames, count",
     NULL},
    {{"smooth", DEPTH | GBUFFER | RAYS, SMOOTH, 0, 0},
     pass_smooth_needed,
     pass_smooth_make,
     pass_smooth_draw,
     "what rays found is smoothed",
     NULL},
    {{"spread", DEPTH | GBUFFER | SMOOTH, OPEN, 0, 0},
     pass_smooth_needed,
     pass_spread_make,
     pass_spread_draw,
     "what rays found is smoothed",
     NULL},
    {{"combine", DEPTH | GBUFFER | OPEN, 0, LIGHT, 0},
     pass_combine_needed,
     pass_combine_make,
     pass_combine_draw,
     "light is indirect",
     NULL},
    {{"sky", DEPTH, 0, LIGHT, 0}, pass_sky_needed, NULL, pass_sky_draw, "the scene has a sky", NULL},
    {{"edge", DEPTH, EDGE, 0, 0},
     pass_edge_needed,
     pass_edge_make,
     pass_edge_draw,
     "edges are blended by coverage",
     NULL},
    {{"tools", SHADOW, TOOLS, DEPTH | LIGHT, 0},
     pass_tools_needed,
     pass_tools_make,
     pass_tools_draw,
     "tools are asked for, or a view of shadow volumes",
     NULL},
    {{"lists", DEPTH, LISTS, 0, 0},
     pass_lists_needed,
     pass_lists_make,
     pass_lists_draw,
     "something is transparent, and there is OpenGL 4.3",
     pass_lists_count},
    {{"blend", LISTS, 0, LIGHT | TOOLS, 0},
     pass_lists_needed,
     pass_blend_make,
     pass_blend_draw,
     "there are lists",
     NULL},
    {{"peel", DEPTH, LAYER, LIGHT | TOOLS, 0},
     pass_peel_needed,
     pass_peel_make,
     pass_peel_draw,
     "something is transparent, and there are no lists",
     pass_peel_count},
    {{"tone", LIGHT | EDGE | TOOLS, SHOWN, 0, EDGE},
     pass_light_needed,
     pass_tone_make,
     pass_tone_draw,
     "the picture is wanted",
     pass_tone_count},
};
enum { PASS_COUNT_HERE = sizeof frame_passes / sizeof *frame_passes };

int frame_pass_count(void) { return PASS_COUNT_HERE; }

const char *frame_reason(const Render *render, const FramePlanRequest *request, int pass)
{
    void (*const draw)(Render *) = frame_passes[pass].draw;
    const char *lacks = draw == pass_edge_draw ? pass_edge_lacks(render) : NULL;
    lacks = draw == pass_gather_draw ? light_far_lacks(render) : lacks;
    return lacks ? lacks : frame_plan_reason(request, &render->targets.plan, pass);
}

/* -- the plan */

/* What triangles are seen is kept for the next frame. */
static unsigned wanted(const Render *render)
{
    const char *view = render->options.view;
    const unsigned kept = facet_lights_seen(render) ? SEEN : 0;
    if (view && voxels_view_level(view) >= 0)
        return CUBES;
    if (pass_positions_is_view(view))
        return 1u << FRAME_TARGET_positions;
    if (view && indirect_view_lanes(view))
        return OPEN | kept;
    for (int target = 0; view && target < FRAME_TARGET_COUNT; target++)
        if (target != FRAME_TARGET_gbuffer && target != FRAME_TARGET_shadow &&
            !strcmp(view, frame_target_name((FrameTarget)target)))
            return 1u << target | kept;
    return !view ? SHOWN | kept : strcmp(view, "shadow") ? GBUFFER : LIGHT | SHADOW | kept;
}

/* What no pass fills is neither read nor changed. Without exact shadows or silhouettes nobody fills SEEN; where nothing is traced, TRACED. */
static void leave_out(const Render *render, FramePlanPass *rows, unsigned allowed)
{
    const unsigned never = (facet_lights_seen(render) ? 0 : SEEN) | (render->cache.tracing ? 0 : TRACED);
    unsigned filled = 0;
    for (int i = 0; i < PASS_COUNT_HERE; i++)
        rows[i].fills &= ~never;
    for (int i = 0; i < PASS_COUNT_HERE; i++)
        filled |= allowed >> i & 1 ? rows[i].fills : 0;
    for (int i = 0; i < PASS_COUNT_HERE; i++) {
        rows[i].reads &= filled;
        rows[i].changes &= filled;
    }
}

void frame_request(const Render *render, FramePlanRows *made)
{
    const bool at_once =
        render->compute && !render->parted; /* what is drawn to is not read, and parts read what they lit again */
    unsigned allowed = 0;
    for (int i = 0; i < PASS_COUNT_HERE; i++) {
        made->passes[i] = frame_passes[i].plan;
        made->passes[i].own &= at_once ? ~0u : 0;
        pass_smooth_request(render, frame_passes[i].draw, &made->passes[i]);
        allowed |= (unsigned)frame_passes[i].needed(render) << i;
    }
    leave_out(render, made->passes, allowed);
    for (int target = 0; target < FRAME_TARGET_COUNT; target++)
        made->targets[target] = frame_plan_target(render, (FrameTarget)target);
    made->request =
        (FramePlanRequest){made->passes, PASS_COUNT_HERE, allowed, wanted(render), made->targets, FRAME_TARGET_COUNT};
}

void frame_place(Render *render)
{
    view_space_place(&render->space, render->whole, render->at);
    render->exact.seen = false;
    shadow_sheet_place(render);
    lighting_place(render, &render->light.pass);
    lighting_place(render, &render->light.far.groups);
    pass_edge_place(render);
    pass_tools_place(render);
    volume_shown_place(render);
    pass_tone_place(render);
    pass_cubes_place(render);
    pass_positions_place(render);
    pass_combine_place(render);
    lighting_place(render, &render->glass.blend);
    lighting_place(render, &render->glass.peel);
}

/* What a pass counts in: all that is drawn before it, if it sees light, else depths alone. */
static void draw_before(Render *render, int pass)
{
    const bool all = (frame_passes[pass].plan.reads & LIGHT) != 0;
    for (int i = 0; i < PASS_COUNT_HERE; i++)
        if (render->targets.plan.runs >> i & 1 &&
            (all ? i < pass : (frame_passes[i].plan.fills | frame_passes[i].plan.changes) & DEPTH))
            frame_passes[i].draw(render);
}

static bool count_tiles(Render *render, int pass)
{
    const int at[2] = {render->at[0], render->at[1]}, margin = render->margin;
    const int step[2] = {render->size[0] - 2 * margin, render->size[1] - 2 * margin};
    bool fine = true;
    for (int y = 0; fine && y < render->whole[1]; y += step[1])
        for (int x = 0; fine && x < render->whole[0]; x += step[0]) {
            render->at[0] = x - margin;
            render->at[1] = y - margin;
            frame_place(render);
            draw_before(render, pass);
            fine = frame_passes[pass].count(render, FRAME_COUNT_tile);
        }
    memcpy(render->at, at, sizeof at);
    frame_place(render);
    return fine;
}

static bool count_pass(Render *render, int pass)
{
    bool (*count)(Render *, FrameCount) = frame_passes[pass].count;
    bool fine = count(render, FRAME_COUNT_begin);
    do
        fine = fine && count_tiles(render, pass);
    while (fine && count(render, FRAME_COUNT_again));
    return fine && count(render, FRAME_COUNT_end);
}

bool frame_count(Render *render)
{
    bool fine = true;
    for (int i = 0; fine && i < PASS_COUNT_HERE; i++)
        if (render->targets.plan.runs >> i & 1 && frame_passes[i].count &&
            frame_passes[i].count(render, FRAME_COUNT_wanted))
            fine = count_pass(render, i);
    return fine;
}

bool frame_make(Render *render)
{
    FramePlanRows made;
    frame_forms_find(render);
    frame_request(render, &made);
    frame_plan(&made.request, &render->targets.plan);
    frame_memory_size(render);
    bool fine = frame_memory_make(render);
    for (int draw = 0; fine && draw < FRAME_DRAW_COUNT; draw++)
        fine = frame_make_draw(render, (FrameDraw)draw);
    for (int i = 0; fine && i < PASS_COUNT_HERE; i++)
        if (render->targets.plan.runs >> i & 1 && frame_passes[i].make)
            fine = frame_passes[i].make(render);
    return fine && frame_count(render);
}

bool frame_change(Render *render, unsigned what)
{
    ScreenPass *passes[] = {&render->light.pass,       &render->light.far.groups, &render->light.far.near,
                            &render->light.far.gather, &render->glass.blend,      &render->indirect.combine,
                            &render->glass.peel,       &render->radiance.light};
    bool fine = !(what & RENDER_CAMERA) || pass_edge_change(render);
    render->radiance.drawn &= !(what & RENDER_LIGHTS);
    pass_volume_change(render);
    volume_shown_place(render);
    pass_cubes_place(render);
    pass_positions_place(render);
    pass_rays_place(render);
    indirect_doubt(render, what & RENDER_TIME     ? INDIRECT_DOUBT_light | INDIRECT_DOUBT_openness
                           : what & RENDER_LIGHTS ? INDIRECT_DOUBT_light
                                                  : 0);
    fine = fine && (!(what & (RENDER_CAMERA | RENDER_LIGHTS)) || pass_tools_change(render));
    for (size_t i = 0; what & (RENDER_CAMERA | RENDER_LIGHTS) && i < sizeof passes / sizeof *passes; i++)
        if (fine && passes[i]->material.store)
            fine = lighting_change(render, passes[i]);
    return fine;
}

void frame_draw(Render *render)
{
    for (int i = 0; i < PASS_COUNT_HERE; i++)
        if (render->targets.plan.runs >> i & 1)
            frame_passes[i].draw(render);
    render->indirect.moving.on = false;
}

void frame_delete(Render *render)
{
    GlContext *gl = render->gl;
    screen_pass_delete(&render->light.pass);
    pass_tone_delete(render);
    indirect_delete(render);
    indirect_motion_delete(render);
    light_far_delete(render);
    pass_edge_delete(render);
    pass_tools_delete(render);
    pass_positions_delete(render);
    screen_pass_delete(&render->glass.blend);
    pass_lists_delete(render);
    pass_peel_delete(render);
    for (int draw = 0; draw < FRAME_DRAW_COUNT; draw++)
        framebuffer_delete(gl, &render->targets.draws[draw]);
    frame_memory_delete(render);
    pass_volume_delete(render);
    pass_shadow_delete(render);
    pass_exact_delete(render);
    pass_cubes_delete(render);
    pass_voxels_delete(render);
    radiance_delete(render);
    light_table_delete(render);
    gl->DeleteTextures(1, &render->light.sky.map); /* GL ignores the name 0 */
    render->light.sky = (SkyLight){0};
    render->targets.plan = (FramePlan){0};
}
