/* The operand and operator stacks of the formula parser. */
#include "compiler/formula/formula_reader.h"

uint32_t formula_add(Session *session, Formula *f, FormulaStep step, const uint32_t *arguments,
                     uint32_t count)
{
    step.first = (uint32_t)f->argument_count;
    step.count = count;
    for (uint32_t i = 0; i < count; i++)
        ARENA_PUSH(session->arena, f->arguments, f->argument_count, f->argument_capacity,
                   arguments[i]);
    ARENA_PUSH(session->arena, f->steps, f->count, f->capacity, step);
    return (uint32_t)f->count - 1;
}

void formula_push(FormulaReader *r, uint32_t step)
{
    ARENA_PUSH(r->session->arena, r->operands, r->operand_count, r->operand_capacity, step);
}

void formula_push_step(FormulaReader *r, FormulaStep step)
{
    formula_push(r, formula_add(r->session, r->f, step, NULL, 0));
}

void formula_push_fault(FormulaReader *r)
{
    formula_push_step(
        r, (FormulaStep){.kind = FORMULA_fault, .start = r->token.start, .end = r->token.end});
}

void formula_wait(FormulaReader *r, FormulaWait wait)
{
    ARENA_PUSH(r->session->arena, r->waits, r->wait_count, r->wait_capacity, wait);
}

void formula_apply(FormulaReader *r, FormulaStep step, size_t count)
{
    r->operand_count -= count;
    const uint32_t made =
        formula_add(r->session, r->f, step, r->operands + r->operand_count, (uint32_t)count);
    formula_push(r, made);
}

void formula_reduce(FormulaReader *r)
{
    const FormulaWait wait = r->waits[--r->wait_count];
    const FormulaStep step = {
        .kind = FORMULA_term, .row = wait.row, .start = wait.start, .end = wait.end};
    if (wait.kind == WAIT_question) {
        /* Computing a span takes time proportional to its offset, so faults above the limit get
         * none. */
        if (r->faults++ < FORMULA_MAX_FAULTS)
            diag_add(r->session, formula_span(r, wait.start, wait.end), DIAG_formula_choice, "':'");
        formula_push_fault(r);
    }
    if (wait.kind == WAIT_colon || wait.kind == WAIT_question)
        formula_apply(r, step, 3);
    else
        formula_apply(r, step, wait.kind == WAIT_infix ? 2 : 1);
}

void formula_reduce_to(FormulaReader *r, OperatorLevel level, bool from_left)
{
    for (FormulaWait *wait = formula_top(r); wait && !formula_is_open(wait);
         wait = formula_top(r)) {
        if (wait->level < level || (wait->level == level && !from_left))
            return;
        formula_reduce(r);
    }
}
