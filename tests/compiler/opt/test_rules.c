/* Every local rule of the optimizer, where it applies and where it must not: on the border of
 * its guard, and just outside. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/opt/opt.h"
#include "tests/rule_case.h"

static const RuleCase signs[] = {
    {"neg(neg(x))", "x"},     {"neg(sub(x, y))", "sub(y, x)"}, {"neg(add(x, y))", NULL},
    {"neg(abs(x))", NULL},    {"abs(abs(x))", "abs(x)"},       {"abs(neg(x))", "abs(x)"},
    {"abs(sub(x, y))", NULL}, {"abs(floor(x))", NULL},
};

static const RuleCase wholes[] = {
    {"floor(floor(x))", "floor(x)"}, {"floor(ceil(x))", "ceil(x)"},
    {"floor(fract(x))", NULL},       {"floor(abs(x))", NULL},
    {"ceil(ceil(x))", "ceil(x)"},    {"ceil(floor(x))", "floor(x)"},
    {"ceil(fract(x))", NULL},        {"ceil(neg(x))", NULL},
    {"fract(fract(x))", "fract(x)"}, {"fract(floor(x))", "0"},
    {"fract(ceil(v))", "[0, 0, 0]"}, {"fract(abs(x))", NULL},
    {"fract(neg(x))", NULL},         {"fract(sign(x))", NULL},
};

static const RuleCase sums[] = {
    {"add(x, 0)", "x"},
    {"add(0, x)", "x"},
    {"add(x, [0, 0])", "v.xx"},
    {"add(v, 0)", "v"},
    {"add(v, [0, 0, 1])", NULL},
    {"add(x, neg(y))", "sub(x, y)"},
    {"add(neg(x), y)", "sub(y, x)"},
    {"add(x, -2)", "sub(x, 2)"},
    {"add(x, 2)", NULL},
    {"add(v, [-1, -2, -3])", "sub(v, [1, 2, 3])"},
    {"add(v, [-1, -2, 0])", NULL}, /* 0 is not below 0 */
    {"add(v, [0, -2, -1])", NULL},
    {"add(v, [-1, 2, -3])", NULL},
    {"add(2, x)", "add(x, 2)"},
    {"add(x, y)", NULL},
    {"add(y, x)", "add(x, y)"},
    {"sub(x, 0)", "x"},
    {"sub(0, x)", "neg(x)"},
    {"sub([0, 0], x)", "neg(v.xx)"},
    {"sub(x, x)", "0"},
    {"sub(v, v)", "[0, 0, 0]"},
    {"sub(x, y)", NULL},
    {"sub(x, neg(y))", "add(x, y)"},
    {"sub(neg(x), y)", NULL},
    {"sub(x, -2)", "add(x, 2)"},
    {"sub(x, 2)", NULL},
    {"sub(1, sub(1, x))", "x"},
    {"sub([1, 1, 1], sub(1, x))", "v.xxx"},
    {"sub(1, sub([1, 1, 1], v))", "v"},
    {"sub(2, sub(1, x))", "add(x, 1)"},
    {"sub(1, sub(2, x))", "sub(x, 1)"},
    {"sub(1, sub([1, 1, 2], v))", "add(v, [0, 0, -1])"},
    {"sub(1, sub(x, 1))", "sub(2, x)"},
    {"sub(1, add(x, 1))", "neg(x)"},
    {"sub(v, [-1, 0, -3])", NULL},
};

static const RuleCase products[] = {
    {"mul(x, 1)", "x"},
    {"mul(1, x)", "x"},
    {"mul(x, [1, 1, 1])", "v.xxx"},
    {"mul(v, [1, 1, 2])", NULL},
    {"mul(x, 0)", "0"},
    {"mul(0, v)", "[0, 0, 0]"},
    {"mul(v, [0, 0, 2])", NULL},
    {"mul(x, -1)", "neg(x)"},
    {"mul(-1, v)", "neg(v)"},
    {"mul(x, -2)", NULL},
    {"mul(neg(x), neg(y))", "mul(x, y)"},
    {"mul(neg(x), y)", NULL},
    {"mul(neg(x), 2)", NULL},
    {"mul(2, x)", "mul(x, 2)"},
    {"mul(y, x)", "mul(x, y)"},
};

/* Only powers of two have exact inverses, and of those only the ones whose inverse a float
 * holds. */
