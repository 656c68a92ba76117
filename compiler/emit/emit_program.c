/* Programs: functions and main() of a stage, preceded by the declarations. */
#include "compiler/emit/emit_scope.h"
#include "compiler/emit/emit_declare.h"
#include "compiler/emit/attribute.h"
#include <string.h>

/* Returns the functions that a kernel sums. */
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

/* Writes the sum over the kernel as a loop, which drivers need not unroll. */
static void put_kernel(Session *session, Text *out, const Ir *ir, int number)
{
    const IrFunction *function = &ir->functions[number];
    const char *type = type_table[ir_type(ir, function->result)].name,
               *name = emit_function_name(session, ir, number);
    text_format(out, "%s %sSum(", type, name);
    put_parameters(out, ir, function);
    bool scalar = ir_type(ir, function->result) == TYPE_float;
    text_format(out, ", vec3 size) {\n    %s sum = ", type);
    text_format(out, scalar ? "0.0;\n" : "%s(0.0);\n", type);
    for (int axis = 0; axis < 3; axis++) {
        emit_indent(out, axis + 1);
        text_format(out, "for (float %c = -0.5; %c < 1.0; %c += 0.5)\n", "ijk"[axis], "ijk"[axis],
                    "ijk"[axis]);
    }
    emit_indent(out, 4);
    text_format(out, "sum += %s(", name);
    for (int i = 0; i < function->count; i++) {
        bool position = ir_type(ir, function->arguments[i]) == TYPE_vec3;
        text_put(out, i ? ", " : "");
        text_put(out, position ? "p + vec3(i, j, k) * size" : "st + vec2(i, j) * size.xy");
    }
    text_put(out, ");\n    return sum;\n}\n\n");
}

/* Writes the body of a function whose scope is open. */
static void put_result(Scope *e, Text *out, Ref result)
{
    emit_leave(e, result);
    emit_block(e, out, 0, 1);
    emit_left_note(e, out, result, 1);
    text_put(out, "    return ");
    emit_expression(e, out, result, PRECEDENCE_any);
    text_put(out, ";\n}\n\n");
}

static void put_function(Scope *e, Text *out, int number)
{
    const Ir *ir = e->ir;
    const IrFunction *function = &ir->functions[number];
    emit_scope_open(e, function, &function->result, 1);
    text_format(out, "%s %s(", type_table[ir_type(ir, function->result)].name,
                emit_function_name(e->session, ir, number));
    put_parameters(out, ir, function);
    text_put(out, ") {\n");
    put_result(e, out, function->result);
}

/* Lists the roots of the fragment program: its output values. */
static int roots_of(const Ir *ir, Ref roots[MAX_OUTPUTS])
{
    int count = 0;
    for (int i = 0; i < ir->output_count; i++)
        if (ir_is_of_fragments(&ir->outputs[i]))
            roots[count++] = ir->outputs[i].value;
    return count;
}

/* Finds the nodes that the roots need, including those of called functions, transitively;
 * callees precede callers. Sets `run` for these functions. */
static IrReach needed_by(const Ir *ir, const Ref *roots, int count, bool *run, Arena *scratch)
{
    IrReach reach = ir_reach_new(ir, scratch);
    ir_reach(ir, roots, count, &reach);
    for (size_t f = ir->function_count;; f--) {
        for (size_t i = 0; i < reach.count; i++)
            if (ir_applies(ir, reach.at[i]))
                run[ir_at(ir, reach.at[i])->payload] = true;
        if (!f)
            return reach;
        ir_reach(ir, &ir->functions[f - 1].result, run[f - 1], &reach);
    }
}

static bool *functions_of(const Ir *ir, const Ref *roots, int count, Arena *scratch)
{
    bool *run = ARENA_ARRAY(scratch, bool, ir->function_count + 1);
    if (ir->function_count)
        needed_by(ir, roots, count, run, scratch);
    return run;
}

static void inputs_of(const Ir *ir, Ref root, bool inputs[INPUT_COUNT])
{
    Arena scratch = {0};
    bool *run = ARENA_ARRAY(&scratch, bool, ir->function_count + 1);
    const IrReach reach = needed_by(ir, &root, 1, run, &scratch);
    for (size_t i = 0; i < reach.count; i++)
        if (ir_is(ir, reach.at[i], OP_input))
            inputs[ir_at(ir, reach.at[i])->payload] = true;
    arena_free(&scratch);
}

static void put_functions(Scope *e, Text *out, const bool *run)
{
    const bool *summed = kernels(e->ir, e->scratch);
    for (int f = 0; f < (int)e->ir->function_count; f++) {
        if (!run[f])
            continue;
        put_function(e, out, f);
        if (summed[f])
            put_kernel(e->session, out, e->ir, f);
    }
}

