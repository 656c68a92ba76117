/* The derivative of every operation by every operand, and of every library function of
 * slopes.def, against finite differences of the folded operation or the C reference in double.
 * Operands vary alone and together. Points at a jump or a crease are skipped. */
#include "tests/test.h"
#include "compiler/ir/fold.h"
#include "compiler/pipeline.h"
#include "compiler/lower/slope.h"
#include "compiler/library/java_random.h"
#include "tests/value/cases.h"
#include <stdio.h>
#include <string.h>

enum { TRIES = 40, OPERANDS = 5, CALLS = 200 };

typedef struct {
    Arena arena;
    Session session;
    Job job;
    Lower l;
    uint64_t random;
    double bound, step; /* of a slope; of the differences */
    int compared, skipped;
} Test;

static double uniform(Test *t, double low, double high)
{
    return low + (high - low) * (.5 + .5 * (double)java_random_signed(&t->random));
}

static void begin(Test *t)
{
    static const Graph none;
    t->arena = (Arena){0};
    t->session = (Session){.arena = &t->arena};
    assert_null(choice_job(&(MatcOptions){.pass = "value", .derivatives = "analytic"}, &t->job));
    t->l = (Lower){
        .session = &t->session, .graph = &none, .ir = ir_new(&t->session, &none), .job = &t->job};
}

static void end(Test *t)
{
    ir_done(t->l.ir);
    arena_free(&t->arena);
}

/* base + rate u + other v. */
static Ref moving(Lower *l, Type type, const double base[4], const double rate[4],
                  const double other[4])
{
    Ref uv = build_input(l->ir, INPUT_U), u = build_swizzle(l->ir, uv, "x"),
        v = build_swizzle(l->ir, uv, "y");
    Ref at = ir_const(l->ir, type, base);
    at = build_add(l->ir, at, build_mul(l->ir, ir_const(l->ir, type, rate), u));
    return build_add(l->ir, at, build_mul(l->ir, ir_const(l->ir, type, other), v));
}

static void evaluate(Test *t, double u, double v, double result[MAX_OUTPUTS][4])
{
    const ReferenceContext context = {REFERENCE_LATTICE, call_textures};
    double inputs[INPUT_COUNT][4] = {{0}};
    inputs[INPUT_U][0] = u;
    inputs[INPUT_U][1] = v;
    ir_eval(t->l.ir, &context, (const double(*)[4])inputs, result);
}

/* The slope over steps h, and how far both sides are apart. */
static double over_steps(Test *t, int axis, int component, double h, double *apart)
{
    double at[5][MAX_OUTPUTS][4];
    for (int i = -2; i <= 2; i++)
        evaluate(t, axis ? 0 : i * h, axis ? i * h : 0, at[i + 2]);
    double behind = at[2][0][component] - at[1][0][component],
           ahead = at[3][0][component] - at[2][0][component];
    *apart = (ahead - behind) / h;
    return (8 * (ahead + behind) - (at[4][0][component] - at[0][0][component])) / (12 * h);
}

/* False: at a jump or a crease, or where doubles do not tell. Of a smooth value both sides are
 * apart in proportion to the step. */
static bool difference(Test *t, int axis, int component, double h, double *slope)
{
    const double wider = 2.7;
    double near, far, other = over_steps(t, axis, component, wider * h, &far);
    *slope = over_steps(t, axis, component, h, &near);
    double tolerance = .2 * t->bound * fmax(1, fabs(*slope)),
           crease = (wider * near - far) / (wider - 1);
    return fabs(crease) <= tolerance && fabs(other - *slope) <= tolerance;
}

/* Compares with the differences of either of two steps, because cells of fine octaves may begin
 * within one step. */
