/* matbench indirect passes: time of each pass of indirect light, by the driver's timer query
 * where available, in the scenes that have goals, next to the thesis' march of 32 rays of 32
 * steps. All variants of a scene are timed alternately. The errors are measured by
 * test_frame_indirect_truth goals. */
#include "indirect_passes.h"
#include "tests/bench/matbench.h"
#include "runtime/gl/clock.h"
#include "runtime/scene_reader/scene_read.h"
#include "tests/frame/indirect_scenes.h"
#include "tests/meshes/meshes.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 4096, FRAMES = 5, FRAMES_MAX = 200, ROWS_MAX = 8 };

/* In the order of a frame: found for each frame; made once for a scene, or its lamps. */
static const char *const timed_passes[] = {"rays",     "temporal", "denoise",
                                           "upsample", "voxels",   "radiance"};
enum { TIMED = sizeof timed_passes / sizeof *timed_passes, EACH_FRAME = 4 };

static const char thesis[] = "method: march, rays: 32, steps: 32, filter: none";

static const char sky[] =
    "camera: { camera: Perspective, position: [0, -4.25, 1], target: [0, 0, 1], angle: 39 "
    "}\nlights: [{ light: Sky }]\n"
    "sky: { material: SunSkyLight, sun: [-1, .25, .12], turbidity: 4, disableSun: true }\n"
    "materials: { m: { material: Phong, diffuse: .75, specular: 0 } }\nobjects:\n"
    "- { object: Box, material: m, size: [2.2, 2.2, .1], transform: { translation: [0, 0, -.05] } "
    "}\n"
    "- { object: Box, material: m, size: [2.2, .1, 2.2], transform: { translation: [0, 1.05, 1] } "
    "}\n"
    "- { object: Box, material: m, size: [.1, 2.2, 2.2], transform: { translation: [-1.05, 0, 1] } "
    "}\n"
    "- { object: Sphere, radius: .5, material: m, transform: { translation: [.3, -.2, .5] } }\n";

typedef struct {
    const char *name, *view, *body; /* NULL: the bunny's */
    double radius;
    int bounces;
    double
        /* max milliseconds of the first row on a GPU like an H100; NAN: no goal */
        most;
    const char *rows[ROWS_MAX]; /* settings of each row */
} Place;

static const Place places[] = {
    {"openness, box",
     "ao",
     indirect_scenes_box,
     .5,
     0,
     .5,
     {"rays: 8", "method: voxels", "rays: 16", "rays: 8, filter: atrous"}},
    {"openness, bunny", "ao", NULL, .75, 0, .5, {"rays: 8", "method: voxels", "rays: 16"}},
    {"light, box",
     "indirect",
     indirect_scenes_box,
     4,
     1,
     1,
     {"rays: 8", "method: voxels", "rays: 8, bounces: 2", "rays: 8, bounces: 4",
      "rays: 8, history: 16", "rays: 16, resolution: half, filter: atrous"}},
    {"light of a sky", "light", sky, 4, 1, NAN, {"rays: 8", "rays: 8, directional: false"}}};
enum { PLACES = sizeof places / sizeof *places };

typedef struct {
    MatcDocument *document;
    Scene *scene;
    Renderer *render;
    double least[TIMED]; /* minimum of seconds */
} Row;

static void close_row(Row *row)
{
    renderer_close(row->render);
    scene_free(row->scene);
    matc_document_free(row->document);
}

static bool open_row(GlContext *gl, const char *text, const char *view, Row *row)
{
    MatcOptions compile;
    matc_options_init(&compile);
    compile.pixels = true;
    row->document = scene_read("scene.yaml", text, strlen(text), &compile, &row->scene);
    if (!row->scene)
        return fputs(matc_diagnostics(row->document, MATC_TEXT), stderr), false;
    row->render = renderer_open(gl, &(RendererOptions){.compile = &compile, .view = view});
    return (row->render && renderer_set_scene(row->render, row->scene) &&
            renderer_frame(row->render)) ||
           fprintf(stderr, "matbench: %s\n", gl->error) < 0;
}

