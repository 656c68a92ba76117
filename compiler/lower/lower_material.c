/* Materials: lowers their shading slots. Only slots that a pass stores are queried. */
#include "compiler/lower/map_value.h"
#include "compiler/lower/blend.h"
#include "compiler/lower/footprint.h"
#include "grammar/lobe_table.h"
#include "compiler/library/sky.h"

/* GroIMP's gray for a surface without a material. */
static const double missing_gray = 128.0 / 255;

enum { MAX_EXPONENT = 65504, DEFAULT_EXPONENT = 4 };

static Ref white(Lower *l) { return build_vec3(l->ir, 1, 1, 1); }
static Ref black(Lower *l) { return build_vec3(l->ir, 0, 0, 0); }
/* Returns the default value of a slot that a material does not set. */
static Ref nothing(Lower *l, Slot slot)
{
    return build_all(l->ir, slot_table[slot].type, slot_table[slot].absent);
}

typedef Ref LowerShader(Lower *l, const Node *material, Slot slot, const Env *env);
typedef const Node *LowerSwitch(const Node *material, bool front);

#define SHADER_OF_SHADER(name)  lower_##name
#define SWITCH_OF_SHADER(name)  NULL
#define FOREIGN_OF_SHADER(name) NULL
static LowerShader *const shaders[KIND_COUNT] = {
#define MATERIAL(name, sort, doc) [KIND_##name] = sort##_OF_SHADER(name),
#include "grammar/materials.def"
#include "grammar/maps.def"
};

#define SHADER_OF_SWITCH(name)  NULL
#define SWITCH_OF_SWITCH(name)  lower_choose_##name
#define FOREIGN_OF_SWITCH(name) NULL
static LowerSwitch *const switches[KIND_COUNT] = {
#define MATERIAL(name, sort, doc) [KIND_##name] = sort##_OF_SWITCH(name),
#include "grammar/materials.def"
#include "grammar/maps.def"
};

static Ref color(Lower *l, const Node *map, const Env *env)
{
    return build_convert(l->ir, lower_query(l, map, GROUP_R, env), TYPE_vec3);
}

/* Returns the alpha of a color: only a vec4 has one; for all others the conversion table gives
 * 1. */
static Ref alpha_of(Lower *l, const Node *map, const Env *env)
{
    Ir *ir = l->ir;
    Ref value = lower_query(l, map, GROUP_R, env);
    return ir_type(ir, value) == TYPE_vec4 ? build_swizzle(ir, value, "w") : build_float(ir, 1);
}

/* Returns the Phong exponent of a shininess; where that is one of two values within the pixel,
 * the mean of both exponents. */
static Ref exponent_of(Lower *l, MapValue shininess, int depth)
{
    Ir *ir = l->ir;
    const Split *split = shininess.split;
    if (!split || depth == 0)
        return build_call(ir, FN_phongExponent, build_swizzle(ir, shininess.value, "x"));
    Ref a = exponent_of(l, split->a, depth - 1), b = exponent_of(l, split->b, depth - 1);
    return map_value_mean(l, split->by, a, b);
}

static Ref exponent(Lower *l, const Node *map, double without, const Env *env)
{
    if (!map)
        return build_float(l->ir, without);
    return exponent_of(l, lower_map_value(l, map, GROUP_R, env), MAX_SPLITS);
}

/* Returns the transparency factor 1 + alpha (c - 1). */
static Ref transparency(Lower *l, const Node *m, const Env *env)
{
    Ir *ir = l->ir;
    Ref alpha = alpha_of(l, lower_param_node(m, P_Phong_diffuse), env);
    Ref c = color(l, lower_param_node(m, P_Phong_transparency), env);
    if (ir_is_number(ir, alpha, 1))
        return c;
    return build_add(ir, build_mul(ir, alpha, build_sub(ir, c, white(l))), white(l));
}

