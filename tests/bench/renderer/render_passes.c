/* Cost of a frame's passes, bytes per pixel, and cost of a transparent fragment. */
#include <stdio.h>
#include "render_passes.h"
#include "tests/bench/matbench.h"
#include "render_scenes.h"
#include <math.h>
#include <string.h>

/* -- passes, and bytes of a pixel */

typedef struct {
    const char *name;
    int panes;
    RendererOptions options;
} Whole;

static const Whole wholes[] = {
    {"opaque", 0, {.edges = RENDERER_EDGES_none}},
    {"with edges", 0, {.edges = RENDERER_EDGES_coverage}},
    {"ten panes, lists", 10, {.edges = RENDERER_EDGES_coverage, .transparency = "lists"}},
    {"ten panes, peeled", 10, {.edges = RENDERER_EDGES_coverage, .transparency = "peeling"}},
};
enum { WHOLES = sizeof wholes / sizeof *wholes };

typedef struct {
    RendererPassTime passes[RENDERER_PASSES_MAX];
    int count, bytes, fragment_bytes;
} WholeTimes;

static bool measure_whole(const Bench *bench, const Whole *whole, WholeTimes *times)
{
    Arena arena = {0};
    Text text = text_new(&arena);
    BenchScene scene = {0};
    bench_show(whole->name);
    scenes_passes(&text, whole->panes);
    const bool fine = bench_scene_open(bench, &text, &whole->options, &scene);
    if (fine && bench->timed)
        times->count = bench_scene_passes(bench, &scene, times->passes);
    else if (fine)
        times->count = renderer_time_passes(scene.render, times->passes); /* which there are */
    times->bytes = fine ? renderer_pixel_bytes(scene.render) : 0;
    times->fragment_bytes = fine ? renderer_fragment_bytes(scene.render) : 0;
    bench_show("");
    bench_scene_close(&scene);
    arena_free(&arena);
    return fine;
}

/* "" if the pass does not run. */
static const char *pass_time(const Bench *bench, const RendererPassTime *pass,
                             char text[BENCH_NUMBER])
{
    if (pass->seconds == 0)
        return "";
    return bench_number(text, 3, bench->timed ? 1e3 * pass->seconds : NAN);
}

static void put_pass(const Bench *bench, const WholeTimes *times, int pass)
{
    printf("%-10s", times->passes[pass].name);
    for (int k = 0; k < WHOLES; k++) {
        printf(" %18s", pass_time(bench, &times[k].passes[pass], (char[BENCH_NUMBER]){0}));
        bench_csv(bench, wholes[k].name, times->passes[pass].name, "seconds",
                  bench->timed && times[k].passes[pass].seconds > 0 ? times[k].passes[pass].seconds
                                                                    : NAN);
    }
    putchar('\n');
}

static void put_bytes(const char *name, const int bytes[WHOLES])
{
    printf("%-10s", name);
    for (int k = 0; k < WHOLES; k++)
        printf(" %18d", bytes[k]);
    putchar('\n');
}

bool bench_passes(const Bench *bench)
{
    static WholeTimes times[WHOLES];
    int bytes[WHOLES], fragment_bytes[WHOLES];
    for (int k = 0; k < WHOLES; k++) {
        if (!measure_whole(bench, &wholes[k], &times[k]))
            return false;
        bytes[k] = times[k].bytes;
        fragment_bytes[k] = times[k].fragment_bytes;
    }
    printf("\npasses: solids, a plane, a sky, a spot and the sun with shadows, ReinhardDevlin; "
           "milliseconds, and "
           "bytes\n%-10s",
           "pass");
    for (int k = 0; k < WHOLES; k++)
        printf(" %18s", wholes[k].name);
    putchar('\n');
    for (int i = 0; i < times->count; i++)
        put_pass(bench, times, i);
    put_bytes("a pixel", bytes);
    put_bytes("a fragment", fragment_bytes);
    return true;
}

/* -- transparent fragments */

/* Seconds of the passes of these names. */
static double seconds_of(const RendererPassTime *passes, int count, const char *const names[2])
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 2; k++)
            sum += names[k] && !strcmp(passes[i].name, names[k]) ? passes[i].seconds : 0;
    return sum;
}

/* Measures square pictures, since all pixels are covered; no ratio depends on their size. */
static bool measure_layers(const Bench *bench, int layers, const char *way)
{
    enum { SIDE = 256, SIDE_OF_GPU = 1024 };
    static const char *const parts[][2] = {
        {"lists", NULL}, {"blend", NULL}, {"peel", NULL}, {"lists", "blend"}};
    Bench square = *bench;
    RendererPassTime passes[RENDERER_PASSES_MAX];
    Arena arena = {0};
    Text text = text_new(&arena);
    BenchScene scene = {0};
    char row[64];
    double nanoseconds[] = {NAN, NAN, NAN, NAN};
    square.width = square.height = bench->gl->hardware ? SIDE_OF_GPU : SIDE;
    snprintf(row, sizeof row, "%d layers, %s", layers, way);
    bench_show(row);
    scenes_panes(&text, layers);
    const bool fine = bench_scene_open(
        &square, &text, &(RendererOptions){.view = "light", .transparency = way}, &scene);
    if (fine && bench->timed) {
        const int count = bench_scene_passes(&square, &scene, passes);
        for (int i = 0; i < 4; i++) {
            nanoseconds[i] =
                1e9 * seconds_of(passes, count, parts[i]) / layers / square.width / square.height;
            nanoseconds[i] = nanoseconds[i] > 0 ? nanoseconds[i] : NAN;
        }
    }
    bench_show("");
    if (fine)
        printf("%-22s %10s %10s %10s %14s\n", row, NUMBER(3, nanoseconds[0]),
               NUMBER(3, nanoseconds[1]), NUMBER(3, nanoseconds[2]),
               NUMBER(3, isnan(nanoseconds[2]) ? nanoseconds[3] : nanoseconds[2]));
    for (int i = 0; i < 3; i++)
        bench_csv(bench, "fragments", row, parts[i][0], 1e-9 * nanoseconds[i]);
    bench_scene_close(&scene);
    arena_free(&arena);
    return fine;
}

bool bench_fragments(const Bench *bench)
{
    static const int layers[] = {1, 2, 4, 10, 40};
    static const char *const ways[] = {"lists", "peeling"};
    bool fine = true;
    printf("\nfragments: panes over all pixels, one lamp; nanoseconds a transparent "
           "fragment\n%-22s %10s %10s %10s %14s\n",
           "", "lists", "blend", "peel", "a fragment");
    for (size_t i = 0; fine && i < sizeof layers / sizeof *layers; i++)
        for (int k = 0; fine && k < 2; k++)
            fine = measure_layers(bench, layers[i], ways[k]);
    return fine;
}
