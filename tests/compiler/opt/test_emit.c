/* The emitted text has the meaning of the IR: every operation as either operand of every other,
 * every mixture of floats and vectors, and branches. Each is drawn under OSMesa, compared with
 * ir_eval, and parsed by glslang in one of three other languages. The optimizer is bypassed, so
 * that the text also has forms that the optimizer would remove. */
/* ctest: unoptimized seconds=15 */
#include "tests/test.h"
#include "compiler/ir/build.h"
#include "compiler/pipeline.h"
#include "tests/stress/choices.h"
#include "tests/draw/draw.h"
#include "tests/value/evaluate.h"
#include "tests/value/expression.h"
#include "tests/value/ir_site.h"
#include <stdio.h>
#include <string.h>

enum { POINTS = 64, LONGEST = 160 };
static const double bound =
    /* of max(1, |value|): Mesa's acos errs by 4e-4, and a lost parenthesis by more than this */
    1e-3;

typedef struct {
    Drawer drawer;
    Point points[POINTS];
    int count; /* of expressions so far */
} Test;

/* Numbers for which every operation has a value, and no two are alike. */
static void make_points(Point *points)
{
    Choices choices;
    choices_random(&choices, 31, 0);
    memset(points, 0, POINTS * sizeof *points);
    for (int i = 0; i < POINTS; i++)
        for (int input = 0; input < POINT_VARYINGS; input++)
            for (int component = 0; component < 3; component++)
                points[i].input[input][component] = (float)(0.2 + 0.7 * choose_part(&choices));
}

/* A vec4 of the value, a truth as 1 or 0. */
static Ref as_color(Ir *ir, Ref value)
{
    if (ir_type(ir, value) == TYPE_bool)
        value = build_select(ir, value, build_float(ir, 1), build_float(ir, 0));
    int components = ir_components(ir, value);
    if (components == 4)
        return value;
    static const Type rest[] = {0, TYPE_vec3, TYPE_vec2, TYPE_float};
    Ref zero = build_all(ir, rest[components], 0);
    return build_vec(ir, TYPE_vec4, value, zero);
}

static Job job_for(Target target)
{
    Job job;
    choice_job(&(MatcOptions){.pass = "value"}, &job);
    job.target = target;
    return job;
}

/* The program for a target. The driver judges the one that is drawn, glslang the others. */
static const char *emit_for(Site *s, Target target, const char *text)
{
    const MatcOptions options = {.validate = target != TARGET_glsl330};
    Job job = job_for(target);
    Products products = {0};
    s->compile.options = &options;
    if (!compile_back(&s->compile, s->ir, &job, &products))
        fail_msg("%s: %s\n%s", text, s->compile.diags.at[0].message, products.fragment);
    return products.fragment;
}

static void compare(Test *t, const Ir *ir, const char *text, const char *fragment)
{
    static float drawn[POINT_COUNT][4]; /* all of the grid is read */
    Graph graph = {0};
    Shading shading = {.fragment = fragment, .target = TARGET_glsl330, .graph = &graph};
    Material material;
    if (!drawer_material(&t->drawer, &shading, &material) ||
        !drawer_draw(&t->drawer, &material, true, (float *const[]){drawn[0]}, 1))
        fail_msg("%s: %s", text, t->drawer.error);
    material_delete(&material);
    const ReferenceContext context = {.noise = ir->noise};
    for (int i = 0; i < POINTS; i++) {
        double inputs[INPUT_COUNT][4], value[MAX_OUTPUTS][4];
        evaluate_inputs(&t->points[i], true, inputs);
        ir_eval(ir, &context, (const double(*)[4])inputs, value);
        for (int component = 0; component < 4; component++)
            if (!(fabs(drawn[i][component] - value[0][component]) <=
                  bound * fmax(1, fabs(value[0][component]))))
                fail_msg("%s: lane %d is %.9g, drawn %.9g\n%s", text, component,
                         value[0][component], drawn[i][component], fragment);
    }
}

