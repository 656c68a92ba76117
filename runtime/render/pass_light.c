/* The pass light: from the G-buffer, depth and lights to light. Its GLSL is pass_light.glsl, behind lighting.glsl; where lights are many,
 * light_far.c has another. */
#include "runtime/render/frame.h"

extern const char render_text_pass_light[];

bool pass_light_needed(const Render *render) { return render->scene != NULL; }

bool pass_light_make(Render *render)
{
    return light_far_used(render)
               ? light_far_make(render)
               : lighting_make(render, &(LightingText){{render_text_pass_light}, false, 0}, &render->light);
}

void pass_light_draw(Render *render)
{
    lighting_bind(render, FRAME_TARGET_gbuffer, FRAME_TARGET_depth);
    if (render->far.numbers)
        light_far_draw(render);
    screen_pass_run(&render->light, &render->draws[FRAME_DRAW_light], &render->screen);
}
