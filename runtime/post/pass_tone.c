/* The tone pass: maps light to the picture's colors and blends edges. Its GLSL is tone.glsl and
 * pass_tone.glsl. Tone curves that depend on the whole picture use reductions made before. */
#include "gen/render_text.h"
#include "runtime/post/post.h"
#include <stdio.h>
#include <string.h>

enum { LIGHT_UNIT, MEASURED_UNIT, ADAPTED_UNIT, EDGE_UNIT, TOOLS_UNIT };

static bool has_edges(const Render *render)
{
    return render->targets.plan.there >> FRAME_TARGET_edge & 1;
}

static bool is_tiled(const Render *render)
{
    return render->size[0] - 2 * render->margin < render->whole[0] ||
           render->size[1] - 2 * render->margin < render->whole[1];
}

static bool measures(const Render *render)
{
    const Scene *scene = render->scene;
    return !render->options.linear &&
           (scene->tone == SCENE_Linear || scene->tone == SCENE_ReinhardDevlin ||
            scene->tone == SCENE_Drago);
}

static bool adapts(const Scene *scene) { return scene->tone == SCENE_ReinhardDevlin; }

static void set_numbers(const Render *render, ScreenPass *pass)
{
    const Scene *scene = render->scene;
    float numbers[4];
    for (int i = 0; i < 4; i++)
        numbers[i] = (float)scene->tone_numbers[i];
    material_set_number(&pass->material, "tone_exposure", (float)scene->exposure);
    material_set_number(&pass->material, "tone_pixels",
                        (float)render->whole[0] * (float)render->whole[1]);
    material_set(&pass->material, &(MaterialValue){"tone_numbers", 4, numbers});
    screen_pass_sampler(pass, "tone_measured", MEASURED_UNIT);
    screen_pass_sampler(pass, "tone_adapted", ADAPTED_UNIT);
}

/* Sets the numbers in every step: steps share a program, so different values would be uploaded
 * again in every frame. */
static void set_steps(const Render *render, Measure *measure)
{
    for (int i = 0; i < measure->count; i++)
        set_numbers(render, &measure->passes[i]);
}

/* Creates the reductions. The second one reduces the colors that the first one's result adapts. */
static bool make_measures(Render *render, const char *kind)
{
    const char *const first[] = {kind, render_text_tone, NULL};
    const char *const second[] = {kind, "#define MEASURE_ADAPTED\n", render_text_tone, NULL};
    if (!measures(render))
        return true;
    if (!measure_make(render->store, render->size, render->compute, first,
                      &render->picture->measured))
        return false;
    set_steps(render, &render->picture->measured);
    if (!adapts(render->scene))
        return true;
    if (!measure_make(render->store, render->size, render->compute, second,
                      &render->picture->adapted))
        return false;
    set_steps(render, &render->picture->adapted);
    return true;
}

static void pass_tone_place(Render *render)
{
    if (render->picture->tone.material.store)
        backdrop_set(render, false, &render->picture->tone);
}

static bool pass_tone_make(Render *render)
{
    char kind[128];
    snprintf(kind, sizeof kind, "#define TONE_%s\n#define TONE_SAMPLES %d\n%s%s",
             render->options.linear ? "LIGHT" : scene_kind_table[render->scene->tone].name,
             render->samples, measures(render) ? "#define TONE_MEASURES\n" : "",
             pass_tools_are_there(render) ? "#define TONE_TOOLS\n" : "");
    const ScreenPassText text = {
        .body = {kind, render_text_tone, backdrop_text(render),
                 has_edges(render) ? render_text_edge_part : render_text_edge_none,
                 render_text_pass_tone},
        .format = frame_format(render, FRAME_TARGET_shown, 0),
        .compute = render->compute};
    if (!make_measures(render, kind) ||
        !screen_pass_make(render->store, &text, &render->picture->tone))
        return false;
    set_numbers(render, &render->picture->tone);
    screen_pass_sampler(&render->picture->tone, "tone_light", LIGHT_UNIT);
    screen_pass_sampler(&render->picture->tone, "edge_words", EDGE_UNIT);
    screen_pass_sampler(&render->picture->tone, "tone_tools", TOOLS_UNIT);
    pass_tone_place(render);
    return true;
}

/* -- tiles: all tiles are drawn and reduced before the first is shown; results are merged */

/* Finds the part of the tile that belongs to the picture and to no other tile. */
static void find_part(const Render *render, int part[2][2])
{
    for (int i = 0; i < 2; i++) {
        const int inner = render->size[i] - render->margin, left = render->whole[i] - render->at[i];
        part[0][i] = render->margin;
        part[1][i] = left < inner ? left : inner;
    }
}

