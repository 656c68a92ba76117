/* Arithmetic between maps: Mix, Add, Multiply, Remap, Clamp, Power, Contrast, HSV, Combine,
 * Separate. They operate on colors, per component; alpha is that of the first operand, except
 * for Mix, which mixes it. The variance that a mean leaves out passes through linear operations,
 * and through Multiply as for a product of means. A nonlinear operation is applied to both
 * halves of a split value:
 *
 *     Clamp to [0, 1] of a Checker of 3 and -1, with .25 and .75 of a pixel: the mean of 1 and 0
 *     by these weights is .25; the mean itself, 0, would be clamped to 0 */
#include "compiler/lower/map_value.h"
#include "compiler/lower/lower_term.h"

enum { MAX_HALVINGS = 3 }; /* nesting depth of halves: each level doubles the computation */

/* Returns a color of one, three or four components, with its split. */
static MapValue whole_colour(Lower *l, const Node *node, int param, const Env *env)
{
    MapValue answer = lower_map_value(l, lower_param_node(node, param), GROUP_R, env);
    return ir_type(l->ir, answer.value) == TYPE_vec2 ? map_value_widened(l, answer, TYPE_vec3)
                                                     : answer;
}

static MapValue colour(Lower *l, const Node *node, int param, const Env *env)
{
    MapValue answer = whole_colour(l, node, param, env);
    answer.split = NULL;
    return answer;
}

/* Returns the red component of a parameter as a number. */
static Ref number(Lower *l, const Node *node, int param, const Env *env)
{
    return build_swizzle(l->ir, colour(l, node, param, env).value, "x");
}

/* Replaces the alpha, if there is one, by another color's. */
static MapValue with_alpha(Lower *l, MapValue answer, Ref from)
{
    Ir *ir = l->ir;
    if (ir_type(ir, answer.value) != TYPE_vec4)
        return answer;
    Ref alpha = build_convert(ir, from, TYPE_vec4);
    answer.value = build_vec(ir, TYPE_vec4, build_swizzle(ir, answer.value, "xyz"),
                             build_swizzle(ir, alpha, "w"));
    if (answer.variance)
        answer.variance =
            build_vec(ir, TYPE_vec4, build_swizzle(ir, answer.variance, "xyz"), build_float(ir, 0));
    return (MapValue){answer.value, answer.variance, NULL};
}

/* Two colors, converted to their common type. */
typedef struct {
    MapValue a, b;
} Pair;

static Pair pair(Lower *l, const Node *node, int param, const Env *env)
{
    MapValue a = colour(l, node, param, env), b = colour(l, node, param + 1, env);
    const Type type = map_value_common_type(ir_type(l->ir, a.value), ir_type(l->ir, b.value));
    a = map_value_widened(l, a, type);
    b = map_value_widened(l, b, type);
    return (Pair){a, b};
}

/* Converts to another group's value. */
static MapValue given(Lower *l, MapValue answer, Group group)
{
    return map_value_as_group(l, answer, group);
}

/* Lowers a Mix: a + t (b - a). */
MapValue lower_Mix(Lower *l, const Node *node, Group group, const Env *env)
{
    Ir *ir = l->ir;
    const Pair p = pair(l, node, P_Mix_a, env);
    Ref t = number(l, node, P_Mix_amount, env), rest = build_sub(ir, build_float(ir, 1), t);
    MapValue mix = map_value_of(build_mix(ir, p.a.value, p.b.value, t));
    Ref of_a = p.a.variance ? build_mul(ir, p.a.variance, build_square(ir, rest)) : 0;
    Ref of_b = p.b.variance ? build_mul(ir, p.b.variance, build_square(ir, t)) : 0;
    mix.variance = build_plus(ir, of_a, of_b);
    return given(l, mix, group);
}

MapValue lower_Add(Lower *l, const Node *node, Group group, const Env *env)
{
    const Pair p = pair(l, node, P_Add_a, env);
    return given(l, with_alpha(l, map_value_sum(l, p.a, p.b), p.a.value), group);
}

MapValue lower_Multiply(Lower *l, const Node *node, Group group, const Env *env)
{
    Ir *ir = l->ir;
    const Pair p = pair(l, node, P_Multiply_a, env);
    MapValue product = map_value_of(build_mul(ir, p.a.value, p.b.value));
    Ref of_a = p.a.variance ? build_mul(ir, p.a.variance, build_square(ir, p.b.value)) : 0;
    Ref of_b = p.b.variance ? build_mul(ir, p.b.variance, build_square(ir, p.a.value)) : 0;
    product.variance = build_plus(ir, of_a, of_b);
    return given(l, with_alpha(l, product, p.a.value), group);
}

/* Returns (x - from) * by + to. */
static MapValue line(Lower *l, MapValue x, Ref from, const Ref by_to[2])
{
    MapValue moved = map_value_moved(l, x, build_neg(l->ir, from));
    return with_alpha(l, map_value_moved(l, map_value_scaled(l, moved, by_to[0]), by_to[1]),
                      x.value);
}

MapValue lower_Remap(Lower *l, const Node *node, Group group, const Env *env)
{
    Ir *ir = l->ir;
    MapValue x = colour(l, node, P_Remap_input, env);
    Ref low = number(l, node, P_Remap_low, env), high = number(l, node, P_Remap_high, env);
    Ref to_low = number(l, node, P_Remap_toLow, env),
        to_high = number(l, node, P_Remap_toHigh, env);
    Ref width = build_sub(ir, high, low), rise = build_sub(ir, to_high, to_low);
    /* the rate is 0 where the width is 0 */
    Ref rate = lower_term(l, TERM_divide, (const Ref[TERM_MAX_ARGUMENTS]){rise, width});
    return given(l, line(l, x, low, (const Ref[]){rate, to_low}), group);
}