static void check(Test *t, const char *text)
{
    static const Target others[] = {TARGET_glsl110, TARGET_glsl450, TARGET_essl300};
    Site s;
    site_open(&s);
    Ref ref = expression_read(s.ir, text);
    if (!ref)
        fail_msg("%s: cannot be read", text);
    ir_output(s.ir, OUT_color, 0, as_color(s.ir, ref));
    const char *fault = ir_check(s.ir);
    if (fault)
        fail_msg("%s: %s", text, fault);
    compare(t, s.ir, text, emit_for(&s, TARGET_glsl330, text));
    emit_for(&s, others[t->count++ % 3], text);
    site_close(&s);
}

static int set_up(void **state)
{
    static Test test;
    make_points(test.points);
    *state = &test;
    if (drawer_open(&test.drawer, true, test.points, POINTS))
        return 0;
    print_error("%s\n", test.drawer.error);
    return 1;
}

static int tear_down(void **state)
{
    Test *test = *state;
    drawer_close(&test->drawer);
    return 0;
}

/* Each with the values of its operands. */
static const char *const numbers[] = {"neg(%s)",
                                      "add(%s, %s)",
                                      "sub(%s, %s)",
                                      "mul(%s, %s)",
                                      "div(%s, %s)",
                                      "min(%s, %s)",
                                      "fract(%s)",
                                      "select(lt(%s, 0.5), %s, 0.25)",
                                      "linear(vec2(%s, y), [1, 2], [3, 4]).y"};
static const char *const truths[] = {"lt(%s, %s)", "le(%s, %s)", "eq(%s, %s)", "ne(%s, %s)"};
static const char *const logic[] = {"and(%s, %s)", "or(%s, %s)", "ne(%s, %s)", "eq(%s, %s)",
                                    "not(%s)"};
#define COUNT(list) (sizeof(list) / sizeof *(list))

/* The operation with one operand, or with it on either side. */
static void check_within(Test *t, const char *outer, const char *inner, const char *other)
{
    char text[LONGEST];
    snprintf(text, sizeof text, outer, inner, other);
    check(t, text);
    if (!strstr(outer, ", %s"))
        return;
    snprintf(text, sizeof text, outer, other, inner);
    check(t, text);
}

static void every_operation_stands_within_every_other(void **state)
{
    char inner[LONGEST];
    for (size_t i = 0; i < COUNT(numbers); i++)
        for (size_t k = 0; k < COUNT(numbers); k++) {
            snprintf(inner, sizeof inner, numbers[k], "y", "z");
            check_within(*state, numbers[i], inner, "x");
        }
    enum { FINITE = 4 };                  /* the first of them, by 0, too */
    for (size_t i = 0; i < FINITE; i++) { /* numbers that begin with a minus */
        check_within(*state, numbers[i], "-2", "x");
        check_within(*state, numbers[i], "-0", "x");
    }
}

static void comparisons_and_logic_stand_within_each_other(void **state)
{
    char inner[LONGEST], truth[LONGEST];
    for (size_t i = 0; i < COUNT(truths); i++)
        for (size_t k = 0; k < COUNT(numbers); k++) {
            snprintf(inner, sizeof inner, numbers[k], "y", "z");
            check_within(*state, truths[i], inner, "x");
        }
    for (size_t i = 0; i < COUNT(logic); i++) {
        for (size_t k = 0; k < COUNT(logic); k++) {
            snprintf(truth, sizeof truth, logic[k], "lt(y, z)", "lt(x, y)");
            check_within(*state, logic[i], truth, "lt(x, z)");
        }
        snprintf(truth, sizeof truth, "select(%s, x, y)", logic[i]);
        check_within(*state, truth, "le(y, z)", "lt(x, y)");
    }
}

