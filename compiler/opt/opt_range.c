/* A clamp that cannot bite is dropped, a comparison that is always the same is decided. The intervals hold in floats: where an
 * operation rounds, a bound is only believed with a little to spare. */
#include "compiler/opt/opt.h"
#include "compiler/ir/range.h"
#include <math.h>

/* Its interval holds to the last bit. */
static bool is_exact(Op op)
{
    switch (op) {
    case OP_const:
    case OP_neg:
    case OP_abs:
    case OP_floor:
    case OP_ceil:
    case OP_fract:
    case OP_step:
    case OP_sign:
    case OP_sin:
    case OP_cos:
    case OP_min:
    case OP_max:
    case OP_clamp:
    case OP_call:
        return true;
    default:
        return false;
    }
}

/* Whether a value surely lies in [low, high]; where it came by arithmetic, a rounding's worth inside. */
static bool within(const Ir *ir, Ref ref, Interval range, double low, double high)
{
    const double slack = 1e-5;
    double spare = is_exact((Op)ir_at(ir, ref)->op) ? 0 : slack;
    return range.low >= low + spare * fabs(low) && range.high <= high - spare * fabs(high);
}

static Ref truth(Ir *ir, bool value) { return ir_const(ir, TYPE_bool, (double[]){value}); }

static Ref decide(Ir *ir, Ref ref, const Ranges *r)
{
    const IrNode *node = ir_at(ir, ref);
    if (node->count < 2)
        return ref;
    Ref a = ir_arg(ir, ref, 0), b = ir_arg(ir, ref, 1);
    Interval x = range_of(r, ir, a, 0), y = range_of(r, ir, b, 0);
    bool same_type = ir_type(ir, a) == (Type)node->type;
    switch (node->op) {
    case OP_clamp: {
        Interval z = range_of(r, ir, ir_arg(ir, ref, 2), 0);
        return same_type && within(ir, a, x, y.high, z.low) ? a : ref;
    }
    case OP_max:
        return same_type && x.low >= y.high ? a : ir_type(ir, b) == node->type && y.low >= x.high ? b : ref;
    case OP_min:
        return same_type && x.high <= y.low ? a : ir_type(ir, b) == node->type && y.high <= x.low ? b : ref;
    case OP_lt:
        return x.high < y.low ? truth(ir, true) : x.low > y.high ? truth(ir, false) : ref;
    case OP_le:
        return x.high < y.low ? truth(ir, true) : x.low > y.high ? truth(ir, false) : ref;
    default:
        return ref;
    }
}

static Ref apply_ranges(Ir *ir, Ref ref, const void *user) { return decide(ir, ref, user); }

bool opt_range(Ir *ir)
{
    Ranges ranges = range_find(ir, &ir->scratch, 1);
    return opt_sweep(ir, apply_ranges, &ranges);
}
