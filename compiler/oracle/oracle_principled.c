/* Evaluates the slots of Principled, of a coat over a material, and of two mixed materials
 * (semantics.md, section 4). */
#include "compiler/oracle/oracle_maps.h"
#include "compiler/base/vec3.h"
#include <math.h>
#include <string.h>

static const double GREATEST_EXPONENT = 65504, LEAST = 1e-6;

static double query_red(Environment *environment, const Node *material, int param)
{
    return oracle_query_param(environment, material, param, channel_id(GROUP_R, 0));
}

static double unit(double x) { return fmin(fmax(x, 0), 1); }

/* Interpolates linearly; exact at both ends, even if the other value is much greater. */
static double mixed(double a, double b, double t) { return (1 - t) * a + t * b; }

/* Returns the Fresnel reflectance at normal incidence. */
static double reflectance_of(double ior) { return (ior - 1) / (ior + 1) * ((ior - 1) / (ior + 1)); }

typedef struct {
    double weight, colour[3], roughness, ior, darkening, roughening;
} OracleCoat;

/* Reads the parameters coat, coatColor, coatRoughness, coatIor, coatDarkening and
 * coatRoughening. */
static OracleCoat coat_of(Environment *environment, const Node *node, const int params[6])
{
    OracleCoat coat = {.weight = unit(query_red(environment, node, params[0])),
                       .roughness = query_red(environment, node, params[2]),
                       .ior = fmax(query_red(environment, node, params[3]), 0),
                       .darkening = query_red(environment, node, params[4]),
                       .roughening = query_red(environment, node, params[5])};
    oracle_query_colour(environment, node, params[1], coat.colour);
    return coat;
}

static double film_ior(double ior)
{
    return fmin(fmax(ior, slot_table[SLOT_filmIor].low), slot_table[SLOT_filmIor].high);
}

/* Lays a coat over a material: changes the base's slots below it, then sets its own. `ior` is
 * the base's index relative to air, `specular` the weight of its reflection. */
static void lay(const OracleCoat *coat, double ior, double specular, SlotValues *result)
{
    if (!(coat->weight > 0))
        return;
    const double w = coat->weight, high = fmax(ior, coat->ior),
                 low = fmax(fmin(ior, coat->ior), LEAST);
    const double own = reflectance_of(coat->ior);
    const double back = unit(1 - (1 - own) / fmax(coat->ior * coat->ior, LEAST));
    double *rough = result->component[SLOT_roughness];
    const double rougher =
        pow(fmin(pow(fmax(rough[0], 0), 4) + 2 * pow(coat->roughness, 4), 1), .25);
    rough[0] = mixed(rough[0], rougher, unit(w * coat->roughening));
    result->component[SLOT_reflectance][0] = specular * reflectance_of(mixed(ior, high / low, w));
    for (int i = 0; i < 3; i++) {
        const double tint = 1 - w + w * coat->colour[i], by = unit(w * coat->darkening);
        const double dark =
            (1 - back) / fmax(1 - unit(result->component[SLOT_diffuse][i]) * back, LEAST);
        result->component[SLOT_coatTint][i] = tint * (1 - by + by * dark);
        result->component[SLOT_emissive][i] *= tint;
    }
    if (result->component[SLOT_film][0] > 0)
        result->component[SLOT_filmIor][0] =
            film_ior(result->component[SLOT_filmIor][0] / fmax(1 - w + w * coat->ior, LEAST));
    result->component[SLOT_coat][0] = w;
    result->component[SLOT_coatRoughness][0] = coat->roughness;
    result->component[SLOT_coatReflectance][0] = own;
}

/* Sets the anisotropy a (cos 2 t, sin 2 t), with t from the rotation in turns plus, if present,
 * the tangent's angle from dP/du toward dP/dv. */
