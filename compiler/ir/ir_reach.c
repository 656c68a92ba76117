/* Finds the nodes of one function, or of main, starting at its roots. The cost is proportional
 * to the nodes found, so many functions are cheap. */
#include "compiler/ir/ir.h"
#include <stdlib.h>

enum {
    SPARSE = 8
    /* Ratio of the range of node numbers to the nodes found, above which sorting the nodes is
     * cheaper than scanning the range. */
};

static int falling(const void *a, const void *b)
{
    Ref x = *(const Ref *)a, y = *(const Ref *)b;
    return x < y ? 1 : x > y ? -1 : 0;
}

static void push(IrReach *r, Ref ref)
{
    if (!ref || r->inside[ref])
        return;
    r->inside[ref] = 1;
    ARENA_PUSH(r->arena, r->at, r->count, r->capacity, ref);
}

IrReach ir_reach_new(const Ir *ir, Arena *arena)
{
    return (IrReach){.arena = arena, .inside = ARENA_ARRAY(arena, uint8_t, ir->count)};
}

/* Searches breadth-first; the list of found nodes is also the queue. */
void ir_reach(const Ir *ir, const Ref *roots, int count, IrReach *r)
{
    Ref last = 0, first = UINT32_MAX;
    for (size_t i = 0; i < r->count; i++)
        r->inside[r->at[i]] = 0;
    r->count = 0;
    for (int i = 0; i < count; i++)
        push(r, roots[i]);
    for (size_t i = 0; i < r->count; i++) {
        Ref ref = r->at[i];
        last = ref > last ? ref : last;
        first = ref < first ? ref : first;
        for (int k = 0; k < ir_at(ir, ref)->count; k++)
            push(r, ir_arg(ir, ref, k));
    }
    if (!r->count)
        return;
    if ((last - first) / SPARSE > r->count) {
        qsort(r->at, r->count, sizeof *r->at, falling);
        return;
    }
    r->count = 0;
    for (Ref ref = last; ref >= first && ref; ref--)
        if (r->inside[ref])
            r->at[r->count++] = ref;
}

size_t ir_written(const Ir *ir, size_t limit)
{
    Arena scratch = {0};
    IrReach reach = ir_reach_new(ir, &scratch);
    Ref roots[MAX_OUTPUTS];
    for (int i = 0; i < ir->output_count; i++)
        roots[i] = ir->outputs[i].value;
    ir_reach(ir, roots, ir->output_count, &reach);
    size_t total = reach.count;
    for (size_t f = 0; f < ir->function_count && total <= limit; f++) {
        ir_reach(ir, &ir->functions[f].result, 1, &reach);
        total += reach.count;
    }
    arena_free(&scratch);
    return total;
}
