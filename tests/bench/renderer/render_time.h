/* Scenes whose drawing is timed: by the renderer, and by the forward renderer. */
#ifndef RENDER_TIME_H
#define RENDER_TIME_H
#include "compiler/base/text.h"
#include "render_forward.h"
#include "runtime/renderer/renderer.h"

typedef struct {
    GlContext *gl;
    MatcOptions compile;
    int width, height;
    bool timed;
    double seconds; /* time for repeated draws of a row; the first frames are always drawn */
    FILE *csv;      /* or NULL */
} Bench;

/* A scene, and its renderers. */
typedef struct {
    MatcDocument *document;
    Scene *scene;
    Renderer *render;
    Renderer *bounded; /* a renderer with grouped far lights, or NULL */
    Forward *forward;  /* or NULL */
} BenchScene;

/* Renderer that draws a scene. */
typedef enum { BENCH_WAY_deferred, BENCH_WAY_bounded, BENCH_WAY_forward, BENCH_WAYS } BenchWay;

typedef struct {
    double median, least; /* seconds per frame */
} BenchTimes;

/* Returns false after a message on standard error. Close in any case. `options` are those of the
 * renderer except size and choices. */
bool bench_scene_open(const Bench *bench, const Text *text, const RendererOptions *options,
                      BenchScene *made);
bool bench_scene_open_bounded(const Bench *bench, const RendererOptions *options, BenchScene *made);
bool bench_scene_open_forward(const Bench *bench, BenchScene *made);
void bench_scene_close(BenchScene *scene);
/* Times frames of all renderers alternately, each frame finished; NAN for missing renderers. */
bool bench_scene_time(const Bench *bench, BenchScene *scene, BenchTimes times[BENCH_WAYS]);
/* Minimum seconds of each pass; returns the number of passes. */
int bench_scene_passes(const Bench *bench, BenchScene *scene,
                       RendererPassTime least[RENDERER_PASSES_MAX]);
/* The share of pixels at which the light, clamped to 1, differs between a renderer and the
 * forward renderer by more than `bound`; with two renderers, the worse one's. NAN: pictures are
 * black, or could not be read. */
double bench_scene_apart(const Bench *bench, BenchScene *scene, double bound);
/* Writes a measurement to the CSV file, if there is a CSV file. */
void bench_csv(const Bench *bench, const char *table, const char *row, const char *measure,
               double value);
#endif