Ref lower_Phong(Lower *l, const Node *m, Slot slot, const Env *env)
{
    const Node *diffuse = lower_param_node(m, P_Phong_diffuse);
    switch (slot) {
    case SLOT_normal:
        return lower_query(l, lower_param_node(m, P_Phong_input), GROUP_N, env);
    case SLOT_diffuse:
        return color(l, diffuse, env);
    case SLOT_alpha:
        return alpha_of(l, diffuse, env);
    case SLOT_specular:
        return color(l, lower_param_node(m, P_Phong_specular), env);
    case SLOT_shininess:
        return exponent(l, lower_param_node(m, P_Phong_shininess), DEFAULT_EXPONENT, env);
    case SLOT_transparency:
        return transparency(l, m, env);
    case SLOT_transparencyShininess:
        return exponent(l, lower_param_node(m, P_Phong_transparencyShininess), MAX_EXPONENT, env);
    case SLOT_interpolatedTransparency:
        return lower_param(l, node_param(m, P_Phong_interpolatedTransparency), TYPE_float);
    case SLOT_diffuseTransparency:
        return color(l, lower_param_node(m, P_Phong_diffuseTransparency), env);
    case SLOT_ambient:
        return color(l, lower_param_node(m, P_Phong_ambient), env);
    case SLOT_emissive:
        return color(l, lower_param_node(m, P_Phong_emissive), env);
    case SLOT_ior:
        return lower_query(l, lower_param_node(m, P_Phong_input), GROUP_IOR, env);
    default:
        return nothing(l, slot);
    }
}

/* Returns a slot of a material of one color: a Phong with that diffuse color and a uniform
 * transparency. */
static Ref plain_slot(Lower *l, Ref diffuse, Ref clear, Slot slot, const Env *env)
{
    Ir *ir = l->ir;
    switch (slot) {
    case SLOT_diffuse:
        return diffuse;
    case SLOT_alpha:
        return build_float(ir, 1);
    case SLOT_transparency:
        return build_convert(ir, clear, TYPE_vec3);
    case SLOT_shininess:
        return build_float(ir, DEFAULT_EXPONENT);
    case SLOT_transparencyShininess:
        return build_float(ir, MAX_EXPONENT);
    case SLOT_interpolatedTransparency:
        return build_float(ir, 1);
    case SLOT_ior:
        return env->root[GROUP_IOR];
    default:
        return nothing(l, slot);
    }
}

Ref lower_RGBA(Lower *l, const Node *m, Slot slot, const Env *env)
{
    Ir *ir = l->ir;
    if (slot == SLOT_normal)
        return env->root[GROUP_N];
    Ref r = lower_param(l, node_param(m, P_RGBA_r), TYPE_float),
        g = lower_param(l, node_param(m, P_RGBA_g), TYPE_float);
    Ref b = lower_param(l, node_param(m, P_RGBA_b), TYPE_float),
        a = lower_param(l, node_param(m, P_RGBA_a), TYPE_float);
    Ref diffuse = build_vec(ir, TYPE_vec3, r, g, b);
    return plain_slot(l, diffuse, build_sub(ir, build_float(ir, 1), a), slot, env);
}

static Ref missing_slot(Lower *l, Slot slot, const Env *env)
{
    Ir *ir = l->ir;
    if (slot == SLOT_normal)
        return env->root[GROUP_N];
    Ref diffuse = build_vec3(ir, missing_gray, missing_gray, missing_gray);
    return plain_slot(l, diffuse, build_float(ir, 0), slot, env);
}

/* Returns the sky's radiance along the local position. Terms of the sun alone are computed here,
 * in double. */
static Ref sky_radiance(Lower *l, const Node *m, const Env *env)
{
    Ir *ir = l->ir;
    const char *why = "the sky's coefficients are computed at compile time";
    lower_reject_uniform(l, node_param(m, P_SunSkyLight_sun), "sun", why);
    lower_reject_uniform(l, node_param(m, P_SunSkyLight_turbidity), "turbidity", why);
    double sun[4], turbidity[4], row[7][3];
    value_number(node_param(m, P_SunSkyLight_sun), TYPE_vec3, sun);
    value_number(node_param(m, P_SunSkyLight_turbidity), TYPE_float, turbidity);
    sky_coefficients(sun, turbidity[0], 1, row);
    /* skyRadiance(direction, sun, zenith over F(0, sun), A, B, C, D, E) */
    static const int order[] = {6, 0, 1, 2, 3, 4, 5};
    Ref args[8] = {lower_query(l, NULL, GROUP_X, env)};
    for (int i = 0; i < 7; i++)
        args[i + 1] = ir_const(ir, TYPE_vec3, row[order[i]]);
    Ref factor = lower_param(l, node_param(m, P_SunSkyLight_radianceFactor), TYPE_float);
    return build_mul(ir, build_call_of(ir, FN_skyRadiance, args, 8), factor);
}

