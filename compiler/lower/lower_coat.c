/* A clear coat over a surface, as in OpenPBR 1.1: the slots of the coat, and the changes to the
 * slots below it, which belong to a Principled or to a Layer's base.
 *
 *     w = coat in [0, 1], c = coatIor, base of index n and roughness r
 *     coatTint = mix(1, coatColor, w) mix(1, (1 - K) / (1 - diffuse K), w coatDarkening), K = 1
 *     - (1 - F0(c)) / c^2: the base absorbs part of the light that the coat's inner side
 *     reflects back repeatedly
 *     roughness = mix(r, min(max(r, 0)^4 + 2 coatRoughness^4, 1)^(1/4), w coatRoughening)
 *     reflectance = F0(mix(n, n / c or c / n, whichever is above 1, w)), F0(x) = ((x - 1) / (x +
 *     1))^2: the base borders on the coat, not on air
 *
 * Worked example, w 1, c 1.6 and n 1.5: the base reflects F0(1.067) = 0.001 instead of 0.04
 * without a coat, the coat 0.053; K is 0.63, so that a base of 0.5 is tinted by 0.54. */
#include "compiler/lower/lower.h"

static const double LEAST = 1e-6; /* minimum divisor */

static Ref red(Lower *l, const Node *m, int param, const Env *env)
{
    return build_swizzle(l->ir, lower_query(l, lower_param_node(m, param), GROUP_R, env), "x");
}

static Ref unit(Ir *ir, Ref x)
{
    return build_clamp(ir, x, build_float(ir, 0), build_float(ir, 1));
}

Ref lower_reflectance(Ir *ir, Ref ior)
{
    Ref one = build_float(ir, 1);
    Ref less = build_sub(ir, ior, one), more = build_add(ir, ior, one);
    return build_square(ir, build_div(ir, less, more));
}

static Ref weight(Lower *l, const Coat *coat, const Env *env)
{
    return unit(l->ir, red(l, coat->of, coat->weight, env));
}

/* Returns the coat's index of refraction, clamped to 0, since an index of -1 would divide by 0. */
static Ref coat_ior(Lower *l, const Coat *coat, const Env *env)
{
    return build_max(l->ir, red(l, coat->of, coat->ior, env), build_float(l->ir, 0));
}

/* Returns the coat's color by its weight, white where the weight is 0. */
static Ref colored(Lower *l, const Coat *coat, const Env *env)
{
    Ir *ir = l->ir;
    Ref color = build_convert(
        ir, lower_query(l, lower_param_node(coat->of, coat->color), GROUP_R, env), TYPE_vec3);
    return build_mix(ir, build_all(ir, TYPE_vec3, 1), color, weight(l, coat, env));
}

/* Returns K, the share of the light from below that the coat's inner side reflects back. */
static Ref sent_back(Lower *l, const Coat *coat, const Env *env)
{
    Ir *ir = l->ir;
    Ref ior = coat_ior(l, coat, env), one = build_float(ir, 1), least = build_float(ir, LEAST);
    Ref through = build_sub(ir, one, lower_reflectance(ir, ior));
    return unit(ir, build_sub(ir, one,
                              build_div(ir, through, build_max(ir, build_square(ir, ior), least))));
}

static Ref tint(Lower *l, const Coat *coat, Ref diffuse, const Env *env)
{
    Ir *ir = l->ir;
    Ref back = sent_back(l, coat, env), one = build_float(ir, 1),
        white = build_all(ir, TYPE_vec3, 1);
    Ref base = build_clamp(ir, diffuse, build_all(ir, TYPE_vec3, 0), white);
    Ref rest = build_max(ir, build_sub(ir, white, build_mul(ir, base, back)),
                         build_all(ir, TYPE_vec3, LEAST));
    Ref dark = build_div(ir, build_splat(ir, build_sub(ir, one, back), TYPE_vec3), rest);
    Ref by = build_mul(ir, weight(l, coat, env), red(l, coat->of, coat->darkening, env));
    return build_mul(ir, colored(l, coat, env), build_mix(ir, white, dark, unit(ir, by)));
}

Ref lower_coat_slot(Lower *l, const Coat *coat, Slot slot, Ref diffuse, const Env *env)
{
    Ir *ir = l->ir;
    Ref there = weight(l, coat, env);
    switch (slot) {
    case SLOT_coat:
        return there;
    case SLOT_coatTint:
        return ir_is_number(ir, there, 0) ? build_all(ir, TYPE_vec3, 1)
                                          : tint(l, coat, diffuse, env);
    case SLOT_coatRoughness:
        return lower_where_there(ir, there, slot, red(l, coat->of, coat->roughness, env));
    default:
        return lower_where_there(ir, there, slot, lower_reflectance(ir, coat_ior(l, coat, env)));
    }
}

Ref lower_coat_normal(Lower *l, const Coat *coat, const Env *env)
{
    Ir *ir = l->ir;
    Ref there = weight(l, coat, env);
    if (graph_coat_follows(l->graph, coat->of) || ir_is_number(ir, there, 0))
        return build_all(ir, TYPE_vec3, 0);
    Ref own = lower_query(l, lower_param_node(coat->of, coat->normal), GROUP_N, env);
    return lower_where_there(ir, there, SLOT_coatNormal, build_call(ir, FN_safeNormalize, own));
}

