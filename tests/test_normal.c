/* The table of normal encodings: mean, rms and greatest error in degrees over two million random directions, beside measured
 * figures. The encodings are the C references, in double precision; test_codes holds the GLSL to them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "runtime/lib/normal.h"
#include "runtime/lib/pack.h"
#include "runtime/reference.h"

enum { DIRECTIONS = 2000000 };

typedef enum { OCTAHEDRAL, PRECISE, SPHEREMAP, OCTAHEDRAL_HALVES, SPHEREMAP_HALVES } Method;

/* 0: not compared. The greatest error of a spheremap on the whole sphere depends on how near a direction comes to the singular
 * one: its figure holds to two hundredths, all others to one. */
typedef struct {
    const char *name;
    Method method;
    int levels; /* codes a coordinate */
    bool hemisphere;
    double mean, rms, greatest;
} Row;

static const Row rows[] = {
    {"octahedral 6, 63 levels", OCTAHEDRAL, 63, false, 1.379, 1.520, 3.895},
    {"octahedral 7, 128 levels", OCTAHEDRAL, 128, false, 0.6735, 0.7421, 1.907},
    {"precise 7, 128 levels", PRECISE, 128, false, 0.6294, 0.6759, 1.269},
    {"spheremap 7", SPHEREMAP, 128, false, 0.980, 1.377, 16.8},
    {"spheremap 7, hemisphere", SPHEREMAP, 128, true, 0.707, 0.761, 1.781},
    {"octahedral 8, 255 levels", OCTAHEDRAL, 255, false, 0.3368, 0.371, 0.949},
    {"octahedral 8, 256 levels", OCTAHEDRAL, 256, false, 0.3357, 0.370, 0.947},
    {"precise 8, 255 levels", PRECISE, 255, false, 0.3147, 0.3380, 0.6330},
    {"octahedral, 247 levels", OCTAHEDRAL, 247, false, 0.3475, 0.3829, 0.983},
    {"spheremap 8", SPHEREMAP, 256, false, 0.492, 0.720, 11.65},
    {"spheremap 8, hemisphere", SPHEREMAP, 256, true, 0.352, 0.379, 0.888},
    {"octahedral 10", OCTAHEDRAL, 1023, false, 0.0836, 0.0921, 0.236},
    {"precise 10", PRECISE, 1023, false, 0.0782, 0.0840, 0.158},
    {"octahedral 12", OCTAHEDRAL, 4095, false, 0.0209, 0.0230, 0.0591},
    {"precise 12", PRECISE, 4095, false, 0.0195, 0.0210, 0.0394},
    {"octahedral 15", OCTAHEDRAL, 32767, false, 0.00261, 0.00288, 0.0074},
    {"octahedral 16", OCTAHEDRAL, 65535, false, 0.00131, 0.00144, 0.0037},
    {"precise 16", PRECISE, 65535, false, 0.00122, 0.00131, 0.00247},
    {"spheremap 16", SPHEREMAP, 65536, false, 0.00195, 0, 0},
    {"spheremap 16, hemisphere", SPHEREMAP, 65536, true, 0.00137, 0, 0.0034},
    {"octahedral in two halves", OCTAHEDRAL_HALVES, 0, false, 0.0150, 0.0176, 0.0585},
    {"spheremap in two halves", SPHEREMAP_HALVES, 0, false, 0.0419, 0, 0},
    {"spheremap in two halves, hemisphere", SPHEREMAP_HALVES, 0, true, 0.0324, 0, 0.108},
};

/* A number in [0, 1). */
static double random_number(uint64_t *seed)
{
    *seed += 0x9E3779B97F4A7C15u;
    uint64_t z = *seed;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}

static void random_direction(uint64_t *seed, bool hemisphere, double n[3])
{
    double z = random_number(seed), angle = 2 * M_PI * random_number(seed);
    n[2] = hemisphere ? z : 2 * z - 1;
    double radius = sqrt(1 - n[2] * n[2]);
    n[0] = radius * cos(angle);
    n[1] = radius * sin(angle);
}

static void halve(double e[2])
{
    for (int i = 0; i < 2; i++)
        e[i] = half_value(half_bits(e[i]));
}

