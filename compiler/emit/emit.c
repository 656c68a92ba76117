/* Statements: a temporary for each step worth a name, branches. */
#include "compiler/emit/emit_scope.h"
#include <string.h>

enum { LARGEST_EXPRESSION = 6, INDENT = 4, LONGEST_INDENT = 64 };

void emit_indent(Text *out, int depth)
{
    for (int i = 0; i < depth && i < LONGEST_INDENT; i++)
        text_put(out, "    ");
}

/* Where the author has what begins here. */
static void put_comment(Scope *e, Text *out, const IrNode *node, int depth)
{
    const char *note = emit_origin_note(e, node);
    if (!*note)
        return;
    emit_indent(out, depth);
    text_put(out, "// ");
    text_put(out, note);
    text_char(out, '\n');
}

static int expression_size(const Scope *e, Ref ref)
{
    int size = emit_is_leaf(e->ir, ref) ? 0 : 1;
    for (int i = 0; i < ir_at(e->ir, ref)->count; i++)
        size += e->size[ir_arg(e->ir, ref, i)];
    return size;
}

/* Whether a node gets a statement of its own: several uses, a branch, a map's value, or too long in place. */
static bool needs_name(const Scope *e, Ref ref, int size)
{
    const IrNode *node = ir_at(e->ir, ref);
    if (e->s.arm[ref])
        return true;
    if (emit_is_leaf(e->ir, ref))
        return node->op == OP_swizzle && e->s.uses[ref] > 1 && size > 0; /* of what is written in place */
    if (e->s.uses[ref] > 1)
        return true;
    return (ir_is_head(e->ir, ref) && size > 1) || size > LARGEST_EXPRESSION;
}

/* One side of a branch: the statements of `block`, and then target = value. */
typedef struct {
    const char *target;
    Ref value;
    int block;
} Arm;

static void put_assignment(Scope *e, Text *out, const Arm *arm, int depth);
static bool put_else_if(Scope *e, Text *out, const Arm *arm, int depth);

/* A select that is an arm's value and nothing else's assigns to the outer target itself. */
static bool is_tail(const Scope *e, const Arm *arm)
{
    return e->s.arm[arm->value] && e->s.uses[arm->value] == 1 && e->s.block[arm->value] == arm->block;
}

/* if (...) { ... target = a; } else { ... target = b; } */
static void put_branch(Scope *e, Text *out, const char *target, Ref ref, int depth)
{
    const Arm then = {target, ir_arg(e->ir, ref, 1), e->s.arm[ref]};
    const Arm other = {target, ir_arg(e->ir, ref, 2), e->s.arm[ref] + 1};
    text_put(out, "if (");
    emit_expression(e, out, ir_arg(e->ir, ref, 0), PRECEDENCE_any);
    text_put(out, ") {\n");
    put_assignment(e, out, &then, depth + 1);
    emit_indent(out, depth);
    text_put(out, "} else ");
    if (put_else_if(e, out, &other, depth))
        return;
    text_put(out, "{\n");
    put_assignment(e, out, &other, depth + 1);
    emit_indent(out, depth);
    text_put(out, "}\n");
}

/* Whether an arm has statements besides its value's own. */
static bool has_statements(Scope *e, const Arm *arm)
{
    for (Ref ref = e->s.blocks[arm->block].first; ref; ref = e->s.next[ref]) {
        if (ref == arm->value || e->done[ref])
            continue;
        int size = expression_size(e, ref);
        e->size[ref] = (uint16_t)size; /* operands come first: the sizes above build on it */
        if (needs_name(e, ref, size))
            return true;
    }
    return false;
}

/* An arm that is nothing but another branch follows its `else` at once. */
static bool put_else_if(Scope *e, Text *out, const Arm *arm, int depth)
{
    if (!is_tail(e, arm) || has_statements(e, arm))
        return false;
    e->done[arm->value] = 1;
    e->names[arm->value] = arm->target;
    put_branch(e, out, arm->target, arm->value, depth);
    return true;
}

