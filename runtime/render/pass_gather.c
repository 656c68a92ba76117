/* The pass gather: from the G-buffer, depth and lights to what far lights give together to each block of pixels, and which are near, as light_bound.c
 * says. Two dispatches: pass_groups.glsl finds groups of pixels, pass_gather.glsl goes through the lights, for each group by itself. light_room.c has
 * the buffers. */
#include "runtime/render/light_far.h"

extern const char render_text_far_terms[], render_text_far_blocks[], render_text_far_group[], render_text_far_lobe[],
    render_text_pass_groups[], render_text_pass_gather[];

bool pass_gather_needed(const Render *render) { return render->scene && light_far_used(render); }

static bool make(Render *render, const LightingText *text, ScreenPass *made)
{
    if (!lighting_make(render, text, made))
        return false;
    light_far_set(render, made);
    return true;
}

bool pass_gather_make(Render *render)
{
    char defined[LIGHT_FAR_DEFINITIONS];
    if (!render->lights.texels && !lighting_lights(render))
        return false;
    light_far_define(render, defined);
    LightingText text = {
        {defined, render_text_far_terms, render_text_far_blocks, render_text_far_group, render_text_pass_groups},
        false,
        LIGHT_FAR_BLOCK,
        LIGHTING_nearest};
    if (!make(render, &text, &render->far.groups))
        return false;
    text.body[4] = render_text_far_lobe;
    text.body[5] = render_text_pass_gather;
    if (!make(render, &text, &render->far.gather))
        return false;
    render->far.gather.layers = LIGHT_FAR_GROUPS;
    return light_far_make(render);
}

void pass_gather_draw(Render *render)
{
    lighting_bind(render, FRAME_TARGET_gbuffer, FRAME_TARGET_depth);
    light_far_bind(render);
    screen_pass_run(&render->far.groups, &render->draws[FRAME_DRAW_light], &render->screen);
    screen_pass_run(&render->far.gather, &render->draws[FRAME_DRAW_light], &render->screen);
}
