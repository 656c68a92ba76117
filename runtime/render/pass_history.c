/* The pass history: what rays found in frames before, kept for those after, in targets of its own, two of each in turns. Its GLSL is pass_history.glsl, behind
 * indirect_place.glsl. Without it, none of this is there. */
#include "runtime/render/frame.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

extern const char render_text_indirect_place[], render_text_pass_history[];

enum { RAYS_UNIT = INDIRECT_FREE_UNIT, VALUES_UNIT, PLACES_UNIT };

static bool make_target(Render *render, Framebuffer *made)
{
    const FramebufferSpec spec = {.width = frame_edge(render, FRAME_TARGET_rays, 0),
                                  .height = frame_edge(render, FRAME_TARGET_rays, 1),
                                  .color_count = 1};
    return framebuffer_make_named(render->gl, &spec, (const char *const[]){"RGBA32F"}, made);
}

static bool make_pass(Render *render, bool place, ScreenPass *pass)
{
    char defined[INDIRECT_DEFINITIONS];
    indirect_define(render, defined);
    const ScreenPassText text = {.body = {indirect_surface_text(render), defined,
                                          place ? "#define HISTORY_PLACE\n" : "", render_text_indirect_place,
                                          render_text_pass_history},
                                 .format = "RGBA32F",
                                 .compute = render->compute};
    if (!screen_pass_make(render->store, &text, pass))
        return false;
    screen_pass_sampler(pass, "history_rays", RAYS_UNIT);
    screen_pass_sampler(pass, "history_values", VALUES_UNIT);
    screen_pass_sampler(pass, "history_places", PLACES_UNIT);
    indirect_set(render, pass);
    return true;
}

bool pass_history_make(Render *render)
{
    IndirectHistory *history = &render->indirect.history;
    bool done = make_pass(render, false, &history->blend) && make_pass(render, true, &history->place);
    for (int i = 0; done && i < 2; i++)
        done = make_target(render, &history->values[i]) && make_target(render, &history->places[i]);
    return done;
}

/* From the eye's space of now to that of the frame before, in double: both are turned and moved alone, so that the inverse of a turn is its transpose. */
static void find_motion(const Render *render, float made[4][4])
{
    const double *now = render->space.eye_from_world, *was = render->indirect.history.eye_from_world;
    double turn[3][3] = {{0}}; /* columns */
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++)
            for (int k = 0; k < 3; k++)
                turn[column][row] += was[4 * k + row] * now[4 * k + column];
    memset(made, 0, 4 * sizeof *made);
    for (int row = 0; row < 3; row++) {
        double moved = was[12 + row];
        for (int column = 0; column < 3; column++) {
            made[column][row] = (float)turn[column][row];
            moved -= turn[column][row] * now[12 + column];
        }
        made[3][row] = (float)moved;
    }
    made[3][3] = 1;
}

static void set_block(const Render *render, ScreenPass *pass)
{
    const IndirectHistory *history = &render->indirect.history;
    float block[7][4] = {{0}};
    find_motion(render, block);
    memcpy(block[4], history->ray, sizeof block[4]);
    memcpy(block[5], history->depth, sizeof block[5]);
    block[6][0] = (float)indirect_most_sets(render);
    block[6][1] = history->there;
    block[6][2] = history->still;
    material_write(&pass->material, "History", block, sizeof block);
}

/* One set of rays more. */
static void blend(Render *render)
{
    IndirectHistory *history = &render->indirect.history;
    const int next = 1 - history->last;
    indirect_bind(render);
    texture_bind(render->gl, frame_texture(render, FRAME_TARGET_rays, 0), RAYS_UNIT);
    texture_bind(render->gl, history->values[history->last].colors[0], VALUES_UNIT);
    texture_bind(render->gl, history->places[history->last].colors[0], PLACES_UNIT);
    set_block(render, &history->blend);
    set_block(render, &history->place);
    screen_pass_run(&history->blend, &history->values[next], &render->screen);
    screen_pass_run(&history->place, &history->places[next], &render->screen);
    memcpy(history->eye_from_world, render->space.eye_from_world, sizeof history->eye_from_world);
    memcpy(history->ray, render->space.ray, sizeof history->ray);
    memcpy(history->depth, render->space.depth, sizeof history->depth);
    history->last = next;
    history->sets = history->still ? history->sets + 1 : 1;
    history->number++;
    history->there = history->still = true;
}

/* How far b is off, the mean of twice as many sets of rays as a: the second half's mean is 2 b - a, so b - a is half of what two means differ by that have nothing to do with each other, and that is
 * about what the mean of both is off. */
static double difference(const float *a, const float *b, size_t pixels)
{
    double sum = 0;
    for (size_t i = 0; i < pixels; i++)
        sum += ((double)b[4 * i + 3] - (double)a[4 * i + 3]) * ((double)b[4 * i + 3] - (double)a[4 * i + 3]);
    return sqrt(sum / (double)pixels);
}

/* Asked when there are 1, 2, 4, ... sets: openness is as exact as is wanted. */
static bool is_exact(Render *render, float *means[2])
{
    IndirectHistory *history = &render->indirect.history;
    const Framebuffer *values = &history->values[history->last];
    const size_t pixels = (size_t)values->spec.width * (size_t)values->spec.height;
    float *before = means[0];
    means[0] = means[1];
    means[1] = before;
    return framebuffer_read(render->gl, values, 0, means[1]) && history->sets > 1 &&
           difference(means[0], means[1], pixels) <= render->scene->indirect.error;
}

void pass_history_draw(Render *render)
{
    IndirectHistory *history = &render->indirect.history;
    const SceneIndirect *in = &render->scene->indirect;
    const size_t pixels = (size_t)history->values[0].spec.width * (size_t)history->values[0].spec.height;
    float *means[2] = {NULL, NULL};
    if (indirect_is_done(render))
        return;
    if (in->error > 0)
        for (int i = 0; i < 2; i++)
            means[i] = calloc(pixels, 4 * sizeof **means);
    for (int i = 0; i < in->samples && !indirect_is_done(render); i++) {
        if (i)
            pass_rays_draw(render);
        blend(render);
        if (means[0] && means[1] && !(history->sets & (history->sets - 1)))
            history->exact = is_exact(render, means);
    }
    free(means[0]);
    free(means[1]);
}
