/* Frames by several methods, drawn alternately. Each method has its own renderer and scene,
 * because a scene's light has one method. */
#include "shadows.h"
#include "tests/bench/matbench.h"
#include <math.h>
#include <stdlib.h>

enum { MAX_ROUNDS = 64, FEWEST_ROUNDS = 3 };

typedef struct {
    ShadowsPlace place;
    Renderer *render;
} Timed;

static bool open_timed(const Shadows *s, const ShadowsTiming *timing, int method, Timed *timed)
{
    const int usual[2] = {s->gl->hardware ? 1920 : 480, s->gl->hardware ? 1080 : 270};
    const int *size = timing->size[0] ? timing->size : usual;
    const RendererOptions options = {
        .compile = &s->compile, .view = "light", .width = size[0], .height = size[1]};
    if (!shadows_open(SHADOWS_frame, timing->mesh, &s->compile, &timed->place))
        return false;
    shadows_use(timed->place.scene, &timing->methods[method], timing->map_size);
    timed->render = renderer_open(s->gl, &options);
    return (timed->render && renderer_set_scene(timed->render, timed->place.scene) &&
            renderer_frame(timed->render)) ||
           fprintf(stderr, "matbench: %s\n", s->gl->error) < 0;
}

/* Seconds per frame, for `frames` frames that are finished together. */
static double draw(const Shadows *s, Timed *timed, bool moving, int frames)
{
    SceneLight *light = timed->place.scene->lights;
    const double start = bench_now();
    for (int i = 0; i < frames; i++) {
        light->direction[0] += moving ? (i % 2 ? -1e-3 : 1e-3) : 0;
        if (moving)
            renderer_changed(timed->render, RENDERER_LIGHTS);
        renderer_frame(timed->render);
    }
    s->gl->Finish();
    return (bench_now() - start) / frames;
}

/* Enough frames to outlast a GPU's synchronization; an even number. */
static int frames_of(const Shadows *s, Timed *timed, bool moving)
{
    const double least = 5e-3, one = draw(s, timed, moving, 2);
    return 2 + 2 * (int)(least / (2 * fmax(one, 1e-5)));
}

static void time_all(const Shadows *s, const ShadowsTiming *timing, Timed *timed, bool moving,
                     double *least)
{
    const double end = bench_now() + timing->seconds;
    int *frames = calloc((size_t)timing->count, sizeof *frames);
    for (int i = 0; frames && i < timing->count; i++) {
        frames[i] = frames_of(s, &timed[i], moving);
        least[i] = INFINITY;
    }
    for (int round = 0;
         frames && round < MAX_ROUNDS && (round < FEWEST_ROUNDS || bench_now() < end); round++)
        for (int i = 0; i < timing->count; i++)
            least[i] = fmin(least[i], draw(s, &timed[i], moving, frames[i]));
    free(frames);
}

static bool measure(const Shadows *s, const ShadowsTiming *timing, Timed *timed, ShadowsTime *times)
{
    double still[SHADOWS_METHODS_MAX] = {0}, moving[SHADOWS_METHODS_MAX] = {0};
    for (int i = 0; i < timing->count; i++)
        if (!open_timed(s, timing, i, &timed[i]))
            return false;
    time_all(s, timing, timed, false, still);
    time_all(s, timing, timed, true, moving);
    for (int i = 0; i < timing->count; i++)
        times[i] = (ShadowsTime){still[i], moving[i]};
    return gl_check(s->gl, "drawing frames") || fprintf(stderr, "matbench: %s\n", s->gl->error) < 0;
}

bool shadows_time(const Shadows *s, const ShadowsTiming *timing, ShadowsTime *times)
{
    Timed timed[SHADOWS_METHODS_MAX] = {{{0}, NULL}};
    for (int i = 0; i < timing->count; i++)
        times[i] = (ShadowsTime){NAN, NAN};
    const bool fine = !s->timed || measure(s, timing, timed, times);
    for (int i = 0; i < timing->count; i++) {
        renderer_close(timed[i].render);
        shadows_close(&timed[i].place);
    }
    return fine;
}
