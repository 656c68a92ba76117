/* The IR as text, one node a line, and as a graph for Graphviz.
 *
 *     %1 = const float 0.5
 *     %2 = input vec3 X
 *     %3 = swizzle float .x %2
 *     %4 = argument vec3 0.0
 *     %5 = call float noise %4
 *     function f0 = %5 %4
 *     %6 = apply float f0 %2
 *     out color 0 = %6 */
#include "compiler/ir/ir.h"
#include <string.h>

static void print_numbers(Text *out, int type, const double *numbers)
{
    for (int i = 0; i < type_table[type].components; i++) {
        text_char(out, ' ');
        text_double(out, numbers[i]);
    }
}

static const char *const attribute_ends[ATTRIBUTE_PARTS] = {"", ".byX", ".byY"};

static void print_payload(Text *out, const Ir *ir, const IrNode *node)
{
    switch ((Payload)op_payload[node->op]) {
    case PAYLOAD_numbers:
        print_numbers(out, node->type, &ir->numbers[node->payload]);
        break;
    case PAYLOAD_input:
        text_format(out, " %s", input_table[node->payload].name);
        break;
    case PAYLOAD_attribute:
        text_format(out, " %s%s", ir->graph->attributes[attribute_of(node->payload)]->name,
                    attribute_ends[attribute_part(node->payload)]);
        break;
    case PAYLOAD_uniform:
        text_format(out, " %s", ir->graph->uniforms[node->payload]->name);
        break;
    case PAYLOAD_member:
        print_numbers(out, node->type, ir->constants[node->payload].numbers);
        break;
    case PAYLOAD_argument:
        text_format(out, " %u.%u", node->payload >> 8, node->payload & 0xFF);
        break;
    case PAYLOAD_texture:
        text_format(out, " %u", node->payload);
        break;
    case PAYLOAD_components:
        text_put(out, " .");
        for (int i = 0; i < type_table[node->type].components; i++)
            text_char(out, "xyzw"[node->payload >> 2 * i & 3]);
        break;
    case PAYLOAD_library:
        text_format(out, " %s", function_row((int)node->payload)->name);
        break;
    case PAYLOAD_function:
        text_format(out, " f%u", node->payload);
        break;
    case PAYLOAD_none:
        break;
    }
}

static void print_node(Text *out, const Ir *ir, Ref ref)
{
    const IrNode *node = ir_at(ir, ref);
    text_format(out, "%s %s", op_text((Op)node->op), type_table[node->type].name);
    print_payload(out, ir, node);
    for (int i = 0; i < node->count; i++)
        text_format(out, " %%%u", ir_arg(ir, ref, i));
}

/* Returns the last node that a function's line refers to; an unused argument may follow the
 * result. */
static Ref last_of(const IrFunction *function)
{
    Ref last = function->result;
    for (int i = 0; i < function->count; i++)
        last = function->arguments[i] > last ? function->arguments[i] : last;
    return last;
}

/* Functions by the node that completes them: `first` is the head of a linked list, counted from
 * 1 (0: none), `next` its links. */
typedef struct {
    int *first, *next;
} Completed;

static Completed completed_functions(const Ir *ir, Arena *scratch)
{
    Completed by = {ARENA_ARRAY(scratch, int, ir->count),
                    ARENA_ARRAY(scratch, int, ir->function_count + 1)};
    for (int f = (int)ir->function_count - 1; f >= 0; f--) {
        Ref last = last_of(&ir->functions[f]);
        by.next[f] = by.first[last];
        by.first[last] = f + 1;
    }
    return by;
}

/* Prints the functions that are complete with this node. */
static void print_functions(Text *out, const Ir *ir, const Completed *by, Ref ref)
{
    for (int f = by->first[ref] - 1; f >= 0; f = by->next[f] - 1) {
        const IrFunction *function = &ir->functions[f];
        text_format(out, "function f%d = %%%u", f, function->result);
        for (int i = 0; i < function->count; i++)
            text_format(out, " %%%u", function->arguments[i]);
        text_char(out, '\n');
    }
}

static const char *const output_names[] = {"discard", "depth", "color", "displacement", "normal"};

void ir_print(Text *out, const Ir *ir)
{
    Arena scratch = {0};
    uint8_t *live = ir_live(ir, &scratch);
    const Completed by = completed_functions(ir, &scratch);
    for (size_t f = 0; f < ir->function_count; f++)
        for (int i = 0; i < ir->functions[f].count; i++)
            live[ir->functions[f].arguments[i]] = 1;
    for (Ref ref = 1; ref < ir->count; ref++) {
        if (!live[ref])
            continue;
        text_format(out, "%%%u = ", ref);
        print_node(out, ir, ref);
        text_char(out, '\n');
        print_functions(out, ir, &by, ref);
    }
    for (int i = 0; i < ir->output_count; i++)
        text_format(out, "out %s %d = %%%u\n", output_names[ir->outputs[i].kind],
                    ir->outputs[i].index, ir->outputs[i].value);
    arena_free(&scratch);
}

void ir_dot(Text *out, const Ir *ir)
{
    Arena scratch = {0};
    uint8_t *live = ir_live(ir, &scratch);
    text_put(out,
             "digraph material {\n  rankdir=BT;\n  node [shape=box, fontname=\"monospace\"];\n");
    for (Ref ref = 1; ref < ir->count; ref++) {
        const IrNode *node = ir_at(ir, ref);
        if (!live[ref])
            continue;
        text_format(out, "  n%u [label=\"%s %s", ref, op_text((Op)node->op),
                    type_table[node->type].name);
        print_payload(out, ir, node);
        text_put(out, "\"];\n");
        for (int i = 0; i < node->count; i++)
            text_format(out, "  n%u -> n%u;\n", ir_arg(ir, ref, i), ref);
        if (ir_applies(ir, ref))
            text_format(out, "  n%u -> n%u [style=dashed];\n", ir->functions[node->payload].result,
                        ref);
    }
    for (int i = 0; i < ir->output_count; i++)
        text_format(out, "  o%d [label=\"%s %d\", style=bold];\n  n%u -> o%d;\n", i,
                    output_names[ir->outputs[i].kind], ir->outputs[i].index, ir->outputs[i].value,
                    i);
    text_put(out, "}\n");
    arena_free(&scratch);
}
