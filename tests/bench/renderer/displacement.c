/* matbench displacement: distance of displaced triangles from the true surface, by their number
 * and subdivision method, and the number of triangles displaced and drawn per second. */
#include "displacement.h"
#include "tests/bench/matbench.h"
#include "runtime/renderer/renderer.h"
#include "runtime/tessellate/scene_divide.h"
#include "runtime/tessellate/scene_refine.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 1024, TEXT = 2048, FRAMES = 5, SMOOTHINGS = 3, CRATERS = 400 };

/* -- heights over a square whose edge is 1, at points a whole number of steps from its corner,
 * linear between them */

typedef struct {
    int side;
    double *height; /* side * side */
} Field;

static double texel(const Field *f, int x, int y)
{
    const int last = f->side - 1;
    x = x < 0 ? 0 : x > last ? last : x;
    y = y < 0 ? 0 : y > last ? last : y;
    return f->height[(size_t)y * (size_t)f->side + (size_t)x];
}

static double height_at(const Field *f, double x, double y)
{
    const double u = x * f->side, v = y * f->side, s = u - floor(u), t = v - floor(v);
    const int i = (int)floor(u), k = (int)floor(v);
    return (texel(f, i, k) * (1 - s) + texel(f, i + 1, k) * s) * (1 - t) +
           (texel(f, i, k + 1) * (1 - s) + texel(f, i + 1, k + 1) * s) * t;
}

/* Smooths with the kernel 1, 2, 1 along both axes. */
static void smooth(Field *f)
{
    double *next = malloc((size_t)f->side * (size_t)f->side * sizeof *next);
    for (int y = 0; next && y < f->side; y++)
        for (int x = 0; x < f->side; x++) {
            double sum = 0;
            for (int i = 0; i < 9; i++)
                sum += (i % 3 == 1 ? 4 : 1) * (i / 3 == 1 ? 4 : 1) *
                       texel(f, x + i % 3 - 1, y + i / 3 - 1) / 36;
            next[(size_t)y * (size_t)f->side + (size_t)x] = sum;
        }
    free(f->height);
    f->height = next;
}

static double chance(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) * 0x1p-24;
}

/* Craters with rims, with a power law of sizes, as on an asteroid's height map. */
static Field craters(void)
{
    Field f = {SIDE, calloc((size_t)SIDE * SIDE, sizeof *f.height)};
    uint32_t state = 7;
    for (int i = 0; f.height && i < CRATERS; i++) {
        const double x = chance(&state), y = chance(&state), r = .01 / sqrt(chance(&state) + .005),
                     reach = 2 * r;
        for (int row = (int)fmax(0, (y - reach) * SIDE); row < SIDE && row < (y + reach) * SIDE;
             row++)
            for (int column = (int)fmax(0, (x - reach) * SIDE);
                 column < SIDE && column < (x + reach) * SIDE; column++) {
                const double d = hypot((double)column / SIDE - x, (double)row / SIDE - y) / r;
                f.height[(size_t)row * SIDE + (size_t)column] +=
                    r * (d < 1 ? .5 * (d * d - 1) + .15 : .15 * exp(-6 * (d - 1)));
            }
    }
    return f;
}

/* Reads the red channel of a picture, scaled to a quarter of the edge, and smooths it. */
static bool read_map(const char *path, Field *f)
{
    char text[TEXT];
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    snprintf(text, sizeof text,
             "material: Phong\ndiffuse: { map: ImageMap, colorspace: linear, image: \"%s\" }\n",
             path);
    MatcDocument *document = matc_read("map.yaml", text, strlen(text), &options);
    MatcProgram *program = matc_compile(document, 0, MATC_KEY, &options);
    const MatcTexture *texture =
        matc_ok(program) && matc_texture_count(program) ? matc_texture(program, 0) : NULL;
    const bool fine = texture && texture->bytes && texture->width == texture->height;
    if (fine) {
        const size_t count = (size_t)texture->width * (size_t)texture->width;
        *f = (Field){texture->width, malloc(count * sizeof *f->height)};
        for (size_t i = 0; f->height && i < count; i++)
            f->height[i] = .25 * texture->bytes[i * (size_t)texture->components] / 255;
        for (int i = 0; i < SMOOTHINGS && f->height; i++)
            smooth(f);
    } else {
        fprintf(stderr, "matbench: %s: %s\n", path,
                texture ? "no square picture of 8 bits a lane"
                        : matc_program_diagnostics(program, MATC_TEXT));
    }
    matc_program_free(program);
    matc_document_free(document);
    return fine && f->height;
}

