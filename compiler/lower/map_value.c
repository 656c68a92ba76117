/* Means and their variances: variances of sums add, those of products with a number are
 * multiplied by its square. */
#include "compiler/lower/map_value.h"
#include "compiler/lower/footprint.h"

Type map_value_common_type(Type a, Type b)
{
    if ((a == TYPE_float && b == TYPE_vec2) || (a == TYPE_vec2 && b == TYPE_float))
        return TYPE_vec3;
    return type_table[a].components > type_table[b].components ? a : b;
}

MapValue map_value_swizzle(Lower *l, MapValue a, const char *components)
{
    Ir *ir = l->ir;
    MapValue part = map_value_of(build_swizzle(ir, a.value, components));
    if (a.variance)
        part.variance = build_swizzle(ir, a.variance, components);
    return part;
}

/* Converts a value to a type with more components. An alpha that the conversion adds is
 * constant. */
MapValue map_value_widened(Lower *l, MapValue a, Type type)
{
    Ir *ir = l->ir;
    if (ir_type(ir, a.value) == type)
        return a;
    MapValue wide = map_value_of(build_convert(ir, a.value, type));
    if (!a.variance)
        return wide;
    wide.variance = build_convert(ir, a.variance, type == TYPE_vec4 ? TYPE_vec3 : type);
    if (type == TYPE_vec4)
        wide.variance = build_vec(ir, type, wide.variance, build_float(ir, 0));
    return wide;
}

MapValue map_value_as_group(Lower *l, MapValue a, Group group)
{
    if (group == GROUP_R)
        return a;
    return group == GROUP_IOR ? map_value_swizzle(l, a, "x") : map_value_widened(l, a, TYPE_vec3);
}

MapValue map_value_moved(Lower *l, MapValue a, Ref by)
{
    Ref value = build_add(l->ir, a.value, by);
    return (MapValue){value, a.variance, NULL};
}

MapValue map_value_scaled(Lower *l, MapValue a, Ref factor)
{
    Ir *ir = l->ir;
    MapValue scaled = map_value_of(build_mul(ir, a.value, factor));
    if (a.variance)
        scaled.variance = build_mul(ir, a.variance, build_square(ir, factor));
    return scaled;
}

MapValue map_value_dot(Lower *l, MapValue a, Ref factors)
{
    Ir *ir = l->ir;
    MapValue sum = map_value_of(build_dot(ir, a.value, factors));
    if (a.variance)
        sum.variance = build_dot(ir, a.variance, build_square(ir, factors));
    return sum;
}

MapValue map_value_sum(Lower *l, MapValue a, MapValue b)
{
    Ir *ir = l->ir;
    MapValue sum = map_value_of(build_add(ir, a.value, b.value));
    sum.variance = build_plus(ir, a.variance, b.variance);
    return sum;
}

Ref map_value_mean(Lower *l, Ref by, Ref a, Ref b)
{
    Ir *ir = l->ir;
    return ir_type(ir, by) == TYPE_bool ? build_select(ir, by, a, b) : build_mix(ir, b, a, by);
}

/* Returns the variance of both sides, each weighted by its share; the split accounts for the
 * distance between their means. A share may exceed [0, 1] by rounding, but a variance is never
 * negative. */
static Ref either_variance(Lower *l, Ref by, const MapValue *a, const MapValue *b)
{
    Ir *ir = l->ir;
    if (!a->variance && !b->variance)
        return 0;
    Ref none = build_all(ir, ir_type(ir, a->value), 0);
    if (ir_type(ir, by) != TYPE_bool)
        by = build_clamp(ir, by, build_float(ir, 0), build_float(ir, 1));
    return map_value_mean(l, by, a->variance ? a->variance : none,
                          b->variance ? b->variance : none);
}

Ref map_value_alpha(Lower *l, Ref color)
{
    if (!l->cheap || ir_components(l->ir, color) < 4)
        return 0;
    Ref alpha = build_swizzle(l->ir, color, "w");
    return ir_is(l->ir, alpha, OP_const) ? alpha : 0;
}

/* Mixes two colors. A constant alpha that both colors have is kept, and only three components
 * are mixed, so that an opaque result stays opaque. */
static Ref mean_of_colors(Lower *l, Ref by, Ref a, Ref b)
{
    Ir *ir = l->ir;
    Ref alpha = map_value_alpha(l, a);
    if (!alpha || map_value_alpha(l, b) != alpha ||
        (ir_is(ir, a, OP_const) && ir_is(ir, b, OP_const)))
        return map_value_mean(l, by, a, b);
    Ref of_a = build_swizzle(ir, a, "xyz"), of_b = build_swizzle(ir, b, "xyz");
    return build_vec(ir, TYPE_vec4, map_value_mean(l, by, of_a, of_b), alpha);
}

MapValue map_value_either(Lower *l, Ref by, MapValue a, MapValue b)
{
    Type type = map_value_common_type(ir_type(l->ir, a.value), ir_type(l->ir, b.value));
    a = map_value_widened(l, a, type);
    b = map_value_widened(l, b, type);
    MapValue either = map_value_of(mean_of_colors(l, by, a.value, b.value));
    if (!footprint_is_filtered(l) && !l->relief)
        return either;
    Split *split = ARENA_NEW(l->session->arena, Split);
    *split = (Split){by, a, b};
    either.variance = either_variance(l, by, &a, &b);
    either.split = split;
    return either;
}
