/* Resolves names and widths of the steps in one walk, since operands precede users. Faulty steps
 * have an unknown width, and their users are not reported. */
#include "compiler/formula/formula_lex.h"
#include <math.h>
#include <string.h>

enum { MAX_COMPONENTS = 4, MAX_POWER = 64 };

typedef struct {
    const FormulaSource *s;
    Session *session;
    Formula *f;
    const Names *locals;
    bool *varies; /* per step: the result depends on the point or an input */
    bool failed;
} Check;

static Span span_of(const Check *c, const FormulaStep *step)
{
    return c->s->span(c->s->user, step->start, step->end);
}

static const FormulaStep *argument(const Check *c, const FormulaStep *step, uint32_t i)
{
    return &c->f->steps[formula_argument(c->f, step, i)];
}

static const char *width_text(int width)
{
    static const char *const words[] = {"a condition", "a number", "two components",
                                        "three components", "four components"};
    return width < 0 ? "something" : words[width];
}

/* Describes a value with that many components. */
static const char *holder_text(int width)
{
    static const char *const words[] = {"a condition", "a number", "a value of two components",
                                        "a value of three components",
                                        "a value of four components"};
    return width < 0 ? "something" : words[width];
}

static const char *component_names(int width)
{
    static const char *const names[] = {"xyzw, rgba or uvw", "x, r or u", "xy, rg or uv",
                                        "xyz, rgb or uvw"};
    return width < 0 || width == MAX_COMPONENTS ? names[0] : names[width];
}

static int fail(Check *c)
{
    c->failed = true;
    return WIDTH_unknown;
}

/* -- Names */

static const char *value_name(const void *user, int i)
{
    const Check *c = user;
    const int local = i - QUANTITY_COUNT, input = local - (int)c->locals->count;
    const NameChoice *inputs = &c->s->names;
    return local < 0   ? quantity_table[i].name
           : input < 0 ? c->locals->at[local]
                       : inputs->name(inputs->user, input);
}

static const char *value_suggested(const Check *c, const char *name)
{
    return diag_suggest(c->session, name, value_name, c,
                        QUANTITY_COUNT + (int)c->locals->count + c->s->names.count);
}

/* Resolves a built-in value that is an attribute of the mesh. */
static int find_attribute(Check *c, FormulaStep *step, const QuantityRow *row)
{
    const double all = row->number;
    const FormulaAttribute given = {
        row->attribute, row->type, {all, all, all, all}, step->start, step->end};
    const int number = c->s->attribute(c->s->user, &given);
    if (number < 0)
        return fail(c);
    step->kind = FORMULA_attribute;
    step->row = number;
    return type_table[row->type].components;
}

static int find_name(Check *c, FormulaStep *step)
{
    const uint32_t size = step->end - step->start;
    const Quantity quantity = quantity_named(c->s->text + step->start, size);
    int width = 0;
    if (quantity != QUANTITY_none) {
        const QuantityRow *row = &quantity_table[quantity];
        if (row->attribute)
            return find_attribute(c, step, row);
        step->kind = row->components ? FORMULA_value : FORMULA_number;
        step->row = quantity;
        step->number = row->number;
        c->f->groups |= row->components ? 1u << row->group : 0;
        return quantity_width(quantity);
    }
    const char *name = arena_string(c->session->arena, c->s->text + step->start, size);
    const int input = c->s->input(c->s->user, name, step, &width);
    if (input >= 0) {
        step->kind = FORMULA_input;
        step->row = input;
        c->f->inputs = input >= c->f->inputs ? input + 1 : c->f->inputs;
        return width;
    }
    const bool called = term_named(name, size) != TERM_none || vector_named(name, size) ||
                        formula_special_named(name, size) != SPECIAL_none;
    if (input == FORMULA_UNKNOWN && called)
        diag_add(c->session, span_of(c, step), DIAG_formula_is_function, name, name);
    else if (input == FORMULA_UNKNOWN) {
        const char *hint = formula_foreign(c->session, name);
        hint = hint ? hint : value_suggested(c, name);
        diag_add(c->session, span_of(c, step), DIAG_formula_unknown, name, hint);
    }
    return fail(c);
}

