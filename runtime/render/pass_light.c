/* The pass light: from the G-buffer, depth and lights to light. Its GLSL is pass_light.glsl, behind lighting.glsl; where lights are many,
 * light_far.c has another. */
#include "runtime/render/frame.h"

extern const char render_text_pass_light[];

bool pass_light_needed(const Render *render) { return render->scene != NULL; }

bool pass_light_make(Render *render)
{
    return light_far_used(render)
               ? light_far_make(render)
               : lighting_make(render, &(LightingText){{render_text_pass_light}, render->parted, 0}, &render->light);
}

void pass_light_draw(Render *render)
{
    const LightingSource source = {FRAME_TARGET_gbuffer, FRAME_TARGET_depth, 0};
    if (render->far.numbers) {
        lighting_bind(render, source.surfaces, source.depth);
        light_far_draw(render);
    }
    if (render->parted) { /* parts add up */
        framebuffer_use(render->gl, &render->draws[FRAME_DRAW_light]);
        render->gl->ClearBufferfv(GL_COLOR, 0, (const float[4]){0});
    }
    lighting_run(render, &source, &render->light);
}