/* -- error */

static bool lift(void *user, const ShapeVertex *at, int count, double (*to)[3])
{
    for (int i = 0; i < count; i++) {
        for (int component = 0; component < 3; component++)
            to[i][component] = (double)at[i].position[component];
        to[i][2] = height_at(user, to[i][0], to[i][1]);
    }
    return true;
}

typedef struct {
    double square, most;
    long count;
    unsigned char *met; /* for each point: covered by a triangle */
} Error;

/* Adds points of the field within a triangle, or on its edges. */
static void add_triangle(const Field *f, const float *const p[3], Error *e)
{
    const double ax = p[0][0], ay = p[0][1], bx = p[1][0] - ax, by = p[1][1] - ay,
                 cx = p[2][0] - ax, cy = p[2][1] - ay;
    const double twice = bx * cy - by * cx;
    const double low[2] = {fmin(fmin(ax, p[1][0]), p[2][0]), fmin(fmin(ay, p[1][1]), p[2][1])},
                 high[2] = {fmax(fmax(ax, p[1][0]), p[2][0]), fmax(fmax(ay, p[1][1]), p[2][1])};
    for (int row = (int)ceil(low[1] * f->side); row < f->side && row <= high[1] * f->side; row++)
        for (int column = (int)ceil(low[0] * f->side);
             column < f->side && column <= high[0] * f->side; column++) {
            const double x = (double)column / f->side - ax, y = (double)row / f->side - ay;
            const double b = (x * cy - y * cx) / twice, c = (bx * y - by * x) / twice;
            unsigned char *met = &e->met[(size_t)row * (size_t)f->side + (size_t)column];
            if (b < 0 || c < 0 || b + c > 1 || *met)
                continue;
            *met = 1;
            const double miss = fabs(p[0][2] + b * ((double)p[1][2] - p[0][2]) +
                                     c * ((double)p[2][2] - p[0][2]) - texel(f, column, row));
            e->square += miss * miss;
            e->most = fmax(e->most, miss);
            e->count++;
        }
}

static Error error_of(const Field *f, const Shape *shape)
{
    Error e = {.met = calloc((size_t)f->side, (size_t)f->side)};
    for (int i = 0; e.met && i < shape->index_count; i += 3) {
        const float *p[3];
        for (int k = 0; k < 3; k++)
            p[k] = shape->vertices[shape->indices[i + k]].position;
        add_triangle(f, p, &e);
    }
    free(e.met);
    return e;
}

static bool even(Field *f, const Shape *square, int triangles, Shape *made)
{
    if (!scene_divide(square, (int)lrint(sqrt(triangles / 2.)), made))
        return false;
    for (int i = 0; i < made->vertex_count; i++) {
        float *p = made->vertices[i].position;
        p[2] = (float)height_at(f, (double)p[0], (double)p[1]);
    }
    return true;
}

static void unit_square(Shape *square)
{
    shape_make_detailed(SHAPE_plane, (int[]){1, 1}, square);
    for (int i = 0; i < square->vertex_count; i++)
        for (int component = 0; component < 2; component++)
            square->vertices[i].position[component] =
                square->vertices[i].position[component] > 0 ? 1 : 0;
}