static void judge(Test *t, const char *what, int axis, int component, double got)
{
    double expected = 0;
    for (int i = 0; i < 2; i++) {
        if (!difference(t, axis, component, i ? t->step / 20 : t->step, &expected)) {
            t->skipped++;
            return;
        }
        if (fabs(got - expected) <= t->bound * fmax(1, fabs(expected))) {
            t->compared++;
            return;
        }
    }
    fail_msg("%s: d/d%c of lane %d is %.12g, by differences %.12g", what, axis ? 'v' : 'u',
             component, got, expected);
}

/* Compares slopes of the value by u and by v. */
static void compare(Test *t, Ref value, const char *name, int varying)
{
    Type type = ir_type(t->l.ir, value);
    double result[MAX_OUTPUTS][4];
    char what[64];
    ir_output(t->l.ir, OUT_color, 0, value);
    for (int d = 0; d < 2; d++) {
        Ref slope = slope_of(&t->l, value, d ? DIRECTION_v : DIRECTION_u);
        ir_output(t->l.ir, OUT_color, 1 + d, slope ? slope : build_all(t->l.ir, type, 0));
    }
    assert_null(ir_check(t->l.ir));
    evaluate(t, 0, 0, result);
    snprintf(what, sizeof what, "%s, operands %x vary", name, (unsigned)varying);
    for (int d = 0; d < 2; d++)
        for (int component = 0; component < type_table[type].components; component++)
            judge(t, what, d, component, result[1 + d][component]);
}

/* Range of an operand. */
static void operand_range(Op op, int operand, double *low, double *high)
{
    static const struct {
        Op op;
        int operand;
        double low, high;
    } ranges[] = {{OP_sqrt, 0, .1, 3},   {OP_log, 0, .1, 3},     {OP_asin, 0, -.9, .9},
                  {OP_acos, 0, -.9, .9}, {OP_tan, 0, -1.2, 1.2}, {OP_div, 1, .5, 2},
                  {OP_mod, 1, .3, 1},    {OP_pow, 0, .2, 2},     {OP_clamp, 1, -1.5, 0},
                  {OP_clamp, 2, .1, 1.5}};
    *low = -2;
    *high = 2;
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++)
        if (ranges[i].op == op && ranges[i].operand == operand) {
            *low = ranges[i].low;
            *high = ranges[i].high;
        }
}

static Ref random_operand(Test *t, Op op, int operand, Type type, bool varies)
{
    double low, high, base[4], rate[4] = {0}, other[4] = {0};
    operand_range(op, operand, &low, &high);
    for (int component = 0; component < 4; component++) {
        base[component] = uniform(t, low, high);
        rate[component] = varies ? uniform(t, -1, 1) : 0;
        other[component] = varies ? uniform(t, -1, 1) : 0;
    }
    return moving(&t->l, type, base, rate, other);
}

/* An operation on operands of these types. */
typedef struct {
    Op op;
    Type type;
    const Type *types;
    int count;
    uint32_t payload;
} Operation;

/* Checks an operation whose operands in the set `varying` vary. */
static void check_operation(Test *t, const Operation *o, int varying)
{
    Ref args[OPERANDS];
    begin(t);
    for (int i = 0; i < o->count; i++) {
        args[i] = random_operand(t, o->op, i, o->types[i], varying >> i & 1);
        if (o->op == OP_select && i == 0)
            args[i] = build_lt(t->l.ir, args[i], build_float(t->l.ir, 0));
    }
    compare(
        t,
        ir_make(t->l.ir,
                (IrNode){.op = o->op, .type = o->type, .count = o->count, .payload = o->payload},
                args),
        op_table[o->op].name, varying);
    end(t);
}

static void check_subsets(Test *t, Operation o)
{
    for (int varying = 1; varying < 1 << o.count; varying++)
        for (int i = 0; i < TRIES; i++)
            check_operation(t, &o, varying);
}

