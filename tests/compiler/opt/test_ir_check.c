/* ir_check refuses an IR that breaks any of its invariants, and names the invariant. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/ir/ir.h"
#include <string.h>

/* Faults that the text form cannot express are made in the node that the output names. */
static void drop_operand(Ir *ir, Ref ref) { ir->nodes[ref].count--; }
static void name_itself(Ir *ir, Ref ref) { ir->args[ir->nodes[ref].first] = ref; }
static void name_none(Ir *ir, Ref ref) { ir->args[ir->nodes[ref].first] = 0; }
static void become_float(Ir *ir, Ref ref) { ir->nodes[ref].type = TYPE_float; }
static void become_vec2(Ir *ir, Ref ref) { ir->nodes[ref].type = TYPE_vec2; }
static void overflow(Ir *ir, Ref ref) { ir->numbers[ir->nodes[ref].payload] = INFINITY; }
static void name_no_function(Ir *ir, Ref ref)
{
    ir->nodes[ref].payload = (uint32_t)ir->function_count;
}
static void move_result(Ir *ir, Ref ref) { ir->functions[ir->nodes[ref].payload].result = ref; }

typedef struct {
    const char *text, *fault; /* NULL: none */
    void (*spoil)(Ir *ir, Ref output);
} Case;

#define POINT                                                                                      \
    "%1 = input vec3 X\n"                                                                          \
    "%2 = swizzle float .x %1\n"                                                                   \
    "%3 = input vec2 U\n"                                                                          \
    "%4 = input bool front\n"                                                                      \
    "%5 = const float 2.0\n"                                                                       \
    "%6 = const int 3.0\n"
#define FUNCTION_F0                                                                                \
    "%7 = argument vec3 0.0\n"                                                                     \
    "%8 = call float noise %7\n"                                                                   \
    "function f0 = %8 %7\n"

static const Case sound[] = {
    {POINT "%9 = mul vec3 %1 %5\nout color 0 = %9\n", NULL, NULL},
    {POINT FUNCTION_F0 "%9 = apply float f0 %1\nout color 0 = %9\n", NULL, NULL},
    {POINT FUNCTION_F0 "%9 = kernel float f0 %1 %1\nout color 0 = %9\n", NULL, NULL},
    {POINT "%9 = linear vec2 %3 %3 %3\nout color 0 = %9\n", NULL, NULL},
    {POINT "%9 = ne bool %4 %4\nout color 0 = %9\n", NULL, NULL},
    /* what nothing reaches may be anything */
    {POINT "%9 = add vec3 %1 %3\nout color 0 = %2\n", NULL, NULL},
    {POINT "%7 = argument vec3 0.0\n%8 = argument vec3 1.0\n%9 = add vec3 %7 %8\nfunction f0 = %9 "
           "%7\nout color 0 = %2\n",
     NULL, NULL},
};

static const Case arithmetic[] = {
    {POINT "%9 = add float %2 %5\nout color 0 = %9\n", "a node has the wrong number of operands",
     drop_operand},
    {POINT "%9 = add float %2 %5\nout color 0 = %9\n", "an operand comes after its user",
     name_itself},
    {POINT "%9 = add float %2 %5\nout color 0 = %9\n", "an operand comes after its user",
     name_none},
    {POINT "%9 = add float %4 %4\nout color 0 = %9\n", "an operand of arithmetic is not a number",
     NULL},
    {POINT "%9 = mul float %2 %6\nout color 0 = %9\n", "an operand of arithmetic is not a number",
     NULL},
    {POINT "%9 = add vec3 %1 %3\nout color 0 = %9\n",
     "operands of arithmetic have different widths", NULL},
    {POINT "%9 = mix vec3 %1 %1 %3\nout color 0 = %9\n",
     "operands of arithmetic have different widths", NULL},
    {POINT "%9 = mul vec3 %1 %5\nout color 0 = %9\n",
     "the width of a result differs from its operands", become_float},
    {POINT "%9 = mul float %2 %5\nout color 0 = %9\n",
     "the width of a result differs from its operands", become_vec2},
    {POINT "%9 = const float 1.0\nout color 0 = %9\n", "a constant is not finite", overflow},
};

