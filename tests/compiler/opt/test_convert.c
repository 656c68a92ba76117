/* Conversions of numbers and vectors from one type to another. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/ir/build.h"
#include "compiler/ir/fold.h"
#include "tests/value/ir_site.h"
#include <math.h>

/* The conversion table: a number stands for all components, what is missing is 0 and alpha 1, a
 * mean stands for a vector. */
static void types_convert_by_the_table(void **state)
{
    (void)state;
    static const double from[] = {8, 4, 2, 1};
    static const Type types[] = {TYPE_float, TYPE_vec2, TYPE_vec3, TYPE_vec4};
    static const double wanted[4][4][4] = {{{8}, {8, 8}, {8, 8, 8}, {8, 8, 8, 1}},
                                           {{6}, {8, 4}, {8, 4, 0}, {8, 4, 0, 1}},
                                           {{14.0 / 3}, {8, 4}, {8, 4, 2}, {8, 4, 2, 1}},
                                           {{3.75}, {8, 4}, {8, 4, 2}, {8, 4, 2, 1}}};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++) {
            Site s;
            double value[MAX_OUTPUTS][4] = {{0}};
            const double inputs[INPUT_COUNT][4] = {{0}};
            site_open(&s);
            ir_output(s.ir, OUT_color, 0,
                      build_convert(s.ir, ir_const(s.ir, types[i], from), types[k]));
            assert_null(ir_check(s.ir));
            ir_eval(s.ir, &(ReferenceContext){.noise = REFERENCE_LATTICE}, inputs, value);
            for (int component = 0; component <= k; component++)
                assert_true(fabs(value[0][component] - wanted[i][k][component]) < 1e-12);
            site_close(&s);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(types_convert_by_the_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
