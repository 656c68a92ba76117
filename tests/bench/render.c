/* matbench render: what a frame takes, after the tables of the thesis: by materials, lights and objects, beside a forward renderer, both without tone
 * mapping, in turns, and of one picture; by pass, by transparent fragment; and the bytes of a pixel. */
#include <stdio.h>
#include "matbench.h"
#include "render_scenes.h"
#include "render_time.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* -- series beside the forward renderer */

enum {
    FORWARD_PROGRAMS = 120, /* more are not compiled: a driver takes minutes for them */
    UNTIMED_PROGRAMS = 10,
    MOST_ROWS = 12
};

typedef struct {
    const char *name, *what;
    int counts[MOST_ROWS]; /* 0 behind the last */
    void (*write)(Text *out, int count);
    bool programs; /* so many, for the forward renderer */
    bool bounded;  /* also with far lights taken together */
} Series;

static const Series series[] = {
    {"materials",
     "2,000 parallelograms, checkers in turns",
     {1, 10, 40, 80, 120, 1000, 2000},
     scenes_materials,
     true,
     false},
    {"lights",
     "a floor with 1,024 boxes, lamps without shadows",
     {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024},
     scenes_lights,
     false,
     true},
    {"objects", "a bush in the sun", {8, 25, 78, 245, 767, 2401, 7512, 23474}, scenes_objects, false, false},
};
enum { SERIES = sizeof series / sizeof *series };

static void show_row(const Series *of, int count)
{
    char what[64];
    snprintf(what, sizeof what, "%d %s", count, of->name);
    bench_show(what);
}

static void put_csv(const Bench *bench, const char *table, const char *row, const char *measure, double value)
{
    if (bench->csv && !isnan(value))
        fprintf(bench->csv, "%s,%s,%s,%.9g\n", table, row, measure, value);
}

typedef struct {
    int count;
    BenchTimes times[BENCH_WAYS];
    double apart; /* share of pixels; NAN: not compared */
} Row;

/* "": the series has no such column. */
static const char *way_name(const Series *of, int way)
{
    const char *const names[BENCH_WAYS] = {of->bounded ? "summed" : "deferred", of->bounded ? "bounded" : "",
                                           "forward"};
    return names[way];
}

/* Of pixels, by how much: the default layout is off by 1/255 of some, what is left out of lights by half of that. */
static const double bound = 2.0 / 255, pixels_beyond = .002;

static const char *same_picture(double apart) { return isnan(apart) ? "-" : apart > pixels_beyond ? "no" : "yes"; }

static void put_head(const Series *of)
{
    printf("\n%s: %s; milliseconds a frame\n%9s", of->name, of->what, of->name);
    for (int way = 0; way < BENCH_WAYS; way++)
        if (*way_name(of, way))
            printf(" %10s %10s %8s", way_name(of, way), "least", "/ first");
    printf(" %8s %s\n", of->bounded ? "/ sum." : "/ def.", "same picture");
}

static void put_row(const Bench *bench, const Series *of, const Row *row, const double first[BENCH_WAYS])
{
    const BenchTimes *times = row->times;
    char name[16], least[32];
    snprintf(name, sizeof name, "%d", row->count);
    printf("%9s", name);
    for (int way = 0; way < BENCH_WAYS; way++) {
        if (!*way_name(of, way))
            continue;
        snprintf(least, sizeof least, "%s least", way_name(of, way));
        put_csv(bench, of->name, name, way_name(of, way), times[way].median);
        put_csv(bench, of->name, name, least, times[way].least);
        printf(" %10s %10s %8s", NUMBER(3, 1e3 * times[way].median), NUMBER(3, 1e3 * times[way].least),
               NUMBER(2, times[way].median / first[way]));
    }
    printf(" %8s %s\n", NUMBER(2, times[BENCH_WAY_forward].median / times[BENCH_WAY_deferred].median),
           same_picture(row->apart));
    fflush(stdout); /* the whole takes minutes */
}

static bool compare(const Bench *bench, BenchScene *scene, Row *row)
{
    if (!bench_scene_open_forward(bench, scene))
        return false;
    row->apart = bench_scene_apart(bench, scene, bound);
    if (isnan(row->apart))
        fputs("matbench: a picture is black, or cannot be read\n", stderr);
    return !isnan(row->apart);
}

static bool measure_row(const Bench *bench, const Series *of, Row *row)
{
    const int most = bench->timed ? FORWARD_PROGRAMS : UNTIMED_PROGRAMS;
    const RenderOptions options = {.view = "light", .lights = "all"};
    Arena arena = {0};
    Text text = text_new(&arena);
    BenchScene scene;
    show_row(of, row->count);
    of->write(&text, row->count);
    bool fine = bench_scene_open(bench, &text, &options, &scene) &&
                (!of->bounded || bench_scene_open_bounded(bench, &options, &scene)) &&
                ((of->programs && row->count > most) || compare(bench, &scene, row));
    fine = fine && (!bench->timed || bench_scene_time(bench, &scene, row->times));
    bench_show("");
    bench_scene_close(&scene);
    arena_free(&arena);
    return fine;
}