static void set_anisotropy(Environment *environment, const Node *material, SlotValues *result)
{
    const double strength = unit(query_red(environment, material, P_Principled_anisotropy));
    double turn = 4 * M_PI * query_red(environment, material, P_Principled_anisotropyRotation),
           tangent[3], beside[3], m[3];
    const double *du = &environment->surface->root[channel_id(GROUP_DU, 0)],
                 *dv = &environment->surface->root[channel_id(GROUP_DV, 0)];
    if (!(strength > 0))
        return;
    if (node_param(material, P_Principled_tangent)->kind != VALUE_none) {
        oracle_query_colour(environment, material, P_Principled_tangent, tangent);
        vec3_cross(du, dv, m);
        vec3_cross(m, du, beside);
        turn += 2 * atan2(vec3_dot(tangent, beside), vec3_dot(tangent, du) * vec3_length(m));
    }
    result->component[SLOT_anisotropy][0] = strength * cos(turn);
    result->component[SLOT_anisotropy][1] = strength * sin(turn);
}

/* Applies transmission, straight and by subsurface scattering: the color applies once to both
 * surfaces of a closed mesh together, and scattered light leaves where it entered. Before the
 * call the diffuse slot is b (1 - metal + metal weight). */
static void let_through(Environment *environment, const Node *material, SlotValues *result)
{
    const double clear = unit(query_red(environment, material, P_Principled_transmission)),
                 metal = result->component[SLOT_metalness][0];
    const double below = unit(query_red(environment, material, P_Principled_subsurface)),
                 opacity = result->component[SLOT_alpha][0];
    const double on =
        fmin(fmax(query_red(environment, material, P_Principled_subsurfaceAnisotropy), -1), 1);
    const double weight = query_red(environment, material, P_Principled_specular),
                 base_weight = query_red(environment, material, P_Principled_baseWeight);
    const bool thin = oracle_number(material, P_Principled_thinWalled) != 0;
    double tint[3], scattered[3], base[3], most = 0;
    if (!(clear > 0) && !(below > 0))
        return;
    oracle_query_colour(environment, material, P_Principled_transmissionColor, tint);
    oracle_query_colour(environment, material, P_Principled_subsurfaceColor, scattered);
    oracle_query_colour(environment, material, P_Principled_baseColor, base);
    for (int i = 0; i < 3; i++) {
        const double back = scattered[i] * (thin ? (1 - on) / 2 : 1), own = base[i] * base_weight;
        const double through =
            clear * (1 - unit(metal)) * (thin ? unit(tint[i]) : sqrt(unit(tint[i])));
        result->component[SLOT_diffuse][i] =
            (1 - metal) * (1 - clear) * mixed(own, back, below) + metal * own * weight;
        result->component[SLOT_diffuseTransparency][i] =
            thin ? below * (1 - clear) * (1 - unit(metal)) * scattered[i] * (1 + on) / 2 : 0;
        result->component[SLOT_transparency][i] = 1 - opacity * (1 - through);
        most = fmax(most, through);
    }
    result->component[SLOT_transmission][0] = opacity * most;
}

static void set_film(Environment *environment, const Node *material, SlotValues *result)
{
    const double there = unit(query_red(environment, material, P_Principled_film)),
                 ior = film_ior(query_red(environment, material, P_Principled_filmIor));
    const double path = 2 * query_red(environment, material, P_Principled_filmThickness) * ior;
    if (!(there > 0))
        return;
    result->component[SLOT_film][0] = there;
    result->component[SLOT_filmIor][0] = ior;
    result->component[SLOT_filmPath][0] = fmin(fmax(path, 0), slot_table[SLOT_filmPath].high);
}

/* Sets the coat's own normal; (0, 0, 0) if the coat follows the normal of the surface below. */
static void set_coat_normal(Environment *environment, const Node *material, int param,
                            SlotValues *result)
{
    double normal[3], *component = result->component[SLOT_coatNormal];
    memset(component, 0, sizeof result->component[SLOT_coatNormal]);
    if (graph_coat_follows(environment->oracle->graph, material))
        return;
    for (int i = 0; i < 3; i++)
        normal[i] = oracle_query_param(environment, material, param, channel_id(GROUP_N, i));
    oracle_call(environment, FN_safeNormalize, normal, component);
    for (int i = 0; i < 3 && !environment->surface->front; i++)
        component[i] = -component[i];
}

