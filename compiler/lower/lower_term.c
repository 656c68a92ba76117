/* Terms -> IR. Cases that GLSL leaves undefined are guarded here, so that every term is a finite
 * number for all arguments; opt_range removes guards that intervals prove needless.
 *
 *     u / (1 + v * v)   c = |1 + v v| < 1e-30; select(c, 0, u) / select(c, 1, 1 + v v). 1 + v v
 *     is at least 1, so it is u / (1 + v v) */
#include "compiler/lower/lower_term.h"
#include "compiler/ir/build_words.h"
#include "compiler/lower/map_value.h"
#include "compiler/lower/area.h"
#include "compiler/lower/cells.h"
#include "compiler/library/reference.h"
#include <float.h>
#include <math.h>

static const double MIN_DIVISOR = 1e-30, MIN_BASE = 1e-37, GREATEST_POWER = 1e37;

static const char *const component_name[] = {"x", "y", "z", "w"};

static Type wider(const Ir *ir, Ref a, Ref b)
{
    return ir_components(ir, a) > ir_components(ir, b) ? ir_type(ir, a) : ir_type(ir, b);
}

static Ref length(Ir *ir, Ref a)
{
    return ir_components(ir, a) == 1 ? build_abs(ir, a) : build_length(ir, a);
}

/* Applies a function of numbers to every component. */
typedef Ref OfNumbers(Lower *l, const Ref *x);
static Ref by_components(Lower *l, OfNumbers *of, const Ref *args, int count)
{
    Ir *ir = l->ir;
    Type type = TYPE_float;
    Ref component[4], x[3];
    for (int i = 0; i < count; i++)
        type =
            type_table[type].components > ir_components(ir, args[i]) ? type : ir_type(ir, args[i]);
    if (type == TYPE_float)
        return of(l, args);
    for (int k = 0; k < type_table[type].components; k++) {
        for (int i = 0; i < count; i++)
            x[i] = ir_components(ir, args[i]) == 1 ? args[i]
                                                   : build_swizzle(ir, args[i], component_name[k]);
        component[k] = of(l, x);
    }
    return build_vec_of(ir, type, component, type_table[type].components);
}

/* Returns true for a constant whose components are all far from 0. */
static bool is_far_from_zero(const Ir *ir, Ref a)
{
    const double *known = ir_is(ir, a, OP_const) ? ir_numbers(ir, a) : NULL;
    for (int i = 0; known && i < ir_components(ir, a); i++)
        if (fabs(known[i]) < MIN_DIVISOR)
            return false;
    return known != NULL;
}

static Ref is_no_divisor(Lower *l, Ref a)
{
    return build_lt(l->ir, build_abs(l->ir, a), build_float(l->ir, MIN_DIVISOR));
}

/* Guards both operands: unchanged where the divisor is far from 0, else 0 and 1. The operands
 * are guarded, not the quotient, since drivers may turn a selection into a product, and 0 times
 * infinity is NaN. */
static void guard_division(Lower *l, const Ref *x, Ref guarded[2])
{
    Ir *ir = l->ir;
    guarded[0] = x[0];
    guarded[1] = x[1];
    if (is_far_from_zero(ir, x[1]))
        return;
    Ref none = is_no_divisor(l, x[1]), zero = build_all(ir, ir_type(ir, x[0]), 0);
    guarded[0] = build_select(ir, none, zero, x[0]);
    guarded[1] = build_select(ir, none, build_all(ir, ir_type(ir, x[1]), 1), x[1]);
}

/* Returns a / b with a scalar divisor: one condition for all components. */
static Ref quotient_by_number(Lower *l, const Ref *x)
{
    Ref guarded[2];
    guard_division(l, x, guarded);
    return build_div_of(l->ir, guarded);
}

static Ref quotient(Lower *l, const Ref *x)
{
    if (ir_components(l->ir, x[1]) == 1 || is_far_from_zero(l->ir, x[1]))
        return quotient_by_number(l, x);
    return by_components(l, quotient_by_number, x, 2);
}

static Ref remainder_by_number(Lower *l, const Ref *x)
{
    Ref guarded[2];
    guard_division(l, x, guarded);
    return build_mod_of(l->ir, guarded);
}

static Ref remainder_of(Lower *l, const Ref *x)
{
    if (ir_components(l->ir, x[1]) == 1 || is_far_from_zero(l->ir, x[1]))
        return remainder_by_number(l, x);
    return by_components(l, remainder_by_number, x, 2);
}

