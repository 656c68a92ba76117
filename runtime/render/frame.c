/* The frame graph: the list of passes, and calls of each pass's functions in turn. */
#include "runtime/transparency/transparency_passes.h"
#include "runtime/indirect/indirect_methods.h"
#include "runtime/indirect/screen/pass_positions.h"
#include "runtime/indirect/rays/pass_rays.h"
#include "runtime/indirect/filter/pass_smooth.h"
#include "runtime/indirect/radiance/radiance.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/light/light_far.h"
#include "runtime/post/post.h"
#include "runtime/render/frame_memory.h"
#include "runtime/render/passes.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/shadow_method.h"
#include "runtime/shadow/hybrid/volume.h"
#include <string.h>

/* The passes in the order of a frame. */
/* clang-format off */
static const FramePass *const passes[] = {
    &pass_surface,
    &pass_plane,
    &pass_positions,
    &pass_shadow,
    &pass_voxels,
    &pass_cubes,
    &pass_radiance,
    &pass_volume,
    &pass_gather,
    &pass_light,
    &pass_rays,
    &pass_history,
    &pass_smooth,
    &pass_spread,
    &pass_combine,
    &pass_sky,
    &pass_edge,
    &pass_tools,
    &pass_lists,
    &pass_blend,
    &pass_peel,
    &pass_tone,
};
/* clang-format on */
enum { PASSES = sizeof passes / sizeof *passes };

int frame_pass_count(void) { return PASSES; }
const FramePass *frame_pass(int pass) { return passes[pass]; }

static bool runs(const Render *render, int pass) { return render->targets.plan.runs >> pass & 1; }

const char *frame_reason(const Render *render, const FramePlanRequest *request, int pass)
{
    const char *lacks = passes[pass]->lacks ? passes[pass]->lacks(render) : NULL;
    return lacks ? lacks : frame_plan_reason(request, &render->targets.plan, pass);
}

/* -- the plan */

/* Returns the targets to read after the frame, by the view; triangle ids are also kept for the
 * next frame. */
static unsigned wanted(const Render *render)
{
    const char *view = render->options.view;
    const unsigned kept = shadow_method_sees(render) ? FRAME_BIT(seen) : 0;
    if (view && voxels_view_level(view) >= 0)
        return FRAME_BIT(cubes);
    if (pass_positions_is_view(view))
        return FRAME_BIT(positions);
    if (view && indirect_view_lanes(view))
        return FRAME_BIT(open) | kept;
    for (int target = 0; view && target < FRAME_TARGET_COUNT; target++)
        if (target != FRAME_TARGET_gbuffer && target != FRAME_TARGET_shadow &&
            !strcmp(view, frame_target_name((FrameTarget)target)))
            return 1u << target | kept;
    if (!view)
        return FRAME_BIT(shown) | kept;
    return strcmp(view, "shadow") ? FRAME_BIT(gbuffer)
                                  : FRAME_BIT(light) | FRAME_BIT(shadow) | kept;
}

/* Removes targets that no allowed pass fills from the passes' inputs and outputs. */
static void leave_out(FramePlanPass *rows, unsigned allowed)
{
    unsigned filled = 0;
    for (int i = 0; i < PASSES; i++)
        filled |= allowed >> i & 1 ? rows[i].fills : 0;
    for (int i = 0; i < PASSES; i++) {
        rows[i].reads &= filled;
        rows[i].changes &= filled;
    }
}

void frame_request(const Render *render, FramePlanRows *made)
{
    /* Fragment programs cannot read the target that they write, and passes over tiled shadow
     * lists read the light that they wrote. */
    const bool at_once = render->compute && !render->parted;
    unsigned allowed = 0;
    for (int i = 0; i < PASSES; i++) {
        made->passes[i] = passes[i]->plan;
        made->passes[i].own &= at_once ? ~0u : 0;
        if (passes[i]->request)
            passes[i]->request(render, &made->passes[i]);
        allowed |= (unsigned)passes[i]->needed(render) << i;
    }
    leave_out(made->passes, allowed);
    for (int target = 0; target < FRAME_TARGET_COUNT; target++)
        made->targets[target] = frame_plan_target(render, (FrameTarget)target);
    made->request = (FramePlanRequest){made->passes,   PASSES,        allowed,
                                       wanted(render), made->targets, FRAME_TARGET_COUNT};
}

void frame_place(Render *render)
{
    view_space_place(&render->space, render->whole, render->at);
    for (int i = 0; i < PASSES; i++)
        if (passes[i]->place)
            passes[i]->place(render);
}

/* Draws the passes before a pass that counts fragments: all if it reads light, otherwise those
 * that write depth. */
static void draw_before(Render *render, int pass)
{
    const bool all = (passes[pass]->plan.reads & FRAME_BIT(light)) != 0;
    for (int i = 0; i < PASSES; i++)
        if (runs(render, i) &&
            (all ? i < pass : (passes[i]->plan.fills | passes[i]->plan.changes) & FRAME_BIT(depth)))
            passes[i]->draw(render);
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
            fine = passes[pass]->count(render, FRAME_COUNT_tile);
        }
    memcpy(render->at, at, sizeof at);
    frame_place(render);
    return fine;
}

static bool count_pass(Render *render, int pass)
{
    bool (*count)(Render *, FrameCount) = passes[pass]->count;
    bool fine = count(render, FRAME_COUNT_begin);
    do
        fine = fine && count_tiles(render, pass);
    while (fine && count(render, FRAME_COUNT_again));
    return fine && count(render, FRAME_COUNT_end);
}

bool frame_count(Render *render)
{
    bool fine = true;
    for (int i = 0; fine && i < PASSES; i++)
        if (runs(render, i) && passes[i]->count && passes[i]->count(render, FRAME_COUNT_wanted))
            fine = count_pass(render, i);
    for (int i = 0; fine && i < PASSES; i++)
        if (passes[i]->recount)
            fine = passes[i]->recount(render);
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
    for (int i = 0; fine && i < PASSES; i++)
        if (runs(render, i) && passes[i]->make)
            fine = passes[i]->make(render);
    return fine && frame_count(render);
}

bool frame_changed(Render *render, unsigned what)
{
    bool fine = true;
    for (int i = 0; fine && i < PASSES; i++)
        fine = !passes[i]->changed || passes[i]->changed(render, what);
    return fine;
}

bool frame_objects_moved(Render *render, int first, int count)
{
    bool fine = true;
    for (int i = 0; fine && i < PASSES; i++)
        fine = !passes[i]->moved || passes[i]->moved(render, first, count);
    return fine;
}

bool frame_fall_back(Render *render)
{
    bool done = false;
    for (int i = 0; !done && i < PASSES; i++)
        done = passes[i]->fall_back && passes[i]->fall_back(render);
    return done;
}

void frame_draw(Render *render)
{
    for (int i = 0; i < PASSES; i++)
        if (runs(render, i))
            passes[i]->draw(render);
    for (int i = 0; i < PASSES; i++)
        if (passes[i]->drawn)
            passes[i]->drawn(render);
}

void frame_clear(Render *render)
{
    for (int i = PASSES - 1; i >= 0; i--) /* a pass may keep data in the state of an earlier one */
        if (passes[i]->forget)
            passes[i]->forget(render);
    for (int draw = 0; draw < FRAME_DRAW_COUNT; draw++)
        framebuffer_delete(render->gl, &render->targets.draws[draw]);
    frame_memory_delete(render);
    render->targets.plan = (FramePlan){0};
}