static bool measure_error(GlContext *gl, const BenchOptions *a)
{
    Field f = {0};
    Shape square;
    (void)gl;
    if (a->map ? !read_map(a->map, &f) : !(f = craters()).height)
        return false;
    unit_square(&square);
    printf("\n%s, a square of edge 1: vertical error at %d x %d points\n%-10s %10s %10s %12s %10s "
           "%10s %10s\n",
           a->map ? "a map, 0.25 high" : "craters", f.side, f.side, "triangles", "evenly", "most",
           "by bisection", "most", "ratio", "seconds");
    static const int rows[] = {8192, 32768, 45000, 131072, 524288, 2097152};
    for (int row = 0; row < (int)(sizeof rows / sizeof *rows) && rows[row] <= a->triangles; row++) {
        const int triangles = rows[row];
        Shape shape[2];
        if (!even(&f, &square, triangles, &shape[0]))
            return false;
        const double begin = bench_now();
        if (!scene_refine(&square,
                          &(SceneRefining){.move = lift, .user = &f, .triangles = triangles},
                          &shape[1]))
            return false;
        const double took = bench_now() - begin;
        const Error e[2] = {error_of(&f, &shape[0]), error_of(&f, &shape[1])};
        const double rms[2] = {sqrt(e[0].square / (double)e[0].count),
                               sqrt(e[1].square / (double)e[1].count)};
        printf("%-10d %10.6f %10.4f %12.6f %10.4f %10.2f %10s\n", triangles, rms[0], e[0].most,
               rms[1], e[1].most, rms[0] / rms[1], NUMBER(2, a->timed ? took : NAN));
        shape_free(&shape[0]);
        shape_free(&shape[1]);
    }
    shape_free(&square);
    free(f.height);
    return true;
}

static bool measure_speed(GlContext *gl, const BenchOptions *a)
{
    return displacement_speed(gl, a->timed, a->triangles / 4);
}

static bool measure_programs(GlContext *gl, const BenchOptions *a)
{
    return displacement_programs(gl, a->timed, a->triangles / 4);
}

static bool autotune_table(GlContext *gl, const BenchOptions *a)
{
    return displacement_table(gl, a->timed, a->triangles, a->plot);
}

static bool measure_bisection(GlContext *gl, const BenchOptions *a)
{
    return displacement_bisection(gl, a->timed, a->triangles / 4);
}

static bool measure_silhouettes(GlContext *gl, const BenchOptions *a)
{
    (void)a;
    return displacement_silhouettes(gl);
}

static bool measure_slopes(GlContext *gl, const BenchOptions *a)
{
    (void)gl;
    (void)a;
    return displacement_slopes();
}

/* -- the command */

static const struct {
    const char *name;
    bool (*measure)(GlContext *, const BenchOptions *);
    bool asked; /* measured only if named */
} tables[] = {{"error", measure_error, false},
              {"speed", measure_speed, false},
              {"programs", measure_programs, false},
              {"bisection", measure_bisection, true},
              {"silhouettes", measure_silhouettes, true},
              {"slopes", measure_slopes, true},
              {"table", autotune_table, true}};
enum { TABLES = sizeof tables / sizeof *tables };

const char *bench_displacement_table(const void *user, int i)
{
    (void)user;
    return i < TABLES ? tables[i].name : NULL;
}

const Option bench_displacement_options[] = {
    BENCH_UNTIMED,
    BENCH_GL,
    BENCH_TEXT("--map", map, "=FILE", "heights of an image instead of craters"),
    BENCH_INT("--triangles", triangles, "=N", 8192, 1 << 24, "a number from 8192 to 16777216",
              "the most that are drawn: 524288"),
    BENCH_TEXT("--plot", plot, "=BASENAME", "charts beside the table"),
    BENCH_HELP,
};

int bench_displacement(const BenchOptions *options)
{
    char error[4096];
    BenchOptions a = *options;
    a.triangles = a.triangles ? a.triangles : 1 << 19;
    GlContext *gl = gl_open(a.gl, true, error, sizeof error);
    bool fine = gl || fprintf(stderr, "matbench: %s\n", error) < 0;
    if (fine && a.timed)
        printf("%s\n", gl->renderer);
    for (int i = 0; fine && i < TABLES; i++)
        fine = !(a.tables ? a.tables >> i & 1 : !tables[i].asked) || tables[i].measure(gl, &a);
    gl_close(gl);
    return !fine;
}
