/* Ambient light along single rays. The GLSL is indirect_around.glsl. */
#include "gen/render_text.h"
#include "runtime/indirect/rays/pass_rays.h"
#include "runtime/light/lighting.h"
#include <math.h>
#include <stdio.h>

#define PI 3.14159265358979323846

/* Reports whether the scene has lights of a kind whose radiance differs by direction. */
static bool is_met(const Renderer *renderer, const LightKind *row)
{
    bool met = false;
    for (int i = 0; row->varies && i < renderer->scene->light_count; i++)
        met |= renderer->scene->lights[i].kind == row->kind;
    return met;
}

static bool kinds_differ(const Renderer *renderer)
{
    bool differ = false;
    for (int k = 0; light_kind_table[k]; k++)
        differ |= is_met(renderer, light_kind_table[k]);
    return differ;
}

static bool sky_differs(const Renderer *renderer)
{
    return light_sky_shines(renderer->scene) && renderer->light->sky.uneven;
}

/* Only the picture's light takes ambient light per ray: views of the rays' results show indirect
 * light alone, and repeated bounces would reflect it once more. */
bool indirect_is_directional(const Renderer *renderer)
{
    const SceneIndirect *in = &renderer->scene->indirect;
    const char *view = renderer->options.view;
    return indirect_is(renderer) && in->directional && in->gain > 0 &&
           !indirect_method(renderer)->unlit && !indirect_is_repeated(renderer) &&
           !(view && indirect_view_components(view)) &&
           (kinds_differ(renderer) || sky_differs(renderer));
}

/* Defines the kinds' radiance along a direction, for example "#define AROUND_KINDS(way) +
 * lightAlongHemisphere(way)". */
static void define_kinds(const Renderer *renderer, char defined[INDIRECT_AROUND_DEFINITION])
{
    size_t size =
        (size_t)snprintf(defined, INDIRECT_AROUND_DEFINITION, "#define AROUND_KINDS(way)");
    for (int k = 0; light_kind_table[k]; k++)
        if (is_met(renderer, light_kind_table[k]))
            size += (size_t)snprintf(defined + size, INDIRECT_AROUND_DEFINITION - size,
                                     " + lightAlong%s(way)", light_kind_name(light_kind_table[k]));
    snprintf(defined + size, INDIRECT_AROUND_DEFINITION - size, "\n");
}

void indirect_around_add(const Renderer *renderer, char defined[INDIRECT_AROUND_DEFINITION],
                         ScreenPassText *text)
{
    if (!indirect_is_directional(renderer))
        return;
    if (sky_differs(renderer))
        screen_pass_add(text, render_text_light_sky);
    for (int k = 0; light_kind_table[k]; k++)
        if (is_met(renderer, light_kind_table[k]))
            screen_pass_add(text, light_kind_table[k]->glsl);
    define_kinds(renderer, defined);
    screen_pass_add(text, defined);
    screen_pass_add(text, render_text_indirect_around);
}

/* Returns the mipmap level of the sky's cube map whose texels have the solid angle of one ray.
 * The denoiser shares rays among pixels, which makes the angle smaller. */
static double level_of(const Renderer *renderer)
{
    const SceneIndirect *in = &renderer->scene->indirect;
    const double shared = in->filter == KEYWORD_Filter_none ? 1 : 16, face = SKY_FACE;
    return fmax(0, .5 * log2(PI / (in->rays * shared) * 6 * face * face / (4 * PI)));
}

void indirect_around_set(const Renderer *renderer, int unit, ScreenPass *pass)
{
    const SceneIndirect *in = &renderer->scene->indirect;
    if (!pass->material.store || !indirect_is_directional(renderer))
        return;
    material_set_number(&pass->material, "around_share", (float)(in->contrast / in->gain));
    material_set_number(&pass->material, "around_level", (float)level_of(renderer));
    light_sum_set(renderer, pass);
    if (sky_differs(renderer))
        light_sky_set(renderer, unit, pass);
}

void indirect_around_bind(const Renderer *renderer, int unit)
{
    if (indirect_is_directional(renderer) && sky_differs(renderer))
        light_sky_bind(renderer, unit);
}