/* Checks by component: numbers, vectors, and numbers with a vector. */
static void check_components(Test *t, Op op)
{
    int count = op_table[op].arity;
    for (int vectors = 0; vectors < 1 << count; vectors++) {
        Type types[OPERANDS];
        for (int i = 0; i < count; i++)
            types[i] = vectors >> i & 1 ? TYPE_vec3 : TYPE_float;
        if (vectors && op_table[op].shape == SHAPE_call && count > 1 && vectors != (1 << count) - 1)
            continue; /* GLSL has few of these forms, and lowering makes none */
        check_subsets(t, (Operation){op, vectors ? TYPE_vec3 : TYPE_float, types, count, 0});
    }
}

/* Operations that do not work per component; false: the operation is a leaf, or has no slope of its
 * own. */
static bool check_special(Test *t, Op op)
{
    static const Type vectors[OPERANDS] = {TYPE_vec3, TYPE_vec3, TYPE_vec3, TYPE_vec3, TYPE_vec3};
    static const Type numbers[OPERANDS] = {TYPE_float, TYPE_float, TYPE_float, TYPE_float,
                                           TYPE_float};
    switch (op) {
    case OP_dot:
        return check_subsets(t, (Operation){op, TYPE_float, vectors, 2, 0}), true;
    case OP_cross:
        return check_subsets(t, (Operation){op, TYPE_vec3, vectors, 2, 0}), true;
    case OP_length:
        return check_subsets(t, (Operation){op, TYPE_float, vectors, 1, 0}), true;
    case OP_linear:
        return check_subsets(t, (Operation){op, TYPE_vec3, vectors, 4, 0}), true;
    case OP_vec:
        return check_subsets(t, (Operation){op, TYPE_vec3, numbers, 3, 0}), true;
    case OP_swizzle: /* .zx */
        return check_subsets(t, (Operation){op, TYPE_vec2, vectors, 1, 2}), true;
    case OP_select:
        return check_subsets(t, (Operation){op, TYPE_float, numbers, 3, 0}), true;
    default:
        return false;
    }
}

static void operations_have_the_slopes_of_all_operands(void **state)
{
    (void)state;
    Test t = {.random = java_random(14), .bound = 1e-7, .step = 1e-5};
    int checked = 0;
    for (int op = 0; op < OP_COUNT; op++) {
        bool by_component = op_table[op].rule == RULE_widest;
        if (by_component)
            check_components(&t, (Op)op);
        checked += by_component || check_special(&t, (Op)op);
    }
    print_message("%d operations, %d slopes, %d at jumps and creases\n", checked, t.compared,
                  t.skipped);
    assert_true(t.compared > 50 * t.skipped);
}

/* An argument of a call: the row's own varies, one of any size in proportion to that, and the
 * others do not. */
static Ref argument(Test *t, char letter, const float components[4], const Argument *form,
                    bool varies)
{
    static const Type types[] = {
        ['f'] = TYPE_float, ['2'] = TYPE_vec2, ['3'] = TYPE_vec3, ['4'] = TYPE_vec4};
    double base[4], rate[4] = {0}, other[4] = {0}, size = 1;
    for (int i = 0; i < 4; i++) {
        base[i] = (double)components[i];
        size = form->form == FORM_wide ? fmax(size, fabs(base[i])) : 1;
    }
    for (int i = 0; i < 4; i++) {
        rate[i] = varies ? uniform(t, -size, size) : 0;
        other[i] = varies ? uniform(t, -size, size) : 0;
    }
    if (letter == 's')
        return build_leaf(t->l.ir, OP_texture, TYPE_sampler, (int)base[0]);
    if (letter == 'i')
        return build_int(t->l.ir, base[0]);
    Type type = types[(int)letter];
    return varies ? moving(&t->l, type, base, rate, other) : ir_const(t->l.ir, type, base);
}

