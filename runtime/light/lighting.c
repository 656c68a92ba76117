/* Inputs of every pass that lights surfaces: GLSL between the unpacking of a Surface and the
 * pass's own, uniforms, textures. */
#include "runtime/light/lighting.h"
#include "gen/render_text.h"
#include "runtime/shadow/shadow.h"
#include <stdio.h>

/* Texture units after those of the G-buffer. */
enum { DEPTH_UNIT = FRAMEBUFFER_COLORS, LIGHTS_UNIT, SKY_UNIT, SHADOW_UNIT };
_Static_assert(SHADOW_UNIT + SHADOW_UNITS == LIGHTING_UNITS, "units");

/* Used instead of a layout if the scene has no surface. */
static const char no_surface[] = "struct Surface { float nothing; };\nSurface unpackSurface(ivec2 "
                                 "pixel) { return Surface(0.0); }\n";

static int targets_of(const Renderer *renderer)
{
    int count = 0;
    while (material_set_format(&renderer->set, count))
        count++;
    return count;
}

static void set(ScreenPass *pass, const char *name, const float values[4])
{
    material_set(&pass->material, &(MaterialValue){name, 4, values});
}

void lighting_place(const Renderer *renderer, ScreenPass *pass)
{
    if (!pass->material.store)
        return;
    set(pass, "light_ray", renderer->space.ray);
    backdrop_set(renderer, true, pass);
}

static void set_numbers(const Renderer *renderer, ScreenPass *pass)
{
    const int targets = targets_of(renderer);
    char name[] = "matc_gbuffer0";
    lighting_place(renderer, pass);
    set(pass, "light_view", renderer->space.depth);
    material_set_number(&pass->material, "light_plain",
                        (float)renderer->light->counts[VIEW_SPACE_PLAIN]);
    material_set_number(&pass->material, "light_points",
                        (float)renderer->light->counts[VIEW_SPACE_POINTS]);
    light_sum_set(renderer, pass);
    for (int i = 0; i < targets; i++) {
        name[sizeof name - 2] = (char)('0' + i);
        screen_pass_sampler(pass, name, i);
    }
    screen_pass_sampler(pass, "light_depth", DEPTH_UNIT);
    light_table_set(renderer, LIGHTS_UNIT, pass);
    shadow_set(renderer, SHADOW_UNIT, pass);
}

/* Prepends the surface model's name: the driver's message refers to a text composed of several. */
static bool fail_model(const Renderer *renderer)
{
    char why[sizeof renderer->gl->error];
    snprintf(why, sizeof why, "%s", renderer->gl->error);
    return gl_fail(renderer->gl, "lighting surfaces by the model %s: %s", renderer->surface->name,
                   why);
}

bool lighting_lights(Renderer *renderer) { return light_table_write(renderer, LIGHTS_UNIT); }

/* Adds the unpacking of a Surface, and the surface model, preceded by the kinds of light that it
 * needs. */
static void add_surface(const Renderer *renderer, bool places, ScreenPassText *text)
{
    screen_pass_add(text, renderer->set.unpack ? renderer->set.unpack : no_surface);
    light_sum_texts(renderer, places, text);
    screen_pass_add(text, renderer->surface_missing);
    screen_pass_add(text, renderer->surface->text);
    screen_pass_add_all(text, renderer->surface->more, SURFACE_MODEL_MORE);
}

/* Adds the sum over lights, with definitions for the part that later passes add. */
static void add_lighting(const Renderer *renderer, LightingOf of, char composed[LIGHT_SUM_TEXT],
                         ScreenPassText *text)
{
    const bool places = of != LIGHTING_around;
    if (of == LIGHTING_nodes)
        screen_pass_add(text, "#define LIGHT_AROUND_LATER\n#undef SHADOW_SHEETS\n" /* per pixel */);
    else if (of == LIGHTING_nearest && scene_indirect_is(renderer->scene))
        screen_pass_add(text, "#define LIGHT_AROUND_LATER\n");
    screen_pass_add(text, backdrop_light_text(renderer));
    light_sum_compose(renderer, places, composed);
    screen_pass_add_all(text, (const char *const[]){render_text_lighting, "#define LIGHT_SENDS\n"},
                        2);
    light_sum_texts(renderer, places, text);
    screen_pass_add(text, composed);
    if (shadow_is_soft(renderer) && places)
        screen_pass_add(text, render_text_shadow_soft);
}