/* Returns the reflectance of both sides of a thin, transmissive wall. */
static double of_both_sides(Environment *environment, const Node *material, double once)
{
    const double clear = unit(query_red(environment, material, P_Principled_transmission));
    return oracle_number(material, P_Principled_thinWalled) == 0
               ? once
               : mixed(once, 2 * once / fmax(1 + once, LEAST), clear);
}

/* Evaluates a Principled. The index of refraction gives the Fresnel reflectance at normal
 * incidence; `specular` scales it, and scales the color of metal. */
void oracle_Principled(Environment *environment, const Node *material, SlotValues *result)
{
    static const int coat_params[] = {P_Principled_coat,          P_Principled_coatColor,
                                      P_Principled_coatRoughness, P_Principled_coatIor,
                                      P_Principled_coatDarkening, P_Principled_coatRoughening};
    double normal[3], colour[3];
    for (int i = 0; i < 3; i++)
        normal[i] =
            oracle_query_param(environment, material, P_Principled_input, channel_id(GROUP_N, i));
    oracle_set_normal(environment, normal, result);
    const double metal = query_red(environment, material, P_Principled_metalness);
    const double weight = query_red(environment, material, P_Principled_specular);
    const double opacity = query_red(environment, material, P_Principled_opacity);
    const double ior = fmax(query_red(environment, material, P_Principled_ior), 0);
    oracle_query_colour(environment, material, P_Principled_baseColor, colour);
    for (int i = 0; i < 3; i++)
        result->component[SLOT_diffuse][i] =
            colour[i] * query_red(environment, material, P_Principled_baseWeight) *
            (1 - metal + metal * weight);
    oracle_query_colour(environment, material, P_Principled_emissionColor, colour);
    for (int i = 0; i < 3; i++)
        result->component[SLOT_emissive][i] =
            opacity * colour[i] * query_red(environment, material, P_Principled_emission);
    oracle_query_colour(environment, material, P_Principled_specularColor,
                        result->component[SLOT_specular]);
    for (int i = 0; i < 3; i++)
        result->component[SLOT_transparency][i] = 1 - opacity;
    result->component[SLOT_alpha][0] = opacity;
    result->component[SLOT_metalness][0] = metal;
    result->component[SLOT_roughness][0] = query_red(environment, material, P_Principled_roughness);
    result->component[SLOT_reflectance][0] = weight * reflectance_of(ior);
    result->component[SLOT_model][0] = MODEL_Principled;
    result->component[SLOT_diffuseRoughness][0] =
        unit(query_red(environment, material, P_Principled_diffuseRoughness));
    set_anisotropy(environment, material, result);
    let_through(environment, material, result);
    set_film(environment, material, result);
    const OracleCoat coat = coat_of(environment, material, coat_params);
    lay(&coat, ior, weight, result);
    if (coat.weight > 0)
        set_coat_normal(environment, material, P_Principled_coatNormal, result);
    result->component[SLOT_reflectance][0] =
        of_both_sides(environment, material, result->component[SLOT_reflectance][0]);
    const double fuzz = query_red(environment, material, P_Principled_fuzz);
    if (!(fuzz > 0))
        return;
    result->component[SLOT_fuzz][0] = fuzz;
    oracle_query_colour(environment, material, P_Principled_fuzzColor,
                        result->component[SLOT_fuzzColor]);
    result->component[SLOT_fuzzRoughness][0] =
        query_red(environment, material, P_Principled_fuzzRoughness);
}

void oracle_Layer(Environment *environment, const Node *material, SlotValues *result)
{
    static const int coat_params[] = {P_Layer_coat,          P_Layer_coatColor,
                                      P_Layer_coatRoughness, P_Layer_coatIor,
                                      P_Layer_coatDarkening, P_Layer_coatRoughening};
    oracle_spend(environment, MAP_VALUE_WORK);
    if (oracle_spent(environment->oracle))
        return;
    oracle_map_value_as(environment, material, oracle_material_of(material, P_Layer_base), result);
    const double root = sqrt(unit(result->component[SLOT_reflectance][0]));
    const OracleCoat coat = coat_of(environment, material, coat_params);
    lay(&coat, (1 + root) / fmax(1 - root, LEAST), 1, result);
    if (coat.weight > 0)
        set_coat_normal(environment, material, P_Layer_coatNormal, result);
}

