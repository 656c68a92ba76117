/* Every library function and every volume map's function: its GLSL, drawn, against its C
 * reference in double at the same floats, within the bound of its row in functions.def. */
/* ctest: unsanitized seconds=14 */
#include "tests/test.h"
#include "compiler/ir/ir.h"
#include "compiler/pipeline.h"
#include "compiler/library/java_random.h"
#include "tests/value/cases.h"
#include "compiler/library/references.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    NEIGHBOURS = 48,  /* that make a hull */
    MAX_VARIANTS = 8, /* texts of a function for one target */
    MAX_SHOWN = 3,    /* faults of a case that are printed */
    MAX_NUMBERS = 4 * CALL_ARGUMENTS
};
/* below, errors count as if the value were this: floats end at 1e-38 */
static const double least_relative = 1e-30;

typedef struct {
    Caller caller;
    const FunctionCase *row;
    int function, tuples, moved, faults;
    double worst;
    ReferenceContext context;
    const char *choices;
    Tuple tuple[CALL_COUNT];
    double result[CALL_COUNT][CALL_COMPONENTS];
} Test;

static const char *name_of(const FunctionCase *row) { return function_row(row->function)->name; }

static double ulp(double v) { return ldexp(1, ilogb(fmax(fabs(v), 1e-20)) - 23); }

/* The sum of |noiseRatio|^k, times |frequencyRatio|^k for slopes. */
static double octave_sum(Test *t, Tuple tuple, bool slope)
{
    int at = (int)strcspn(function_arguments(t->function), "i");
    double frequency = fabs((double)tuple[at + 1][0]), noise = fabs((double)tuple[at + 2][0]),
           sum = 0;
    for (int k = 0; k < (int)tuple[at][0]; k++)
        sum += pow(noise, k) * (slope ? fmax(pow(frequency, k), 1) : 1);
    return sum;
}

/* Divisor of an error. */
static double scale_of(Test *t, int i, const double expected[CALL_COMPONENTS], int component,
                       int components)
{
    double greatest = 0, v = fabs(expected[component]);
    switch (t->row->unit) {
    case UNIT_RELATIVE:
        return fmax(v, least_relative);
    case UNIT_MIXED:
        return fmax(v, 1);
    case UNIT_ULP:
        return ulp(v);
    case UNIT_STRENGTH:
    case UNIT_SLOPE:
        return octave_sum(t, t->tuple[i], t->row->unit == UNIT_SLOPE);
    case UNIT_VECTOR:
        for (int k = 0; k < components; k++)
            greatest = fmax(greatest, fabs(expected[k]));
        return fmax(greatest, least_relative);
    default:
        return 1;
    }
}

static void reference(const Test *t, const double *args, double expected[CALL_COMPONENTS])
{
    reference_of(t->function)(&t->context, args, expected);
}

/* From what the reference makes of the neighbors: from the nearest of them for codes, else from
 * their hull, which is taken to be wider by its own width. */
static double miss_nearby(Test *t, int i, int component, double start)
{
    const char *letters = function_arguments(t->function);
    double low = start, high = start, got = t->result[i][component];
    uint64_t state = java_random(i);
    for (int k = 0; k < NEIGHBOURS; k++) {
        double args[MAX_NUMBERS], expected[CALL_COMPONENTS] = {0};
        tuple_flatten(t->tuple[i], letters, args);
        tuple_move(args, t->row->arguments, letters, t->row->reach, &state);
        reference(t, args, expected);
        if (expected[component] == got)
            return 0;
        low = fmin(low, expected[component]);
        high = fmax(high, expected[component]);
    }
    if (t->row->unit == UNIT_CODE)
        return 1;
    double tolerance = high - low;
    return fmax(fmax(low - tolerance - got, got - high - tolerance), 0);
}

static double miss_of(Test *t, int i, const double expected[CALL_COMPONENTS], int component,
                      int components)
{
    double scale = scale_of(t, i, expected, component, components), got = t->result[i][component];
    double miss = fabs(got - expected[component]);
    if (!isfinite(got))
        return INFINITY;
    if (t->row->unit == UNIT_TURN)
        miss = fabs(got - expected[component] - rint(got - expected[component]));
    if (t->row->unit == UNIT_CODE)
        miss = miss != 0;
    if (miss <= t->row->bound * scale || t->row->reach == 0)
        return miss / scale;
    t->moved++;
    return miss_nearby(t, i, component, expected[component]) / scale;
}

