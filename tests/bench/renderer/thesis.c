/* matbench thesis: tables 5.2 to 5.6 of Hartmann 2010, its numbers left of a colon, ours right of
 * it. The machines differ too much to compare times, so only ratios within one side are comparable:
 * rows over the first row, and stages of one frame. The thesis' scenes exist only in GroIMP;
 * thesis_scenes.c generates substitutes. */
#include <stdio.h>
#include "thesis.h"
#include "tests/bench/matbench.h"
#include "render_scenes.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    SIDE = 512,    /* width and height of the thesis' pictures */
    WARM = 5,      /* warm-up frames, as in the thesis */
    FRAMES = 1000, /* measured frames, as in the thesis; fewer if they are slow */
    FEWEST = 3,
    QUICK_OBJECTS = 2401, /* maximum row of --quick and --untimed */
    QUICK_CHECKERS = 120,
    QUICK_LIGHTS = 128,
    MAX_ROWS = 12
};
#define NONE        NAN /* no number in the thesis, or nothing measured here */
#define MS(seconds) NUMBER(3, 1e3 * (seconds))

typedef struct {
    Bench bench;
    bool quick;
} Thesis;

typedef struct {
    double mean, least, most; /* seconds a frame */
} FrameTimes;

/* -- frames */

/* Moves every object from index `first` on back and forth. */
static bool move_objects(BenchScene *scene, int first, int frame)
{
    Scene *of = scene->scene;
    for (int i = first; i < of->object_count; i++)
        of->objects[i].world_from_local.m[12] += frame % 2 ? -.01 : .01;
    return renderer_changed_objects(scene->render, first, of->object_count - first);
}

static double draw_frame(const Thesis *t, BenchScene *scene, int first_moving, int frame)
{
    const double start = bench_now();
    if (first_moving >= 0)
        move_objects(scene, first_moving, frame);
    renderer_frame(scene->render);
    t->bench.gl->Finish();
    return bench_now() - start;
}

/* Opens a scene, times its frames and leaves it open. first_moving: index of the first moving
 * object, or -1. */
static bool time_scene(const Thesis *t, const Text *text, int first_moving, BenchScene *scene,
                       FrameTimes *times)
{
    const RendererOptions options = {.edges = RENDERER_EDGES_none};
    double sum = 0;
    int count = 0;
    *times = (FrameTimes){NONE, NONE, NONE};
    if (!bench_scene_open(&t->bench, text, &options, scene))
        return false;
    if (!t->bench.timed)
        return true;
    for (int i = 0; i < WARM; i++)
        draw_frame(t, scene, first_moving, i);
    const double end = bench_now() + t->bench.seconds;
    *times = (FrameTimes){0, INFINITY, 0};
    for (; count < FRAMES && (count < FEWEST || bench_now() < end); count++) {
        const double seconds = draw_frame(t, scene, first_moving, count + 1);
        sum += seconds;
        times->least = fmin(times->least, seconds);
        times->most = fmax(times->most, seconds);
    }
    times->mean = sum / count;
    return gl_check(t->bench.gl, "drawing frames") ||
           fprintf(stderr, "matbench: %s\n", t->bench.gl->error) < 0;
}

/* -- table 5.2: scenes */

static const struct {
    const char *name;
    ThesisScene scene;
    int nodes;
    bool moving; /* all objects move in each frame */
    double a, b, older_a, older_b;
} nodes[] = {
    {"City", THESIS_city, 2573, false, 68.2, 38.1, 63.4, 11.6},
    {"FSPM", THESIS_plants, 479, false, 267, 21.5, 8.4, 6.2},
    {"Boids", THESIS_boids, 307, false, 7.81, 4.28, 2.79, 2.81},
    {"Boids-moving", THESIS_boids, 307, true, 7.92, 4.46, 2.64, 2.65},
    {"helicopter", THESIS_helicopter, 223, false, 18.8, 5.3, 2.4, 1.7},
};

