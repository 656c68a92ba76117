/* Sample sequences of indirect rays: published values; sets of samples are nets; sets over tiles
 * of pixels are nets. */
#include "tests/test.h"
#include "runtime/indirect/rays/indirect_sequence.h"
#include <math.h>
#include <string.h>

enum { MOST = 4096 };
static double samples[MOST][2];

static void sequences_are_as_they_are_published(void **state)
{
    (void)state;
    static const struct {
        Keyword sequence;
        double first[5][2];
    } cases[] = {
        {KEYWORD_Sequence_hammersley, {{0, 0}, {.2, .5}, {.4, .25}, {.6, .75}, {.8, .125}}},
        {KEYWORD_Sequence_halton,
         {{0, 0}, {.5, 1. / 3}, {.25, 2. / 3}, {.75, 1. / 9}, {.125, 4. / 9}}},
        {KEYWORD_Sequence_sobol, {{0, 0}, {.5, .5}, {.25, .75}, {.75, .25}, {.125, .625}}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        indirect_sequence_samples(cases[i].sequence, 5, samples);
        for (int k = 0; k < 10; k++)
            assert_true(fabs(samples[k / 2][k % 2] - cases[i].first[k / 2][k % 2]) < 1e-15);
    }
}

/* The third dimension has base 5 in Halton's sequence, and base 3 in the others, whose first two
 * have base 2. */
static void thirds_are_of_other_bases(void **state)
{
    (void)state;
    static const double five[6] = {0, .2, .4, .6, .8, .04},
                        three[6] = {0, 1. / 3, 2. / 3, 1. / 9, 4. / 9, 7. / 9};
    for (int i = 0; i < 6; i++) {
        assert_true(fabs(indirect_sequence_third(KEYWORD_Sequence_halton, i) - five[i]) < 1e-15);
        assert_true(fabs(indirect_sequence_third(KEYWORD_Sequence_sobol, i) - three[i]) < 1e-15);
        assert_true(fabs(indirect_sequence_third(KEYWORD_Sequence_hammersley, i) - three[i]) <
                    1e-15);
    }
}

/* Checks that each box of 2^-a by 2^(a - m) contains one of 2^m samples. */
static void assert_net(int m)
{
    static int seen[MOST];
    for (int a = 0; a <= m; a++) {
        memset(seen, 0, sizeof seen);
        for (int i = 0; i < 1 << m; i++)
            seen[((int)(samples[i][0] * (1 << a)) << (m - a)) +
                 (int)(samples[i][1] * (1 << (m - a)))]++;
        for (int i = 0; i < 1 << m; i++)
            assert_int_equal(seen[i], 1);
    }
}

static void sets_are_nets(void **state)
{
    (void)state;
    static const Keyword sequences[] = {KEYWORD_Sequence_hammersley, KEYWORD_Sequence_sobol};
    for (int m = 0; m <= 12; m++)
        for (int i = 0; i < 2; i++) {
            indirect_sequence_samples(sequences[i], 1 << m, samples);
            assert_net(m);
        }
}

/* A rotated sample in 16 bits, as in the GLSL. */
static double turned(double sample, double shift)
{
    return ((unsigned)(sample * 65536) ^ (unsigned)(shift * 65536)) / 65536.;
}

/* The samples of each 2^k x 2^k pixels of a tile form one net, at any aligned position: 1, 4,
 * 16, 64 pixels. */
static void tiles_of_sobol_are_nets(void **state)
{
    (void)state;
    for (int bits = 0; bits <= 5; bits++) {
        const IndirectSequence of = {KEYWORD_Sequence_sobol, KEYWORD_Rotation_tile, 1 << bits};
        assert_int_equal(indirect_sequence_edge(&of), 8);
        for (int edge = 1, m = bits; edge <= 8; edge *= 2, m += 2)
            for (int block = 0; block < 64 / (edge * edge); block++) {
                static double own[MOST][2];
                const int x = block % (8 / edge) * edge, y = block / (8 / edge) * edge;
                int count = 0;
                indirect_sequence_samples(of.sequence, of.count, own);
                for (int p = 0; p < edge * edge; p++)
                    for (int i = 0; i < of.count; i++, count++) {
                        double shift[3];
                        indirect_sequence_shift(&of, x + p % edge + 8, y + p / edge, shift);
                        for (int k = 0; k < 2; k++)
                            samples[count][k] = turned(own[i][k], shift[k]);
                    }
                assert_int_equal(count, 1 << m);
                assert_net(m);
            }
    }
}

/* Any 4 x 4 pixels, wherever they begin, have the 16 n samples of one Hammersley set: i / 16 n,
 * each once, with mirrored bits. */
/* As the GLSL has it: set k is shifted by sample k n, too. The sets of a pixel from 0 on are one
 * net, and so is each set of a tile. */
static void sets_of_frames_are_nets(void **state)
{
    (void)state;
    enum { COUNT = 8, SETS = 16, LOG_COUNT = 3, LOG_SETS = 4, LOG_PIXELS = 6 };
    static double sobol[SETS * COUNT][2];
    const IndirectSequence of = {KEYWORD_Sequence_sobol, KEYWORD_Rotation_tile, COUNT};
    assert_int_equal(indirect_sequence_block(&of), COUNT);
    assert_int_equal(indirect_sequence_block(&(IndirectSequence){of.sequence, of.rotation, 5}), 8);
    indirect_sequence_samples(of.sequence, SETS * COUNT, sobol);
    for (int one = 0; one < 2; one++) /* of a pixel, of a set */
        for (int fixed = 0; fixed < SETS; fixed++) {
            const int others = one ? 64 : SETS;
            for (int i = 0; i < others * COUNT; i++) {
                const int pixel = one ? i / COUNT : fixed, set = one ? fixed : i / COUNT;
                double shift[3];
                indirect_sequence_shift(&of, pixel % 8, pixel / 8, shift);
                for (int k = 0; k < 2; k++)
                    samples[i][k] =
                        turned(turned(sobol[i % COUNT][k], shift[k]), sobol[set * COUNT][k]);
            }
            assert_net(LOG_COUNT + (one ? LOG_PIXELS : LOG_SETS));
        }
}

static void tiles_of_hammersley_are_one_set(void **state)
{
    (void)state;
    const IndirectSequence of = {KEYWORD_Sequence_hammersley, KEYWORD_Rotation_tile, 8};
    static double own[MOST][2];
    indirect_sequence_samples(of.sequence, of.count, own);
    for (int at = 0; at < 16; at++) {
        for (int p = 0; p < 16; p++) {
            double shift[3];
            indirect_sequence_shift(&of, at % 4 + p % 4, at / 4 + p / 4, shift);
            for (int i = 0; i < of.count; i++)
                for (int k = 0; k < 2; k++)
                    samples[8 * p + i][k] = fmod(own[i][k] + shift[k] + 1e-12, 1);
        }
        static int seen[2][128];
        memset(seen, 0, sizeof seen);
        for (int i = 0; i < 128; i++) {
            seen[0][(int)(samples[i][0] * 128)]++;
            seen[1][(int)(samples[i][1] * 16)]++;
        }
        for (int i = 0; i < 128; i++)
            assert_true(seen[0][i] == 1 && (i >= 16 || seen[1][i] == 8));
    }
}

/* The blue noise shifts are three uncorrelated values of the mask; `none` and `random` have no
 * table. */
static void blue_noise_and_none(void **state)
{
    (void)state;
    const IndirectSequence blue = {KEYWORD_Sequence_sobol, KEYWORD_Rotation_blue, 8};
    const int edge = indirect_sequence_edge(&blue);
    double product[3] = {0};
    for (int i = 0; i < edge * edge; i++) {
        double shift[3];
        indirect_sequence_shift(&blue, i % edge, i / edge, shift);
        for (int k = 0; k < 3; k++) {
            assert_true(shift[k] > 0 && shift[k] < 1);
            product[k] += 12 * (shift[k] - .5) * (shift[(k + 1) % 3] - .5) / (edge * edge);
        }
    }
    for (int k = 0; k < 3; k++)
        assert_true(fabs(product[k]) < .06);
    assert_int_equal(indirect_sequence_edge(
                         &(IndirectSequence){KEYWORD_Sequence_sobol, KEYWORD_Rotation_none, 8}),
                     0);
    assert_int_equal(indirect_sequence_edge(
                         &(IndirectSequence){KEYWORD_Sequence_sobol, KEYWORD_Rotation_random, 8}),
                     0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(sequences_are_as_they_are_published),
                                       cmocka_unit_test(thirds_are_of_other_bases),
                                       cmocka_unit_test(sets_are_nets),
                                       cmocka_unit_test(tiles_of_sobol_are_nets),
                                       cmocka_unit_test(sets_of_frames_are_nets),
                                       cmocka_unit_test(tiles_of_hammersley_are_one_set),
                                       cmocka_unit_test(blue_noise_and_none)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