/* A float stands for a vector where GLSL lets it, and where it does not. */
static void floats_and_vectors_mix(void **state)
{
    static const char *const one[] = {"neg",  "abs",  "floor", "ceil", "fract", "sign",
                                      "sqrt", "exp",  "exp2",  "log",  "sin",   "cos",
                                      "tan",  "asin", "acos",  "atan"};
    static const char *const two[] = {"add", "sub",  "mul", "div", "min",
                                      "max", "step", "mod", "pow", "atan2"};
    static const char *const three[] = {"clamp", "mix"};
    static const char *const wide[] = {"x", "y", "0.75", "v", "w", "[0.1, 0.9, 0.6]"};
    char text[LONGEST];
    for (size_t i = 0; i < COUNT(one); i++)
        for (int k = 0; k < 6; k += 3) {
            snprintf(text, sizeof text, "%s(%s)", one[i], wide[k]);
            check(*state, text);
        }
    for (size_t i = 0; i < COUNT(two); i++)
        for (int k = 0; k < 9; k++) {
            snprintf(text, sizeof text, "%s(%s, %s)", two[i], wide[k % 3 * 2],
                     wide[(k / 3 * 2 + 1)]);
            check(*state, text);
        }
    for (size_t i = 0; i < COUNT(three); i++) /* the lower bound of a clamp below the upper */
        for (int k = 0; k < 8; k++) {
            snprintf(text, sizeof text, "%s(%s, %s, %s)", three[i], k & 1 ? "v" : "x",
                     k & 2 ? "[0.3, 0.4, 0.5]" : "0.4", k & 4 ? "[0.6, 0.7, 0.8]" : "0.6");
            check(*state, text);
        }
}

static void numbers_components_and_vectors_are_written(void **state)
{
    static const char *const texts[] = {"neg(-0.5)",
                                        "sub(x, -0.5)",
                                        "sub(-0.5, x)",
                                        "mul(-2, -3)",
                                        "neg(neg(x))",
                                        "not(not(lt(x, y)))",
                                        "add(x, [-1, -2, -3])",
                                        "div(1, -4)",
                                        "abs(-1e-30)",
                                        "mul(1e30, 1e-30)",
                                        "add(16777216, x)",
                                        "[0.5, 0.5, 0.5]",
                                        "[1, 1, 2].zx",
                                        "v.zyx.xy",
                                        "add(v, w).y",
                                        "mul(sub(v, w), x).zx",
                                        "vec2(x, y)",
                                        "vec3(x, x, x)",
                                        "vec4(x, x, x, y)",
                                        "vec4(x, x, y, y)",
                                        "vec4(v, 1)",
                                        "vec4(1, v)",
                                        "vec4(u, u)",
                                        "vec4(vec2(x, y).yx, 0, 1)",
                                        "vec3(u, x).zyx",
                                        "dot(v, w)",
                                        "cross(v, w)",
                                        "length(v)",
                                        "linear(u, [1, 2], [3, 4])",
                                        "linear(v, w, v, [1, 2, 3])",
                                        "linear(add(v, w), v, w, v)",
                                        "neg(linear(u, [1, 2], [3, 4]))",
                                        "select(front, v, w)",
                                        "select(front, select(lt(x, y), x, y), z)",
                                        "select(select(front, lt(x, y), lt(y, z)), x, y)",
                                        "select(lt(x, y), select(front, x, y), z)",
                                        "sub(select(front, x, y), select(lt(x, y), y, x))",
                                        "phongExponent(mul(x, y))",
                                        "safeNormalize(sub(v, w))",
                                        "noise(mul(v, 3))",
                                        "turbulence(v, 3i, 2, 0.5)"};
    for (size_t i = 0; i < COUNT(texts); i++)
        check(*state, texts[i]);
}

/* Values and conditions, each made of some before it. */
enum { MADE = 40, CONDITIONS = 3, RECENT = 9, SHADERS = 48 };
typedef struct {
    Choices choices;
    Ir *ir;
    Ref values[MADE], conditions[CONDITIONS];
    int count;
} Chosen;

/* One of the last few, that much is made of each. */
static Ref any_value(Chosen *c)
{
    const uint32_t most = c->count < RECENT ? (uint32_t)c->count : RECENT;
    return c->values[c->count - 1 - (int)choose(&c->choices, most)];
}

static void add_value(Chosen *c, Ref value) { c->values[c->count++] = value; }

static Ref next_value(Chosen *c)
{
    Ir *ir = c->ir;
    Ref a = any_value(c), b = any_value(c), by = c->conditions[choose(&c->choices, CONDITIONS)];
    switch (choose(&c->choices, 6)) {
    case 0:
        return build_mul(ir, build_add(ir, a, b), build_float(ir, 0.5));
    case 1:
        return build_mul(ir, a, b);
    case 2:
        return build_call(ir, FN_noise, build_vec(ir, TYPE_vec3, a, b, a));
    default:
        return build_select(ir, by, a, chance(&c->choices, 1, 2) ? build_float(ir, 0) : b);
    }
}

