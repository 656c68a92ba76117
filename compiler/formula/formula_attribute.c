/* Parses attribute("wetness", float, 0), a vertex attribute of the mesh. Its arguments are not
 * values, so it needs its own parser.
 *
 *     attribute("name", type [, default])    type: float, vec2, vec3, vec4; default: a
 *                                            number, a list of numbers, a color; 0 if
 *                                            omitted */
#include "compiler/formula/formula_reader.h"
#include <string.h>

enum { LONGEST_NAME = LIMIT_NAME - 16 }; /* the shader's name has a prefix and a suffix */

static void say(FormulaReader *r, const char *what)
{
    r->faults++;
    diag_add(r->session, formula_token_span(r), DIAG_formula_attribute, what,
             formula_token_text(r->s, r->token));
}

/* Takes a symbol, or reports that it is missing. */
static bool take(FormulaReader *r, const char *symbol, const char *what)
{
    const bool is = formula_is(r, symbol);
    if (is)
        formula_next(r);
    else
        say(r, what);
    return is;
}

/* Returns true for a letter followed by letters, digits and single '_', valid inside a GLSL
 * identifier. */
static bool is_name(const char *name, size_t size)
{
    bool fine = size > 0 && size <= LONGEST_NAME && text_is_letter(*name) && name[size - 1] != '_';
    for (size_t i = 0; fine && i < size; i++)
        fine = text_is_alphanumeric(name[i]) || (name[i] == '_' && name[i + 1] != '_');
    return fine;
}

static bool read_name(FormulaReader *r, FormulaAttribute *made)
{
    const char *text = r->s->text + r->token.start + 1;
    const uint32_t size = formula_token_size(r->token);
    if (r->token.kind != TOKEN_text) {
        say(r, "its name in quotes");
        return false;
    }
    made->start = r->token.start, made->end = r->token.end;
    made->name = arena_string(r->session->arena, text, size - 2);
    if (!is_name(made->name, size - 2)) {
        r->faults++;
        diag_add(r->session, formula_token_span(r), DIAG_attribute_name, made->name,
                 (int)LONGEST_NAME);
        return false;
    }
    formula_next(r);
    return true;
}

static bool read_type(FormulaReader *r, Type *type)
{
    for (int i = TYPE_float; i <= TYPE_vec4; i++)
        if (r->token.kind == TOKEN_name && !strcmp(type_table[i].name, formula_word(r, r->token))) {
            *type = (Type)i;
            formula_next(r);
            return true;
        }
    say(r, "a type, which is float, vec2, vec3 or vec4,");
    return false;
}

static bool read_number(FormulaReader *r, double *number)
{
    const bool minus = formula_is(r, "-");
    if (minus)
        formula_next(r);
    if (r->token.kind != TOKEN_number) {
        say(r, "a number");
        return false;
    }
    *number = minus ? -r->token.number : r->token.number;
    formula_next(r);
    return true;
}

/* Parses [1, 0, -2] after its bracket. Returns the number of components, 0 for a fault. */
static int read_list(FormulaReader *r, double components[FORMULA_MAX_COMPONENTS])
{
    int count = 0;
    formula_next(r);
    do {
        if (count == FORMULA_MAX_COMPONENTS) {
            say(r, "']'");
            return 0;
        }
        if (count && !take(r, ",", "a ',' or a ']'"))
            return 0;
        if (!read_number(r, &components[count++]))
            return 0;
    } while (!formula_is(r, "]"));
    formula_next(r);
    return count;
}

static int read_components(FormulaReader *r, double components[FORMULA_MAX_COMPONENTS])
{
    if (formula_is(r, "["))
        return read_list(r, components);
    if (r->token.kind == TOKEN_color) {
        const int count = formula_color(r->s, &r->token, components);
        formula_next(r);
        return count;
    }
    return read_number(r, components) ? 1 : 0;
}

/* A single number is copied to all components; a color without alpha is opaque. */
static bool read_default(FormulaReader *r, FormulaAttribute *made)
{
    const int components = type_table[made->type].components;
    const Token first = r->token;
    const int count = read_components(r, made->initial);
    if (!count)
        return false;
    for (int i = 1; count == 1 && i < FORMULA_MAX_COMPONENTS; i++)
        made->initial[i] = made->initial[0];
    if (count == 3 && components == 4 && first.kind == TOKEN_color)
        made->initial[3] = 1;
    else if (count != 1 && count != components) {
        r->faults++;
        diag_add(r->session, formula_span(r, first.start, first.end), DIAG_attribute_default, count,
                 type_table[made->type].name);
        return false;
    }
    return true;
}

static bool read_whole(FormulaReader *r, FormulaAttribute *made)
{
    formula_next(r); /* takes the bracket, which was already checked */
    if (!read_name(r, made) || !take(r, ",", "a ',' and a type") || !read_type(r, &made->type))
        return false;
    if (formula_is(r, ",")) {
        formula_next(r);
        if (!read_default(r, made))
            return false;
    }
    return take(r, ")", "a ')'");
}

/* Skips to the token after the closing bracket. */
static void skip(FormulaReader *r)
{
    while (r->token.kind != TOKEN_end && !formula_is(r, ")") && !formula_is(r, ";"))
        formula_next(r);
    if (formula_is(r, ")"))
        formula_next(r);
}

void formula_read_attribute(FormulaReader *r, Token name)
{
    FormulaAttribute made = {0};
    const bool whole = read_whole(r, &made);
    const int number = whole ? r->s->attribute(r->s->user, &made) : FORMULA_REPORTED;
    if (!whole)
        skip(r);
    if (number < 0) {
        r->faults += whole;
        formula_push_fault(r);
        return;
    }
    formula_push_step(r, (FormulaStep){.kind = FORMULA_attribute,
                                       .row = number,
                                       .width = (int8_t)type_table[made.type].components,
                                       .start = name.start,
                                       .end = name.end});
}