/* Clamps the base so that its power by a constant is within GREATEST_POWER; an infinity never
 * occurs. */
static Ref power_by_number(Lower *l, Ref base, Ref exponent, double by)
{
    Ir *ir = l->ir;
    const double border = pow(GREATEST_POWER, 1 / by),
                 least_by = log(GREATEST_POWER) / log(FLT_MAX);
    Ref within = build_max(ir, base, build_float(ir, by < 0 ? fmax(border, MIN_BASE) : MIN_BASE));
    if (by > least_by) /* a lower exponent reaches the bound with no float */
        within = build_min(ir, within, build_float(ir, border));
    return build_pow(ir, within, exponent);
}

/* Returns the power of x[0] by x[1]. */
static Ref power(Lower *l, const Ref *x)
{
    Ir *ir = l->ir;
    const bool minus = ir_is(ir, x[1], OP_neg);
    const Ref number = minus ? ir_arg(ir, x[1], 0) : x[1];
    const double by =
        ir_is(ir, number, OP_const) && ir_components(ir, number) == 1 ? *ir_numbers(ir, number) : 0;
    if (by != 0)
        return power_by_number(l, x[0], x[1], minus ? -by : by);
    Ref raised = build_pow(ir, build_max(ir, x[0], build_float(ir, MIN_BASE)), x[1]);
    return build_min(ir, raised, build_float(ir, GREATEST_POWER));
}

/* Returns min(max(a, b), c); GLSL's clamp is undefined where b is above c. */
static Ref bounded(Lower *l, const Ref *x)
{
    Ir *ir = l->ir;
    const double *low = ir_is(ir, x[1], OP_const) ? ir_numbers(ir, x[1]) : NULL;
    const double *high = ir_is(ir, x[2], OP_const) ? ir_numbers(ir, x[2]) : NULL;
    if (low && high && ir_components(ir, x[1]) == 1 && ir_components(ir, x[2]) == 1 &&
        *low <= *high)
        return build_clamp_of(ir, x);
    return build_min(ir, build_max(ir, x[0], x[1]), x[2]);
}

static Ref within(Lower *l, Ref a, double low, double high)
{
    Ir *ir = l->ir;
    return build_clamp(ir, a, build_float(ir, low), build_float(ir, high));
}

/* Returns the position of x between `low` and `high`, in [0, 1]. */
static Ref share(Lower *l, const Ref *x)
{
    Ir *ir = l->ir;
    Ref way = build_sub(ir, x[1], x[0]), gone = build_sub(ir, x[2], x[0]);
    return within(l, quotient(l, (Ref[]){gone, way}), 0, 1);
}

static Ref smooth(Lower *l, Ref t)
{
    Ir *ir = l->ir;
    return MUL(MUL(t, t), SUB(K(3), TWICE(t)));
}

/* Combines all components by a binary operation, from the first to the last. */
static Ref over_components(Lower *l, Op op, Ref a)
{
    Ir *ir = l->ir;
    Ref result = ir_components(ir, a) > 1 ? build_swizzle(ir, a, component_name[0]) : a;
    for (int i = 1; i < ir_components(ir, a); i++)
        result = build_binary(ir, op, result, build_swizzle(ir, a, component_name[i]));
    return result;
}

static Ref dot(Lower *l, const Ref *x)
{
    Ir *ir = l->ir;
    const Type type = wider(ir, x[0], x[1]);
    if (type == TYPE_float)
        return build_mul_of(ir, x);
    return build_dot(ir, build_splat(ir, x[0], type), build_splat(ir, x[1], type));
}

static Ref average(Lower *l, Ref a)
{
    Ir *ir = l->ir;
    return ir_components(ir, a) == 1
               ? a
               : build_dot(ir, a, build_all(ir, ir_type(ir, a), 1.0 / ir_components(ir, a)));
}

static Ref turned(Lower *l, const Ref *x)
{
    Ir *ir = l->ir;
    Ref c = build_cos(ir, x[1]), s = build_sin(ir, x[1]), zero = build_float(ir, 0);
    Ref a = build_vec(ir, TYPE_vec2, c, s), b = build_vec(ir, TYPE_vec2, build_sub(ir, zero, s), c);
    return build_linear(ir, (Ref[]){x[0], a, b}, 3);
}

/* Converts HSV to RGB, hue in turns: each component is 1 within a sixth of a turn around its own
 * hue. */
