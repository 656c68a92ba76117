/* Interval arithmetic over the IR, operands first.
 *
 *     a = fract(u)       [0, 1], whatever u is
 *     b = sub(a, 0.5)    [-0.5, 0.5]
 *     c = mul(b, b)      [0, 0.25]: one value twice, where the corners alone would give [-0.25, 0.25]
 *     d = max(c, 0)      is c, as opt_range finds */
#include "compiler/ir/range.h"
#include "runtime/library/references.h"
#include <math.h>

static const Interval everything = {-INFINITY, INFINITY};

/* What drivers may err by where GLSL lets them: more than a rounding. */
static const double SLACK = 1e-5;

Interval range_of(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    return r->guards ? range_guarded(r, ir, ref, lane) : range_kept(r, ir, ref, lane);
}

Interval range_kept(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    if (ref >= r->count)
        return everything;
    return r->lanes == 1 ? r->of[ref] : r->of[(Ref)r->lanes * ref + (Ref)(ir_lanes(ir, ref) == 1 ? 0 : lane)];
}

static Interval between(double low, double high) { return (Interval){low, high}; }

static Interval hull(Interval a, Interval b) { return (Interval){fmin(a.low, b.low), fmax(a.high, b.high)}; }

/* Of all lanes of an operand. */
static Interval whole(const Ranges *r, const Ir *ir, Ref ref)
{
    Interval all = range_of(r, ir, ref, 0);
    for (int lane = 1; r->lanes > 1 && lane < ir_lanes(ir, ref); lane++)
        all = hull(all, range_of(r, ir, ref, lane));
    return all;
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

static Interval negative(Interval a) { return (Interval){-a.high, -a.low}; }

static Interval magnitude(Interval a)
{
    double high = fmax(fabs(a.low), fabs(a.high));
    return (Interval){a.low <= 0 && a.high >= 0 ? 0 : fmin(fabs(a.low), fabs(a.high)), high};
}

static Interval square(Interval a) { return times(magnitude(a), magnitude(a)); }

static Interval quotient(Interval a, Interval b)
{
    if (!(b.low > 0 || b.high < 0))
        return everything;
    return times(a, (Interval){1 / b.high, 1 / b.low});
}

/* Beyond the ends of [0, 1] too: a (1 - t) + b t. */
static Interval mixed(Interval a, Interval b, Interval t)
{
    if (t.low >= 0 && t.high <= 1)
        return hull(a, b);
    return sum(times(a, sum((Interval){1, 1}, negative(t))), times(b, t));
}

/* A bound that a driver's function may pass. */
static Interval loose(Interval a)
{
    return (Interval){a.low - SLACK * fmax(fabs(a.low), 1), a.high + SLACK * fmax(fabs(a.high), 1)};
}

/* A function that never falls, between its values at both ends; and one that a driver computes as it likes. */
static Interval ends(double (*f)(double), Interval a) { return between(f(a.low), f(a.high)); }
static Interval rising(double (*f)(double), Interval a) { return loose(ends(f, a)); }

static Interval power(Interval a, Interval b)
{
    if (!(a.low >= 0) || !(b.low >= 0))
        return everything;
    double p = pow(a.low, b.low), q = pow(a.low, b.high), r = pow(a.high, b.low), s = pow(a.high, b.high);
    Interval corners = {fmin(fmin(p, q), fmin(r, s)), fmax(fmax(p, q), fmax(r, s))};
    if (a.low < 1 && a.high > 1)
        corners = hull(corners, (Interval){1, 1});
    return isnan(corners.low) || isnan(corners.high) ? (Interval){0, INFINITY} : loose(corners);
}

static Interval remainder_of(Interval a, Interval b)
{
    if (a.low >= 0 && a.high < b.low)
        return a;
    return b.low > 0 ? (Interval){0, b.high} : everything;
}

/* That of the tables, whatever the arguments are. */
static Interval table_range(int function)
{
    switch (function) {
#define ANY              -INFINITY, INFINITY
#define RANGE(low, high) low, high
#define FUNCTION(name, result, arguments, range, cost, doc)                                                            \
    case FN_##name:                                                                                                    \
        return (Interval){range};
#include "grammar/functions.def"
#undef RANGE
#undef ANY
#define BETWEEN(map, low, high)                                                                                        \
    case FN_FIRST_MAP + KIND_##map:                                                                                    \
        return (Interval){low, high};
#include "grammar/maps.def"
    default:
        return everything;
    }
}

/* Octaves of a noise in [-1, 1]: the sum of their strengths. */
static Interval octaves_range(Interval octaves, Interval ratio)
{
    double strength = 1, most = 0;
    const double each = fmax(fabs(ratio.low), fabs(ratio.high));
    if (!isfinite(each) || octaves.high > 64)
        return everything;
    for (int k = 0; k < fmax(octaves.high, 1); k++, strength *= each)
        most += strength;
    return loose((Interval){-most, most});
}

/* Rises from shininess 0 to 1; beyond, it falls again. */
static Interval exponent_range(Interval a)
{
    double low, high;
    Interval all = table_range(FN_phongExponent);
    if (!(a.low >= 0 && a.high <= 1 + 2 * SLACK))
        return all;
    reference_of(FN_phongExponent)(NULL, &a.low, &low);
    reference_of(FN_phongExponent)(NULL, &a.high, &high);
    high = a.high >= 1 ? all.high : high;
    return (Interval){low * (1 - SLACK), fmin(high * (1 + SLACK), all.high)};
}

static Interval call_range(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    const int function = (int)ir_at(ir, ref)->payload;
    (void)lane;
    switch (function) {
    case FN_turbulence:
        return octaves_range(whole(r, ir, ir_arg(ir, ref, 1)), whole(r, ir, ir_arg(ir, ref, 3)));
    case FN_phongExponent:
        return exponent_range(whole(r, ir, ir_arg(ir, ref, 0)));
    default:
        return table_range(function);
    }
}

/* The sum of the products of lanes; of one lane alone, where all are as one, as often as there are lanes. */
static Interval dot_range(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    const Ref a = ir_arg(ir, ref, 0), b = ir_arg(ir, ref, 1);
    Interval all = {0, 0};
    (void)lane;
    for (int i = 0; i < ir_lanes(ir, a); i++) {
        Interval x = range_of(r, ir, a, i), y = range_of(r, ir, b, i);
        all = sum(all, a == b ? square(x) : times(x, y));
    }
    return all;
}

static Interval length_range(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    const Ref a = ir_arg(ir, ref, 0);
    double squares = 0;
    (void)lane;
    for (int i = 0; i < ir_lanes(ir, a); i++)
        squares += square(range_of(r, ir, a, i)).high;
    return loose((Interval){0, sqrt(squares)});
}

/* A lane of a matrix times a vector, by its columns. */
static Interval linear_range(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    Interval all = {0, 0};
    for (int i = 1; i < ir_at(ir, ref)->count; i++)
        all = sum(all, times(range_of(r, ir, ir_arg(ir, ref, 0), i - 1), range_of(r, ir, ir_arg(ir, ref, i), lane)));
    return all;
}

/* The operand that a vector's lane comes from; all of them, where one interval is kept. */
static Interval vec_range(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    Interval all = range_of(r, ir, ir_arg(ir, ref, 0), 0);
    for (int i = 0, first = 0; i < ir_at(ir, ref)->count; i++) {
        const Ref part = ir_arg(ir, ref, i);
        const int lanes = ir_lanes(ir, part);
        if (r->lanes == 1)
            all = hull(all, range_of(r, ir, part, 0));
        else if (lane >= first && lane < first + lanes)
            return range_of(r, ir, part, lane - first);
        first += lanes;
    }
    return all;
}

static Interval const_range(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    if (ir_type(ir, ref) == TYPE_sampler)
        return everything;
    const double *at = ir_numbers(ir, ref);
    Interval range = between(at[lane], at[lane]);
    for (int i = 1; r->lanes == 1 && i < ir_lanes(ir, ref); i++)
        range = hull(range, between(at[i], at[i]));
    return range;
}

static Interval swizzle_range(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    return range_of(r, ir, ir_arg(ir, ref, 0), (int)(ir_at(ir, ref)->payload >> 2 * lane & 3));
}

static Interval apply_range(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    return range_of(r, ir, ir->functions[ir_at(ir, ref)->payload].result, lane);
}

static Interval kernel_range(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    return times(apply_range(r, ir, ref, lane), between(KERNEL_POINTS, KERNEL_POINTS));
}

/* Of an operation that works lane by lane: the RANGE lines of ops.def. */
static Interval lane_range(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    const IrNode *node = ir_at(ir, ref);
    const bool squared = node->count == 2 && ir_arg(ir, ref, 0) == ir_arg(ir, ref, 1);
    Interval x[3] = {everything, everything, everything}, a, b, c;
    for (int i = 0; i < node->count && i < 3; i++)
        x[i] = range_of(r, ir, ir_arg(ir, ref, i), lane);
    a = x[0], b = x[1], c = x[2];
    switch (node->op) {
#define RANGE(name, interval)                                                                                          \
    case OP_##name:                                                                                                    \
        return interval;
#include "grammar/ops.def"
    default:
        return everything;
    }
}

Interval range_computed(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    switch (ir_at(ir, ref)->op) {
#define RANGE_NODE(name, function)                                                                                     \
    case OP_##name:                                                                                                    \
        return function(r, ir, ref, lane);
#include "grammar/ops.def"
    default:
        return lane_range(r, ir, ref, lane);
    }
}

bool range_is_exact(Op op)
{
    switch (op) {
#define EXACT(name) case OP_##name:
#include "grammar/ops.def"
        return true;
    default:
        return false;
    }
}

Ranges range_find(const Ir *ir, Arena *arena, int lanes)
{
    Ranges r = {ARENA_ARRAY(arena, Interval, ir->count * (size_t)lanes), (Ref)ir->count, lanes, NULL};
    for (Ref ref = 1; ref < r.count; ref++)
        for (int lane = 0; lane < lanes && lane < (lanes == 1 ? 1 : ir_lanes(ir, ref)); lane++) {
            Interval range = range_computed(&r, ir, ref, lane);
            bool none = isnan(range.low) || isnan(range.high);
            r.of[(Ref)lanes * ref + (Ref)lane] = none ? everything : range;
        }
    return r;
}
