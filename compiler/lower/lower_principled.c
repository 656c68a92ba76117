/* The material Principled: converts OpenPBR's parameters to slots. */
#include "compiler/lower/lower.h"
#include <math.h>

static Ref color(Lower *l, const Node *m, int param, const Env *env)
{
    return build_convert(l->ir, lower_query(l, lower_param_node(m, param), GROUP_R, env),
                         TYPE_vec3);
}

/* Returns the red component of a parameter as a number. */
static Ref red(Lower *l, const Node *m, int param, const Env *env)
{
    return build_swizzle(l->ir, lower_query(l, lower_param_node(m, param), GROUP_R, env), "x");
}

/* Minimum divisor of quotients whose divisor is 1 plus a reflectance. */
static const double MIN_SUM = 1e-6;

static Ref unit(Ir *ir, Ref x)
{
    return build_clamp(ir, x, build_float(ir, 0), build_float(ir, 1));
}

static Ref share(Lower *l, const Node *m, int param, const Env *env)
{
    return unit(l->ir, red(l, m, param, env));
}

static bool is_thin(const Node *m)
{
    return !value_is_zero(node_param(m, P_Principled_thinWalled));
}

/* Returns weight ((ior - 1) / (ior + 1))^2: Fresnel reflectance at normal incidence. The index is
 * clamped to 0, since -1 would divide by 0. A transmissive thin wall reflects on both sides,
 * repeatedly: R + (1 - R)^2 R / (1 - R^2) = 2 R / (1 + R). */
static Ref reflectance(Lower *l, const Node *m, const Coat *coat, const Env *env)
{
    Ir *ir = l->ir;
    Ref ior = build_max(ir, red(l, m, P_Principled_ior, env), build_float(ir, 0));
    Ref once = build_mul(ir, lower_coated_reflectance(l, coat, ior, env),
                         red(l, m, P_Principled_specular, env));
    Ref clear = share(l, m, P_Principled_transmission, env);
    if (!is_thin(m) || ir_is_number(ir, clear, 0))
        return once;
    Ref both =
        build_div(ir, build_scale(ir, once, 2),
                  build_max(ir, build_add(ir, build_float(ir, 1), once), build_float(ir, MIN_SUM)));
    return build_mix(ir, once, both, clear);
}

/* Returns the share of light scattered within thin walls that leaves on one side: `toward` 1 is
 * the opposite side, -1 the side where the light entered. */
static Ref scattered(Lower *l, const Node *m, double toward, const Env *env)
{
    Ir *ir = l->ir;
    Ref all = color(l, m, P_Principled_subsurfaceColor, env), half = build_float(ir, .5);
    if (!is_thin(m))
        return all;
    Ref on = build_clamp(ir, red(l, m, P_Principled_subsurfaceAnisotropy, env), build_float(ir, -1),
                         build_float(ir, 1));
    return build_mul(ir, all, build_add(ir, half, build_scale(ir, on, toward / 2)));
}

/* Returns the diffuse color of the dielectric: the part that is not transmitted, with subsurface
 * scattering mixed in. */
static Ref dielectric(Lower *l, const Node *m, Ref own, const Env *env)
{
    Ir *ir = l->ir;
    Ref through = share(l, m, P_Principled_transmission, env),
        below = share(l, m, P_Principled_subsurface, env);
    if (!ir_is_number(ir, below, 0))
        own = build_mix(ir, own, scattered(l, m, -1, env), below);
    return ir_is_number(ir, through, 0)
               ? own
               : build_mul(ir, own, build_sub(ir, build_float(ir, 1), through));
}

static Ref not_metal(Lower *l, const Node *m, const Env *env)
{
    return build_sub(l->ir, build_float(l->ir, 1), share(l, m, P_Principled_metalness, env));
}

/* Returns the transmittance of the surface per component: each of a closed mesh's two surfaces
 * takes the square root of the color. */
static Ref through(Lower *l, const Node *m, const Env *env)
{
    Ir *ir = l->ir;
    Ref tint = build_clamp(ir, color(l, m, P_Principled_transmissionColor, env),
                           build_all(ir, TYPE_vec3, 0), build_all(ir, TYPE_vec3, 1));
    Ref weight = build_mul(ir, share(l, m, P_Principled_transmission, env), not_metal(l, m, env));
    return build_mul(ir, is_thin(m) ? tint : build_sqrt(ir, tint), weight);
}