static bool measure_nodes(const Thesis *t)
{
    bool fine = true;
    printf("\ntable 5.2, scenes: generated here, with as many objects as there are nodes there; "
           "milliseconds a frame\n"
           "%-13s %6s %8s %8s %8s %8s   %9s %9s %9s\n",
           "scene", "nodes", "A", "B", "old-A", "old-B", "here", "least", "most");
    for (size_t i = 0; fine && i < sizeof nodes / sizeof *nodes; i++) {
        Arena arena = {0};
        Text text = text_new(&arena);
        BenchScene scene = {0};
        FrameTimes times;
        bench_show(nodes[i].name);
        thesis_scene(&text, nodes[i].scene, nodes[i].nodes);
        const int rotor = nodes[i].scene == THESIS_helicopter ? nodes[i].nodes - 1 : -1;
        fine = time_scene(t, &text, nodes[i].moving ? 0 : rotor, &scene, &times);
        bench_show("");
        if (fine)
            printf("%-13s %6d %8s %8s %8s %8s : %9s %9s %9s\n", nodes[i].name,
                   scene.scene->object_count, NUMBER(2, nodes[i].a), NUMBER(2, nodes[i].b),
                   NUMBER(2, nodes[i].older_a), NUMBER(2, nodes[i].older_b), MS(times.mean),
                   MS(times.least), MS(times.most));
        fflush(stdout);
        bench_scene_close(&scene);
        arena_free(&arena);
    }
    return fine;
}

/* -- tables 5.3 to 5.5: series */

typedef struct {
    int count; /* 0 after the last row */
    double a, b, older_a;
} SeriesRow;

typedef struct {
    const char *name, *what;
    void (*write)(Text *out, int count);
    int quick;    /* maximum count of --quick */
    bool forward; /* a forward renderer draws the scene, too */
    SeriesRow rows[MAX_ROWS];
} Series;

static const Series series[] = {
    {"bush",
     "table 5.3, a bush of twigs and leaves; the numbers of objects between the first and the last "
     "are ours",
     scenes_objects,
     QUICK_OBJECTS,
     true,
     {{8, 8.76, 2.95, 1.45},
      {25, 14.3, 3.04, 2.06},
      {78, 15.5, 4.02, 4.02},
      {245, 22, 8.95, 9.18},
      {767, 33.7, 19.2, 26.9},
      {2401, 42.2, 51.6, 71.6},
      {7512, 110, 152, 207},
      {23474, 314, 446, 619}}},
    {"checkers",
     "table 5.4, checkers of different materials on 2,000 parallelograms; there B takes about 2 s "
     "at 1,000, the older view "
     "87 to 89 ms on A, and runs out of memory beyond 80 (B: 40)",
     scenes_materials,
     QUICK_CHECKERS,
     false,
     {{1, 55.8, 18.5, NONE},
      {10, 80.7, 47.1, NONE},
      {40, 81.4, 51.2, NONE},
      {80, 83.1, 51.1, NONE},
      {120, 85.5, 60.6, NONE},
      {1000, 115, 2000, NONE},
      {2000, 162, NONE, NONE}}},
    {"lights",
     "table 5.5, lamps without shadows over a black plane, a sphere below each; there a ray tracer "
     "takes 21.1 to 26 s",
     thesis_lights,
     QUICK_LIGHTS,
     false,
     {{1, 7.57, 2.56, NONE},
      {2, NONE, NONE, NONE},
      {4, NONE, NONE, NONE},
      {8, NONE, NONE, NONE},
      {16, NONE, NONE, NONE},
      {32, NONE, NONE, NONE},
      {64, NONE, NONE, NONE},
      {128, 161, NONE, NONE},
      {256, NONE, NONE, NONE},
      {512, NONE, NONE, NONE},
      {1024, 1210, 514, NONE}}},
};
enum { SERIES = sizeof series / sizeof *series };

/* Times the forward renderer, the counterpart of the thesis' older view. */
static bool time_forward(const Thesis *t, BenchScene *scene, double *mean)
{
    *mean = NONE;
    if (!t->bench.timed)
        return true;
    if (!bench_scene_open_forward(&t->bench, scene))
        return false;
    forward_draw(scene->forward);
    t->bench.gl->Finish();
    const double start = bench_now(), end = start + t->bench.seconds;
    int count = 0;
    for (; count < FRAMES && (count < FEWEST || bench_now() < end); count++) {
        forward_draw(scene->forward);
        t->bench.gl->Finish();
    }
    *mean = (bench_now() - start) / count;
    return true;
}

static void put_series_row(const SeriesRow *row, const SeriesRow *first, const double here[2],
                           const double begin[2])
{
    printf("%9d %8s %8s %8s : %9s %9s   %8s %8s %8s : %9s %9s\n", row->count, NUMBER(2, row->a),
           NUMBER(2, row->b), NUMBER(2, row->older_a), MS(here[0]), MS(here[1]),
           NUMBER(2, row->a / first->a), NUMBER(2, row->b / first->b),
           NUMBER(2, row->older_a / first->older_a), NUMBER(2, here[0] / begin[0]),
           NUMBER(2, here[1] / begin[1]));
    fflush(stdout);
}

