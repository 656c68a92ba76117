/* The pass light_cluster: light clustering, from the G-buffer, depth and lights to the sums of
 * distant lights and the sets of near lights for each block of pixels (light_bound.c). Three
 * dispatches: pass_groups.glsl finds groups of pixels; pass_near.glsl selects each group's near
 * lights; pass_light_cluster.glsl sums the others. The sum has a dispatch of its own since it
 * needs many registers. light_storage.c has the buffers. */
#include "gen/render_text.h"
#include "runtime/light/light_far.h"
#include "runtime/light/lighting.h"

static bool pass_light_cluster_needed(const Renderer *renderer)
{
    return renderer->scene && light_far_used(renderer);
}

/* Makes a program of the pass. Its text is the common text, followed by `texts`; the last of
 * `texts` is specific to the program. */
static bool make(Renderer *renderer, LightFarUse use, const char *const texts[3], ScreenPass *made)
{
    char defined[LIGHT_FAR_DEFINITIONS];
    light_far_define(renderer, use, defined);
    const LightingText text = {{defined, render_text_far_terms, render_text_far_blocks,
                                render_text_far_group, texts[0], texts[1], texts[2]},
                               false,
                               LIGHT_FAR_BLOCK,
                               LIGHTING_nearest};
    if (!lighting_make(renderer, &text, made))
        return false;
    light_far_set(renderer, made);
    return true;
}

static bool pass_light_cluster_make(Renderer *renderer)
{
    static const char *const texts[][3] = {
        [LIGHT_FAR_groups] = {render_text_pass_groups},
        [LIGHT_FAR_near] = {render_text_far_lobe, render_text_far_light, render_text_pass_near},
        [LIGHT_FAR_cluster] = {render_text_far_lobe, render_text_far_light,
                               render_text_pass_light_cluster}};
    FrameFar *far = &renderer->light->far;
    if ((!renderer->light->table.texels && !lighting_lights(renderer)) ||
        !make(renderer, LIGHT_FAR_groups, texts[LIGHT_FAR_groups], &far->groups) ||
        !make(renderer, LIGHT_FAR_near, texts[LIGHT_FAR_near], &far->near) ||
        !make(renderer, LIGHT_FAR_cluster, texts[LIGHT_FAR_cluster], &far->gather))
        return false;
    far->near.layers = far->gather.layers = LIGHT_FAR_GROUPS;
    return light_far_make(renderer);
}

static void pass_light_cluster_draw(Renderer *renderer)
{
    lighting_bind(renderer, FRAME_TARGET_gbuffer, FRAME_TARGET_depth);
    light_far_bind(renderer);
    screen_pass_run(&renderer->light->far.groups, &renderer->targets.draws[FRAME_DRAW_light],
                    &renderer->screen);
    screen_pass_run(&renderer->light->far.near, &renderer->targets.draws[FRAME_DRAW_light],
                    &renderer->screen);
    screen_pass_run(&renderer->light->far.gather, &renderer->targets.draws[FRAME_DRAW_light],
                    &renderer->screen);
}

static void pass_light_cluster_place(Renderer *renderer)
{
    lighting_place(renderer, &renderer->light->far.groups);
}

static bool pass_light_cluster_changed(Renderer *renderer, unsigned what)
{
    FrameFar *far = &renderer->light->far;
    return lighting_changed(renderer, what, &far->groups) &&
           lighting_changed(renderer, what, &far->near) &&
           lighting_changed(renderer, what, &far->gather);
}

static bool pass_light_cluster_moved(Renderer *renderer, int first, int count)
{
    (void)first, (void)count;
    lighting_moved(renderer, &renderer->light->far.groups);
    lighting_moved(renderer, &renderer->light->far.near);
    lighting_moved(renderer, &renderer->light->far.gather);
    return true;
}

const FramePass pass_light_cluster = {
    .plan = {"light_cluster", .reads = FRAME_BIT(depth) | FRAME_BIT(gbuffer) | FRAME_BIT(mask),
             .fills = FRAME_BIT(far)},
    .when = "lights are many, and far ones are taken together",
    .needed = pass_light_cluster_needed,
    .lacks = light_far_missing,
    .make = pass_light_cluster_make,
    .draw = pass_light_cluster_draw,
    .place = pass_light_cluster_place,
    .changed = pass_light_cluster_changed,
    .moved = pass_light_cluster_moved,
    .forget = light_far_delete,
};
