/* MixMaterial: mixes two materials by a mask, each slot in the space in which its steps look
 * equal; a Phong mixed with a Principled is converted. */
#include "compiler/lower/map_value.h"
#include "compiler/lower/blend.h"
#include "compiler/lower/footprint.h"

enum { MAX_EXPONENT = 65504 };

/* Cached slots of mixed materials: one material may occur twice in a Mix, and in other Mixes
 * too. */
typedef struct SlotMemo {
    Ref value;
    int number; /* number of the environment */
} SlotMemo;

static SlotMemo *remembered(Lower *l, const Node *m, Slot slot)
{
    const size_t count = (size_t)l->graph->node_count * SLOT_COUNT;
    l->slots = l->slots ? l->slots : ARENA_ARRAY(l->session->arena, SlotMemo, count);
    return &l->slots[(size_t)m->index * SLOT_COUNT + (size_t)slot];
}

/* Returns a slot of a Mix's side, in the Mix's surface model. */
static Ref side_of_mix(Lower *l, const Node *mix, const Node *side, Slot slot, const Env *env)
{
    return lower_value_slot(l, side, lower_is_principled(l, mix), slot, env);
}

/* A side of a Mix, visible where `shows` is true. */
typedef struct {
    const Node *mix, *side;
    Ref shows;
} MixedSide;

/* Returns a slot of a Mix's side, converted to the slot's type. */
static Ref side_value(Lower *l, const MixedSide *of, Slot slot, const Env *env)
{
    l->arms++;
    Ref value =
        build_convert(l->ir, side_of_mix(l, of->mix, of->side, slot, env), slot_table[slot].type);
    l->arms--;
    return value;
}

/* Guards a costly value: it is not read where the other side covers everything. */
static Ref guarded_side(Lower *l, const MixedSide *of, Ref value)
{
    return l->cheap && blend_is_costly(l->ir, value) ? blend_guarded(l, of->shows, value) : value;
}

/* Converts Phong's exponent to a roughness in (0, 1], in which equal steps look equal: the
 * perceptual roughness of the Beckmann lobe of equal width. */
static Ref roughness_of(Ir *ir, Ref exponent)
{
    Ref alpha = build_div(ir, build_float(ir, 2), build_add(ir, exponent, build_float(ir, 2)));
    return build_sqrt(ir, build_sqrt(ir, alpha));
}

static Ref exponent_from(Ir *ir, Ref roughness)
{
    Ref power = build_square(ir, build_square(ir, roughness));
    Ref exponent = build_sub(ir, build_div(ir, build_float(ir, 2), power), build_float(ir, 2));
    return build_clamp(ir, exponent, build_float(ir, 0), build_float(ir, MAX_EXPONENT));
}

/* Converts both sides to the space in which they are mixed, mixes, and converts back. */
static Ref mixed(Lower *l, Slot slot, const Ref sides[2], Ref by)
{
    Ir *ir = l->ir;
    Ref a = sides[0], b = sides[1];
    switch (slot_mixing(slot)) {
    case MIXING_EXPONENT:
        a = roughness_of(ir, a);
        return exponent_from(ir, build_mix(ir, a, roughness_of(ir, b), by));
    case MIXING_DIRECTION:
        a = build_call(ir, FN_safeNormalize, a);
        b = build_call(ir, FN_safeNormalize, b);
        break;
    case MIXING_LINEAR:
        break;
    }
    return build_mix(ir, a, b, by);
}

/* Returns the weight of the second side: the mask clamped to [0, 1], separately for each part of
 * a split pixel. Half a pixel at -1 and half at 1 give 1/2. */
static Ref share_of_second(Lower *l, MapValue mask, int depth)
{
    Ir *ir = l->ir;
    const Split *split = mask.split;
    if (split && depth > 0) {
        Ref a = share_of_second(l, split->a, depth - 1),
            b = share_of_second(l, split->b, depth - 1);
        return map_value_mean(l, split->by, a, b);
    }
    Ref red = build_swizzle(ir, mask.value, "x"), zero = build_float(ir, 0),
        one = build_float(ir, 1);
    return build_clamp(ir, red, zero, one);
}

