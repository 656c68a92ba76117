/* Values of every node of random programs against their claimed intervals: one for the whole
 * node, and one for each component, with conditions narrowing the arms of selects. */
#include "tests/test.h"
#include "compiler/ir/build.h"
#include "compiler/ir/fold.h"
#include "compiler/ir/range.h"
#include "tests/stress/choices.h"
#include "tests/value/expression.h"
#include "tests/value/ir_site.h"
#include "compiler/library/references.h"
#include <string.h>

enum { PROGRAMS = 300, STEPS = 40, POINTS = 24 };

static const double numbers[] = {-3, -2.5, -1, -0.5, 0, 0.25, 0.5, 1, 1.5, 2, 3};
enum { NUMBERS = sizeof numbers / sizeof *numbers };

typedef struct {
    Site site;
    Choices choices;
    Ref floats[STEPS + 8], vectors[STEPS + 8];
    int float_count, vector_count;
} Program;

/* Recent ones more often: programs grow deep. */
static Ref pick(Program *p, const Ref *from, int count)
{
    int recent = count < 6 ? count : 6;
    return chance(&p->choices, 1, 3) ? from[choose(&p->choices, (uint32_t)count)]
                                     : from[count - 1 - (int)choose(&p->choices, (uint32_t)recent)];
}

static Ref a_float(Program *p) { return pick(p, p->floats, p->float_count); }
static Ref a_vector(Program *p) { return pick(p, p->vectors, p->vector_count); }
static Ref a_number(Program *p)
{
    return build_float(p->site.ir, numbers[choose(&p->choices, NUMBERS)]);
}

/* A value, or a function of it, where its condition holds. */
static Ref guarded(Program *p)
{
    Ir *ir = p->site.ir;
    Ref value = a_float(p), at = a_number(p), other = a_float(p);
    Op compare = chance(&p->choices, 1, 2) ? OP_lt : OP_le;
    bool right = chance(&p->choices, 1, 2);
    Ref condition =
        right ? build_binary(ir, compare, value, at) : build_binary(ir, compare, at, value);
    Ref arm = chance(&p->choices, 1, 2) ? value : build_mul(ir, value, other);
    Ref rest = chance(&p->choices, 1, 2) ? other : build_sub(ir, value, other);
    return build_select(ir, condition, arm, rest);
}

static Ref float_step(Program *p)
{
    static const Op one[] = {OP_neg,  OP_abs, OP_floor, OP_ceil, OP_fract,
                             OP_sign, OP_sin, OP_cos,   OP_atan};
    static const Op two[] = {OP_add, OP_sub, OP_mul, OP_min, OP_max, OP_step, OP_atan2};
    Ir *ir = p->site.ir;
    Op operation;
    Ref vector;
    switch (choose(&p->choices, 10)) {
    case 0:
        operation = one[choose(&p->choices, sizeof one / sizeof *one)];
        return build_unary(ir, operation, a_float(p));
    case 1:
        operation = two[choose(&p->choices, sizeof two / sizeof *two)];
        return build_binary(ir, operation, a_float(p), a_float(p));
    case 2:
        return build_clamp(ir, a_float(p), build_float(ir, -1), build_float(ir, 2));
    case 3:
        return build_mix(ir, a_float(p), a_float(p), a_float(p));
    case 4:
        return build_div(ir, a_float(p),
                         build_clamp(ir, a_float(p), build_float(ir, 0.5), build_float(ir, 3)));
    case 5:
        return build_mod(ir, a_float(p),
                         build_clamp(ir, a_float(p), build_float(ir, 1), build_float(ir, 2)));
    case 6:
        return build_dot(ir, a_vector(p), a_vector(p));
    case 7:
        return build_length(ir, a_vector(p));
    case 8:
        vector = a_vector(p);
        return build_components(ir, vector, choose(&p->choices, 3), 1);
    default:
        return guarded(p);
    }
}

