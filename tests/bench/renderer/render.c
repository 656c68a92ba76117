/* matbench render: frame times as in the tables of the thesis: by the number of materials,
 * lights and objects, next to a forward renderer, both without tone mapping and timed
 * alternately; the time of a single picture; and the tables of render_passes.h. */
#include <stdio.h>
#include "tests/bench/matbench.h"
#include "render_scenes.h"
#include "render_passes.h"
#include "render_time.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* -- series beside the forward renderer */

enum {
    /* max for the forward renderer: a driver takes minutes to compile more */
    FORWARD_PROGRAMS = 120,
    UNTIMED_PROGRAMS = 10,
    MAX_ROWS = 12
};

typedef struct {
    const char *name, *what;
    int counts[MAX_ROWS]; /* terminated by 0 */
    void (*write)(Text *out, int count);
    bool programs; /* the counts are numbers of programs, for the forward renderer */
    bool bounded;  /* also with grouped far lights */
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
    {"objects",
     "a bush in the sun",
     {8, 25, 78, 245, 767, 2401, 7512, 23474},
     scenes_objects,
     false,
     false},
};
enum { SERIES = sizeof series / sizeof *series };

static void show_row(const Series *of, int count)
{
    char what[64];
    snprintf(what, sizeof what, "%d %s", count, of->name);
    bench_show(what);
}

typedef struct {
    int count;
    BenchTimes times[BENCH_WAYS];
    double apart; /* share of different pixels; NAN: not compared */
} Row;

/* "" if the series lacks the column. */
static const char *way_name(const Series *of, int way)
{
    const char *const names[BENCH_WAYS] = {of->bounded ? "summed" : "deferred",
                                           of->bounded ? "bounded" : "", "forward"};
    return names[way];
}

/* Tolerance, and allowed share of pixels outside of it: the default layout has an error of 1/255
 * at some, light clustering half of that. */
static const double bound = 2.0 / 255, pixels_beyond = .002;

static const char *same_picture(double apart)
{
    return isnan(apart) ? "-" : apart > pixels_beyond ? "no" : "yes";
}

static void put_head(const Series *of)
{
    printf("\n%s: %s; milliseconds a frame\n%9s", of->name, of->what, of->name);
    for (int way = 0; way < BENCH_WAYS; way++)
        if (*way_name(of, way))
            printf(" %10s %10s %8s", way_name(of, way), "least", "/ first");
    printf(" %8s %s\n", of->bounded ? "/ sum." : "/ def.", "same picture");
}

static void put_row(const Bench *bench, const Series *of, const Row *row,
                    const double first[BENCH_WAYS])
{
    const BenchTimes *times = row->times;
    char name[16], least[32];
    snprintf(name, sizeof name, "%d", row->count);
    printf("%9s", name);
    for (int way = 0; way < BENCH_WAYS; way++) {
        if (!*way_name(of, way))
            continue;
        snprintf(least, sizeof least, "%s least", way_name(of, way));
        bench_csv(bench, of->name, name, way_name(of, way), times[way].median);
        bench_csv(bench, of->name, name, least, times[way].least);
        printf(" %10s %10s %8s", NUMBER(3, 1e3 * times[way].median),
               NUMBER(3, 1e3 * times[way].least), NUMBER(2, times[way].median / first[way]));
    }
    printf(" %8s %s\n",
           NUMBER(2, times[BENCH_WAY_forward].median / times[BENCH_WAY_deferred].median),
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
    const RendererOptions options = {.view = "light", .lights = "all"};
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
    for (int i = 0; fine && i < MAX_ROWS && of->counts[i]; i++) {
        Row row = {of->counts[i], {{NAN, NAN}, {NAN, NAN}, {NAN, NAN}}, NAN};
        fine = measure_row(bench, of, &row);
        for (int way = 0; way < BENCH_WAYS; way++)
            first[way] = i ? first[way]
                           : row.times[way == BENCH_WAY_bounded ? BENCH_WAY_deferred : way].median;
        if (fine)
            put_row(bench, of, &row, first);
        fine = fine && !(row.apart > pixels_beyond);
    }
    return fine;
}

/* -- the command */

static const struct {
    const char *name;
    bool (*measure)(const Bench *bench);
} others[] = {{"passes", bench_passes}, {"fragments", bench_fragments}, {"surfaces", bench_lobes}};
enum { TABLES = SERIES + sizeof others / sizeof *others };

static const char *table_name(int table)
{
    return table < SERIES ? series[table].name : others[table - SERIES].name;
}

static bool measure(const Bench *bench, unsigned tables)
{
    bool fine = true;
    for (int i = 0; i < (int)TABLES; i++)
        if (tables >> i & 1)
            fine &=
                i < SERIES ? measure_series(bench, &series[i]) : others[i - SERIES].measure(bench);
    return fine;
}

/* A size that a CPU renders in about the time of a GPU with 1080 rows; minimal without times. */
static void choose_size(Bench *bench)
{
    static const int sizes[][2] = {{160, 90}, {480, 270}, {1920, 1080}};
    const int *size = sizes[!bench->timed ? 0 : bench->gl->hardware ? 2 : 1];
    bench->width = bench->width ? bench->width : size[0];
    bench->height = bench->height ? bench->height : size[1];
}

const char *bench_render_table(const void *user, int i)
{
    (void)user;
    return i < (int)TABLES ? table_name(i) : NULL;
}

static const char *set_size(void *to, const Option *option, const char *value)
{
    BenchOptions *o = to;
    int *size = o->size;
    const bool fine =
        sscanf(value, "%dx%d", &size[0], &size[1]) == 2 && size[0] >= 0 && size[1] >= 0;
    return fine ? NULL : option_fault_number(&o->arena, option->wants, value);
}

const Option bench_render_options[] = {
    BENCH_UNTIMED,
    BENCH_GL,
    {"--size", OPTION_text, .set = set_size, .label = "=WIDTHxHEIGHT",
     .wants = "--size wants WIDTHxHEIGHT", .help = "pixels of a frame"},
    BENCH_TEXT("--csv", csv, " FILE", "where the measurements are written"),
    BENCH_HELP,
};

int bench_render(const BenchOptions *options)
{
    char error[4096];
    Bench bench = {.timed = options->timed,
                   .width = options->size[0],
                   .height = options->size[1],
                   .seconds = 1};
    matc_options_init(&bench.compile);
    bench.compile.pixels = true;
    bench.gl = gl_open(options->timed ? options->gl : GL_KIND_osmesa, true, error, sizeof error);
    bench.csv = bench.gl && options->csv ? fopen(options->csv, "w") : NULL;
    if (!bench.gl || (options->csv && !bench.csv)) {
        fprintf(stderr, "matbench: %s\n", bench.gl ? "the CSV file cannot be written" : error);
        gl_close(bench.gl);
        return 1;
    }
    choose_size(&bench);
    if (bench.timed)
        printf("%s, %d x %d pixels\n", bench.gl->renderer, bench.width, bench.height);
    bool fine = measure(&bench, options->tables ? options->tables : (1u << TABLES) - 1);
    fine = (!bench.csv || !fclose(bench.csv)) && fine;
    gl_close(bench.gl);
    return !fine;
}
