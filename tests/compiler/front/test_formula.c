/* Formulas: the grammar, widths, error positions, totality; every example of expression.def.
 * Their values are compared with the oracle by test_expression.c, which has its own evaluator. */
#include "tests/test.h"
#include "compiler/formula/formula.h"
#include "compiler/library/reference.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    Arena arena;
    MatcOptions options;
    Session session;
} Fixture;

static void open_fixture(Fixture *f)
{
    memset(f, 0, sizeof *f);
    matc_options_init(&f->options);
    f->session = session_open(&f->options, &f->arena);
}

static Span plain_span(void *user, uint32_t start, uint32_t end)
{
    (void)user;
    return (Span){start, end, NO_FILE};
}

/* One input of each width: one, two, three, four. */
static int find(void *user, const char *name, const FormulaStep *step, int *width)
{
    static const char *const names[] = {"one", "two", "three", "four"};
    (void)user, (void)step;
    for (int i = 0; i < 4; i++)
        if (!strcmp(names[i], name)) {
            *width = i + 1;
            return i;
        }
    return FORMULA_UNKNOWN;
}

static Formula *read_sized(Fixture *f, const char *text, size_t size)
{
    const FormulaSource source = {.session = &f->session,
                                  .text = text,
                                  .size = (uint32_t)size,
                                  .span = plain_span,
                                  .input = find};
    return formula_read(&source);
}

static Formula *read_text(Fixture *f, const char *text)
{
    return read_sized(f, text, strlen(text));
}

/* At u = .25, v = .5, p = (1, 2, 3); inputs 1, (1, 2), (1, 2, 3), (1, 2, 3, 4). NAN: it is
 * faulty. */
static double value_of(const char *text, int component)
{
    Fixture f;
    open_fixture(&f);
    Formula *formula = read_text(&f, text);
    double result[4] = {NAN, NAN, NAN, NAN};
    if (formula) {
        static const double inputs[4][4] = {{1, 1, 1, 1}, {1, 2}, {1, 2, 3}, {1, 2, 3, 4}};
        const ReferenceContext noise = {.noise = REFERENCE_LATTICE};
        FormulaPoint point = {.inputs = inputs,
                              .noise = &noise,
                              .values = calloc(formula->count, sizeof *point.values)};
        static const double u[4] = {.25, .25, .25, .25}, v[4] = {.5, .5, .5, .5}, uv[4] = {.25, .5},
                            p[4] = {1, 2, 3};
        memcpy(point.quantity[QUANTITY_u], u, sizeof u);
        memcpy(point.quantity[QUANTITY_v], v, sizeof v);
        memcpy(point.quantity[QUANTITY_uv], uv, sizeof uv);
        memcpy(point.quantity[QUANTITY_p], p, sizeof p);
        formula_value(formula, &point, result);
        free(point.values);
    }
    arena_free(&f.arena);
    return result[component];
}

static void is_near(const char *text, double value)
{
    const double found = value_of(text, 0);
    if (!(fabs(found - value) <= 1e-12 * fmax(1, fabs(value))))
        fail_msg("%s is %.17g, not %.17g", text, found, value);
}

static void examples_are_as_they_say(void **state)
{
    (void)state;
    for (int i = 0; i < TERM_COUNT; i++) {
        char text[256];
        const char *end = NULL;
        for (const char *at = strstr(term_table[i].example, " = "); at; at = strstr(at + 1, " = "))
            end = at;
        assert_non_null(end);
        snprintf(text, sizeof text, "%.*s", (int)(end - term_table[i].example),
                 term_table[i].example);
        is_near(text, atof(end + 3));
        assert_true(term_table[i].doc[strlen(term_table[i].doc) - 1] == '.');
    }
}