static Ref transparency(Lower *l, const Node *m, Slot slot, const Env *env)
{
    Ir *ir = l->ir;
    Ref opacity = red(l, m, P_Principled_opacity, env), one = build_float(ir, 1);
    const bool holes = ir_is_number(ir, share(l, m, P_Principled_transmission, env), 0);
    if (holes)
        return slot == SLOT_transmission
                   ? build_float(ir, 0)
                   : build_convert(ir, build_sub(ir, one, opacity), TYPE_vec3);
    Ref components = through(l, m, env);
    if (slot == SLOT_transparency)
        return build_sub(
            ir, build_all(ir, TYPE_vec3, 1),
            build_mul(ir, opacity, build_sub(ir, build_all(ir, TYPE_vec3, 1), components)));
    Ref most = build_max(
        ir, build_max(ir, build_component(ir, components, 0), build_component(ir, components, 1)),
        build_component(ir, components, 2));
    return build_mul(ir, opacity, most);
}

/* Returns the diffuse transmission. Light scattered below the surface leaves where it entered,
 * except for thin walls. */
static Ref to_other_side(Lower *l, const Node *m, const Env *env)
{
    Ir *ir = l->ir;
    Ref below = share(l, m, P_Principled_subsurface, env),
        clear = share(l, m, P_Principled_transmission, env);
    if (!is_thin(m) || ir_is_number(ir, below, 0))
        return build_all(ir, TYPE_vec3, 0);
    Ref weight = build_mul(ir, build_mul(ir, below, build_sub(ir, build_float(ir, 1), clear)),
                           not_metal(l, m, env));
    return build_mul(ir, scattered(l, m, 1, env), weight);
}

/* Returns the base color: the diffuse color, mixed with the metal's by metalness. `specular`
 * scales all of a metal's reflection. */
static Ref base(Lower *l, const Node *m, const Env *env)
{
    Ir *ir = l->ir;
    Ref own = build_mul(ir, color(l, m, P_Principled_baseColor, env),
                        red(l, m, P_Principled_baseWeight, env));
    Ref matt = dielectric(l, m, own, env);
    if (matt != own) {
        Ref metal = build_mul(ir, own, red(l, m, P_Principled_specular, env));
        return build_mix(ir, matt, metal, red(l, m, P_Principled_metalness, env));
    }
    Ref weight = red(l, m, P_Principled_specular, env), one = build_float(ir, 1);
    Ref less = build_mul(ir, red(l, m, P_Principled_metalness, env), build_sub(ir, weight, one));
    return build_mul(ir, own, build_add(ir, one, less));
}

