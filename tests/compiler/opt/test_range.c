/* Intervals against values: the result of an operation lies within its claimed interval, for any
 * intervals of its operands, ends included, and the claimed interval is no wider than necessary.
 * Neither goldens nor the optimizer take part. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/ir/build.h"
#include "compiler/ir/range.h"
#include "tests/stress/choices.h"
#include "tests/value/expression.h"
#include "tests/value/ir_site.h"
#include <string.h>

static const double loosened = 3e-5; /* what range.c adds for drivers, twice and a little more */

/* -- one operation */

/* Meaning of the operation in GLSL. */
static double meaning(Op op, double a, double b, double c)
{
    switch (op) {
    case OP_neg:
        return 0 - a;
    case OP_abs:
        return a < 0 ? -a : a;
    case OP_floor:
        return floor(a);
    case OP_ceil:
        return ceil(a);
    case OP_fract:
        return a - floor(a);
    case OP_sign:
        return a > 0 ? 1 : a < 0 ? -1 : 0;
    case OP_sqrt:
        return sqrt(a);
    case OP_exp:
        return exp(a);
    case OP_exp2:
        return exp2(a);
    case OP_log:
        return log(a);
    case OP_sin:
        return sin(a);
    case OP_cos:
        return cos(a);
    case OP_tan:
        return tan(a);
    case OP_asin:
        return asin(a);
    case OP_acos:
        return acos(a);
    case OP_atan:
        return atan(a);
    case OP_add:
        return a + b;
    case OP_sub:
        return a - b;
    case OP_mul:
        return a * b;
    case OP_div:
        return a / b;
    case OP_min:
        return a < b ? a : b;
    case OP_max:
        return a > b ? a : b;
    case OP_step:
        return b < a ? 0 : 1;
    case OP_mod:
        return a - b * floor(a / b);
    case OP_pow:
        return pow(a, b);
    case OP_atan2:
        return atan2(a, b);
    case OP_clamp:
        return fmin(fmax(a, b), c);
    case OP_mix:
        return a * (1 - c) + b * c;
    default:
        fail_msg("%s: no meaning", op_table[op].name);
        return 0;
    }
}

/* How near the claim has to be to what values reach: ends are met, or lie within [low, high], or
 * may be anything. */
typedef enum { MET, FIXED, ANY } Tightness;

typedef struct {
    Op op;
    double low, high; /* of the first operand: where the operation has a value */
    Tightness tightness;
    Interval fixed;
} Case;

static const Case cases[] = {
    {OP_neg, -1000, 1000, MET, {0, 0}},    {OP_abs, -1000, 1000, MET, {0, 0}},
    {OP_floor, -1000, 1000, MET, {0, 0}},  {OP_ceil, -1000, 1000, MET, {0, 0}},
    {OP_sign, -1000, 1000, MET, {0, 0}},   {OP_sqrt, 0, 1000, MET, {0, 0}},
    {OP_exp, -80, 80, MET, {0, 0}},        {OP_exp2, -80, 80, MET, {0, 0}},
    {OP_log, 1e-3, 1000, MET, {0, 0}},     {OP_atan, -1000, 1000, MET, {0, 0}},
    {OP_tan, -1.49, 1.49, MET, {0, 0}},    {OP_add, -1000, 1000, MET, {0, 0}},
    {OP_sub, -1000, 1000, MET, {0, 0}},    {OP_mul, -1000, 1000, MET, {0, 0}},
    {OP_min, -1000, 1000, MET, {0, 0}},    {OP_max, -1000, 1000, MET, {0, 0}},
    {OP_clamp, -1000, 1000, MET, {0, 0}},  {OP_mix, -1000, 1000, ANY, {0, 0}},
    {OP_pow, 0, 1000, MET, {0, 0}},        {OP_fract, -1000, 1000, FIXED, {0, 1}},
    {OP_step, -1000, 1000, FIXED, {0, 1}}, {OP_sin, -1000, 1000, FIXED, {-1, 1}},
    {OP_cos, -1000, 1000, FIXED, {-1, 1}}, {OP_asin, -1, 1, FIXED, {-1.5708, 1.5708}},
    {OP_acos, -1, 1, FIXED, {0, 3.1416}},  {OP_atan2, -1000, 1000, FIXED, {-3.1416, 3.1416}},
};

