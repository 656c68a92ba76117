/* The list of passes, and the sweep that most of them are. */
#include "compiler/opt/opt.h"
#include <string.h>

enum { MOST_ROUNDS = 8 };

typedef struct {
    const char *name;
    bool (*run)(Ir *ir);
} PassRun;

/* What stands for old nodes and functions during a sweep. */
typedef struct {
    Ref *node;
    uint32_t *function;    /* a function whose result changed is a new one: its calls then come after the new result */
    int *by_result, *next; /* functions of a result: head by Ref, from 1; then the next with the same */
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

static Ref remake(Ir *ir, Ref ref, const Moves *moves)
{
    const IrNode node = ir->nodes[ref];
    Ref args[UINT8_MAX];
    uint32_t payload = ir_applies(ir, ref) ? moves->function[node.payload] : node.payload;
    bool same = payload == node.payload;
    for (int i = 0; i < node.count; i++) {
        Ref old = ir->args[node.first + (uint32_t)i];
        args[i] = moves->node[old];
        same &= args[i] == old;
    }
    if (same)
        return ref;
    Ref made = ir_make(ir, (Op)node.op, (Type)node.type, payload, args, node.count);
    if (!ir_is(ir, made, OP_const))
        ir->nodes[made].head |= node.head;
    return made;
}

static void move_functions(Ir *ir, Moves *moves, Ref old, Ref result)
{
    for (int f = moves->by_result ? moves->by_result[old] : 0; f; f = moves->next[f - 1]) {
        IrFunction function = ir->functions[f - 1];
        function.result = result;
        moves->function[f - 1] = (uint32_t)ir->function_count;
        ARENA_PUSH(ir->arena, ir->functions, ir->function_count, ir->function_room, function);
    }
}

bool opt_sweep(Ir *ir, Rewrite rewrite, const void *user)
{
    Arena *scratch = &ir->scratch;
    uint8_t *live = ir_live(ir, scratch);
    Moves moves = new_moves(ir, scratch);
    Ref count = (Ref)ir->count;
    bool changed = false;
    for (Ref ref = 1; ref < count; ref++) {
        if (!live[ref])
            continue;
        uint8_t head = ir->nodes[ref].head;
        ir->hint = ir->nodes[ref].hint;
        Ref better = rewrite(ir, remake(ir, ref, &moves), user);
        moves.node[ref] = better;
        if (better == ref)
            continue;
        changed = true;
        if (head && !ir->nodes[better].head && ir->nodes[better].hint == ir->hint)
            ir->nodes[better].head = 1;
        move_functions(ir, &moves, ref, better);
    }
    for (int i = 0; i < ir->output_count; i++)
        ir->outputs[i].value = moves.node[ir->outputs[i].value];
    return changed;
}

uint32_t *opt_uses(const Ir *ir, Arena *arena)
{
    uint8_t *live = ir_live(ir, arena);
    uint32_t *uses = ARENA_ARRAY(arena, uint32_t, ir->count);
    for (Ref ref = 1; ref < ir->count; ref++)
        for (int i = 0; live[ref] && i < ir->nodes[ref].count; i++)
            uses[ir_arg(ir, ref, i)]++;
    for (int i = 0; i < ir->output_count; i++)
        uses[ir->outputs[i].value]++;
    for (size_t f = 0; f < ir->function_count; f++)
        uses[ir->functions[f].result]++;
    return uses;
}

static bool run_pass(Session *session, Ir *ir, const PassRun *pass, bool *progress)
{
    *progress |= pass->run(ir);
    arena_reset(&ir->scratch);
    const char *fault = session->check ? ir_check(ir) : NULL;
    if (fault)
        diag_add(session, NO_SPAN, DIAG_broken_ir, pass->name, fault);
    if (session->measure) {
        int nodes, cost;
        ir_measure(ir, &nodes, &cost);
        session_stage_done(session, pass->name, nodes, cost);
    }
    return !fault;
}

/* The builder has applied the local rules to every node as it was made; what they gain from knowing uses and ranges is left,
 * and each gain may make room for another. Ranges and functions gain nothing new where nothing changed. */
bool opt_run(Session *session, Ir *ir)
{
    static const PassRun polish = {"polish", opt_polish}, range = {"range", opt_range},
                         function = {"function", opt_function}, merge = {"merge", opt_merge};
    bool changed = true, merged = false;
    if (!run_pass(session, ir, &merge, &merged))
        return false;
    for (int round = 0; round < MOST_ROUNDS; round++) {
        if (!run_pass(session, ir, &polish, &changed))
            return false;
        if (!changed)
            break;
        changed = false;
        if (!run_pass(session, ir, &range, &changed) || !run_pass(session, ir, &function, &changed))
            return false;
    }
    return true;
}
