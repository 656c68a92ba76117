/* Counts the uses of nodes, for rules that would duplicate work. Operands precede users, and a
 * function's result precedes its calls: one downward sweep finds live nodes and counts. */
#include "compiler/opt/opt.h"

Uses opt_uses(Ir *ir, Arena *arena)
{
    uint8_t *live = ARENA_ARRAY(&ir->kept, uint8_t, ir->count);
    uint32_t *uses = ARENA_ARRAY(arena, uint32_t, ir->count);
    /* replaced functions use nothing */
    bool *applied = ARENA_ARRAY(arena, bool, ir->function_count + 1);
    for (int i = 0; i < ir->output_count; i++)
        uses[ir->outputs[i].value]++;
    for (Ref ref = (Ref)ir->count - 1; ref > 0; ref--) {
        const IrNode *node = ir_at(ir, ref);
        if (!uses[ref])
            continue;
        live[ref] = 1;
        for (int i = 0; i < node->count; i++)
            uses[ir->args[node->first + (uint32_t)i]]++;
        if (ir_applies(ir, ref) && !applied[node->payload]) {
            applied[node->payload] = true;
            uses[ir->functions[node->payload].result]++;
        }
    }
    ir->live = live;
    ir->live_count = ir->count;
    return (Uses){uses, (Ref)ir->count, NULL};
}
