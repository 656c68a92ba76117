/* Meaning of the names and operators of formulas, from mathematics, in long double: for
 * test_expression.c. Uses no code of matc. */
#ifndef MATC_FORMULA_RULES_H
#define MATC_FORMULA_RULES_H
#include <math.h>
#include <stdbool.h>

typedef long double Number;
/* A rule of the tree generator: the form of the text, its precedence, the widths of its parts
 * ('g': equal to the rule's own), the width of its result, its components. */
typedef struct Rule {
    const char *form; /* a function's name, or an operator between its parts */
    int level;        /* precedence of an operator; 0: a call */
    const char *parts;
    int width; /* 0: a condition, -1: the width of the 'g' parts */
    Number (*component)(const Number *x);
    void (*whole)(const Number x[5][4], int components, Number *result);
} Rule;

#define RULE_COMPONENT(name, value)                                                                \
    static Number name(const Number *x) { return value; }
static Number over(Number a, Number b) { return fabsl(b) < 1e-30L ? 0 : a / b; }
static Number cut(Number a, Number low, Number high) { return a < low ? low : a > high ? high : a; }
static Number ramp(Number low, Number high, Number x)
{
    return cut(over(x - low, high - low), 0, 1);
}
static Number signum(Number a) { return a > 0 ? 1 : a < 0 ? -1 : 0; }
static Number raised(Number a, Number b) { return fminl(powl(fmaxl(a, 1e-37L), b), 1e37L); }
RULE_COMPONENT(sum, x[0] + x[1])
RULE_COMPONENT(difference, x[0] - x[1])
RULE_COMPONENT(product, x[0] * x[1])
RULE_COMPONENT(ratio, over(x[0], x[1]))
RULE_COMPONENT(rest, fabsl(x[1]) < 1e-30L ? 0 : x[0] - x[1] * floorl(x[0] / x[1]))
RULE_COMPONENT(power, raised(x[0], x[1]))
RULE_COMPONENT(square, x[0] * x[0])
RULE_COMPONENT(minus_cube, over(1, x[0] * x[0] * x[0]))
RULE_COMPONENT(minus, -x[0])
RULE_COMPONENT(less, x[0] < x[1])
RULE_COMPONENT(not_more, x[0] <= x[1])
RULE_COMPONENT(more, x[0] > x[1])
RULE_COMPONENT(not_less, x[0] >= x[1])
RULE_COMPONENT(same, x[0] == x[1])
RULE_COMPONENT(other, x[0] != x[1])
RULE_COMPONENT(both, x[0] != 0 && x[1] != 0)
RULE_COMPONENT(any, x[0] != 0 || x[1] != 0)
RULE_COMPONENT(not, x[0] == 0)
RULE_COMPONENT(choice, x[0] != 0 ? x[1] : x[2])
RULE_COMPONENT(size, fabsl(x[0]))
RULE_COMPONENT(sign_of, signum(x[0]))
RULE_COMPONENT(below, floorl(x[0]))
RULE_COMPONENT(above, ceill(x[0]))
RULE_COMPONENT(nearest, floorl(x[0] + .5L))
RULE_COMPONENT(whole, truncl(x[0]))
RULE_COMPONENT(part, x[0] - floorl(x[0]))
RULE_COMPONENT(root, sqrtl(fmaxl(x[0], 0)))
RULE_COMPONENT(one_over_root, over(1, sqrtl(fmaxl(x[0], 0))))
RULE_COMPONENT(exponential, expl(fminl(x[0], 88)))
RULE_COMPONENT(two_to, exp2l(fminl(x[0], 127)))
RULE_COMPONENT(logarithm, logl(fmaxl(x[0], 1e-37L)))
RULE_COMPONENT(logarithm2, log2l(fmaxl(x[0], 1e-37L)))
RULE_COMPONENT(sine, sinl(x[0]))
RULE_COMPONENT(cosine, cosl(x[0]))
RULE_COMPONENT(tangent, tanl(x[0]))
RULE_COMPONENT(arc_sine, asinl(cut(x[0], -1, 1)))
RULE_COMPONENT(arc_cosine, acosl(cut(x[0], -1, 1)))
RULE_COMPONENT(arc_tangent, atanl(x[0]))
/* Set if the value depends on the sign of a rounding error, so that evaluators may differ: an
 * angle on the negative axis, where zero has two signs; the fraction of a number without
 * fractional digits. */