static void operators_bind_as_in_mathematics(void **state)
{
    (void)state;
    is_near("1 + 2 * 3 ^ 2", 19);
    is_near("2 ^ 3 ^ 2", 512);
    is_near("-2 ^ 2", -4);
    is_near("2 ^ -2", .25);
    is_near("2 ^ -1 * 4", 2);
    is_near("(1 + 2) * 3", 9);
    is_near("10 - 4 - 3", 3);
    is_near("16 / 4 / 2", 2);
    is_near("7 % 4 * 2", 6);
    is_near("- - 3", 3);
    is_near("1 < 2 && 3 < 2 || 1 == 1 ? 1 : 0", 1);
    is_near("!(1 < 2) || 2 > 1 ? 4 : 5", 4);
    is_near("1 < 0 ? 1 : 1 < 2 ? 2 : 3", 2);
    is_near("1 < 2 ? 1 < 0 ? 5 : 6 : 7", 6);
    is_near("[1, 2, 3].z", 3);
    is_near("[1, 2, 3][1]", 2);
    is_near("-three.z", -3);
    is_near("three.xy.y * 2", 4);
    is_near("p.zyx.x", 3);
    is_near("[5, 6, 7].uvw.z", 7);
    is_near("[5, 6, 7].wv.x", 7);
    is_near("[5, 6, 7, 8].w", 8);
    is_near("vec3(uv, 7).z", 7);
    is_near("vec3(2).z", 2);
    is_near("vec4(p, 1).w", 1);
    is_near("a = u * 2; b = a + 1; a * b", .75);
    is_near("a = 2; a;", 2);
    is_near(" 1.5e1 + .5 + 2. ", 17.5);
    is_near("#f00.r", 1);
    is_near("#336699.b", .6);
    is_near("#33669980.a", 128. / 255);
    is_near("dot(three, 2)", 12);
    is_near("(three + 1).y", 3);
    is_near("pi", M_PI);
    is_near("contrast(.75, 2) + contrast(.75, 2, .5)", 2);
    is_near("fbm(p / 7, 3) - fbm(p / 7, 3, 2, .5)", 0);
    is_near("noise(p / 7) - fbm(p / 7, 1)", 0);
    is_near("pow(-2, 2)", 4);
    is_near("(-2) ^ 3 + 0 ^ -1 + 0 ^ 0", -7);
    is_near("(-2) ^ 2.5", pow(1e-37, 2.5));
}

