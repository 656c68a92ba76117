/* One scope's text: main() or a function of the program. Private to emit*.c. */
#ifndef MATC_EMIT_SCOPE_H
#define MATC_EMIT_SCOPE_H
#include "compiler/emit/emit.h"
#include "compiler/emit/schedule.h"

typedef struct {
    Session *session;
    const Ir *ir;
    const Job *job;
    Interface *interface;
    Arena *scratch;
    Schedule s;
    const IrFunction *function;               /* NULL: main */
    const char **names;                       /* by Ref: its temporary, or NULL */
    uint16_t *size;                           /* by Ref: operations in its expression, where it is written in place */
    uint8_t *done;                            /* by Ref: its statement is written, or it needs none */
    int heads[HINT_COUNT], steps[HINT_COUNT]; /* names given so far */
    int last_hint;                            /* of the statement before */
} Scope;

/* The value as an expression whose operators bind more tightly than `precedence`. */
void emit_expression(Scope *e, Text *out, Ref ref, int precedence);
/* A number or vector. */
void emit_constant(Text *out, const Ir *ir, Ref ref);
/* Values that are never worth a temporary: constants, inputs, lanes of something named. */
bool emit_is_leaf(const Ir *ir, Ref ref);
enum {
    PRECEDENCE_any,
    PRECEDENCE_select,
    PRECEDENCE_or,
    PRECEDENCE_and,
    PRECEDENCE_join,
    PRECEDENCE_equal,
    PRECEDENCE_less,
    PRECEDENCE_shift,
    PRECEDENCE_add,
    PRECEDENCE_mul,
    PRECEDENCE_prefix,
    PRECEDENCE_postfix
};
const char *emit_function_name(Session *session, const Ir *ir, int function);
#endif
