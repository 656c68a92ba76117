/* matbench displacement, table of the thesis: frames per second by the number of triangles, for
 * its third and second version at its step counts, its figures next to ours. The camera moves in
 * each frame, so that all triangles are subdivided, displaced and drawn each time; triangles
 * stored in a buffer are only drawn. */
#include "displacement.h"
#include "tests/bench/matbench.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/autotune/plot.h"
#include "runtime/renderer/renderer.h"
#include "runtime/scene_reader/scene_read.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Figures 22 to 24 of the thesis, of 2009: brute force, then 11, 10, 9, 8 steps of the third
 * version, 10, 9, 8 of the second; 0: none. */
enum {
    THIRD = 4,
    SECOND = 3,
    VERSIONS = THIRD + SECOND,
    TEXT = 2048,
    POINTS = 40,
    FRAMES = 3,
    SIDE = 600
};
static const struct {
    int triangles, brute, third[THIRD], second[SECOND];
} rows[] = {
    {349525, 24, {21, 0, 0, 0}, {26, 0, 0}},
    {337609, 0, {0, 0, 0, 0}, {38, 0, 0}},
    {322712, 0, {0, 29, 0, 0}, {39, 0, 0}},
    {300000, 28, {29, 35, 0, 0}, {41, 0, 0}},
    {288605, 0, {0, 37, 0, 0}, {43, 0, 0}},
    {250000, 33, {0, 41, 0, 0}, {48, 0, 0}},
    {228098, 0, {0, 0, 0, 0}, {52, 0, 0}},
    {200000, 40, {39, 48, 0, 0}, {60, 51, 0}},
    {190766, 0, {0, 50, 0, 0}, {62, 64, 0}},
    {177473, 0, {0, 53, 0, 0}, {0, 69, 0}},
    {169493, 0, {44, 0, 0, 0}, {68, 0, 0}},
    {157340, 0, {0, 58, 0, 0}, {74, 76, 0}},
    {150000, 54, {0, 0, 0, 0}, {0, 0, 0}},
    {141938, 0, {49, 0, 0, 0}, {79, 82, 0}},
    {134624, 0, {0, 64, 80, 0}, {0, 0, 0}},
    {125468, 0, {0, 68, 90, 0}, {86, 90, 0}},
    {100000, 80, {0, 78, 104, 0}, {104, 110, 0}},
    {90000, 88, {0, 83, 113, 0}, {113, 117, 0}},
    {80000, 98, {67, 89, 122, 0}, {0, 0, 0}},
    {74384, 0, {0, 93, 128, 0}, {126, 134, 141}},
    {70000, 112, {0, 0, 0, 0}, {0, 0, 156}},
    {65411, 0, {0, 98, 136, 0}, {0, 0, 166}},
    {60000, 130, {0, 0, 0, 0}, {0, 160, 178}},
    {57956, 0, {79, 106, 148, 0}, {0, 0, 0}},
    {51200, 0, {0, 0, 0, 0}, {159, 180, 0}},
    {50000, 154, {0, 0, 161, 0}, {0, 0, 200}},
    {42542, 0, {0, 0, 0, 0}, {180, 202, 226}},
    {41783, 0, {96, 124, 176, 0}, {0, 0, 0}},
    {40000, 190, {0, 0, 0, 0}, {0, 0, 0}},
    {39248, 0, {0, 0, 0, 262}, {0, 0, 0}},
    {35000, 0, {109, 141, 196, 290}, {204, 227, 259}},
    {30000, 242, {0, 0, 0, 333}, {0, 0, 0}},
    {29000, 252, {125, 159, 217, 0}, {0, 0, 0}},
    {25000, 290, {0, 0, 0, 0}, {0, 270, 0}},
    {24000, 294, {148, 184, 246, 374}, {0, 0, 0}},
    {23000, 308, {0, 0, 0, 0}, {0, 0, 0}},
    {22412, 0, {156, 194, 260, 390}, {242, 0, 332}},
    {22000, 328, {0, 0, 0, 0}, {0, 288, 0}},
    {21000, 350, {164, 205, 273, 407}, {0, 0, 0}},
    {20000, 361, {0, 0, 0, 418}, {0, 0, 348}},
    {19000, 367, {177, 220, 291, 429}, {0, 0, 0}},
    {18000, 383, {0, 0, 0, 0}, {268, 312, 368}},
    {17000, 424, {0, 0, 0, 0}, {0, 0, 378}},
    {16832, 0, {196, 242, 316, 455}, {0, 0, 0}},
    {16000, 481, {203, 250, 326, 468}, {0, 0, 388}},
    {15000, 505, {0, 0, 0, 0}, {292, 334, 396}},
    {14000, 515, {226, 275, 353, 503}, {305, 350, 412}},
    {13000, 537, {239, 291, 374, 522}, {322, 366, 426}},
    {11000, 800, {268, 323, 409, 560}, {350, 396, 456}},
    {10000, 880, {285, 341, 433, 580}, {374, 422, 486}},
    {9000, 970, {308, 370, 460, 612}, {396, 446, 510}},
    {8000, 1120, {342, 410, 504, 670}, {428, 480, 548}},
    {7000, 1300, {378, 450, 554, 719}, {472, 528, 600}},
    {6000, 1660, {422, 501, 613, 790}, {525, 584, 666}},
    {5000, 2070, {482, 566, 685, 871}, {592, 664, 750}},
    {4000, 2530, {559, 652, 781, 972}, {674, 750, 844}},
    {3000, 3260, {662, 764, 900, 1100}, {771, 850, 946}},
    {2000, 4700, {854, 970, 1125, 1340}, {946, 1040, 1160}},
    {1000, 7240, {1210, 1348, 1510, 1730}, {1266, 1380, 1520}},
    {512, 0, {1560, 1705, 1880, 2100}, {1480, 1610, 1770}},
    {128, 0, {2010, 2150, 2310, 2510}, {1732, 1860, 2010}},
    {32, 12000, {2190, 2340, 2500, 2680}, {2060, 2230, 2380}},
};
#define FRAMES_AT(curve, triangles)                                                                \
    NUMBER(decimals(frames_at(curve, triangles)), frames_at(curve, triangles))
