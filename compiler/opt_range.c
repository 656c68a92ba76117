/* Intervals of every value: a clamp that cannot bite is dropped, a comparison that is always the same is decided. The
 * intervals hold in floats: where an operation rounds, a bound is only believed with a little to spare. */
#include "opt.h"
#include <math.h>

typedef struct {
    double low, high; /* of every lane */
} Interval;

static const Interval everything = {-INFINITY, INFINITY};

typedef struct {
    Interval *of; /* by Ref */
    Ref count;
} Ranges;

static Interval range_of(const Ranges *r, Ref ref) { return ref < r->count ? r->of[ref] : everything; }

static Interval hull(Interval a, Interval b) { return (Interval){fmin(a.low, b.low), fmax(a.high, b.high)}; }

static Interval numbers(const Ir *ir, Ref ref)
{
    const double *lane = ir_numbers(ir, ref);
    Interval range = {lane[0], lane[0]};
    for (int i = 1; i < ir_lanes(ir, ref); i++)
        range = hull(range, (Interval){lane[i], lane[i]});
    return range;
}

static double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

static Interval times(Interval a, Interval b)
{
    double p = product(a.low, b.low), q = product(a.low, b.high), r = product(a.high, b.low),
           s = product(a.high, b.high);
    return (Interval){fmin(fmin(p, q), fmin(r, s)), fmax(fmax(p, q), fmax(r, s))};
}

static Interval sum(Interval a, Interval b)
{
    Interval s = {a.low + b.low, a.high + b.high};
    return (Interval){isnan(s.low) ? -INFINITY : s.low, isnan(s.high) ? INFINITY : s.high};
}

static Interval magnitude(Interval a)
{
    double high = fmax(fabs(a.low), fabs(a.high));
    return (Interval){a.low <= 0 && a.high >= 0 ? 0 : fmin(fabs(a.low), fabs(a.high)), high};
}

static Interval mixed(Interval a, Interval b, Interval t)
{
    return t.low >= 0 && t.high <= 1 ? hull(a, b) : everything;
}

static Interval function_range(int function)
{
    switch (function) {
#define FUNCTION(name, result, arguments, low, high, cost, doc)                                                        \
    case FN_##name:                                                                                                    \
        return (Interval){low, high};
#include "grammar/functions.def"
    default:
        return everything;
    }
}

static Interval node_range(const Ir *ir, Ref ref, const Ranges *r)
{
    const IrNode *node = ir_at(ir, ref);
    Interval a = node->count > 0 ? range_of(r, ir_arg(ir, ref, 0)) : everything;
    Interval b = node->count > 1 ? range_of(r, ir_arg(ir, ref, 1)) : everything;
    Interval c = node->count > 2 ? range_of(r, ir_arg(ir, ref, 2)) : everything, all = a;
    switch (node->op) {
    case OP_const:
        return node->type == TYPE_sampler ? everything : numbers(ir, ref);
    case OP_neg:
        return (Interval){-a.high, -a.low};
    case OP_abs:
        return magnitude(a);
    case OP_floor:
        return (Interval){floor(a.low), floor(a.high)};
    case OP_ceil:
        return (Interval){ceil(a.low), ceil(a.high)};
    case OP_fract:
        return (Interval){0, 1};
    case OP_sin:
    case OP_cos:
        return (Interval){-1, 1};
    case OP_add:
        return sum(a, b);
    case OP_sub:
        return sum(a, (Interval){-b.high, -b.low});
    case OP_mul:
        return ir_arg(ir, ref, 0) == ir_arg(ir, ref, 1) ? times(magnitude(a), magnitude(a)) : times(a, b);
    case OP_min:
        return (Interval){fmin(a.low, b.low), fmin(a.high, b.high)};
    case OP_max:
        return (Interval){fmax(a.low, b.low), fmax(a.high, b.high)};
    case OP_clamp:
        return (Interval){fmin(fmax(a.low, b.low), c.high), fmax(fmin(a.high, c.high), b.low)};
    case OP_mix:
        return mixed(a, b, c);
    case OP_select:
        return hull(b, c);
    case OP_swizzle:
        return a;
    case OP_vec:
        for (int i = 1; i < node->count; i++)
            all = hull(all, range_of(r, ir_arg(ir, ref, i)));
        return all;
    case OP_call:
        return function_range((int)node->payload);
    case OP_kernel:
        return times(range_of(r, ir->functions[node->payload].result), (Interval){KERNEL_POINTS, KERNEL_POINTS});
    case OP_apply:
        return range_of(r, ir->functions[node->payload].result);
    default:
        return everything;
    }
}

/* Whether a value surely lies in [low, high]; where it came by arithmetic, a rounding's worth inside. */
static bool within(const Ir *ir, Ref ref, Interval range, double low, double high)
{
    const double slack = 1e-5;
    Op op = (Op)ir_at(ir, ref)->op;
    bool exact = op != OP_add && op != OP_sub && op != OP_mul && op != OP_mix && op != OP_apply && op != OP_kernel &&
                 op != OP_vec && op != OP_select && op != OP_swizzle;
    double spare = exact ? 0 : slack;
    return range.low >= low + spare * fabs(low) && range.high <= high - spare * fabs(high);
}

static Ref truth(Ir *ir, bool value) { return ir_const(ir, TYPE_bool, (double[]){value}); }

static Ref decide(Ir *ir, Ref ref, const Ranges *r)
{
    const IrNode *node = ir_at(ir, ref);
    if (node->count < 2)
        return ref;
    Ref a = ir_arg(ir, ref, 0), b = ir_arg(ir, ref, 1);
    Interval x = range_of(r, a), y = range_of(r, b);
    bool same_type = ir_type(ir, a) == (Type)node->type;
    switch (node->op) {
    case OP_clamp: {
        Interval z = range_of(r, ir_arg(ir, ref, 2));
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
    Arena *scratch = &ir->scratch;
    Ranges ranges = {ARENA_ARRAY(scratch, Interval, ir->count), (Ref)ir->count};
    for (Ref ref = 1; ref < ranges.count; ref++)
        ranges.of[ref] = node_range(ir, ref, &ranges);
    bool changed = opt_sweep(ir, apply_ranges, &ranges);
    return changed;
}