bool oracle_is_principled(const Environment *environment, const Node *material)
{
    const unsigned *models = environment->oracle->graph->models;
    return material && models && models[material->index] >> MODEL_Principled & 1;
}

/* Converts a Phong's slots to a Principled with equal reflectance at normal incidence and equal
 * lobe width. */
void oracle_as_principled(SlotValues *side)
{
    const double *specular = side->component[SLOT_specular],
                 share = 2 / (side->component[SLOT_shininess][0] + 2);
    const double most = fmax(fmax(specular[0], fmax(specular[1], specular[2])), 0);
    static const Slot lost[] = {SLOT_shininess, SLOT_transparencyShininess,
                                SLOT_interpolatedTransparency, SLOT_diffuseTransparency,
                                SLOT_ambient};
    for (size_t i = 0; i < sizeof lost / sizeof *lost; i++)
        for (int component = 0; component < type_table[slot_table[lost[i]].type].components;
             component++)
            side->component[lost[i]][component] = slot_table[lost[i]].absent;
    for (int component = 0; component < 3; component++)
        side->component[SLOT_specular][component] =
            (side->component[SLOT_specular][component] + LEAST) / (most + LEAST);
    side->component[SLOT_roughness][0] = sqrt(sqrt(share));
    side->component[SLOT_reflectance][0] = most * share;
    side->component[SLOT_model][0] = MODEL_Principled;
}

static double roughness_of(double exponent) { return sqrt(sqrt(2 / (exponent + 2))); }

/* Returns the weight of the second side where the mask is t, multiplied by the slot that weighs
 * this one on both sides. */
static double counted(Slot slot, const SlotValues sides[2], double t)
{
    if (slot_weight(slot) == SLOT_COUNT)
        return t;
    const double a = (1 - t) * sides[0].component[slot_weight(slot)][0],
                 b = t * sides[1].component[slot_weight(slot)][0];
    return a + b > LEAST ? b / (a + b) : t;
}

/* Mixes a slot of both sides. */
static void mix_slot(const Environment *environment, Slot slot, const SlotValues sides[2], double t,
                     SlotValues *result)
{
    const double *a = sides[0].component[slot], *b = sides[1].component[slot],
                 by = counted(slot, sides, t);
    double *mean = result->component[slot];
    if (!memcmp(a, b, sizeof sides[0].component[slot])) {
        memcpy(mean, a, sizeof sides[0].component[slot]);
        return;
    }
    for (int i = 0; i < 3; i++)
        mean[i] = a[i] * (1 - by) + b[i] * by;
    if (slot == SLOT_coatNormal) {
        const double size = fmax(vec3_length(mean), 1e-15);
        for (int i = 0; i < 3; i++)
            mean[i] /= size;
    } else if (slot_mixing(slot) == MIXING_DIRECTION) {
        const double side = environment->surface->front ? 1 : -1;
        const double turned[3] = {side * mean[0], side * mean[1], side * mean[2]};
        oracle_set_normal(environment, turned, result);
    } else if (slot_mixing(slot) == MIXING_EXPONENT) {
        const double r = roughness_of(a[0]) * (1 - t) + roughness_of(b[0]) * t;
        mean[0] = fmin(fmax(2 / (r * r * r * r) - 2, 0), GREATEST_EXPONENT);
    }
}

/* Evaluates a Mix. A material that occurs repeatedly in nested Mixes is evaluated as often; the
 * bound on work limits the total. */
void oracle_MixMaterial(Environment *environment, const Node *material, SlotValues *result)
{
    SlotValues sides[2];
    oracle_spend(environment, MAP_VALUE_WORK);
    if (oracle_spent(environment->oracle))
        return;
    const double red = query_red(environment, material, P_MixMaterial_mask);
    oracle_map_value_as(environment, material, oracle_material_of(material, P_MixMaterial_a),
                        &sides[0]);
    oracle_map_value_as(environment, material, oracle_material_of(material, P_MixMaterial_b),
                        &sides[1]);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        mix_slot(environment, (Slot)slot, sides, unit(red), result);
}
