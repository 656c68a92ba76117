/* Statements: a temporary for each step worth a name, branches, functions, main(), and around them the declarations. */
#include "compiler/emit/emit_scope.h"
#include "compiler/emit/emit_declare.h"
#include <string.h>

enum { LARGEST_EXPRESSION = 6, INDENT = 4, LONGEST_INDENT = 64 };

static void indent(Text *out, int depth)
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
    indent(out, depth);
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
    return (node->head && size > 1) || size > LARGEST_EXPRESSION;
}

/* One side of a branch: the statements of `block`, and then target = value. */
typedef struct {
    const char *target;
    Ref value;
    int block;
} Arm;

static void put_block(Scope *e, Text *out, int block, int depth);
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
    indent(out, depth);
    text_put(out, "} else ");
    if (put_else_if(e, out, &other, depth))
        return;
    text_put(out, "{\n");
    put_assignment(e, out, &other, depth + 1);
    indent(out, depth);
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
    put_block(e, out, arm->block, depth);
    indent(out, depth);
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
    indent(out, depth);
    text_put(out, type_table[node->type].name);
    text_char(out, ' ');
    text_put(out, name);
    if (e->s.arm[ref]) {
        text_put(out, ";\n");
        indent(out, depth);
        put_branch(e, out, name, ref, depth);
    } else {
        text_put(out, " = ");
        emit_expression(e, out, ref, PRECEDENCE_any);
        text_put(out, ";\n");
    }
    e->names[ref] = name;
}

static void put_block(Scope *e, Text *out, int block, int depth)
{
    for (Ref ref = e->s.blocks[block].first; ref; ref = e->s.next[ref])
        if (!e->done[ref])
            put_statement(e, out, ref, depth);
}

/* The statements of the scope's own block that `root` needs and that are not written yet. */
static void put_needed(Scope *e, Text *out, Ref root, int depth)
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

static Scope new_scope(Session *session, const Ir *ir, const Job *job, Interface *interface, Arena *scratch)
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

/* Begins a function, or main, with nothing written yet. */
static void open_scope(Scope *e, const IrFunction *function, const Ref *roots, int count)
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

/* Which functions a loop sums. */
static bool *kernels(const Ir *ir, Arena *scratch)
{
    bool *summed = ARENA_ARRAY(scratch, bool, ir->function_count + 1);
    for (Ref ref = 1; ref < ir->count; ref++)
        if (ir_is(ir, ref, OP_kernel))
            summed[ir_at(ir, ref)->payload] = true;
    return summed;
}

static void put_parameters(Text *out, const Ir *ir, const IrFunction *function)
{
    for (int i = 0; i < function->count; i++) {
        Type type = ir_type(ir, function->arguments[i]);
        text_put(out, i ? ", " : "");
        text_format(out, "%s %s", type_table[type].name, type == TYPE_vec3 ? "p" : "st");
    }
}

/* The sum over the neighbourhood, as a loop that a driver need not unroll. */
static void put_kernel(Session *session, Text *out, const Ir *ir, int number)
{
    const IrFunction *function = &ir->functions[number];
    const char *type = type_table[ir_type(ir, function->result)].name, *name = emit_function_name(session, ir, number);
    text_format(out, "%s %sSum(", type, name);
    put_parameters(out, ir, function);
    bool scalar = ir_type(ir, function->result) == TYPE_float;
    text_format(out, ", vec3 size) {\n    %s sum = ", type);
    text_format(out, scalar ? "0.0;\n" : "%s(0.0);\n", type);
    for (int axis = 0; axis < 3; axis++) {
        indent(out, axis + 1);
        text_format(out, "for (float %c = -0.5; %c < 1.0; %c += 0.5)\n", "ijk"[axis], "ijk"[axis], "ijk"[axis]);
    }
    indent(out, 4);
    text_format(out, "sum += %s(", name);
    for (int i = 0; i < function->count; i++) {
        bool position = ir_type(ir, function->arguments[i]) == TYPE_vec3;
        text_put(out, i ? ", " : "");
        text_put(out, position ? "p + vec3(i, j, k) * size" : "st + vec2(i, j) * size.xy");
    }
    text_put(out, ");\n    return sum;\n}\n\n");
}