static bool rule_unsure;
static Number unsure(bool is, Number value)
{
    rule_unsure |= is;
    return value;
}
RULE_COMPONENT(angle,
               x[0] == 0 && x[1] == 0 ? 0 : unsure(x[0] == 0 && x[1] < 0, atan2l(x[0], x[1])))
RULE_COMPONENT(hyper_sine, sinhl(cut(x[0], -88, 88)))
RULE_COMPONENT(hyper_cosine, coshl(cut(x[0], -88, 88)))
RULE_COMPONENT(hyper_tangent, tanhl(x[0]))
RULE_COMPONENT(in_degrees, x[0] * 57.295779513082320876798154814105L)
RULE_COMPONENT(in_radians, x[0] * 0.017453292519943295769236907684886L)
RULE_COMPONENT(lesser, x[0] < x[1] ? x[0] : x[1])
RULE_COMPONENT(greater, x[0] > x[1] ? x[0] : x[1])
RULE_COMPONENT(signed_power, signum(x[0]) * raised(fabsl(x[0]), x[1]))
RULE_COMPONENT(hypotenuse, sqrtl(x[0] * x[0] + x[1] * x[1]))
RULE_COMPONENT(clamped, fminl(fmaxl(x[0], x[1]), x[2]))
RULE_COMPONENT(saturated, cut(x[0], 0, 1))
RULE_COMPONENT(inverted, 1 - x[0])
RULE_COMPONENT(mixed, x[0] + (x[1] - x[0]) * x[2])
RULE_COMPONENT(stepped, x[1] < x[0] ? 0 : 1)
RULE_COMPONENT(linear, ramp(x[0], x[1], x[2]))
RULE_COMPONENT(smooth,
               ramp(x[0], x[1], x[2]) * ramp(x[0], x[1], x[2]) * (3 - 2 * ramp(x[0], x[1], x[2])))
RULE_COMPONENT(mapped, x[3] + (x[4] - x[3]) * over(x[0] - x[1], x[2] - x[1]))
RULE_COMPONENT(contrasted, (x[0] - x[2]) * x[1] + x[2])
RULE_COMPONENT(biased, over(x[0], (over(1, x[1]) - 2) * (1 - x[0]) + 1))
RULE_COMPONENT(gained, x[0] < .5 ? over(x[0], (over(1, x[1]) - 2) * (1 - 2 * x[0]) + 1)
                                 : 1 - over(1 - x[0], (over(1, x[1]) - 2) * (2 * x[0] - 1) + 1))

