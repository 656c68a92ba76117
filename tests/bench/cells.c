/* matbench cells: computes the mean values that replace cells smaller than a pixel, by
 * integration over random points and squares, and prints the rows of grammar/cells.def in its
 * order. tests/compiler/mean/test_statistics_cells.c compares that table with the same integrals
 * over other points. */
#include "matbench.h"
#include "compiler/library/cells.h"
#include "compiler/library/java_random.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { F1, F2, EDGE, RANDOM, CENTRE, MEASURES };
enum { JITTERS = 3, WIDTHS = 2, SIDE = 8, POINTS = 40000, SQUARES = 1200 };
static const char *const distances[] = {"euclidean", "manhattan", "chebyshev"};
static const char *const measures[MEASURES] = {"F1", "F2", "edge", "random", "centre"};

/* Statistics of one kind of cells, by measure. */
typedef struct {
    double mean[MEASURES], variance[MEASURES], slope[MEASURES];
} Moments;

static double random_number(uint64_t *random) { return 2000 * (double)java_random_signed(random); }

/* Mean squared derivative of the difference of both distances along an axis. */
static double edge_slope(const CellsPair *pair, const CellsQuestion *q)
{
    double sum = 0;
    for (int i = 0; i < q->dimensions; i++) {
        double rise[2];
        for (int k = 0; k < 2; k++) {
            const CellsPoint *point = k ? &pair->second : &pair->first;
            const double a = point->away[i], side = (a > 0) - (a < 0);
            rise[k] = q->how == CELLS_EUCLIDEAN   ? a / point->distance
                      : q->how == CELLS_MANHATTAN ? side
                                                  : (fabs(a) == point->distance ? side : 0);
        }
        sum += (rise[0] - rise[1]) * (rise[0] - rise[1]) / q->dimensions;
    }
    return sum;
}

/* The point's position in the cell counts by one component, with mean 0. */
static void values_of(const CellsPair *pair, double value[MEASURES])
{
    const double all[MEASURES] = {pair->first.distance, pair->second.distance,
                                  pair->second.distance - pair->first.distance, pair->first.number,
                                  pair->first.away[0]};
    memcpy(value, all, sizeof all);
}

static Moments moments_of(CellsQuestion q)
{
    uint64_t random = java_random(5);
    Moments m = {0};
    for (int i = 0; i < POINTS; i++) {
        double value[MEASURES];
        for (int k = 0; k < 3; k++)
            q.p[k] = random_number(&random);
        const CellsPair pair = cells_nearest(REFERENCE_LATTICE, &q);
        values_of(&pair, value);
        for (int k = 0; k < MEASURES; k++) {
            m.mean[k] += value[k] / POINTS;
            m.variance[k] += value[k] * value[k] / POINTS;
        }
        m.slope[EDGE] += edge_slope(&pair, &q) / POINTS;
    }
    for (int k = 0; k < MEASURES; k++)
        m.variance[k] -= m.mean[k] * m.mean[k];
    m.mean[RANDOM] = .5;
    m.variance[RANDOM] = 1. / 12;
    m.mean[CENTRE] = 0;
    m.slope[F1] = m.slope[F2] = q.how == CELLS_MANHATTAN ? 1 : 1. / q.dimensions;
    return m;
}

/* Least-squares factor by which the value at a square's center predicts the mean over the
 * square. */
static void factors_of(CellsQuestion q, const Moments *m, double width, double factor[MEASURES])
{
    uint64_t random = java_random(7);
    double both[MEASURES] = {0}, square[MEASURES] = {0};
    for (int i = 0; i < SQUARES; i++) {
        const double from[3] = {random_number(&random), random_number(&random),
                                random_number(&random)};
        double middle[MEASURES] = {0}, sum[MEASURES] = {0}, value[MEASURES];
        for (int k = -1; k < SIDE * SIDE; k++) {
            const double du = k < 0 ? 0 : width * ((k % SIDE + .5) / SIDE - .5),
                         dv = k < 0 ? 0 : width * ((k / SIDE + .5) / SIDE - .5);
            for (int axis = 0; axis < 3; axis++)
                q.p[axis] = from[axis] + (axis == 0 ? du : axis == 1 ? dv : 0);
            const CellsPair pair = cells_nearest(REFERENCE_LATTICE, &q);
            values_of(&pair, value);
            for (int n = 0; n < MEASURES; n++)
                if (k < 0)
                    middle[n] = value[n] - m->mean[n];
                else
                    sum[n] += (value[n] - m->mean[n]) / (SIDE * SIDE);
        }
        for (int n = 0; n < MEASURES; n++) {
            both[n] += middle[n] * sum[n];
            square[n] += middle[n] * middle[n];
        }
    }
    for (int n = 0; n < MEASURES; n++)
        factor[n] = both[n] / square[n];
}

/* Fits 1 / (1 + b x + c x^2) to the factors of both widths, x = w^2, or w for a discontinuous
 * measure. The fit must decrease: if c would be below 0, c is 0, and b that of the greater
 * width. */
static void fit(const double factor[WIDTHS], const double width[WIDTHS], bool jumps, double bend[2])
{
    double x[WIDTHS], rise[WIDTHS];
    for (int i = 0; i < WIDTHS; i++) {
        x[i] = jumps ? width[i] : width[i] * width[i];
        rise[i] = (1 / fmax(factor[i], .02) - 1) / x[i];
    }
    bend[1] = fmax((rise[1] - rise[0]) / (x[1] - x[0]), 0);
    bend[0] = bend[1] > 0 ? rise[0] - bend[1] * x[0] : rise[1];
}

static void print_kind(int dimensions, CellsDistance how)
{
    static const double jitters[JITTERS] = {0, .5, 1}, widths[WIDTHS] = {.35, .7};
    Moments m[JITTERS];
    double factor[WIDTHS][MEASURES];
    for (int i = 0; i < JITTERS; i++)
        m[i] = moments_of((CellsQuestion){dimensions, {0}, jitters[i], how});
    for (int i = 0; i < WIDTHS; i++)
        factors_of((CellsQuestion){dimensions, {0}, 1, how}, &m[JITTERS - 1], widths[i], factor[i]);
    for (int k = 0; k < MEASURES; k++) {
        const double of[WIDTHS] = {factor[0][k], factor[1][k]};
        double bend[2];
        fit(of, widths, k >= RANDOM, bend);
        printf("CELLS(%d, %s, %s, THREE(%.4f, %.4f, %.4f), THREE(%.4f, %.4f, %.4f), THREE(%.3f, "
               "%.3f, %.3f), %.3f, %.3f)\n",
               dimensions, distances[how], measures[k], m[0].mean[k], m[1].mean[k], m[2].mean[k],
               m[0].variance[k], m[1].variance[k], m[2].variance[k], m[0].slope[k], m[1].slope[k],
               m[2].slope[k], bend[0], bend[1]);
    }
}

int bench_cells(const BenchOptions *options)
{
    (void)options;
    for (int dimensions = 2; dimensions <= 3; dimensions++)
        for (int how = 0; how <= CELLS_CHEBYSHEV; how++)
            print_kind(dimensions, (CellsDistance)how);
    return EXIT_SUCCESS;
}