Ref lower_where_there(Ir *ir, Ref weight, Slot slot, Ref value)
{
    Ref absent = build_all(ir, slot_table[slot].type, slot_table[slot].absent);
    return build_select(ir, build_lt(ir, build_float(ir, 0), weight), value, absent);
}

Ref lower_coated_roughness(Lower *l, const Coat *coat, Ref roughness, const Env *env)
{
    Ir *ir = l->ir;
    Ref by = unit(ir, build_mul(ir, weight(l, coat, env), red(l, coat->of, coat->roughening, env)));
    Ref own = red(l, coat->of, coat->roughness, env);
    if (ir_is_number(ir, by, 0))
        return roughness;
    if (ir_is_number(ir, own, 0)) /* clamps a roughness outside [0, 1] */
        return build_mix(ir, roughness, unit(ir, roughness), by);
    Ref rough = build_max(ir, roughness, build_float(ir, 0));
    Ref below = build_square(ir, build_square(ir, rough)),
        above = build_square(ir, build_square(ir, own));
    Ref sum = build_min(ir, build_add(ir, below, build_scale(ir, above, 2)), build_float(ir, 1));
    return build_mix(ir, roughness, build_sqrt(ir, build_sqrt(ir, sum)), by);
}

Ref lower_coated_reflectance(Lower *l, const Coat *coat, Ref ior, const Env *env)
{
    Ir *ir = l->ir;
    Ref there = weight(l, coat, env), own = coat_ior(l, coat, env);
    if (ir_is_number(ir, there, 0))
        return lower_reflectance(ir, ior);
    Ref high = build_max(ir, ior, own),
        low = build_max(ir, build_min(ir, ior, own), build_float(ir, LEAST));
    return lower_reflectance(ir, build_mix(ir, ior, build_div(ir, high, low), there));
}

Ref lower_coated_emission(Lower *l, const Coat *coat, Ref sent, const Env *env)
{
    return ir_is_number(l->ir, weight(l, coat, env), 0)
               ? sent
               : build_mul(l->ir, sent, colored(l, coat, env));
}

Ref lower_coated_film(Lower *l, const Coat *coat, Ref ior, const Env *env)
{
    Ir *ir = l->ir;
    Ref there = weight(l, coat, env);
    if (ir_is_number(ir, there, 0))
        return ior;
    Ref above = build_mix(ir, build_float(ir, 1), coat_ior(l, coat, env), there);
    return lower_film_ior(ir, build_div(ir, ior, build_max(ir, above, build_float(ir, LEAST))));
}

Ref lower_film_ior(Ir *ir, Ref ior)
{
    return build_clamp(ir, ior, build_float(ir, slot_table[SLOT_filmIor].low),
                       build_float(ir, slot_table[SLOT_filmIor].high));
}

/* Returns the index of refraction, relative to air, that has this reflectance at normal
 * incidence. */
static Ref ior_of(Ir *ir, Ref reflectance)
{
    Ref root = build_sqrt(ir, unit(ir, reflectance)), one = build_float(ir, 1);
    return build_div(ir, build_add(ir, one, root),
                     build_max(ir, build_sub(ir, one, root), build_float(ir, LEAST)));
}

/* Returns a slot of a Layer's base, changed by the coat above. */
static Ref below(Lower *l, const Coat *coat, Slot slot, Ref base, const Env *env)
{
    switch (slot) {
    case SLOT_emissive:
        return lower_coated_emission(l, coat, base, env);
    case SLOT_roughness:
        return lower_coated_roughness(l, coat, base, env);
    case SLOT_reflectance:
        return ir_is_number(l->ir, weight(l, coat, env), 0)
                   ? base
                   : lower_coated_reflectance(l, coat, ior_of(l->ir, base), env);
    default:
        return base;
    }
}

Ref lower_Layer(Lower *l, const Node *m, Slot slot, const Env *env)
{
    Ir *ir = l->ir;
    const Coat coat = COAT_OF(m, Layer);
    const Node *side = lower_param_node(m, P_Layer_base);
    const bool own = slot == SLOT_coat || slot == SLOT_coatTint || slot == SLOT_coatRoughness ||
                     slot == SLOT_coatReflectance;
    const Ref base =
        build_convert(ir, lower_value_slot(l, side, true, slot, env), slot_table[slot].type);
    if (slot == SLOT_filmIor) {
        const Ref film = lower_value_slot(l, side, true, SLOT_film, env);
        return ir_is_number(ir, film, 0)
                   ? base
                   : lower_where_there(ir, film, slot, lower_coated_film(l, &coat, base, env));
    }
    if (slot == SLOT_coatNormal) /* the base's own coat shows where this coat has no weight */
        return build_select(ir, build_lt(ir, build_float(ir, 0), weight(l, &coat, env)),
                            lower_coat_normal(l, &coat, env), base);
    if (!own)
        return below(l, &coat, slot, base, env);
    const Ref diffuse =
        build_convert(ir, lower_value_slot(l, side, true, SLOT_diffuse, env), TYPE_vec3);
    const Ref laid =
        build_convert(ir, lower_coat_slot(l, &coat, slot, diffuse, env), slot_table[slot].type);
    return build_select(ir, build_lt(ir, build_float(ir, 0), weight(l, &coat, env)), laid, base);
}
