/* Constants of sums and products are collected, with each sign and on each side; and cases in
 * which they must not be. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/opt/opt.h"
#include "tests/rule_case.h"

static const RuleCase sums[] = {
    {"add(add(x, 2), 3)", "add(x, 5)"},
    {"add(sub(x, 2), 3)", "add(x, 1)"},
    {"add(sub(x, 3), 2)", "sub(x, 1)"},
    {"add(sub(2, x), 3)", "sub(5, x)"},
    {"sub(add(x, 2), 3)", "sub(x, 1)"},
    {"sub(sub(x, 2), 3)", "sub(x, 5)"},
    {"sub(sub(2, x), 3)", "sub(-1, x)"},
    {"sub(2, add(x, 3))", "sub(-1, x)"},
    {"sub(2, sub(x, 3))", "sub(5, x)"},
    {"sub(2, sub(3, x))", "sub(x, 1)"},
    {"sub(3, sub(2, x))", "add(x, 1)"},
    {"sub(add(x, 2), 2)", "x"},
    {"sub(add(x, 0.3), 0.1)", "add(x, 0.2)"},
    {"add(sub(add(x, 0.45), 0.5), 0.05)", "x"}, /* 0.45 - 0.5 + 0.05 is 2.7e-17 in double */
    {"add(add(x, [1, 2, 3]), 2)", "add(x, [3, 4, 5])"},
    {"sub(add(v, 2), [1, 2, 3])", "add(v, [1, 0, -1])"},
    {"mul(add(add(x, 2), 3), add(x, 2))", NULL}, /* x + 2 is wanted itself */
    {"add(add(x, 2), y)", NULL},
    {"add(add(x, y), 2)", NULL},
    {"sub(add(x, 2e15), 1e15)", NULL},
};

static const RuleCase products[] = {
    {"mul(mul(x, 6), 4)", "mul(x, 24)"},
    {"mul(mul(mul(x, 20), 4), 0.5)", "mul(x, 40)"},
    {"div(mul(x, 6), 3)", "mul(x, 2)"},
    {"mul(div(x, 3), 6)", "mul(x, 2)"},
    {"div(div(x, 3), 5)", "div(x, 15)"},
    {"mul(mul(x, [1, 2, 3]), 2)", "mul(x, [2, 4, 6])"},
    {"mul(mul(v, 3), [2, 4, 6])", "mul(v, [6, 12, 18])"},
    {"mul(div(3, x), 5)", NULL},
    {"div(3, mul(x, 5))", NULL},
    {"div(3, div(x, 5))", NULL},
    {"div(6, div(3, x))", NULL},
    {"add(mul(mul(x, 6), 4), mul(x, 6))", NULL}, /* 6 x is wanted itself */
    {"mul(mul(x, 1e-16), 3)", NULL},
    {"mul(mul(x, 1e16), 3)", NULL},
    {"mul(mul(x, y), 3)", NULL},
    {"mul(add(x, 2), 3)", NULL},
};

static void constants_come_together(void **state)
{
    (void)state;
    int failed = RULE_CHECK(sums, opt_polish, true);
    failed += RULE_CHECK(products, opt_polish, true);
    assert_int_equal(failed, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constants_come_together),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
