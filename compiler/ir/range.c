/* Interval arithmetic over the IR, operands first.
 *
 *     a = fract(u)       [0, 1], whatever u is
 *     b = sub(a, 0.5)    [-0.5, 0.5]
 *     c = mul(b, b)      [0, 0.25]: equal operands; bounds alone would give [-0.25, 0.25]
 *     d = max(c, 0)      equals c, which opt_range uses */
#include "compiler/ir/range.h"
#include "compiler/library/references.h"
#include <math.h>

enum { MAX_GUARDS = 16, SEEN_SLOTS = 128, MAX_COMPONENTS = 4 };

typedef struct {
    Ref ref;
    Interval within;
} Guard;

typedef struct Guards {
    Guard at[MAX_GUARDS];
    int count;
    uint32_t set; /* id of the current set of guards; every set ever active has its own id */
    int steps;    /* remaining number of reexaminations */
    int depth;    /* recursion depth of reexamined nodes */
} Guards;

/* Interval of one component of a node while a set of guards holds. */
typedef struct {
    uint32_t set;
    Ref ref;
    int component;
    Interval found;
} SeenComponent;

typedef struct Seen {
    SeenComponent slots[SEEN_SLOTS];
    uint32_t sets; /* number of sets so far */
} Seen;

struct Seen *range_seen_new(Arena *arena)
{
    Seen *seen = arena_alloc(arena, sizeof *seen);
    seen->sets = 0;
    for (int i = 0; i < SEEN_SLOTS; i++)
        seen->slots[i].set = 0; /* the slot becomes empty: its set is 0 */
    return seen;
}

/* -- Guards: intervals under a condition. In the arms of select(t < 1, a, b), t is below 1 in a
 * and at least 1 in b. Nodes of an arm that depend on t are recomputed with the narrower
 * interval, up to LIMIT_GUARD_STEPS and LIMIT_GUARD_DEPTH; further nodes keep their general
 * interval.
 *
 *     t in [0, 4], select(t < 1, t * t, 2)    [0, 16] by t alone; in the first arm t is in
 *                                             [0, 1], so the result is in [0, 2] */

static SeenComponent *seen_slot(const Ranges *r, Ref ref, int component)
{
    return &r->seen->slots[(ref * 4 + (Ref)component) % SEEN_SLOTS];
}

/* Returns the number of intervals of a node: one per component; a sampler, without components,
 * has one. */
static int components_of(const Ir *ir, Ref ref)
{
    return ir_components(ir, ref) ? ir_components(ir, ref) : 1;
}

/* Recomputes the interval of a node that depends on guarded nodes, from its operands under the
 * guards. */
static Interval found_again(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    Guards *guards = r->guards;
    const uint32_t set = guards->set;
    SeenComponent *slot = seen_slot(r, ref, component);
    if (slot->set == set && slot->ref == ref && slot->component == component)
        return slot->found;
    if (guards->depth == LIMIT_GUARD_DEPTH || guards->steps-- <= 0)
        return everything;
    guards->depth++;
    if (ir_is(ir, ref, OP_select)) {
        Interval components[MAX_COMPONENTS];
        range_select(r, ir, ref, components_of(ir, ref), components);
        for (int i = 0; i < components_of(ir, ref); i++)
            *seen_slot(r, ref, i) = (SeenComponent){set, ref, i, components[i]};
    } else {
        *slot = (SeenComponent){set, ref, component, range_computed(r, ir, ref, component)};
    }
    guards->depth--;
    return slot->found;
}

Interval range_guarded(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    const Guards *guards = r->guards;
    Interval kept = range_kept(r, ref, component);
    bool guarded = false;
    component = r->place[ref].by_component
                    ? component
                    : 0; /* a node with a single interval for all components */
    for (int i = 0; i < guards->count; i++)
        if (guards->at[i].ref == ref) {
            kept = both(kept, guards->at[i].within);
            guarded = true;
        }
    if (guarded)
        return kept;
    const Interval found = found_again(r, ir, ref, component), narrow = both(kept, found);
    return isnan(found.low) || isnan(found.high) || is_empty(narrow) ? kept : narrow;
}

/* Decodes a comparison with a constant: the compared node, and its interval where the condition
 * holds (sides[0]) and where it does not (sides[1]). */
static bool read_condition(const Ranges *r, const Ir *ir, Ref condition, Ref *value,
                           Interval sides[2])
{
    const IrNode *node = ir_at(ir, condition);
    if (node->op != OP_lt && node->op != OP_le)
        return false;
    const Ref a = ir_arg(ir, condition, 0), b = ir_arg(ir, condition, 1);
    if (ir_components(ir, a) != 1 || ir_components(ir, b) != 1)
        return false;
    const bool right = ir_is(ir, b, OP_const);
    const double at = range_kept(r, right ? b : a, 0).low;
    *value = right ? a : b;
    sides[right ? 0 : 1] = (Interval){-INFINITY, at};
    sides[right ? 1 : 0] = (Interval){at, INFINITY};
    return right || ir_is(ir, a, OP_const);
}