static void put_assignment(Scope *e, Text *out, const Arm *arm, int depth)
{
    bool tail = is_tail(e, arm), own = e->s.uses[arm->value] == 1 && e->s.block[arm->value] == arm->block;
    if (own) /* the assignment is its statement */
        e->done[arm->value] = 1;
    if (tail)
        e->names[arm->value] = arm->target;
    emit_block(e, out, arm->block, depth);
    emit_indent(out, depth);
    if (tail) {
        put_branch(e, out, arm->target, arm->value, depth);
    } else {
        text_put(out, arm->target);
        text_put(out, " = ");
        emit_expression(e, out, arm->value, PRECEDENCE_any);
        text_put(out, ";\n");
    }
}

static void put_statement(Scope *e, Text *out, Ref ref, int depth)
{
    const IrNode *node = ir_at(e->ir, ref);
    int size = expression_size(e, ref);
    e->done[ref] = 1;
    if (!needs_name(e, ref, size)) {
        e->size[ref] = (uint16_t)size;
        return;
    }
    put_comment(e, out, node, depth);
    const char *name = emit_new_name(e, node);
    emit_indent(out, depth);
    text_put(out, type_table[node->type].name);
    text_char(out, ' ');
    text_put(out, name);
    if (e->s.arm[ref]) {
        text_put(out, ";\n");
        emit_indent(out, depth);
        put_branch(e, out, name, ref, depth);
    } else {
        text_put(out, " = ");
        emit_expression(e, out, ref, PRECEDENCE_any);
        text_put(out, ";\n");
    }
    e->names[ref] = name;
}

void emit_block(Scope *e, Text *out, int block, int depth)
{
    for (Ref ref = e->s.blocks[block].first; ref; ref = e->s.next[ref])
        if (!e->done[ref])
            put_statement(e, out, ref, depth);
}

void emit_needed(Scope *e, Text *out, Ref root, int depth)
{
    uint8_t *needed = ARENA_ARRAY(e->scratch, uint8_t, root + 1);
    needed[root] = 1;
    for (Ref ref = root; ref > 0; ref--)
        for (int i = 0; needed[ref] && i < ir_at(e->ir, ref)->count; i++)
            needed[ir_arg(e->ir, ref, i)] = 1;
    for (Ref ref = e->s.blocks[0].first; ref && ref <= root; ref = e->s.next[ref])
        if (needed[ref] && !e->done[ref])
            put_statement(e, out, ref, depth);
}

Scope emit_scope_new(Session *session, const Ir *ir, const Job *job, Interface *interface, Arena *scratch)
{
    Scope e = {.session = session, .ir = ir, .job = job, .interface = interface, .scratch = scratch};
    e.s = schedule_new(ir, scratch);
    e.names = ARENA_ARRAY(scratch, const char *, ir->count);
    e.size = ARENA_ARRAY(scratch, uint16_t, ir->count);
    e.done = ARENA_ARRAY(scratch, uint8_t, ir->count);
    e.naming = ARENA_ARRAY(scratch, Naming, ORIGIN_MAPS + ir->map_count);
    e.lines = ARENA_ARRAY(scratch, Lines, session->source_count + 1);
    for (size_t i = 0; i < ir->constant_count; i++)
        names_add(scratch, &e.constants, ir->constants[i].name);
    return e;
}

void emit_scope_open(Scope *e, const IrFunction *function, const Ref *roots, int count)
{
    e->function = function;
    schedule(&e->s, e->ir, roots, count, e->session->optimize > 0);
    emit_forget_names(e);
    for (size_t i = 0; i < e->s.nodes.count; i++) {
        Ref ref = e->s.nodes.at[i];
        e->names[ref] = NULL;
        e->size[ref] = 0;
        e->done[ref] = 0;
    }
}
