/* Cost of a point light by surface model: nanoseconds per pixel and light, from 1 to 64 lights,
 * and relative to Phong. Frames of all surfaces and light counts are drawn alternately; the
 * minimum of each counts. `plastic+` is plastic in a scene in which another material has a coat
 * and fuzz. */
#include <stdio.h>
#include "render_passes.h"
#include "tests/bench/matbench.h"
#include "render_scenes.h"
#include <math.h>
#include <string.h>
#include <time.h>

enum { SIDE = 256, SIDE_OF_GPU = 1024, ROUNDS = 12 };
static const int counts[] = {1, 4, 16, 64};
enum { COUNTS = sizeof counts / sizeof *counts };
static const struct {
    const char *name, *material;
    bool beside; /* the scene has an additional, invisible material with all lobes */
} surfaces[] = {
    {"Phong", "material: Phong, diffuse: [.5, .4, .3], specular: .3, shininess: .7", false},
    {"plastic", "material: Principled, baseColor: [.5, .4, .3], roughness: '= .2 + .6 * u'", false},
    {"metal",
     "material: Principled, baseColor: [.9, .6, .3], metalness: 1, roughness: '= .2 + .6 * u'",
     false},
    {"brushed",
     "material: Principled, baseColor: [.9, .6, .3], metalness: 1, roughness: .5, anisotropy: .7",
     false},
    {"painted",
     "material: Principled, baseColor: [.5, .4, .3], roughness: '= .2 + .6 * u', coat: .8, "
     "coatRoughness: .2",
     false},
    {"cloth",
     "material: Principled, baseColor: [.5, .4, .3], roughness: .7, fuzz: .6, fuzzRoughness: .5",
     false},
    {"both",
     "material: Principled, baseColor: [.5, .4, .3], roughness: .7, fuzz: .6, fuzzRoughness: .5, "
     "coat: .8, "
     "coatRoughness: .2",
     false},
    {"plastic+", "material: Principled, baseColor: [.5, .4, .3], roughness: '= .2 + .6 * u'", true},
};
enum { SURFACES = sizeof surfaces / sizeof *surfaces };

typedef struct {
    BenchScene scenes[SURFACES][COUNTS];
    double seconds[SURFACES][COUNTS]; /* seconds of the pass light; NAN: not drawn */
} Lobes;

static bool open_scenes(const Bench *bench, Lobes *made)
{
    const RendererOptions options = {.view = "light", .lights = "all"};
    bool fine = true;
    for (int i = 0; i < SURFACES && fine; i++)
        for (int k = 0; k < COUNTS && fine; k++) {
            Arena arena = {0};
            Text text = text_new(&arena);
            bench_show(surfaces[i].name);
            scenes_lobes(&text, surfaces[i].material, counts[k]);
            if (surfaces[i].beside)
                scenes_unseen(&text);
            fine = bench_scene_open(bench, &text, &options, &made->scenes[i][k]);
            arena_free(&arena);
        }
    bench_show("");
    return fine;
}

static double processor_seconds(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

/* On a GPU the seconds of the pass light; otherwise CPU time of all threads for a frame, hardly
 * affected by other programs. */
static double light_seconds(const Bench *bench, BenchScene *scene)
{
    RendererPassTime times[RENDERER_PASSES_MAX];
    if (!bench->gl->hardware) {
        const double start = processor_seconds();
        renderer_frame(scene->render);
        bench->gl->Finish();
        return processor_seconds() - start;
    }
    const int count = renderer_time_passes(scene->render, times);
    for (int i = 0; i < count; i++)
        if (!strcmp(times[i].name, "light"))
            return times[i].seconds;
    return NAN;
}

static void put_rows(const Bench *bench, const Lobes *lobes)
{
    const double pixels = (double)bench->width * bench->height * (counts[COUNTS - 1] - counts[0]);
    double phong = NAN;
    for (int i = 0; i < SURFACES; i++) {
        const double *seconds = lobes->seconds[i],
                     one = 1e9 * (seconds[COUNTS - 1] - seconds[0]) / pixels;
        phong = i ? phong : one;
        printf("%-10s", surfaces[i].name);
        for (int k = 0; k < COUNTS; k++)
            printf(" %10s", NUMBER(3, 1e3 * seconds[k]));
        printf(" %10s %8s\n", NUMBER(4, one), NUMBER(2, one / phong));
        bench_csv(bench, "surfaces", surfaces[i].name, "a light", 1e-9 * one);
    }
}

bool bench_lobes(const Bench *bench)
{
    static Lobes lobes;
    Bench square = *bench;
    square.width = square.height = bench->gl->hardware ? SIDE_OF_GPU : SIDE;
    const bool fine = open_scenes(&square, &lobes);
    for (int i = 0; i < SURFACES; i++)
        for (int k = 0; k < COUNTS; k++)
            lobes.seconds[i][k] = bench->timed ? INFINITY : NAN;
    for (int round = 0; round < ROUNDS && fine && bench->timed; round++)
        for (int i = 0; i < SURFACES; i++)
            for (int k = 0; k < COUNTS; k++)
                lobes.seconds[i][k] =
                    fmin(lobes.seconds[i][k], light_seconds(&square, &lobes.scenes[i][k]));
    printf("\nsurfaces: a wall, point lights; milliseconds of the pass light on a GPU, else of the "
           "processor, a frame; "
           "nanoseconds a pixel and light\n%-10s",
           "lights");
    for (int k = 0; k < COUNTS; k++)
        printf(" %10d", counts[k]);
    printf(" %10s %8s\n", "a light", "/ Phong");
    if (fine)
        put_rows(&square, &lobes);
    for (int i = 0; i < SURFACES; i++)
        for (int k = 0; k < COUNTS; k++)
            bench_scene_close(&lobes.scenes[i][k]);
    return fine;
}