static const double borders[] = {-1000, -3, -2.5, -1, -0.5, 0, 0.25, 0.5, 1, 1.5, 2, 3, 100};
enum { ENDS = sizeof borders / sizeof *borders, TRIES = 300, SAMPLES = 300 };

static Interval random_interval(Choices *c, double low, double high)
{
    double a = fmin(fmax(borders[choose(c, ENDS)], low), high),
           b = fmin(fmax(borders[choose(c, ENDS)], low), high);
    return (Interval){fmin(a, b), fmax(a, b)};
}

/* The borders most often, 0 and 1 where they are inside, else anything. */
static double inside(Choices *c, Interval range)
{
    double some = range.low + choose_part(c) * (range.high - range.low);
    double special[] = {range.low, range.high, range.low, range.high, 0, 1, some, some};
    double x = special[choose(c, 8)];
    return x < range.low || x > range.high ? some : x;
}

static Interval sampled(Choices *c, Op op, const Interval *of, bool square)
{
    Interval met = {INFINITY, -INFINITY};
    for (int i = 0; i < SAMPLES * op_table[op].arity * op_table[op].arity; i++) {
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] = inside(c, of[k]);
        double value = meaning(op, x[0], square ? x[0] : x[1], x[2]);
        met = (Interval){fmin(met.low, value), fmax(met.high, value)};
    }
    return met;
}

static double size_of(double x) { return fmax(fabs(x), 1); }

static void check_claim(const Case *c, const Interval *of, Interval claimed, Interval met)
{
    bool sound = claimed.low <= met.low + 1e-12 * size_of(met.low) &&
                 claimed.high >= met.high - 1e-12 * size_of(met.high);
    Interval least = c->tightness == FIXED ? c->fixed : met;
    bool tight = claimed.low >= least.low - loosened * size_of(least.low) &&
                 claimed.high <= least.high + loosened * size_of(least.high);
    if (!sound || (c->tightness != ANY && !tight))
        fail_msg("%s of [%g, %g] [%g, %g] [%g, %g]: claimed [%.9g, %.9g], met [%.9g, %.9g]",
                 op_table[c->op].name, of[0].low, of[0].high, of[1].low, of[1].high, of[2].low,
                 of[2].high, claimed.low, claimed.high, met.low, met.high);
}

/* The interval that is claimed of op(x, y, z), or of op(x, x, z), when those have the given
 * ones. */
static Interval claim(Site *s, Op op, const Interval *of, bool square)
{
    Ref args[3] = {expression_read(s->ir, "x"), expression_read(s->ir, "y"),
                   expression_read(s->ir, "z")};
    if (square)
        args[1] = args[0];
    Ref ref =
        ir_make(s->ir, (IrNode){.op = op, .type = TYPE_float, .count = op_table[op].arity}, args);
    Ranges ranges = {.of = ARENA_ARRAY(&s->arena, Interval, s->ir->count),
                     .place = ARENA_ARRAY(&s->arena, RangePlace, s->ir->count),
                     .count = (Ref)s->ir->count,
                     .components = 1};
    for (int k = op_table[op].arity - 1; k >= 0; k--) {
        ranges.place[args[k]].first = args[k];
        ranges.of[args[k]] = of[k];
    }
    return range_computed(&ranges, s->ir, ref, 0);
}

static void random_operands(Choices *c, const Case *of, Interval operands[3])
{
    double most = of->op == OP_pow ? 3 : 1000, least = of->op == OP_pow ? 0 : -1000;
    operands[0] = random_interval(c, of->low, of->high);
    operands[1] = random_interval(c, least, most);
    operands[2] = random_interval(c, -1000, 1000);
    /* GLSL wants the lower bound below the upper */
    if (of->op == OP_clamp && operands[1].high > operands[2].low)
        operands[2] = (Interval){operands[1].high, fmax(operands[2].high, operands[1].high)};
}