enum { ROWS = sizeof rows / sizeof *rows };

static const struct {
    const char *name, *skirts;
    int steps;
} versions[VERSIONS] = {{"V3 11", "early", 11}, {"V3 10", "early", 10},   {"V3 9", "early", 9},
                        {"V3 8", "early", 8},   {"V2 10", "borders", 10}, {"V2 9", "borders", 9},
                        {"V2 8", "borders", 8}};

typedef struct {
    double triangles, seconds;
} Point;
typedef struct {
    Point at[POINTS];
    int count;
} Curve;

typedef struct {
    GlContext *gl;
    MatcOptions compile;
    MatcDocument *document;
    Scene *scene;
    Renderer *render;
} Drawn;

static bool open_drawn(GlContext *gl, const char *how, Drawn *d)
{
    char text[TEXT];
    *d = (Drawn){.gl = gl};
    matc_options_init(&d->compile);
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [0, 0, "
             "100], up: [0, 1, 0], angle: "
             "60 }\n"
             "displacement: { %s }\nlights: [{ light: Directional, direction: [1, 0.6, -1], "
             "shadows: none }]\n"
             "materials: { m: { material: Phong, displacement: { map: VolumeTurbulence, size: 1, "
             "octaves: 4, "
             "noiseRatio: 0.45 }, displacementScale: 0.2 } }\n"
             "objects:\n- { object: Parallelogram, u: [10, 0, 0], v: [0, 10, 0], material: m, "
             "transform: { translation: "
             "[-5, -5, 0] } }\n",
             SIDE, SIDE, how);
    d->document = scene_read("scene.yaml", text, strlen(text), &d->compile, &d->scene);
    d->render = d->scene ? renderer_open(gl, &(RendererOptions){.compile = &d->compile}) : NULL;
    if (d->render && renderer_set_scene(d->render, d->scene))
        return true;
    fprintf(stderr, "matbench: %s\n",
            d->scene ? gl->error : matc_diagnostics(d->document, MATC_TEXT));
    return false;
}