static void there_and_back(const Row *row, const double n[3], double back[3])
{
    double e[2];
    int code[2];
    switch (row->method) {
    case OCTAHEDRAL:
        octahedral_encode(n, row->levels, code);
        octahedral_decode(code, row->levels, back);
        break;
    case PRECISE:
        octahedral_encode_precise(n, row->levels, code);
        octahedral_decode(code, row->levels, back);
        break;
    case SPHEREMAP:
        spheremap_encode(n, row->levels, code);
        spheremap_decode(code, row->levels, back);
        break;
    case OCTAHEDRAL_HALVES:
        octahedral_map(n, e);
        halve(e);
        octahedral_unmap(e, back);
        break;
    case SPHEREMAP_HALVES:
        spheremap_map(n, e);
        halve(e);
        spheremap_unmap(e, back);
        break;
    }
}

/* Within a share of the figure, or half of its last digit. */
static bool is_near(double measured, double figure, double share)
{
    const double last_digit = 5e-6;
    return figure == 0 || fabs(measured - figure) <= share * figure + last_digit;
}

static void errors_are_those_of_the_table(void **state)
{
    (void)state;
    int wrong = 0;
    print_message("%-36s %10s %10s %10s\n", "degrees", "mean", "rms", "greatest");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const Row *row = &rows[i];
        uint64_t seed = 1;
        double sum = 0, squares = 0, greatest = 0;
        for (int k = 0; k < DIRECTIONS; k++) {
            double n[3], back[3];
            random_direction(&seed, row->hemisphere, n);
            there_and_back(row, n, back);
            double angle = normal_angle(n, back);
            sum += angle;
            squares += angle * angle;
            greatest = fmax(greatest, angle);
        }
        double mean = sum / DIRECTIONS, rms = sqrt(squares / DIRECTIONS);
        bool singular = row->method == SPHEREMAP && !row->hemisphere;
        bool fine = is_near(mean, row->mean, 0.01) && is_near(rms, row->rms, 0.01) &&
                    is_near(greatest, row->greatest, singular ? 0.02 : 0.01);
        print_message("%-36s %10.5f %10.5f %10.5f%s\n", row->name, mean, rms, greatest, fine ? "" : " differs");
        wrong += !fine;
    }
    assert_int_equal(wrong, 0);
}

/* Every code of 8 and 12 bits: its direction has that code, but on the folded border, where it has that direction. */
static void every_code_is_its_own(void **state)
{
    (void)state;
    for (int bits = 8; bits <= 12; bits += 4) {
        int levels = octahedral_levels(bits);
        for (int x = 0; x < levels; x++)
            for (int y = 0; y < levels; y++) {
                double n[3], again[3];
                int code[2];
                octahedral_decode((int[2]){x, y}, levels, n);
                octahedral_encode(n, levels, code);
                if (code[0] == x && code[1] == y)
                    continue;
                octahedral_decode(code, levels, again);
                assert_true(x == 0 || y == 0 || x == levels - 1 || y == levels - 1);
                assert_true(normal_angle(n, again) < 1e-9);
            }
    }
}

/* 16 bits: a sweep of 2^24 of the 2^32 codes, by steps that meet all of each coordinate. */
static void codes_of_16_bits_are_their_own(void **state)
{
    (void)state;
    int levels = octahedral_levels(16);
    for (int i = 0; i < 1 << 24; i++) {
        int x = 1 + i % (levels - 2), y = 1 + (int)(i * 40503u % (unsigned)(levels - 2)), code[2];
        double n[3];
        octahedral_decode((int[2]){x, y}, levels, n);
        octahedral_encode(n, levels, code);
        assert_true(code[0] == x && code[1] == y);
    }
}

static void axes_and_nothing(void **state)
{
    (void)state;
    for (int bits = 2; bits <= 16; bits++)
        for (int i = 0; i < 6; i++) {
            double n[3] = {0}, back[3];
            int code[2];
            n[i / 2] = i % 2 ? -1 : 1;
            octahedral_encode(n, octahedral_levels(bits), code);
            octahedral_decode(code, octahedral_levels(bits), back);
            for (int lane = 0; lane < 3; lane++)
                assert_true(back[lane] == n[lane]);
        }
    double back[3];
    int code[2];
    octahedral_encode((double[3]){0, 0, 0}, 255, code);
    octahedral_decode(code, 255, back);
    assert_true(back[2] == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_are_those_of_the_table),
        cmocka_unit_test(every_code_is_its_own),
        cmocka_unit_test(codes_of_16_bits_are_their_own),
        cmocka_unit_test(axes_and_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