static void show(Test *t, int i, int component, double expected, double miss)
{
    char text[1024];
    double args[MAX_NUMBERS];
    int size = 0, count = 0;
    const char *letters = function_arguments(t->function);
    tuple_flatten(t->tuple[i], letters, args);
    for (int k = 0; letters[k]; k++)
        count += argument_components(letters[k]);
    for (int k = 0; k < count; k++)
        size += snprintf(text + size, sizeof text - (size_t)size, " %.9g", args[k]);
    print_error("%s %s (%s) lane %d:%s\n    is %.9g, should be %.9g, off by %.2g\n",
                name_of(t->row), target_table[t->caller.target].name, t->choices, component, text,
                t->result[i][component], expected, miss);
}

static void compare(Test *t)
{
    const char *letters = function_arguments(t->function);
    Type type = function_row(t->function)->result;
    int components = type == TYPE_uint ? 1 : type_table[type].components, shown = 0;
    for (int i = 0; i < CALL_COUNT; i++) {
        double args[MAX_NUMBERS], expected[CALL_COMPONENTS] = {0};
        tuple_flatten(t->tuple[i], letters, args);
        reference(t, args, expected);
        t->tuples++;
        for (int component = 0; component < components; component++) {
            double miss = miss_of(t, i, expected, component, components);
            t->worst = fmax(t->worst, miss);
            if (miss <= t->row->bound)
                continue;
            t->faults++;
            if (shown++ < MAX_SHOWN)
                show(t, i, component, expected[component], miss);
        }
    }
}

static void call_seed(Test *t, int seed)
{
    uint64_t state = case_random(t->row, seed);
    for (int i = 0; i < CALL_COUNT; i++)
        tuple_draw(t->row->arguments, function_arguments(t->function), &state, t->tuple[i]);
    if (!call_draw(&t->caller, t->function, t->tuple, t->result))
        fail_msg("%s: %s", name_of(t->row), t->caller.error);
    compare(t);
}

/* FUNCTION_SEEDS of them; ctest draws one. */
static void call(Test *t)
{
    const char *seeds = getenv("FUNCTION_SEEDS");
    const size_t size = strlen(t->caller.text); /* a call puts its main() behind it */
    for (int seed = 0; seed == 0 || (seeds && seed < atoi(seeds)); seed++) {
        t->caller.text[size] = 0;
        call_seed(t, seed);
    }
}

/* Every text that the choices of noise and trigonometry make, once. */
static void call_variants(Test *t)
{
    static const char *const noises[] = {"lattice", "groimp", "simplex"}, *const trigonometry[] = {
                                                                              "native", "bounded"};
    static const char *const names[][2] = {{"lattice", "lattice, bounded"},
                                           {"groimp", "groimp, bounded"},
                                           {"simplex", "simplex, bounded"}};
    char *texts[MAX_VARIANTS];
    int count = 0;
    for (int i = 0; i < 6; i++) {
        Job job;
        MatcOptions options;
        matc_options_init(&options);
        options.target = target_table[t->caller.target].name;
        options.noise = noises[i / 2];
        options.trigonometry = trigonometry[i % 2];
        assert_null(choice_job(&options, &job));
        assert_true(call_gather(&t->caller, t->function, &job));
        bool seen = false;
        for (int k = 0; k < count; k++)
            seen |= !strcmp(texts[k], t->caller.text);
        if (seen)
            continue;
        texts[count++] = strdup(t->caller.text);
        t->choices = names[i / 2][i % 2];
        t->context =
            (ReferenceContext){job_noise(job.choice[AXIS_noise], t->caller.target), call_textures};
        call(t);
    }
    while (count)
        free(texts[--count]);
}

static bool exists(int function, Target target)
{
    const bool of_sampler = function == FN_imageSampledOver || function == FN_pictureSize ||
                            function == FN_imageRiseOver || function == FN_imageRiseNear ||
                            function == FN_imageRiseBeyond; /* of GLSL 1.30 */
    return target_table[target].words ||
           (function_row(function)->result != TYPE_uint && !of_sampler);
}

/* Its faults. */
static int check_case(Test *t, const FunctionCase *row, const char *only)
{
    if (!exists(row->function, t->caller.target) || (only && strcmp(only, name_of(row))))
        return 0;
    t->row = row;
    t->function = row->function;
    t->tuples = t->moved = t->faults = 0;
    t->worst = 0;
    call_variants(t);
    print_message("%-26s %9.1e %9.1e %7d %d%s\n", name_of(row), row->bound, t->worst, t->tuples,
                  t->moved, t->faults ? "  TOO LARGE" : "");
    return t->faults;
}