static Ref vector_step(Program *p)
{
    Ir *ir = p->site.ir;
    switch (choose(&p->choices, 5)) {
    case 0:
        return build_vec(ir, TYPE_vec3, a_float(p), a_float(p), a_float(p));
    case 1:
        return build_mul(ir, a_vector(p), a_float(p));
    case 2:
        return build_fract(ir, a_vector(p));
    case 3:
        return build_linear(ir, REFS(ir, a_vector(p), a_vector(p), a_vector(p), a_vector(p)), 4);
    default:
        return build_swizzle(ir, a_vector(p), "zxy");
    }
}

static void program_make(Program *p, int number)
{
    *p = (Program){0};
    choices_random(&p->choices, 17, (uint64_t)number);
    site_open(&p->site);
    static const char *const first[] = {"x", "fract(y)", "clamp(z, -1, 3)", "0.5", "-2"};
    for (size_t i = 0; i < sizeof first / sizeof *first; i++)
        p->floats[p->float_count++] = expression_read(p->site.ir, first[i]);
    p->vectors[p->vector_count++] = expression_read(p->site.ir, "clamp(v, -2, 2)");
    p->vectors[p->vector_count++] = expression_read(p->site.ir, "fract(w)");
    for (int i = 0; i < STEPS; i++) {
        bool vector = chance(&p->choices, 1, 4);
        Ref made = vector ? vector_step(p) : float_step(p); /* before it counts */
        if (vector)
            p->vectors[p->vector_count++] = made;
        else
            p->floats[p->float_count++] = made;
    }
}

static void check_node(Program *p, const Ranges ranges[2], Ref ref, const double *value)
{
    for (int kept = 0; kept < 2; kept++)
        for (int component = 0; component < ir_components(p->site.ir, ref); component++) {
            Interval claimed = range_of(&ranges[kept], p->site.ir, ref, component);
            double spare = 1e-9 * fmax(fabs(value[component]), 1), x = value[component];
            if (isfinite(x) && !(x >= claimed.low - spare && x <= claimed.high + spare)) {
                Text text = text_new(&p->site.arena);
                expression_print(&text, p->site.ir, ref);
                fail_msg("%.900s: lane %d is %.17g, claimed [%.17g, %.17g] of %d", text.at,
                         component, x, claimed.low, claimed.high, ranges[kept].components);
            }
        }
}

/* The values of `count` nodes at every point. */
static void check_nodes(Program *p, const Ranges ranges[2], const Ref *refs, int count)
{
    const ReferenceContext context = {.noise = p->site.ir->noise};
    p->site.ir->output_count = 0;
    for (int i = 0; i < count; i++)
        ir_output(p->site.ir, OUT_color, i, refs[i]);
    for (int n = 0; n < POINTS; n++) {
        double inputs[INPUT_COUNT][4], values[MAX_OUTPUTS][4];
        p->choices.count = 0;
        for (int i = 0; i < INPUT_COUNT; i++)
            for (int component = 0; component < 4; component++)
                inputs[i][component] = chance(&p->choices, 1, 2)
                                           ? 8 * choose_part(&p->choices) - 4
                                           : numbers[choose(&p->choices, NUMBERS)];
        ir_eval(p->site.ir, &context, (const double(*)[4])inputs, values);
        for (int i = 0; i < count; i++)
            check_node(p, ranges, refs[i], values[i]);
    }
}

static void values_of_random_programs_lie_within_their_intervals(void **state)
{
    (void)state;
    static Program p;
    for (int number = 0; number < PROGRAMS; number++) {
        program_make(&p, number);
        Ranges ranges[2] = {range_find(p.site.ir, &p.site.arena, 1),
                            range_find(p.site.ir, &p.site.arena, 4)};
        for (int i = 0; i < p.float_count; i += MAX_OUTPUTS)
            check_nodes(&p, ranges, &p.floats[i],
                        p.float_count - i < MAX_OUTPUTS ? p.float_count - i : MAX_OUTPUTS);
        for (int i = 0; i < p.vector_count; i += MAX_OUTPUTS)
            check_nodes(&p, ranges, &p.vectors[i],
                        p.vector_count - i < MAX_OUTPUTS ? p.vector_count - i : MAX_OUTPUTS);
        site_close(&p.site);
    }
}

