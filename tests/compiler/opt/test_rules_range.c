/* The optimizer's rules that use intervals, on both sides of their borders. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/opt/opt.h"
#include "tests/rule_case.h"

/* Rules of opt_range, with the intervals of fract, [0, 1], and of sums and products of it, which
 * may exceed theirs by a rounding. */
static const RuleCase ranges[] = {
    {"clamp(fract(x), 0, 1)", "fract(x)"},
    {"clamp(fract(x), 0, 0.999)", NULL},
    {"clamp(fract(x), 1, 2)", "1"},
    {"clamp(fract(x), 0.999, 2)", NULL},
    {"clamp(fract(x), -2, 0)", "0"},
    {"clamp(fract(x), -2, 0.001)", NULL},
    {"clamp(fract(x), 0.001, 1)", NULL},
    {"clamp(x, 0, 1)", NULL},
    /* component by component: of all of them */
    {"max(vec2(fract(x), 7), [0, 7])", "vec2(fract(x), 7)"},
    {"max(vec2(7, fract(x)), 0.5)", NULL},
    {"max(vec2(fract(x), 7), 0.5)", NULL},
    {"max(vec2(fract(x), 7), [1, 8])", "[1, 8]"},
    /* one number alone, but where a rounding might make it another */
    {"mix(vec2(x, 3), vec2(y, 3), z).y", "3"},
    {"floor(add(mul(fract(x), 0.5), 0.25))", NULL},
    {"add(floor(add(mul(fract(x), 0.5), 0.25)), 2)", NULL},
    {"clamp(sin(x), -1, 1)", "sin(x)"},
    {"clamp(sin(x), -1, 0.999)", NULL},
    {"clamp(noise(v), -1, 1)", "noise(v)"},
    {"clamp(mul(fract(x), 2), 0, 2)", NULL}, /* a rounding may pass the bound */
    {"clamp(mul(fract(x), 2), 0, 2.00001)", NULL},
    {"clamp(mul(fract(x), 2), 0, 2.00003)", "mul(fract(x), 2)"},
    {"clamp(add(fract(x), 1), 1, 3)", NULL},
    {"clamp(add(fract(x), 1), 0.999, 3)", "add(fract(x), 1)"},
    {"clamp(fract(x), fract(y), 2)", NULL}, /* the bound may be 1 */
    {"clamp(add(fract(x), 1.5), fract(y), 3)", "add(fract(x), 1.5)"},
    {"clamp(fract(x), 0, add(fract(y), 0.5))", NULL}, /* the bound may be 0.5 */
    {"clamp(fract(x), 0, add(fract(y), 1))", "fract(x)"},
    {"clamp(fract(x), [0, 0], [1, 1])", NULL}, /* a vec2 stays one */
    {"max(fract(x), 0)", "fract(x)"},
    {"max(fract(x), 0.001)", NULL},
    {"max(fract(x), 1)", "1"},
    {"max(fract(x), 0.999)", NULL},
    {"max(fract(x), sub(fract(y), 0.5))", NULL}, /* which may be 0.5 */
    {"max(fract(x), fract(y))", NULL},
    {"max(fract(x), [0, 0])", NULL},
    {"max(fract(x), [1, 1])", "[1, 1]"},
    {"max(fract(x), add(fract(y), 1))", "add(fract(y), 1)"},
    {"max(fract(x), add(fract(y), 0.5))", NULL},
    {"min(fract(x), 1)", "fract(x)"},
    {"min(fract(x), 0.999)", NULL},
    {"min(fract(x), 0)", "0"},
    {"min(fract(x), 0.001)", NULL},
    {"min(fract(x), add(fract(y), 0.5))", NULL}, /* which may be 0.5 */
    {"min(fract(x), fract(y))", NULL},
    {"min(fract(x), add(fract(y), 1))", "fract(x)"},
    {"min(fract(x), [1, 1])", NULL},
    {"step(fract(x), 1)", "1"},
    {"step(fract(x), 0.999)", NULL},
    {"step(0, fract(x))", "1"},
    {"step(0.001, fract(x))", NULL},
    {"step(1.001, fract(x))", "0"},
    {"step(1, fract(x))", NULL}, /* it may be 1 */
    {"lt(fract(x), 1.001)", "true"},
    {"lt(fract(x), 1)", NULL},
    {"lt(0, fract(x))", NULL}, /* it may be 0 */
    {"lt(-0.001, fract(x))", "true"},
    {"lt(fract(x), -0.001)", "false"},
    {"lt(1.001, fract(x))", "false"},
    {"lt(fract(x), 0.5)", NULL},
    {"le(fract(x), 1.001)", "true"},
    {"le(fract(x), 0)", NULL}, /* it may be 0 */
    {"le(1, fract(x))", NULL},
    {"le(-0.001, fract(x))", "true"},
    {"le(fract(x), -0.001)", "false"},
    {"le(1.001, fract(x))", "false"},
    {"eq(fract(x), 2)", NULL},
};

static void ranges_decide_on_this_side_of_the_border(void **state)
{
    (void)state;
    assert_int_equal(RULE_CHECK(ranges, opt_range, false), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ranges_decide_on_this_side_of_the_border),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