static void close_drawn(Drawn *d)
{
    renderer_close(d->render);
    scene_free(d->scene);
    matc_document_free(d->document);
}

/* Minimum time of a frame after a small camera move. */
static bool measure(Drawn *d, double height, Point *made)
{
    *made = (Point){0, INFINITY};
    for (int i = 0; i < FRAMES; i++) {
        d->scene->camera.position[2] = height * (1 + 1e-9 * i);
        if (scene_camera_aim(&d->scene->camera) != SCENE_AIM_fine)
            return false;
        d->gl->Finish();
        const double begin = bench_now();
        if (!renderer_changed(d->render, RENDERER_CAMERA) || !renderer_frame(d->render))
            return false;
        d->gl->Finish();
        made->seconds = fmin(made->seconds, bench_now() - begin);
    }
    made->triangles = d->render->gpu_scene.meshes[0].index_count / 3;
    return true;
}

/* Moves from far away, with few triangles, closer until there are `most`, or no more. */
static bool measure_version(GlContext *gl, int version, int most, Curve *curve)
{
    const double farthest = 8e4, nearer = .66;
    char how[120];
    Drawn d;
    snprintf(how, sizeof how, "method: feedback, near: 4, detail: 250, steps: %d, skirts: %s",
             versions[version].steps, versions[version].skirts);
    bool fine = open_drawn(gl, how, &d);
    double height = farthest;
    for (int i = 0;
         fine && i < POINTS && !(curve->count && curve->at[curve->count - 1].triangles > most);
         i++, height *= nearer) {
        bench_show(versions[version].name);
        Point *at = &curve->at[curve->count];
        fine = measure(&d, height, at);
        curve->count += !curve->count || at->triangles > at[-1].triangles;
    }
    bench_show("");
    close_drawn(&d);
    return fine;
}

/* Triangles of uniform size stored in a buffer: of a displaced mesh, or of grids. */
static bool measure_even(GlContext *gl, const char *method, double height, int most, Curve *curve)
{
    bool fine = true;
    for (int triangles = 32; fine && triangles <= 2 * most && curve->count < POINTS;
         triangles *= 4) {
        char how[120];
        Drawn d;
        snprintf(how, sizeof how, "method: %s, triangles: %d", method, triangles);
        fine = open_drawn(gl, how, &d) && measure(&d, height, &curve->at[curve->count++]);
        close_drawn(&d);
    }
    return fine;
}

/* Frames per second for a number of triangles, interpolated; NAN outside of the measured range. */
static double frames_at(const Curve *curve, double triangles)
{
    for (int i = 1; i < curve->count; i++) {
        const Point *a = &curve->at[i - 1], *b = &curve->at[i];
        if (triangles >= a->triangles && triangles <= b->triangles) {
            const double t = log(triangles / a->triangles) / log(b->triangles / a->triangles);
            return 1 / exp(log(a->seconds) + t * log(b->seconds / a->seconds));
        }
    }
    return NAN;
}

/* One decimal below ten. */
static int decimals(double frames) { return frames < 9.95 ? 1 : 0; }

static double given(int frames) { return frames ? frames : (double)NAN; }

/* -- charts of the thesis' figures 23 and 24: frames a second by triangles, there and here */

enum { PANELS = 4, LINES = THIRD + 1 }; /* versions there and here; numbers of steps, brute force */
typedef struct {
    PlotPoint at[ROWS * LINES];
    int count;
} Line;

