/* Parses operands: numbers, colors, names, calls, lists, brackets, prefix operators. */
#include "compiler/formula/formula_reader.h"
#include <string.h>

static const char *function_name(const void *user, int i)
{
    (void)user;
    if (i < TERM_COUNT)
        return term_table[i].callable ? term_table[i].name : NULL;
    i -= TERM_COUNT;
    return i < vector_count ? vector_table[i].name : formula_special_table[i - vector_count].name;
}

/* Parses the start of a call: name "(". */
static void open_call(FormulaReader *r, Token name)
{
    const uint32_t size = formula_token_size(name);
    const Term term = term_named(r->s->text + name.start, size);
    const int width = vector_named(r->s->text + name.start, size);
    FormulaWait wait = {WAIT_call, level_none, term, r->operand_count, name.start, name.end};
    if (width) {
        wait.kind = WAIT_list;
        wait.row = width;
    } else if (term == TERM_none) {
        const char *called = formula_word(r, name), *hint = formula_foreign(r->session, called);
        r->faults++;
        hint = hint ? hint
                    : diag_suggest(r->session, called, function_name, NULL,
                                   TERM_COUNT + vector_count + SPECIAL_COUNT);
        diag_add(r->session, formula_span(r, name.start, name.end), DIAG_formula_no_function,
                 called, hint);
    }
    formula_wait(r, wait);
}

/* Pushes a local's step, or a name for the check to resolve. */
static void read_name(FormulaReader *r, Token name)
{
    const int local = r->locals.count ? names_find(&r->locals, formula_word(r, name)) : -1;
    if (local >= 0)
        formula_push(r, r->local_steps[local]);
    else
        formula_push_step(
            r, (FormulaStep){.kind = FORMULA_name, .start = name.start, .end = name.end});
}

static void push_color(FormulaReader *r)
{
    uint32_t components[4];
    double color[4];
    const int count = formula_color(r->s, &r->token, color);
    FormulaStep step = {.kind = FORMULA_number, .start = r->token.start, .end = r->token.end};
    for (int i = 0; i < count; i++) {
        step.number = color[i];
        components[i] = formula_add(r->session, r->f, step, NULL, 0);
    }
    step.kind = FORMULA_list;
    formula_push(r, formula_add(r->session, r->f, step, components, (uint32_t)count));
}

static bool prefix(FormulaReader *r)
{
    for (int i = r->token.symbol; i < symbol_count; i++)
        if (symbol_table[i].level == level_prefix && formula_is(r, symbol_table[i].text)) {
            formula_wait(r, (FormulaWait){WAIT_prefix, level_prefix, symbol_table[i].term,
                                          r->operand_count, r->token.start, r->token.end});
            formula_next(r);
            return true;
        }
    return false;
}

/* Parses an operand. Returns false if an operand is still expected. */
bool formula_operand(FormulaReader *r)
{
    const Token token = r->token;
    if (prefix(r))
        return false;
    if (formula_read_if(r))
        return true;
    if (formula_is(r, "(") || formula_is(r, "[")) {
        formula_wait(r, (FormulaWait){formula_is(r, "(") ? WAIT_group : WAIT_list, level_none, 0,
                                      r->operand_count, token.start, token.end});
        formula_next(r);
        return false;
    }
    switch (token.kind) {
    case TOKEN_number:
        formula_push_step(r, (FormulaStep){.kind = FORMULA_number,
                                           .number = token.number,
                                           .start = token.start,
                                           .end = token.end});
        break;
    case TOKEN_color:
        push_color(r);
        break;
    case TOKEN_name:
        formula_next(r);
        if (!formula_is(r, "(")) {
            read_name(r, token);
            return true;
        }
        if (formula_special_named(r->s->text + token.start, formula_token_size(token)) ==
            SPECIAL_attribute) {
            formula_read_attribute(r, token);
            return true;
        }
        open_call(r, token);
        formula_next(r);
        return formula_is(r, ")"); /* a call without arguments is already complete */
    case TOKEN_text:
        formula_report_other(r);
        formula_push_fault(r);
        break;
    case TOKEN_other:
        formula_report_other(r);
        if (formula_is_large(r)) {
            formula_push_fault(r);
            break;
        }
        formula_pass_other(r);
        return false;
    default: /* the token is left to the operator parser */
        r->faults++;
        diag_add(r->session, formula_token_span(r), DIAG_formula_wants,
                 formula_token_text(r->s, r->token));
        formula_push_fault(r);
        return true;
    }
    formula_next(r);
    return true;
}
