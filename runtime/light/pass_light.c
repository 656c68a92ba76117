/* The pass light: deferred shading, from the G-buffer, depth and lights to radiance. Its GLSL is
 * pass_light.glsl, after lighting.glsl; with many lights it is pass_light_far.glsl, which reads
 * the light clusters of the pass gather. */
#include "gen/render_text.h"
#include "runtime/light/light_far.h"
#include "runtime/light/lighting.h"

static bool pass_light_needed(const Render *render) { return render->scene != NULL; }

static bool make_far(Render *render)
{
    char defined[LIGHT_FAR_DEFINITIONS];
    light_far_define(render, LIGHT_FAR_light, defined);
    const LightingText text = {
        {defined, render_text_far_terms, render_text_far_blocks, render_text_pass_light_far},
        false,
        0,
        LIGHTING_nearest};
    if (!lighting_make(render, &text, &render->light->pass))
        return false;
    light_far_set(render, &render->light->pass);
    return true;
}

static bool pass_light_make(Render *render)
{
    return light_far_used(render)
               ? make_far(render)
               : lighting_make(
                     render,
                     &(LightingText){{render_text_pass_light}, render->parted, 0, LIGHTING_nearest},
                     &render->light->pass);
}

static void pass_light_draw(Render *render)
{
    const LightingSource source = {FRAME_TARGET_gbuffer, FRAME_TARGET_depth, 0};
    if (render->light->far.numbers)
        light_far_bind_read(render);
    if (render->parted) { /* runs over tiled lists add up */
        framebuffer_use(render->gl, &render->targets.draws[FRAME_DRAW_light]);
        render->gl->ClearBufferfv(GL_COLOR, 0, (const float[4]){0});
    }
    lighting_run(render, &source, &render->light->pass);
}

static void pass_light_place(Render *render) { lighting_place(render, &render->light->pass); }
static bool pass_light_changed(Render *render, unsigned what)
{
    return lighting_changed(render, what, &render->light->pass);
}

static bool pass_light_moved(Render *render, int first, int count)
{
    (void)first, (void)count;
    lighting_moved(render, &render->light->pass);
    return true;
}

static void pass_light_forget(Render *render)
{
    frame_retire(render, &render->light->pass);
    light_table_delete(render);
    render->gl->DeleteTextures(1, &render->light->sky.map); /* GL ignores the name 0 */
    render->light->sky = (SkyLight){0};
}

const FramePass pass_light = {
    .plan = {"light",
             .reads = FRAME_BIT(depth) | FRAME_BIT(gbuffer) | FRAME_BIT(shadow) | FRAME_BIT(mask) |
                      FRAME_BIT(seen) | FRAME_BIT(far),
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
