/* Blend: piecewise linear interpolation between items of ascending value.
 *
 *     items at 0, .3 and 1 with values a, b, c, and t = .65: the first item above t is the
 *     third, at (.65 - .3) / (1 - .3) = 1/2 of the segment that begins at the second: (b + c) /
 *     2. Below 0 the result is a, from 1 on c.
 *     walk:    t < 0 ? a : t < .3 ? mix(a, b, ..) : t < 1 ? mix(b, c, ..) : c
 *     search:  t < .3 ? (t < 0 ? a : mix(a, b, ..)) : (t < 1 ? mix(b, c, ..) : c)
 *     mixes:   mix(mix(a, b, clamp(t / .3)), c, clamp((t - .3) / .7))
 *     guards:  a costly b shows between 0 and 1 only: it becomes 0 < t && t < 1 ? b : 0, and
 *     mixing it needs no branch
 *     weights: a (1 - clamp(t / .3)) + b (clamp(t / .3) - clamp((t - .3) / .7)) + ..., for
 *     guards whose values may be of any size
 * Means over a pixel's box of t: blend.c. Slopes of the last three forms: blend_slope.c.
 * Ramps are Blends of two items, at 0 and at 1. A Switch over a box has two items at every
 * border between maps, one for the map below and one for the map above:
 *
 *     maps a, b, c: items a and b at 1/2, b and c at 3/2. A pixel whose number is in [1, 2] is
 *     (b + c) / 2 */
#include "compiler/lower/blend.h"
#include "compiler/lower/map_value.h"
#include "compiler/lower/footprint.h"
#include <string.h>

enum { MAX_AREA_ITEMS = 64 }; /* items up to which a Blend is averaged over the pixel */

/* Segments first..last of a Blend: segment i ends at item i, and segment `count` is the constant
 * after the last item. */
typedef struct {
    const Stop *stops;
    int count, first, last;
} Segments;

/* Returns the value within segment i: t is below item i's value and not below the previous
 * item's. */
static Ref segment(Lower *l, Ref t, const Stop *stops, int i)
{
    if (i == 0)
        return stops[0].result;
    Ref at = blend_position(l, t, stops[i - 1].value, stops[i].value);
    return build_mix(l->ir, stops[i - 1].result, stops[i].result, at);
}

/* Returns true for known values that ascend; `strictly`: no two are equal as floats. */
static bool ascending(const Ir *ir, const Stop *stops, int count, bool strictly)
{
    for (int i = 0; i < count; i++) {
        const double *now = ir_known(ir, stops[i].value),
                     *before = i ? ir_known(ir, stops[i - 1].value) : NULL;
        if (!now ||
            (before && (now[0] < before[0] || (strictly && (float)now[0] <= (float)before[0]))))
            return false;
    }
    return true;
}

/* Returns the condition that t has not reached item i of `count`. The last segment includes its
 * end, where the value is the last item's but the slope is the segment's: a wave that rises to 1
 * and falls again is 1 for many floats around its peak, and at all but one of them it still
 * rises or falls. */
static Ref is_below(Lower *l, Ref t, const Stop *stops, int i, int count)
{
    Ir *ir = l->ir;
    const bool closed = i > 0 && i == count - 1 && ascending(ir, &stops[i - 1], 2, true);
    return closed ? build_le(ir, t, stops[i].value) : build_lt(ir, t, stops[i].value);
}

/* Lowers the Blend as written: the first item whose value is above t decides. */
static Ref blend_walk(Lower *l, Ref t, const Stop *stops, int count)
{
    Ir *ir = l->ir;
    Ref result = stops[count - 1].result;
    for (int i = count - 1; i >= 0; i--) {
        Ref below = is_below(l, t, stops, i, count);
        result = build_select(ir, below, segment(l, t, stops, i), result);
    }
    return result;
}

/* Finds the segment by binary search, for stops that are known to ascend. */
static Ref blend_search(Lower *l, Ref t, Segments s)
{
    Ir *ir = l->ir;
    if (s.first == s.last)
        return s.first == s.count ? s.stops[s.count - 1].result : segment(l, t, s.stops, s.first);
    const int middle = s.first + (s.last - s.first) / 2;
    Ref below = is_below(l, t, s.stops, middle, s.count);
    Ref low = blend_search(l, t, (Segments){s.stops, s.count, s.first, middle});
    return build_select(ir, below, low,
                        blend_search(l, t, (Segments){s.stops, s.count, middle + 1, s.last}));
}

