/* Statistics that replace filtered noise, against their defining integrals: means over many
 * points of the noise itself. */
/* ctest: unsanitized */
#include "tests/test.h"
#include "compiler/library/java_random.h"
#include "compiler/library/reference.h"
#include <stdio.h>

REFERENCE(turbulenceFiltered);
REFERENCE(turbulenceVariance);
REFERENCE(vectorTurbulenceFiltered);
REFERENCE(graniteFiltered);
REFERENCE(graniteVariance);

enum { POINTS = 300000, SQUARES = 3000, SIDE = 8 };
static const struct {
    const char *name;
    ReferenceNoise noise;
    /* how near to the integrals what is left of the variance and the share are */
    double left, share;
} noises[] = {
    {"lattice", REFERENCE_LATTICE, .004, .004},
    {"lattice of floats", REFERENCE_LATTICE_FLOAT, .004, .004},
    {"groimp", REFERENCE_GROIMP, .004, .004},
    {"simplex", REFERENCE_SIMPLEX, .009, .03},
    {"simplex of floats", REFERENCE_SIMPLEX_FLOAT, .009, .03},
};
enum { NOISES = sizeof noises / sizeof *noises };

static double noise_at(ReferenceNoise noise, const double p[3])
{
    return clamp(2 * reference_lattice(noise, p, NULL), -1, 1);
}

static void random_point(uint64_t *random, double p[3])
{
    for (int i = 0; i < 3; i++)
        p[i] = 3000 * (double)java_random_signed(random) + (double)java_random_signed(random);
}

typedef struct {
    double components[3]; /* means of the vector */
    /* slope: the mean square of its derivative along an axis */
    double mean, variance, magnitude, slope;
    double fourth; /* mean fourth power */
} Moments;

static Moments measure(ReferenceNoise noise)
{
    uint64_t random = java_random(11);
    Moments m = {0};
    double square = 0;
    for (int i = 0; i < POINTS; i++) {
        double p[3], value[3], slope[3][3];
        random_point(&random, p);
        reference_lattice_slope(noise, p, value, slope);
        double v = clamp(2 * value[0], -1, 1);
        for (int component = 0; component < 3; component++)
            m.components[component] += value[component] / POINTS;
        m.mean += v / POINTS;
        m.magnitude += fabs(v) / POINTS;
        square += v * v / POINTS;
        m.fourth += v * v * v * v / POINTS;
        for (int axis = 0; axis < 3 && fabs(v) < 1; axis++)
            m.slope += 4 * slope[0][axis] * slope[0][axis] / 3 / POINTS;
    }
    m.variance = square - m.mean * m.mean;
    return m;
}

static Moments moments[NOISES];

static int set_up(void **state)
{
    (void)state;
    for (int i = 0; i < NOISES; i++)
        moments[i] = measure(noises[i].noise);
    return 0;
}

static const double wide = 1e3;

/* One octave at a place, over a square of an edge. */
static double filtered(ReferenceNoise noise, const double p[3], double width)
{
    const double args[] = {p[0], p[1], p[2], 0, 0, 0, 1, 2, 1, width};
    double result[4];
    reference_turbulenceFiltered(&(ReferenceContext){.noise = noise}, args, result);
    return result[0];
}

static double variance_left(ReferenceNoise noise, double width)
{
    double result[4];
    reference_turbulenceVariance(&(ReferenceContext){.noise = noise},
                                 (const double[]){1, 2, 1, width}, result);
    return result[0];
}

static void near(const char *name, const char *what, double stated, double is, double within)
{
    print_message("%-18s %-40s %8.4f, is %8.4f, within %.4f\n", name, what, stated, is, within);
    if (!(fabs(stated - is) <= within))
        fail_msg("%s: %s: %g, not %g", name, what, stated, is);
}

/* Mean of a component of one octave of vectors over a wide square. */
static double stated_component(ReferenceNoise noise, int component)
{
    const double args[] = {.1, .2, .3, 0, 0, 0, 1, 2, 1, wide};
    double result[4];
    reference_vectorTurbulenceFiltered(&(ReferenceContext){.noise = noise}, args, result);
    return result[component];
}

/* (noiseMagnitude - 1/2) (2 - 1/32): six octaves, each half as strong as the one before. */
static double stated_magnitude(ReferenceNoise noise)
{
    double result[4];
    reference_graniteFiltered(&(ReferenceContext){.noise = noise},
                              (const double[]){0, 0, 0, 0, 0, 0, wide}, result);
    return result[0] / (63. / 32) + .5;
}

/* Share of a value that one octave keeps over a square. */
static double share(ReferenceNoise noise, double width)
{
    const double p[3] = {.3, .2, .6};
    double mean = filtered(noise, p, wide), plain = filtered(noise, p, 0);
    return (filtered(noise, p, width) - mean) / (plain - mean);
}

