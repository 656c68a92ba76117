/* Operator-precedence parser: text -> steps, with explicit stacks, so that nesting does not use
 * the call stack.
 *
 *     1 + 2 * u ^ 2      operands 1           operators +
 *                        operands 1 2 u 2     operators + * ^: each binds tighter than the
 *                                             one before, so it is stacked
 *                        at the end ^, * and + are applied, the last one first
 *
 * Parsing continues after a fault if possible, so that one run reports several. */
#include "compiler/formula/formula_reader.h"
#include <string.h>

/* Parses a value up to ';' or the end. Returns its step. */
static uint32_t read_value(FormulaReader *r)
{
    bool behind = false, ended = false;
    r->operand_count = r->wait_count = 0;
    while (!ended && r->faults < FORMULA_MAX_FAULTS)
        behind = behind ? formula_operator(r, &ended) : formula_operand(r);
    if (!ended) /* after too many faults stacked operators may lack operands */
        return 0;
    for (formula_reduce_to(r, level_none, true); r->wait_count;
         formula_reduce_to(r, level_none, true)) {
        const FormulaWait *open = &r->waits[--r->wait_count];
        if (r->faults++ < FORMULA_MAX_FAULTS)
            diag_add(
                r->session, formula_span(r, open->start, open->end), DIAG_formula_not_closed,
                formula_token_text(
                    r->s, (Token){.kind = TOKEN_name, .start = open->start, .end = open->end}));
    }
    return r->operand_count ? r->operands[0] : 0;
}

/* Returns true if the next tokens are name "=". */
static bool is_local(const FormulaReader *r)
{
    if (r->token.kind != TOKEN_name)
        return false;
    const Token next = formula_token(r->s, r->token.end);
    return formula_token_is(&next, "=");
}

/* Parses a local: name "=" value. */
static void read_local(FormulaReader *r)
{
    const Token name = r->token;
    const char *called = formula_word(r, name);
    const uint32_t size = formula_token_size(name);
    const bool word = term_named(called, size) != TERM_none ||
                      quantity_named(called, size) != QUANTITY_none || vector_named(called, size) ||
                      formula_special_named(called, size) != SPECIAL_none;
    if (word || names_find(&r->locals, called) >= 0) {
        r->faults++;
        diag_add(r->session, formula_token_span(r), word ? DIAG_formula_hides : DIAG_formula_local,
                 called);
    }
    formula_next(r);
    formula_next(r);
    r->in_local = true;
    const uint32_t step = read_value(r);
    r->in_local = false;
    if (names_find(&r->locals, called) < 0) {
        names_add(r->session->arena, &r->locals, called);
        ARENA_PUSH(r->session->arena, r->local_steps, r->local_count, r->local_capacity, step);
    }
}

/* Reports and skips the type in a declaration such as `float d = ...`. */
static void pass_type(FormulaReader *r)
{
    formula_pass_return(r);
    const Token name = r->token.kind == TOKEN_name ? formula_token(r->s, r->token.end) : r->token;
    const Token sign = name.kind == TOKEN_name ? formula_token(r->s, name.end) : name;
    if (r->token.kind != TOKEN_name || name.kind != TOKEN_name || !formula_token_is(&sign, "="))
        return;
    r->faults++;
    diag_add(r->session, formula_token_span(r), DIAG_formula_typed, formula_word(r, name));
    formula_next(r);
}

/* Parses a formula: { name "=" value ";" } value [ ";" ] */
static void read_parts(FormulaReader *r)
{
    for (pass_type(r); is_local(r) && r->faults < FORMULA_MAX_FAULTS; pass_type(r)) {
        read_local(r);
        if (formula_is(r, ";"))
            formula_next(r);
    }
    if (r->faults >= FORMULA_MAX_FAULTS)
        return;
    if (r->token.kind == TOKEN_end) {
        formula_report(r, DIAG_formula_no_value);
        return;
    }
    r->f->result = read_value(r);
    if (formula_is(r, ";"))
        formula_next(r);
    if (r->faults < FORMULA_MAX_FAULTS && r->token.kind != TOKEN_end)
        formula_report(r, DIAG_formula_ends);
}

Formula *formula_read(const FormulaSource *source)
{
    FormulaReader r = {
        .s = source, .session = source->session, .f = ARENA_NEW(source->session->arena, Formula)};
    if (source->size > LIMIT_FORMULA)
        return diag_add(r.session, source->span(source->user, 0, 1), DIAG_formula_long,
                        LIMIT_FORMULA);
    formula_next(&r);
    if (r.token.kind == TOKEN_end)
        return diag_add(r.session, source->span(source->user, 0, source->size), DIAG_formula_empty);
    read_parts(&r);
    if (r.f->count == 0)
        return NULL;
    return formula_check(source, r.f, &r.locals) && !r.faults ? r.f : NULL;
}