/* Each has a fault, and so many of them. */
static void faults_are_reported(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int faults;
        DiagKind first;
        uint32_t at; /* its byte */
    } cases[] = {
        {"", 1, DIAG_formula_empty, 0},
        {"1 +", 1, DIAG_formula_wants, 3},
        {"* 2", 1, DIAG_formula_wants, 0},
        {"2 u", 1, DIAG_formula_operator, 2},
        {"(u", 1, DIAG_formula_not_closed, 0},
        {"u)", 1, DIAG_formula_closes, 1},
        {"[u, v)", 2, DIAG_formula_closes, 5},
        {"sin(u, v)", 1, DIAG_formula_arguments, 0},
        {"sin()", 1, DIAG_formula_arguments, 0},
        {"snn(u)", 1, DIAG_formula_no_function, 0},
        {"u + sin", 1, DIAG_formula_is_function, 4},
        {"u + qq", 1, DIAG_formula_unknown, 4},
        {"two + three", 1, DIAG_formula_widths, 4},
        {"1 + (u < v)", 1, DIAG_formula_argument, 2},
        {"u ? 1 : 2", 1, DIAG_formula_argument, 2},
        {"three < 1 ? 1 : 2", 1, DIAG_formula_argument, 6},
        {"u < v", 1, DIAG_formula_result, 2},
        {"1 < 2 < 3 ? 1 : 0", 1, DIAG_formula_argument, 6},
        {"u < v ? 1", 1, DIAG_formula_choice, 6},
        {"u : v", 1, DIAG_formula_choice, 2},
        {"u, v", 1, DIAG_formula_comma, 1},
        {"(u, v)", 1, DIAG_formula_comma, 2},
        {"uv.z", 1, DIAG_formula_components, 2},
        {"p.xg", 1, DIAG_formula_components, 1},
        {"p.xyzxy", 1, DIAG_formula_components, 1},
        {"p[3]", 1, DIAG_formula_components, 1},
        {"p[u]", 1, DIAG_formula_components, 1},
        {"[p, uv]", 1, DIAG_formula_list, 0},
        {"vec2(p)", 1, DIAG_formula_vector, 0},
        {"vec3()", 1, DIAG_formula_vector, 0},
        {"a = 1; a = 2; a", 1, DIAG_formula_local, 7},
        {"u = 1; u", 1, DIAG_formula_hides, 0},
        {"sin = 1; u", 1, DIAG_formula_hides, 0},
        {"a = 1;", 1, DIAG_formula_no_value, 6},
        {"u; v", 1, DIAG_formula_ends, 3},
        {"u + v = 2", 1, DIAG_formula_assigns, 6},
        {"fbm(p, u)", 1, DIAG_formula_whole, 7},
        {"fbm(p, 2.5)", 1, DIAG_formula_whole, 7},
        {"fbm(p, 99)", 1, DIAG_formula_whole, 7},
        {"fbm(uv, 3)", 1, DIAG_formula_argument, 0},
        {"u $ v", 2, DIAG_formula_other, 2},
        {"#12 + u", 1, DIAG_formula_other, 0},
        {"1e999", 1, DIAG_formula_other, 0},
        {"qq + snn(ww) * two.z", 4, DIAG_formula_no_function, 5},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Fixture f;
        open_fixture(&f);
        const Formula *formula = read_text(&f, cases[i].text);
        const Diag *first = f.session.diags.at;
        if (formula || f.session.diags.errors != cases[i].faults || first->kind != cases[i].first ||
            first->span.start != cases[i].at) {
            for (size_t k = 0; k < f.session.diags.count; k++)
                fprintf(stderr, "%s: %u: %s\n", cases[i].text, f.session.diags.at[k].span.start,
                        f.session.diags.at[k].message);
            fail_msg("'%s' has %d faults", cases[i].text, f.session.diags.errors);
        }
        arena_free(&f.arena);
    }
}

static void every_term_is_total(void **state)
{
    (void)state;
    static const char *const numbers[] = {"0",      "-1",  "1",    "-0.5",    "1e-38",
                                          "-1e-38", "1e6", "-1e6", "(0 - 0)", "3.4e38 * 0"};
    enum { NUMBERS = sizeof numbers / sizeof *numbers };
    unsigned seed = 1;
    for (int i = 0; i < TERM_COUNT; i++)
        for (int round = 0; term_table[i].callable && round < 200; round++) {
            char text[512];
            int size = snprintf(text, sizeof text, "%s(", term_table[i].name);
            for (int k = 0; k < term_table[i].count; k++) {
                const char letter = term_table[i].signature[k], *comma = k ? ", " : "";
                const int components = letter == '3' ? 3 : letter == '2' ? 2 : 1;
                size += snprintf(text + size, sizeof text - (size_t)size,
                                 components > 1 ? "%s[" : "%s", comma);
                for (int component = 0; component < components; component++) {
                    seed = seed * 1664525 + 1013904223;
                    size += snprintf(text + size, sizeof text - (size_t)size, "%s%s",
                                     component ? ", " : "",
                                     letter == 'i' ? "3" : numbers[(seed >> 8) % NUMBERS]);
                }
                size +=
                    snprintf(text + size, sizeof text - (size_t)size, components > 1 ? "]" : "");
            }
            snprintf(text + size, sizeof text - (size_t)size, ")");
            if (!isfinite(value_of(text, 0)))
                fail_msg("%s is %g", text, value_of(text, 0));
        }
}

/* Proposals for names that are not built in: a local, before and after its value; nothing if all
 * names are far. */
