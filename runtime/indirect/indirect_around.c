/* Light from all around along single rays. The GLSL is indirect_around.glsl. */
#include "gen/render_text.h"
#include "runtime/indirect/indirect.h"
#include "runtime/light/lighting.h"
#include <math.h>

#define PI 3.14159265358979323846

/* Whose colors may be others from frame to frame. */
static bool has_hemispheres(const Render *render)
{
    float numbers[VIEW_SPACE_HEMISPHERE][4];
    return view_space_hemisphere(&render->space, render->scene, numbers);
}

static bool sky_differs(const Render *render)
{
    return light_sky_shines(render->scene) && render->light->sky.uneven;
}

/* Where the picture's light is wanted: views of what rays find have nothing but that. Bounces that
 * run one after the other would send it on once more. */
bool indirect_is_directional(const Render *render)
{
    const SceneIndirect *in = &render->scene->indirect;
    const char *view = render->options.view;
    return indirect_is(render) && in->directional && in->gain > 0 &&
           indirect_method(render) != WORD_Indirect_points && !indirect_is_repeated(render) &&
           !(view && indirect_view_lanes(view)) && (has_hemispheres(render) || sky_differs(render));
}

void indirect_around_texts(const Render *render, const char *texts[INDIRECT_AROUND_TEXTS])
{
    const bool is = indirect_is_directional(render);
    texts[0] = is && sky_differs(render) ? render_text_light_sky : "";
    texts[1] = is && has_hemispheres(render) ? render_text_light_hemisphere : "";
    texts[2] = is ? render_text_indirect_around : "";
}

/* Rays of a pixel, times those of pixels over which they are smoothed, are looked up where the
 * cube's texels are as large as the solid angle of each. */
static double level_of(const Render *render)
{
    const SceneIndirect *in = &render->scene->indirect;
    const double shared = in->filter == WORD_Filter_none ? 1 : 16, face = 256;
    return fmax(0, .5 * log2(PI / (in->rays * shared) * 6 * face * face / (4 * PI)));
}

void indirect_around_set(const Render *render, int unit, ScreenPass *pass)
{
    const SceneIndirect *in = &render->scene->indirect;
    float numbers[VIEW_SPACE_HEMISPHERE][4];
    if (!pass->material.store || !indirect_is_directional(render))
        return;
    material_set_number(&pass->material, "around_share", (float)(in->contrast / in->gain));
    material_set_number(&pass->material, "around_level", (float)level_of(render));
    if (view_space_hemisphere(&render->space, render->scene, numbers))
        material_write(&pass->material, "Hemisphere", numbers, sizeof numbers);
    if (sky_differs(render))
        light_sky_set(render, unit, pass);
}

void indirect_around_bind(const Render *render, int unit)
{
    if (indirect_is_directional(render) && sky_differs(render))
        light_sky_bind(render, unit);
}
