/* Statistics that replace cells smaller than a pixel, grammar/cells.def, against their defining
 * integrals, over other points than those of `matbench cells`, which prints the table; and the
 * references' search within three cells, against a wider search. */
/* ctest: unsanitized seconds=43 */
#include "tests/test.h"
#include "compiler/library/cells.h"
#include "compiler/library/java_random.h"
#include <stdio.h>

enum { F1, F2, edge, random_number, centre, MEASURES };
#define random random_number /* the table's word, which the C library has, too */

typedef struct {
    int dimensions, distance, measure;
    double mean[3], variance[3], slope[3], narrow, wide;
} Row;
enum { euclidean = CELLS_EUCLIDEAN, manhattan = CELLS_MANHATTAN, chebyshev = CELLS_CHEBYSHEV };
#define THREE(a, b, c)                                                                             \
    {                                                                                              \
        a, b, c                                                                                    \
    }
#define CELLS(...) {__VA_ARGS__},
static const Row rows[] = {
#include "grammar/cells.def"
};
enum { ROWS = sizeof rows / sizeof *rows, POINTS = 20000, SQUARES = 800, SIDE = 8 };
static const ReferenceNoise noises[] = {REFERENCE_LATTICE, REFERENCE_LATTICE_FLOAT};

static double uniform(uint64_t *state) { return 2000 * (double)java_random_signed(state); }

static double value_of(const CellsPair *pair, int measure)
{
    const double values[MEASURES] = {pair->first.distance, pair->second.distance,
                                     pair->second.distance - pair->first.distance,
                                     pair->first.number, pair->first.away[1]};
    return values[measure];
}

static double sample(ReferenceNoise noise, const Row *row, double jitter, const double p[3])
{
    const CellsQuestion q = {
        row->dimensions, {p[0], p[1], p[2]}, jitter, (CellsDistance)row->distance};
    const CellsPair pair = cells_nearest(noise, &q);
    return value_of(&pair, row->measure);
}

/* The parabola through what the row states of jitter 0, 1/2 and 1. */
static double stated(const double at[3], double jitter)
{
    return at[0] * (1 - jitter) * (1 - 2 * jitter) + at[1] * 4 * jitter * (1 - jitter) +
           at[2] * jitter * (2 * jitter - 1);
}

static void near(const Row *row, const char *what, double of, double stands, double within)
{
    if (!(fabs(of - stands) <= within))
        fail_msg("%d dimensions, distance %d, measure %d: %s is %.4f, not %.4f within %.4f",
                 row->dimensions, row->distance, row->measure, what, of, stands, within);
}

static void moments_are_stated(void **state)
{
    static const double jitters[] = {0, .3, .8, 1};
    (void)state;
    for (int i = 0; i < ROWS; i++)
        for (int k = 0; k < 4; k++) {
            const Row *row = &rows[i];
            uint64_t from = java_random(31 + k);
            double mean = 0, square = 0;
            for (int n = 0; n < POINTS / 4; n++) {
                const double p[3] = {uniform(&from), uniform(&from), uniform(&from)};
                const double v = sample(noises[n % 2], row, jitters[k], p);
                mean += v / (POINTS / 4);
                square += v * v / (POINTS / 4);
            }
            near(row, "the mean", mean, stated(row->mean, jitters[k]), .016);
            near(row, "the variance", square - mean * mean, stated(row->variance, jitters[k]),
                 .005);
        }
}

/* The mean square of the derivative, by differences; of what jumps none is stated. */
static void slopes_are_stated(void **state)
{
    (void)state;
    const double h = 1e-6;
    for (int i = 0; i < ROWS; i++) {
        const Row *row = &rows[i];
        uint64_t from = java_random(41);
        double mean = 0;
        for (int n = 0; n < POINTS / 4; n++) {
            double p[3] = {uniform(&from), uniform(&from), uniform(&from)};
            const double here = sample(noises[0], row, 1, p);
            p[0] += h;
            const double rise = (sample(noises[0], row, 1, p) - here) / h;
            mean += rise * rise / (POINTS / 4);
        }
        if (row->measure <= edge)
            near(row, "the mean square of the slope", mean, row->slope[2], .08);
        else
            assert_true(row->slope[0] == 0 && row->slope[1] == 0 && row->slope[2] == 0);
    }
}