/* Finds the intervals of all components of a select's arm, given its side of the condition. */
static void find_arm(Ranges *r, const Ir *ir, Ref arm, Guard side, Interval found[MAX_COMPONENTS])
{
    const Interval none = {INFINITY, -INFINITY};
    const int components = components_of(ir, arm);
    side.within = both(range_of(r, ir, side.ref, 0), side.within);
    if (is_empty(side.within)) { /* the select never takes this arm */
        for (int component = 0; component < components; component++)
            found[component] = none;
        return;
    }
    Guards *guards = r->guards;
    const uint64_t guarded = r->guarded;
    const uint32_t set = guards->set;
    guards->at[guards->count++] = side;
    r->guarded |= range_mark(side.ref);
    guards->set = ++r->seen->sets;
    for (int component = 0; component < components; component++)
        found[component] = range_of(r, ir, arm, component);
    guards->count--;
    r->guarded = guarded;
    guards->set = set;
}

/* Union of both arms, used if the condition is no comparison with a constant, or there are too
 * many guards. */
static Interval select_range(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    return hull(range_of(r, ir, ir_arg(ir, ref, 1), component),
                range_of(r, ir, ir_arg(ir, ref, 2), component));
}

void range_select(const Ranges *r, const Ir *ir, Ref ref, int components, Interval *found)
{
    Ref value;
    Interval sides[2];
    const Ref a = ir_arg(ir, ref, 1), b = ir_arg(ir, ref, 2);
    const bool full = r->guards && r->guards->count == MAX_GUARDS;
    if (full || !read_condition(r, ir, ir_arg(ir, ref, 0), &value, sides)) {
        for (int component = 0; component < components; component++)
            found[component] = select_range(r, ir, ref, component);
        return;
    }
    Guards own; /* uninitialized: programs have many selects, and most need one guard */
    Ranges with = *r;
    if (!r->guards) {
        own.count = own.depth = 0;
        own.set = 0;
        own.steps = components * LIMIT_GUARD_STEPS;
        with.guards = &own;
    }
    Interval otherwise[MAX_COMPONENTS];
    find_arm(&with, ir, b, (Guard){value, sides[1]}, otherwise);
    find_arm(&with, ir, a, (Guard){value, sides[0]}, found);
    for (int component = 0; component < components; component++)
        found[component] = hull(found[component], otherwise[component]);
}

/* -- Operations */

/* Returns the interval of all components of an operand. */
static Interval whole(const Ranges *r, const Ir *ir, Ref ref)
{
    Interval all = range_of(r, ir, ref, 0);
    for (int component = 1; r->components > 1 && component < ir_components(ir, ref); component++)
        all = hull(all, range_of(r, ir, ref, component));
    return all;
}

/* Returns the interval of a function by its table row, for any arguments. */
static Interval table_range(int function)
{
    switch (function) {
#define ANY              -INFINITY, INFINITY
#define RANGE(low, high) low, high
#define FUNCTION(name, result, arguments, range, cost, doc)                                        \
    case FN_##name:                                                                                \
        return (Interval){range};
#include "grammar/functions.def"
#undef RANGE
#undef ANY
#define BETWEEN(map, low, high)                                                                    \
    case FN_FIRST_MAP + KIND_##map:                                                                \
        return (Interval){low, high};
#include "grammar/maps.def"
    default:
        return everything;
    }
}

/* Bounds the octaves of a noise in [-1, 1] by the sum of their amplitudes. */
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

/* phongExponent rises for a shininess from 0 to 1; above 1 it falls again. */
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

/* Returns true for a call that reads an image of floats, whose values are unbounded. */
static bool reads_floats(const Ir *ir, Ref call)
{
    const Ref sampler = ir_arg(ir, call, 0);
    if (!ir_is(ir, sampler, OP_texture) || ir_at(ir, sampler)->payload >= ir->texture_count)
        return false;
    return ir->textures[ir_at(ir, sampler)->payload].floats;
}

static Interval call_range(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    const int function = (int)ir_at(ir, ref)->payload;
    (void)component;
    switch (function) {
    case FN_turbulence:
        return octaves_range(whole(r, ir, ir_arg(ir, ref, 1)), whole(r, ir, ir_arg(ir, ref, 3)));
    case FN_phongExponent:
        return exponent_range(whole(r, ir, ir_arg(ir, ref, 0)));
    case FN_imageNearest:
    case FN_imageBilinear:
    case FN_imageFiltered:
    case FN_imageSampled:
    case FN_imageCentred:
    case FN_imageSampledOver:
        return reads_floats(ir, ref) ? everything : table_range(function);
    default:
        return table_range(function);
    }
}