/* -- Terms */

static const char *count_text(const Check *c, const TermRow *row)
{
    Text text = text_new(c->session->arena);
    if (row->least && row->least < row->count)
        text_format(&text, "%d to ", row->least);
    text_format(&text, "%d argument%s", row->count, row->count == 1 ? "" : "s");
    return text.at;
}

/* Reads a literal integer with an optional minus sign. */
static bool whole_of(const Check *c, const FormulaStep *step, double *number)
{
    const bool minus = step->kind == FORMULA_term && step->row == TERM_negate;
    const FormulaStep *plain = minus ? argument(c, step, 0) : step;
    *number = minus ? -plain->number : plain->number;
    return plain->kind == FORMULA_number && plain->number == trunc(plain->number);
}

static bool check_whole(Check *c, const FormulaStep *step, const TermRow *row,
                        const FormulaStep *given)
{
    double number;
    if (whole_of(c, given, &number) && number >= row->whole_low && number <= row->whole_high)
        return true;
    diag_add(c->session, span_of(c, given->end ? given : step), DIAG_formula_whole, row->name,
             row->whole_low, row->whole_high);
    return false;
}

/* Returns a hint how to convert an argument to the wanted width. */
static const char *width_mend(int wanted, int width)
{
    if (wanted == 3 && width == 2)
        return "; `[a, 0]` extends two components to three";
    if (wanted == 2 && width > 2)
        return "; `a.xy` has two";
    return wanted == 3 && width == 4  ? "; `a.xyz` has three"
           : wanted == 1 && width > 1 ? "; `a.x` is one"
                                      : "";
}

/* Checks an argument against its letter of the signature. *widest: max width of the arguments of
 * any width. */
static bool check_argument(Check *c, const FormulaStep *step, uint32_t i, int *widest)
{
    const TermRow *row = &term_table[step->row];
    const FormulaStep *given = argument(c, step, i);
    const char letter = row->signature[i];
    const int width = given->width, wanted = letter >= '1' && letter <= '4' ? letter - '0'
                                             : letter == 'b'                ? WIDTH_condition
                                                                            : letter == 'i';
    if (letter == 'i')
        return check_whole(c, step, row, given);
    if (letter == 'g' && width != WIDTH_condition) {
        if (*widest > 1 && width > 1 && width != *widest) {
            diag_add(c->session, span_of(c, step), DIAG_formula_widths,
                     term_symbol((Term)step->row), width_text(*widest), width_text(width));
            return false;
        }
        *widest = width > *widest ? width : *widest;
        return true;
    }
    if (letter != 'g' && (width == wanted || (width == 1 && wanted > 1)))
        return true;
    diag_add(c->session, span_of(c, step), DIAG_formula_argument, term_symbol((Term)step->row),
             letter == 'g' ? "numbers" : width_text(wanted), width_text(width),
             letter == 'g' ? "" : width_mend(wanted, width));
    return false;
}

/* Converts a ^ 3 to a product. */
static void make_power(Check *c, FormulaStep *step)
{
    double number;
    if (step->row != TERM_pow || !whole_of(c, argument(c, step, 1), &number) ||
        fabs(number) > MAX_POWER)
        return;
    step->kind = FORMULA_power;
    step->number = number;
    step->count = 1;
    step->width = argument(c, step, 0)->width;
}

static int check_term(Check *c, FormulaStep *step)
{
    const TermRow *row = &term_table[step->row];
    int widest = 1;
    if (step->count != (uint32_t)row->count) {
        diag_add(c->session, span_of(c, step), DIAG_formula_arguments, row->name,
                 count_text(c, row), (int)step->count);
        return fail(c);
    }
    for (uint32_t i = 0; i < step->count; i++)
        if (!check_argument(c, step, i, &widest))
            return fail(c);
    const char result = term_result(row);
    step->width = (int8_t)(result == 'g' ? widest : result == 'b' ? WIDTH_condition : result - '0');
    make_power(c, step);
    return step->width;
}

/* -- Swizzles and lists */