static bool measure_row(const Thesis *t, const Series *of, const SeriesRow *row, double here[2])
{
    Arena arena = {0};
    Text text = text_new(&arena);
    BenchScene scene = {0};
    FrameTimes times;
    char what[64];
    snprintf(what, sizeof what, "%d %s", row->count, of->name);
    bench_show(what);
    of->write(&text, row->count);
    const bool fine = time_scene(t, &text, -1, &scene, &times) &&
                      (!of->forward || time_forward(t, &scene, &here[1]));
    here[0] = times.mean;
    bench_show("");
    bench_scene_close(&scene);
    arena_free(&arena);
    return fine;
}

static bool measure_series(const Thesis *t, const Series *of)
{
    double begin[2] = {NONE, NONE};
    bool fine = true;
    printf("\n%s; milliseconds a frame, and over the first row\n%9s %8s %8s %8s   %9s %9s   %8s "
           "%8s %8s   %9s %9s\n",
           of->what, of->name, "A", "B", "old-A", "here", "forward", "A/first", "B/first",
           "old/first", "/first", "/first");
    for (int i = 0; fine && i < MAX_ROWS && of->rows[i].count; i++) {
        double here[2] = {NONE, NONE};
        if (!t->quick || of->rows[i].count <= of->quick)
            fine = measure_row(t, of, &of->rows[i], here);
        memcpy(begin, i ? begin : here, sizeof begin);
        if (fine)
            put_series_row(&of->rows[i], &of->rows[0], here, begin);
    }
    return fine;
}

static bool measure_bush(const Thesis *t) { return measure_series(t, &series[0]); }
static bool measure_checkers(const Thesis *t) { return measure_series(t, &series[1]); }
static bool measure_lights(const Thesis *t) { return measure_series(t, &series[2]); }

/* -- table 5.6: stages of a frame */

typedef enum { DRAW, PEEL, LIGHT, SKY, TONE, TOOLS, SHOW, STAGES } Stage;
static const char *const stage_names[STAGES] = {"draw", "peel",  "light", "sky",
                                                "tone", "tools", "show"};

/* The stage of the thesis whose work a pass does. All passes without a row belong to `light`. */
static const struct {
    const char *pass;
    Stage stage;
} stages[] = {{"surface", DRAW}, {"plane", DRAW}, {"lists", PEEL}, {"blend", PEEL},
              {"peel", PEEL},    {"sky", SKY},    {"tone", TONE},  {"tools", TOOLS}};

static const struct {
    const char *name;
    int count; /* objects, or lamps */
    double a[STAGES], b[STAGES];
} frames[] = {
    {"bush", 7784, {106, NONE, 1.33, 3.78, 2.38, .38, .8}, {143, NONE, .68, 1.49, .74, .16, .3}},
    {"City", 2573, {19.3, 5.77, 2.15, .77, 2.25, 2.34, .78}, {5.24, 2.61, 2.22, .24, .55, .25, .2}},
    {"Boids", 307, {4.36, NONE, .84, 1.29, 2.25, .39, .79}, {2.81, NONE, .32, .42, .75, .11, .29}},
    {"helicopter",
     223,
     {3.31, NONE, 4.16, 8.92, 2.43, .32, .8},
     {2.06, NONE, 3.35, 3.33, .7, .12, .28}},
    {"spheres",
     4000,
     {88.5, NONE, 1.37, 1.32, 2.29, .38, .78},
     {52.7, NONE, .64, .43, .76, .16, .29}},
    {"FSPM", 479, {261, NONE, 2.14, .39, 2.1, .4, .7}, {16.8, NONE, 2.44, .14, .55, .13, .2}},
    {"lights", 128, {5.74, NONE, 1.82, .5, 2.49, .34, .83}, {1.4, NONE, .61, .13, .54, .13, .19}},
};
enum { BUSH, CITY, BOIDS, HELICOPTER, SPHERES, PLANTS, LIGHTS };

/* Every picture of the thesis has a sky, a tone mapping and tools. */
static void write_frame(Text *out, int row)
{
    static const ThesisScene scenes[] = {[CITY] = THESIS_city,
                                         [BOIDS] = THESIS_boids,
                                         [HELICOPTER] = THESIS_helicopter,
                                         [PLANTS] = THESIS_plants};
    if (row == BUSH) {
        scenes_objects(out, frames[row].count);
        text_put(out, "toneMapping: { toneMapping: ReinhardDevlin }\n");
    } else if (row == SPHERES)
        thesis_spheres(out);
    else if (row == LIGHTS)
        thesis_lights(out, frames[row].count);
    else
        thesis_scene(out, scenes[row], frames[row].count);
    if (row == BUSH || row == SPHERES || row == LIGHTS)
        text_put(out, "sky: { material: SunSkyLight, sun: [-0.6, -0.5, 0.6], turbidity: 3 }\n");
    text_put(out, "tools: { grid: true, axes: true }\n");
}

