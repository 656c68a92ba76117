/* Blends by weights: the share of every item in a pixel's box of t, or at a point.
 *
 *     items at 0, .3 and 1 with values a, b, c; the pixel's t is in [.25, .45]. On average 47 /
 *     48 of the step from a to b has been passed, and 9 / 112 of that from b to c:
 *     area:    a + (b - a) 47 / 48 + (c - b) 9 / 112
 *     weights: a (1 - 47 / 48) + b (47 / 48 - 9 / 112) + c 9 / 112, which loses no small item
 *     next to a great one
 *     guards:  as weights, with a costly c as w != 0 ? c : 0 for its weight w. With t in [.1,
 *     .2] that is 0 */
#include "compiler/lower/blend.h"
#include "compiler/lower/area.h"
#include <math.h>
#include <string.h>

enum {
    ALIKE = 16,      /* maximum ratio of the greatest to the least of alike items */
    KNOWN_DEPTH = 6, /* depth of operations searched for a value's bounds */
};

Ref blend_position(Lower *l, Ref t, Ref low, Ref high)
{
    Ir *ir = l->ir;
    const double *from = ir_known(ir, low), *to = ir_known(ir, high);
    Ref along = build_sub(ir, t, low);
    if (from && to)
        return build_mul(ir, along, area_known_inverse(l, low, high));
    Ref width = build_sub(ir, high, low);
    Ref flat = build_eq(ir, width, build_float(ir, 0));
    return build_div(ir, along, build_select(ir, flat, build_float(ir, 1), width));
}

/* Makes the guard, which gets the name of the guarded value. */
Ref blend_guarded(Lower *l, Ref shown, Ref value)
{
    Ir *ir = l->ir;
    Ref guard = build_guard(ir, shown, value);
    ir->nodes[guard].origin = ir->nodes[value].origin;
    ir_set_head(ir, guard, ir_is_head(ir, value));
    return guard;
}

bool blend_is_costly(const Ir *ir, Ref result)
{
    return lower_cost_below(ir, result, BLEND_CHEAP) >= BLEND_CHEAP;
}

/* Returns the index of the first operand that, with all that follow, must be in [0, 1] for the
 * result to be in [0, 1] (UNIT lines of ops.def). -1: the result may be anything. */
static int first_in_unit(Op op)
{
    switch (op) {
#define UNIT(name, first)                                                                          \
    case OP_##name:                                                                                \
        return first;
#include "grammar/ops.def"
    default:
        return -1;
    }
}

/* Returns true if every component of a value is surely in [0, 1]. */
static bool within_unit(const Ir *ir, Ref ref, int depth)
{
    const IrNode *node = ir_at(ir, ref);
    const double *known = ir_known(ir, ref);
    const int first = first_in_unit((Op)node->op);
    for (int i = 0; known && i < ir_components(ir, ref); i++)
        if (!(known[i] >= 0 && known[i] <= 1))
            return false;
    if (known || first < 0)
        return known != NULL;
    for (int i = first; i < node->count; i++)
        if (!depth || !within_unit(ir, ir_arg(ir, ref, i), depth - 1))
            return false;
    return true;
}

/* Returns true for constants whose magnitudes differ by a factor of at most ALIKE. */
static bool alike_constants(const Ir *ir, const Stop *stops, int count)
{
    double least = INFINITY, greatest = 0;
    for (int i = 0; i < count; i++) {
        if (!ir_known(ir, stops[i].result))
            return false;
        for (int component = 0; component < ir_components(ir, stops[i].result); component++) {
            double size = fabs(ir_known(ir, stops[i].result)[component]);
            least = fmin(least, size);
            greatest = fmax(greatest, size);
        }
    }
    return greatest <= ALIKE * least;
}

/* Drivers compute mix(a, b, t) as a + t (b - a), which errs by a rounding of the greater one: a
 * small item would be lost next to a great one. */
bool blend_alike(const Ir *ir, const Stop *stops, int count)
{
    bool unit = true;
    for (int i = 0; unit && i < count; i++)
        unit = within_unit(ir, stops[i].result, KNOWN_DEPTH);
    return unit || alike_constants(ir, stops, count);
}

/* Items first..last of `count`. */
typedef struct {
    const Stop *stops;
    int count, first, last;
} Run;

/* Returns the condition under which the items first..last show: above the value before them and
 * below the one after; `closed`: also exactly there. 0: everywhere. */
static Ref where_shown(Lower *l, Ref t, Run s, bool closed)
{
    Ir *ir = l->ir;
    const Op less = closed ? OP_le : OP_lt;
    Ref above = 0, below = 0;
    if (s.first > 0)
        above = build_binary(ir, less, s.stops[s.first - 1].value, t);
    if (s.last < s.count - 1)
        below = build_binary(ir, less, t, s.stops[s.last + 1].value);
    return above && below ? build_and(ir, above, below) : above ? above : below;
}

/* Returns the condition under which any item with the value of item s.first shows; s.first is
 * the first such item. 0: everywhere. */
static Ref where_result(Lower *l, Ref t, Run s, bool closed)
{
    const Ref result = s.stops[s.first].result;
    Ref shown = 0;
    for (int i = s.first; i < s.count; i++) {
        if (s.stops[i].result != result)
            continue;
        const int first = i;
        while (i + 1 < s.count && s.stops[i + 1].result == result)
            i++;
        Ref here = where_shown(l, t, (Run){s.stops, s.count, first, i}, closed);
        if (!here)
            return 0;
        shown = shown ? build_or(l->ir, shown, here) : here;
    }
    return shown;
}

