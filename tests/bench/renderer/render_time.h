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
    double seconds; /* that a row may be drawn again and again; the first frames always are */
    FILE *csv;      /* or NULL */
} Bench;

/* A scene, and what draws it. */
typedef struct {
    MatcDocument *document;
    Scene *scene;
    Renderer *render;
    Renderer *bounded; /* the same with far lights taken together, or NULL */
    Forward *forward;  /* or NULL */
} BenchScene;

/* Renderer that draws a scene. */
typedef enum { BENCH_WAY_deferred, BENCH_WAY_bounded, BENCH_WAY_forward, BENCH_WAYS } BenchWay;

typedef struct {
    double median, least; /* seconds of a frame */
} BenchTimes;

/* False: said on standard error. Close in any case. `options` are those of the renderer but for
 * size and choices. */
bool bench_scene_open(const Bench *bench, const Text *text, const RendererOptions *options,
                      BenchScene *made);
bool bench_scene_open_bounded(const Bench *bench, const RendererOptions *options, BenchScene *made);
bool bench_scene_open_forward(const Bench *bench, BenchScene *made);
void bench_scene_close(BenchScene *scene);
/* Frames of all that draw it, in turns, each finished; NAN of the others. */
bool bench_scene_time(const Bench *bench, BenchScene *scene, BenchTimes times[BENCH_WAYS]);
/* The least seconds that each pass takes; how many passes there are. */
int bench_scene_passes(const Bench *bench, BenchScene *scene,
                       RendererPassTime least[RENDERER_PASSES_MAX]);
/* The share of pixels at which the light, cut at 1, of one renderer's picture and of the forward
 * renderer's is apart by more than `bound`; where there are two, of the one that is worse. NAN:
 * they are black, or could not be read. */
double bench_scene_apart(const Bench *bench, BenchScene *scene, double bound);
/* A line of the CSV, where there is one, of what was measured. */
void bench_csv(const Bench *bench, const char *table, const char *row, const char *measure,
               double value);
#endif