static const RuleCase quotients[] = {
    {"div(x, 1)", "x"},
    {"div(0, x)", "0"},
    {"div(x, 2)", "mul(x, 0.5)"},
    {"div(x, 0.125)", "mul(x, 8)"},
    {"div(x, -4)", "mul(x, -0.25)"},
    {"div(x, 3)", NULL},
    {"div(x, 6)", NULL},
    {"div(x, 0.1)", NULL},
    {"div(x, 0)", NULL},
    {"div(x, y)", NULL},
    {"div(1, x)", NULL},
    {"div(2, x)", NULL},
    {"div(x, x)", NULL}, /* of 0 it is none */
    {"div(v, [2, 4, 8])", "mul(v, [0.5, 0.25, 0.125])"},
    {"div(v, [2, 3, 4])", NULL},
    {"div(v, [2, 4, 5])", NULL},
    {"div(x, 0x1p98)", "mul(x, 3.155443621e-30)"},
    {"div(x, 0x1p99)", NULL},
    {"div(x, 0x1p-100)", "mul(x, 1.2676506e+30)"},
    {"div(x, 0x1p-101)", NULL},
};

static const RuleCase bounds[] = {
    {"min(x, x)", "x"},
    {"min(x, y)", NULL},
    {"min(2, x)", "min(x, 2)"},
    {"max(v, v)", "v"},
    {"max(x, y)", NULL},
    {"max(2, x)", "max(x, 2)"},
    {"mod(mod(x, 3), 3)", "mod(x, 3)"},
    {"mod(mod(x, y), y)", "mod(x, y)"},
    {"mod(mod(x, 3), 2)", NULL},
    {"mod(mod(x, 2), 3)", NULL}, /* true of positive divisors only */
    {"mod(fract(x), 1)", NULL},
    {"clamp(clamp(x, 0, 1), 0, 1)", "clamp(x, 0, 1)"},
    {"clamp(clamp(x, fract(y), 2), fract(y), 2)", "clamp(x, fract(y), 2)"},
    {"clamp(clamp(x, 0, 1), 0, 0.5)", NULL},
    {"clamp(clamp(x, 0, 1), 0.5, 1)", NULL},
    {"clamp(clamp(x, 0, 1), 2, 3)", NULL},
    {"clamp(x, y, y)", "y"},
    {"clamp(x, 0, 1)", NULL},
    {"clamp(v, x, x)", "v.xxx"},
    {"clamp(fract(x), 0, 1)", NULL}, /* for ranges */
    {"mix(x, y, 0)", "x"},
    {"mix(x, y, 1)", "y"},
    {"mix(x, x, y)", "x"},
    {"mix(x, v, 0)", "v.xxx"},
    {"mix(v, x, 1)", "v.xxx"},
    {"mix(x, y, 0.5)", NULL},
    {"mix(x, y, z)", NULL},
    {"mix(0, x, y)", "mul(x, y)"},
    {"mix(0, 1, x)", "x"},
    {"mix([0, 0, 0], x, y)", "mul(v.xxx, y)"},
    {"mix([0, 0, 0], w, x)", "mul(x, w)"},
    {"mix([0, 1, 0], w, x)", NULL},
    {"mix(1, x, y)", NULL},
    {"mix(1, 0, x)", "sub(1, x)"},
    {"mix([1, 1, 1], [0, 0, 0], x)", "sub([1, 1, 1], x)"},
    {"mix([1, 1, 0], [0, 0, 0], x)", NULL},
    {"mix(1, [0, 0, 0], x)", "sub([1, 1, 1], x)"},
    {"mix(x, 0, y)", NULL},
    {"mix(v, w, [0, 0, 1])", NULL},
    {"mix(v, w, [1, 0, 1])", NULL},
};

