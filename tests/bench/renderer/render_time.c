/* Opens scenes, times frames and passes, compares pictures. */
#include <stdio.h>
#include "render_time.h"
#include "tests/bench/matbench.h"
#include "runtime/scene_reader/scene_read.h"
#include <math.h>
#include <stdlib.h>

enum { MAX_FRAMES = 64, FEWEST_FRAMES = 3 };

static bool reported(const char *why) { return fprintf(stderr, "matbench: %s\n", why) < 0; }

static RendererOptions options_of(const Bench *bench, const RendererOptions *options)
{
    RendererOptions with = *options;
    with.compile = &bench->compile;
    with.width = bench->width;
    with.height = bench->height;
    return with;
}

/* Opens a renderer, and draws a first frame. */
static bool open_renderer(const Bench *bench, const RendererOptions *options, const Scene *scene,
                          Renderer **made)
{
    *made = renderer_open(bench->gl, options);
    return (*made && renderer_set_scene(*made, scene) && renderer_frame(*made)) ||
           reported(bench->gl->error);
}

bool bench_scene_open(const Bench *bench, const Text *text, const RendererOptions *options,
                      BenchScene *made)
{
    const RendererOptions with = options_of(bench, options);
    *made = (BenchScene){0};
    made->document = scene_read("bench.yaml", text->at, text->size, &bench->compile, &made->scene);
    if (!made->scene)
        return reported(matc_diagnostics(made->document, MATC_TEXT));
    return open_renderer(bench, &with, made->scene, &made->render);
}

bool bench_scene_open_bounded(const Bench *bench, const RendererOptions *options, BenchScene *made)
{
    RendererOptions with = options_of(bench, options);
    with.lights = "bounded";
    return open_renderer(bench, &with, made->scene, &made->bounded);
}

bool bench_scene_open_forward(const Bench *bench, BenchScene *made)
{
    const ForwardSource source = {made->scene, &bench->compile, bench->width, bench->height};
    made->forward = forward_open(bench->gl, &source);
    if (!made->forward)
        return reported(bench->gl->error);
    forward_draw(made->forward);
    return true;
}

void bench_scene_close(BenchScene *scene)
{
    forward_close(scene->forward);
    renderer_close(scene->bounded);
    renderer_close(scene->render);
    scene_free(scene->scene);
    matc_document_free(scene->document);
    *scene = (BenchScene){0};
}

static bool draws(const BenchScene *scene, BenchWay way)
{
    return way == BENCH_WAY_deferred ||
           (way == BENCH_WAY_bounded ? scene->bounded != NULL : scene->forward != NULL);
}

/* Seconds per frame, for `frames` frames that are finished together. */
static double draw(const Bench *bench, BenchScene *scene, BenchWay way, int frames)
{
    const double start = bench_now();
    for (int i = 0; i < frames; i++)
        if (way == BENCH_WAY_forward)
            forward_draw(scene->forward);
        else
            renderer_frame(way == BENCH_WAY_bounded ? scene->bounded : scene->render);
    bench->gl->Finish();
    return (bench_now() - start) / frames;
}

/* Enough frames to outlast a GPU's synchronization. */
static int frames_of(const Bench *bench, BenchScene *scene, BenchWay way)
{
    const double least = 5e-3, one = draw(bench, scene, way, 1);
    return 1 + (int)(least / (one > 1e-5 ? one : 1e-5));
}

static BenchTimes times_of(double *seconds, int count)
{
    const double median = bench_median(seconds, count); /* bench_median sorts the list */
    return (BenchTimes){median, seconds[0]};
}

bool bench_scene_time(const Bench *bench, BenchScene *scene, BenchTimes times[BENCH_WAYS])
{
    double seconds[BENCH_WAYS][MAX_FRAMES];
    const double end = bench_now() + bench->seconds;
    int count = 0, frames[BENCH_WAYS] = {0};
    bench->gl->Finish();
    for (int way = 0; way < BENCH_WAYS; way++)
        if (draws(scene, way))
            /* the first frame was drawn when the scene was opened */
            frames[way] = frames_of(bench, scene, way);
    for (; count < MAX_FRAMES && (count < FEWEST_FRAMES || bench_now() < end); count++)
        for (int way = 0; way < BENCH_WAYS; way++)
            if (draws(scene, way))
                seconds[way][count] = draw(bench, scene, way, frames[way]);
    for (int way = 0; way < BENCH_WAYS; way++)
        times[way] = draws(scene, way) ? times_of(seconds[way], count) : (BenchTimes){NAN, NAN};
    return gl_check(bench->gl, "drawing frames") || reported(bench->gl->error);
}

int bench_scene_passes(const Bench *bench, BenchScene *scene,
                       RendererPassTime least[RENDERER_PASSES_MAX])
{
    const double end = bench_now() + bench->seconds;
    RendererPassTime times[RENDERER_PASSES_MAX];
    const int count = renderer_time_passes(scene->render, least);
    for (int frames = 1; frames < MAX_FRAMES && (frames < FEWEST_FRAMES || bench_now() < end);
         frames++) {
        renderer_time_passes(scene->render, times);
        for (int i = 0; i < count; i++)
            least[i].seconds = fmin(least[i].seconds, times[i].seconds);
    }
    return count;
}

void bench_csv(const Bench *bench, const char *table, const char *row, const char *measure,
               double value)
{
    if (bench->csv && !isnan(value))
        fprintf(bench->csv, "%s,%s,%s,%.9g\n", table, row, measure, value);
}

static bool is_black(const float *rgba, int pixels)
{
    int lit = 0;
    for (int i = 0; i < 4 * pixels; i++)
        lit += i % 4 < 3 && rgba[i] > .05f;
    return lit == 0;
}

/* Number of pixels that differ between two pictures. */
static int count_apart(const float *a, const float *b, int pixels, double bound)
{
    int apart = 0;
    for (int i = 0; i < pixels; i++) {
        double most = 0;
        for (int component = 4 * i; component < 4 * i + 3; component++)
            most = fmax(most, isnan(a[component]) || isnan(b[component])
                                  ? INFINITY
                                  : fabs(fmin(a[component], 1) - fmin(b[component], 1)));
        apart += most > bound;
    }
    return apart;
}

static double apart_from_forward(const Bench *bench, const BenchScene *scene, Renderer *render,
                                 double bound)
{
    const int pixels = bench->width * bench->height;
    float *rgba[2];
    double apart = NAN;
    for (int i = 0; i < 2; i++)
        rgba[i] = calloc((size_t)pixels, 4 * sizeof **rgba);
    if (rgba[0] && rgba[1] && renderer_frame(render) && renderer_read(render, rgba[0]) &&
        forward_read(scene->forward, rgba[1]) && !is_black(rgba[0], pixels))
        apart = (double)count_apart(rgba[0], rgba[1], pixels, bound) / pixels;
    free(rgba[0]);
    free(rgba[1]);
    return apart;
}

double bench_scene_apart(const Bench *bench, BenchScene *scene, double bound)
{
    const double apart = apart_from_forward(bench, scene, scene->render, bound);
    const double bounded =
        scene->bounded ? apart_from_forward(bench, scene, scene->bounded, bound) : 0;
    return isnan(bounded) || bounded > apart ? bounded : apart;
}
