/* The BOUND rows of rules.def: drops clamps without effect, and decides comparisons with a known
 * result. A value with a single possible number becomes a constant. The intervals hold for float
 * arithmetic: an operation that rounds needs a margin. Intervals are per component:
 *     mix(vec4(a, 1), vec4(b, 1), t)    the last component is 1 for any t
 *     max(vec2(fract(x), 7), 0.5)       stays, since its first component may be below 0.5 */
#include "compiler/opt/opt.h"
#include "compiler/ir/range.h"
#include <math.h>

enum { MAX_COMPONENTS = 4 };

/* State of the sweep. */
typedef struct {
    const Ranges *ranges;
    const bool **
        /* Per Ref: the value depends on floor, ceil or sign, which rounding at an interval's end
         * may move by a whole step; NULL: not computed yet. */
        steps;
} Known;

typedef struct {
    const Ir *ir;
    const Ranges *ranges;
    int component;
} Site;

static Interval range_at(const Site *s, Ref ref)
{
    return range_of(s->ranges, s->ir, ref, s->component);
}

/* Returns true if a value is certainly in [low, high]; for a rounded value with a margin for
 * rounding errors. */
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

/* Returns the max number of components of a node and its operands. */
static int components_at(const Ir *ir, Ref ref)
{
    int components = ir_components(ir, ref);
    for (int i = 0; i < ir_at(ir, ref)->count; i++)
        if (ir_components(ir, ir_arg(ir, ref, i)) > components)
            components = ir_components(ir, ir_arg(ir, ref, i));
    return components;
}

/* Returns true if a node has a step. A function's result also precedes its calls. */
static bool has_step(const Ir *ir, Ref ref, const bool *steps)
{
    const IrNode *node = ir_at(ir, ref);
    if (node->op == OP_floor || node->op == OP_ceil || node->op == OP_sign)
        return true;
    if (ir_applies(ir, ref) && steps[ir->functions[node->payload].result])
        return true;
    for (int i = 0; i < node->count; i++)
        if (steps[ir_arg(ir, ref, i)])
            return true;
    return false;
}

static const bool *find_steps(Ir *ir, Ref count)
{
    bool *steps = ARENA_ARRAY(&ir->scratch, bool, count);
    for (Ref ref = 1; ref < count; ref++)
        steps[ref] = has_step(ir, ref, steps);
    return steps;
}

/* Returns a constant if every component has a single possible value, which is rare. */
static Ref only_value(Ir *ir, Ref ref, const Known *known)
{
    const Type type = ir_type(ir, ref);
    double components[MAX_COMPONENTS] = {0};
    if (type < TYPE_float || type > TYPE_vec4 || ir_is(ir, ref, OP_const) ||
        ref >= known->ranges->count)
        return ref;
    for (int i = 0; i < ir_components(ir, ref); i++) {
        const Interval range = range_of(known->ranges, ir, ref, i);
        if (!is_point(range))
            return ref;
        components[i] = range.low;
    }
    if (!*known->steps)
        *known->steps = find_steps(ir, known->ranges->count);
    return (*known->steps)[ref] ? ref : ir_const(ir, type, components);
}

/* Applies the BOUND rows of rules.def. */
static Ref decide(Ir *ir, Ref ref, const void *user)
{
    const Known *known = user;
    Site site = {ir, known->ranges, 0};
    bool holds; /* every component satisfies the condition */
    int components;
    const IrNode node = *ir_at(ir, ref);
    Ref a = node.count > 0 ? ir_arg(ir, ref, 0) : 0, b = node.count > 1 ? ir_arg(ir, ref, 1) : 0;
    Ref c = node.count > 2 ? ir_arg(ir, ref, 2) : 0, found;
    switch (node.op) {
#define ON(op) case OP_##op:
#define BOUND(condition, result, why)                                                              \
    for (holds = true, components = components_at(ir, ref), site.component = 0;                    \
         holds && site.component < components; site.component++)                                   \
        holds = (condition);                                                                       \
    if (holds && ir_type(ir, found = (result)) == (Type)node.type)                                 \
        return found;
#define END break;
#include "grammar/rules.def"
    default:
        break;
    }
    const Ref only = only_value(ir, ref, known);
    if (only == ref && range_is_found(known->ranges, ref))
        ir->nodes[ref].flags |= NODE_decided;
    return only;
}

bool opt_range(Ir *ir)
{
    const uint8_t *live = ir_live_kept(ir);
    const bool *steps = NULL;
    if (!ir->ranges) {
        ir->ranges = ARENA_NEW(&ir->kept, Ranges);
        ir->ranges->components = MAX_COMPONENTS;
    }
    range_find_live(ir->ranges, ir, &ir->kept, live);
    const Known known = {ir->ranges, &steps};
    return ir_sweep_unsettled(ir, NODE_decided, decide, &known);
}