static Number dotted(const Number *a, const Number *b, int components)
{
    Number total = 0;
    for (int i = 0; i < components; i++)
        total += a[i] * b[i];
    return total;
}
#define RULE_WHOLE(name) static void name(const Number x[5][4], int components, Number *r)
#define ROWS(a, b, c, d) r[0] = (a), r[1] = (b), r[2] = (c), r[3] = (d)
RULE_WHOLE(mean) { r[0] = dotted(x[0], (const Number[]){1, 1, 1, 1}, components) / components; }
RULE_WHOLE(most)
{
    r[0] = x[0][0];
    for (int i = 1; i < components; i++)
        r[0] = x[0][i] > r[0] ? x[0][i] : r[0];
}
RULE_WHOLE(least)
{
    r[0] = x[0][0];
    for (int i = 1; i < components; i++)
        r[0] = x[0][i] < r[0] ? x[0][i] : r[0];
}
RULE_WHOLE(bright)
{
    (void)components, r[0] = .2126L * x[0][0] + .7152L * x[0][1] + .0722L * x[0][2];
}
RULE_WHOLE(inner) { r[0] = dotted(x[0], x[1], components); }
RULE_WHOLE(norm) { r[0] = sqrtl(dotted(x[0], x[0], components)); }
RULE_WHOLE(apart)
{
    Number d[4];
    for (int i = 0; i < 4; i++)
        d[i] = x[0][i] - x[1][i];
    r[0] = sqrtl(dotted(d, d, components));
}
RULE_WHOLE(outer)
{
    const Number *a = x[0], *b = x[1];
    (void)components,
        ROWS(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], 0);
}
RULE_WHOLE(unit)
{
    const Number n = sqrtl(dotted(x[0], x[0], 3));
    (void)components, ROWS(x[0][0] / n, x[0][1] / n, x[0][2] / n, 0);
}
RULE_WHOLE(mirrored)
{
    const Number k = 2 * dotted(x[0], x[1], 3);
    (void)components, ROWS(x[0][0] - k * x[1][0], x[0][1] - k * x[1][1], x[0][2] - k * x[1][2], 0);
}
RULE_WHOLE(turned)
{
    const Number c = cosl(x[1][0]), s = sinl(x[1][0]);
    (void)components, ROWS(c * x[0][0] - s * x[0][1], s * x[0][0] + c * x[0][1], 0, 0);
}
/* By sixths of the hue, the textbook formula. */
RULE_WHOLE(from_hsv)
{
    const Number h = unsure(fabsl(x[0][0]) > 1e9L, 6 * (x[0][0] - floorl(x[0][0]))), s = x[0][1],
                 v = x[0][2], f = h - floorl(h);
    const Number p = v * (1 - s), q = v * (1 - s * f), t = v * (1 - s * (1 - f));
    const Number table[6][3] = {{v, t, p}, {q, v, p}, {p, v, t}, {p, q, v}, {t, p, v}, {v, p, q}};
    const Number *row = table[(int)h % 6];
    (void)components, ROWS(row[0], row[1], row[2], 0);
}
RULE_WHOLE(to_hsv)
{
    const Number red = x[0][0], green = x[0][1], blue = x[0][2];
    const Number high = fmaxl(red, fmaxl(green, blue)), low = fminl(red, fminl(green, blue)),
                 c = high - low;
    Number h = c < 1e-30L      ? 0
               : high == red   ? (green - blue) / c
               : high == green ? 2 + (blue - red) / c
                               : 4 + (red - green) / c;
    h /= 6;
    (void)components, ROWS(h - floorl(h), over(c, high), high, 0);
}
RULE_WHOLE(chess)
{
    const Number n = floorl(x[0][0]) + floorl(x[0][1]);
    (void)components, r[0] = unsure(fabsl(n) > 1e15L, n - 2 * floorl(n / 2));
}
RULE_WHOLE(pair) { (void)components, ROWS(x[0][0], x[1][0], 0, 0); }
RULE_WHOLE(triple) { (void)components, ROWS(x[0][0], x[1][0], x[2][0], 0); }
RULE_WHOLE(behind) { (void)components, ROWS(x[0][0], x[0][1], x[1][0], 0); }
RULE_WHOLE(four) { (void)components, ROWS(x[0][0], x[0][1], x[0][2], x[1][0]); }
RULE_WHOLE(backward) { (void)components, ROWS(x[0][2], x[0][1], x[0][0], 0); }
RULE_WHOLE(second) { (void)components, r[0] = x[0][1]; }

