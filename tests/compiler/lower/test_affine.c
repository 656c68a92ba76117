/* --coordinates=long: a coordinate transformed by constant sums, products, matrices, swizzles
 * and negations in any order keeps its integer part and fraction far from the origin. The
 * reference is a matrix and an offset in long double that the test carries along. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/ir/fold.h"
#include "compiler/lower/footprint.h"
#include "compiler/opt/opt.h"
#include "compiler/pipeline.h"
#include "tests/value/evaluate.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COMPONENTS = 3, TRIALS = 3000, MAX_STEPS = 12, LONG_CHAIN = 400, POINTS = 4 };

/* row . root + offset for each component. */
typedef struct {
    long double row[COMPONENTS][COMPONENTS], offset[COMPONENTS];
} Exact;

typedef struct {
    Arena arena;
    MatcOptions options;
    Session session;
    Graph graph;
    Job job;
    Lower l;
    Ref value;
    Exact exact;
    uint64_t random;
} Trial;

static double next(Trial *t)
{
    t->random = t->random * 6364136223846793005u + 1442695040888963407u;
    return (double)(t->random >> 11) * 0x1p-53;
}

static int choose(Trial *t, int count) { return (int)(next(t) * count); }

/* A factor of either sign, and about 1, so that long chains neither grow without end nor vanish. */
static double factor(Trial *t) { return (choose(t, 2) ? 1 : -1) * (0.8 + 0.45 * next(t)); }

static void open_trial(Trial *t, uint64_t seed, bool simplify)
{
    *t = (Trial){.random = seed * 0x9E3779B97F4A7C15u + 1};
    matc_options_init(&t->options);
    t->options.coordinates = "long";
    t->options.pass = "value";
    assert_null(choice_job(&t->options, &t->job));
    t->session = (Session){
        .options = &t->options, .arena = &t->arena, .optimize = simplify ? 2 : 0, .check = true};
    t->l = (Lower){.session = &t->session,
                   .graph = &t->graph,
                   .ir = ir_new(&t->session, &t->graph),
                   .job = &t->job};
    t->l.ir->simplify = simplify ? opt_simplify : NULL;
    t->value = build_input(t->l.ir, INPUT_X);
    for (int i = 0; i < COMPONENTS; i++)
        t->exact.row[i][i] = 1;
}

static void close_trial(Trial *t)
{
    ir_done(t->l.ir);
    arena_free(&t->arena);
}

static void step_sum(Trial *t)
{
    double shift[COMPONENTS] = {factor(t), factor(t), factor(t)};
    Ref constant = ir_const(t->l.ir, TYPE_vec3, shift);
    int form = choose(t, 4); /* x + k, k + x, x - k, k - x */
    Ref a = form % 2 ? constant : t->value, b = form % 2 ? t->value : constant;
    t->value = build_binary(t->l.ir, form < 2 ? OP_add : OP_sub, a, b);
    for (int i = 0; i < COMPONENTS; i++) {
        for (int k = 0; form == 3 && k < COMPONENTS; k++)
            t->exact.row[i][k] *= -1;
        t->exact.offset[i] = (form == 3 ? -1 : 1) * t->exact.offset[i] +
                             (form == 2 ? -1 : 1) * (long double)shift[i];
    }
}

static void scale_component(Trial *t, int component, double by)
{
    t->exact.offset[component] *= by;
    for (int k = 0; k < COMPONENTS; k++)
        t->exact.row[component][k] *= by;
}

static void step_product(Trial *t)
{
    double by[COMPONENTS] = {factor(t), factor(t), factor(t)};
    bool one = choose(t, 2), first = choose(t, 2);
    Ref constant = one ? build_float(t->l.ir, by[0]) : ir_const(t->l.ir, TYPE_vec3, by);
    t->value =
        build_mul_of(t->l.ir, first ? (Ref[]){constant, t->value} : (Ref[]){t->value, constant});
    for (int i = 0; i < COMPONENTS; i++)
        scale_component(t, i, by[one ? 0 : i]);
}

static void step_sign(Trial *t)
{
    t->value = build_neg(t->l.ir, t->value);
    for (int i = 0; i < COMPONENTS; i++)
        scale_component(t, i, -1);
}

static void step_matrix(Trial *t)
{
    double column[COMPONENTS][COMPONENTS]; /* a rotation, a little off */
    double angle = 6.28 * next(t), stretch = 0.9 + 0.2 * next(t);
    int axis = choose(t, 3);
    memset(column, 0, sizeof column);
    column[axis][axis] = stretch;
    int i = (axis + 1) % 3, k = (axis + 2) % 3;
    column[i][i] = cos(angle);
    column[k][k] = cos(angle) * stretch;
    column[i][k] = sin(angle);
    column[k][i] = -sin(angle);
    Ref args[] = {t->value, ir_const(t->l.ir, TYPE_vec3, column[0]),
                  ir_const(t->l.ir, TYPE_vec3, column[1]), ir_const(t->l.ir, TYPE_vec3, column[2])};
    t->value = build_linear(t->l.ir, args, 4);
    Exact before = t->exact;
    for (int row = 0; row < COMPONENTS; row++) {
        t->exact.offset[row] = 0;
        for (int c = 0; c < COMPONENTS; c++) {
            t->exact.offset[row] += column[c][row] * before.offset[c];
            t->exact.row[row][c] = 0;
            for (int j = 0; j < COMPONENTS; j++)
                t->exact.row[row][c] += column[j][row] * before.row[j][c];
        }
    }
}