static void check_call(Test *t, const FunctionCase *row, const SlopeRow *slope)
{
    const int function = row->function;
    const char *letters = function_arguments(function);
    for (int i = 0; i < CALLS; i++) {
        Tuple tuple;
        Ref args[CALL_ARGUMENTS];
        int count = (int)strlen(letters);
        tuple_draw(row->arguments, letters, &t->random, tuple);
        begin(t);
        t->l.ir->texture_count = CALL_TEXTURES;
        t->l.ir->textures = ARENA_ARRAY(&t->arena, IrTexture, CALL_TEXTURES);
        for (int k = 0; k < CALL_TEXTURES; k++)
            t->l.ir->textures[k].wrap = KEYWORD_Address_repeat;
        for (int k = 0; k < count; k++)
            args[k] = argument(t, letters[k], tuple[k], &row->arguments[k], k == slope->argument);
        compare(t, build_call_of(t->l.ir, function, args, count), function_row(function)->name,
                1 << slope->argument);
        end(t);
    }
}

/* Functions with a row in slopes.def or maps.def; all others are differentiated by differences. */
static void functions_have_the_slopes_of_their_rows(void **state)
{
    (void)state;
    for (int i = 0; i < case_count; i++) {
        const FunctionCase *row = &function_cases[i];
        Test t = {.random = case_random(row, 0), .bound = 3e-5, .step = 1e-7};
        const int function = row->function;
        const SlopeRow *slope = slope_row(function);
        /* that of the picture as it is */
        if (slope->kind == SLOPE_difference || function == FN_imageFiltered)
            continue;
        check_call(&t, row, slope);
        print_message("%s: %d slopes, %d at jumps and creases\n", function_row(function)->name,
                      t.compared, t.skipped);
        assert_true(t.compared > CALLS / 4 || slope->kind == SLOPE_flat);
    }
}

/* Differences over 1/256 would not see boxes below that: nothing that a pixel is averaged by is
 * left to them. */
static void means_have_slopes_of_their_own(void **state)
{
    (void)state;
    static const int means[] = {FN_stripes2,           FN_stripes3,
                                FN_stripesAlong2,      FN_stripesAlong3,
                                FN_rampMean,           FN_cubicMean,
                                FN_triangleMean,       FN_scallopMean,
                                FN_turbulenceFiltered, FN_vectorTurbulenceFiltered,
                                FN_graniteFiltered,    FN_leopardFiltered,
                                FN_imageFiltered,      FN_imageSampled,
                                FN_imageSampledOver};
    for (size_t i = 0; i < sizeof means / sizeof *means; i++)
        assert_int_not_equal(slope_row(means[i])->kind, SLOPE_difference);
}

/* A function without a row: e^(base + rate u) over differences of 1/256 has an error of rate^2 / 6
 * of their square. */
static void a_function_without_a_row_has_the_slope_of_its_differences(void **state)
{
    (void)state;
    Test t = {.random = java_random(15)};
    const double step = 1. / 256;
    const int function = FN_waveExp;
    assert_int_equal(slope_row(function)->kind, SLOPE_difference);
    for (int i = 0; i < CALLS; i++) {
        double base[4] = {uniform(&t, -5, 5)}, rate[4] = {uniform(&t, -4, 4)}, none[4] = {0};
        double result[MAX_OUTPUTS][4], expected = rate[0] * exp(base[0]),
                                       squared = rate[0] * rate[0] * step * step;
        begin(&t);
        Ref value = build_call(t.l.ir, function, moving(&t.l, TYPE_float, base, rate, none));
        ir_output(t.l.ir, OUT_color, 0, slope_of(&t.l, value, DIRECTION_u));
        evaluate(&t, 0, 0, result);
        end(&t);
        if (fabs(result[0][0] - expected) > (squared / 6 + 1e-11) * 1.001 * fabs(expected))
            fail_msg("e^(%g + %g u) has the slope %.12g, should be %.12g", base[0], rate[0],
                     result[0][0], expected);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(operations_have_the_slopes_of_all_operands),
        cmocka_unit_test(functions_have_the_slopes_of_their_rows),
        cmocka_unit_test(means_have_slopes_of_their_own),
        cmocka_unit_test(a_function_without_a_row_has_the_slope_of_its_differences),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
