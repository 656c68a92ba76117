/* Code generation of one scope: main() or a function of the program. Private to emit*.c. */
#ifndef MATC_EMIT_SCOPE_H
#define MATC_EMIT_SCOPE_H
#include "compiler/emit/emit.h"
#include "compiler/emit/schedule.h"

/* Names of an origin's temporaries in a scope. */
typedef struct {
    int scope; /* scope for which the name is valid: Scope.number */
    /* Scope that computes the map's value, which gets the plain name; otherwise the first step
     * does. */
    int valued;
    const char *name; /* stem of the names; steps append numbers */
    int steps;        /* number of named steps */
    bool given;       /* the plain name is already used */
} Naming;

/* Offsets of a source's lines; NULL until first needed. */
typedef struct {
    uint32_t *starts;
    size_t count, capacity;
} Lines;

typedef struct {
    Session *session;
    const Ir *ir;
    const Job *job;
    Interface *interface;
    Arena *scratch;
    Schedule s;
    const IrFunction *function; /* the open function; NULL: main */
    const char **names;         /* per Ref: the name of its temporary; NULL: none */
    /* Per Ref: number of operations in its expression, if inlined. */
    uint16_t *size;
    uint8_t *done;    /* per Ref: the node's statement is written or not needed */
    int number;       /* number of the scope, from 1 */
    Naming *naming;   /* names of temporaries, indexed by origin */
    FreshNames fresh; /* temporaries of the scope */
    Names constants;  /* members of the constants' uniform block */
    Lines *lines;     /* line tables, indexed by source */
} Scope;

/* Creates a scope; its arrays by Ref are reused for all scopes in turn. */
Scope emit_scope_new(Session *session, const Ir *ir, const Job *job, Interface *interface,
                     Arena *scratch);
/* Opens a function, or main (NULL), with nothing written yet. */
void emit_scope_open(Scope *e, const IrFunction *function, const Ref *roots, int count);
/* Writes the indentation of a statement. */
void emit_indent(Text *out, int depth);
/* Writes the statements of a block; emit_needed() those of the scope's own block that `root`
 * needs and that are not yet written. */
void emit_block(Scope *e, Text *out, int block, int depth);
void emit_needed(Scope *e, Text *out, Ref root, int depth);
/* Writes the statements of all implicit derivatives, for a scope that discards: they are
 * undefined after a discard. */
void emit_hoisted(Scope *e, Text *out, int depth);
/* emit_leave() is called before the statements: a root without other users is inlined in its
 * output. emit_left_note() is called after them and writes the comment that the root's own
 * statement would have. */
void emit_leave(Scope *e, Ref root);
void emit_left_note(Scope *e, Text *out, Ref root, int depth);
/* Forgets all names at the beginning of a scheduled scope. emit_name.c */
void emit_forget_names(Scope *e);
/* Returns a name for the node's temporary: "clay" for a map's value, "clay_1" for an
 * intermediate step, "diffuse_bits" for a packed value. */
const char *emit_new_name(Scope *e, const IrNode *node);
/* Returns "brick.yaml:8 clay" for the first statement of a map in a scope; otherwise "". */
const char *emit_origin_note(Scope *e, const IrNode *node);

/* Writes a value as an expression, in parentheses if it binds less tightly than `precedence`. */
void emit_expression(Scope *e, Text *out, Ref ref, int precedence);
/* Returns true for values that never need a temporary: constants, inputs, swizzles of named
 * values. */
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
