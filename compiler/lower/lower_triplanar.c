/* Triplanar projection: its maps are sampled three times, with two of the position's components
 * as u and v.
 *
 *     p = (.2, .3, .7), n = (.1, .6, .79), sharpness 2: shares .01, .36 and .63; x has less than
 *     1/64 and does not count; y is sampled at u = .2, v = .7 and weighs (.36 - 1/64) / (.99 -
 *     2/64) = .36, z at (.2, .3) weighs .64 */
#include "compiler/lower/map_value.h"
#include "compiler/lower/blend.h"
#include "compiler/lower/slope.h"

enum { AXES = 3 };
static const double TRIPLANAR_MIN_SHARE = 1 / 64.; /* min weight of an axis: semantics.md 2.5 */

static const int maps_of[AXES] = {P_Triplanar_x, P_Triplanar_y, P_Triplanar_z};

/* Returns the map of an axis, or of the next axis that has one. */
static const Node *projected_map(const Node *node, int axis)
{
    for (int i = 0; i < AXES; i++) {
        const Node *map = lower_param_node(node, maps_of[(axis + i) % AXES]);
        if (map)
            return map;
    }
    return NULL;
}

static int place_number(Lower *l, Place place)
{
    const uint32_t hash = place.uv * 0x9E3779B1u ^ (uint32_t)place.outer * 0x85EBCA6Bu;
    for (HashProbe probe = hash_probe(&l->place_index, hash); hash_probe_next(&probe);)
        if (l->places[probe.number].uv == place.uv && l->places[probe.number].outer == place.outer)
            return (int)probe.number;
    hash_index_add(l->session->arena, &l->place_index, hash, (uint32_t)l->place_count);
    ARENA_PUSH(l->session->arena, l->places, l->place_count, l->place_capacity, place);
    return (int)l->place_count - 1;
}

/* Returns the environment of an axis. Equal texture coordinates in equal environments share an
 * environment number, so that nested Triplanars, which read one position, have three of them in
 * total. */
static Env projected_env(Lower *l, const Env *env, MapValue p, int axis)
{
    static const char *const components[AXES] = {"yz", "xz", "xy"};
    Env made = *env;
    made.root[GROUP_U] = build_vec(
        l->ir, TYPE_vec3, build_swizzle(l->ir, p.value, components[axis]), build_float(l->ir, 0));
    made.number = (place_number(l, (Place){made.root[GROUP_U], env->number}) + 1) * PLACE_STRIDE +
                  env->number % PLACE_STRIDE;
    return made;
}

/* Returns the weights of the axes: |n|^k of the unit normal, as a share of the sum; the excess
 * over TRIPLANAR_MIN_SHARE counts. The weights count as constant when the map is
 * differentiated. */
static Ref weights_of(Lower *l, Ref p, Ref sharpness)
{
    Ir *ir = l->ir;
    const double least = 1e-37; /* min divisor, a normal (not denormal) float */
    Ref by_u = build_or_zero(ir, slope_detached(l, p, DIRECTION_u), TYPE_vec3);
    Ref by_v = build_or_zero(ir, slope_detached(l, p, DIRECTION_v), TYPE_vec3);
    Ref normal = build_call(ir, FN_safeNormalize, build_cross(ir, by_u, by_v));
    Ref base = build_max(ir, build_abs(ir, normal), build_all(ir, TYPE_vec3, least));
    Ref weight = build_pow(ir, base, build_splat(ir, sharpness, TYPE_vec3));
    const Ref ones = build_all(ir, TYPE_vec3, 1), sum = build_dot(ir, weight, ones);
    Ref share =
        build_sub(ir, build_div(ir, weight, sum), build_all(ir, TYPE_vec3, TRIPLANAR_MIN_SHARE));
    share = build_max(ir, share, build_all(ir, TYPE_vec3, 0));
    return build_div(ir, share, build_dot(ir, share, ones));
}

MapValue lower_Triplanar(Lower *l, const Node *node, Group group, const Env *env)
{
    static const char *const component[AXES] = {"x", "y", "z"};
    Ir *ir = l->ir;
    if (!projected_map(node, 0))
        return map_value_as_group(l, map_value_of(build_float(ir, 0)), group);
    const MapValue p = lower_map_value(l, lower_param_node(node, P_Triplanar_input), GROUP_X, env);
    const Ref weight =
        weights_of(l, p.value, lower_param(l, node_param(node, P_Triplanar_sharpness), TYPE_float));
    MapValue side[AXES], sum = {0};
    Type type = TYPE_float;
    for (int i = 0; i < AXES; i++) {
        const Env there = projected_env(l, env, p, i);
        side[i] = lower_arm(l, projected_map(node, i), GROUP_R, &there);
        type = i ? map_value_common_type(type, ir_type(ir, side[i].value))
                 : ir_type(ir, side[i].value);
    }
    for (int i = 0; i < AXES; i++) {
        const Ref share = build_swizzle(ir, weight, component[i]);
        MapValue own = map_value_widened(l, side[i], type);
        const bool shared = side[i].value == side[(i + 1) % AXES].value ||
                            side[i].value == side[(i + 2) % AXES].value;
        if (l->cheap && !shared && blend_is_costly(ir, own.value) && !ir_is(ir, share, OP_const))
            own.value = blend_guarded(l, build_lt(ir, build_float(ir, 0), share), own.value);
        const MapValue part = map_value_scaled(l, own, share);
        sum = i ? map_value_sum(l, sum, part) : part;
    }
    return map_value_as_group(l, map_value_of(sum.value), group);
}
