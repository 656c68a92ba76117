/* The pass tone: from light to the picture. Its GLSL is pass_tone.glsl. */
#include "runtime/render/frame.h"

extern const char render_text_pass_tone[];

bool pass_tone_make(Render *render)
{
    const ScreenPassText text = {.body = {render_text_pass_tone},
                                 .format = frame_format(render, FRAME_TARGET_shown, 0),
                                 .compute = render->compute};
    if (!screen_pass_make(render->store, &text, &render->tone))
        return false;
    material_set_number(&render->tone.material, "tone_exposure", (float)render->scene->exposure);
    material_set_number(&render->tone.material, "tone_filmic", render->scene->tone == SCENE_Filmic);
    screen_pass_sampler(&render->tone, "tone_light", 0);
    return true;
}

void pass_tone_draw(Render *render)
{
    texture_bind(render->gl, frame_texture(render, FRAME_TARGET_light, 0), 0);
    screen_pass_run(&render->tone, &render->draws[FRAME_DRAW_shown], &render->screen);
}