const Stop *blend_guarded_items(Lower *l, Ref t, const Stop *stops, int count, bool closed)
{
    Stop *own = NULL;
    for (int i = 0; i < count; i++) {
        const Ref result = stops[i].result;
        if (!blend_is_costly(l->ir, result) || (own && own[i].result != result))
            continue;
        Ref shown = where_result(l, t, (Run){stops, count, i, count}, closed);
        if (!shown)
            continue;
        own = own ? own
                  : memcpy(ARENA_ARRAY(l->session->arena, Stop, count), stops,
                           sizeof *stops * (size_t)count);
        Ref guard = blend_guarded(l, shown, result);
        for (int k = i; k < count; k++)
            if (stops[k].result == result)
                own[k].result = guard;
    }
    return own ? own : stops;
}

Ref blend_share(Lower *l, Ref t, const Stop *stop)
{
    Ref at = blend_position(l, t, stop[0].value, stop[1].value);
    return build_clamp(l->ir, at, build_float(l->ir, 0), build_float(l->ir, 1));
}

/* Returns the share of the step from a stop to the next that a box of t has passed; edge 0: a
 * point. */
static Ref step_share(Lower *l, Ref t, Ref edge, const Stop *stop)
{
    return edge ? area_ramp(l, t, edge, stop[0].value, stop[1].value) : blend_share(l, t, stop);
}

/* Returns the mean over a box of t: every step from one item to the next counts by the share of
 * it that the box has passed. */
static Ref blend_area(Lower *l, Ref t, Ref edge, const Stop *stops, int count)
{
    Ir *ir = l->ir;
    Ref result = stops[0].result;
    for (int i = 1; i < count; i++) {
        Ref share = step_share(l, t, edge, &stops[i - 1]);
        result = build_add(
            ir, result, build_mul(ir, build_sub(ir, stops[i].result, stops[i - 1].result), share));
    }
    return result;
}

/* Returns the share of the box, or of the point, that has reached each item: all for the first,
 * 0 after the last. */
static Ref *shares(Lower *l, Ref t, Ref edge, const Stop *stops, int count)
{
    Ref *share = ARENA_ARRAY(l->session->arena, Ref, count + 1);
    share[0] = build_float(l->ir, 1);
    for (int i = 1; i < count; i++)
        share[i] = step_share(l, t, edge, &stops[i - 1]);
    share[count] = build_float(l->ir, 0);
    return share;
}

/* Returns the weight of each item in the box: exactly 0 where the box does not reach the item. */
static Ref *weights(Lower *l, Ref t, Ref edge, const Stop *stops, int count)
{
    Ref *weight = shares(l, t, edge, stops, count);
    for (int i = 0; i + 1 < count; i++)
        weight[i] = build_sub(l->ir, weight[i], weight[i + 1]);
    return weight;
}

static bool has_costly(const Ir *ir, const Stop *stops, int count)
{
    for (int i = 0; i < count; i++)
        if (blend_is_costly(ir, stops[i].result))
            return true;
    return false;
}

/* Returns the total weight of all items that have the value of item i, if i is the first of
 * them; otherwise 0. Adjacent items form one run, so that items that cover everything weigh
 * exactly 1. */
static Ref weight_of_result(Lower *l, const Ref *share, const Stop *stops, int count, int i)
{
    const Ref result = stops[i].result;
    Ref sum = 0;
    for (int k = 0; k < i; k++)
        if (stops[k].result == result)
            return 0;
    for (int end; i < count; i = end + 1) {
        for (end = i; end < count && stops[end].result == result;)
            end++;
        if (end > i)
            sum = build_plus(l->ir, sum, build_sub(l->ir, share[i], share[end]));
    }
    return sum;
}

/* Returns the mean over a box of t, with costly items behind guards: where an item's weight is 0
 * it is not computed. The condition is the weight itself, after rounding. */
static Ref blend_guarded_area(Lower *l, Ref t, Ref edge, const Stop *stops, int count)
{
    Ir *ir = l->ir;
    const Ref *share = shares(l, t, edge, stops, count);
    Ref result = 0;
    for (int i = 0; i < count; i++) {
        Ref weight = weight_of_result(l, share, stops, count, i), value = stops[i].result;
        if (!weight)
            continue;
        if (blend_is_costly(ir, value) && !ir_is(ir, weight, OP_const))
            value = blend_guarded(l, build_ne(ir, weight, build_float(ir, 0)), value);
        result = build_plus(ir, result, build_mul(ir, value, weight));
    }
    return result;
}

/* Returns the weighted sum, for items that are not alike. */
Ref blend_weights(Lower *l, Ref t, Ref edge, const Stop *stops, int count)
{
    Ir *ir = l->ir;
    const Ref *weight = weights(l, t, edge, stops, count);
    Ref result = build_mul(ir, stops[0].result, weight[0]);
    for (int i = 1; i < count; i++)
        result = build_add(ir, result, build_mul(ir, stops[i].result, weight[i]));
    return result;
}

Ref blend_variance(Lower *l, Ref t, Ref edge, const Stop *stops, int count)
{
    Ir *ir = l->ir;
    Ref variance = 0, *weight = NULL;
    for (int i = 0; i < count; i++) {
        if (!stops[i].variance)
            continue;
        weight = weight ? weight : weights(l, t, edge ? edge : build_float(ir, 0), stops, count);
        Ref term = build_mul(ir, stops[i].variance, build_square(ir, weight[i]));
        variance = build_plus(ir, variance, term);
    }
    return variance;
}

Ref blend_over(Lower *l, Ref t, Ref edge, const Stop *stops, int count)
{
    if (l->cheap && count <= BLEND_MAX_MIXES && has_costly(l->ir, stops, count))
        return blend_guarded_area(l, t, edge, stops, count);
    return blend_alike(l->ir, stops, count) ? blend_area(l, t, edge, stops, count)
                                            : blend_weights(l, t, edge, stops, count);
}