/* Lowers the Blend without branches, for values known to ascend: each item is mixed over the
 * result of the items before it. The weight is 1 where t has passed a segment, 0 where t has not
 * reached it. */
static Ref blend_mixes(Lower *l, Ref t, const Stop *stops, int count)
{
    Ir *ir = l->ir;
    Ref result = stops[0].result;
    for (int i = 1; i < count; i++) {
        if (stops[i].result == stops[i - 1].result)
            continue; /* the result already has this value */
        result = build_mix(ir, result, stops[i].result, blend_share(l, t, &stops[i - 1]));
    }
    return result;
}

static bool cheap_arms(const Ir *ir, const Stop *stops, int count)
{
    int cost = 0;
    for (int i = 0; i < count && cost < BLEND_CHEAP; i++)
        cost += lower_cost_below(ir, stops[i].result, BLEND_CHEAP - cost);
    return cost < BLEND_CHEAP;
}

/* Returns the sum, and records its slopes. If the same node is another Blend already, returns
 * the binary search instead. */
static Ref noted(Lower *l, Ref sum, const Blended *blend)
{
    return blend_note(l, sum, blend)
               ? sum
               : blend_search(l, blend->t, (Segments){blend->stops, blend->count, 0, blend->count});
}

/* Returns the value at a point of t. */
static Ref blend_point(Lower *l, Ref t, const Stop *stops, int count)
{
    const bool ordered = ascending(l->ir, stops, count, true);
    if (l->cheap && ordered && count <= BLEND_MAX_MIXES && cheap_arms(l->ir, stops, count) &&
        blend_alike(l->ir, stops, count))
        return noted(l, blend_mixes(l, t, stops, count), &(Blended){t, stops, stops, count});
    if (ordered && (l->cheap || count > LIMIT_WALK))
        return blend_search(l, t, (Segments){stops, count, 0, count});
    return blend_walk(l, t, stops, count);
}

/* Mixes with each costly item behind a guard, which needs no further branch; 0: no item is
 * costly, or a binary search follows, which has branches already. */
static Ref blend_guards(Lower *l, Ref t, const Stop *stops, int count)
{
    if (!l->cheap || count > BLEND_MAX_MIXES || !ascending(l->ir, stops, count, true))
        return 0;
    const Stop *own = blend_guarded_items(l, t, stops, count, false);
    if (own == stops)
        return 0;
    Ref sum = blend_alike(l->ir, own, count) ? blend_mixes(l, t, own, count)
                                             : blend_weights(l, t, 0, own, count);
    return noted(l, sum, &(Blended){t, stops, own, count});
}

static MapValue blend_components(Lower *l, MapValue t, const Stop *stops, int count)
{
    if (count > MAX_AREA_ITEMS || !ascending(l->ir, stops, count, false))
        return map_value_of(blend_point(l, t.value, stops, count));
    Ref edge = footprint_edges(l, t);
    Ref sum =
        edge ? blend_over(l, t.value, edge, stops, count) : blend_guards(l, t.value, stops, count);
    MapValue blend = map_value_of(sum ? sum : blend_point(l, t.value, stops, count));
    blend.variance = blend_variance(l, t.value, edge, stops, count);
    return blend;
}

/* Returns the constant alpha that all items have; 0: the alpha differs between items, or is not
 * constant. */
static Ref common_alpha(Lower *l, const Stop *stops, int count)
{
    Ref alpha = 0;
    for (int i = 0; i < count; i++) {
        Ref own = map_value_alpha(l, stops[i].result);
        if (!own || (alpha && own != alpha))
            return 0;
        alpha = own;
    }
    return alpha;
}

/* Blends colors; an alpha that all items have is kept as it is, so that opaque items stay
 * opaque. */