static Ref emission(Lower *l, const Node *m, const Env *env)
{
    Ir *ir = l->ir;
    Ref sent = build_mul(ir, color(l, m, P_Principled_emissionColor, env),
                         red(l, m, P_Principled_emission, env));
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

static Ref film(Lower *l, const Node *m, const Coat *coat, Slot slot, const Env *env)
{
    Ir *ir = l->ir;
    Ref there = share(l, m, P_Principled_film, env);
    if (slot == SLOT_film || ir_is_number(ir, there, 0))
        return slot == SLOT_film ? there : build_float(ir, slot_table[slot].absent);
    Ref ior = lower_film_ior(ir, red(l, m, P_Principled_filmIor, env)), zero = build_float(ir, 0),
        most = build_float(ir, slot_table[SLOT_filmPath].high);
    if (slot == SLOT_filmIor)
        return lower_where_there(ir, there, slot, lower_coated_film(l, coat, ior, env));
    Ref path = build_scale(ir, build_mul(ir, red(l, m, P_Principled_filmThickness, env), ior), 2);
    return lower_where_there(ir, there, slot, build_clamp(ir, path, zero, most));
}

/* Returns the doubled angle t of x toward y as (cos 2 t, sin 2 t); (1, 0) for the zero vector. */
static Ref twice_the_angle(Ir *ir, Ref x, Ref y)
{
    const double least = 1e-30;
    Ref xx = build_square(ir, x), yy = build_square(ir, y), all = build_add(ir, xx, yy);
    Ref none = build_lt(ir, all, build_float(ir, least)),
        size = build_max(ir, all, build_float(ir, least));
    Ref cosine = build_div(ir, build_sub(ir, xx, yy), size),
        sine = build_div(ir, build_scale(ir, build_mul(ir, x, y), 2), size);
    return build_select(ir, none, build_vec(ir, TYPE_vec2, build_float(ir, 1), build_float(ir, 0)),
                        build_vec(ir, TYPE_vec2, cosine, sine));
}

/* Normalizes a vector; a zero vector stays zero, and has no angle. */
static Ref unit_or_nothing(Ir *ir, Ref vector)
{
    Ref size = build_max(ir, build_length(ir, vector), build_float(ir, 1e-15));
    return build_mul(ir, vector,
                     build_splat(ir, build_div(ir, build_float(ir, 1), size), TYPE_vec3));
}

/* Returns the doubled angle of a world-space vector, from dP/du toward dP/dv. With n = dP/du x
 * dP/dv the vector n x dP/du is perpendicular to dP/du, and |n| times as long. */
static Ref tangent_turn(Lower *l, const Node *m, const Env *env)
{
    Ir *ir = l->ir;
    Ref toward = unit_or_nothing(ir, color(l, m, P_Principled_tangent, env));
    Ref du = unit_or_nothing(ir, lower_query(l, NULL, GROUP_DU, env));
    Ref dv = unit_or_nothing(ir, lower_query(l, NULL, GROUP_DV, env));
    Ref up = build_cross(ir, du, dv), beside = build_cross(ir, up, du);
    Ref along = build_mul(ir, build_dot(ir, toward, du), build_length(ir, up));
    return twice_the_angle(ir, along, build_dot(ir, toward, beside));
}

static Ref anisotropy(Lower *l, const Node *m, const Env *env)
{
    Ir *ir = l->ir;
    Ref strength = build_clamp(ir, red(l, m, P_Principled_anisotropy, env), build_float(ir, 0),
                               build_float(ir, 1));
    if (ir_is_number(ir, strength, 0))
        return build_all(ir, TYPE_vec2, 0);
    Ref twice = build_scale(ir, red(l, m, P_Principled_anisotropyRotation, env), 4 * M_PI);
    Ref cosine = build_cos(ir, twice), sine = build_sin(ir, twice);
    Ref turn = build_vec(ir, TYPE_vec2, cosine, sine);
    /* adds the tangent's angle to the rotation's */
    if (lower_param_node(m, P_Principled_tangent)) {
        Ref own = tangent_turn(l, m, env), x = build_component(ir, own, 0),
            y = build_component(ir, own, 1);
        Ref real = build_sub(ir, build_mul(ir, x, cosine), build_mul(ir, y, sine));
        turn = build_vec(ir, TYPE_vec2, real,
                         build_add(ir, build_mul(ir, x, sine), build_mul(ir, y, cosine)));
    }
    return build_mul(ir, build_splat(ir, strength, TYPE_vec2), turn);
}

Ref lower_stored_anisotropy(Lower *l, const Node *material, const Env *env)
{
    Ir *ir = l->ir;
    Ref own = lower_slot(l, material, SLOT_anisotropy, env);
    if (ir_is(ir, own, OP_const) && ir_numbers(ir, own)[0] == 0 && ir_numbers(ir, own)[1] == 0)
        return own;
    Ref normal = lower_stored_normal(l, material, env);
    Ref du = lower_query(l, NULL, GROUP_DU, env), dv = lower_query(l, NULL, GROUP_DV, env);
    if (l->job->normals == NORMALS_eye) {
        du = build_call(ir, FN_eyeFromWorld, du);
        dv = build_call(ir, FN_eyeFromWorld, dv);
    }
    ir->origin = ORIGIN_SLOTS + SLOT_anisotropy;
    return build_call(ir, FN_anisotropyStored, own, normal, du, dv);
}

Ref lower_Principled(Lower *l, const Node *m, Slot slot, const Env *env)
{
    Ir *ir = l->ir;
    const Coat coat = COAT_OF(m, Principled);
    switch (slot) {
    case SLOT_normal:
        return lower_query(l, lower_param_node(m, P_Principled_input), GROUP_N, env);
    case SLOT_diffuse:
        return base(l, m, env);
    case SLOT_alpha:
        return red(l, m, P_Principled_opacity, env);
    case SLOT_specular:
        return color(l, m, P_Principled_specularColor, env);
    case SLOT_transparency:
    case SLOT_transmission:
        return transparency(l, m, slot, env);
    case SLOT_diffuseTransparency:
        return to_other_side(l, m, env);
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
    case SLOT_film:
    case SLOT_filmPath:
    case SLOT_filmIor:
        return film(l, m, &coat, slot, env);
    case SLOT_anisotropy:
        return anisotropy(l, m, env);
    case SLOT_coatNormal:
        return lower_coat_normal(l, &coat, env);
    case SLOT_diffuseRoughness:
        return share(l, m, P_Principled_diffuseRoughness, env);
    default:
        return build_all(ir, slot_table[slot].type, slot_table[slot].absent);
    }
}

/* Lower bound of the specular color, below which the tint approaches white. */
static const double MIN_TINT = 1e-6;

Ref lower_principled_of_phong(Lower *l, Slot slot, const PhongSlots *phong)
{
    Ir *ir = l->ir;
    Ref share =
        build_div(ir, build_float(ir, 2), build_add(ir, phong->exponent, build_float(ir, 2)));
    Ref x = build_component(ir, phong->specular, 0), y = build_component(ir, phong->specular, 1),
        z = build_component(ir, phong->specular, 2);
    Ref most = build_max(ir, build_max(ir, x, y), z), least = build_float(ir, MIN_TINT);
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

/* Returns the reflectance at normal incidence of the metal and the dielectric. A Phong mixed
 * with a Principled may have any number here; outside [0, 1] the rest of the lobe would be a
 * difference of large numbers. */
static Ref reflected(Lower *l, const Node *m, const Env *env)
{
    Ir *ir = l->ir;
    Ref strength = build_splat(ir, lower_slot(l, m, SLOT_reflectance, env), TYPE_vec3);
    Ref dielectric = build_mul(ir, strength, lower_slot(l, m, SLOT_specular, env));
    Ref metal = lower_slot(l, m, SLOT_diffuse, env);
    Ref share = build_mix(ir, dielectric, metal, lower_slot(l, m, SLOT_metalness, env));
    return build_clamp(ir, share, build_all(ir, TYPE_vec3, 0), build_all(ir, TYPE_vec3, 1));
}

/* Returns the Phong exponent of the lobe as wide as GGX's: over light directions the lobe is
 * twice as wide as over microfacet normals. */
static Ref exponent_of(Lower *l, const Node *m, const Env *env)
{
    const double least = 1e-6, greatest = slot_table[SLOT_shininess].high;
    Ir *ir = l->ir;
    Ref width = build_square(ir, lower_slot(l, m, SLOT_roughness, env)), half = build_float(ir, .5);
    Ref square = build_max(ir, build_square(ir, width), build_float(ir, least));
    Ref exponent = build_sub(ir, build_div(ir, half, square), half);
    return build_clamp(ir, exponent, build_float(ir, 0), build_float(ir, greatest));
}

/* Returns the factor that undoes a double loss. A layout for Phongs multiplies the light by 1 -
 * transparency; a Principled's diffuse color already excludes the light transmitted through the
 * dielectric. The factor that undoes the double loss is (1 - holes) / (1 - transparency); 1 if
 * the dielectric transmits nothing. The test is by value: a test for a folded constant would
 * give another result at -O0. */
static Ref kept_twice(Lower *l, const Node *m, const Env *env)
{
    const double least = 1e-3;
    Ir *ir = l->ir;
    Ref one = build_all(ir, TYPE_vec3, 1);
    Ref there = build_splat(ir, lower_slot(l, m, SLOT_alpha, env), TYPE_vec3);
    Ref opaque = build_le(ir, lower_slot(l, m, SLOT_transmission, env), build_float(ir, 0));
    Ref kept = build_sub(ir, one, lower_slot(l, m, SLOT_transparency, env));
    Ref factor = build_div(ir, there, build_max(ir, kept, build_all(ir, TYPE_vec3, least)));
    return build_select(ir, opaque, one, factor);
}

/* Returns a lobe's strength with the correction of kept_twice(), at most 1, the bound of the
 * slots. */
static Ref within_slot(Lower *l, const Node *m, Ref strength, const Env *env)
{
    Ir *ir = l->ir;
    Ref wanted = build_mul(ir, strength, kept_twice(l, m, env));
    return build_min(ir, wanted, build_all(ir, TYPE_vec3, 1));
}

/* Returns the strength of the Phong lobe. A lobe of exponent n reflects 2 / (n + 2); the
 * strength is at most 1, the bound of the slot. */
static Ref lobe_of(Lower *l, const Node *m, const Env *env)
{
    Ir *ir = l->ir;
    Ref more = build_add(ir, exponent_of(l, m, env), build_float(ir, 2));
    Ref lobe = build_mul(ir, reflected(l, m, env), build_scale(ir, more, .5));
    return build_min(ir, lobe, build_all(ir, TYPE_vec3, 1));
}

/* Returns the diffuse color, including the reflection that exceeds the lobe's maximum. */
static Ref matt_of(Lower *l, const Node *m, const Env *env)
{
    Ir *ir = l->ir;
    Ref one = build_float(ir, 1), more = build_add(ir, exponent_of(l, m, env), build_float(ir, 2));
    Ref enters = build_sub(ir, one, lower_slot(l, m, SLOT_reflectance, env));
    Ref share = build_mul(ir, enters, build_sub(ir, one, lower_slot(l, m, SLOT_metalness, env)));
    Ref base = build_mul(ir, lower_slot(l, m, SLOT_diffuse, env), share);
    Ref coat = lower_slot(l, m, SLOT_coatTint, env);
    Ref held = build_div(ir, build_scale(ir, lobe_of(l, m, env), 2), more);
    return build_mul(ir, coat, build_add(ir, base, build_sub(ir, reflected(l, m, env), held)));
}

Ref lower_phong_of_principled(Lower *l, const Node *m, Slot slot, const Env *env)
{
    switch (slot) {
    case SLOT_shininess:
        return exponent_of(l, m, env);
    case SLOT_specular:
        return within_slot(l, m, lobe_of(l, m, env), env);
    case SLOT_diffuse:
        return within_slot(l, m, matt_of(l, m, env), env);
    default:
        return lower_slot(l, m, slot, env);
    }
}
