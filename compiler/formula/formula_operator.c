/* Parses what follows an operand: infix operators, swizzles, closing brackets, conditionals. */
#include "compiler/formula/formula_reader.h"
#include <string.h>

/* Returns the index of a component by the set that contains all letters: w is index 2 in uvw,
 * otherwise 3. */
static int component_of(const char *letters, char letter)
{
    static const char *const sets[] = {"xyzw", "rgba", "uvw"};
    for (size_t i = 0; i < sizeof sets / sizeof *sets; i++)
        if (strspn(letters, sets[i]) == strlen(letters))
            return (int)(strchr(sets[i], letter) - sets[i]);
    return -1;
}

/* Returns true for one to four letters of one set. */
static bool is_swizzle(const char *letters)
{
    static const char *const sets[] = {"xyzw", "rgba", "uvw"};
    for (size_t i = 0; i < sizeof sets / sizeof *sets; i++)
        if (strlen(letters) <= FORMULA_MAX_COMPONENTS &&
            strspn(letters, sets[i]) == strlen(letters))
            return true;
    return false;
}

/* Parses "." letters; the check verifies that the components exist. */
static void read_components(FormulaReader *r)
{
    const uint32_t start = r->token.start;
    formula_next(r);
    const char *letters = r->token.kind == TOKEN_name ? formula_word(r, r->token) : "";
    FormulaStep step = {.kind = FORMULA_components,
                        .start = start,
                        .end = r->token.end,
                        .width = (int8_t)strlen(letters)};
    if (!*letters || r->token.start != start + 1 || !is_swizzle(letters)) {
        r->faults++;
        diag_add(r->session, formula_span(r, start, r->token.end), DIAG_formula_components,
                 "a value", letters, "xyzw, rgba or uvw");
        step = (FormulaStep){.kind = FORMULA_fault, .start = start, .end = start + 1};
    }
    for (int i = 0; step.kind == FORMULA_components && letters[i]; i++)
        step.row |= component_of(letters, letters[i]) << 2 * i;
    if (r->token.kind == TOKEN_name)
        formula_next(r);
    formula_apply(r, step, 1);
}

/* Parses "[" digit "]". */
static void read_index(FormulaReader *r)
{
    FormulaStep step = {.kind = FORMULA_components, .start = r->token.start, .width = 1};
    formula_next(r);
    const Token index = r->token;
    formula_next(r);
    step.end = r->token.end;
    if (index.kind != TOKEN_number || !formula_is(r, "]") || index.number != (int)index.number ||
        index.number < 0 || index.number >= FORMULA_MAX_COMPONENTS) {
        r->faults++;
        diag_add(
            r->session, formula_span(r, step.start, step.end), DIAG_formula_components, "a value",
            arena_string(r->session->arena, r->s->text + index.start, formula_token_size(index)),
            "xyzw, rgba or uvw");
        step.kind = FORMULA_fault;
    } else {
        step.row = index.number;
    }
    if (formula_is(r, "]"))
        formula_next(r);
    formula_apply(r, step, 1);
}

void formula_report(FormulaReader *r, DiagKind kind)
{
    r->faults++;
    diag_add(r->session, formula_token_span(r), kind, formula_token_text(r->s, r->token));
    formula_next(r);
}

/* Pushes the defaults of omitted optional arguments. */
static void push_defaults(FormulaReader *r, const TermRow *row, int given)
{
    for (int i = given; row->least && i >= row->least && i < row->count; i++)
        formula_push_step(
            r, (FormulaStep){.kind = FORMULA_number, .number = row->initial[i - row->least]});
}

/* Handles ")" or "]": applies the construct that it closes. */
static void close_open(FormulaReader *r, bool bracket)
{
    formula_reduce_to(r, level_none, true);
    if (!r->wait_count) {
        formula_report(r, DIAG_formula_closes);
        return;
    }
    const FormulaWait wait = r->waits[r->wait_count - 1];
    const bool of_bracket = r->s->text[wait.start] == '[';
    if (of_bracket != bracket) {
        formula_report(r, DIAG_formula_closes);
        return;
    }
    r->wait_count--;
    FormulaStep step = {.row = wait.row, .start = wait.start, .end = wait.end};
    if (bracket)
        step.end = r->token.end;
    formula_next(r);
    if (wait.kind == WAIT_group)
        return;
    if (wait.kind == WAIT_call && wait.row != TERM_none)
        push_defaults(r, &term_table[wait.row], (int)(r->operand_count - wait.base));
    step.kind = wait.kind == WAIT_list  ? FORMULA_list
                : wait.row == TERM_none ? FORMULA_fault
                                        : FORMULA_term;
    formula_apply(r, step, r->operand_count - wait.base);
}

/* Handles ",". Reports it and returns false unless the innermost open bracket is a list or call. */
static bool read_comma(FormulaReader *r)
{
    formula_reduce_to(r, level_none, true);
    const FormulaWait *open = formula_top(r);
    if (open && open->kind != WAIT_group) {
        formula_next(r);
        return true;
    }
    if (!formula_report_decimal(r))
        formula_report(r, DIAG_formula_comma);
    r->operand_count--; /* the operand after the comma replaces both operands */
    return false;
}

