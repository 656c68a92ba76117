/* Dead code elimination: drops nodes that the outputs do not reach, functions that are not
 * called and textures that are not sampled, and renumbers the rest. */
#include "compiler/opt/opt.h"
#include <string.h>

static void keep_function(Ir *ir, size_t from, size_t to, const Ref *moved)
{
    IrFunction function = ir->functions[from];
    /* copies the list, as another function may share it */
    Ref *arguments = ARENA_ARRAY(ir->arena, Ref, function.count);
    function.result = moved[function.result];
    for (int i = 0; i < function.count; i++)
        arguments[i] = moved[function.arguments[i]];
    function.arguments = arguments;
    ir->functions[to] = function;
}

/* Returns the new numbers of called functions, -1 for the others. */
static int *renumber_functions(const Ir *ir, const uint8_t *live, Arena *scratch)
{
    int *number = ARENA_ARRAY(scratch, int, ir->function_count + 1), next = 0;
    if (!ir->function_count)
        return number;
    for (size_t f = 0; f < ir->function_count; f++)
        number[f] = -1;
    for (Ref ref = 1; ref < ir->count; ref++)
        if (live[ref] && ir_applies(ir, ref))
            number[ir_at(ir, ref)->payload] = 0;
    for (size_t f = 0; f < ir->function_count; f++)
        if (number[f] == 0)
            number[f] = next++;
    return number;
}

/* Compacts the list of sampled textures. Returns their new numbers. */
static uint32_t *compact_textures(Ir *ir, const uint8_t *live, Ref count, Arena *scratch)
{
    uint32_t *number = ARENA_ARRAY(scratch, uint32_t, ir->texture_count + 1);
    uint8_t *sampled = ARENA_ARRAY(scratch, uint8_t, ir->texture_count + 1);
    if (!ir->texture_count)
        return number;
    for (Ref ref = 1; ref < count; ref++)
        if (live[ref] && ir_is(ir, ref, OP_texture) && ir_at(ir, ref)->payload < ir->texture_count)
            sampled[ir_at(ir, ref)->payload] = 1;
    uint32_t next = 0;
    for (uint32_t i = 0; i < ir->texture_count; i++) {
        number[i] = next;
        if (sampled[i])
            ir->textures[next++] = ir->textures[i];
    }
    ir->texture_count = next;
    return number;
}

typedef struct {
    const Ref *node;
    const int *function;
    const uint32_t *texture;
    /* number of textures before compaction; IR that was parsed from text may refer to missing
     * textures */
    size_t texture_count;
} Numbers;

/* Moves a node's parts to the compacted arrays, in which they only move down. */
static void compact_node(Ir *ir, IrNode node, const Numbers *numbers)
{
    const Payload kind = (Payload)op_payload[node.op];
    if (kind == PAYLOAD_numbers) {
        size_t components = (size_t)type_table[node.type].components;
        memmove(&ir->numbers[ir->number_count], &ir->numbers[node.payload],
                components * sizeof(double));
        node.payload = (uint32_t)ir->number_count;
        ir->number_count += components;
    }
    if (kind == PAYLOAD_function)
        node.payload = (uint32_t)numbers->function[node.payload];
    if (kind == PAYLOAD_texture && node.payload < numbers->texture_count)
        node.payload = numbers->texture[node.payload];
    for (int i = 0; i < node.count; i++)
        ir->args[ir->arg_count + (size_t)i] = numbers->node[ir->args[node.first + (uint32_t)i]];
    node.first = (uint32_t)ir->arg_count;
    ir->arg_count += node.count;
    ir->nodes[ir->count++] = node;
}

bool opt_dead(Ir *ir)
{
    Arena *scratch = &ir->scratch;
    uint8_t *live = memcpy(arena_alloc(scratch, ir->count), ir_live_kept(ir), ir->count);
    Ref *moved = ARENA_ARRAY(scratch, Ref, ir->count), count = (Ref)ir->count, next = 1;
    int *number = renumber_functions(ir, live, scratch);
    for (size_t f = 0; f < ir->function_count; f++) /* a called function keeps all its arguments */
        for (int i = 0; number[f] >= 0 && i < ir->functions[f].count; i++)
            live[ir->functions[f].arguments[i]] = 1;
    for (Ref ref = 1; ref < count; ref++)
        if (live[ref])
            moved[ref] = next++;
    bool changed = next != count;
    if (changed) {
        Numbers numbers = {moved, number, NULL, ir->texture_count};
        numbers.texture = compact_textures(ir, live, count, scratch);
        ir->count = 1;
        ir->arg_count = ir->number_count = 0;
        for (Ref ref = 1; ref < count; ref++)
            if (live[ref])
                compact_node(ir, ir->nodes[ref], &numbers);
        size_t kept = 0;
        for (size_t f = 0; f < ir->function_count; f++)
            if (number[f] >= 0)
                keep_function(ir, f, kept++, moved);
        ir->function_count = kept;
        for (int i = 0; i < ir->output_count; i++)
            ir->outputs[i].value = moved[ir->outputs[i].value];
        ir_rehash(ir);
    }
    return false; /* dropping nodes enables no other pass */
}
