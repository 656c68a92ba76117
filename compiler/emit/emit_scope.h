/* One scope's text: main() or a function of the program. Private to emit*.c. */
#ifndef MATC_EMIT_SCOPE_H
#define MATC_EMIT_SCOPE_H
#include "compiler/emit/emit.h"
#include "compiler/emit/schedule.h"

/* Names of an origin's temporaries in a scope. */
typedef struct {
    int scope; /* in which that is known: Scope.number */
    /* scope that computes the value, which then is called so; else the first step is */
    int valued;
    const char *name; /* numbers behind it tell steps apart */
    int steps;        /* named so far */
    bool given;       /* to somebody */
} Naming;

/* Where the lines of a source begin; NULL until somebody asks. */
typedef struct {
    uint32_t *starts;
    size_t count, room;
} Lines;

typedef struct {
    Session *session;
    const Ir *ir;
    const Job *job;
    Interface *interface;
    Arena *scratch;
    Schedule s;
    const IrFunction *function; /* NULL: main */
    const char **names;         /* by Ref: its temporary, or NULL */
    /* by Ref: operations in its expression, where it is written in place */
    uint16_t *size;
    uint8_t *done;    /* by Ref: its statement is written, or it needs none */
    int number;       /* of the scope, from 1 */
    Naming *naming;   /* by origin */
    FreshNames fresh; /* temporaries of the scope */
    Names constants;  /* members of the buffer */
    Lines *lines;     /* by source */
} Scope;

/* A scope to be opened; the arrays by Ref are those of all that are, one after the other. */
Scope emit_scope_new(Session *session, const Ir *ir, const Job *job, Interface *interface,
                     Arena *scratch);
/* Begins a function, or main (NULL), with nothing written yet. */
void emit_scope_open(Scope *e, const IrFunction *function, const Ref *roots, int count);
/* Spaces before a statement. */
void emit_indent(Text *out, int depth);
/* The statements of a block; those of the scope's own block that `root` needs and that are not
 * written yet. */
void emit_block(Scope *e, Text *out, int block, int depth);
void emit_needed(Scope *e, Text *out, Ref root, int depth);
/* The statements of all implicit derivatives, for a scope that discards: behind a discard they
 * are undefined. */
void emit_hoisted(Scope *e, Text *out, int depth);
/* Before them: a root that nothing else needs has no statement of its own, it is written where it
 * goes; behind them: the comment that one would have. */
void emit_leave(Scope *e, Ref root);
void emit_left_note(Scope *e, Text *out, Ref root, int depth);
/* emit_name.c: begins a scope, which is scheduled, with no names. */
void emit_forget_names(Scope *e);
/* A name for the node's temporary: "clay" for a map's value, "clay_1" for a step on its way,
 * "diffuse_bits" for what is stored. */
const char *emit_new_name(Scope *e, const IrNode *node);
/* "brick.yaml:8 clay", the first time that something of the map gets a statement; "" otherwise. */
const char *emit_origin_note(Scope *e, const IrNode *node);

/* The value as an expression whose operators bind more tightly than `precedence`. */
void emit_expression(Scope *e, Text *out, Ref ref, int precedence);
/* Values that are never worth a temporary: constants, inputs, lanes of something named. */
static inline bool emit_is_leaf(const Ir *ir, Ref ref)
{
    return op_table[ir_at(ir, ref)->op].arity == 0 || ir_is(ir, ref, OP_swizzle);
}
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