/* Handles the ":" of a conditional. */
static void read_colon(FormulaReader *r)
{
    for (FormulaWait *wait = formula_top(r);
         wait && !formula_is_open(wait) && wait->kind != WAIT_question; wait = formula_top(r))
        formula_reduce(r);
    FormulaWait *question = formula_top(r);
    if (question && question->kind == WAIT_question) {
        question->kind = WAIT_colon;
    } else {
        r->faults++;
        diag_add(r->session, formula_token_span(r), DIAG_formula_choice, "'?'");
        r->operand_count--;
    }
    formula_next(r);
}

static const SymbolRow *infix_of(const FormulaReader *r)
{
    for (int i = r->token.symbol; i < symbol_count; i++)
        if (symbol_table[i].level != level_prefix && formula_is(r, symbol_table[i].text))
            return &symbol_table[i];
    return NULL;
}

/* Returns true if a local's value is followed by the start of the next part without ';': a name
 * and its '=', or a value on a new line, with no bracket open. */
static bool lacks_semicolon(const FormulaReader *r)
{
    bool line = false;
    for (size_t i = 0; i < r->wait_count; i++)
        if (formula_is_open(&r->waits[i]))
            return false;
    for (uint32_t i = r->token.start; i > 0 && strchr(" \t\r\n", r->s->text[i - 1]); i--)
        line |= r->s->text[i - 1] == '\n';
    const Token next = formula_token(r->s, r->token.end);
    return r->in_local && (line || (r->token.kind == TOKEN_name && formula_token_is(&next, "=")));
}

/* Detects the operator "**" of other languages. */
static bool is_power_of_others(const FormulaReader *r)
{
    return r->token.kind == TOKEN_other && formula_begins(r->s, r->token.start, "**");
}

/* Reports a token in the place of an operator. */
static void report_no_operator(FormulaReader *r)
{
    const char *word = r->token.kind == TOKEN_name ? formula_word(r, r->token) : "", *hint = "";
    const bool foreign = !strcmp(word, "and") || !strcmp(word, "or");
    if (foreign && !(hint = formula_foreign(r->session, word)))
        hint = "";
    r->faults++;
    if (foreign)
        diag_add(r->session, formula_token_span(r), DIAG_formula_unknown, word, hint);
    else
        diag_add(r->session, formula_token_span(r), DIAG_formula_operator,
                 formula_token_text(r->s, r->token));
    if (foreign) {
        formula_next(r);
        formula_reduce_to(r, level_or, true);
    }
}

/* Returns true for a ';' within a closed bracket that has parts: a ',' is meant. */
static bool divides_arguments(const FormulaReader *r)
{
    size_t open = r->wait_count;
    while (open > 0 && !formula_is_open(&r->waits[open - 1]))
        open--;
    if (!formula_is(r, ";") || !open || r->waits[open - 1].kind == WAIT_group)
        return false;
    int depth = 1;
    for (Token t = r->token; depth > 0 && t.kind != TOKEN_end; t = formula_token(r->s, t.end)) {
        const bool local = formula_token_is(&t, "=");
        depth += formula_token_is(&t, "(") || formula_token_is(&t, "[");
        depth -= formula_token_is(&t, ")") || formula_token_is(&t, "]");
        if (local)
            return false;
    }
    return depth == 0;
}

/* Parses what follows an operand. Returns false if an operand is expected next. *ended: the
 * value is complete. */
bool formula_operator(FormulaReader *r, bool *ended)
{
    const SymbolRow *infix = infix_of(r);
    if (infix) {
        formula_reduce_to(r, infix->level, infix->level != level_power);
        formula_wait(r, (FormulaWait){WAIT_infix, infix->level, infix->term, r->operand_count,
                                      r->token.start, r->token.end});
        formula_next(r);
        return false;
    }
    if (formula_read_suffix(r))
        return true;
    if (formula_is(r, ".") || formula_is(r, "[")) {
        (formula_is(r, ".") ? read_components : read_index)(r);
        return true;
    }
    if (formula_is(r, ")") || formula_is(r, "]")) {
        close_open(r, formula_is(r, "]"));
        return true;
    }
    if (formula_is(r, "?")) {
        formula_reduce_to(r, level_or, true);
        formula_wait(r, (FormulaWait){WAIT_question, level_choose, TERM_choose, r->operand_count,
                                      r->token.start, r->token.end});
        formula_next(r);
        return false;
    }
    if (formula_is(r, ",")) {
        read_comma(r);
        return false;
    }
    if (formula_is(r, ":")) {
        read_colon(r);
        return false;
    }
    if (divides_arguments(r)) {
        r->faults++;
        diag_add(r->session, formula_token_span(r), DIAG_formula_divides);
        formula_reduce_to(r, level_none, true);
        formula_next(r);
        return false;
    }
    if (r->token.kind == TOKEN_end || formula_is(r, ";")) {
        *ended = true;
        return true;
    }
    if (lacks_semicolon(r)) {
        r->faults++;
        diag_add(r->session, formula_token_span(r), DIAG_formula_semicolon,
                 formula_token_text(r->s, r->token));
        *ended = true;
        return true;
    }
    if (formula_is(r, "=")) {
        formula_report(r, DIAG_formula_assigns);
    } else if (is_power_of_others(r)) {
        formula_report_other(r);
        formula_next(r);
    } else if (r->token.kind == TOKEN_other) {
        formula_report_other(r);
        formula_pass_other(r);
        return true;
    } else {
        report_no_operator(r);
    }
    r->operand_count--;
    return false;
}