static void check_case(const Case *c, Choices *choices, bool square)
{
    Site site;
    Interval of[3];
    choices->count = 0;
    site_open(&site);
    random_operands(choices, c, of);
    Interval claimed = claim(&site, c->op, of, square);
    check_claim(c, of, claimed, sampled(choices, c->op, of, square));
    site_close(&site);
}

static void intervals_hold_and_are_no_wider_than_values(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Choices choices;
        choices_random(&choices, 5, i);
        for (int n = 0; n < TRIES; n++)
            check_case(&cases[i], &choices, cases[i].op == OP_mul && n % 4 == 0);
    }
}

/* -- whole expressions */

typedef struct {
    const char *text;
    int components; /* intervals kept: 1, or one for each component */
    int component;
    double low, high;
} Known;

/* Worked out by hand; an end that range.c loosens is met to 3e-5. */
static const Known known[] = {
    /* a clamp that always saturates is a point, on whichever side */
    {"clamp(fract(x), 2, 3)", 1, 0, 2, 2},
    {"clamp(fract(x), -3, -2)", 1, 0, -2, -2},
    {"clamp(fract(x), 1, 3)", 1, 0, 1, 1},
    {"clamp(x, -2, 3)", 1, 0, -2, 3},
    {"clamp(10, 0, add(fract(x), 2))", 1, 0, 2, 3},
    {"clamp(-10, sub(fract(x), 3), 0)", 1, 0, -3, -2},
    /* divisors that hold 0, touch it, or keep away */
    {"div(fract(x), clamp(y, 2, 4))", 1, 0, 0, 0.5},
    {"div(clamp(x, 1, 2), clamp(y, -4, -2))", 1, 0, -1, -0.25},
    {"div(fract(x), clamp(y, 0, 4))", 1, 0, -INFINITY, INFINITY},
    {"div(fract(x), clamp(y, -4, 0))", 1, 0, -INFINITY, INFINITY},
    {"div(fract(x), y)", 1, 0, -INFINITY, INFINITY},
    /* a tangent that may pass its pole; vector products, a component and all of them */
    {"tan(clamp(x, 1, 2))", 1, 0, -INFINITY, INFINITY},
    {"cross(vec3(fract(x), 2, 3), vec3(4, 5, fract(y)))", 4, 2, -8, -3},
    {"cross(vec3(fract(x), 2, 3), vec3(4, 5, fract(y)))", 4, 0, -15, -13},
    {"cross(vec3(fract(x), 0, 0), vec3(0, fract(y), 0))", 1, 0, -1, 1},
    /* a remainder of what is within the divisor is the value itself */
    {"mod(clamp(x, 0.25, 1.5), 2)", 1, 0, 0.25, 1.5},
    {"mod(clamp(x, 0.25, 2), 2)", 1, 0, 0, 2}, /* 2 leaves 0 */
    {"mod(clamp(x, -0.25, 1.5), 2)", 1, 0, 0, 2},
    {"mod(x, clamp(y, 2, 5))", 1, 0, 0, 5},
    {"mod(clamp(x, 0, 3), clamp(y, 2, 5))", 1, 0, 0, 5},
    {"mod(x, clamp(y, -1, 5))", 1, 0, -INFINITY, INFINITY},
    {"log(fract(x))", 1, 0, -INFINITY, INFINITY},
    {"sqrt(sub(fract(x), 0.5))", 1, 0, 0, 0.70710678},
    {"pow(sub(fract(x), 0.5), 2)", 1, 0, -INFINITY, INFINITY},
    {"pow(add(mul(fract(x), 3.5), 0.5), 2)", 1, 0, 0.25, 16},
    {"pow(add(mul(fract(x), 3.5), 0.5), sub(fract(y), 0.5))", 1, 0, -INFINITY, INFINITY},
    /* mix goes beyond its ends when its weight does */
    {"mix(1, 5, fract(x))", 1, 0, 1, 5},
    {"mix(1, 5, mul(fract(x), 2))", 1, 0, 1, 9},
    {"mix(5, 1, sub(fract(x), 1))", 1, 0, 5, 9},
    {"mix(3, 3, fract(x))", 1, 0, 3, 3}, /* but for equal ones */
    {"mix(vec2(x, 3), vec2(y, 3), z)", 4, 1, 3, 3},
    {"mix(vec2(x, 3), vec2(y, 4), z)", 4, 1, -INFINITY, INFINITY},
    /* vectors: together, and component by component */
    {"vec2(fract(x), add(fract(y), 3))", 1, 0, 0, 4},
    {"vec2(fract(x), add(fract(y), 3))", 4, 0, 0, 1},
    {"vec2(fract(x), add(fract(y), 3))", 4, 1, 3, 4},
    {"vec3(vec2(fract(x), 7), add(fract(y), 3))", 4, 1, 7, 7},
    {"vec3(vec2(fract(x), 7), add(fract(y), 3))", 4, 2, 3, 4},
    {"vec3(9, vec2(fract(x), 7))", 4, 2, 7, 7},
    {"vec3(fract(x), 7, 8).zy", 4, 0, 8, 8},
    {"vec3(fract(x), 7, 8).zx", 4, 1, 0, 1},
    {"mul([1, 2, 3], fract(x))", 4, 2, 0, 3},
    {"mul([1, 2, 3], fract(x))", 1, 0, 0, 3},
    {"[1, -2, 3]", 1, 0, -2, 3},
    {"[1, -2, 3]", 4, 1, -2, -2},
    {"dot(vec2(fract(x), 2), [3, -1])", 4, 0, -2, 1},
    {"dot(vec3(fract(x), fract(y), 2), [1, 1, 1])", 1, 0, 0,
     6}, /* three components of up to 2 each */
    {"length(vec2(mul(fract(x), 3), 4))", 4, 0, 0, 5},
    {"length(vec2(fract(x), 3))", 1, 0, 0, 4.24264069},
    {"linear(vec2(fract(x), fract(y)), [1, 10], [2, -20])", 4, 0, 0, 3},
    {"linear(vec2(fract(x), fract(y)), [1, 10], [2, -20])", 4, 1, -20, 10},
    {"linear(vec2(fract(x), 3), [1, 10], [2, -20])", 4, 1, -60, -50},
    /* an arm is bounded by what its condition says */
    {"select(lt(clamp(x, 0, 10), 1), clamp(x, 0, 10), 5)", 4, 0, 0, 5},
    {"select(lt(clamp(x, 0, 10), 7), clamp(x, 0, 10), 5)", 4, 0, 0, 7},
    {"select(lt(clamp(x, 0, 10), 1), 5, clamp(x, 0, 10))", 4, 0, 1, 10},
    {"select(lt(1, clamp(x, 0, 10)), clamp(x, 0, 10), 5)", 4, 0, 1, 10},
    {"select(lt(1, clamp(x, 0, 10)), 0.5, clamp(x, 0, 10))", 4, 0, 0, 1},
    {"select(le(clamp(x, 0, 10), 1), clamp(x, 0, 10), 0.5)", 4, 0, 0, 1},
    {"select(le(1, clamp(x, 0, 10)), clamp(x, 0, 10), 5)", 4, 0, 1, 10},
    {"select(lt(clamp(x, 0, 10), 1), add(clamp(x, 0, 10), 2), mul(clamp(x, 0, 10), 3))", 4, 0, 2,
     30},
    {"select(lt(clamp(x, 0, 10), 1), mul(clamp(x, 0, 10), 3), sub(clamp(x, 0, 10), 2))", 4, 0, -1,
     8},
    {"select(lt(clamp(x, 0, 10), 0), 100, 5)", 4, 0, 5, 100}, /* an end counts to both sides */
    {"select(lt(clamp(x, 0, 10), -1), 100, 5)", 4, 0, 5, 5},  /* never taken */
    {"select(lt(clamp(x, 0, 10), 11), 100, 5)", 4, 0, 100, 100},
    /* one interval a node: without */
    {"select(lt(clamp(x, 0, 10), 1), clamp(x, 0, 10), 5)", 1, 0, 0, 10},
    /* with nothing constant */
    {"select(lt(clamp(x, 0, 10), clamp(y, 0, 10)), clamp(x, 0, 10), 5)", 4, 0, 0, 10},
    {"select(front, clamp(x, 0, 10), 20)", 4, 0, 0, 20},
    {"select(lt(clamp(x, 0, 10), 6), select(lt(2, clamp(x, 0, 10)), clamp(x, 0, 10), 3), 4)", 4, 0,
     2, 6},
    {"select(lt(clamp(x, 0, 10), 1), select(lt(5, clamp(x, 0, 10)), 99, 0.5), 0.25)", 4, 0, 0.25,
     0.5},
    /* functions: octaves of noise in [-1, 1], exponents */
    {"turbulence(v, 1i, 2, 0.5)", 1, 0, -1, 1},
    {"turbulence(v, 3i, 2, 0.5)", 1, 0, -1.75, 1.75},
    {"turbulence(v, 3i, 2, -2)", 1, 0, -7, 7},
    {"turbulence(v, 0i, 2, 0.5)", 1, 0, -1, 1},
    {"turbulence(v, 2i, 2, fract(x))", 1, 0, -2, 2},
    {"turbulence(v, 65i, 2, 0.5)", 1, 0, -INFINITY, INFINITY},
    {"turbulence(v, 3i, 2, x)", 1, 0, -INFINITY, INFINITY},
    {"noise(v)", 1, 0, -1, 1},
    {"wood(v)", 1, 0, 0, INFINITY},
    {"phongExponent(x)", 1, 0, 0, 65504},
};

