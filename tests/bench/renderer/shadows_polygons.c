/* Data paths by shadow map size, and the thesis' measurement: frames per second by number of
 * polygons, with every map redrawn in each frame. */
#include "shadows.h"
#include "tests/bench/matbench.h"
#include "runtime/autotune/plot.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* -- methods */

static const struct {
    Keyword word;
    const char *name;
} paths[] = {{KEYWORD_Path_fetch, "fetch"},
             {KEYWORD_Path_copy, "copy"},
             {KEYWORD_Path_compute, "compute"}},
  volumes[] = {{KEYWORD_Volume_plain, "plain"},
               {KEYWORD_Volume_blurred, "blurred"},
               {KEYWORD_Volume_perfect, "perfect"}};
enum {
    PATHS = 3,
    VOLUMES = 3,
    NONE = 0,
    MAP,
    FIRST_VOLUME,
    METHODS = FIRST_VOLUME + PATHS * VOLUMES
};

/* None, a single lookup of a map, and each volume by each data path. */
static void list_methods(ShadowsMethod methods[METHODS])
{
    methods[NONE] = (ShadowsMethod){
        {"no", "shadows"}, KEYWORD_Shadows_none, 0, KEYWORD_Volume_plain, false, KEYWORD_Path_auto};
    methods[MAP] = (ShadowsMethod){{"map", "hard"}, KEYWORD_Shadows_map, 0, KEYWORD_Volume_plain,
                                   false,           KEYWORD_Path_auto};
    for (int i = 0; i < PATHS * VOLUMES; i++)
        methods[FIRST_VOLUME + i] =
            (ShadowsMethod){{volumes[i / PATHS].name, paths[i % PATHS].name},
                            KEYWORD_Shadows_hybrid,
                            1,
                            volumes[i / PATHS].word,
                            false,
                            paths[i % PATHS].word};
}

/* -- paths */

bool shadows_paths(const Shadows *s)
{
    static const int sizes[] = {256, 512, 1024};
    enum { SIZES = sizeof sizes / sizeof *sizes };
    ShadowsMethod methods[METHODS];
    ShadowsTime times[SIZES][METHODS];
    list_methods(methods);
    bench_show("paths");
    for (int size = 0; size < SIZES; size++) {
        const ShadowsTiming timing = {methods, METHODS, sizes[size], &s->mesh, {0, 0}, 1};
        if (!shadows_time(s, &timing, times[size]))
            return false;
    }
    bench_show("");
    printf("\npaths: least milliseconds of a frame by the size of the map, standing still and with "
           "light that "
           "moves\n%-19s",
           "volume and path");
    for (int size = 0; size < SIZES; size++)
        printf(" %5d still %5d moving", sizes[size], sizes[size]);
    putchar('\n');
    for (int method = 0; method < METHODS; method++) {
        printf("%-9s %-9s", methods[method].name[0], methods[method].name[1]);
        for (int size = 0; size < SIZES; size++)
            printf(" %11s %12s", NUMBER(3, 1e3 * times[size][method].still),
                   NUMBER(3, 1e3 * times[size][method].moving));
        putchar('\n');
    }
    fflush(stdout);
    return true;
}

/* -- polygons */

static const int polygons[] = {500, 2000, 8000, 32000, 128000, 200000, 800000};
enum { ROWS = sizeof polygons / sizeof *polygons, CHARTS = 3 };

static bool time_row(const Shadows *s, int row, int map_size, double rates[METHODS])
{
    ShadowsMethod methods[METHODS];
    ShadowsTime times[METHODS];
    Shape mesh;
    list_methods(methods);
    if (!shadows_ball(polygons[row], &mesh))
        return fputs("matbench: out of memory\n", stderr) < 0;
    const ShadowsTiming timing = {methods, METHODS, map_size, &mesh, {512, 512}, .2};
    const bool fine = shadows_time(s, &timing, times);
    for (int i = 0; i < METHODS; i++)
        rates[i] = 1 / times[i].moving;
    shape_free(&mesh);
    return fine;
}

static void put_rates(const double rates[ROWS][METHODS], int map_size)
{
    printf("\npolygons: frames a second, all drawn anew, 512 x 512 pixels, a map of %d x %d; "
           "fetched, copied, computed\n"
           "%8s %8s %8s %26s %26s %26s\n",
           map_size, map_size, "polygons", "none", "map", "plain", "blurred", "perfect");
    for (int row = 0; row < ROWS; row++) {
        printf("%8d", polygons[row]);
        for (int i = 0; i < METHODS; i++)
            printf(" %8s", NUMBER(1, rates[row][i]));
        putchar('\n');
    }
    fflush(stdout);
}

/* The fastest of the paths. */
static double best(const double rates[METHODS], int volume)
{
    double most = 0;
    for (int path = 0; path < PATHS; path++)
        most = fmax(most, rates[FIRST_VOLUME + PATHS * volume + path]);
    return most;
}

/* Table 1 of the thesis, on a GeForce 6800 GT. Columns: none, map, then for each kind of volume our
 * path `fetch` (vertex texture fetch in the thesis) and `copy` (pixel buffer). The path `compute`
 * has no counterpart. */