static MapValue blend_at(Lower *l, MapValue t, const Stop *stops, int count)
{
    Ir *ir = l->ir;
    Ref alpha = common_alpha(l, stops, count);
    if (!alpha)
        return blend_components(l, t, stops, count);
    Stop *color = ARENA_ARRAY(l->session->arena, Stop, count);
    for (int i = 0; i < count; i++) {
        Ref result = build_swizzle(ir, stops[i].result, "xyz");
        Ref variance = stops[i].variance ? build_swizzle(ir, stops[i].variance, "xyz") : 0;
        color[i] = (Stop){stops[i].value, result, variance};
    }
    MapValue blend = blend_components(l, t, color, count);
    MapValue whole = map_value_of(build_vec(ir, TYPE_vec4, blend.value, alpha));
    if (blend.variance)
        whole.variance = build_vec(ir, TYPE_vec4, blend.variance, build_float(ir, 0));
    return whole;
}

/* Blends along a coordinate. If the coordinate is one of two values within the pixel, returns
 * the mean of both blends, since a Blend is not linear. */
static MapValue blend_split(Lower *l, MapValue x, const Stop *stops, int count, int depth)
{
    if (!x.split || depth == 0)
        return blend_at(l, map_value_swizzle(l, x, "x"), stops, count);
    MapValue a = blend_split(l, x.split->a, stops, count, depth - 1);
    MapValue b = blend_split(l, x.split->b, stops, count, depth - 1);
    return map_value_either(l, x.split->by, a, b);
}

/* Returns the items, converted to one type. */
static Stop *stops_of(Lower *l, const Value *blend, Group group, const Env *env)
{
    const int count = blend->items->count;
    Stop *stops = ARENA_ARRAY(l->session->arena, Stop, count);
    MapValue *answers = ARENA_ARRAY(l->session->arena, MapValue, count);
    Type type = TYPE_float;
    for (int i = 0; i < count; i++) {
        const Item *item = &blend->items->item[i];
        stops[i].value = lower_param(l, &item->value, TYPE_float);
        answers[i] = lower_arm(l, item->input, group, env);
        Type own = ir_type(l->ir, answers[i].value);
        type = i ? map_value_common_type(type, own) : own;
    }
    for (int i = 0; i < count; i++) {
        MapValue wide = map_value_widened(l, answers[i], type);
        stops[i].result = wide.value;
        stops[i].variance = wide.variance;
    }
    return stops;
}

MapValue lower_Blend(Lower *l, const Node *node, Group group, const Env *env)
{
    Ir *ir = l->ir;
    const Value *blend = node_param(node, P_Blend_blend);
    const Node *input = lower_param_node(node, P_Blend_input);
    int count = blend->kind == VALUE_items ? blend->items->count : 0;
    if (!count || l->failed)
        return lower_map_value(l, input, group, env);
    MapValue x = lower_map_value(l, input, GROUP_X, env);
    /* recorded before the items are lowered */
    lower_note_crossing(l, node, build_swizzle(ir, x.value, "x"));
    const Stop *stops = stops_of(l, blend, group, env);
    if (count > LIMIT_WALK && !ascending(ir, stops, count, true)) {
        diag_add(l->session, blend->span, DIAG_long_walk, LIMIT_WALK);
        l->failed = true;
        return map_value_of(stops[0].result);
    }
    MapValue answer = blend_split(l, x, stops, count, MAX_SPLITS);
    /* A Blend in a displacement is no split value any more: a Blend along it uses its slope. */
    if (l->relief)
        answer.split = NULL;
    return answer;
}

/* Interpolates linearly from a to b as t goes from 0 to 1. */
static MapValue ramp(Lower *l, MapValue t, MapValue a, MapValue b)
{
    const Type type = map_value_common_type(ir_type(l->ir, a.value), ir_type(l->ir, b.value));
    a = map_value_widened(l, a, type);
    b = map_value_widened(l, b, type);
    /* allocated on the arena, since slopes are queried later */
    Stop *stops = ARENA_ARRAY(l->session->arena, Stop, 2);
    stops[0] = (Stop){build_float(l->ir, 0), a.value, a.variance};
    stops[1] = (Stop){build_float(l->ir, 1), b.value, b.variance};
    return blend_at(l, t, stops, 2);
}

