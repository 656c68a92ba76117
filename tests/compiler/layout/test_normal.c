/* The table of normal encodings: mean, root mean square and greatest error in degrees over two
 * million random directions, against measured figures. The encodings are the C references, in
 * double precision; test_codes compares the GLSL with them. */
/* ctest: seconds=10 */
#include "tests/test.h"
#include "compiler/library/normal.h"
#include "compiler/library/pack.h"
#include "compiler/library/reference.h"
#include "tests/value/normals.h"

enum { DIRECTIONS = 2000000 };

/* All to a hundredth. */
static void errors_are_those_of_the_table(void **state)
{
    (void)state;
    int wrong = 0;
    print_message("%-36s %10s %10s %10s\n", "degrees", "mean", "rms", "greatest");
    for (int i = 0; i < normal_rows; i++) {
        const NormalRow *row = &normal_table[i];
        NormalAngles a = normals_measure(row, DIRECTIONS);
        bool fine = normals_off(a.mean, row->mean) <= 0.01 &&
                    normals_off(a.rms, row->rms) <= 0.01 &&
                    (normals_are_singular(row) || normals_off(a.maximum, row->maximum) <= 0.01);
        print_message("%-36s %10.5f %10.5f %10.5f%s\n", row->name, a.mean, a.rms, a.maximum,
                      fine ? "" : " differs");
        wrong += !fine;
    }
    assert_int_equal(wrong, 0);
}

/* Every code of 8 and 12 bits: its direction has that code, but on the folded border, where it has
 * that direction. */
static void every_code_is_its_own(void **state)
{
    (void)state;
    for (int bits = 8; bits <= 12; bits += 4) {
        int levels = octahedral_levels(bits);
        for (int x = 0; x < levels; x++)
            for (int y = 0; y < levels; y++) {
                double n[3], again[3];
                int code[2];
                normal_octahedral_decode((int[2]){x, y}, levels, n);
                normal_octahedral_encode(n, levels, code);
                if (code[0] == x && code[1] == y)
                    continue;
                normal_octahedral_decode(code, levels, again);
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
        normal_octahedral_decode((int[2]){x, y}, levels, n);
        normal_octahedral_encode(n, levels, code);
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
            normal_octahedral_encode(n, octahedral_levels(bits), code);
            normal_octahedral_decode(code, octahedral_levels(bits), back);
            for (int component = 0; component < 3; component++)
                assert_true(back[component] == n[component]);
        }
    double back[3];
    int code[2];
    normal_octahedral_encode((double[3]){0, 0, 0}, 255, code);
    normal_octahedral_decode(code, 255, back);
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
