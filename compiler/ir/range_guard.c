/* Intervals where a condition holds: in select(t < 1, a, b), t is below 1 in a, and not below it in b. What an arm computes of
 * t is computed once more with that, as far as LIMIT_GUARD_STEPS go; beyond, what is known everywhere.
 *
 *     t in [0, 4], select(t < 1, t * t, 2)    [0, 16] by t alone; in the first arm t is in [0, 1], so [0, 2] */
#include "compiler/ir/range.h"
#include <math.h>

enum { MOST_GUARDS = 16 };

typedef struct {
    Ref ref;
    Interval within;
} Guard;

typedef struct Guards {
    Guard at[MOST_GUARDS];
    int count;
    int steps; /* left */
} Guards;

static Interval hull(Interval a, Interval b) { return (Interval){fmin(a.low, b.low), fmax(a.high, b.high)}; }
static Interval both(Interval a, Interval b) { return (Interval){fmax(a.low, b.low), fmin(a.high, b.high)}; }
static bool is_empty(Interval a) { return a.low > a.high; }

/* The node that a condition compares with a constant, and where it lies when the condition holds, and when not. */
static bool read_condition(const Ranges *r, const Ir *ir, Ref condition, Ref *value, Interval sides[2])
{
    const IrNode *node = ir_at(ir, condition);
    if (node->op != OP_lt && node->op != OP_le)
        return false;
    const Ref a = ir_arg(ir, condition, 0), b = ir_arg(ir, condition, 1);
    if (ir_lanes(ir, a) != 1 || ir_lanes(ir, b) != 1)
        return false;
    const bool right = ir_is(ir, b, OP_const);
    const double at = range_kept(r, ir, right ? b : a, 0).low;
    *value = right ? a : b;
    sides[right ? 0 : 1] = (Interval){-INFINITY, at};
    sides[right ? 1 : 0] = (Interval){at, INFINITY};
    return right || ir_is(ir, a, OP_const);
}

/* Where the side holds. */
static Interval arm_range(const Ranges *r, const Ir *ir, Ref arm, int lane, Guard side)
{
    const Interval none = {INFINITY, -INFINITY};
    side.within = both(range_of(r, ir, side.ref, 0), side.within);
    if (is_empty(side.within))
        return none; /* it is never taken */
    Guards *guards = r->guards;
    guards->at[guards->count++] = side;
    Interval found = range_of(r, ir, arm, lane);
    guards->count--;
    return found;
}

Interval range_select(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    Ref value;
    Interval sides[2];
    Guards own = {.steps = LIMIT_GUARD_STEPS};
    Ranges with = *r;
    const Ref a = ir_arg(ir, ref, 1), b = ir_arg(ir, ref, 2);
    if (!with.guards)
        with.guards = &own;
    if (r->lanes == 1 || with.guards->count == MOST_GUARDS || !read_condition(r, ir, ir_arg(ir, ref, 0), &value, sides))
        return hull(range_of(r, ir, a, lane), range_of(r, ir, b, lane));
    return hull(arm_range(&with, ir, a, lane, (Guard){value, sides[0]}),
                arm_range(&with, ir, b, lane, (Guard){value, sides[1]}));
}

/* What comes before every guarded node cannot depend on one. */
static bool is_before(const Guards *guards, Ref ref)
{
    for (int i = 0; i < guards->count; i++)
        if (ref >= guards->at[i].ref)
            return false;
    return true;
}

Interval range_guarded(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    Guards *guards = r->guards;
    Interval kept = range_kept(r, ir, ref, lane);
    const Op op = (Op)ir_at(ir, ref)->op;
    bool guarded = false;
    for (int i = 0; i < guards->count; i++)
        if (guards->at[i].ref == ref) {
            kept = both(kept, guards->at[i].within);
            guarded = true;
        }
    if (guarded || ref >= r->count || op == OP_const || is_before(guards, ref) || guards->steps-- <= 0)
        return kept;
    Interval found = range_computed(r, ir, ref, lane);
    Interval narrow = both(kept, found);
    return isnan(found.low) || isnan(found.high) || is_empty(narrow) ? kept : narrow;
}
