/* The pass gather: from the G-buffer, depth and lights to what far lights give together to each block of pixels, and which are near, as light_bound.c
 * says. Its GLSL is pass_gather.glsl; light_room.c has its buffers. */
#include "runtime/render/light_far.h"

extern const char render_text_far_terms[], render_text_far_blocks[], render_text_far_group[], render_text_far_lobe[],
    render_text_pass_gather[];

bool pass_gather_needed(const Render *render) { return render->scene && light_far_used(render); }

bool pass_gather_make(Render *render)
{
    char defined[LIGHT_FAR_DEFINITIONS];
    if (!render->lights.texels && !lighting_lights(render))
        return false;
    light_far_define(render, defined);
    const LightingText text = {
        {defined, render_text_far_terms, render_text_far_blocks, render_text_far_group, render_text_far_lobe,
         render_text_pass_gather},
        false,
        LIGHT_FAR_BLOCK,
        true};
    if (!lighting_make(render, &text, &render->far.gather))
        return false;
    light_far_set(render, &render->far.gather);
    return light_far_make(render);
}

void pass_gather_draw(Render *render)
{
    lighting_bind(render, FRAME_TARGET_gbuffer, FRAME_TARGET_depth);
    light_far_bind(render);
    screen_pass_run(&render->far.gather, &render->draws[FRAME_DRAW_light], &render->screen);
    render->gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}