static const RuleCase vectors[] = {
    {"dot([0, 0, 0], v)", "0"},
    {"dot(v, [0, 0, 0])", "0"},
    {"dot(v, [2, 0, 0])", "mul(x, 2)"},
    {"dot(v, [0, 1, 0])", "y"},
    {"dot(v, [0, 0, -1])", "neg(z)"},
    {"dot(v, [1, 1, 0])", NULL},
    {"dot(v, [0, 2, 2])", NULL},
    {"dot(v, [1, 0, 1])", NULL},
    {"dot(v, w)", NULL},
    {"dot(vec3(sin(x), sin(x), sin(x)), [0.3333333333333333, 0.3333333333333333, "
     "0.3333333333333333])",
     "sin(x)"},
    {"dot(vec2(sin(x), sin(x)), [0.5, 0.5])", "sin(x)"},
    {"dot(vec3(sin(x), sin(x), sin(x)), [0.5, 0.5, 0.5])", NULL},
    {"dot(vec3(sin(x), sin(x), sin(y)), [0.3333333333333333, 0.3333333333333333, "
     "0.3333333333333333])",
     NULL},
    {"dot(vec3(sin(x), sin(y), sin(x)), [0.3333333333333333, 0.3333333333333333, "
     "0.3333333333333333])",
     NULL},
    {"dot(vec3(sin(x), sin(x), sin(x)), [0.3333333333333333, 0.3333333333333333, 0.25])", NULL},
    {"length(neg(v))", "length(v)"},
    {"length(abs(v))", NULL},
    {"length(sub(v, w))", NULL},
    {"cross(v, v)", NULL},
    {"v.xyz", "v"},
    {"v.xzy", NULL},
    {"v.xx", NULL},
    {"v.zyx.xy", "v.zy"},
    {"v.zyx.z", "x"},
    {"vec3(x, y, z)", "v"},
    {"vec2(x, z)", "v.xz"},
    {"vec3(y, x, z)", "v.yxz"},
    {"vec2(x, w.y)", NULL},
    {"vec3(u, 1).z", "1"},
    {"vec3(u, x).xy", "u"},
    {"vec3(u, x).yx", "u.yx"},
    {"vec3(x, u).z", "u.y"},
    {"vec3(x, u).xz", "vec2(x, u.y)"},
    {"vec4(vec2(x, 1), vec2(w.y, 2))", "vec4(x, 1, w.y, 2)"},
    {"mul(v, [1, 0, 2]).y", "0"},
    {"add(v, [1, 0, 2]).y", "y"},
    {"mul(v, w).x", "mul(w.x, x)"},
    {"floor(v).zx", "floor(v.zx)"},
    {"select(front, v, w).y", "select(front, y, w.y)"},
    {"mix(v, w, x).y", "mix(y, w.y, x)"},
    /* a component that both have, whichever it is mixed by or chosen by */
    {"mix(vec4(v, 1), [4, 5, 6, 1], x).w", "1"},
    {"mix(vec4(v, 1), vec4(w, 1), vec4(x, y, z, x)).w", "1"},
    {"mix(vec4(v, 1), vec4(w, 0.5), x).w", "mix(1, 0.5, x)"},
    {"mix(vec4(v, 1), vec4(w, x), y).w", "mix(1, x, y)"},
    {"select(front, vec4(v, 1), vec4(w, 1)).w", "1"},
    {"select(front, vec4(v, 1), vec4(w, 0.5)).w", "select(front, 1, 0.5)"},
    {"select(front, mix(vec4(v, 1), vec4(w, 1), x), vec4(w, 1)).w", "1"},
    {"sub(1, select(front, vec4(v, 1), vec4(w, 1))).w", "0"},
    {"cross(v, w).y", NULL},
    {"vec2(length(v), 2).x", "length(v)"},
};

static const RuleCase truths[] = {
    {"lt(x, x)", "false"},
    {"le(x, x)", "true"},
    {"eq(x, x)", "true"},
    {"ne(x, x)", "false"},
    {"lt(x, y)", NULL},
    {"le(x, y)", NULL},
    {"eq(x, y)", NULL},
    {"ne(x, y)", NULL},
    {"ne(front, false)", "front"},
    {"ne(false, front)", "front"},
    {"ne(front, true)", "not(front)"},
    {"ne(true, front)", "not(front)"},
    {"ne(x, 0)", NULL}, /* a number is no truth value */
    {"ne(0, x)", NULL},
    {"ne(x, 1)", NULL},
    {"ne(1, x)", NULL},
    {"not(not(front))", "front"},
    {"not(lt(x, y))", "le(y, x)"},
    {"not(le(x, y))", "lt(y, x)"},
    {"not(eq(x, y))", "ne(x, y)"},
    {"not(ne(x, y))", "eq(x, y)"},
    {"not(front)", NULL},
    {"not(and(front, lt(x, y)))", NULL},
    {"and(false, front)", "false"},
    {"and(front, false)", "false"},
    {"and(true, front)", "front"},
    {"and(front, true)", "front"},
    {"and(front, front)", "front"},
    {"and(front, lt(x, y))", NULL},
    {"or(true, front)", "true"},
    {"or(front, true)", "true"},
    {"or(false, front)", "front"},
    {"or(front, false)", "front"},
    {"or(front, front)", "front"},
    {"or(front, lt(x, y))", NULL},
};

