/* The pass light: deferred shading, from the G-buffer, depth and lights to radiance. Its GLSL is
 * pass_light.glsl, after lighting.glsl; with many lights it is pass_light_far.glsl, which reads
 * the light clusters of the pass light_cluster. */
#include "gen/render_text.h"
#include "runtime/light/light_far.h"
#include "runtime/light/lighting.h"

static bool pass_light_needed(const Renderer *renderer) { return renderer->scene != NULL; }

static bool make_far(Renderer *renderer)
{
    char defined[LIGHT_FAR_DEFINITIONS];
    light_far_define(renderer, LIGHT_FAR_light, defined);
    const LightingText text = {
        {defined, render_text_far_terms, render_text_far_blocks, render_text_pass_light_far},
        false,
        0,
        LIGHTING_nearest};
    if (!lighting_make(renderer, &text, &renderer->light->pass))
        return false;
    light_far_set(renderer, &renderer->light->pass);
    return true;
}

static bool pass_light_make(Renderer *renderer)
{
    return light_far_used(renderer)
               ? make_far(renderer)
               : lighting_make(renderer,
                               &(LightingText){
                                   {render_text_pass_light}, renderer->tiled, 0, LIGHTING_nearest},
                               &renderer->light->pass);
}

static void pass_light_draw(Renderer *renderer)
{
    const LightingSource source = {FRAME_TARGET_gbuffer, FRAME_TARGET_depth, 0};
    if (renderer->light->far.numbers)
        light_far_bind_read(renderer);
    if (renderer->tiled) { /* adds up the runs over tiled lists */
        framebuffer_use(renderer->gl, &renderer->targets.draws[FRAME_DRAW_light]);
        renderer->gl->ClearBufferfv(GL_COLOR, 0, (const float[4]){0});
    }
    lighting_run(renderer, &source, &renderer->light->pass);
}

static void pass_light_place(Renderer *renderer)
{
    lighting_place(renderer, &renderer->light->pass);
}
static bool pass_light_changed(Renderer *renderer, unsigned what)
{
    return lighting_changed(renderer, what, &renderer->light->pass);
}

static bool pass_light_moved(Renderer *renderer, int first, int count)
{
    (void)first, (void)count;
    lighting_moved(renderer, &renderer->light->pass);
    return true;
}

static void pass_light_forget(Renderer *renderer)
{
    frame_retire(renderer, &renderer->light->pass);
    light_table_delete(renderer);
    renderer->gl->DeleteTextures(1, &renderer->light->sky.map); /* GL ignores the name 0 */
    renderer->light->sky = (SkyLight){0};
}

const FramePass pass_light = {
    .plan = {"light",
             .reads = FRAME_BIT(depth) | FRAME_BIT(gbuffer) | FRAME_BIT(shadow) | FRAME_BIT(mask) |
                      FRAME_BIT(triangle_id) | FRAME_BIT(far),
             .fills = FRAME_BIT(light), .own = FRAME_BIT(gbuffer)},
    .when = "always: what is not lit is black",
    .needed = pass_light_needed,
    .make = pass_light_make,
    .draw = pass_light_draw,
    .place = pass_light_place,
    .changed = pass_light_changed,
    .moved = pass_light_moved,
    .forget = pass_light_forget,
};