enum { COPIED = 2, THERE = FIRST_VOLUME + COPIED * VOLUMES, QUICK_POLYGONS = 32000 };
static const double there[ROWS][THERE] = {
    {845, 555, 144, 119, 139, 113, 65, 36},
    {739, 432, 135, 112, 131, 107, 63, 35},
    {472, 232, 110, 93, 105, 89, 58, 33},
    {194, 76, 59, 55, 58, 53, 41, 26},
    {60, 22, 21, 20, 20, 19, 18, 14},
    {40, 14, 14, 14, 14, 14, 13, 11},
    {11, 4, 4, 4, 4, 4, 4, 4},
};

/* Index of our method for a column of the thesis' table. */
static int method_of(int column)
{
    const int volume = (column - FIRST_VOLUME) / COPIED, path = (column - FIRST_VOLUME) % COPIED;
    return column < FIRST_VOLUME ? column : FIRST_VOLUME + PATHS * volume + path;
}

/* Prints frames per second, or their ratio to frames without shadows of the same row and side. */
static void put_compared(const double rates[METHODS], int row, bool over_none)
{
    printf("%-8d", polygons[row]);
    for (int i = 0; i < THERE; i++)
        printf(
            " %5s : %8s",
            NUMBER(over_none ? 2 : 0, over_none ? there[row][i] / there[row][NONE] : there[row][i]),
            NUMBER(over_none ? 2 : 1,
                   over_none ? rates[method_of(i)] / rates[NONE] : rates[method_of(i)]));
    putchar('\n');
    fflush(stdout);
}

static void put_compared_head(const char *what)
{
    static const char *const names[THERE] = {"none",          "map",         "plain,fetch",
                                             "plain,copy",    "blur,fetch",  "blur,copy",
                                             "perfect,fetch", "perfect,copy"};
    printf("\ntable 1 of the thesis, a map of 256 x 256, all drawn anew, there : here, %s\n%-8s",
           what, "polygons");
    for (int i = 0; i < THERE; i++)
        printf(" %16s", names[i]);
    putchar('\n');
}

bool shadows_table1(const Shadows *s)
{
    enum { MAP_SIZE = 256 };
    static double rates[ROWS][METHODS];
    for (int row = 0; row < ROWS; row++) {
        for (int i = 0; i < METHODS; i++)
            rates[row][i] = (double)NAN;
        bench_show("table 1");
        if (s->timed && (!s->quick || polygons[row] <= QUICK_POLYGONS) &&
            !time_row(s, row, MAP_SIZE, rates[row]))
            return false;
        bench_show("");
    }
    for (int over_none = 0; over_none < 2; over_none++) {
        put_compared_head(over_none ? "frames a second over those without shadows"
                                    : "frames a second");
        for (int row = 0; row < ROWS; row++)
            put_compared(rates[row], row, over_none);
    }
    return true;
}

enum { LINES = 2 + VOLUMES }; /* lines of a chart: none, map, volumes */

static double rate_of(const double rates[METHODS], int line)
{
    return line < FIRST_VOLUME ? rates[line] : best(rates, line - FIRST_VOLUME);
}

static void fill_chart(const double rates[ROWS][METHODS], bool ratio,
                       PlotPoint points[ROWS * LINES])
{
    static const char *const names[LINES] = {"none", "map", "plain", "blurred", "perfect"};
    for (int i = 0; i < ROWS * LINES; i++) {
        const int line = i / ROWS, row = i % ROWS;
        const double rate = rate_of(rates[row], line);
        points[i] = (PlotPoint){.x = polygons[row],
                                .y = ratio ? rate / rates[row][MAP] : rate,
                                .line = line + 1,
                                .named = row == ROWS - 1,
                                .label = names[line]};
    }
}

static bool write_charts(const Shadows *s, const double rates[2][ROWS][METHODS])
{
    static PlotPoint points[CHARTS][ROWS * LINES];
    static const char *const titles[CHARTS] = {"maps of 256 x 256", "maps of 512 x 512",
                                               "over the map, 256 x 256"};
    PlotPanel panels[CHARTS];
    char path[4096];
    for (int i = 0; i < CHARTS; i++) {
        fill_chart(rates[i == 1], i == 2, points[i]);
        panels[i] =
            (PlotPanel){titles[i], "polygons",
                        i == 2 ? "frames a second over those of the map" : "frames a second",
                        points[i], ROWS * LINES};
    }
    char *svg =
        plot_svg(&(Plot){"Hybrid shadows by polygons", s->gl->renderer, panels, CHARTS, CHARTS});
    snprintf(path, sizeof path, "%s.svg", s->plot);
    FILE *file = fopen(path, "w");
    bool done = file && fputs(svg, file) >= 0;
    done = file && !fclose(file) && done;
    free(svg);
    return done || fprintf(stderr, "matbench: %s cannot be written\n", path) < 0;
}

bool shadows_polygons(const Shadows *s)
{
    static const int sizes[2] = {256, 512};
    static double rates[2][ROWS][METHODS];
    for (int size = 0; size < 2; size++) {
        bench_show("polygons");
        for (int row = 0; row < ROWS; row++)
            if (!time_row(s, row, sizes[size], rates[size][row]))
                return false;
        bench_show("");
        put_rates((const double(*)[METHODS])rates[size], sizes[size]);
    }
    return !s->plot || !s->timed || write_charts(s, (const double(*)[ROWS][METHODS])rates);
}