static Ref rgb(Lower *l, Ref hsv)
{
    Ir *ir = l->ir;
    Ref h = build_swizzle(ir, hsv, "x"), s = build_swizzle(ir, hsv, "y"),
        v = build_swizzle(ir, hsv, "z");
    Ref turn = build_fract(ir, build_add(ir, h, build_vec3(ir, 0, 2.0 / 3, 1.0 / 3)));
    Ref away = build_abs(ir, SUB(SCALED(turn, 6), K(3)));
    Ref full = within(l, SUB(away, K(1)), 0, 1);
    return MUL(v, build_mix(ir, build_vec3(ir, 1, 1, 1), full, s));
}

/* Converts RGB to HSV. The greatest component selects the third of the hue circle, the other two
 * the position in the third. */
static Ref hsv(Lower *l, Ref rgb)
{
    Ir *ir = l->ir;
    Ref r = build_swizzle(ir, rgb, "x"), g = build_swizzle(ir, rgb, "y"),
        b = build_swizzle(ir, rgb, "z");
    Ref most = over_components(l, OP_max, rgb), spread = SUB(most, over_components(l, OP_min, rgb));
    Ref by_r = SUB(g, b), by_g = SUB(b, r), by_b = SUB(r, g);
    Ref is_r = build_eq(ir, most, r), is_g = build_eq(ir, most, g);
    Ref difference = build_select(ir, is_r, by_r, build_select(ir, is_g, by_g, by_b));
    Ref from = build_select(ir, is_r, K(0), build_select(ir, is_g, K(2), K(4)));
    Ref sixth = ADD(from, quotient(l, REFS(ir, difference, spread)));
    Ref grey = is_no_divisor(l, spread);
    Ref hue = build_select(ir, grey, K(0), build_fract(ir, SCALED(sixth, 1.0 / 6)));
    return build_vec(ir, TYPE_vec3, hue, quotient(l, REFS(ir, spread, most)), most);
}

/* Octaves of noise at a position; over the pixel where maps are averaged. */
static Ref octaves(Lower *l, bool vector, Ref p, const Ref *args)
{
    const MapValue at = map_value_of(build_splat(l->ir, p, TYPE_vec3));
    return (vector ? area_vector_turbulence(l, at, args) : area_turbulence(l, at, args)).value;
}

/* Returns |noise| of one octave. The variance that the pixel leaves out contributes to the mean
 * as if it were normally distributed: 2.3 % off where all is left out. */
static Ref folded_octave(Lower *l, Ref p)
{
    Ir *ir = l->ir;
    /* Square of the mean over the variance: 2 / pi for a normal distribution, 0.68 and 0.63 for
     * noise. */
    const double share = .65;
    const Ref single = build_int(ir, 1), two = build_float(ir, 2), half = build_float(ir, .5);
    const Ref one_octave[] = {single, two, half};
    const MapValue noise = area_turbulence(l, map_value_of(p), one_octave);
    if (!noise.variance)
        return build_abs(ir, noise.value);
    Ref square = build_square(ir, noise.value);
    return build_sqrt(ir, build_add(ir, square, build_scale(ir, noise.variance, share)));
}

/* Returns the sum of octaves of |noise|. Arguments: position, octaves, factor on the frequency,
 * factor on the amplitude. */
static Ref folded(Lower *l, const Ref *x)
{
    Ir *ir = l->ir;
    Ref p = build_splat(ir, x[0], TYPE_vec3), strength = x[3], sum = folded_octave(l, p);
    for (int k = 1; k < *ir_numbers(ir, x[1]); k++) {
        p = build_mul(ir, p, x[2]);
        Ref octave = folded_octave(l, p);
        sum = build_add(ir, sum, build_mul(ir, octave, strength));
        strength = build_mul(ir, strength, x[3]);
    }
    return sum;
}

static Ref count(Lower *l, Ref number)
{
    /* the number is a literal of the formula */
    return build_int(l->ir, ir_numbers(l->ir, number)[0]);
}

/* Calls a scalar library function for every component. */
static Ref each(Lower *l, Function function, Ref a)
{
    Ir *ir = l->ir;
    Ref component[4];
    if (ir_components(ir, a) == 1)
        return build_call(ir, function, a);
    for (int i = 0; i < ir_components(ir, a); i++) {
        component[i] = build_swizzle(ir, a, component_name[i]);
        component[i] = build_call(ir, function, component[i]);
    }
    return build_vec_of(ir, ir_type(ir, a), component, ir_components(ir, a));
}

