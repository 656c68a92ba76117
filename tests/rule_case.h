/* Results of an optimizer pass on expressions, against results worked out by hand; both versions
 * are also evaluated and compared. */
#ifndef TESTS_RULE_CASE_H
#define TESTS_RULE_CASE_H
#include "compiler/ir/fold.h"
#include "tests/stress/choices.h"
#include "tests/value/expression.h"
#include "tests/value/ir_site.h"
#include <math.h>
#include <string.h>

/* Expected result for an expression; NULL: unchanged. */
typedef struct {
    const char *text, *becomes;
} RuleCase;

/* Makes an IR that already contains the leaves, x the youngest: commutative operands are ordered
 * by age. */
static inline Ir *rule_open(Site *s)
{
    static const char *const leaves[] = {"front", "u", "w", "v", "z", "y", "x"};
    site_open(s);
    for (size_t i = 0; i < sizeof leaves / sizeof *leaves; i++)
        expression_read(s->ir, leaves[i]);
    return s->ir;
}

/* Number of coordinates that points are made of: border values and both signs. */
enum { RULE_POINTS = 40 };

static inline void rule_point(int number, double inputs[INPUT_COUNT][4])
{
    static const double coordinates[] = {0, 0.25, -0.25, 1, -1, 2, -2.5, 7.75, 1e-3, -300};
    Choices choices;
    choices_random(&choices, 9, (uint64_t)number);
    for (int i = 0; i < INPUT_COUNT; i++)
        for (int component = 0; component < 4; component++)
            inputs[i][component] =
                coordinates[choose(&choices, sizeof coordinates / sizeof *coordinates)];
    inputs[INPUT_front][0] = number % 2;
}

/* Checks that wherever the original is finite, the result is equal up to rounding. */
static inline void rule_check_values(const char *text, const Ir *before, const Ir *after)
{
    const ReferenceContext context = {.noise = before->noise};
    for (int i = 0; i < RULE_POINTS; i++) {
        double inputs[INPUT_COUNT][4], a[MAX_OUTPUTS][4], b[MAX_OUTPUTS][4];
        rule_point(i, inputs);
        ir_eval(before, &context, (const double(*)[4])inputs, a);
        ir_eval(after, &context, (const double(*)[4])inputs, b);
        for (int component = 0; component < ir_components(before, before->outputs[0].value);
             component++)
            if (isfinite(a[0][component]) && !(fabs(a[0][component] - b[0][component]) <=
                                               1e-13 * fmax(1, fabs(a[0][component]))))
                fail_msg("%s: lane %d is %.17g, was %.17g at %g %g %g", text, component,
                         b[0][component], a[0][component], inputs[INPUT_X][0], inputs[INPUT_X][1],
                         inputs[INPUT_X][2]);
    }
}

static inline const char *rule_printed(Site *p, const Ir *ir)
{
    Text text = text_new(&p->arena);
    expression_print(&text, ir, ir->outputs[0].value);
    return text.at;
}

static inline void rule_add_output(Ir *ir, const char *text)
{
    Ref ref = expression_read(ir, text);
    if (!ref)
        fail_msg("%s: cannot be read", text);
    ir_output(ir, OUT_color, 0, ref);
}

static inline bool rule_check(const RuleCase *c, bool (*pass)(Ir *ir), bool as_made)
{
    Site sites[2];
    Ir *before = rule_open(&sites[0]), *after = rule_open(&sites[1]);
    rule_add_output(before, c->text);
    after->simplify = as_made ? opt_simplify : NULL;
    rule_add_output(after, c->text);
    pass(after);
    const char *got = rule_printed(&sites[1], after),
               *wanted = c->becomes ? c->becomes : rule_printed(&sites[0], before);
    bool good = !strcmp(got, wanted);
    if (!good)
        print_error("%s: became %s instead of %s\n", c->text, got, wanted);
    assert_null(ir_check(after));
    rule_check_values(c->text, before, after);
    site_close(&sites[0]);
    site_close(&sites[1]);
    return good;
}

/* Returns the number of failing cases. */
static inline int rule_check_all(const RuleCase *cases, size_t count, bool (*pass)(Ir *ir),
                                 bool as_made)
{
    int failed = 0;
    for (size_t i = 0; i < count; i++)
        failed += !rule_check(&cases[i], pass, as_made);
    return failed;
}

#define RULE_CHECK(cases, pass, as_made)                                                           \
    rule_check_all(cases, sizeof cases / sizeof *cases, pass, as_made)
#endif