static bool measure_series(const Bench *bench, const Series *of)
{
    double first[BENCH_WAYS] = {0};
    bool fine = true;
    put_head(of);
    for (int i = 0; fine && i < MOST_ROWS && of->counts[i]; i++) {
        Row row = {of->counts[i], {{NAN, NAN}, {NAN, NAN}, {NAN, NAN}}, NAN};
        fine = measure_row(bench, of, &row);
        for (int way = 0; way < BENCH_WAYS; way++)
            first[way] = i ? first[way] : row.times[way == BENCH_WAY_bounded ? BENCH_WAY_deferred : way].median;
        if (fine)
            put_row(bench, of, &row, first);
        fine = fine && !(row.apart > pixels_beyond);
    }
    return fine;
}

/* -- passes, and bytes of a pixel */

typedef struct {
    const char *name;
    int panes;
    RenderOptions options;
} Whole;

static const Whole wholes[] = {
    {"opaque", 0, {.edges = RENDER_EDGES_none}},
    {"with edges", 0, {.edges = RENDER_EDGES_coverage}},
    {"ten panes, lists", 10, {.edges = RENDER_EDGES_coverage, .transparency = "lists"}},
    {"ten panes, peeled", 10, {.edges = RENDER_EDGES_coverage, .transparency = "peeling"}},
};
enum { WHOLES = sizeof wholes / sizeof *wholes };

typedef struct {
    RenderPassTime passes[RENDER_PASSES_MOST];
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
        times->count = render_time_passes(scene.render, times->passes); /* which there are */
    times->bytes = fine ? render_pixel_bytes(scene.render) : 0;
    times->fragment_bytes = fine ? render_fragment_bytes(scene.render) : 0;
    bench_show("");
    bench_scene_close(&scene);
    arena_free(&arena);
    return fine;
}

/* "" where it does not run. */
static const char *pass_time(const Bench *bench, const RenderPassTime *pass, char text[BENCH_NUMBER])
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
        put_csv(bench, wholes[k].name, times->passes[pass].name, "seconds",
                bench->timed && times[k].passes[pass].seconds > 0 ? times[k].passes[pass].seconds : NAN);
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

static bool measure_passes(const Bench *bench)
{
    static WholeTimes times[WHOLES];
    int bytes[WHOLES], fragment_bytes[WHOLES];
    for (int k = 0; k < WHOLES; k++) {
        if (!measure_whole(bench, &wholes[k], &times[k]))
            return false;
        bytes[k] = times[k].bytes;
        fragment_bytes[k] = times[k].fragment_bytes;
    }
    printf("\npasses: solids, a plane, a sky, a spot and the sun with shadows, ReinhardDevlin; milliseconds, and "
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
static double seconds_of(const RenderPassTime *passes, int count, const char *const names[2])
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 2; k++)
            sum += names[k] && !strcmp(passes[i].name, names[k]) ? passes[i].seconds : 0;
    return sum;
}

/* Of square pictures, since all pixels are covered; no ratio depends on their size. */
static bool measure_layers(const Bench *bench, int layers, const char *way)
{
    enum { SIDE = 256, SIDE_OF_GPU = 1024 };
    static const char *const parts[][2] = {{"lists", NULL}, {"blend", NULL}, {"peel", NULL}, {"lists", "blend"}};
    Bench square = *bench;
    RenderPassTime passes[RENDER_PASSES_MOST];
    Arena arena = {0};
    Text text = text_new(&arena);
    BenchScene scene = {0};
    char row[64];
    double nanoseconds[] = {NAN, NAN, NAN, NAN};
    square.width = square.height = bench->gl->hardware ? SIDE_OF_GPU : SIDE;
    snprintf(row, sizeof row, "%d layers, %s", layers, way);
    bench_show(row);
    scenes_panes(&text, layers);
    const bool fine = bench_scene_open(&square, &text, &(RenderOptions){.view = "light", .transparency = way}, &scene);
    if (fine && bench->timed) {
        const int count = bench_scene_passes(&square, &scene, passes);
        for (int i = 0; i < 4; i++) {
            nanoseconds[i] = 1e9 * seconds_of(passes, count, parts[i]) / layers / square.width / square.height;
            nanoseconds[i] = nanoseconds[i] > 0 ? nanoseconds[i] : NAN;
        }
    }
    bench_show("");
    if (fine)
        printf("%-22s %10s %10s %10s %14s\n", row, NUMBER(3, nanoseconds[0]), NUMBER(3, nanoseconds[1]),
               NUMBER(3, nanoseconds[2]), NUMBER(3, isnan(nanoseconds[2]) ? nanoseconds[3] : nanoseconds[2]));
    for (int i = 0; i < 3; i++)
        put_csv(bench, "fragments", row, parts[i][0], 1e-9 * nanoseconds[i]);
    bench_scene_close(&scene);
    arena_free(&arena);
    return fine;
}

