/* The tone pass: maps light to the picture's colors and blends edges. Its GLSL is tone.glsl and
 * pass_tone.glsl. Tone curves that depend on the whole picture use reductions made before. */
#include "gen/render_text.h"
#include "runtime/post/post.h"
#include <stdio.h>
#include <string.h>

enum { LIGHT_UNIT, MEASURED_UNIT, ADAPTED_UNIT, EDGE_UNIT, TOOLS_UNIT };

static bool has_edges(const Renderer *renderer)
{
    return renderer->targets.plan.there >> FRAME_TARGET_edge & 1;
}

static bool is_tiled(const Renderer *renderer)
{
    return renderer->size[0] - 2 * renderer->margin < renderer->whole[0] ||
           renderer->size[1] - 2 * renderer->margin < renderer->whole[1];
}

static bool measures(const Renderer *renderer)
{
    const Scene *scene = renderer->scene;
    return !renderer->options.linear &&
           (scene->tone == SCENE_Linear || scene->tone == SCENE_ReinhardDevlin ||
            scene->tone == SCENE_Drago);
}

static bool adapts(const Scene *scene) { return scene->tone == SCENE_ReinhardDevlin; }

static void set_numbers(const Renderer *renderer, ScreenPass *pass)
{
    const Scene *scene = renderer->scene;
    float numbers[4];
    for (int i = 0; i < 4; i++)
        numbers[i] = (float)scene->tone_numbers[i];
    material_set_number(&pass->material, "tone_exposure", (float)scene->exposure);
    material_set_number(&pass->material, "tone_pixels",
                        (float)renderer->whole[0] * (float)renderer->whole[1]);
    material_set(&pass->material, &(MaterialValue){"tone_numbers", 4, numbers});
    screen_pass_sampler(pass, "tone_measured", MEASURED_UNIT);
    screen_pass_sampler(pass, "tone_adapted", ADAPTED_UNIT);
}

/* Sets the numbers in every step: steps share a program, so different values would be uploaded
 * again in every frame. */
static void set_steps(const Renderer *renderer, Measure *measure)
{
    for (int i = 0; i < measure->count; i++)
        set_numbers(renderer, &measure->passes[i]);
}

/* Creates the reductions. The second one reduces the colors that the first one's result adapts. */
static bool make_measures(Renderer *renderer, const char *kind)
{
    const char *const first[] = {kind, render_text_tone, NULL};
    const char *const second[] = {kind, "#define MEASURE_ADAPTED\n", render_text_tone, NULL};
    if (!measures(renderer))
        return true;
    if (!measure_make(renderer->store, renderer->size, renderer->compute, first,
                      &renderer->post->measured))
        return false;
    set_steps(renderer, &renderer->post->measured);
    if (!adapts(renderer->scene))
        return true;
    if (!measure_make(renderer->store, renderer->size, renderer->compute, second,
                      &renderer->post->adapted))
        return false;
    set_steps(renderer, &renderer->post->adapted);
    return true;
}

static void pass_tone_place(Renderer *renderer)
{
    if (renderer->post->tone.material.store)
        backdrop_set(renderer, false, &renderer->post->tone);
}

static bool pass_tone_make(Renderer *renderer)
{
    char kind[128];
    snprintf(kind, sizeof kind, "#define TONE_%s\n#define TONE_SAMPLES %d\n%s%s",
             renderer->options.linear ? "LIGHT" : scene_kind_table[renderer->scene->tone].name,
             renderer->samples, measures(renderer) ? "#define TONE_MEASURES\n" : "",
             pass_tools_enabled(renderer) ? "#define TONE_TOOLS\n" : "");
    const ScreenPassText text = {
        .body = {kind, render_text_tone, backdrop_text(renderer),
                 has_edges(renderer) ? render_text_edge_part : render_text_edge_none,
                 render_text_pass_tone},
        .format = frame_format(renderer, FRAME_TARGET_final, 0),
        .compute = renderer->compute};
    if (!make_measures(renderer, kind) ||
        !screen_pass_make(renderer->store, &text, &renderer->post->tone))
        return false;
    set_numbers(renderer, &renderer->post->tone);
    screen_pass_sampler(&renderer->post->tone, "tone_light", LIGHT_UNIT);
    screen_pass_sampler(&renderer->post->tone, "edge_words", EDGE_UNIT);
    screen_pass_sampler(&renderer->post->tone, "tone_tools", TOOLS_UNIT);
    pass_tone_place(renderer);
    return true;
}

/* -- tiles: all tiles are drawn and reduced before the first is shown; results are merged */

/* Finds the part of the tile that belongs to the picture and to no other tile. */
static void find_part(const Renderer *renderer, int part[2][2])
{
    for (int i = 0; i < 2; i++) {
        const int inner = renderer->size[i] - renderer->margin,
                  left = renderer->whole[i] - renderer->at[i];
        part[0][i] = renderer->margin;
        part[1][i] = left < inner ? left : inner;
    }
}