/* The best factor by least squares from the value in the middle of a square to the mean over it. */
static double best_factor(const Row *row, double jitter, double width)
{
    uint64_t from = java_random(43);
    double both = 0, square = 0;
    const double mean = stated(row->mean, jitter);
    for (int i = 0; i < SQUARES; i++) {
        const double p[3] = {uniform(&from), uniform(&from), uniform(&from)};
        double sum = 0, middle = sample(noises[0], row, jitter, p) - mean;
        for (int k = 0; k < SIDE * SIDE; k++) {
            const double q[3] = {p[0] + width * ((k % SIDE + .5) / SIDE - .5),
                                 p[1] + width * ((k / SIDE + .5) / SIDE - .5), p[2]};
            sum += (sample(noises[0], row, jitter, q) - mean) / (SIDE * SIDE);
        }
        both += middle * sum;
        square += middle * middle;
    }
    return both / square;
}

static void factors_are_those_of_least_squares(void **state)
{
    static const double widths[] = {.25, .6, 1};
    (void)state;
    for (int i = 0; i < ROWS; i++)
        for (int k = 0; k < 3; k++) {
            const Row *row = &rows[i];
            const double x = row->measure >= random ? widths[k] : widths[k] * widths[k];
            const double factor = 1 / (1 + x * (row->narrow + row->wide * x));
            near(row, "the factor of least squares", best_factor(row, 1, widths[k]), factor, .075);
        }
}

/* Points with corners of cells for places, where the nearest ones may be farthest. */
static void none_is_beyond_reach(void **state)
{
    (void)state;
    for (int dimensions = 2; dimensions <= 3; dimensions++)
        for (int how = CELLS_EUCLIDEAN; how <= CELLS_CHEBYSHEV; how++) {
            uint64_t from = java_random(47);
            double most = 0;
            for (int n = 0; n < POINTS; n++) {
                CellsQuestion q = {dimensions, {0}, 1, (CellsDistance)how};
                for (int i = 0; i < 3; i++)
                    q.p[i] = n % 2 ? floor(uniform(&from)) : uniform(&from);
                const CellsPair pair = cells_nearest(noises[n % 2], &q);
                most = fmax(most, pair.second.distance);
            }
            const double bounds[2][3] = {{sqrt(2.5), 2, 1.5}, {sqrt(3), 3, 1.5}};
            if (most > bounds[dimensions - 2][how])
                fail_msg("%d dimensions, distance %d: a second nearest is %g away", dimensions, how,
                         most);
        }
}

/* Random numbers of neighbors, and a cell's number and its place, know nothing of each other. */
static void numbers_are_independent(void **state)
{
    enum { ALONG = 200 };
    (void)state;
    for (int noise = 0; noise < 2; noise++) {
        double sum = 0, square = 0, beside = 0, place = 0, last = .5;
        for (int i = 0; i < ALONG * ALONG; i++) {
            const CellsQuestion q = {2, {i % ALONG + .5, i / ALONG + .5}, 0, CELLS_EUCLIDEAN};
            CellsQuestion moved = q;
            moved.jitter = .5;
            const CellsPair pair = cells_nearest(noises[noise], &q),
                            other = cells_nearest(noises[noise], &moved);
            const double v = pair.first.number - .5;
            sum += v;
            square += v * v;
            beside += v * last;
            place += v * other.first.away[0] * 4;
            last = v;
        }
        const double n = (double)ALONG * ALONG;
        assert_true(fabs(sum / n) < .006 && fabs(square / n - 1. / 12) < .003);
        assert_true(fabs(beside / n) < .003 && fabs(place / n) < .006);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(moments_are_stated),
        cmocka_unit_test(slopes_are_stated),
        cmocka_unit_test(factors_are_those_of_least_squares),
        cmocka_unit_test(none_is_beyond_reach),
        cmocka_unit_test(numbers_are_independent),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