MapValue lower_Contrast(Lower *l, const Node *node, Group group, const Env *env)
{
    MapValue x = colour(l, node, P_Contrast_input, env);
    Ref amount = number(l, node, P_Contrast_amount, env),
        pivot = number(l, node, P_Contrast_pivot, env);
    return given(l, line(l, x, pivot, (const Ref[]){amount, pivot}), group);
}

/* A nonlinear function with its parameters. */
typedef struct {
    Ref (*of)(Lower *l, Ref x, const Ref *numbers);
    Ref numbers[3];
} Curve;

/* Applies the curve to both halves of a split. In a displacement the halves are heights, whose
 * mix the curve is applied to. */
static MapValue curved(Lower *l, const Curve *curve, MapValue x, int depth)
{
    if (!x.split || depth == 0 || l->relief)
        return with_alpha(l, map_value_of(curve->of(l, x.value, curve->numbers)), x.value);
    const Split *split = x.split;
    const MapValue a = curved(l, curve, split->a, depth - 1),
                   b = curved(l, curve, split->b, depth - 1);
    return map_value_either(l, split->by, a, b);
}

static Ref clamped(Lower *l, Ref x, const Ref *low_high)
{
    Ir *ir = l->ir;
    const Type type = ir_type(ir, x);
    return build_min(ir, build_max(ir, x, build_splat(ir, low_high[0], type)),
                     build_splat(ir, low_high[1], type));
}

MapValue lower_Clamp(Lower *l, const Node *node, Group group, const Env *env)
{
    const MapValue x = whole_colour(l, node, P_Clamp_input, env);
    const Ref low = number(l, node, P_Clamp_low, env), high = number(l, node, P_Clamp_high, env);
    return given(l, curved(l, &(Curve){clamped, {low, high}}, x, MAX_HALVINGS), group);
}

/* Returns x to the power of `exponent`, with x bounded so that the power is at most 1e37.
 * lower_term() reads all arguments that a term may have. */
static Ref raised(Lower *l, Ref x, const Ref *exponent)
{
    Ir *ir = l->ir;
    if (!ir_is(ir, *exponent, OP_const)) { /* lower_term() bounds a constant exponent */
        Ref one = build_float(ir, 1),
            border = build_pow(ir, build_float(ir, 1e37),
                               build_div(ir, one, build_max(ir, *exponent, one)));
        x = build_min(ir, x, build_splat(ir, border, ir_type(ir, x)));
    }
    return lower_term(l, TERM_pow, (const Ref[TERM_MAX_ARGUMENTS]){x, *exponent});
}

static Ref term_of(Lower *l, Term term, Ref x)
{
    return lower_term(l, term, (const Ref[TERM_MAX_ARGUMENTS]){x});
}

MapValue lower_Power(Lower *l, const Node *node, Group group, const Env *env)
{
    const MapValue x = whole_colour(l, node, P_Power_input, env);
    const ParamRow *row = &param_table[P_Power_exponent];
    Ref low = build_float(l->ir, row->low), high = build_float(l->ir, row->high);
    Ref exponent = build_clamp(l->ir, number(l, node, P_Power_exponent, env), low, high);
    return given(l, curved(l, &(Curve){raised, {exponent}}, x, MAX_HALVINGS), group);
}

/* Changes hue, saturation and value; a fourth component, if any, is a placeholder for the
 * color's own alpha. */
static Ref turned(Lower *l, Ref x, const Ref *by)
{
    Ir *ir = l->ir;
    Ref rgb = build_convert(ir, x, TYPE_vec3), hsv = term_of(l, TERM_rgbtohsv, rgb);
    Ref zero = build_float(ir, 0), one = build_float(ir, 1);
    hsv = build_add(ir, hsv, build_vec(ir, TYPE_vec3, by[0], zero, zero));
    hsv = build_mul(ir, hsv, build_vec(ir, TYPE_vec3, one, by[1], by[2]));
    rgb = term_of(l, TERM_hsvtorgb, hsv);
    return ir_type(ir, x) == TYPE_vec4 ? build_convert(ir, rgb, TYPE_vec4) : rgb;
}

MapValue lower_HSV(Lower *l, const Node *node, Group group, const Env *env)
{
    const MapValue x = whole_colour(l, node, P_HSV_input, env);
    const Ref hue = number(l, node, P_HSV_hue, env),
              saturation = number(l, node, P_HSV_saturation, env),
              value = number(l, node, P_HSV_value, env);
    return given(l, curved(l, &(Curve){turned, {hue, saturation, value}}, x, MAX_HALVINGS), group);
}

MapValue lower_Combine(Lower *l, const Node *node, Group group, const Env *env)
{
    Ir *ir = l->ir;
    Ref r = number(l, node, P_Combine_r, env), g = number(l, node, P_Combine_g, env),
        b = number(l, node, P_Combine_b, env);
    return given(l, map_value_of(build_vec(ir, TYPE_vec3, r, g, b)), group);
}

/* Lowers a Separate: a component of a color that is widened to four. */
MapValue lower_Separate(Lower *l, const Node *node, Group group, const Env *env)
{
    static const char *const components[] = {"x", "y", "z", "w"};
    const int component =
        (int)node_param(node, P_Separate_channel)->number[0] - (int)KEYWORD_Channel_r;
    MapValue x = colour(l, node, P_Separate_input, env);
    return given(l, map_value_swizzle(l, map_value_widened(l, x, TYPE_vec4), components[component]),
                 group);
}
