/* Many lights, as light_bound.c says, on the driver's side: a dispatch that gathers what is far, and the pass light of that. */
#include "runtime/render/frame.h"
#include <stdio.h>

extern const char render_text_far_terms[], render_text_far_blocks[], render_text_far_group[], render_text_far_gather[],
    render_text_pass_light_far[];

/* As far_blocks.glsl has them. */
enum { NUMBERS_BINDING = 5, WORDS_BINDING = 4 };

/* Behind transparent layers what is relative stays so, and what is not may grow. */
static void set_budget(const Render *render, ScreenPass *pass)
{
    const bool covered = pass_lists_needed(render) || pass_peel_needed(render);
    double budget[2] = {0};
    light_far_budget(render->scene->tone, budget);
    material_set_number(&pass->material, "far_relative", (float)budget[0]);
    material_set_number(&pass->material, "far_absolute", (float)(covered ? 0 : budget[1] / render->scene->exposure));
    material_set_number(&pass->material, "far_row", (float)light_far_blocks(render->size[0]));
}

/* So many at most: programs are shared by numbers of lights that are near. */
static int count_lights(const Render *render)
{
    int most = 512;
    while (most < render->light_counts[VIEW_SPACE_PLAIN] + render->light_counts[VIEW_SPACE_POINTS])
        most *= 2;
    return most;
}

bool light_far_make(Render *render)
{
    char defined[64];
    if (!render->lights.texels && !lighting_lights(render))
        return false;
    snprintf(defined, sizeof defined, "#define FAR_LIGHTS %d\n%s", count_lights(render),
             render->light_counts[VIEW_SPACE_POINTS] ? "#define FAR_OTHERS\n" : "");
    const LightingText gather = {
        {defined, render_text_far_terms, render_text_far_blocks, render_text_far_group, render_text_far_gather},
        false,
        LIGHT_FAR_BLOCK};
    const LightingText light = {
        {defined, render_text_far_terms, render_text_far_blocks, render_text_pass_light_far}, false, 0};
    if (!lighting_make(render, &gather, &render->far.gather) || !lighting_make(render, &light, &render->light))
        return false;
    set_budget(render, &render->far.gather);
    set_budget(render, &render->light);
    return light_far_make_buffers(render);
}

void light_far_draw(Render *render)
{
    const GlContext *gl = render->gl;
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, NUMBERS_BINDING, render->far.numbers);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, WORDS_BINDING, render->far.words);
    screen_pass_run(&render->far.gather, &render->draws[FRAME_DRAW_light], &render->screen);
    gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void light_far_delete(Render *render)
{
    screen_pass_delete(&render->far.gather);
    render->gl->DeleteBuffers(1, &render->far.numbers); /* GL ignores the name 0 */
    render->gl->DeleteBuffers(1, &render->far.words);
    render->far = (FrameFar){0};
}
