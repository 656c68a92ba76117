/* The pass combine: over the light that comes from lights with a place, that from all around, dimmed, and indirect light. Its GLSL is pass_combine.glsl,
 * behind lighting.glsl. */
#include "runtime/indirect/indirect.h"
#include "runtime/light/lighting.h"

extern const char render_text_pass_combine[];

bool pass_combine_needed(const Render *render) { return indirect_is(render); }

bool pass_combine_make(Render *render)
{
    const SceneIndirect *in = &render->scene->indirect;
    const LightingText text = {.body = {in->dims_direct ? "#define INDIRECT_DIMS\n" : "", render_text_pass_combine},
                               .over = true,
                               .of = LIGHTING_around};
    if (!lighting_make(render, &text, &render->indirect.combine))
        return false;
    material_set_number(&render->indirect.combine.material, "indirect_gain", (float)in->gain);
    screen_pass_sampler(&render->indirect.combine, "indirect_open", LIGHTING_FREE_UNIT);
    return true;
}

void pass_combine_place(Render *render)
{
    pass_rays_place(render);
    lighting_place(render, &render->indirect.combine);
}

void pass_combine_draw(Render *render)
{
    lighting_bind(render, FRAME_TARGET_gbuffer, FRAME_TARGET_depth);
    texture_bind(render->gl, frame_texture(render, FRAME_TARGET_open, 0), LIGHTING_FREE_UNIT);
    screen_pass_run(&render->indirect.combine, &render->targets.draws[FRAME_DRAW_light], &render->screen);
}