static int check_components(Check *c, const FormulaStep *step)
{
    const int width = argument(c, step, 0)->width;
    const int size = (int)(step->end - step->start);
    for (int i = 0; i < step->width; i++)
        if (width < 1 || (step->row >> 2 * i & 3) >= width) {
            const char *letters =
                arena_string(c->session->arena, c->s->text + step->start, (size_t)size);
            diag_add(c->session, span_of(c, step), DIAG_formula_components, holder_text(width),
                     letters + (*letters == '.'), component_names(width));
            return fail(c);
        }
    return step->width;
}

static int check_list(Check *c, const FormulaStep *step)
{
    int components = 0;
    for (uint32_t i = 0; i < step->count; i++) {
        const int width = argument(c, step, i)->width;
        if (width == WIDTH_condition) {
            diag_add(c->session, span_of(c, step), DIAG_formula_argument, "a vector", "numbers",
                     width_text(width), "");
            return fail(c);
        }
        components += width;
    }
    if (step->row && (components == step->row || (components == 1 && step->count == 1)))
        return step->row;
    if (!step->row && components >= 1 && components <= MAX_COMPONENTS)
        return components;
    if (step->row)
        diag_add(c->session, span_of(c, step), DIAG_formula_vector,
                 arena_string(c->session->arena, c->s->text + step->start, step->end - step->start),
                 (int)step->row, components);
    else
        diag_add(c->session, span_of(c, step), DIAG_formula_list, components);
    return fail(c);
}

/* Returns true if all arguments have a known width, so none is faulty. */
static bool are_known(const Check *c, const FormulaStep *step)
{
    for (uint32_t i = 0; i < step->count; i++)
        if (argument(c, step, i)->width == WIDTH_unknown)
            return false;
    return true;
}

static int width_of(Check *c, FormulaStep *step)
{
    if (step->kind == FORMULA_fault || !are_known(c, step))
        return fail(c);
    switch (step->kind) {
    case FORMULA_number:
        return 1;
    case FORMULA_attribute:
        return step->width;
    case FORMULA_name:
        return find_name(c, step);
    case FORMULA_term:
        return check_term(c, step);
    case FORMULA_components:
        return check_components(c, step);
    default:
        return check_list(c, step);
    }
}

/* Returns true if a step jumps. A power with an exponent below 1 is infinitely steep at 0. */
static bool jumps(const Formula *f, const FormulaStep *step)
{
    if (step->kind != FORMULA_term || !term_table[step->row].jumps)
        return false;
    const bool power = step->row == TERM_pow || step->row == TERM_safepow;
    const FormulaStep *exponent = power ? &f->steps[formula_argument(f, step, 1)] : NULL;
    return !exponent || exponent->kind != FORMULA_number || exponent->number < 1;
}

/* Propagates whether a value varies, jumps, or reads the mesh. */
static void measure(Check *c, uint32_t number)
{
    const FormulaStep *step = &c->f->steps[number];
    c->varies[number] = step->kind == FORMULA_value || step->kind == FORMULA_input ||
                        step->kind == FORMULA_attribute;
    c->f->meshed |= step->kind == FORMULA_attribute;
    for (uint32_t i = 0; i < step->count; i++)
        c->varies[number] |= c->varies[formula_argument(c->f, step, i)];
    c->f->jumps |= c->varies[number] && jumps(c->f, step);
}

bool formula_check(const FormulaSource *source, Formula *f, const Names *locals)
{
    const uint32_t count = (uint32_t)f->count;
    Check c = {.s = source, .session = source->session, .f = f, .locals = locals};
    c.varies = ARENA_ARRAY(c.session->arena, bool, count);
    for (uint32_t i = 0; i < count; i++) {
        const int width = width_of(&c, &f->steps[i]);
        f->steps[i].width = (int8_t)width;
        measure(&c, i);
    }
    f->width = f->steps[f->result].width;
    f->varies = c.varies[f->result];
    if (f->width == WIDTH_condition)
        diag_add(c.session, span_of(&c, &f->steps[f->result]), DIAG_formula_result);
    return !c.failed && f->width > 0;
}