static void put_output(Scope *e, Text *out, const IrOutput *output)
{
    bool named = target_table[e->job->target].in_out;
    /* the program discards every fragment */
    if (output->kind == OUT_discard && ir_is_number(e->ir, output->value, 1)) {
        text_put(out, "    discard;\n");
        return;
    }
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

/* Computes the derivatives of inputs before any branch, since dFdx needs uniform control flow.
 * Functions read them from globals. */
static void put_changes(Text *out, const Interface *interface, bool shared)
{
    for (int i = 0; i < change_count; i++) {
        const InputRow *row = &input_table[change_table[i].input];
        if (shared && interface->inputs[change_table[i].input])
            text_format(out, "    %s = %s(%s);\n", row->glsl, change_table[i].by,
                        input_table[change_table[i].of].glsl);
        else if (interface->inputs[change_table[i].input])
            text_format(out, "    %s %s = %s(%s);\n", type_table[row->type].name, row->glsl,
                        change_table[i].by, input_table[change_table[i].of].glsl);
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
    attribute_put_changes(out, interface, ATTRIBUTE_CHANGES_declared);
    if (out->size > before)
        text_char(out, '\n');
}

static void put_main(Scope *e, Text *out)
{
    const Ir *ir = e->ir;
    Ref roots[MAX_OUTPUTS];
    Text body = text_new(e->session->arena);
    const int count = roots_of(ir, roots);
    emit_scope_open(e, NULL, roots, count);
    if (ir_output_of(ir, OUT_discard) && count > 1)
        emit_hoisted(e, &body, 1);
    for (int i = 0; i < ir->output_count; i++) {
        if (!ir_is_of_fragments(&ir->outputs[i]))
            continue;
        const Ref root = ir->outputs[i].value;
        emit_leave(e, root);
        if (count == 1) /* a single output needs all statements */
            emit_block(e, &body, 0, 1);
        else
            emit_needed(e, &body, root, 1);
        emit_left_note(e, &body, root, 1);
        put_output(e, &body, &ir->outputs[i]);
    }
    text_put(out, "void main() {\n");
    put_changes(out, e->interface, ir->function_count > 0);
    attribute_put_changes(out, e->interface,
                          ir->function_count > 0 ? ATTRIBUTE_CHANGES_shared
                                                 : ATTRIBUTE_CHANGES_whole);
    text_add(out, body.at, body.size);
    text_put(out, "}\n");
}

static Interface new_interface(Session *session, const Ir *ir)
{
    return (Interface){.ir = ir,
                       .uniforms = ARENA_ARRAY(session->arena, bool, ir->graph->uniform_count),
                       .counts = ARENA_ARRAY(session->arena, bool, ir->graph->uniform_count),
                       .textures = ARENA_ARRAY(session->arena, bool, ir->texture_count)};
}

/* Merges the declarations of two stages; of inputs only those that are uniforms. */
static Interface joined(Session *session, const Ir *ir, const Interface *a, const Interface *b)
{
    Interface all = new_interface(session, ir);
    const Interface *const both[] = {a, b};
    memcpy(all.inputs, a->inputs, sizeof all.inputs);
    /* vertex stages do not compute with attributes */
    memcpy(all.attributes, a->attributes, sizeof all.attributes);
    all.instances = a->instances;
    all.members = a->members || b->members;
    for (int i = 0; i < INPUT_COUNT; i++)
        all.inputs[i] |= b->inputs[i] && (input_table[i].source == SOURCE_draw ||
                                          input_table[i].source == SOURCE_object);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < ir->graph->uniform_count; i++) {
            all.uniforms[i] |= both[k]->uniforms[i];
            all.counts[i] |= both[k]->counts[i];
        }
        for (size_t i = 0; i < ir->texture_count; i++)
            all.textures[i] |= both[k]->textures[i];
        for (size_t i = 0; i < both[k]->chunks.count; i++)
            chunks_add_found(session, &all.chunks, both[k]->chunks.at[i]);
    }
    return all;
}

static void put_chunks(Text *out, const Chunks *chunks)
{
    for (size_t i = 0; i < chunks->count; i++) {
        text_put(out, chunks->at[i]->body);
        text_char(out, '\n');
    }
}

/* Returns the text of a VertexMove. Its inputs are global variables, since functions of filters
 * read them too, and main() sets them for both calls. `normal` may be 0. */
