/* What every pass that lights surfaces takes: the GLSL between what gives a Surface and the pass's own, numbers, textures. */
#include "runtime/render/frame.h"
#include <stdlib.h>

extern const char render_text_light_area[], render_text_light_sky[], render_text_surface_phong[],
    render_text_lighting[];

/* Units behind those of the G-buffer. */
enum { DEPTH_UNIT = FRAMEBUFFER_COLORS, LIGHTS_UNIT, SKY_UNIT, SHADOW_UNIT };

/* What stands for a layout where no surface has one. */
static const char no_surface[] =
    "struct Surface { float nothing; };\nSurface unpackSurface(ivec2 pixel) { return Surface(0.0); }\n";

static int targets_of(const Render *render)
{
    int count = 0;
    while (set_format(&render->set, count))
        count++;
    return count;
}

/* Texels of lights, into the texture that is there, or a new one. */
static bool write_lights(Render *render)
{
    const int most = render->scene->light_count > 0 ? render->scene->light_count : 1;
    const int row = most < VIEW_SPACE_LIGHT_ROW ? most : VIEW_SPACE_LIGHT_ROW;
    const int rows = (most + VIEW_SPACE_LIGHT_ROW - 1) / VIEW_SPACE_LIGHT_ROW;
    const size_t texels = (size_t)row * (size_t)rows * VIEW_SPACE_LIGHT_TEXELS;
    float *floats = calloc(texels * 4, sizeof *floats);
    if (!floats)
        return gl_fail(render->gl, "out of memory");
    view_space_lights(&render->space, render->scene, floats, render->light_counts);
    shadow_put_lights(render, floats);
    const TextureSpec spec = {.width = row * VIEW_SPACE_LIGHT_TEXELS, .height = rows, .lanes = 4, .floats = floats};
    render->gl->ActiveTexture(GL_TEXTURE0 + LIGHTS_UNIT); /* making a texture binds it */
    if (render->lights)
        texture_rewrite(render->gl, render->lights, &spec);
    else
        render->lights = texture_check(render->gl, &spec) ? texture_make(render->gl, &spec) : 0;
    free(floats);
    return render->lights != 0;
}

static void set(ScreenPass *pass, const char *name, const float values[4])
{
    material_set(&pass->material, &(MaterialValue){name, 4, values});
}

void lighting_place(const Render *render, ScreenPass *pass)
{
    if (pass->material.store)
        set(pass, "light_ray", render->space.ray);
}

static void set_numbers(const Render *render, ScreenPass *pass)
{
    const int targets = targets_of(render);
    char name[] = "matc_gbuffer0";
    float ambient[4];
    view_space_ambient(render->scene, ambient);
    set(pass, "light_ray", render->space.ray);
    set(pass, "light_view", render->space.depth);
    set(pass, "light_ambient", ambient);
    material_set_number(&pass->material, "light_points", (float)render->light_counts[VIEW_SPACE_POINTS]);
    material_set_number(&pass->material, "light_areas", (float)render->light_counts[VIEW_SPACE_AREAS]);
    for (int i = 0; i < targets; i++) {
        name[sizeof name - 2] = (char)('0' + i);
        screen_pass_sampler(pass, name, i);
    }
    screen_pass_sampler(pass, "light_depth", DEPTH_UNIT);
    screen_pass_sampler(pass, "light_lights", LIGHTS_UNIT);
    shadow_samplers(pass, SHADOW_UNIT);
}

bool lighting_make(Render *render, const LightingText *own, ScreenPass *made)
{
    char defined[SHADOW_DEFINITIONS];
    if ((!render->lights && !write_lights(render)) || !shadow_make_tables(render))
        return false;
    const bool areas = render->light_counts[VIEW_SPACE_AREAS] > 0, sky = light_sky_shines(render->scene);
    const char *const shadows = shadow_text(render, defined);
    if (sky && !render->sky.map && !light_sky_make(render))
        return false;
    const ScreenPassText text = {.body = {render->set.unpack ? render->set.unpack : no_surface,
                                          areas ? render_text_light_area : "", sky ? render_text_light_sky : "",
                                          render_text_surface_phong, defined, shadows, render_text_lighting,
                                          own->body[0], own->body[1]},
                                 .format = frame_format(render, FRAME_TARGET_light, 0),
                                 .compute = render->compute,
                                 .over = own->over};
    if (!screen_pass_make(render->store, &text, made))
        return false;
    set_numbers(render, made);
    if (sky)
        light_sky_set(render, SKY_UNIT, made);
    return true;
}

bool lighting_change(Render *render, ScreenPass *pass)
{
    if (!write_lights(render))
        return false;
    set_numbers(render, pass);
    if (render->sky.map)
        light_sky_set(render, SKY_UNIT, pass);
    return true;
}

void lighting_bind(const Render *render, FrameTarget surfaces, FrameTarget depth)
{
    for (int i = 0; frame_format(render, surfaces, i); i++)
        texture_bind(render->gl, frame_texture(render, surfaces, i), i);
    texture_bind(render->gl, frame_texture(render, depth, 0), DEPTH_UNIT);
    texture_bind(render->gl, render->lights, LIGHTS_UNIT);
    shadow_bind(render, SHADOW_UNIT);
    if (render->sky.map)
        light_sky_bind(render, SKY_UNIT);
}
