/* Statements: temporaries for expressions worth a name, and branches. */
#include "compiler/emit/emit_scope.h"
#include <string.h>

enum { LARGEST_EXPRESSION = 6, INDENT = 4, LONGEST_INDENT = 64 };

void emit_indent(Text *out, int depth)
{
    for (int i = 0; i < depth && i < LONGEST_INDENT; i++)
        text_put(out, "    ");
}

/* Writes the source position of the map whose code begins here. */
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

/* Returns true if a node gets its own statement: it has several uses, is a branch or a map's
 * value, is too long to be inlined, or must be evaluated before a condition. */
static bool needs_name(const Scope *e, Ref ref, int size)
{
    const IrNode *node = ir_at(e->ir, ref);
    if (e->s.arm[ref] || (e->s.hoisted && e->s.hoisted[ref]))
        return true;
    if (emit_is_leaf(e->ir, ref))
        /* the node is a swizzle of an inlined expression */
        return node->op == OP_swizzle && e->s.uses[ref] > 1 && size > 0;
    if (e->s.uses[ref] > 1)
        return true;
    return (ir_is_head(e->ir, ref) && size > 1) || size > LARGEST_EXPRESSION;
}

/* A branch sets all selects of its region, linked by Schedule.mate from `region` on; its sides
 * are 0 and 1. */
static Ref side_value(const Scope *e, Ref ref, int side) { return ir_arg(e->ir, ref, 1 + side); }

static void put_branch(Scope *e, Text *out, Ref region, int depth);

/* Returns true if the value is computed in the block and used only once. */
static bool is_own(const Scope *e, Ref value, int block)
{
    return e->s.uses[value] == 1 && e->s.block[value] == block;
}

/* Returns a nested branch that sets all values of the region's side, and nothing else, so both
 * can share their targets; 0: none. */
static Ref tail_of(const Scope *e, Ref region, int side)
{
    const Ref tail = side_value(e, region, side);
    Ref ref = region, within = tail;
    do {
        Ref value = side_value(e, ref, side);
        if (!e->s.arm[value] || e->s.arm[value] != e->s.arm[tail] ||
            !is_own(e, value, e->s.arm[region] + side))
            return 0;
        within = e->s.mate[within];
        ref = e->s.mate[ref];
    } while (ref != region && within != tail);
    return ref == region && within == tail ? tail : 0;
}

/* Marks the values of a side that need no statement of their own: those of the tail, and
 * operands inlined in an assignment. */
static void leave_to_side(Scope *e, Ref region, int side, Ref tail)
{
    Ref ref = region;
    do {
        Ref value = side_value(e, ref, side);
        if (tail)
            e->names[value] = e->names[ref];
        if (tail || (is_own(e, value, e->s.arm[region] + side) && !e->s.arm[value]))
            e->done[value] = 1;
    } while ((ref = e->s.mate[ref]) != region);
}

/* Writes one side: shared statements first, then the value of each select of the region. */
static void put_side(Scope *e, Text *out, Ref region, int side, int depth)
{
    const Ref tail = tail_of(e, region, side);
    Ref ref = region;
    leave_to_side(e, region, side, tail);
    emit_block(e, out, e->s.arm[region] + side, depth);
    if (tail) {
        emit_indent(out, depth);
        put_branch(e, out, tail, depth);
        return;
    }
    do {
        emit_indent(out, depth);
        text_put(out, e->names[ref]);
        text_put(out, " = ");
        emit_expression(e, out, side_value(e, ref, side), PRECEDENCE_any);
        text_put(out, ";\n");
    } while ((ref = e->s.mate[ref]) != region);
}

/* Returns true if a block has statements other than those of a branch. */
static bool has_statements(Scope *e, int block, Ref tail)
{
    for (Ref ref = e->s.blocks[block].first; ref; ref = e->s.next[ref]) {
        if (e->s.arm[ref] == e->s.arm[tail] || e->done[ref])
            continue;
        int size = expression_size(e, ref);
        /* sizes of operands come first, since sizes of users build on them */
        e->size[ref] = (uint16_t)size;
        if (needs_name(e, ref, size))
            return true;
    }
    return false;
}

/* Writes `else if` for a side that consists of another branch only. */
static bool put_else_if(Scope *e, Text *out, Ref region, int depth)
{
    const Ref tail = tail_of(e, region, 1);
    if (!tail || has_statements(e, e->s.arm[region] + 1, tail))
        return false;
    leave_to_side(e, region, 1, tail);
    put_branch(e, out, tail, depth);
    return true;
}