static Stage stage_of(const char *pass)
{
    for (size_t i = 0; i < sizeof stages / sizeof *stages; i++)
        if (!strcmp(stages[i].pass, pass))
            return stages[i].stage;
    return LIGHT;
}

static bool measure_frame(const Thesis *t, int row, double seconds[STAGES])
{
    Arena arena = {0};
    Text text = text_new(&arena);
    BenchScene scene = {0};
    RendererPassTime passes[RENDERER_PASSES_MAX];
    bench_show(frames[row].name);
    write_frame(&text, row);
    const bool fine = bench_scene_open(&t->bench, &text,
                                       &(RendererOptions){.edges = RENDERER_EDGES_none}, &scene);
    const int count = fine && t->bench.timed ? bench_scene_passes(&t->bench, &scene, passes) : 0;
    for (int i = 0; i < STAGES; i++)
        seconds[i] = NONE;
    for (int i = 0; i < count; i++)
        if (passes[i].seconds > 0) {
            double *to = &seconds[stage_of(passes[i].name)];
            *to = passes[i].seconds + (isnan(*to) ? 0 : *to);
        }
    bench_show("");
    bench_scene_close(&scene);
    arena_free(&arena);
    return fine;
}

/* Prints the milliseconds of each stage, and the share of `draw` in their sum. */
static void put_stages(const char *name, const char *who, const double milliseconds[STAGES])
{
    double sum = 0;
    printf("%-11s %-5s", name, who);
    for (int i = 0; i < STAGES; i++) {
        printf(" %8s", NUMBER(3, milliseconds[i]));
        sum += isnan(milliseconds[i]) ? 0 : milliseconds[i];
    }
    printf(" %8s\n", NUMBER(1, sum > 0 ? 100 * milliseconds[DRAW] / sum : NAN));
}

static bool measure_stages(const Thesis *t)
{
    bool fine = true;
    printf("\ntable 5.6, stages of a frame: milliseconds, and drawing's share of them in "
           "percent\n%-11s %-5s",
           "scene", "");
    for (int i = 0; i < STAGES; i++)
        printf(" %8s", stage_names[i]);
    printf(" %8s\n", "draw/all");
    for (int row = 0; fine && row < (int)(sizeof frames / sizeof *frames); row++) {
        double here[STAGES];
        fine = measure_frame(t, row, here);
        for (int i = 0; i < STAGES; i++)
            here[i] *= 1e3;
        if (fine) {
            put_stages(frames[row].name, "A", frames[row].a);
            put_stages(frames[row].name, "B", frames[row].b);
            put_stages(frames[row].name, "here", here);
        }
        fflush(stdout);
    }
    return fine;
}

/* -- the command */

static const struct {
    const char *name;
    bool (*measure)(const Thesis *t);
} tables[] = {{"nodes", measure_nodes},
              {"bush", measure_bush},
              {"checkers", measure_checkers},
              {"lights", measure_lights},
              {"stages", measure_stages}};
enum { TABLES = sizeof tables / sizeof *tables };

const char *bench_thesis_table(const void *user, int i)
{
    (void)user;
    return i < TABLES ? tables[i].name : NULL;
}

const Option bench_thesis_options[] = {
    BENCH_UNTIMED,
    BENCH_FLAG("--quick", quick, "fewer objects and lights"),
    BENCH_GL,
    BENCH_HELP,
};

int bench_thesis(const BenchOptions *options)
{
    const unsigned chosen = options->tables ? options->tables : (1u << TABLES) - 1;
    char error[4096];
    Thesis t = {.bench = {.timed = options->timed, .width = SIDE, .height = SIDE, .seconds = 1},
                .quick = options->quick || !options->timed};
    matc_options_init(&t.bench.compile);
    t.bench.compile.pixels = true;
    t.bench.gl = gl_open(options->timed ? options->gl : GL_KIND_osmesa, true, error, sizeof error);
    bool fine = t.bench.gl || fprintf(stderr, "matbench: %s\n", error) < 0;
    if (fine && options->timed)
        printf("%s, ", t.bench.gl->renderer);
    if (fine)
        printf("%d x %d pixels; there, A is a GeForce 8600M GT, B a Radeon HD 3870 X2, of 2007\n",
               SIDE, SIDE);
    if (!options->timed) /* nothing is timed, so a small picture will do */
        t.bench.width = t.bench.height = 64;
    for (int i = 0; fine && i < TABLES; i++)
        fine = !(chosen >> i & 1) || tables[i].measure(&t);
    gl_close(t.bench.gl);
    return !fine;
}
