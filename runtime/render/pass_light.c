/* The pass light: from the G-buffer, depth and lights to light. Its GLSL is pass_light.glsl, behind what reads the layout back and the
 * surface model. */
#include "runtime/render/frame.h"
#include <stdlib.h>
#include <string.h>

extern const char render_text_pass_light[], render_text_surface_phong[];

/* What stands for a layout where no surface has one. */
static const char no_surface[] =
    "struct Surface { float nothing; };\nSurface unpackSurface(ivec2 pixel) { return Surface(0.0); }\n";

bool pass_light_needed(const Render *render) { return render->scene != NULL; }

static int targets_of(const Render *render)
{
    int count = 0;
    while (set_format(&render->set, count))
        count++;
    return count;
}

static bool make_lights(Render *render)
{
    const int most = render->scene->light_count > 0 ? render->scene->light_count : 1;
    const int row = most < VIEW_SPACE_LIGHT_ROW ? most : VIEW_SPACE_LIGHT_ROW;
    const int rows = (most + VIEW_SPACE_LIGHT_ROW - 1) / VIEW_SPACE_LIGHT_ROW;
    const size_t texels = (size_t)row * (size_t)rows * VIEW_SPACE_LIGHT_TEXELS;
    float *floats = calloc(texels * 4, sizeof *floats);
    if (!floats)
        return gl_fail(render->gl, "out of memory");
    render->light_count = view_space_lights(&render->space, render->scene, floats);
    const TextureSpec spec = {.width = row * VIEW_SPACE_LIGHT_TEXELS, .height = rows, .lanes = 4, .floats = floats};
    render->lights = texture_check(render->gl, &spec) ? texture_make(render->gl, &spec) : 0;
    free(floats);
    return render->lights != 0;
}

static void set(Render *render, const char *name, const float values[4])
{
    material_set(&render->light.material, &(MaterialValue){name, 4, values});
}

static void set_numbers(Render *render)
{
    const int targets = targets_of(render);
    char name[] = "matc_gbuffer0";
    float ambient[4];
    view_space_ambient(render->scene, ambient);
    set(render, "light_ray", render->space.ray);
    set(render, "light_view", render->space.depth);
    set(render, "light_ambient", ambient);
    material_set_number(&render->light.material, "light_count", (float)render->light_count);
    for (int i = 0; i < targets; i++) {
        name[sizeof name - 2] = (char)('0' + i);
        screen_pass_sampler(&render->light, name, i);
    }
    screen_pass_sampler(&render->light, "light_depth", targets);
    screen_pass_sampler(&render->light, "light_lights", targets + 1);
}

bool pass_light_make(Render *render)
{
    const ScreenPassText text = {.body = {render->set.unpack ? render->set.unpack : no_surface,
                                          render_text_surface_phong, render_text_pass_light},
                                 .format = frame_format(render, FRAME_TARGET_light, 0),
                                 .compute = render->compute};
    if (!screen_pass_make(render->store, &text, &render->light) || !make_lights(render))
        return false;
    set_numbers(render);
    return true;
}

void pass_light_draw(Render *render)
{
    const int targets = targets_of(render);
    for (int i = 0; i < targets; i++)
        texture_bind(render->gl, frame_texture(render, FRAME_TARGET_gbuffer, i), i);
    texture_bind(render->gl, frame_texture(render, FRAME_TARGET_depth, 0), targets);
    texture_bind(render->gl, render->lights, targets + 1);
    screen_pass_run(&render->light, &render->draws[FRAME_DRAW_light], &render->screen);
}