static bool measure_tile(Render *render, Measure *measure)
{
    int part[2][2];
    float texels[MEASURE_TEXELS][4];
    const bool adapted = measure == &render->picture->adapted;
    find_part(render, part);
    measure_set_part(measure, (const int(*)[2])part);
    if (adapted)
        texture_bind(render->gl, render->picture->whole[0], MEASURED_UNIT);
    measure_run(measure, frame_texture(render, FRAME_TARGET_light, 0), &render->screen);
    if (!measure_read(measure, texels))
        return false;
    measure_merge(render->picture->whole_texels[adapted], (const float(*)[4])texels);
    return true;
}

static bool make_whole(Render *render, int number)
{
    const TextureSpec spec = {.width = MEASURE_TEXELS,
                              .height = 1,
                              .lanes = 4,
                              .floats = render->picture->whole_texels[number][0]};
    render->gl->ActiveTexture(GL_TEXTURE0); /* texture_make binds the new texture */
    render->picture->whole[number] = texture_make(render->gl, &spec);
    return render->picture->whole[number] != 0;
}

static bool begin_whole(Render *render)
{
    static const float nothing[MEASURE_TEXELS][4] = {
        {0}, {0}, {0, 0, MEASURE_GREATEST, MEASURE_GREATEST}};
    render->gl->DeleteTextures(2, render->picture->whole); /* GL ignores the name 0 */
    for (int i = 0; i < 2; i++) {
        render->picture->whole[i] = 0;
        memcpy(render->picture->whole_texels[i], nothing, sizeof nothing);
    }
    return true;
}

/* The second reduction uses the result of the first. */
static bool pass_tone_count(Render *render, FrameCount step)
{
    const bool second = render->picture->whole[0] != 0;
    switch (step) {
    case FRAME_COUNT_wanted:
        return measures(render) && is_tiled(render);
    case FRAME_COUNT_begin:
        return begin_whole(render);
    case FRAME_COUNT_tile:
        return measure_tile(render,
                            second ? &render->picture->adapted : &render->picture->measured);
    case FRAME_COUNT_again:
        return !second && make_whole(render, 0) && adapts(render->scene);
    default:
        return second && (!adapts(render->scene) || make_whole(render, 1));
    }
}

/* Runs the reductions of a picture of one tile. */
static void measure_picture(Render *render)
{
    const GLuint light = frame_texture(render, FRAME_TARGET_light, 0);
    if (render->picture->measured.count) {
        measure_run(&render->picture->measured, light, &render->screen);
        texture_bind(render->gl, measure_result(&render->picture->measured), MEASURED_UNIT);
    }
    if (render->picture->adapted.count) {
        measure_run(&render->picture->adapted, light, &render->screen);
        texture_bind(render->gl, measure_result(&render->picture->adapted), ADAPTED_UNIT);
    }
}

static void pass_tone_draw(Render *render)
{
    const GLuint light = frame_texture(render, FRAME_TARGET_light, 0);
    if (!render->picture->whole[0])
        measure_picture(render);
    for (int i = 0; i < 2; i++)
        if (render->picture->whole[i])
            texture_bind(render->gl, render->picture->whole[i], i ? ADAPTED_UNIT : MEASURED_UNIT);
    texture_bind(render->gl, light, LIGHT_UNIT);
    if (has_edges(render))
        texture_bind(render->gl, frame_texture(render, FRAME_TARGET_edge, 0), EDGE_UNIT);
    if (pass_tools_are_there(render))
        texture_bind(render->gl, frame_texture(render, FRAME_TARGET_tools, 0), TOOLS_UNIT);
    screen_pass_run(&render->picture->tone, &render->targets.draws[FRAME_DRAW_shown],
                    &render->screen);
}

static void pass_tone_delete(Render *render)
{
    frame_retire(render, &render->picture->tone);
    measure_delete(render->gl, &render->picture->measured);
    measure_delete(render->gl, &render->picture->adapted);
    render->gl->DeleteTextures(2, render->picture->whole); /* GL ignores the name 0 */
    memset(render->picture->whole, 0, sizeof render->picture->whole);
}

static bool pass_tone_needed(const Render *render) { return render->scene != NULL; }

static bool pass_tone_changed(Render *render, unsigned what)
{
    render->uncounted |= what & RENDER_LIGHTS && pass_tone_count(render, FRAME_COUNT_wanted);
    return true;
}

const FramePass pass_tone = {
    .plan = {"tone", .reads = FRAME_BIT(light) | FRAME_BIT(edge) | FRAME_BIT(tools),
             .fills = FRAME_BIT(shown), .own = FRAME_BIT(edge)},
    .when = "the picture is wanted",
    .needed = pass_tone_needed,
    .make = pass_tone_make,
    .count = pass_tone_count,
    .draw = pass_tone_draw,
    .place = pass_tone_place,
    .changed = pass_tone_changed,
    .forget = pass_tone_delete,
};
