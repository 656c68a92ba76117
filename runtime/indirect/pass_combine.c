/* The pass combine: adds ambient light, multiplied by ambient occlusion, and indirect light to
 * the direct light. Its GLSL is pass_combine.glsl, after lighting.glsl. */
#include "gen/render_text.h"
#include "runtime/indirect/settings/indirect.h"
#include "runtime/indirect/indirect_methods.h"
#include "runtime/light/lighting.h"

static bool pass_combine_needed(const Renderer *renderer) { return indirect_is(renderer); }

static bool pass_combine_make(Renderer *renderer)
{
    const SceneIndirect *in = &renderer->scene->indirect;
    const LightingText text = {
        .body = {in->dims_direct ? "#define INDIRECT_DIMS\n" : "", render_text_pass_combine},
        .over = true,
        .of = LIGHTING_around};
    if (!lighting_make(renderer, &text, &renderer->indirect->combine))
        return false;
    material_set_number(&renderer->indirect->combine.material, "indirect_gain", (float)in->gain);
    screen_pass_sampler(&renderer->indirect->combine, "indirect_open", LIGHTING_FREE_UNIT);
    return true;
}

static void pass_combine_place(Renderer *renderer)
{
    lighting_place(renderer, &renderer->indirect->combine);
}

static void pass_combine_draw(Renderer *renderer)
{
    lighting_bind(renderer, FRAME_TARGET_gbuffer, FRAME_TARGET_depth);
    texture_bind(renderer->gl, frame_texture(renderer, FRAME_TARGET_ao, 0), LIGHTING_FREE_UNIT);
    screen_pass_run(&renderer->indirect->combine, &renderer->targets.draws[FRAME_DRAW_light],
                    &renderer->screen);
}

static bool pass_combine_changed(Renderer *renderer, unsigned what)
{
    return lighting_changed(renderer, what, &renderer->indirect->combine);
}

const FramePass pass_combine = {
    .plan = {"combine", .reads = FRAME_BIT(depth) | FRAME_BIT(gbuffer) | FRAME_BIT(ao),
             .changes = FRAME_BIT(light)},
    .when = "light is indirect",
    .needed = pass_combine_needed,
    .make = pass_combine_make,
    .draw = pass_combine_draw,
    .place = pass_combine_place,
    .changed = pass_combine_changed,
};
