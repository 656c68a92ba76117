/* Inputs of every pass that lights surfaces: GLSL between the unpacking of a Surface and the
 * pass's own, uniforms, textures. */
#include "runtime/light/lighting.h"
#include "gen/render_text.h"
#include "runtime/shadow/shadow.h"
#include <stdio.h>

/* Units after those of the G-buffer. */
enum { DEPTH_UNIT = FRAMEBUFFER_COLORS, LIGHTS_UNIT, SKY_UNIT, SHADOW_UNIT };
_Static_assert(SHADOW_UNIT + SHADOW_UNITS == LIGHTING_UNITS, "units");

/* Used instead of a layout if the scene has no surface. */
static const char no_surface[] = "struct Surface { float nothing; };\nSurface unpackSurface(ivec2 "
                                 "pixel) { return Surface(0.0); }\n";

static int targets_of(const Render *render)
{
    int count = 0;
    while (material_set_format(&render->set, count))
        count++;
    return count;
}

static void set(ScreenPass *pass, const char *name, const float values[4])
{
    material_set(&pass->material, &(MaterialValue){name, 4, values});
}

void lighting_place(const Render *render, ScreenPass *pass)
{
    if (!pass->material.store)
        return;
    set(pass, "light_ray", render->space.ray);
    backdrop_set(render, true, pass);
}

static void set_numbers(const Render *render, ScreenPass *pass)
{
    const int targets = targets_of(render);
    char name[] = "matc_gbuffer0";
    lighting_place(render, pass);
    set(pass, "light_view", render->space.depth);
    material_set_number(&pass->material, "light_plain",
                        (float)render->light->counts[VIEW_SPACE_PLAIN]);
    material_set_number(&pass->material, "light_points",
                        (float)render->light->counts[VIEW_SPACE_POINTS]);
    light_sum_set(render, pass);
    for (int i = 0; i < targets; i++) {
        name[sizeof name - 2] = (char)('0' + i);
        screen_pass_sampler(pass, name, i);
    }
    screen_pass_sampler(pass, "light_depth", DEPTH_UNIT);
    light_table_set(render, LIGHTS_UNIT, pass);
    shadow_set(render, SHADOW_UNIT, pass);
}

/* Prepends the surface model's name: the driver's message refers to a text composed of several. */
static bool fail_model(const Render *render)
{
    char why[sizeof render->gl->error];
    snprintf(why, sizeof why, "%s", render->gl->error);
    return gl_fail(render->gl, "lighting surfaces by the model %s: %s", render->surface->name, why);
}

bool lighting_lights(Render *render) { return light_table_write(render, LIGHTS_UNIT); }

/* Adds the unpacking of a Surface, and the surface model, preceded by the kinds of light that it
 * needs. */
static void add_surface(const Render *render, bool places, ScreenPassText *text)
{
    screen_pass_add(text, render->set.unpack ? render->set.unpack : no_surface);
    light_sum_texts(render, places, text);
    screen_pass_add(text, render->surface_lacks);
    screen_pass_add(text, render->surface->text);
    screen_pass_add_all(text, render->surface->more, SURFACE_MODEL_MORE);
}

/* Adds the sum over lights, with definitions for the part that later passes add. */
static void add_lighting(const Render *render, LightingOf of, char composed[LIGHT_SUM_TEXT],
                         ScreenPassText *text)
{
    const bool places = of != LIGHTING_around;
    if (of == LIGHTING_nodes)
        screen_pass_add(text, "#define LIGHT_AROUND_LATER\n#undef SHADOW_SHEETS\n" /* per pixel */);
    else if (of == LIGHTING_nearest && scene_indirect_is(render->scene))
        screen_pass_add(text, "#define LIGHT_AROUND_LATER\n");
    screen_pass_add(text, backdrop_light_text(render));
    light_sum_compose(render, places, composed);
    screen_pass_add_all(text, (const char *const[]){render_text_lighting, "#define LIGHT_SENDS\n"},
                        2);
    light_sum_texts(render, places, text);
    screen_pass_add(text, composed);
    if (shadow_is_soft(render) && places)
        screen_pass_add(text, render_text_shadow_soft);
}

static bool make_what_it_reads(Render *render)
{
    return (render->light->table.texels || lighting_lights(render)) && shadow_make_tables(render) &&
           (!light_sky_shines(render->scene) || render->light->sky.map || light_sky_make(render));
}

bool lighting_make(Render *render, const LightingText *own, ScreenPass *made)
{
    char table[LIGHT_TABLE_DEFINITION], composed[LIGHT_SUM_TEXT];
    ShadowText shadows;
    const bool places = own->of != LIGHTING_around,
               scattered = own->block > 0 && own->of != LIGHTING_nodes;
    ScreenPassText text = {.format = frame_format(render, FRAME_TARGET_light, 0),
                           .compute = render->compute || own->of == LIGHTING_nodes,
                           .over = own->over,
                           .block = own->block};
    if (!make_what_it_reads(render))
        return false;
    add_surface(render, places, &text);
    if (places) {
        shadow_text(render, own->of == LIGHTING_nearest, &shadows);
        screen_pass_add_all(&text, shadows.pieces, SHADOW_TEXT_PIECES);
    }
    light_table_define(render, scattered, table);
    screen_pass_add(&text, table);
    add_lighting(render, own->of, composed, &text);
    screen_pass_add_all(&text, own->body, LIGHTING_PIECES);
    if (!screen_pass_make(render->store, &text, made))
        return fail_model(render);
    set_numbers(render, made);
    if (light_sky_shines(render->scene))
        light_sky_set(render, SKY_UNIT, made);
    return true;
}

bool lighting_changed(Render *render, unsigned what, ScreenPass *pass)
{
    if (!(what & (RENDER_CAMERA | RENDER_LIGHTS)) || !pass->material.store)
        return true;
    if (!light_table_write(render, LIGHTS_UNIT))
        return false;
    set_numbers(render, pass);
    if (render->light->sky.map)
        light_sky_set(render, SKY_UNIT, pass);
    return true;
}

void lighting_moved(const Render *render, ScreenPass *pass)
{
    if (pass->material.store)
        shadow_set(render, SHADOW_UNIT, pass);
}

void lighting_bind(const Render *render, FrameTarget surfaces, FrameTarget depth)
{
    for (int i = 0; frame_format(render, surfaces, i); i++)
        texture_bind(render->gl, frame_texture(render, surfaces, i), i);
    texture_bind(render->gl, frame_texture(render, depth, 0), DEPTH_UNIT);
    light_table_bind(render, LIGHTS_UNIT);
    shadow_bind(render, SHADOW_UNIT);
    if (render->light->sky.map)
        light_sky_bind(render, SKY_UNIT);
}

void lighting_run(Render *render, const LightingSource *source, ScreenPass *pass)
{
    shadow_sheet_draw(render, frame_texture(render, source->depth, 0));
    for (int part = 0; part < shadow_parts_number(render); part++) {
        shadow_parts_load(render, part);
        lighting_bind(render, source->surfaces, source->depth);
        if (source->own)
            texture_bind(render->gl, source->own, LIGHTING_FREE_UNIT);
        screen_pass_run(pass, &render->targets.draws[FRAME_DRAW_light], &render->screen);
    }
}