static void put_function(Scope *e, Text *out, int number)
{
    const Ir *ir = e->ir;
    const IrFunction *function = &ir->functions[number];
    open_scope(e, function, &function->result, 1);
    text_format(out, "%s %s(", type_table[ir_type(ir, function->result)].name,
                emit_function_name(e->session, ir, number));
    put_parameters(out, ir, function);
    text_put(out, ") {\n");
    put_block(e, out, 0, 1);
    text_put(out, "    return ");
    emit_expression(e, out, function->result, PRECEDENCE_any);
    text_put(out, ";\n}\n\n");
}

static void put_functions(Scope *e, Text *out)
{
    const bool *summed = kernels(e->ir, e->scratch);
    for (int f = 0; f < (int)e->ir->function_count; f++) {
        put_function(e, out, f);
        if (summed[f])
            put_kernel(e->session, out, e->ir, f);
    }
}

static void put_output(Scope *e, Text *out, const IrOutput *output)
{
    bool named = target_table[e->job->target].in_out;
    put_needed(e, out, output->value, 1);
    if (output->kind == OUT_discard) {
        text_put(out, "    if (");
        emit_expression(e, out, output->value, PRECEDENCE_any);
        text_put(out, ") discard;\n");
        return;
    }
    if (output->kind == OUT_depth)
        text_put(out, "    gl_FragDepth = ");
    else
        text_format(out, named ? "    fragment%d = " : "    gl_FragData[%d] = ", output->index);
    emit_expression(e, out, output->value, PRECEDENCE_any);
    text_put(out, ";\n");
}

/* How inputs change over the screen is computed before any branch, as dFdx must be; functions read it from globals. */
static void put_changes(Text *out, const Interface *interface, bool shared)
{
    for (int i = 0; i < change_count; i++) {
        const InputRow *row = &input_table[change_table[i].input];
        if (shared && interface->inputs[change_table[i].input])
            text_format(out, "    %s = %s(%s);\n", row->glsl, change_table[i].by, input_table[change_table[i].of].glsl);
        else if (interface->inputs[change_table[i].input])
            text_format(out, "    %s %s = %s(%s);\n", type_table[row->type].name, row->glsl, change_table[i].by,
                        input_table[change_table[i].of].glsl);
    }
}

static void declare_changes(Text *out, const Interface *interface)
{
    size_t before = out->size;
    for (int i = 0; i < change_count; i++) {
        const InputRow *row = &input_table[change_table[i].input];
        if (interface->inputs[change_table[i].input])
            text_format(out, "%s %s;\n", type_table[row->type].name, row->glsl);
    }
    if (out->size > before)
        text_char(out, '\n');
}

static void put_main(Scope *e, Text *out)
{
    const Ir *ir = e->ir;
    Ref roots[MOST_OUTPUTS];
    Text body = text_new(e->session->arena);
    for (int i = 0; i < ir->output_count; i++)
        roots[i] = ir->outputs[i].value;
    open_scope(e, NULL, roots, ir->output_count);
    for (int i = 0; i < ir->output_count; i++)
        put_output(e, &body, &ir->outputs[i]);
    text_put(out, "void main() {\n");
    put_changes(out, e->interface, ir->function_count > 0);
    text_add(out, body.at, body.size);
    text_put(out, "}\n");
}

const char *emit_fragment(Session *session, const Ir *ir, const Job *job, Interface *interface, size_t *size)
{
    Arena scratch = {0};
    *interface = (Interface){.uniforms = ARENA_ARRAY(session->arena, bool, ir->graph->uniform_count),
                             .counts = ARENA_ARRAY(session->arena, bool, ir->graph->uniform_count),
                             .textures = ARENA_ARRAY(session->arena, bool, ir->texture_count)};
    Text functions = text_new(session->arena), body = text_new(session->arena), out = text_new(session->arena);
    Scope e = new_scope(session, ir, job, interface, &scratch);
    put_functions(&e, &functions);
    put_main(&e, &body);
    arena_free(&scratch);
    emit_declarations(session, &out, ir, job, interface);
    interface->declarations = out.size;
    for (size_t i = 0; i < interface->chunks.count; i++) {
        text_put(&out, interface->chunks.at[i]->body);
        text_char(&out, '\n');
    }
    if (functions.size)
        declare_changes(&out, interface);
    text_add(&out, functions.at, functions.size);
    text_add(&out, body.at, body.size);
    *size = out.size;
    return out.at;
}
