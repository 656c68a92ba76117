/* Computes the cost of a value up to a limit. */
#include "compiler/lower/lower.h"

/* Visits a value's nodes breadth-first and adds up their cost, stopping at `limit`. A shared node
 * counts once for each user, and nodes without a cost (components, vectors) could multiply without
 * end, so a value with more than MAX_MET visits counts as costing `limit`. */
int lower_cost_below(const Ir *ir, Ref ref, int limit)
{
    enum { MAX_MET = 1024 };
    Ref met[MAX_MET + UINT8_MAX]; /* stays uninitialized: most values reach the limit early */
    int cost = 0;
    met[0] = ref;
    for (int from = 0, count = 1; from < count && cost < limit; from++) {
        const IrNode *node = ir_at(ir, met[from]);
        if (ir_applies(ir, met[from]) || count > MAX_MET)
            return limit;
        cost += ir_cost(ir, met[from]);
        for (int i = 0; i < node->count; i++)
            met[count++] = ir_arg(ir, met[from], i);
    }
    return cost;
}