static void wide_squares_have_the_moments(void **state)
{
    (void)state;
    for (int i = 0; i < NOISES; i++) {
        ReferenceNoise noise = noises[i].noise;
        Moments m = moments[i];
        near(noises[i].name, "mean", filtered(noise, (const double[3]){.1, .2, .3}, wide), m.mean,
             .002);
        near(noises[i].name, "mean magnitude", stated_magnitude(noise), m.magnitude, .002);
        near(noises[i].name, "variance", variance_left(noise, wide), m.variance, .003);
        for (int component = 0; component < 3; component++)
            near(noises[i].name, "mean of vectors", stated_component(noise, component),
                 m.components[component], .002);
    }
}

enum { PLACES = 64, PLACE_POINTS = 1500, CELLS = 60 };

/* Distances of a mean over points of a place, and of the mean square, in their standard errors: the
 * root mean square over the places, and the greatest. If corners are independent the first is about
 * 1, and one of 64 places exceeds 4.5 in one set of 2,300. */
typedef struct {
    double root[2], most[2];
} Spread;

static void look_at_place(ReferenceNoise noise, const double plane[2][3], const double from[3],
                          uint64_t *random, double mean[2])
{
    mean[0] = mean[1] = 0;
    for (int i = 0; i < PLACE_POINTS; i++) {
        const double a = CELLS * (double)java_random_signed(random),
                     b = CELLS * (double)java_random_signed(random);
        double p[3];
        for (int axis = 0; axis < 3; axis++)
            p[axis] = from[axis] + a * plane[0][axis] + b * plane[1][axis];
        const double v = noise_at(noise, p);
        mean[0] += v / PLACE_POINTS;
        mean[1] += v * v / PLACE_POINTS;
    }
}

static Spread spread_over(ReferenceNoise noise, const Moments *m, const double plane[2][3])
{
    uint64_t random = java_random(23);
    const double square = m->variance + m->mean * m->mean;
    const double is[2] = {m->mean, square},
                 error[2] = {sqrt(m->variance / PLACE_POINTS),
                             sqrt((m->fourth - square * square) / PLACE_POINTS)};
    Spread spread = {0};
    for (int place = 0; place < PLACES; place++) {
        double from[3], mean[2];
        for (int axis = 0; axis < 3; axis++)
            from[axis] = 30000 * (double)java_random_signed(&random);
        look_at_place(noise, plane, from, &random, mean);
        for (int i = 0; i < 2; i++) {
            const double off = fabs(mean[i] - is[i]) / error[i];
            spread.root[i] += off * off / PLACES;
            spread.most[i] = fmax(spread.most[i], off);
        }
    }
    for (int i = 0; i < 2; i++)
        spread.root[i] = sqrt(spread.root[i]);
    return spread;
}

/* 64 places of each plane: a hash whose corners are alike along an axis of a lattice shows there,
 * the simplex' skewed ones among them. The planes are a little askew, since within a cell the
 * variance is not the same everywhere. */
static void places_differ_as_chance_has_it(void **state)
{
    static const double planes[][2][3] = {
        {{1, 0, .013}, {0, 1, .017}},
        {{.013, 1, 0}, {.017, 0, 1}},
        {{0, .013, 1}, {1, .017, 0}},
        {{5. / 6, -1. / 6, -.15}, {-1. / 6, 5. / 6, -.15}},
        {{-.15, 5. / 6, -1. / 6}, {-.15, -1. / 6, 5. / 6}},
        {{-1. / 6, -.15, 5. / 6}, {5. / 6, -.15, -1. / 6}},
        {{1, -1, .013}, {.5, .5, -.983}},
        {{.7, .5, .3}, {-.4, .6, .8}},
    };
    static const char *const what[] = {"means of places", "mean squares of places"};
    (void)state;
    for (int i = 0; i < NOISES; i++)
        for (size_t plane = 0; plane < sizeof planes / sizeof *planes; plane++) {
            const Spread spread = spread_over(noises[i].noise, &moments[i], planes[plane]);
            for (int k = 0; k < 2; k++) {
                near(noises[i].name, what[k], 1, spread.root[k], .4);
                near(noises[i].name, "the one furthest off", 0, spread.most[k], 5);
            }
        }
}

/* The slope of a square's mean shows a part of its variance: share^2 slope^2 edge^2 / 12. */
static void slopes_show_their_part(void **state)
{
    (void)state;
    const double width = .6;
    for (int i = 0; i < NOISES; i++) {
        Moments m = moments[i];
        double kept = share(noises[i].noise, width),
               left = variance_left(noises[i].noise, width) / m.variance;
        near(noises[i].name, "left of the variance over 0.6", left,
             1 - kept * kept * (1 + m.slope / m.variance * width * width / 12), noises[i].left);
    }
}