/* Writes if (...) { ... target = a; } else { ... target = b; } */
static void put_branch(Scope *e, Text *out, Ref region, int depth)
{
    text_put(out, "if (");
    emit_expression(e, out, ir_arg(e->ir, region, 0), PRECEDENCE_any);
    text_put(out, ") {\n");
    put_side(e, out, region, 0, depth + 1);
    emit_indent(out, depth);
    text_put(out, "} else ");
    if (put_else_if(e, out, region, depth))
        return;
    text_put(out, "{\n");
    put_side(e, out, region, 1, depth + 1);
    emit_indent(out, depth);
    text_put(out, "}\n");
}

static const char *put_declaration(Scope *e, Text *out, Ref ref, int depth)
{
    const IrNode *node = ir_at(e->ir, ref);
    put_comment(e, out, node, depth);
    const char *name = emit_new_name(e, node);
    emit_indent(out, depth);
    text_put(out, type_table[node->type].name);
    text_char(out, ' ');
    text_put(out, name);
    e->done[ref] = 1;
    return name;
}

/* Declares the targets of a region, then writes the branch that sets them. */
static void put_region(Scope *e, Text *out, Ref region, int depth)
{
    Ref ref = region;
    do {
        e->names[ref] = put_declaration(e, out, ref, depth);
        text_put(out, ";\n");
    } while ((ref = e->s.mate[ref]) != region);
    emit_indent(out, depth);
    put_branch(e, out, region, depth);
}

static void put_statement(Scope *e, Text *out, Ref ref, int depth)
{
    int size = expression_size(e, ref);
    e->done[ref] = 1;
    if (!needs_name(e, ref, size)) {
        e->size[ref] = (uint16_t)size;
        return;
    }
    if (e->s.arm[ref]) {
        put_region(e, out, ref, depth);
        return;
    }
    const char *name = put_declaration(e, out, ref, depth);
    text_put(out, " = ");
    emit_expression(e, out, ref, PRECEDENCE_any);
    text_put(out, ";\n");
    e->names[ref] = name;
}

void emit_block(Scope *e, Text *out, int block, int depth)
{
    for (Ref ref = e->s.blocks[block].first; ref; ref = e->s.next[ref])
        if (!e->done[ref])
            put_statement(e, out, ref, depth);
}

void emit_leave(Scope *e, Ref root)
{
    if (e->s.uses[root] == 1 && !e->s.arm[root])
        e->done[root] = 1;
}

void emit_left_note(Scope *e, Text *out, Ref root, int depth)
{
    if (!e->names[root] && needs_name(e, root, expression_size(e, root)))
        put_comment(e, out, ir_at(e->ir, root), depth);
}

/* Marks the unwritten nodes that a root needs; of a region all selects. */
static uint8_t *needed_by(Scope *e, Ref root)
{
    uint8_t *needed = ARENA_ARRAY(e->scratch, uint8_t, e->ir->count);
    Ref *met = NULL;
    size_t count = 0, capacity = 0;
    ARENA_PUSH(e->scratch, met, count, capacity, root);
    while (count) {
        Ref ref = met[--count];
        if (needed[ref] || (e->done[ref] && ref != root))
            continue;
        needed[ref] = 1;
        if (e->s.mate[ref] != ref)
            ARENA_PUSH(e->scratch, met, count, capacity, e->s.mate[ref]);
        for (int i = 0; i < ir_at(e->ir, ref)->count; i++)
            ARENA_PUSH(e->scratch, met, count, capacity, ir_arg(e->ir, ref, i));
    }
    return needed;
}

void emit_needed(Scope *e, Text *out, Ref root, int depth)
{
    const uint8_t *needed = needed_by(e, root);
    for (Ref ref = e->s.blocks[0].first; ref; ref = e->s.next[ref])
        if (needed[ref] && !e->done[ref])
            put_statement(e, out, ref, depth);
}

void emit_hoisted(Scope *e, Text *out, int depth)
{
    for (size_t i = 0; e->s.hoisted && i < e->s.nodes.count; i++) {
        const Ref ref = e->s.nodes.at[i];
        if (!ir_needs_neighbours(e->ir, ref))
            continue;
        e->s.hoisted[ref] = 1;
        emit_needed(e, out, ref, depth);
    }
}

Scope emit_scope_new(Session *session, const Ir *ir, const Job *job, Interface *interface,
                     Arena *scratch)
{
    Scope e = {
        .session = session, .ir = ir, .job = job, .interface = interface, .scratch = scratch};
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