static bool is_near(double got, double wanted)
{
    return got == wanted || (isfinite(wanted) && fabs(got - wanted) <= loosened * size_of(wanted));
}

static void intervals_of_expressions_are_those_worked_out(void **state)
{
    (void)state;
    int failed = 0;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        Site site;
        site_open(&site);
        Ref ref = expression_read(site.ir, known[i].text);
        assert_int_not_equal(ref, 0);
        Ranges ranges = range_find(site.ir, &site.arena, known[i].components);
        Interval got = range_of(&ranges, site.ir, ref, known[i].component);
        if (!is_near(got.low, known[i].low) || !is_near(got.high, known[i].high)) {
            print_error("%s lane %d of %d: [%.9g, %.9g] instead of [%.9g, %.9g]\n", known[i].text,
                        known[i].component, known[i].components, got.low, got.high, known[i].low,
                        known[i].high);
            failed++;
        }
        site_close(&site);
    }
    assert_int_equal(failed, 0);
}

/* A sum over the kernel is 27 times, an application once, what the function may be. */
static void functions_of_the_program_have_the_range_of_their_result(void **state)
{
    (void)state;
    for (int components = 1; components <= 4; components += 3) {
        Site s;
        Ref arguments[1], args[1];
        site_open(&s);
        ir_arguments(s.ir, 0, (Type[]){TYPE_vec3}, 1, arguments);
        Ref result = build_sub(s.ir, build_fract(s.ir, arguments[0]), build_float(s.ir, 0.25));
        int function = ir_function(s.ir, arguments, 1, result);
        args[0] = expression_read(s.ir, "v");
        Ref once = build_apply(s.ir, function, args),
            kernel = build_kernel(s.ir, function, args, args[0]);
        Ranges ranges = range_find(s.ir, &s.arena, components);
        Interval one = range_of(&ranges, s.ir, once, 1), all = range_of(&ranges, s.ir, kernel, 1);
        assert_true(one.low == -0.25 && one.high == 0.75);
        assert_true(all.low == -0.25 * 27 && all.high == 0.75 * 27);
        site_close(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(intervals_hold_and_are_no_wider_than_values),
        cmocka_unit_test(intervals_of_expressions_are_those_worked_out),
        cmocka_unit_test(functions_of_the_program_have_the_range_of_their_result),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