static const RuleCase constants[] = {
    {"add(2, 3)", "5"},
    {"sub(2, 3)", "-1"},
    {"mul([1, 2, 3], 2)", "[2, 4, 6]"},
    {"div(1, 4)", "0.25"},
    {"div(1, 0)", NULL}, /* the shader decides */
    {"sqrt(-1)", NULL},
    {"log(0)", NULL},
    {"mod(-1, 3)", "2"},
    {"step(2, 2)", "1"},
    {"step(2, 1)", "0"},
    {"sign(-3)", "-1"},
    {"fract(-0.25)", "0.75"},
    {"ceil(-0.5)", "-0"},
    {"clamp(5, 0, 1)", "1"},
    {"clamp(-5, 0, 1)", "0"},
    {"mix(2, 4, 0.25)", "2.5"},
    {"min(2, 3)", "2"},
    {"max(2, 3)", "3"},
    {"lt(2, 2)", "false"},
    {"le(2, 2)", "true"},
    {"dot([1, 2, 3], [4, 5, 6])", "32"},
    {"cross([1, 2, 3], [4, 5, 7])", "[-1, 5, -3]"},
    {"length([3, 4, 12])", "13"},
    {"linear([1, 2], [3, 4], [5, 6])", "[13, 16]"},
    {"vec3([1, 2], 3)", "[1, 2, 3]"},
    {"[1, 2, 3].zx", "[3, 1]"},
    {"shift(3u, 4i)", "48u"},
    {"join(3u, 16u)", "19u"},
};

static const RuleCase selects[] = {
    {"select(true, x, y)", "x"},
    {"select(false, x, y)", "y"},
    {"select(front, x, x)", "x"},
    {"select(front, x, y)", NULL},
    {"select(not(front), x, y)", "select(front, y, x)"},
    {"select(front, select(front, x, y), z)", "select(front, x, z)"},
    {"select(front, x, select(front, y, z))", "select(front, x, z)"},
    {"select(front, select(lt(x, y), x, y), z)", NULL},
    {"select(front, x, select(lt(x, y), y, z))", NULL},
    {"mul(select(front, 1, 3), 2)", "select(front, 2, 6)"},
    {"sub(5, select(front, 1, 3))", "select(front, 4, 2)"},
    {"sub(select(front, 9, 8), select(front, 1, 3))", "select(front, 8, 5)"},
    {"lt(select(front, 1, 3), 2)", "select(front, true, false)"},
    {"abs(select(front, 2, -2))", "2"},
    {"sub(select(front, 9, 8), select(lt(x, y), 1, 3))", NULL},
    {"mul(select(front, 1, x), 2)", NULL},
    {"mul(select(front, 1, 3), x)", NULL},
    {"div(1, select(front, 0, 4))", NULL},
    {"phongExponent(select(front, 1, 1))", "65504"},
};

#define SQUARE(a) "mul(" a ", " a ")"
#define POWER_64  SQUARE(SQUARE(SQUARE(SQUARE(SQUARE(SQUARE("x"))))))

static const RuleCase powers[] = {
    {"pow(x, 0)", "1"},
    {"pow(v, 0)", NULL},
    {"pow(x, 1)", "x"},
    {"pow(x, 2)", "mul(x, x)"},
    {"pow(x, 3)", "mul(mul(x, x), x)"},
    {"pow(x, 4)", "mul(mul(x, x), mul(x, x))"},
    {"pow(x, 6)", "mul(mul(mul(x, x), mul(x, x)), mul(x, x))"},
    {"pow(x, -1)", "div(1, x)"},
    {"pow(x, -2)", "div(1, mul(x, x))"},
    {"pow(x, 0.5)", "sqrt(x)"},
    {"pow(v, 0.5)", "sqrt(v)"},
    {"pow(x, -0.5)", NULL},
    {"pow(x, 2.5)", NULL},
    {"pow(x, 64)", POWER_64},
    {"pow(x, -64)", "div(1, " POWER_64 ")"},
    {"pow(x, 65)", NULL},
    {"pow(x, -65)", NULL},
    {"pow(x, y)", NULL},
    {"pow(2, x)", NULL},
    {"pow(v, [2, 2, 2])", NULL},
};

static void local_rules_apply_where_they_may(void **state)
{
    (void)state;
    int failed = 0;
    failed += RULE_CHECK(signs, opt_polish, true);
    failed += RULE_CHECK(wholes, opt_polish, true);
    failed += RULE_CHECK(sums, opt_polish, true);
    failed += RULE_CHECK(products, opt_polish, true);
    failed += RULE_CHECK(quotients, opt_polish, true);
    failed += RULE_CHECK(bounds, opt_polish, true);
    failed += RULE_CHECK(vectors, opt_polish, true);
    failed += RULE_CHECK(truths, opt_polish, true);
    failed += RULE_CHECK(constants, opt_polish, true);
    failed += RULE_CHECK(selects, opt_polish, true);
    failed += RULE_CHECK(powers, opt_polish, true);
    assert_int_equal(failed, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(local_rules_apply_where_they_may),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