static bool measure_tile(Renderer *renderer, Measure *measure)
{
    int part[2][2];
    float texels[MEASURE_TEXELS][4];
    const bool adapted = measure == &renderer->post->adapted;
    find_part(renderer, part);
    measure_set_part(measure, (const int(*)[2])part);
    if (adapted)
        texture_bind(renderer->gl, renderer->post->whole[0], MEASURED_UNIT);
    measure_run(measure, frame_texture(renderer, FRAME_TARGET_light, 0), &renderer->screen);
    if (!measure_read(measure, texels))
        return false;
    measure_merge(renderer->post->whole_texels[adapted], (const float(*)[4])texels);
    return true;
}

static bool make_whole(Renderer *renderer, int number)
{
    const TextureSpec spec = {.width = MEASURE_TEXELS,
                              .height = 1,
                              .components = 4,
                              .floats = renderer->post->whole_texels[number][0]};
    renderer->gl->ActiveTexture(GL_TEXTURE0); /* texture_make binds the new texture */
    renderer->post->whole[number] = texture_make(renderer->gl, &spec);
    return renderer->post->whole[number] != 0;
}

static bool begin_whole(Renderer *renderer)
{
    static const float nothing[MEASURE_TEXELS][4] = {
        {0}, {0}, {0, 0, MEASURE_GREATEST, MEASURE_GREATEST}};
    renderer->gl->DeleteTextures(2, renderer->post->whole); /* GL ignores the name 0 */
    for (int i = 0; i < 2; i++) {
        renderer->post->whole[i] = 0;
        memcpy(renderer->post->whole_texels[i], nothing, sizeof nothing);
    }
    return true;
}

/* The second reduction uses the result of the first. */
static bool pass_tone_count(Renderer *renderer, FrameCount step)
{
    const bool second = renderer->post->whole[0] != 0;
    switch (step) {
    case FRAME_COUNT_wanted:
        return measures(renderer) && is_tiled(renderer);
    case FRAME_COUNT_begin:
        return begin_whole(renderer);
    case FRAME_COUNT_tile:
        return measure_tile(renderer,
                            second ? &renderer->post->adapted : &renderer->post->measured);
    case FRAME_COUNT_again:
        return !second && make_whole(renderer, 0) && adapts(renderer->scene);
    default:
        return second && (!adapts(renderer->scene) || make_whole(renderer, 1));
    }
}

/* Runs the reductions of a picture of one tile. */
static void measure_picture(Renderer *renderer)
{
    const GLuint light = frame_texture(renderer, FRAME_TARGET_light, 0);
    if (renderer->post->measured.count) {
        measure_run(&renderer->post->measured, light, &renderer->screen);
        texture_bind(renderer->gl, measure_result(&renderer->post->measured), MEASURED_UNIT);
    }
    if (renderer->post->adapted.count) {
        measure_run(&renderer->post->adapted, light, &renderer->screen);
        texture_bind(renderer->gl, measure_result(&renderer->post->adapted), ADAPTED_UNIT);
    }
}

static void pass_tone_draw(Renderer *renderer)
{
    const GLuint light = frame_texture(renderer, FRAME_TARGET_light, 0);
    if (!renderer->post->whole[0])
        measure_picture(renderer);
    for (int i = 0; i < 2; i++)
        if (renderer->post->whole[i])
            texture_bind(renderer->gl, renderer->post->whole[i], i ? ADAPTED_UNIT : MEASURED_UNIT);
    texture_bind(renderer->gl, light, LIGHT_UNIT);
    if (has_edges(renderer))
        texture_bind(renderer->gl, frame_texture(renderer, FRAME_TARGET_edge, 0), EDGE_UNIT);
    if (pass_tools_enabled(renderer))
        texture_bind(renderer->gl, frame_texture(renderer, FRAME_TARGET_tools, 0), TOOLS_UNIT);
    screen_pass_run(&renderer->post->tone, &renderer->targets.draws[FRAME_DRAW_final],
                    &renderer->screen);
}

static void pass_tone_delete(Renderer *renderer)
{
    frame_retire(renderer, &renderer->post->tone);
    measure_delete(renderer->gl, &renderer->post->measured);
    measure_delete(renderer->gl, &renderer->post->adapted);
    renderer->gl->DeleteTextures(2, renderer->post->whole); /* GL ignores the name 0 */
    memset(renderer->post->whole, 0, sizeof renderer->post->whole);
}

static bool pass_tone_needed(const Renderer *renderer) { return renderer->scene != NULL; }

static bool pass_tone_changed(Renderer *renderer, unsigned what)
{
    renderer->uncounted |= what & RENDERER_LIGHTS && pass_tone_count(renderer, FRAME_COUNT_wanted);
    return true;
}

const FramePass pass_tone = {
    .plan = {"tone", .reads = FRAME_BIT(light) | FRAME_BIT(edge) | FRAME_BIT(tools),
             .fills = FRAME_BIT(final), .own = FRAME_BIT(edge)},
    .when = "the final image is requested",
    .needed = pass_tone_needed,
    .make = pass_tone_make,
    .count = pass_tone_count,
    .draw = pass_tone_draw,
    .place = pass_tone_place,
    .changed = pass_tone_changed,
    .forget = pass_tone_delete,
};
