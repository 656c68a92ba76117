/* The material Principled: OpenPBR's parameters to slots. */
#include "compiler/lower/lower.h"

static Ref color(Lower *l, const Node *m, int param, const Env *env)
{
    return build_convert(l->ir, lower_ask(l, lower_param_node(m, param), GROUP_R, env), TYPE_vec3);
}

/* What a map says as a number: its red. */
static Ref red(Lower *l, const Node *m, int param, const Env *env)
{
    return build_swizzle(l->ir, lower_ask(l, lower_param_node(m, param), GROUP_R, env), "x");
}

/* weight ((ior - 1) / (ior + 1))^2: Fresnel's formulas along the normal. Without a bound below, -1 would divide by 0. */
static Ref reflectance(Lower *l, const Node *m, const Coat *coat, const Env *env)
{
    Ir *ir = l->ir;
    Ref ior = build_max(ir, red(l, m, P_Principled_ior, env), build_float(ir, 0));
    return build_mul(ir, lower_coated_reflectance(l, coat, ior, env), red(l, m, P_Principled_specular, env));
}

/* Of metal, `specular` is a factor on all that it reflects. */
static Ref base(Lower *l, const Node *m, const Env *env)
{
    Ir *ir = l->ir;
    Ref own = build_mul(ir, color(l, m, P_Principled_baseColor, env), red(l, m, P_Principled_baseWeight, env));
    Ref weight = red(l, m, P_Principled_specular, env), one = build_float(ir, 1);
    Ref less = build_mul(ir, red(l, m, P_Principled_metalness, env), build_sub(ir, weight, one));
    return build_mul(ir, own, build_add(ir, one, less));
}

static Ref emission(Lower *l, const Node *m, const Env *env)
{
    Ir *ir = l->ir;
    Ref sent = build_mul(ir, color(l, m, P_Principled_emissionColor, env), red(l, m, P_Principled_emission, env));
    return build_mul(ir, sent, red(l, m, P_Principled_opacity, env));
}

static Ref fuzz(Lower *l, const Node *m, Slot slot, const Env *env)
{
    Ref there = red(l, m, P_Principled_fuzz, env);
    Ref value = slot == SLOT_fuzz        ? there
                : slot == SLOT_fuzzColor ? color(l, m, P_Principled_fuzzColor, env)
                                         : red(l, m, P_Principled_fuzzRoughness, env);
    return lower_where_there(l->ir, there, slot, value);
}

Ref lower_Principled(Lower *l, const Node *m, Slot slot, const Env *env)
{
    Ir *ir = l->ir;
    const Coat coat = COAT_OF(m, Principled);
    switch (slot) {
    case SLOT_normal:
        return lower_ask(l, lower_param_node(m, P_Principled_input), GROUP_N, env);
    case SLOT_diffuse:
        return base(l, m, env);
    case SLOT_alpha:
        return red(l, m, P_Principled_opacity, env);
    case SLOT_specular:
        return color(l, m, P_Principled_specularColor, env);
    case SLOT_transparency:
        return build_convert(ir, build_sub(ir, build_float(ir, 1), red(l, m, P_Principled_opacity, env)), TYPE_vec3);
    case SLOT_emissive:
        return lower_coated_emission(l, &coat, emission(l, m, env), env);
    case SLOT_ior:
        return env->root[GROUP_IOR];
    case SLOT_metalness:
        return red(l, m, P_Principled_metalness, env);
    case SLOT_roughness:
        return lower_coated_roughness(l, &coat, red(l, m, P_Principled_roughness, env), env);
    case SLOT_reflectance:
        return reflectance(l, m, &coat, env);
    case SLOT_model:
        return build_float(ir, MODEL_Principled);
    case SLOT_coat:
    case SLOT_coatTint:
    case SLOT_coatRoughness:
    case SLOT_coatReflectance:
        return lower_coat_slot(l, &coat, slot, base(l, m, env), env);
    case SLOT_fuzz:
    case SLOT_fuzzColor:
    case SLOT_fuzzRoughness:
        return fuzz(l, m, slot, env);
    default:
        return build_all(ir, slot_table[slot].type, slot_table[slot].absent);
    }
}

/* Where a tint has no colour to be of, it is white. */
static const double LEAST_TINT = 1e-6;

Ref lower_principled_of_phong(Lower *l, Slot slot, const PhongSlots *phong)
{
    Ir *ir = l->ir;
    Ref share = build_div(ir, build_float(ir, 2), build_add(ir, phong->exponent, build_float(ir, 2)));
    Ref x = build_lane(ir, phong->specular, 0), y = build_lane(ir, phong->specular, 1),
        z = build_lane(ir, phong->specular, 2);
    Ref most = build_max(ir, build_max(ir, x, y), z), least = build_float(ir, LEAST_TINT);
    switch (slot) {
    case SLOT_normal:
    case SLOT_diffuse:
    case SLOT_alpha:
    case SLOT_transparency:
    case SLOT_emissive:
    case SLOT_ior:
        return phong->own;
    case SLOT_specular:
        most = build_max(ir, most, build_float(ir, 0));
        return build_div(ir, build_add(ir, phong->specular, build_splat(ir, least, TYPE_vec3)),
                         build_splat(ir, build_add(ir, most, least), TYPE_vec3));
    case SLOT_roughness:
        return build_sqrt(ir, build_sqrt(ir, share));
    case SLOT_reflectance:
        return build_mul(ir, build_max(ir, most, build_float(ir, 0)), share);
    case SLOT_model:
        return build_float(ir, MODEL_Principled);
    default:
        return build_all(ir, slot_table[slot].type, slot_table[slot].absent);
    }
}