/* The best factor by least squares from the value in the middle of a square to the mean over it. */
static double best_factor(ReferenceNoise noise, double mean, double width)
{
    uint64_t random = java_random(13);
    double both = 0, square = 0;
    for (int i = 0; i < SQUARES; i++) {
        double p[3], sum = 0;
        random_point(&random, p);
        double middle = noise_at(noise, p) - mean;
        for (int k = 0; k < SIDE * SIDE; k++) {
            const double q[3] = {p[0] + width * ((k % SIDE + .5) / SIDE - .5),
                                 p[1] + width * ((k / SIDE + .5) / SIDE - .5), p[2]};
            sum += (noise_at(noise, q) - mean) / (SIDE * SIDE);
        }
        both += middle * sum;
        square += middle * middle;
    }
    return both / square;
}

/* The share is 1.43 times the factor less 0.43, so that it ends. */
static void shares_are_those_of_least_squares(void **state)
{
    (void)state;
    static const double widths[] = {.3, .8, 1.4};
    for (int i = 0; i < NOISES; i++)
        for (int k = 0; k < 3; k++) {
            double width = widths[k] / (noises[i].noise >= REFERENCE_SIMPLEX ? 2 : 1);
            double stated = (share(noises[i].noise, width) + .43) / 1.43;
            char what[64];
            snprintf(what, sizeof what, "least squares over %g", width);
            near(noises[i].name, what, stated, best_factor(noises[i].noise, moments[i].mean, width),
                 noises[i].share);
        }
}

/* The topmost bits of a corner's number, from the slope of noise there: where all other corners
 * count for nothing it is that number. */
enum { GRID = 64, LEVELS = 16, PAIRS = LEVELS * LEVELS };

static int level_at(ReferenceNoise noise, const int corner[3], int axis)
{
    double p[3], value[3], slope[3][3],
        back = noise == REFERENCE_SIMPLEX ? (corner[0] + corner[1] + corner[2]) / 6. : 0;
    for (int i = 0; i < 3; i++)
        p[i] = corner[i] - back;
    reference_lattice_slope(noise, p, value, slope);
    double number = slope[0][axis] / (noise == REFERENCE_SIMPLEX ? 71. / 16 : 1);
    return (int)clamp(floor((number + 1) * LEVELS / 2), 0, LEVELS - 1);
}

typedef unsigned char Levels[GRID * GRID * GRID];

/* Chi squared of pairs of levels, one's at a corner and the other's a step further, 255 degrees of
 * freedom: of 114 that are independent, one in 500,000 sets has one above 430. */
static double chi_squared(const Levels one, const Levels other, const int step[3])
{
    int counts[PAIRS] = {0};
    const double expected = (double)(GRID - step[0]) * (GRID - step[1]) * (GRID - step[2]) / PAIRS;
    double sum = 0;
    for (int x = 0; x < GRID - step[0]; x++)
        for (int y = 0; y < GRID - step[1]; y++)
            for (int z = 0; z < GRID - step[2]; z++) {
                const int at = (x * GRID + y) * GRID + z;
                counts[LEVELS * one[at] +
                       other[at + (step[0] * GRID + step[1]) * GRID + step[2]]]++;
            }
    for (int i = 0; i < PAIRS; i++)
        sum += (counts[i] - expected) * (counts[i] - expected) / expected;
    return sum;
}

static void find_levels(ReferenceNoise noise, Levels levels[3])
{
    for (int axis = 0; axis < 3; axis++)
        for (int at = 0; at < GRID * GRID * GRID; at++)
            levels[axis][at] = (unsigned char)level_at(
                noise,
                (const int[]){1000 + at / GRID / GRID, 777 + at / GRID % GRID, 31000 + at % GRID},
                axis);
}

/* Nor do the numbers of one corner. */
static void neighbours_know_nothing_of_each_other(void **state)
{
    static const int steps[][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0},
                                   {0, 1, 1}, {1, 0, 1}, {1, 1, 1}, {2, 0, 0}, {0, 0, 2}};
    static const struct {
        const char *name;
        ReferenceNoise noise;
    } hashed[] = {{"lattice", REFERENCE_LATTICE}, {"simplex", REFERENCE_SIMPLEX}};
    static Levels levels[3];
    (void)state;
    for (int i = 0; i < 2; i++) {
        find_levels(hashed[i].noise, levels);
        for (int axis = 0; axis < 3; axis++)
            for (size_t step = 0; step < sizeof steps / sizeof *steps; step++) {
                near(hashed[i].name, "corners, chi squared", 0,
                     chi_squared(levels[axis], levels[(axis + 1) % 3], steps[step]), 430);
                if (step)
                    near(hashed[i].name, "neighbours, chi squared", 0,
                         chi_squared(levels[axis], levels[axis], steps[step]), 430);
            }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wide_squares_have_the_moments),
        cmocka_unit_test(places_differ_as_chance_has_it),
        cmocka_unit_test(slopes_show_their_part),
        cmocka_unit_test(shares_are_those_of_least_squares),
        cmocka_unit_test(neighbours_know_nothing_of_each_other),
    };
    return cmocka_run_group_tests(tests, set_up, NULL);
}
