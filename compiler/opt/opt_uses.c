/* How often nodes are used: what a rule may cost more than it gains. */
#include "compiler/opt/opt.h"

Uses opt_uses(const Ir *ir, Arena *arena)
{
    uint8_t *live = ir_live(ir, arena);
    uint32_t *uses = ARENA_ARRAY(arena, uint32_t, ir->count);
    bool *applied = ARENA_ARRAY(arena, bool, ir->function_count + 1); /* those that others have replaced use nothing */
    for (Ref ref = 1; ref < ir->count; ref++) {
        if (!live[ref])
            continue;
        for (int i = 0; i < ir->nodes[ref].count; i++)
            uses[ir_arg(ir, ref, i)]++;
        if (ir_applies(ir, ref))
            applied[ir_at(ir, ref)->payload] = true;
    }
    for (int i = 0; i < ir->output_count; i++)
        uses[ir->outputs[i].value]++;
    for (size_t f = 0; f < ir->function_count; f++)
        uses[ir->functions[f].result] += applied[f];
    return (Uses){uses, live, (Ref)ir->count};
}