/* The thesis' frames per second in a column: those of THIRD, then of SECOND; -1: brute force. */
static double thesis_rate(int row, int column)
{
    const int rate = column < 0       ? rows[row].brute
                     : column < THIRD ? rows[row].third[column]
                                      : rows[row].second[column - THIRD];
    return given(rate);
}

static void add_line(Line *to, int column, int line, const Curve *here)
{
    int last = -1;
    for (int row = 0; row < ROWS; row++) {
        const double triangles = rows[row].triangles;
        const double rate = here ? frames_at(here, triangles) : thesis_rate(row, column);
        if (isnan(rate))
            continue;
        last = to->count++;
        to->at[last] = (PlotPoint){.x = triangles,
                                   .y = rate,
                                   .line = line,
                                   .label = column < 0 ? "brute" : versions[column].name};
    }
    if (last >= 0)
        to->at[last].named = true;
}

static bool write_text(const char *plot, const char *svg)
{
    char path[4096];
    snprintf(path, sizeof path, "%s.svg", plot);
    FILE *file = fopen(path, "w");
    bool done = file && fputs(svg, file) >= 0;
    done = file && !fclose(file) && done;
    return done || fprintf(stderr, "matbench: %s cannot be written\n", path) < 0;
}

static bool write_charts(const char *plot, const char *driver, const Curve curves[VERSIONS],
                         const Curve *brute)
{
    static Line lines[PANELS];
    static const char *const titles[PANELS] = {
        "third version, GeForce 8800 GTX", "third version, here",
        "second version, GeForce 8800 GTX", "second version, here"};
    PlotPanel panels[PANELS];
    memset(lines, 0, sizeof lines);
    for (int i = 0; i < PANELS; i++) {
        const int first = i < 2 ? 0 : THIRD, count = i < 2 ? THIRD : SECOND;
        add_line(&lines[i], -1, LINES, i % 2 ? brute : NULL);
        for (int column = first; column < first + count; column++)
            add_line(&lines[i], column, column - first + 1, i % 2 ? &curves[column] : NULL);
        panels[i] =
            (PlotPanel){titles[i], "triangles", "frames a second", lines[i].at, lines[i].count};
    }
    char *svg = plot_svg(&(Plot){"Displacement by transform feedback", driver, panels, PANELS, 2});
    const bool done = write_text(plot, svg);
    free(svg);
    return done;
}

bool displacement_table(GlContext *gl, bool timed, int most, const char *plot)
{
    Curve curves[VERSIONS] = {{.count = 0}}, even[2] = {{.count = 0}};
    static const char *const methods[] = {"mesh", "grid"};
    bool fine = true;
    for (int i = 0; i < VERSIONS && fine && timed; i++)
        fine = measure_version(gl, i, most, &curves[i]);
    for (int i = 0; i < 2 && fine && timed; i++)
        fine = measure_even(gl, methods[i], 12, most, &even[i]);
    printf("\nthe thesis' table: frames a second, there : here, of a square of two triangles, 600 "
           "x 600 pixels\n%-9s "
           "%11s %7s",
           "triangles", "brute", "grid");
    for (int i = 0; i < VERSIONS; i++)
        printf(" %11s", versions[i].name);
    puts("");
    for (int row = 0; row < ROWS && fine; row++) {
        const double triangles = rows[row].triangles;
        printf("%-9.0f %5s:%5s %7s", triangles, NUMBER(0, given(rows[row].brute)),
               FRAMES_AT(&even[0], triangles), FRAMES_AT(&even[1], triangles));
        for (int i = 0; i < VERSIONS; i++)
            printf(" %5s:%5s",
                   NUMBER(0, given(i < THIRD ? rows[row].third[i] : rows[row].second[i - THIRD])),
                   FRAMES_AT(&curves[i], triangles));
        puts("");
    }
    return fine && (!plot || !timed || write_charts(plot, gl->renderer, curves, &even[0]));
}