static bool has_case(int function)
{
    for (int i = 0; i < case_count; i++)
        if (function_cases[i].function == function)
            return true;
    return false;
}

static int check_target(Test *t, Target target, const char *only)
{
    int faults = 0;
    if (!caller_open(&t->caller, target))
        fail_msg("%s", t->caller.error);
    print_message("%-26s %9s %9s %7s %s\n", target_table[target].name, "bound", "worst", "tuples",
                  "by neighbours");
    for (int i = 0; i < case_count; i++)
        faults += check_case(t, &function_cases[i], only);
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        if (kind_table[kind].lowering != LOWERING_VOLUME || has_case(FN_FIRST_MAP + kind))
            continue;
        const FunctionCase all = case_of_ranges((Kind)kind);
        faults += check_case(t, &all, only);
    }
    caller_close(&t->caller);
    return faults;
}

static void functions_are_their_references(void **state)
{
    (void)state;
    static Test test;
    const char *only = getenv("FUNCTION_ONLY");
    int faults =
        check_target(&test, TARGET_glsl330, only) + check_target(&test, TARGET_glsl110, only);
    assert_int_equal(faults, 0);
}

/* |z| = 2 has not escaped. All numbers are exact: c = -2 is the set's tip, where z is -2, 2, 2,
 * ...; of c = 1 z is 1, 2, 5. */
static const struct {
    Kind map;
    float x, y, cx, cy;
    int iterations, within; /* steps that stay within 2 */
} escapes[] = {
    {KIND_Mandel, 0, .5f, 0, 0, 8, 8},   {KIND_Mandel, .75f, .5f, 0, 0, 8, 1},
    {KIND_Mandel, .5f, .5f, 0, 0, 8, 8}, {KIND_Mandel, -3, 7.5f, 0, 0, 16, 16},
    {KIND_Mandel, .5f, 0, 0, 0, 8, 0},   {KIND_Julia, .5f, .5f, -2, 0, 8, 8},
    {KIND_Julia, 0, .5f, -2, 0, 8, 8},   {KIND_Julia, .5f, .5f, 2, 0, 8, 1},
    {KIND_Julia, .5f, .5f, 0, 2, 8, 1},  {KIND_Julia, .5f, .5f, 0, -2, 16, 1},
    {KIND_Julia, .75f, .5f, 1, 0, 8, 1}, {KIND_Julia, .5f, .5f, 2.5f, 0, 8, 0},
};

static void check_escape(Caller *caller, size_t i)
{
    static Tuple tuples[CALL_COUNT];
    static double results[CALL_COUNT][CALL_COMPONENTS];
    Job job;
    MatcOptions options;
    matc_options_init(&options);
    options.target = target_table[caller->target].name;
    assert_null(choice_job(&options, &job));
    memset(tuples, 0, sizeof tuples);
    tuples[0][0][0] = escapes[i].x;
    tuples[0][0][1] = escapes[i].y;
    tuples[0][1][0] = (float)escapes[i].iterations;
    tuples[0][2][0] = escapes[i].cx;
    tuples[0][3][0] = escapes[i].cy;
    const int function = FN_FIRST_MAP + (int)escapes[i].map;
    assert_true(call_gather(caller, function, &job));
    assert_true(call_draw(caller, function, tuples, results));
    double expected = 2. * escapes[i].within / escapes[i].iterations - 1;
    if (fabs(results[0][0] - expected) > 1e-6)
        fail_msg("%s %s, row %zu: is %g, should be %g", function_row(function)->name,
                 options.target, i, results[0][0], expected);
}

static void what_reaches_two_has_not_escaped(void **state)
{
    static const Target targets[] = {TARGET_glsl330, TARGET_glsl110};
    static Caller caller;
    (void)state;
    for (int k = 0; k < 2; k++) {
        assert_true(caller_open(&caller, targets[k]));
        for (size_t i = 0; i < sizeof escapes / sizeof *escapes; i++)
            check_escape(&caller, i);
        caller_close(&caller);
    }
}

static void every_library_function_has_a_case(void **state)
{
    (void)state;
    for (int i = 0; i < FN_FIRST_MAP; i++)
        if (!has_case(i))
            fail_msg("tests/functions.def has no case for %s", function_row(i)->name);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_library_function_has_a_case),
        cmocka_unit_test(what_reaches_two_has_not_escaped),
        cmocka_unit_test(functions_are_their_references),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