/* Selects that alone need a noise, by one condition; others may be made of one and needed by the
 * next. */
static void add_together(Chosen *c)
{
    Ir *ir = c->ir;
    Ref by = c->conditions[choose(&c->choices, CONDITIONS)], a = any_value(c);
    Ref noise = build_call(ir, FN_noise, build_vec(ir, TYPE_vec3, a, any_value(c), a));
    for (int i = 0; i < 3 && c->count < MADE; i++) {
        Ref arm = build_mul(ir, noise, any_value(c)), other = any_value(c);
        c->values[c->count++] = chance(&c->choices, 1, 4) ? build_select(ir, by, other, arm)
                                                          : build_select(ir, by, arm, other);
    }
}

/* Compared values are exact: inputs, one or the other of them, and numbers. */
static void choose_values(Chosen *c, Ir *ir, uint64_t index)
{
    Ref p = build_input(ir, INPUT_X);
    c->ir = ir;
    c->count = 3;
    choices_random(&c->choices, 7, index);
    for (int i = 0; i < 3; i++)
        c->values[i] = build_swizzle(ir, p, (const char *[]){"x", "y", "z"}[i]);
    for (int i = 0; i < CONDITIONS; i++) {
        Ref a = any_value(c), b = any_value(c);
        Ref value = i ? build_select(ir, c->conditions[choose(&c->choices, (uint32_t)i)], a, b) : a;
        c->conditions[i] =
            build_lt(ir, value, build_float(ir, 0.3 + 0.5 * choose_part(&c->choices)));
    }
    while (c->count < MADE)
        if (chance(&c->choices, 1, 3))
            add_together(c);
        else
            add_value(c, next_value(c));
}

/* Two variables that one branch sets. */
static bool declares_several(const char *fragment)
{
    bool before = false;
    for (const char *line = fragment; line; line = strchr(line + 1, '\n')) {
        const char *word = line + strspn(line, "\n "), *end = word + strcspn(word, "=;\n");
        const bool declares = !strncmp(word, "float ", strlen("float ")) && *end == ';';
        if (declares && before)
            return true;
        before = declares;
    }
    return false;
}

static int times(const char *text, const char *word)
{
    int n = 0;
    for (; (text = strstr(text, word)); text++)
        n++;
    return n;
}

static int noises_of(const Ir *ir)
{
    int n = 0;
    for (Ref ref = 1; ref < ir->count; ref++)
        n += ir_is(ir, ref, OP_call);
    return n;
}

/* Selects by few conditions, of noises that several of them need, in each other and beside each
 * other, with a second output that is written before; as branches. */
static void branches_by_one_condition_are_what_they_mean(void **state)
{
    int several = 0;
    for (int i = 0; i < SHADERS; i++) {
        Site s;
        Chosen c;
        char text[LONGEST];
        snprintf(text, sizeof text, "shader %d", i);
        site_open(&s);
        choose_values(&c, s.ir, (uint64_t)i);
        ir_output(s.ir, OUT_discard, 0,
                  build_lt(s.ir, c.values[MADE - 5], build_float(s.ir, -1000)));
        ir_output(s.ir, OUT_color, 0,
                  build_vec(s.ir, TYPE_vec4, c.values[MADE - 1], c.values[MADE - 2],
                            c.values[MADE - 3], c.values[MADE - 4]));
        s.compile.optimize = 1; /* there are branches */
        emit_for(&s, TARGET_essl300, text);
        const char *fragment = emit_for(&s, TARGET_glsl330, text);
        s.ir->outputs[0] = s.ir->outputs[s.ir->output_count = 1]; /* the one that is compared */
        compare(*state, s.ir, text, fragment);
        several += declares_several(fragment);
        /* what is needed twice is written once */
        assert_true(times(fragment, "noise(vec3(") <= noises_of(s.ir));
        site_close(&s);
    }

    assert_true(several > SHADERS / 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_operation_stands_within_every_other),
        cmocka_unit_test(comparisons_and_logic_stand_within_each_other),
        cmocka_unit_test(floats_and_vectors_mix),
        cmocka_unit_test(numbers_components_and_vectors_are_written),
        cmocka_unit_test(branches_by_one_condition_are_what_they_mean),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
