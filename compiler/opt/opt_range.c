/* The BOUND rows of rules.def: a clamp that cannot bite is dropped, a comparison that is always the same is decided. The intervals
 * hold in floats: where an operation rounds, a bound is only believed with a little to spare. */
#include "compiler/opt/opt.h"
#include "compiler/ir/range.h"
#include <math.h>

typedef struct {
    const Ir *ir;
    const Ranges *ranges;
} Site;

static Interval range_at(const Site *s, Ref ref) { return range_of(s->ranges, s->ir, ref, 0); }

/* Whether a value surely lies in [low, high]; where it came by arithmetic, a rounding's worth inside. */
static bool lies_within(const Site *s, Ref ref, double low, double high)
{
    const double slack = 1e-5;
    const Interval range = range_at(s, ref);
    double spare = range_is_exact((Op)ir_at(s->ir, ref)->op) ? 0 : slack;
    return range.low >= low + spare * fabs(low) && range.high <= high - spare * fabs(high);
}

#define low(x)                 range_at(&site, x).low
#define high(x)                range_at(&site, x).high
#define within(x, least, most) lies_within(&site, x, least, most)
#define truth(x)               build_truth(ir, x)
#define spread(x)              build_splat(ir, x, (Type)node.type)

/* The BOUND rows of rules.def. */
static Ref decide(Ir *ir, Ref ref, const void *user)
{
    const Site site = {ir, user};
    const IrNode node = *ir_at(ir, ref);
    Ref a = node.count > 0 ? ir_arg(ir, ref, 0) : 0, b = node.count > 1 ? ir_arg(ir, ref, 1) : 0;
    Ref c = node.count > 2 ? ir_arg(ir, ref, 2) : 0, found;
    switch (node.op) {
#define ON(op) case OP_##op:
#define BOUND(condition, result, why)                                                                                  \
    if ((condition) && ir_type(ir, found = (result)) == (Type)node.type)                                               \
        return found;
#define END break;
#include "grammar/rules.def"
    default:
        break;
    }
    return ref;
}

bool opt_range(Ir *ir)
{
    Ranges ranges = range_find(ir, &ir->scratch, 1);
    return ir_sweep(ir, decide, &ranges);
}
