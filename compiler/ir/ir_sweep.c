/* Rebuilds the live nodes in one sweep, operands first; most optimizer passes are sweeps. */
#include "compiler/ir/ir.h"

/* Replacements of nodes and functions during a sweep. */
typedef struct {
    bool any;
    Ref *node;
    /* A function with a changed result is replaced by a new function, since calls must follow
     * the new result. */
    uint32_t *function;
    /* Lists of functions by result: heads by Ref, from 1; then the next function with the same
     * result. */
    int *by_result, *next;
} Moves;

static Moves new_moves(const Ir *ir, Arena *scratch)
{
    Moves moves = {.node = arena_alloc(scratch, sizeof(Ref) * ir->count)};
    if (!ir->function_count)
        return moves;
    moves.function = ARENA_ARRAY(scratch, uint32_t, ir->function_count);
    moves.next = ARENA_ARRAY(scratch, int, ir->function_count);
    moves.by_result = ARENA_ARRAY(scratch, int, ir->count);
    for (size_t f = 0; f < ir->function_count; f++) {
        Ref result = ir->functions[f].result;
        moves.function[f] = (uint32_t)f;
        moves.next[f] = moves.by_result[result];
        moves.by_result[result] = (int)f + 1;
    }
    return moves;
}

/* Rebuilds a node on the replacements of its operands. */
static Ref remake(Ir *ir, Ref ref, const Moves *moves)
{
    IrNode node = ir->nodes[ref];
    Ref args[UINT8_MAX];
    if (ir_applies(ir, ref))
        node.payload = moves->function[node.payload];
    bool same = node.payload == ir->nodes[ref].payload;
    for (int i = 0; i < node.count; i++) {
        Ref old = ir->args[node.first + (uint32_t)i];
        args[i] = moves->node[old];
        same &= args[i] == old;
    }
    if (same)
        return ref;
    Ref made = ir_make(ir, node, args);
    if (!ir_is(ir, made, OP_const))
        ir_set_head(ir, made, ir_is_head(ir, made) || node.flags & NODE_head);
    return made;
}

static void move_functions(Ir *ir, Moves *moves, Ref old, Ref result)
{
    for (int f = moves->by_result ? moves->by_result[old] : 0; f; f = moves->next[f - 1]) {
        IrFunction function = ir->functions[f - 1];
        function.result = result;
        moves->function[f - 1] = (uint32_t)ir->function_count;
        ARENA_PUSH(ir->arena, ir->functions, ir->function_count, ir->function_capacity, function);
    }
}

/* Moves the flag NODE_head to the replacement of a map's head node. */
static void pass_head(Ir *ir, Ref old, Ref better)
{
    if (ir_is_head(ir, old) && ir->nodes[better].origin == ir->nodes[old].origin)
        ir_set_head(ir, better, true);
}

bool ir_sweep(Ir *ir, IrRewrite *rewrite, const void *user)
{
    return ir_sweep_unsettled(ir, 0, rewrite, user);
}

bool ir_sweep_unsettled(Ir *ir, uint8_t settled, IrRewrite *rewrite, const void *user)
{
    const uint8_t *live = ir_live_kept(ir);
    Moves moves = new_moves(ir, &ir->scratch);
    Ref count = (Ref)ir->count;
    for (Ref ref = 1; ref < count; ref++) {
        if (!live[ref])
            continue;
        moves.node[ref] = ref;
        if (!moves.any && ir->nodes[ref].flags & settled)
            continue;
        ir->origin = ir->nodes[ref].origin;
        Ref better = moves.any ? remake(ir, ref, &moves) : ref;
        if (!(ir->nodes[better].flags & settled))
            better = rewrite(ir, better, user);
        if (better == ref)
            continue;
        moves.node[ref] = better;
        moves.any = true;
        pass_head(ir, ref, better);
        move_functions(ir, &moves, ref, better);
    }
    if (!moves.any)
        return false;
    ir->live = NULL;
    for (int i = 0; i < ir->output_count; i++)
        ir->outputs[i].value = moves.node[ir->outputs[i].value];
    return true;
}