/* Components in another order, one of them now and then taken twice, from a vector or one by one.
 */
static void step_components(Trial *t)
{
    static const char letters[] = "xyz";
    int from[COMPONENTS] = {choose(t, 3), 0, 0};
    from[1] = (from[0] + 1 + choose(t, 2)) % 3;
    from[2] = choose(t, 4) ? 3 - from[0] - from[1] : from[0];
    char all[] = {letters[from[0]], letters[from[1]], letters[from[2]], 0};
    if (choose(t, 2)) {
        t->value = build_swizzle(t->l.ir, t->value, all);
    } else {
        Ref pair = build_swizzle(t->l.ir, t->value, (char[]){all[0], all[1], 0});
        Ref last = build_swizzle(t->l.ir, t->value, (char[]){all[2], 0});
        t->value = build_vec(t->l.ir, TYPE_vec3, pair, last);
    }
    Exact before = t->exact;
    for (int i = 0; i < COMPONENTS; i++) {
        t->exact.offset[i] = before.offset[from[i]];
        memcpy(t->exact.row[i], before.row[from[i]], sizeof before.row[0]);
    }
}

static void step(Trial *t)
{
    static void (*const steps[])(Trial * t) = {step_sum, step_product, step_sign, step_matrix,
                                               step_components};
    steps[choose(t, sizeof steps / sizeof *steps)](t);
}

static bool is_power(long double x)
{
    int exponent;
    return fabsl(frexpl(x, &exponent)) == 0.5L;
}

/* A float of the root comes through as it is: nothing to gain. */
static bool nothing_rounds(const Exact *exact)
{
    for (int i = 0; i < COMPONENTS; i++) {
        int terms = 0;
        for (int k = 0; k < COMPONENTS; k++) {
            terms += exact->row[i][k] != 0;
            if (exact->row[i][k] != 0 && !is_power(exact->row[i][k]))
                return false;
        }
        if (terms > 1 || (terms && exact->offset[i] != 0))
            return false;
    }
    return true;
}

/* The factors that the program multiplies a float's halves with have 12 bits, so that every product
 * is exact. */
static void check_bits(const Ir *ir, Ref call)
{
    for (int i = 1; i < ir_at(ir, call)->count; i++)
        for (int component = 0; i % 3 != 0 && component < COMPONENTS; component++) {
            int exponent;
            double bits =
                ldexp(frexp(ir_numbers(ir, ir_arg(ir, call, i))[component], &exponent), 12);
            assert_true(bits == trunc(bits));
        }
}

static void check_point(Trial *t, double scale, const double point[COMPONENTS])
{
    double inputs[INPUT_COUNT][4] = {{0}}, result[MAX_OUTPUTS][4];
    for (int i = 0; i < COMPONENTS; i++)
        inputs[INPUT_X][i] = point[i];
    ir_eval(t->l.ir, &(ReferenceContext){.noise = REFERENCE_LATTICE}, (const double(*)[4])inputs,
            result);
    for (int i = 0; i < COMPONENTS; i++) {
        long double want = t->exact.offset[i], size = fabsl(want);
        for (int k = 0; k < COMPONENTS; k++) {
            want += t->exact.row[i][k] * point[k];
            size += fabsl(t->exact.row[i][k] * point[k]);
        }
        long double found = (long double)result[0][i] + result[1][i],
                    allowed = 1e-12L * (1 + size) * (long double)scale;
        assert_true(result[0][i] == nearbyint(result[0][i]) && fabs(result[1][i]) <= 0.5 + 1e-9);
        if (fabsl(found - want * scale) > allowed)
            fail_msg("lane %d: %.17Lg, exactly %.17Lg", i, found, want * (long double)scale);
    }
}

static void check(Trial *t, double scale)
{
    LongCoordinate parts;
    bool is_long = affine_coordinate(&t->l, t->value, scale, &parts);
    assert_int_equal(is_long, !nothing_rounds(&t->exact));
    if (!is_long)
        return;
    ir_output(t->l.ir, OUT_color, 0, parts.whole);
    ir_output(t->l.ir, OUT_color, 1, parts.fraction);
    assert_null(ir_check(t->l.ir));
    check_bits(t->l.ir, parts.whole);
    for (int i = 0; i < POINTS; i++)
        check_point(t, scale,
                    (double[]){(float)(1e5 * factor(t)), (float)(3e4 * factor(t)),
                               (float)(7e3 * factor(t))});
}

static void whole_and_fraction_are_exact(void **state)
{
    (void)state;
    for (int i = 0; i < TRIALS; i++) {
        Trial t;
        open_trial(&t, (uint64_t)i, i % 2);
        for (int steps = 1 + choose(&t, MAX_STEPS); steps > 0; steps--)
            step(&t);
        check(&t, i % 3 ? 2 : 1);
        close_trial(&t);
    }
}

