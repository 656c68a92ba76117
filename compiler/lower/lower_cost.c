/* What a value costs, as far as it matters. */
#include "compiler/lower/lower.h"

/* Left to right, operands behind their users. What has no cost of its own, lanes and vectors of them, may be met without end
 * where it is shared: a value of more than MOST_MET nodes is costly. */
int lower_cost_below(const Ir *ir, Ref ref, int limit)
{
    enum { MOST_MET = 1024 };
    Ref met[MOST_MET + UINT8_MAX]; /* not cleared: most values are cheap, or met their limit soon */
    int cost = 0;
    met[0] = ref;
    for (int from = 0, count = 1; from < count && cost < limit; from++) {
        const IrNode *node = ir_at(ir, met[from]);
        if (ir_applies(ir, met[from]) || count > MOST_MET)
            return limit;
        cost += ir_cost(ir, met[from]);
        for (int i = 0; i < node->count; i++)
            met[count++] = ir_arg(ir, met[from], i);
    }
    return cost;
}