Ref lower_SunSkyLight(Lower *l, const Node *m, Slot slot, const Env *env)
{
    if (slot == SLOT_normal)
        return env->root[GROUP_N];
    if (slot == SLOT_emissive)
        return sky_radiance(l, m, env);
    Ref diffuse = black(l);
    return plain_slot(l, diffuse, build_float(l->ir, 0), slot, env);
}

/* Returns the material of a side. A missing back is replaced by the front; a missing front stays
 * missing. */
const Node *lower_choose_SideSwitch(const Node *m, bool front)
{
    const Node *back = front ? NULL : lower_param_node(m, P_SideSwitch_backShader);
    return back ? back : lower_param_node(m, P_SideSwitch_frontShader);
}

/* Returns the material for a preview: the GUI's, else the ray tracer's, else the radiation
 * model's. */
const Node *lower_choose_AlgorithmSwitch(const Node *m, bool front)
{
    (void)front;
    const Node *gui = lower_param_node(m, P_AlgorithmSwitch_guiShader);
    const Node *ray = lower_param_node(m, P_AlgorithmSwitch_raytracerShader);
    return gui ? gui : ray ? ray : lower_param_node(m, P_AlgorithmSwitch_radiationShader);
}

const Node *lower_displaced(const Node *m)
{
    while (m && !graph_displaces(m))
        m = switches[m->kind] ? switches[m->kind](m, true) : NULL;
    return m;
}

/* Returns the material visible from one side, through any number of nested switches, which all
 * see the same side. */
static const Node *seen_from(const Node *m, bool front)
{
    while (m && switches[m->kind])
        m = switches[m->kind](m, front);
    return m;
}

static Ref both_sides(Lower *l, const Env *env, const Ref sides[2])
{
    return sides[0] == sides[1] ? sides[0] : build_select(l->ir, env->front, sides[0], sides[1]);
}

/* Lowers a slot of a material that is not a switch. */
static Ref side_slot(Lower *l, const Node *m, Slot slot, const Env *env)
{
    return m ? shaders[m->kind](l, m, slot, env) : missing_slot(l, slot, env);
}

bool lower_is_principled(const Lower *l, const Node *m)
{
    return m && l->graph->models[m->index] >> MODEL_Principled & 1;
}

/* Returns a slot of a material that is not a switch, converted to a Principled. */
static Ref side_as_principled(Lower *l, const Node *m, Slot slot, const Env *env)
{
    if (lower_is_principled(l, m))
        return side_slot(l, m, slot, env);
    const Ref own = side_slot(l, m, slot, env);
    const Ref specular = build_convert(l->ir, side_slot(l, m, SLOT_specular, env), TYPE_vec3);
    const Ref shininess = side_slot(l, m, SLOT_shininess, env);
    const PhongSlots phong = {own, specular, shininess};
    return lower_principled_of_phong(l, slot, &phong);
}

Ref lower_value_slot(Lower *l, const Node *m, bool principled, Slot slot, const Env *env)
{
    const Node *front = seen_from(m, true), *back = seen_from(m, false);
    typedef Ref SideSlot(Lower * l, const Node *m, Slot slot, const Env *env);
    SideSlot *side = principled ? side_as_principled : side_slot;
    if (front == back)
        return side(l, front, slot, env);
    return both_sides(l, env, REFS(l->ir, side(l, front, slot, env), side(l, back, slot, env)));
}

/* Returns the normal in eye space: the interpolated normal comes from the vertex program in eye
 * space; any other is transformed. */
static Ref in_eye_space(Lower *l, Ref normal, const Env *env)
{
    if (normal == env->root[GROUP_N] && env->eye_n)
        return env->eye_n;
    return build_call(l->ir, FN_eyeFromWorld, normal);
}