static bool make_what_it_reads(Renderer *renderer)
{
    return (renderer->light->table.texels || lighting_lights(renderer)) &&
           shadow_make_tables(renderer) &&
           (!light_sky_shines(renderer->scene) || renderer->light->sky.map ||
            light_sky_make(renderer));
}

bool lighting_make(Renderer *renderer, const LightingText *own, ScreenPass *made)
{
    char table[LIGHT_TABLE_DEFINITION], composed[LIGHT_SUM_TEXT];
    ShadowText shadows;
    const bool places = own->of != LIGHTING_around,
               scattered = own->block > 0 && own->of != LIGHTING_nodes;
    ScreenPassText text = {.format = frame_format(renderer, FRAME_TARGET_light, 0),
                           .compute = renderer->compute || own->of == LIGHTING_nodes,
                           .over = own->over,
                           .block = own->block};
    if (!make_what_it_reads(renderer))
        return false;
    add_surface(renderer, places, &text);
    if (places) {
        shadow_text(renderer, own->of == LIGHTING_nearest, &shadows);
        screen_pass_add_all(&text, shadows.pieces, SHADOW_TEXT_PIECES);
    }
    light_table_define(renderer, scattered, table);
    screen_pass_add(&text, table);
    add_lighting(renderer, own->of, composed, &text);
    screen_pass_add_all(&text, own->body, LIGHTING_PIECES);
    if (!screen_pass_make(renderer->store, &text, made))
        return fail_model(renderer);
    set_numbers(renderer, made);
    if (light_sky_shines(renderer->scene))
        light_sky_set(renderer, SKY_UNIT, made);
    return true;
}

bool lighting_changed(Renderer *renderer, unsigned what, ScreenPass *pass)
{
    if (!(what & (RENDERER_CAMERA | RENDERER_LIGHTS)) || !pass->material.store)
        return true;
    if (!light_table_write(renderer, LIGHTS_UNIT))
        return false;
    set_numbers(renderer, pass);
    if (renderer->light->sky.map)
        light_sky_set(renderer, SKY_UNIT, pass);
    return true;
}

void lighting_moved(const Renderer *renderer, ScreenPass *pass)
{
    if (pass->material.store)
        shadow_set(renderer, SHADOW_UNIT, pass);
}

void lighting_bind(const Renderer *renderer, FrameTarget surfaces, FrameTarget depth)
{
    for (int i = 0; frame_format(renderer, surfaces, i); i++)
        texture_bind(renderer->gl, frame_texture(renderer, surfaces, i), i);
    texture_bind(renderer->gl, frame_texture(renderer, depth, 0), DEPTH_UNIT);
    light_table_bind(renderer, LIGHTS_UNIT);
    shadow_bind(renderer, SHADOW_UNIT);
    if (renderer->light->sky.map)
        light_sky_bind(renderer, SKY_UNIT);
}

void lighting_run(Renderer *renderer, const LightingSource *source, ScreenPass *pass)
{
    plane_transmittance_draw(renderer, frame_texture(renderer, source->depth, 0));
    for (int part = 0; part < shadow_parts_number(renderer); part++) {
        shadow_parts_load(renderer, part);
        lighting_bind(renderer, source->surfaces, source->depth);
        if (source->own)
            texture_bind(renderer->gl, source->own, LIGHTING_FREE_UNIT);
        screen_pass_run(pass, &renderer->targets.draws[FRAME_DRAW_light], &renderer->screen);
    }
}