MapValue lower_Ramp(Lower *l, const Node *node, Group group, const Env *env)
{
    const bool along_v = node_param(node, P_Ramp_along)->number[0] == KEYWORD_Axis_v;
    MapValue t =
        map_value_swizzle(l, lower_map_value(l, lower_param_node(node, P_Ramp_input), GROUP_U, env),
                          along_v ? "y" : "x");
    MapValue a = lower_arm(l, lower_param_node(node, P_Ramp_a), group, env);
    return ramp(l, t, a, lower_arm(l, lower_param_node(node, P_Ramp_b), group, env));
}

MapValue lower_CornerRamp(Lower *l, const Node *node, Group group, const Env *env)
{
    const MapValue uvw =
        lower_map_value(l, lower_param_node(node, P_CornerRamp_input), GROUP_U, env);
    const MapValue s = map_value_swizzle(l, uvw, "x"), t = map_value_swizzle(l, uvw, "y");
    MapValue corner[4];
    for (int i = 0; i < 4; i++)
        corner[i] = lower_arm(l, lower_param_node(node, P_CornerRamp_bottomLeft + i), group, env);
    const MapValue bottom = ramp(l, s, corner[0], corner[1]),
                   top = ramp(l, s, corner[2], corner[3]);
    return ramp(l, t, bottom, top);
}

/* Maps first..last; the map nearest to `number` is chosen. */
typedef struct {
    Ref number;
    const MapValue *maps;
    int first, last;
} Choices;

/* Returns the choice at a point, by bisection. */
static MapValue chosen_of(Lower *l, Choices c)
{
    if (c.first == c.last)
        return c.maps[c.first];
    const int middle = c.first + (c.last - c.first) / 2;
    Ref below = build_lt(l->ir, c.number, build_float(l->ir, middle + .5));
    const MapValue low = chosen_of(l, (Choices){c.number, c.maps, c.first, middle});
    return map_value_either(l, below, low,
                            chosen_of(l, (Choices){c.number, c.maps, middle + 1, c.last}));
}

/* Returns the choice over a box of the number; with more maps than MAX_AREA_ITEMS allows, at
 * its center. */
static MapValue chosen_at(Lower *l, MapValue number, const MapValue *maps, int count)
{
    Ref edge = 2 * (count - 1) <= MAX_AREA_ITEMS ? footprint_edges(l, number) : 0;
    Stop *stops = ARENA_ARRAY(l->session->arena, Stop, 2 * count);
    Type type = TYPE_float;
    if (!edge || count == 1)
        return chosen_of(l, (Choices){number.value, maps, 0, count - 1});
    for (int i = 0; i < count; i++)
        type = i ? map_value_common_type(type, ir_type(l->ir, maps[i].value))
                 : ir_type(l->ir, maps[i].value);
    for (int i = 0; i < 2 * (count - 1); i++) {
        const MapValue wide = map_value_widened(l, maps[(i + 1) / 2], type);
        stops[i] = (Stop){build_float(l->ir, i / 2 + .5), wide.value, wide.variance};
    }
    return blend_at(l, number, stops, 2 * (count - 1));
}

/* Chooses by a number. If the number is one of two values within the pixel, returns the mean of
 * both choices; in a displacement the choice is made at the point. */
static MapValue chosen_split(Lower *l, MapValue x, const MapValue *maps, int count, int depth)
{
    if (!x.split || depth == 0 || l->relief)
        return chosen_at(l, map_value_swizzle(l, x, "x"), maps, count);
    const Split *split = x.split;
    const MapValue a = chosen_split(l, split->a, maps, count, depth - 1);
    const MapValue b = chosen_split(l, split->b, maps, count, depth - 1);
    return map_value_either(l, split->by, a, b);
}

MapValue lower_Switch(Lower *l, const Node *node, Group group, const Env *env)
{
    const Value *list = node_param(node, P_Switch_maps);
    const int count = list->kind == VALUE_items ? list->items->count : 0;
    if (!count || l->failed)
        return map_value_as_group(l, map_value_of(build_float(l->ir, 0)), group);
    const MapValue x = lower_map_value(l, lower_param_node(node, P_Switch_which), GROUP_R, env);
    MapValue *maps = ARENA_ARRAY(l->session->arena, MapValue, count);
    for (int i = 0; i < count; i++)
        maps[i] = lower_arm(l, list->items->item[i].input, group, env);
    MapValue answer = chosen_split(l, x, maps, count, MAX_SPLITS);
    if (l->relief)
        answer.split = NULL;
    return answer;
}