static bool measure_fragments(const Bench *bench)
{
    static const int layers[] = {1, 2, 4, 10, 40};
    static const char *const ways[] = {"lists", "peeling"};
    bool fine = true;
    printf(
        "\nfragments: panes over all pixels, one lamp; nanoseconds a transparent fragment\n%-22s %10s %10s %10s %14s\n",
        "", "lists", "blend", "peel", "a fragment");
    for (size_t i = 0; fine && i < sizeof layers / sizeof *layers; i++)
        for (int k = 0; fine && k < 2; k++)
            fine = measure_layers(bench, layers[i], ways[k]);
    return fine;
}

/* -- the command */

enum { TABLE_passes = SERIES, TABLE_fragments, TABLES };

static const char *table_name(int table)
{
    return table < SERIES ? series[table].name : table == TABLE_passes ? "passes" : "fragments";
}

static unsigned table_of(const char *name)
{
    int table = 0;
    while (table < TABLES && strcmp(name, table_name(table)) != 0)
        table++;
    return table < TABLES ? 1u << table : 0;
}

static bool measure(const Bench *bench, unsigned tables)
{
    bool fine = true;
    for (int i = 0; i < SERIES; i++)
        if (tables >> i & 1)
            fine &= measure_series(bench, &series[i]);
    if (tables >> TABLE_passes & 1)
        fine &= measure_passes(bench);
    if (tables >> TABLE_fragments & 1)
        fine &= measure_fragments(bench);
    return fine;
}

/* A picture that a CPU fills in the time that a GPU takes for one of 1080 rows; without times, as small as will do. */
static void choose_size(Bench *bench)
{
    static const int sizes[][2] = {{160, 90}, {480, 270}, {1920, 1080}};
    const int *size = sizes[!bench->timed ? 0 : bench->gl->hardware ? 2 : 1];
    bench->width = bench->width ? bench->width : size[0];
    bench->height = bench->height ? bench->height : size[1];
}

typedef struct {
    unsigned tables;
    GlKind gl;
    const char *csv;
    int size[2];
    bool timed;
} Arguments;

static bool read_arguments(int argc, char **argv, Arguments *made)
{
    *made = (Arguments){.gl = GL_KIND_osmesa, .timed = !bench_untimed(argc, argv)};
    for (int i = made->timed ? 1 : 2; i < argc; i++) {
        const unsigned table = table_of(argv[i]);
        made->tables |= table;
        if (!strcmp(argv[i], "--csv") && i + 1 < argc)
            made->csv = argv[++i];
        else if (!table && (strncmp(argv[i], "--gl=", 5) != 0 || !gl_kind_find(argv[i] + 5, &made->gl)) &&
                 sscanf(argv[i], "--size=%dx%d", &made->size[0], &made->size[1]) != 2)
            return false;
    }
    if (!made->timed)
        made->gl = GL_KIND_osmesa; /* what is left is the same everywhere */
    made->tables = made->tables ? made->tables : (1u << TABLES) - 1;
    return made->size[0] >= 0 && made->size[1] >= 0;
}

static int run(const Arguments *arguments)
{
    char error[4096];
    Bench bench = {.timed = arguments->timed, .width = arguments->size[0], .height = arguments->size[1], .seconds = 1};
    matc_options_init(&bench.compile);
    bench.compile.pixels = true;
    bench.gl = gl_open(arguments->gl, true, error, sizeof error);
    bench.csv = bench.gl && arguments->csv ? fopen(arguments->csv, "w") : NULL;
    if (!bench.gl || (arguments->csv && !bench.csv)) {
        fprintf(stderr, "matbench: %s\n", bench.gl ? "the CSV file cannot be written" : error);
        gl_close(bench.gl);
        return 1;
    }
    choose_size(&bench);
    if (bench.timed)
        printf("%s, %d x %d pixels\n", bench.gl->renderer, bench.width, bench.height);
    bool fine = measure(&bench, arguments->tables);
    fine = (!bench.csv || !fclose(bench.csv)) && fine;
    gl_close(bench.gl);
    return !fine;
}

int bench_render(int argc, char **argv)
{
    Arguments arguments;
    if (read_arguments(argc, argv, &arguments))
        return run(&arguments);
    fputs(
        "usage: matbench render [--untimed] [--gl=osmesa|egl] [--size=WIDTHxHEIGHT] [--csv FILE] [materials] [lights] "
        "[objects] [passes] [fragments]\n",
        stderr);
    return 2;
}