/* Mixes exponents; with a mask that is one of two values within the pixel, the mean of both
 * results. */
static Ref mixed_by(Lower *l, Slot slot, const Ref sides[2], MapValue mask, int depth)
{
    const Split *split = slot_mixing(slot) == MIXING_EXPONENT ? mask.split : NULL;
    if (split && depth > 0) {
        Ref a = mixed_by(l, slot, sides, split->a, depth - 1),
            b = mixed_by(l, slot, sides, split->b, depth - 1);
        return map_value_mean(l, split->by, a, b);
    }
    return mixed(l, slot, sides, share_of_second(l, mask, depth));
}

/* Returns the weight of the second side, multiplied by the slot that weighs this one on both
 * sides. If both are 0, the weight is t. */
static Ref weighed(Lower *l, const MixedSide sides[2], Slot by, Ref t, const Env *env)
{
    Ir *ir = l->ir;
    Ref least = build_float(ir, 1e-6), one = build_float(ir, 1);
    Ref a = side_value(l, &sides[0], by, env), b = side_value(l, &sides[1], by, env);
    if (a == b)
        return t;
    const bool alone = ir_is_number(ir, a, 0);
    const uint32_t origin = ir->origin;
    a = guarded_side(l, &sides[0], a);
    b = guarded_side(l, &sides[1], b);
    /* the origin is the Mix, whichever slot is queried first */
    ir->origin = ir_origin(ir, sides[0].mix);
    a = build_mul(ir, build_sub(ir, one, t), a);
    b = build_mul(ir, t, b);
    Ref sum = alone ? b : build_add(ir, a, b);
    Ref share = build_select(ir, build_lt(ir, least, sum),
                             alone ? one : build_div(ir, b, build_max(ir, sum, least)), t);
    lower_mark_head(ir, share, ir->origin);
    ir->origin = origin;
    return share;
}

/* Returns the Mix's share, with the Mix as its origin whichever slot is queried first. */
static Ref named_share(Lower *l, const Node *mix, MapValue mask)
{
    Ir *ir = l->ir;
    const uint32_t origin = ir->origin;
    ir->origin = ir_origin(ir, mix);
    const Ref share = share_of_second(l, mask, MAX_SPLITS);
    lower_mark_head(ir, share, ir->origin);
    ir->origin = origin;
    return share;
}

static Ref mix_of(Lower *l, const Node *m, Slot slot, const Env *env)
{
    Ir *ir = l->ir;
    const MapValue mask = lower_map_value(l, lower_param_node(m, P_MixMaterial_mask), GROUP_R, env);
    const Ref t = named_share(l, m, mask), zero = build_float(ir, 0), one = build_float(ir, 1);
    const double *known = ir_known(ir, t);
    const Node *a = lower_param_node(m, P_MixMaterial_a), *b = lower_param_node(m, P_MixMaterial_b);
    if (l->cheap && known && (*known <= 0 || *known >= 1))
        return side_of_mix(l, m, *known <= 0 ? a : b, slot, env);
    const Ref first_shows = build_lt(ir, t, one), second_shows = build_lt(ir, zero, t);
    const MixedSide sides[] = {{m, a, first_shows}, {m, b, second_shows}};
    Ref first = side_value(l, &sides[0], slot, env), second = side_value(l, &sides[1], slot, env);
    if (first == second)
        return first;
    first = guarded_side(l, &sides[0], first);
    second = guarded_side(l, &sides[1], second);
    if (slot_weight(slot) == SLOT_COUNT)
        return mixed_by(l, slot, (Ref[]){first, second}, mask, MAX_SPLITS);
    return build_mix(ir, first, second, weighed(l, sides, slot_weight(slot), t, env));
}

Ref lower_MixMaterial(Lower *l, const Node *m, Slot slot, const Env *env)
{
    const SlotMemo *found = remembered(l, m, slot);
    if (found->value && found->number == env->number)
        return found->value;
    Ref value = mix_of(l, m, slot, env);
    *remembered(l, m, slot) = (SlotMemo){value, env->number};
    return value;
}