enum { CONDITION = 0 }; /* a width: marks a condition */
enum { OR = 1, AND, COMPARE, SUM, PRODUCT, PREFIX, POWER, CHOOSE = -1, POSTFIX = 99 };
static const Rule rules[] = {
    {"||", OR, "bb", 0, any, 0},
    {"&&", AND, "bb", 0, both, 0},
    {"!", PREFIX, "b", 0, not, 0},
    {"<", COMPARE, "11", 0, less, 0},
    {"<=", COMPARE, "11", 0, not_more, 0},
    {">", COMPARE, "11", 0, more, 0},
    {">=", COMPARE, "11", 0, not_less, 0},
    {"==", COMPARE, "11", 0, same, 0},
    {"!=", COMPARE, "11", 0, other, 0},
    {"+", SUM, "gg", -1, sum, 0},
    {"-", SUM, "gg", -1, difference, 0},
    {"*", PRODUCT, "gg", -1, product, 0},
    {"/", PRODUCT, "gg", -1, ratio, 0},
    {"%", PRODUCT, "gg", -1, rest, 0},
    {"-", PREFIX, "g", -1, minus, 0},
    {"^", POWER, "gg", -1, power, 0},
    {"^ 2", POSTFIX, "g", -1, square, 0},
    {"^ -3", POSTFIX, "g", -1, minus_cube, 0},
    {"?", CHOOSE, "bgg", -1, choice, 0},
    {"abs", 0, "g", -1, size, 0},
    {"sign", 0, "g", -1, sign_of, 0},
    {"floor", 0, "g", -1, below, 0},
    {"ceil", 0, "g", -1, above, 0},
    {"round", 0, "g", -1, nearest, 0},
    {"trunc", 0, "g", -1, whole, 0},
    {"fract", 0, "g", -1, part, 0},
    {"sqrt", 0, "g", -1, root, 0},
    {"inversesqrt", 0, "g", -1, one_over_root, 0},
    {"exp", 0, "g", -1, exponential, 0},
    {"exp2", 0, "g", -1, two_to, 0},
    {"log", 0, "g", -1, logarithm, 0},
    {"log2", 0, "g", -1, logarithm2, 0},
    {"sin", 0, "g", -1, sine, 0},
    {"cos", 0, "g", -1, cosine, 0},
    {"tan", 0, "g", -1, tangent, 0},
    {"asin", 0, "g", -1, arc_sine, 0},
    {"acos", 0, "g", -1, arc_cosine, 0},
    {"atan", 0, "g", -1, arc_tangent, 0},
    {"atan2", 0, "gg", -1, angle, 0},
    {"sinh", 0, "g", -1, hyper_sine, 0},
    {"cosh", 0, "g", -1, hyper_cosine, 0},
    {"tanh", 0, "g", -1, hyper_tangent, 0},
    {"degrees", 0, "g", -1, in_degrees, 0},
    {"radians", 0, "g", -1, in_radians, 0},
    {"min", 0, "gg", -1, lesser, 0},
    {"max", 0, "gg", -1, greater, 0},
    {"mod", 0, "gg", -1, rest, 0},
    {"pow", 0, "gg", -1, power, 0},
    {"safepow", 0, "gg", -1, signed_power, 0},
    {"hypot", 0, "gg", -1, hypotenuse, 0},
    {"clamp", 0, "ggg", -1, clamped, 0},
    {"saturate", 0, "g", -1, saturated, 0},
    {"invert", 0, "g", -1, inverted, 0},
    {"mix", 0, "ggg", -1, mixed, 0},
    {"step", 0, "gg", -1, stepped, 0},
    {"linearstep", 0, "ggg", -1, linear, 0},
    {"smoothstep", 0, "ggg", -1, smooth, 0},
    {"remap", 0, "ggggg", -1, mapped, 0},
    {"contrast", 0, "ggg", -1, contrasted, 0},
    {"bias", 0, "gg", -1, biased, 0},
    {"gain", 0, "gg", -1, gained, 0},
    {"average", 0, "n", 1, 0, mean},
    {"maxcomponent", 0, "n", 1, 0, most},
    {"mincomponent", 0, "n", 1, 0, least},
    {"luminance", 0, "3", 1, 0, bright},
    {"dot", 0, "33", 1, 0, inner},
    {"length", 0, "n", 1, 0, norm},
    {"distance", 0, "33", 1, 0, apart},
    {"cross", 0, "33", 3, 0, outer},
    {"normalize", 0, "3", 3, 0, unit},
    {"reflect", 0, "33", 3, 0, mirrored},
    {"rotate2", 0, "21", 2, 0, turned},
    {"hsvtorgb", 0, "3", 3, 0, from_hsv},
    {"rgbtohsv", 0, "3", 3, 0, to_hsv},
    {"checker", 0, "2", 1, 0, chess},
    {"vec2", 0, "11", 2, 0, pair},
    {"vec3", 0, "111", 3, 0, triple},
    {"vec3", 0, "21", 3, 0, behind},
    {"vec4", 0, "31", 4, 0, four},
    {".zyx", POSTFIX, "3", 3, 0, backward},
    {"[1]", POSTFIX, "n", 1, 0, second},
};
enum { RULES = sizeof rules / sizeof *rules };
#endif