/* However long the chain is, it is followed to where it starts. */
static void long_chains_are_followed(void **state)
{
    (void)state;
    for (int i = 0; i < 20; i++) {
        Trial t;
        open_trial(&t, (uint64_t)(1000000 + i), false);
        for (int steps = 0; steps < LONG_CHAIN; steps++)
            step_sum(&t), step_sign(&t), step_components(&t);
        step_matrix(&t);
        check(&t, 1);
        close_trial(&t);
    }
}

typedef struct {
    double factor[COMPONENTS], offset[COMPONENTS];
    bool gains;
} Border;

/* By component, x factor + offset: a power of two alone is exact, with an offset it is not. */
static void what_is_exact_is_left(void **state)
{
    (void)state;
    static const Border borders[] = {
        {{1, 1, 1}, {0, 0, 0}, false},     {{2, 4, 0.5}, {0, 0, 0}, false},
        {{-2, 1, 1}, {0, 0, 0}, false},    {{2, 2, 3}, {0, 0, 0}, true},
        {{1, 1, 1}, {0, 0, 1}, true},      {{1, 1, 1}, {0.5, 0, 0}, true},
        {{1, 1.0625, 1}, {0, 0, 0}, true}, {{0, 2, 2}, {5, 0, 0}, false},
        {{0, 2, 2}, {5, 1, 0}, true},
    };
    for (size_t i = 0; i < sizeof borders / sizeof *borders; i++) {
        Trial t;
        open_trial(&t, i, false);
        Ref by = ir_const(t.l.ir, TYPE_vec3, borders[i].factor),
            shift = ir_const(t.l.ir, TYPE_vec3, borders[i].offset);
        t.value = build_add(t.l.ir, build_mul(t.l.ir, t.value, by), shift);
        for (int component = 0; component < COMPONENTS; component++) {
            scale_component(&t, component, borders[i].factor[component]);
            t.exact.offset[component] += borders[i].offset[component];
        }
        assert_int_equal(nothing_rounds(&t.exact), !borders[i].gains);
        check(&t, 1);
        close_trial(&t);
    }
}

/* Two components with a factor of 1 each: their sum rounds. */
static void sums_of_components_round(void **state)
{
    (void)state;
    Trial t;
    open_trial(&t, 0, false);
    Ref turned = build_swizzle(t.l.ir, t.value, "yzx");
    t.value = build_add(t.l.ir, t.value, turned);
    for (int i = 0; i < COMPONENTS; i++)
        t.exact.row[i][(i + 1) % COMPONENTS] += 1;
    check(&t, 1);
    close_trial(&t);
}

/* Values of two inputs have no one start; nor has the fourth component of a vector one that is
 * followed. */
static void other_starts_are_left(void **state)
{
    (void)state;
    Trial t;
    LongCoordinate parts;
    open_trial(&t, 0, false);
    Ref other = build_input(t.l.ir, INPUT_P),
        three = ir_const(t.l.ir, TYPE_vec3, (double[]){3, 3, 3});
    Ref both = build_mul(t.l.ir, build_add(t.l.ir, t.value, other), three);
    assert_true(affine_coordinate(&t.l, both, 1, &parts)); /* of their sum, as it is */
    assert_int_equal(ir_arg(t.l.ir, parts.whole, 0), ir_arg(t.l.ir, both, 0));
    Ref four = build_vec(t.l.ir, TYPE_vec4, t.value, build_swizzle(t.l.ir, other, "x"));
    Ref root = build_fract(t.l.ir, four), last = build_swizzle(t.l.ir, root, "wwx");
    Ref scaled = build_mul(t.l.ir, last, three);
    bool is_long = affine_coordinate(&t.l, scaled, 1, &parts);
    assert_false(is_long && ir_arg(t.l.ir, parts.whole, 0) != last);
    close_trial(&t);
}

/* Factors that no float holds are not followed: the rest starts from there. */
static void overflow_is_not_followed(void **state)
{
    (void)state;
    Trial t;
    LongCoordinate parts;
    open_trial(&t, 0, false);
    for (int i = 0; i < 21; i++)
        t.value = build_mul(t.l.ir, t.value, build_float(t.l.ir, 3e30));
    assert_true(affine_coordinate(&t.l, t.value, 2, &parts));
    assert_null(ir_check(t.l.ir));
    for (Ref ref = 1; ref < t.l.ir->count; ref++)
        for (int i = 0; ir_is(t.l.ir, ref, OP_const) && i < ir_components(t.l.ir, ref); i++)
            assert_true(fabs(ir_numbers(t.l.ir, ref)[i]) <= 3.5e38);
    close_trial(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_and_fraction_are_exact), cmocka_unit_test(long_chains_are_followed),
        cmocka_unit_test(what_is_exact_is_left),        cmocka_unit_test(sums_of_components_round),
        cmocka_unit_test(other_starts_are_left),        cmocka_unit_test(overflow_is_not_followed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