static void misspelt_names_are_reported(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"shade = u; shaed * 2", "did you mean 'shade'?"},
        {"shaed = grian; grain = 2; shaed", "did you mean 'grain'?"},
        {"shade = u; facng * shade", "did you mean 'facing'?"},
        {"shade = u; quite", "unknown name 'quite'"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Fixture f;
        open_fixture(&f);
        assert_null(read_text(&f, cases[i][0]));
        assert_int_equal(f.session.diags.errors, 1);
        const char *message = f.session.diags.at->message, *found = strstr(message, cases[i][1]);
        if (!found || strcmp(found, cases[i][1]))
            fail_msg("%s: %s", cases[i][0], message);
        arena_free(&f.arena);
    }
}

/* Messages about names of other languages are given for no name of ours. */
static void foreign_names_are_not_ours(void **state)
{
    static const char *const names[] = {
#define FOREIGN_FORMULA(name, here) #name,
#include "grammar/foreign.def"
    };
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const size_t size = strlen(names[i]);
        if (term_named(names[i], size) != TERM_none || vector_named(names[i], size) ||
            quantity_named(names[i], size) != QUANTITY_none ||
            formula_special_named(names[i], size) != SPECIAL_none)
            fail_msg("'%s' is foreign, and ours", names[i]);
    }
}

/* Texts made to exhaust stack, memory or time. */
static void hostile_texts_end(void **state)
{
    (void)state;
    static const char *const units[] = {"(",     "[",   "-",    "!",        "u?",    "u?u:", "sin(",
                                        "u+",    "u^",  "a=",   "u;",       ".x",    "[0]",  ",",
                                        ")",     "u<",  "\xff", "\xc3\xa9", "a0=u;", "1",    "u ",
                                        "vec3(", "u?(", "#fff", "\0"};
    enum { LONG = 1 << 21 };
    char *text = malloc(LONG + 1);
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        for (size_t size = 60000; size <= LONG; size = size < LONG ? LONG : size + 1) {
            const size_t unit = strlen(units[i]) ? strlen(units[i]) : 1;
            for (size_t k = 0; k < size; k++)
                text[k] = units[i][k % unit];
            text[size] = 0;
            Fixture f;
            open_fixture(&f);
            read_sized(&f, text, size);
            assert_true(f.session.diags.errors > 0 || size <= LIMIT_FORMULA);
            arena_free(&f.arena);
        }
    free(text);
}

/* Sums of 20,000 operands, locals of which each reads the one before, choices within choices: they
 * are read, in one walk. */
static void long_formulas_are_read(void **state)
{
    (void)state;
    enum { COUNT = 8000, CAPACITY = 65536 };
    char *text = malloc(CAPACITY);
    size_t size = 0;
    for (int i = 0; i < COUNT; i++)
        size += (size_t)snprintf(text + size, CAPACITY - size, "u+");
    snprintf(text + size, CAPACITY - size, "0");
    is_near(text, .25 * COUNT);
    size = 0;
    for (int i = 0; i < 2000; i++)
        size += (size_t)snprintf(text + size, CAPACITY - size, i ? "a%d=a%d+a%d*0;" : "a%d=1;", i,
                                 i - 1, i - 1);
    snprintf(text + size, CAPACITY - size, "a1999");
    is_near(text, 1);
    size = 0;
    for (int i = 0; i < 5000; i++)
        size += (size_t)snprintf(text + size, CAPACITY - size, "u>v?0:");
    snprintf(text + size, CAPACITY - size, "3");
    is_near(text, 3);
    size = 0;
    for (int i = 0; i < 20000; i++)
        text[size++] = '(';
    text[size++] = 'u';
    for (int i = 0; i < 20000; i++)
        text[size++] = ')';
    text[size] = 0;
    is_near(text, .25);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(examples_are_as_they_say),
        cmocka_unit_test(operators_bind_as_in_mathematics),
        cmocka_unit_test(faults_are_reported),
        cmocka_unit_test(misspelt_names_are_reported),
        cmocka_unit_test(every_term_is_total),
        cmocka_unit_test(foreign_names_are_not_ours),
        cmocka_unit_test(hostile_texts_end),
        cmocka_unit_test(long_formulas_are_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