/* -- what functions.def and maps.def say of library functions and maps */

enum { CALLS = 3000, MAX_NUMBERS = 64, TEXELS = 8 };

static double a_component(Choices *c)
{
    double part = choose_part(c);
    switch (choose(c, 4)) {
    case 0:
        return part; /* shares, coordinates of pictures */
    case 1:
        return 2 * part - 1;
    case 2:
        return numbers[choose(c, NUMBERS)];
    default:
        return 200 * part - 100;
    }
}

static int vector_argument(Choices *c, int components, double *to)
{
    double square = 0;
    bool unit = chance(c, 1, 2);
    for (int i = 0; i < components; i++) {
        to[i] = a_component(c);
        square += to[i] * to[i];
    }
    for (int i = 0; unit && square > 0 && i < components; i++)
        to[i] /= sqrt(square);
    return components;
}

/* One of the letter's type; how many numbers it has. */
static int an_argument(Choices *c, char letter, double *to)
{
    switch (letter) {
    case 's':
        to[0] = 0;
        return 1;
    case 'i':
        to[0] = 4 + choose(c, 6); /* bits that every code has */
        return 1;
    case 'f':
        to[0] = a_component(c);
        return 1;
    default:
        return vector_argument(c, letter - '0', to);
    }
}

static Interval claimed_of(Site *s, int function)
{
    Ref args[MAX_NUMBERS];
    const int count = (int)strlen(function_arguments(function));
    for (int i = 0; i < count; i++)
        /* where a texture is wanted, too: nothing is known of its texels */
        args[i] = build_float(s->ir, 0);
    Ref ref = build_call_of(s->ir, function, args, count);
    Ranges none = {0};
    return range_computed(&none, s->ir, ref, 0);
}

static void functions_have_values_within_their_intervals(void **state)
{
    (void)state;
    static const uint8_t texels[TEXELS * TEXELS * 4] = {0, 255, 3, 128, 7, 200, 255, 0, 90};
    const ReferenceTexture texture = {
        .width = TEXELS, .height = TEXELS, .components = 4, .bytes = texels};
    const ReferenceContext context = {REFERENCE_LATTICE, &texture};
    int bounded = 0;
    Choices choices;
    choices_random(&choices, 23, 0);
    for (int function = 0; function < FUNCTION_COUNT; function++) {
        Site site;
        site_open(&site);
        bool known = function_row(function)->name && function != FN_turbulence &&
                     function != FN_phongExponent;
        Interval claimed = known ? claimed_of(&site, function) : (Interval){-INFINITY, INFINITY};
        bounded += isfinite(claimed.low) || isfinite(claimed.high);
        for (int n = 0; (isfinite(claimed.low) || isfinite(claimed.high)) && n < CALLS; n++) {
            double args[MAX_NUMBERS], result[4] = {0};
            int used = 0;
            choices.count = 0;
            for (const char *letter = function_arguments(function); *letter; letter++)
                used += an_argument(&choices, *letter, &args[used]);
            reference_of(function)(&context, args, result);
            for (int component = 0;
                 component < type_table[function_row(function)->result].components; component++)
                if (isfinite(result[component]) &&
                    !(result[component] >= claimed.low && result[component] <= claimed.high))
                    fail_msg("%s: %.9g, claimed [%.9g, %.9g]", function_row(function)->name,
                             result[component], claimed.low, claimed.high);
        }
        site_close(&site);
    }
    assert_true(bounded > 40);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_of_random_programs_lie_within_their_intervals),
        cmocka_unit_test(functions_have_values_within_their_intervals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
