/* The pass light: from the G-buffer, depth and lights to light. Its GLSL is pass_light.glsl, behind lighting.glsl. */
#include "runtime/render/frame.h"

extern const char render_text_pass_light[];

bool pass_light_needed(const Render *render) { return render->scene != NULL; }

bool pass_light_make(Render *render)
{
    return lighting_make(render, &(LightingText){{render_text_pass_light}, false}, &render->light);
}

void pass_light_draw(Render *render)
{
    lighting_bind(render, FRAME_TARGET_gbuffer, FRAME_TARGET_depth);
    screen_pass_run(&render->light, &render->draws[FRAME_DRAW_light], &render->screen);
}