static Ref side_normal(Lower *l, const Node *m, const Env *env, bool eye)
{
    Ref normal = side_slot(l, m, SLOT_normal, env);
    return eye ? in_eye_space(l, normal, env) : normal;
}

/* Returns the environment of the displaced surface. */
static Env shape_env(Lower *l, const Node *m, const Env *mesh)
{
    const Node *displaced = lower_displaced(m);
    return displaced && !graph_displaces_volume(displaced) ? lower_displaced_env(l, displaced, mesh)
                                                           : *mesh;
}

static Ref normal_of(Lower *l, const Node *m, const Env *mesh, bool eye)
{
    const Env moved = shape_env(l, m, mesh), *env = &moved;
    const Node *front = seen_from(m, true), *back = seen_from(m, false);
    if (front == back)
        return side_normal(l, front, env, eye);
    return both_sides(l, env,
                      REFS(l->ir, side_normal(l, front, env, eye), side_normal(l, back, env, eye)));
}

/* Normalizes a normal, and flips it to the viewer's side. */
static Ref finished_normal(Lower *l, Ref normal, const Env *env)
{
    Ir *ir = l->ir;
    Ref side = build_select(ir, env->front, build_float(ir, 1), build_float(ir, -1));
    return build_mul(ir, build_call(ir, FN_safeNormalize, normal), side);
}

Ref lower_stored_normal(Lower *l, const Node *material, const Env *env)
{
    const bool eye = l->job->normals == NORMALS_eye;
    l->ir->origin = ORIGIN_SLOTS + SLOT_normal;
    Ref value = finished_normal(l, normal_of(l, material, env, eye), env);
    lower_mark_head(l->ir, value, ORIGIN_SLOTS + SLOT_normal);
    return value;
}

/* Returns the coat's own normal, normalized and flipped; (0, 0, 0) if the coat has none. */
static Ref coat_normal_of(Lower *l, const Node *material, const Env *mesh, bool eye)
{
    Ir *ir = l->ir;
    const double least = 1e-15;
    if (!material || !(l->graph->models[material->index] & MODEL_LOBE(LOBE_coatNormal)))
        return build_all(ir, TYPE_vec3, 0);
    const Env env = shape_env(l, material, mesh);
    Ref value =
        lower_value_slot(l, material, lower_is_principled(l, material), SLOT_coatNormal, &env);
    if (ir_is_number(ir, value, 0))
        return value;
    value = eye ? build_call(ir, FN_eyeFromWorld, value) : value;
    Ref side = build_select(ir, mesh->front, build_float(ir, 1), build_float(ir, -1));
    return build_mul(
        ir, value,
        build_splat(
            ir, build_div(ir, side, build_max(ir, build_length(ir, value), build_float(ir, least))),
            TYPE_vec3));
}

Ref lower_stored_coat_normal(Lower *l, const Node *material, const Env *env)
{
    l->ir->origin = ORIGIN_SLOTS + SLOT_coatNormal;
    Ref value = coat_normal_of(l, material, env, l->job->normals == NORMALS_eye);
    lower_mark_head(l->ir, value, ORIGIN_SLOTS + SLOT_coatNormal);
    return value;
}

Ref lower_slot(Lower *l, const Node *material, Slot slot, const Env *env)
{
    Ir *ir = l->ir;
    SlotValue *asked = &l->asked[slot];
    const bool beside = l->averaged;
    ir->origin = (uint32_t)(ORIGIN_SLOTS + slot);
    const bool known = asked->value && asked->material == material && asked->number == env->number;
    if (known && (l->averaged_below || !asked->averaged)) {
        l->averaged |= asked->averaged;
        return asked->value;
    }
    l->averaged = false;
    Ref value = slot == SLOT_normal ? finished_normal(l, normal_of(l, material, env, false), env)
                : slot == SLOT_coatNormal
                    ? coat_normal_of(l, material, env, false)
                    : lower_value_slot(l, material, lower_is_principled(l, material), slot, env);
    value = build_convert(ir, value, slot_table[slot].type);
    lower_mark_head(ir, value, ir->origin);
    *asked = (SlotValue){material, env->number, l->averaged, value};
    l->averaged |= beside;
    return value;
}