static const char *move_text(Session *session, const Ir *ir, const Job *job, Interface *own,
                             Ref normal)
{
    Arena scratch = {0};
    const Ref root = ir_output_of(ir, OUT_displacement)->value, both[] = {root, normal};
    Text functions = text_new(session->arena), out = text_new(session->arena);
    Scope e = emit_scope_new(session, ir, job, own, &scratch);
    put_functions(&e, &functions, functions_of(ir, both, normal ? 2 : 1, &scratch));
    emit_scope_open(&e, NULL, &root, 1);
    text_format(&functions, "// How far the point moves: %s.\n%s matc_displacement() {\n",
                ir_type(ir, root) == TYPE_float ? "along its normal"
                : ir_type(ir, root) == TYPE_vec4
                    ? "what is solid along its normal, from x to y and from z to w"
                    : "along dP/du, dP/dv and its normal",
                type_table[ir_type(ir, root)].name);
    put_result(&e, &functions, root);
    if (normal) {
        emit_scope_open(&e, NULL, &normal, 1);
        text_put(
            &functions,
            "// The unit normal of what the surface comes to be.\nvec3 matc_displacedNormal() {\n");
        put_result(&e, &functions, normal);
    }
    for (int i = 0; i < INPUT_COUNT; i++)
        if (input_table[i].source == SOURCE_vertex && (own->inputs[i] || i == INPUT_vertexP))
            text_format(&out, "%s %s;\n", type_table[input_table[i].type].name,
                        input_table[i].glsl);
    text_char(&out, '\n');
    put_chunks(&out, &own->chunks);
    text_add(&out, functions.at, functions.size);
    arena_free(&scratch);
    return out.at;
}

/* Creates a VertexMove without its declarations, which `own` collects. */
static VertexMove *move_new(Session *session, const Ir *ir, const Job *job, Interface *own,
                            Ref normal)
{
    VertexMove *move = ARENA_NEW(session->arena, VertexMove);
    const Ref root = ir_output_of(ir, OUT_displacement)->value;
    *own = new_interface(session, ir);
    own->instances = job->instances;
    move->text = move_text(session, ir, job, own, normal);
    move->along_tangents = ir_type(ir, root) == TYPE_vec3;
    move->volume = ir_type(ir, root) == TYPE_vec4;
    move->turns = normal != 0;
    inputs_of(ir, root, move->inputs);
    if (normal)
        inputs_of(ir, normal, move->normal_inputs);
    return move;
}

static void declare_move(Session *session, const Ir *ir, const Job *job, VertexMove *move,
                         Declared declared)
{
    Text declarations = text_new(session->arena);
    emit_move_declarations(session, &declarations, ir, job, declared);
    move->declarations = declarations.size ? declarations.at : "";
}

/* Returns the interface of all stages, derived from that of the fragment program. */
static Interface with_move(Session *session, const Ir *ir, const Job *job,
                           const Interface *fragment)
{
    const IrOutput *normal = ir_output_of(ir, OUT_normal);
    Interface own, computed;
    if (!ir_output_of(ir, OUT_displacement))
        return *fragment;
    VertexMove *move = move_new(session, ir, job, &own, 0),
               *compute = normal ? move_new(session, ir, job, &computed, normal->value) : move;
    Interface all =
        /* computing normals includes displacement */
        joined(session, ir, fragment, normal ? &computed : &own);
    declare_move(session, ir, job, move, (Declared){&own, &all});
    if (normal)
        declare_move(session, ir, job, compute, (Declared){&computed, &all});
    all.move = move;
    all.compute = compute;
    all.fragment_textures = fragment->textures;
    all.fragment_chunks = fragment->chunks;
    return all;
}

const char *emit_fragment(Session *session, const Ir *ir, const Job *job, Interface *interface,
                          size_t *size)
{
    Arena scratch = {0};
    Ref roots[MAX_OUTPUTS];
    Interface own = new_interface(session, ir);
    own.instances = job->instances;
    Text functions = text_new(session->arena), body = text_new(session->arena),
         out = text_new(session->arena);
    Scope e = emit_scope_new(session, ir, job, &own, &scratch);
    put_functions(&e, &functions, functions_of(ir, roots, roots_of(ir, roots), &scratch));
    put_main(&e, &body);
    arena_free(&scratch);
    *interface = with_move(session, ir, job, &own);
    emit_declarations(session, &out, ir, job, (Declared){&own, interface});
    interface->declarations = out.size;
    put_chunks(&out, &own.chunks);
    if (functions.size)
        declare_changes(&out, &own);
    text_add(&out, functions.at, functions.size);
    text_add(&out, body.at, body.size);
    *size = out.size;
    return out.at;
}