static void time_row(Row *row, bool first)
{
    RendererPassTime times[RENDERER_PASSES_MAX];
    for (int count = renderer_time_passes(row->render, times), i = 0; i < count; i++)
        for (int k = 0; k < TIMED; k++)
            if (!strcmp(times[i].name, timed_passes[k]))
                row->least[k] = first ? times[i].seconds : fmin(row->least[k], times[i].seconds);
}

static double each_frame(const Row *row)
{
    double sum = 0;
    for (int k = 0; k < EACH_FRAME; k++)
        sum += row->least[k];
    return sum;
}

/* Goals apply to the first row, and to GPUs. */
static void put_row(const IndirectPasses *p, const Place *place, const Row *row, const Row *march,
                    int number)
{
    printf("| %s | `%s` |", place->name, place->rows[number]);
    for (int k = 0; k < TIMED; k++) {
        if (k == EACH_FRAME)
            printf(" %s | %s | %s |", NUMBER(2, p->timed ? 1e3 * each_frame(row) : NAN),
                   NUMBER(2, number ? NAN : place->most),
                   NUMBER(3, p->timed ? each_frame(row) / each_frame(march) : NAN));
        printf(" %s |", NUMBER(2, row->least[k] > 0 ? 1e3 * row->least[k] : NAN));
    }
    putchar('\n');
}

/* Opens with the row's keys, which may give bounces; otherwise those of the place. */
static bool open_keys(GlContext *gl, const IndirectPasses *p, const Place *place, const char *keys,
                      Row *row)
{
    char text[TEXT], bunny[INDIRECT_SCENES_TEXT], bounces[BENCH_NUMBER] = "";
    if (!place->body)
        indirect_scenes_bunny(p->mesh, p->lift, bunny);
    if (!strstr(keys, "bounces"))
        snprintf(bounces, sizeof bounces, "bounces: %d, ", place->bounces);
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\nindirect: { radius: %g, %s%s }\n%s", p->edge,
             p->edge, place->radius, bounces, keys, place->body ? place->body : bunny);
    return open_row(gl, text, place->view, row);
}

static bool measure(GlContext *gl, const IndirectPasses *p, const Place *place, Row *march)
{
    Row rows[ROWS_MAX] = {{0}};
    bool fine = true;
    int count = 0;
    for (; fine && count < ROWS_MAX && place->rows[count]; count++)
        fine = open_keys(gl, p, place, place->rows[count], &rows[count]);
    const double enough = 2, start = bench_now();
    for (int i = 0;
         fine && p->timed && i < FRAMES_MAX && (i < FRAMES || bench_now() < start + enough); i++) {
        time_row(march, i == 0);
        for (int k = 0; k < count; k++)
            time_row(&rows[k], i == 0);
    }
    for (int k = 0; fine && k < count; k++)
        put_row(p, place, &rows[k], march, k);
    fflush(stdout);
    for (int k = 0; k < count; k++)
        close_row(&rows[k]);
    return fine;
}

bool bench_indirect_passes(GlContext *gl, const IndirectPasses *passes)
{
    IndirectPasses p = *passes;
    char *found = p.mesh ? NULL : meshes_path("bunny");
    Row march = {0};
    bool fine = open_keys(gl, &p, &places[0], thesis, &march);
    if (found) {
        p.mesh = found;
        p.lift = "0.9913";
    }
    printf("\npasses of indirect light, %d x %d, least milliseconds by the %s clock: those of a "
           "frame together, which are "
           "to take at most so on "
           "an H100, as a share of the march of openness in the box by `%s`; what is made once for "
           "a scene\n\n| | keys |",
           p.edge, p.edge, gl_clock_is(gl) ? "driver's" : "wall", thesis);
    for (int k = 0; k < TIMED; k++)
        printf("%s %s |", k == EACH_FRAME ? " together | at most | share |" : "", timed_passes[k]);
    printf("\n| --- | --- |");
    for (int k = 0; k < TIMED + 3; k++)
        printf(" --- |");
    putchar('\n');
    for (int i = 0; fine && i < PLACES; i++)
        if (places[i].body || p.mesh)
            fine = measure(gl, &p, &places[i], &march);
        else
            printf("| %s | there is no mesh: `sh tests/meshes/fetch.sh build` fetches it |\n",
                   places[i].name);
    close_row(&march);
    free(found);
    return fine;
}
