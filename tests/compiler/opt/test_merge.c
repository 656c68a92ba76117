/* opt_merge: the value of a pattern that is its gradient's fourth component is not computed a
 * second time. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/opt/opt.h"
#include "tests/rule_case.h"

/* Gradients of a pattern at points p and its values at points q, each with a weight of its own, all
 * in one sum: a value is its gradient's fourth component where q is p, and nowhere else. So many
 * that their places in any table are taken. */
enum { GRADIENTS = 300 };

static Ref point_of(Ir *ir, int number)
{
    const double at[4] = {number, .25 * number, -number};
    return build_add(ir, build_input(ir, INPUT_X), ir_const(ir, TYPE_vec3, at));
}

static Ref sum_of_gradients(Ir *ir)
{
    Ref sum = build_all(ir, TYPE_float, 0);
    for (int i = 0; i < GRADIENTS; i++) {
        int moved = i % 2 ? 0 : GRADIENTS;
        Ref slope = build_call(ir, FN_leopardGradient, point_of(ir, i));
        Ref value = build_call(ir, FN_FIRST_MAP + KIND_Leopard, point_of(ir, i + moved));
        Ref weight = ir_const(ir, TYPE_float, (double[4]){i + 1});
        sum = build_add(ir, sum, build_mul(ir, build_swizzle(ir, slope, "x"), value));
        sum = build_add(ir, sum, build_mul(ir, weight, value));
    }
    return sum;
}

static int live_values(const Ir *ir)
{
    Arena arena = {0};
    const uint8_t *live = ir_live(ir, &arena);
    int count = 0;
    for (Ref ref = 1; ref < ir->count; ref++)
        count += live[ref] && ir_is(ir, ref, OP_call) &&
                 ir_at(ir, ref)->payload == FN_FIRST_MAP + KIND_Leopard;
    arena_free(&arena);
    return count;
}

static void a_gradient_gives_its_own_value_only(void **state)
{
    (void)state;
    Site sites[2];
    for (int i = 0; i < 2; i++) {
        site_open(&sites[i]);
        ir_output(sites[i].ir, OUT_color, 0, sum_of_gradients(sites[i].ir));
        assert_int_equal(live_values(sites[i].ir), GRADIENTS);
    }
    assert_true(opt_merge(sites[1].ir));
    assert_null(ir_check(sites[1].ir));
    assert_int_equal(live_values(sites[1].ir), GRADIENTS / 2);
    rule_check_values("gradients", sites[0].ir, sites[1].ir);
    site_close(&sites[0]);
    site_close(&sites[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_gradient_gives_its_own_value_only),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
