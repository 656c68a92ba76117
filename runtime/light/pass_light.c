/* The pass light: from the G-buffer, depth and lights to light. Its GLSL is pass_light.glsl, behind lighting.glsl; where lights are many, it is
 * pass_light_far.glsl, by what the pass gather has summed. */
#include "runtime/light/light_far.h"
#include "runtime/light/lighting.h"

extern const char render_text_pass_light[], render_text_far_terms[], render_text_far_blocks[],
    render_text_pass_light_far[];

bool pass_light_needed(const Render *render) { return render->scene != NULL; }

static bool make_far(Render *render)
{
    char defined[LIGHT_FAR_DEFINITIONS];
    light_far_define(render, LIGHT_FAR_light, defined);
    const LightingText text = {
        {defined, render_text_far_terms, render_text_far_blocks, render_text_pass_light_far}, false, 0, LIGHTING_nearest};
    if (!lighting_make(render, &text, &render->light.pass))
        return false;
    light_far_set(render, &render->light.pass);
    return true;
}

bool pass_light_make(Render *render)
{
    return light_far_used(render)
               ? make_far(render)
               : lighting_make(render, &(LightingText){{render_text_pass_light}, render->parted, 0, LIGHTING_nearest},
                               &render->light.pass);
}

void pass_light_draw(Render *render)
{
    const LightingSource source = {FRAME_TARGET_gbuffer, FRAME_TARGET_depth, 0};
    if (render->light.far.numbers)
        light_far_bind_read(render);
    if (render->parted) { /* parts add up */
        framebuffer_use(render->gl, &render->targets.draws[FRAME_DRAW_light]);
        render->gl->ClearBufferfv(GL_COLOR, 0, (const float[4]){0});
    }
    lighting_run(render, &source, &render->light.pass);
}