/* Returns b where the condition holds, else c, in the wider of both types. */
static Ref chosen(Lower *l, const Ref *x)
{
    Ir *ir = l->ir;
    const Type type = wider(ir, x[1], x[2]);
    return build_select(ir, x[0], build_splat(ir, x[1], type), build_splat(ir, x[2], type));
}

/* Returns 1 where the sum of both components' floors is odd: where one floor is odd and the
 * other is not. */
static Ref odd(Lower *l, Ref uv)
{
    Ir *ir = l->ir;
    Ref parity = build_mod(ir, build_floor(ir, uv), K(2));
    return UNARY(abs, SUB(build_swizzle(ir, parity, "x"), build_swizzle(ir, parity, "y")));
}

static Ref three(Lower *l, Ref a) { return build_splat(l->ir, a, TYPE_vec3); }

Ref lower_whole_power(Lower *l, Ref a, int power)
{
    Ir *ir = l->ir;
    Ref product = 0, square = a;
    for (int left = power < 0 ? -power : power; left; left >>= 1) {
        if (left & 1)
            product = product ? build_mul(ir, product, square) : square;
        if (left > 1)
            square = build_square(ir, square);
    }
    if (!product)
        return build_all(ir, ir_type(ir, a), 1);
    return power < 0 ? quotient(l, REFS(ir, build_float(ir, 1), product)) : product;
}

/* Evaluates MaterialX's noises in three dimensions, averaged over the pixel like the maps
 * CellNoise and Worley. */
static Ref cell_noise(Lower *l, Ref p)
{
    Ref dimensions = build_int(l->ir, 3);
    return area_volume(l, KIND_CellNoise, map_value_of(p), &dimensions, 1).value;
}

static Ref worley(Lower *l, Ref p)
{
    Ir *ir = l->ir;
    Ref jitter = build_float(ir, 1), style = build_int(ir, 0), dimensions = build_int(ir, 3);
    return area_volume(l, KIND_Worley, map_value_of(p), (const Ref[]){jitter, style, dimensions}, 3)
        .value;
}

#define CELL_NOISE(a)              cell_noise(l, three(l, a))
#define WORLEY(a)                  worley(l, three(l, a))
#define QUOTIENT(a, b)             quotient(l, REFS(ir, a, b))
#define REMAINDER(a, b)            remainder_of(l, REFS(ir, a, b))
#define ROOT(a)                    build_sqrt(ir, MAX(a, K(0)))
#define AT_MOST(a, most)           build_min(ir, a, K(most))
#define AT_LEAST(a, least)         MAX(a, K(least))
#define WITHIN(a, low, high)       within(l, a, low, high)
#define BETWEEN(a, b, c)           bounded(l, REFS(ir, a, b, c))
#define POWER(a, b)                power(l, REFS(ir, a, b))
#define SHARE(a, b, c)             share(l, REFS(ir, a, b, c))
#define SMOOTH(t)                  smooth(l, t)
#define COMPONENTS(op, a)          over_components(l, OP_##op, a)
#define DOT(a, b)                  dot(l, REFS(ir, a, b))
#define LENGTH(a)                  length(ir, a)
#define AVERAGE(a)                 average(l, a)
#define UNIT(a)                    build_call(ir, FN_safeNormalize, three(l, a))
#define TURNED(a, b)               turned(l, REFS(ir, a, b))
#define RGB(a)                     rgb(l, three(l, a))
#define HSV(a)                     hsv(l, three(l, a))
#define CHOSEN(a, b, c)            chosen(l, REFS(ir, a, b, c))
#define THREE(a)                   three(l, a)
#define ODD(uv)                    odd(l, uv)
#define EACH(function, a)          each(l, FN_##function, a)
#define CELLS(a, edge)             cells_of(l, three(l, a), edge)
#define COUNT(b)                   count(l, b)
#define OCTAVES(p, n, c, d)        octaves(l, false, p, REFS(ir, n, c, d))
#define FOLDED(p, n, c, d)         folded(l, REFS(ir, p, n, c, d))
#define VECTOR_OCTAVES(p, n, c, d) octaves(l, true, p, REFS(ir, n, c, d))

Ref lower_term(Lower *l, Term term, const Ref *args)
{
    Ir *ir = l->ir;
    Ref a = args[0], b = args[1], c = args[2], d = args[3], e = args[4];
    switch (term) {
#define BUILD(name, built)                                                                         \
    case TERM_##name:                                                                              \
        return built;
#include "grammar/expression.def"
    default:
        return a;
    }
}