static const Case truths[] = {
    {POINT "%9 = lt bool %1 %1\nout color 0 = %9\n", "operands of a comparison do not fit", NULL},
    {POINT "%9 = lt bool %2 %6\nout color 0 = %9\n", "operands of a comparison do not fit", NULL},
    {POINT "%9 = eq bool %4 %2\nout color 0 = %9\n", "operands of a comparison do not fit", NULL},
    {POINT "%9 = and bool %2 %2\nout color 0 = %9\n", "operands of a comparison do not fit", NULL},
    {POINT "%9 = or bool %2 %5\nout color 0 = %9\n", "operands of a comparison do not fit", NULL},
    {POINT "%9 = not bool %2\nout color 0 = %9\n", "operands of a comparison do not fit", NULL},
    {POINT "%9 = le bool %2 %5\nout color 0 = %9\n", "a comparison is not a truth value",
     become_float},
    {POINT "%9 = select float %2 %2 %5\nout color 0 = %9\n",
     "a select's condition is not a truth value", NULL},
    {POINT "%9 = select vec3 %4 %1 %5\nout color 0 = %9\n", "a select's arms have another type",
     NULL},
    {POINT "%9 = select vec3 %4 %5 %1\nout color 0 = %9\n", "a select's arms have another type",
     NULL},
    {POINT "%9 = select float %4 %1 %1\nout color 0 = %9\n", "a select's arms have another type",
     NULL},
};

static const Case vectors[] = {
    {POINT "%9 = vec vec4 %1 %3\nout color 0 = %9\n", "a vector's parts do not fill it", NULL},
    {POINT "%9 = vec vec4 %1\nout color 0 = %9\n", "a vector's parts do not fill it", NULL},
    {POINT "%9 = vec float %2\nout color 0 = %9\n", "a vector's parts do not fill it", NULL},
    {POINT "%9 = linear vec2 %3 %3 %1\nout color 0 = %9\n",
     "a matrix and its vector have different widths", NULL},
    {POINT "%9 = linear vec2 %1 %3 %3\nout color 0 = %9\n",
     "a matrix and its vector have different widths", NULL},
    {POINT "%9 = linear vec2 %3 %3\nout color 0 = %9\n", "a matrix has the wrong number of columns",
     NULL},
    {POINT "%9 = linear vec2 %3 %3 %3 %3\nout color 0 = %9\n",
     "a matrix has the wrong number of columns", NULL},
    {POINT "%9 = swizzle float .z %3\nout color 0 = %9\n",
     "a swizzle uses a component that does not exist", NULL},
    {POINT "%9 = swizzle vec2 .xw %1\nout color 0 = %9\n",
     "a swizzle uses a component that does not exist", NULL},
};

static const Case calls[] = {
    {POINT "%9 = call float noise\nout color 0 = %9\n", "a call has the wrong number of arguments",
     NULL},
    {POINT "%9 = call float noise %1 %1\nout color 0 = %9\n",
     "a call has the wrong number of arguments", NULL},
    {POINT "%9 = call float noise %2\nout color 0 = %9\n", "a call's argument has the wrong type",
     NULL},
    {POINT "%9 = call uint unormBits %2 %5\nout color 0 = %9\n",
     "a call's argument has the wrong type", NULL},
    {POINT "%9 = call float turbulence %1 %6 %5 %6\nout color 0 = %9\n",
     "a call's argument has the wrong type", NULL},
    {POINT "%9 = call vec3 noise %1\nout color 0 = %9\n", "a call has the wrong type", NULL},
};

