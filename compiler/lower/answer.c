/* Means and their variances: those of sums add, those of products with a number are multiplied by its square. */
#include "compiler/lower/answer.h"
#include "compiler/lower/footprint.h"

static Ref zero_of(Lower *l, Type type) { return ir_const(l->ir, type, (double[4]){0}); }

Type answer_common_type(Type a, Type b)
{
    if ((a == TYPE_float && b == TYPE_vec2) || (a == TYPE_vec2 && b == TYPE_float))
        return TYPE_vec3;
    return type_table[a].lanes > type_table[b].lanes ? a : b;
}

Answer answer_swizzle(Lower *l, Answer a, const char *lanes)
{
    Answer part = answer_of(ir_swizzle(l->ir, a.value, lanes));
    if (a.variance)
        part.variance = ir_swizzle(l->ir, a.variance, lanes);
    return part;
}

/* An alpha that the conversion adds does not vary. */
Answer answer_widened(Lower *l, Answer a, Type type)
{
    if (ir_type(l->ir, a.value) == type)
        return a;
    Answer wide = answer_of(ir_convert(l->ir, a.value, type));
    if (!a.variance)
        return wide;
    wide.variance = ir_convert(l->ir, a.variance, type == TYPE_vec4 ? TYPE_vec3 : type);
    if (type == TYPE_vec4)
        wide.variance = ir_vec(l->ir, type, REFS(l->ir, wide.variance, number(l, 0)), 2);
    return wide;
}

Answer answer_as_group(Lower *l, Answer a, Group group)
{
    if (group == GROUP_R)
        return a;
    return group == GROUP_IOR ? answer_swizzle(l, a, "x") : answer_widened(l, a, TYPE_vec3);
}

Answer answer_moved(Lower *l, Answer a, Ref by)
{
    Ref value = add(l, a.value, by);
    return (Answer){value, a.variance, NULL};
}

Answer answer_scaled(Lower *l, Answer a, Ref factor)
{
    Answer scaled = answer_of(mul(l, a.value, factor));
    if (a.variance)
        scaled.variance = mul(l, a.variance, mul(l, factor, factor));
    return scaled;
}

Answer answer_dot(Lower *l, Answer a, Ref factors)
{
    Answer sum = answer_of(ir_binary(l->ir, OP_dot, a.value, factors));
    if (a.variance)
        sum.variance = ir_binary(l->ir, OP_dot, a.variance, mul(l, factors, factors));
    return sum;
}

Answer answer_sum(Lower *l, Answer a, Answer b)
{
    Answer sum = answer_of(add(l, a.value, b.value));
    sum.variance = !a.variance ? b.variance : !b.variance ? a.variance : add(l, a.variance, b.variance);
    return sum;
}

Ref answer_mean(Lower *l, Ref by, Ref a, Ref b)
{
    return ir_type(l->ir, by) == TYPE_bool ? ir_select(l->ir, by, a, b) : ir_ternary(l->ir, OP_mix, b, a, by);
}

/* Both variances, each by its share; how far the two are apart is the split's to tell. A share may be a rounding beyond 0 or 1, a
 * variance never below 0. */
static Ref either_variance(Lower *l, Ref by, const Answer *a, const Answer *b)
{
    if (!a->variance && !b->variance)
        return 0;
    Ref none = zero_of(l, ir_type(l->ir, a->value));
    if (ir_type(l->ir, by) != TYPE_bool)
        by = ir_ternary(l->ir, OP_clamp, by, number(l, 0), number(l, 1));
    return answer_mean(l, by, a->variance ? a->variance : none, b->variance ? b->variance : none);
}

Answer answer_either(Lower *l, Ref by, Answer a, Answer b)
{
    Type type = answer_common_type(ir_type(l->ir, a.value), ir_type(l->ir, b.value));
    a = answer_widened(l, a, type);
    b = answer_widened(l, b, type);
    Answer either = answer_of(answer_mean(l, by, a.value, b.value));
    if (!footprint_is_filtered(l))
        return either;
    Split *split = ARENA_NEW(l->session->arena, Split);
    *split = (Split){by, a, b};
    either.variance = either_variance(l, by, &a, &b);
    either.split = split;
    return either;
}
