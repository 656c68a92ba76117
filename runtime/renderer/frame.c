/* The frame graph: the list of passes, and calls of each pass's functions in turn. */
#include "runtime/transparency/transparency_passes.h"
#include "runtime/indirect/indirect_methods.h"
#include "runtime/indirect/screen/pass_positions.h"
#include "runtime/indirect/rays/pass_rays.h"
#include "runtime/indirect/filter/pass_denoise.h"
#include "runtime/indirect/radiance/radiance.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/light/light_far.h"
#include "runtime/post/post.h"
#include "runtime/renderer/frame_memory.h"
#include "runtime/renderer/passes.h"
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
    &pass_light_cluster,
    &pass_light,
    &pass_rays,
    &pass_temporal,
    &pass_denoise,
    &pass_upsample,
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

static bool runs(const Renderer *renderer, int pass)
{
    return renderer->targets.plan.runs >> pass & 1;
}

const char *frame_reason(const Renderer *renderer, const FramePlanRequest *request, int pass)
{
    const char *lacks = passes[pass]->lacks ? passes[pass]->lacks(renderer) : NULL;
    return lacks ? lacks : frame_plan_reason(request, &renderer->targets.plan, pass);
}

/* -- the plan */

/* Returns the targets to read after the frame, by the view; triangle ids are also kept for the
 * next frame. */
static unsigned wanted(const Renderer *renderer)
{
    const char *view = renderer->options.view;
    const unsigned kept = shadow_method_sees(renderer) ? FRAME_BIT(triangle_id) : 0;
    if (view && voxels_view_level(view) >= 0)
        return FRAME_BIT(cubes);
    if (pass_positions_is_view(view))
        return FRAME_BIT(positions);
    if (view && indirect_view_components(view))
        return FRAME_BIT(ao) | kept;
    for (int target = 0; view && target < FRAME_TARGET_COUNT; target++)
        if (target != FRAME_TARGET_gbuffer && target != FRAME_TARGET_shadow &&
            !strcmp(view, frame_target_name((FrameTarget)target)))
            return 1u << target | kept;
    if (!view)
        return FRAME_BIT(final) | kept;
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

void frame_request(const Renderer *renderer, FramePlanRows *made)
{
    /* Fragment programs cannot read the target that they write, and passes over tiled shadow
     * lists read the light that they wrote. */
    const bool at_once = renderer->compute && !renderer->tiled;
    unsigned allowed = 0;
    for (int i = 0; i < PASSES; i++) {
        made->passes[i] = passes[i]->plan;
        made->passes[i].own &= at_once ? ~0u : 0;
        if (passes[i]->request)
            passes[i]->request(renderer, &made->passes[i]);
        allowed |= (unsigned)passes[i]->needed(renderer) << i;
    }
    leave_out(made->passes, allowed);
    for (int target = 0; target < FRAME_TARGET_COUNT; target++)
        made->targets[target] = frame_plan_target(renderer, (FrameTarget)target);
    made->request = (FramePlanRequest){made->passes,     PASSES,        allowed,
                                       wanted(renderer), made->targets, FRAME_TARGET_COUNT};
}

void frame_place(Renderer *renderer)
{
    view_space_place(&renderer->space, renderer->whole, renderer->at);
    for (int i = 0; i < PASSES; i++)
        if (passes[i]->place)
            passes[i]->place(renderer);
}

/* Draws the passes before a pass that counts fragments: all if it reads light, otherwise those
 * that write depth. */
static void draw_before(Renderer *renderer, int pass)
{
    const bool all = (passes[pass]->plan.reads & FRAME_BIT(light)) != 0;
    for (int i = 0; i < PASSES; i++)
        if (runs(renderer, i) &&
            (all ? i < pass : (passes[i]->plan.fills | passes[i]->plan.changes) & FRAME_BIT(depth)))
            passes[i]->draw(renderer);
}

static bool count_tiles(Renderer *renderer, int pass)
{
    const int at[2] = {renderer->at[0], renderer->at[1]}, margin = renderer->margin;
    const int step[2] = {renderer->size[0] - 2 * margin, renderer->size[1] - 2 * margin};
    bool fine = true;
    for (int y = 0; fine && y < renderer->whole[1]; y += step[1])
        for (int x = 0; fine && x < renderer->whole[0]; x += step[0]) {
            renderer->at[0] = x - margin;
            renderer->at[1] = y - margin;
            frame_place(renderer);
            draw_before(renderer, pass);
            fine = passes[pass]->count(renderer, FRAME_COUNT_tile);
        }
    memcpy(renderer->at, at, sizeof at);
    frame_place(renderer);
    return fine;
}

static bool count_pass(Renderer *renderer, int pass)
{
    bool (*count)(Renderer *, FrameCount) = passes[pass]->count;
    bool fine = count(renderer, FRAME_COUNT_begin);
    do
        fine = fine && count_tiles(renderer, pass);
    while (fine && count(renderer, FRAME_COUNT_again));
    return fine && count(renderer, FRAME_COUNT_end);
}

bool frame_count(Renderer *renderer)
{
    bool fine = true;
    for (int i = 0; fine && i < PASSES; i++)
        if (runs(renderer, i) && passes[i]->count && passes[i]->count(renderer, FRAME_COUNT_wanted))
            fine = count_pass(renderer, i);
    for (int i = 0; fine && i < PASSES; i++)
        if (passes[i]->recount)
            fine = passes[i]->recount(renderer);
    return fine;
}

bool frame_make(Renderer *renderer)
{
    FramePlanRows made;
    frame_forms_find(renderer);
    frame_request(renderer, &made);
    frame_plan(&made.request, &renderer->targets.plan);
    frame_memory_size(renderer);
    bool fine = frame_memory_make(renderer);
    for (int draw = 0; fine && draw < FRAME_DRAW_COUNT; draw++)
        fine = frame_make_draw(renderer, (FrameDraw)draw);
    for (int i = 0; fine && i < PASSES; i++)
        if (runs(renderer, i) && passes[i]->make)
            fine = passes[i]->make(renderer);
    return fine && frame_count(renderer);
}

bool frame_changed(Renderer *renderer, unsigned what)
{
    bool fine = true;
    for (int i = 0; fine && i < PASSES; i++)
        fine = !passes[i]->changed || passes[i]->changed(renderer, what);
    return fine;
}

bool frame_objects_moved(Renderer *renderer, int first, int count)
{
    bool fine = true;
    for (int i = 0; fine && i < PASSES; i++)
        fine = !passes[i]->moved || passes[i]->moved(renderer, first, count);
    return fine;
}

bool frame_fall_back(Renderer *renderer)
{
    bool done = false;
    for (int i = 0; !done && i < PASSES; i++)
        done = passes[i]->fall_back && passes[i]->fall_back(renderer);
    return done;
}

void frame_draw(Renderer *renderer)
{
    for (int i = 0; i < PASSES; i++)
        if (runs(renderer, i))
            passes[i]->draw(renderer);
    for (int i = 0; i < PASSES; i++)
        if (passes[i]->drawn)
            passes[i]->drawn(renderer);
}

void frame_clear(Renderer *renderer)
{
    for (int i = PASSES - 1; i >= 0; i--) /* a pass may keep data in the state of an earlier one */
        if (passes[i]->forget)
            passes[i]->forget(renderer);
    for (int draw = 0; draw < FRAME_DRAW_COUNT; draw++)
        framebuffer_delete(renderer->gl, &renderer->targets.draws[draw]);
    frame_memory_delete(renderer);
    renderer->targets.plan = (FramePlan){0};
}