static const Case functions[] = {
    {POINT FUNCTION_F0 "%9 = apply float f0\nout color 0 = %9\n",
     "an application does not fit its function", NULL},
    {POINT FUNCTION_F0 "%9 = apply float f0 %1 %1\nout color 0 = %9\n",
     "an application does not fit its function", NULL},
    {POINT FUNCTION_F0 "%9 = apply float f0 %1\nout color 0 = %9\n",
     "an application does not fit its function", name_no_function},
    {POINT FUNCTION_F0 "%9 = apply float f0 %3\nout color 0 = %9\n",
     "an application's argument has the wrong type", NULL},
    {POINT FUNCTION_F0 "%9 = apply vec3 f0 %1\nout color 0 = %9\n",
     "an application has the wrong type", NULL},
    {POINT FUNCTION_F0 "%9 = apply float f0 %1\nout color 0 = %9\n",
     "a function's result comes after its call", move_result},
    {POINT FUNCTION_F0 "%9 = kernel float f0 %1\nout color 0 = %9\n",
     "a kernel does not fit its function", NULL},
    {POINT FUNCTION_F0 "%9 = kernel float f0 %1 %2\nout color 0 = %9\n",
     "a kernel does not fit its function", NULL},
    {POINT FUNCTION_F0 "%9 = kernel float f0 %1 %1\nout color 0 = %9\n",
     "a kernel does not fit its function", name_no_function},
    {POINT FUNCTION_F0 "out color 0 = %8\n", "an argument is read outside its function", NULL},
    {POINT FUNCTION_F0 "%9 = apply float f0 %1\n%10 = mul vec3 %7 %9\nout color 0 = %10\n",
     "an argument is read outside its function", NULL},
    /* the other's is read by the last operand, by the first, and by the only one */
    {POINT FUNCTION_F0
     "%9 = argument vec3 1.0\n%10 = add vec3 %9 %7\nfunction f1 = %10 %9\n%11 = apply vec3 f1 %1\n"
     "out color 0 = %11\n",
     "a function reads another's argument", NULL},
    {POINT FUNCTION_F0
     "%9 = argument vec3 1.0\n%10 = add vec3 %7 %9\nfunction f1 = %10 %9\n%11 = apply vec3 f1 %1\n"
     "out color 0 = %11\n",
     "a function reads another's argument", NULL},
    {POINT FUNCTION_F0
     "%9 = argument vec3 1.0\nfunction f1 = %8 %9\n%11 = apply float f1 %1\nout color 0 = %11\n",
     "a function reads another's argument", NULL},
    /* one that another function calls, with the caller's argument for its own */
    {POINT FUNCTION_F0 "%9 = argument vec3 1.0\n%10 = apply float f0 %9\n%11 = mul vec3 %7 "
                       "%10\nfunction f1 = %11 %9\n"
                       "%12 = apply vec3 f1 %1\nout color 0 = %12\n",
     "a function reads another's argument", NULL},
};

static bool says(const char *fault, const char *wanted)
{
    return !fault || !wanted ? fault == wanted : !strcmp(fault, wanted);
}

static int check(const Case *c)
{
    Arena arena = {0};
    Session compile = {.arena = &arena};
    Graph graph = {0};
    const char *fault = NULL;
    Ir *ir = ir_read(&compile, c->text, &graph, &fault);
    if (!ir)
        fail_msg("%s%s", c->text, fault);
    if (c->spoil)
        c->spoil(ir, ir->outputs[0].value);
    fault = ir_check(ir);
    bool good = says(fault, c->fault);
    if (!good)
        print_error("%ssaid: %s\nwanted: %s\n\n", c->text, fault ? fault : "nothing",
                    c->fault ? c->fault : "nothing");
    ir_done(ir);
    arena_free(&arena);
    return !good;
}

static int check_all(const Case *cases, size_t count)
{
    int failed = 0;
    for (size_t i = 0; i < count; i++)
        failed += check(&cases[i]);
    return failed;
}

#define CHECK(cases) assert_int_equal(check_all(cases, sizeof cases / sizeof *cases), 0)

static void what_is_sound_passes(void **state)
{
    (void)state;
    CHECK(sound);
}

static void every_broken_invariant_is_named(void **state)
{
    (void)state;
    CHECK(arithmetic);
    CHECK(truths);
    CHECK(vectors);
    CHECK(calls);
    CHECK(functions);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_sound_passes),
        cmocka_unit_test(every_broken_invariant_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