/* Returns the interval of a dot product: the sum over the components. With one interval for all
 * components the same term is added once per component. */
static Interval dot_range(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    const Ref a = ir_arg(ir, ref, 0), b = ir_arg(ir, ref, 1);
    Interval all = {0, 0};
    (void)component;
    for (int i = 0; i < ir_components(ir, a); i++) {
        Interval x = range_of(r, ir, a, i), y = range_of(r, ir, b, i);
        all = sum(all, a == b ? square(x) : times(x, y));
    }
    return all;
}

/* Returns the interval of a cross product's component: a_j b_k - a_k b_j with the other two
 * components. */
static Interval cross_range(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    const Ref a = ir_arg(ir, ref, 0), b = ir_arg(ir, ref, 1);
    const int j = (component + 1) % 3, k = (component + 2) % 3;
    const Interval left = times(range_of(r, ir, a, j), range_of(r, ir, b, k));
    return sum(left, negative(times(range_of(r, ir, a, k), range_of(r, ir, b, j))));
}

static Interval length_range(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    const Ref a = ir_arg(ir, ref, 0);
    double squares = 0;
    (void)component;
    for (int i = 0; i < ir_components(ir, a); i++)
        squares += square(range_of(r, ir, a, i)).high;
    return loose((Interval){0, sqrt(squares)});
}

/* Returns the interval of one component of a matrix times a vector, given by columns. */
static Interval linear_range(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    Interval all = {0, 0};
    for (int i = 1; i < ir_at(ir, ref)->count; i++)
        all = sum(all, times(range_of(r, ir, ir_arg(ir, ref, 0), i - 1),
                             range_of(r, ir, ir_arg(ir, ref, i), component)));
    return all;
}

/* Returns the interval of a vector's component: that of its part; the union of all parts if a
 * single interval is stored. */
static Interval vec_range(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    Interval all = range_of(r, ir, ir_arg(ir, ref, 0), 0);
    for (int i = 0, first = 0; i < ir_at(ir, ref)->count; i++) {
        const Ref part = ir_arg(ir, ref, i);
        const int components = ir_components(ir, part);
        if (r->components == 1)
            all = hull(all, range_of(r, ir, part, 0));
        else if (component >= first && component < first + components)
            return range_of(r, ir, part, component - first);
        first += components;
    }
    return all;
}

static Interval const_range(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    if (ir_type(ir, ref) == TYPE_sampler)
        return everything;
    const double *at = ir_numbers(ir, ref);
    Interval range = between(at[component], at[component]);
    for (int i = 1; r->components == 1 && i < ir_components(ir, ref); i++)
        range = hull(range, between(at[i], at[i]));
    return range;
}

static Interval swizzle_range(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    return range_of(r, ir, ir_arg(ir, ref, 0), (int)(ir_at(ir, ref)->payload >> 2 * component & 3));
}

static Interval apply_range(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    return range_of(r, ir, ir->functions[ir_at(ir, ref)->payload].result, component);
}

static Interval kernel_range(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    return times(apply_range(r, ir, ref, component), between(KERNEL_POINTS, KERNEL_POINTS));
}

/* Returns the interval of an operand; unbounded if the operand is missing. */
static inline Interval operand_range(const Ranges *r, const Ir *ir, const IrNode *node, int i,
                                     int component)
{
    return i < node->count ? range_of(r, ir, ir->args[node->first + (uint32_t)i], component)
                           : everything;
}

/* Returns the interval of an operation that works per component, by the RANGE lines of ops.def. */
static Interval component_range(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    const IrNode *node = ir_at(ir, ref);
    const bool squared = node->count == 2 && ir_arg(ir, ref, 0) == ir_arg(ir, ref, 1);
    const Interval a = operand_range(r, ir, node, 0, component),
                   b = operand_range(r, ir, node, 1, component),
                   c = operand_range(r, ir, node, 2, component);
    switch (node->op) {
#define RANGE(name, interval)                                                                      \
    case OP_##name:                                                                                \
        return interval;
#include "grammar/ops.def"
    default:
        return everything;
    }
}

Interval range_computed(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    switch (ir_at(ir, ref)->op) {
#define RANGE_NODE(name, function)                                                                 \
    case OP_##name:                                                                                \
        return function(r, ir, ref, component);
#include "grammar/ops.def"
    default:
        return component_range(r, ir, ref, component);
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
