/* matbench functions: the accuracy of the driver's built-in functions for which GLSL promises
 * little or nothing, and of waves that are made of them. They are drawn on a grid of floats and
 * compared with the C library in double. Prints the worst error next to the bound that
 * docs/reference/stability.md states for Mesa. */
#include "matbench.h"
#include "tests/draw/canvas.h"
#include <math.h>
#include <stdio.h>

enum { SIDE = 512, PIXELS = SIDE * SIDE };
static const double UNIT = 1. / (1 << 24); /* unit of relative errors */

/* Drawn from `low` on, over a width that is a power of two, so that every number of the grid is
 * a float. */
typedef struct {
    const char *name, *library; /* a library function, or "" */
    double (*reference)(double);
    double low, width;
    bool of_exp; /* 6 + 2 |x| units of 2^-24, relative; otherwise `stated`, absolute */
    double stated;
} Row;

static const Row rows[] = {
    {"exp", "", exp, -40, 128, true, 0},
    {"waveCosh", "waveCosh", cosh, -40, 128, true, 0},
    {"waveSinh", "waveSinh", sinh, -40, 128, true, 0},
    {"sin", "", sin, -4, 8, false, 4e-7},
    {"cos", "", cos, -4, 8, false, 4e-7},
    {"acos", "", acos, -1, 2, false, 4e-4},
    {"asin", "", asin, -1, 2, false, 4e-4},
    {"atan", "", atan, -64, 128, false, 4e-6},
};

/* Greatest ratio of the error to the stated bound, and the greatest error. */
typedef struct {
    double seen, ratio;
} Worst;

static Worst worst_of(const Row *row, const float *rgba)
{
    Worst worst = {0, 0};
    for (int i = 0; i < PIXELS; i++) {
        double x = row->low + i * (row->width / PIXELS), value = row->reference(x);
        double off =
            fabs((double)rgba[4 * i] - value) / (row->of_exp && value != 0 ? fabs(value) : 1);
        double stated = row->of_exp ? (6 + 2 * fabs(x)) * UNIT : row->stated;
        worst.seen = fmax(worst.seen, off);
        worst.ratio = fmax(worst.ratio, off / stated);
    }
    return worst;
}

static bool measure(Canvas *canvas, const Row *row, float *rgba, Worst *worst)
{
    char expression[128];
    snprintf(expression, sizeof expression, "vec4(%s(float(index) * %.17g + %.17g))", row->name,
             row->width / PIXELS, row->low);
    if (!canvas_draw(canvas, &(Drawing){.functions = row->library, .expression = expression},
                     &canvas->floats) ||
        !framebuffer_read(canvas->gl, &canvas->floats, 0, rgba)) {
        fprintf(stderr, "matbench: %s: %s\n", row->name, canvas->error);
        return false;
    }
    *worst = worst_of(row, rgba);
    return true;
}

static void put_row(const Row *row, const Worst *worst)
{
    char range[32], seen[16] = "-";
    snprintf(range, sizeof range, "[%g, %g]", row->low, row->low + row->width);
    if (worst)
        snprintf(seen, sizeof seen, "%.1e", worst->seen);
    if (row->of_exp)
        printf("%-10s %-12s relative   %8s  (6 + 2|x|) 2^-24\n", row->name, range, seen);
    else
        printf("%-10s %-12s absolute   %8s  %.0e\n", row->name, range, seen, row->stated);
}

int bench_functions(const BenchOptions *options)
{
    Canvas canvas;
    bool drawn = options->timed, fine = true;
    static float rgba[4 * PIXELS];
    if (drawn && !canvas_open(&canvas, SIDE)) {
        fprintf(stderr, "matbench: %s\n", canvas.error);
        return 1;
    }
    printf("%-10s %-12s %-10s %8s  %s\n", "function", "x in", "error", "seen", "stated");
    for (size_t i = 0; i < sizeof rows / sizeof *rows && fine; i++) {
        Worst worst = {0};
        fine = !drawn || measure(&canvas, &rows[i], rgba, &worst);
        put_row(&rows[i], drawn ? &worst : NULL);
        if (worst.ratio > 1)
            fprintf(stderr, "matbench: %s errs by more than is stated\n", rows[i].name);
        fine = fine && worst.ratio <= 1;
    }
    if (drawn)
        canvas_close(&canvas);
    return !fine;
}
