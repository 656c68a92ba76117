/* The blue noise mask (runtime/indirect/rays/blue_noise.c): equals the result of
 * void-and-cluster, and its spectrum has almost no low frequencies, compared with white noise.
 * `build/tests/test_blue_noise print` prints its rows in that file's format. */
#include "tests/test.h"
#include "runtime/indirect/rays/blue_noise.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum { EDGE = BLUE_NOISE_EDGE, PIXELS = EDGE * EDGE, FIRST = PIXELS / 10, WIDTH_MAX = EDGE / 2 };

static uint32_t near_by[EDGE]
                       /* contribution of a point to the density at an offset: integers, so that
                        * sums do not depend on their order */
                       [EDGE];
static uint64_t crowd[PIXELS];
static bool is_point[PIXELS];
static int ranks[PIXELS];

static uint32_t next(uint32_t *state) { return (*state = *state * 1664525u + 1013904223u) >> 8; }

static void put(int at, bool point)
{
    is_point[at] = point;
    for (int i = 0; i < PIXELS; i++) {
        const uint32_t more =
            near_by[(i / EDGE - at / EDGE + EDGE) % EDGE][(i % EDGE - at % EDGE + EDGE) % EDGE];
        crowd[i] += point ? more : -(uint64_t)more;
    }
}

/* The point in the densest cluster, or the empty place in the largest void. */
static int extreme(bool points)
{
    int best = -1;
    for (int i = 0; i < PIXELS; i++)
        if (is_point[i] == points &&
            (best < 0 || (points ? crowd[i] > crowd[best] : crowd[i] < crowd[best])))
            best = i;
    return best;
}

/* Void-and-cluster (Ulichney 1993) on a torus: random points move from the densest clusters to
 * the largest voids until no point moves; then these are ranked as they are removed, densest
 * first, and the others as they are added, always to the largest void. */
static void make(void)
{
    const double width = 1.5; /* standard deviation of the density's Gaussian, in pixels */
    static bool first[PIXELS];
    uint32_t state = 14;
    memset(crowd, 0, sizeof crowd);
    memset(is_point, 0, sizeof is_point);
    for (int i = 0; i < PIXELS; i++) {
        const double x = WIDTH_MAX - fabs(i % EDGE - (double)WIDTH_MAX),
                     y = WIDTH_MAX - fabs((double)(i / EDGE) - WIDTH_MAX);
        near_by[i / EDGE][i % EDGE] =
            (uint32_t)(1e6 * exp(-(x * x + y * y) / (2 * width * width)) + .5);
    }
    for (int count = 0; count < FIRST;) {
        const int at = (int)(next(&state) % PIXELS);
        if (!is_point[at]) {
            put(at, true);
            count++;
        }
    }
    for (int from = -1, to = -2; from != to;) {
        put(from = extreme(true), false);
        put(to = extreme(false), true);
    }
    memcpy(first, is_point, sizeof first);
    for (int rank = FIRST - 1; rank >= 0; rank--) {
        const int at = extreme(true);
        ranks[at] = rank;
        put(at, false);
    }
    for (int i = 0; i < PIXELS; i++)
        if (first[i])
            put(i, true);
    for (int rank = FIRST; rank < PIXELS; rank++) {
        const int at = extreme(false);
        ranks[at] = rank;
        put(at, true);
    }
}

static void data_is_what_void_and_cluster_gives(void **state)
{
    (void)state;
    make();
    for (int i = 0; i < PIXELS; i++)
        assert_int_equal(blue_noise_rank(i % EDGE, i / EDGE), ranks[i]);
}

/* Mean power at frequencies within a ring, of values from 0 to 1; white noise has 1/12
 * everywhere. */
static double power(int (*rank)(int, int), double least, double most)
{
    double sum = 0;
    int count = 0;
    for (int v = 0; v < EDGE; v++)
        for (int u = 0; u <= EDGE / 2; u++) {
            const double r = hypot(u, v < EDGE / 2 ? v : v - EDGE);
            double re = 0, im = 0;
            /* a fifth of the frequencies suffices */
            if (r < least || r >= most || (u * 7 + v * 3) % 5)
                continue;
            for (int i = 0; i < PIXELS; i++) {
                const double turn = 2 * PI * ((u * (i % EDGE) + v * (i / EDGE)) % EDGE) / EDGE;
                re += (rank(i % EDGE, i / EDGE) + .5) / PIXELS * cos(turn);
                im += (rank(i % EDGE, i / EDGE) + .5) / PIXELS * sin(turn);
            }
            sum += (re * re + im * im) / PIXELS;
            count++;
        }
    assert_true(count > 10);
    return sum / count * 12;
}

/* SplitMix64 of the place. */
static int white_rank(int x, int y)
{
    uint64_t z = (uint64_t)(y * EDGE + x + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (int)((z ^ z >> 31) >> 52);
}

static void low_frequencies_are_missing(void **state)
{
    (void)state;
    static const double rings[][3] = {
        /* ring of frequencies, and max share of white noise's power */
        {1, 8, .005},
        {8, 16, .1},
        {20, 32, 3}};
    for (int i = 0; i < 3; i++) {
        const double blue = power(blue_noise_rank, rings[i][0], rings[i][1]),
                     white = power(white_rank, rings[i][0], rings[i][1]);
        print_message(
            "waves of %2.0f to %2.0f in 64 pixels: %.4f of white noise's power; at random %.2f\n",
            rings[i][0], rings[i][1], blue, white);
        assert_true(blue < rings[i][2] && (i < 2 || blue > 1) && white > .7 && white < 1.4);
    }
}

/* Each rank occurs once, so values are uniform. */
static void ranks_are_all_there(void **state)
{
    (void)state;
    static bool seen[PIXELS];
    for (int i = 0; i < PIXELS; i++)
        seen[blue_noise_rank(i % EDGE, i / EDGE)] = true;
    for (int i = 0; i < PIXELS; i++)
        assert_true(seen[i]);
}

static void print(void)
{
    make();
    for (int i = 0; i < PIXELS; i++)
        printf("%s%c%c%s", i % 32 ? "" : "    \"", BLUE_NOISE_DIGITS[ranks[i] >> 6],
               BLUE_NOISE_DIGITS[ranks[i] & 63], i % 32 == 31 ? "\",\n" : "");
}

int main(int count, char **arguments)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(data_is_what_void_and_cluster_gives),
                                       cmocka_unit_test(ranks_are_all_there),
                                       cmocka_unit_test(low_frequencies_are_missing)};
    if (count > 1 && !strcmp(arguments[1], "print"))
        return print(), 0;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
