/* Derivatives by the chain rule, from the SLOPE lines of ops.def and the rows of slopes.def. Every (value, direction) is
 * differentiated once. */
#include "compiler/lower/slope.h"
#include <string.h>

enum { UNKNOWN = 0, LANE_OPERANDS = 3 };
static const Ref FLAT = UINT32_MAX; /* in the memo: it does not change */

static Ref *memo_of(Lower *l, Ref value, Direction direction)
{
    l->slopes = arena_reach(l->session->arena, l->slopes, value, &l->slope_room, sizeof *l->slopes);
    return &l->slopes[value][direction];
}

void slope_set(Lower *l, Ref value, Direction direction, Ref slope)
{
    *memo_of(l, value, direction) = slope ? slope : FLAT;
}

/* All lanes of a vector alike: a number's derivative may stand for a vector's. */
static Ref widened(Lower *l, Ref value, Type type)
{
    if (!value || ir_type(l->ir, value) == type || type_table[type].lanes == 1)
        return value;
    return ir_vec(l->ir, type, REFS(l->ir, value, value, value, value), type_table[type].lanes);
}

static Ref zero_of(Lower *l, Type type) { return ir_const(l->ir, type, (double[4]){0}); }

/* Sums and products in which 0 stands for a derivative that is zero. */
#define plus(l, a, b) sum_of(l, REFS((l)->ir, a, b))
#define over(l, a, b) quotient_of(l, REFS((l)->ir, a, b))
static Ref sum_of(Lower *l, const Ref x[2]) { return !x[0] ? x[1] : !x[1] ? x[0] : add(l, x[0], x[1]); }
static Ref quotient_of(Lower *l, const Ref x[2]) { return x[0] ? ir_make(l->ir, OP_div, TYPE_bool, 0, x, 2) : 0; }
static Ref times(Lower *l, Ref factor, Ref a) { return a ? ir_binary(l->ir, OP_mul, factor, a) : 0; }
static Ref negated(Lower *l, Ref a) { return a ? ir_unary(l->ir, OP_neg, a) : 0; }

/* a where the mask is 1, b where it is 0. */
static Ref pick(Lower *l, const Ref x[3])
{
    Ref mask = x[0], a = x[1], b = x[2];
    if (!a && !b)
        return 0;
    return plus(l, times(l, mask, a), times(l, ir_binary(l->ir, OP_sub, number(l, 1), mask), b));
}

/* sqrt(1 - a^2), not 0: at the ends of an arc the derivative is cut rather than infinite. */
static Ref arc(Lower *l, Ref a)
{
    const double least = 1e-6;
    Ref rest = ir_binary(l->ir, OP_sub, number(l, 1), ir_binary(l->ir, OP_mul, a, a));
    return ir_unary(l->ir, OP_sqrt, ir_binary(l->ir, OP_max, rest, number(l, least)));
}

#define K(x)          number(l, x)
#define UNARY(op, a)  ir_unary(l->ir, OP_##op, a)
#define NEG(a)        negated(l, a)
#define PLUS(a, b)    plus(l, a, b)
#define TIMES(a, b)   times(l, a, b)
#define OVER(a, b)    over(l, a, b)
#define PICK(m, a, b) pick(l, REFS(l->ir, m, a, b))
#define MUL(a, b)     ir_binary(l->ir, OP_mul, a, b)
#define SUB(a, b)     ir_binary(l->ir, OP_sub, a, b)
#define MAX(a, b)     ir_binary(l->ir, OP_max, a, b)
#define STEP(a, b)    ir_binary(l->ir, OP_step, a, b)
#define POW(a, b)     ir_binary(l->ir, OP_pow, a, b)
#define DIV(a, b)     ir_binary(l->ir, OP_div, a, b)
#define SIGN(a)       ir_unary(l->ir, OP_sign, a)
#define TWICE(a)      MUL(a, K(2))
#define SCALED(a, k)  MUL(a, K(k))
#define ARC(a)        arc(l, a)

static Ref operand(const Ir *ir, Ref ref, int i) { return i < ir_at(ir, ref)->count ? ir_arg(ir, ref, i) : 0; }

/* Of an operation that works by lane: the SLOPE lines of ops.def. */
static Ref lanes_slope(Lower *l, Ref r, const Ref *slopes)
{
    Ref a = operand(l->ir, r, 0), b = operand(l->ir, r, 1), c = operand(l->ir, r, 2);
    Ref da = slopes[0], db = slopes[1], dc = slopes[2];
    switch (ir_at(l->ir, r)->op) {
#define SLOPE(name, slope)                                                                                             \
    case OP_##name:                                                                                                    \
        return slope;
#include "grammar/ops.def"
    default:
        return 0;
    }
}

/* The operands' derivatives, 0 where there is none, of LANE_OPERANDS at least; whether any changes. */
static bool operand_slopes(Lower *l, Ref ref, Direction direction, Ref *slopes)
{
    bool any = false;
    for (int i = 0; i < LANE_OPERANDS; i++)
        slopes[i] = 0;
    for (int i = 0; i < ir_at(l->ir, ref)->count; i++) {
        slopes[i] = slope_of(l, ir_arg(l->ir, ref, i), direction);
        any |= slopes[i] != 0;
    }
    return any;
}

static Ref vec_slope(Lower *l, Ref ref, const Ref *slopes)
{
    Ref parts[4];
    int count = ir_at(l->ir, ref)->count;
    for (int i = 0; i < count; i++) {
        Type type = ir_type(l->ir, ir_arg(l->ir, ref, i));
        parts[i] = slopes[i] ? slopes[i] : zero_of(l, type);
    }
    return ir_vec(l->ir, ir_type(l->ir, ref), parts, count);
}

static Ref swizzle_slope(Lower *l, Ref ref, const Ref *slopes)
{
    return ir_swizzle_lanes(l->ir, slopes[0], ir_at(l->ir, ref)->payload, ir_lanes(l->ir, ref));
}

static Ref filled(Lower *l, Ref slope, Ref like) { return slope ? slope : zero_of(l, ir_type(l->ir, like)); }

static Ref select_slope(Lower *l, Ref ref, const Ref *slopes)
{
    if (!slopes[1] && !slopes[2])
        return 0;
    return ir_select(l->ir, ir_arg(l->ir, ref, 0), filled(l, slopes[1], ref), filled(l, slopes[2], ref));
}

/* dot, cross: linear in each operand. */
static Ref bilinear_slope(Lower *l, Ref ref, const Ref *slopes)
{
    Op op = (Op)ir_at(l->ir, ref)->op;
    Ref a = ir_arg(l->ir, ref, 0), b = ir_arg(l->ir, ref, 1);
    Ref by_a = slopes[0] ? ir_binary(l->ir, op, slopes[0], b) : 0;
    Ref by_b = slopes[1] ? ir_binary(l->ir, op, a, slopes[1]) : 0;
    return plus(l, by_a, by_b);
}

static Ref length_slope(Lower *l, Ref ref, const Ref *slopes)
{
    const double least = 1e-30;
    Ref toward = ir_binary(l->ir, OP_dot, ir_arg(l->ir, ref, 0), slopes[0]);
    return over(l, toward, ir_binary(l->ir, OP_max, ref, number(l, least)));
}

/* A matrix times a vector: the matrix times the vector's change, and the columns' changes times the vector. */
static Ref linear_slope(Lower *l, Ref ref, const Ref *slopes)
{
    Ref moved[5], turned[5];
    int count = ir_at(l->ir, ref)->count;
    Type type = ir_type(l->ir, ref);
    bool turns = false;
    for (int i = 1; i < count; i++) {
        moved[i] = ir_arg(l->ir, ref, i);
        turned[i] = slopes[i] ? slopes[i] : zero_of(l, ir_type(l->ir, moved[i]));
        turns |= slopes[i] != 0;
    }
    moved[0] = slopes[0];
    turned[0] = ir_arg(l->ir, ref, 0);
    return plus(l, moved[0] ? ir_make(l->ir, OP_linear, type, 0, moved, count) : 0,
                turns ? ir_make(l->ir, OP_linear, type, 0, turned, count) : 0);
}

/* f(a + h d) and f(a - h d), for a library function whose derivative nobody wrote down: error h^2 / 6 of the third one. */
static Ref difference_slope(Lower *l, Ref ref, const Ref *args, const Ref *slopes, int count)
{
    const double step = 1.0 / 256;
    Ref ends[2], moved[16];
    for (int side = 0; side < 2; side++) {
        for (int i = 0; i < count; i++)
            moved[i] = plus(l, args[i], slopes[i] ? times(l, number(l, side ? -step : step), slopes[i]) : 0);
        ends[side] = ir_call(l->ir, (int)ir_at(l->ir, ref)->payload, moved, count);
    }
    return ir_binary(l->ir, OP_mul, ir_binary(l->ir, OP_sub, ends[0], ends[1]), number(l, 0.5 / step));
}

/* The function that slopes.def names, called on the arguments that it shares with this one. */
static Ref call_sibling(Lower *l, const SlopeRow *row, const Ref *args, int count, Ref direction)
{
    Ref all[16];
    int used = 0;
    for (const char *from = row->arguments; *from; from++) {
        if (*from == 'd')
            all[used++] = direction;
        else if (*from == 'r')
            all[used++] = ir_vec3(l->ir, 0, 0, 0);
        else if (*from == 'w')
            all[used++] = number(l, 0);
        else if (*from - '0' < count)
            all[used++] = args[*from - '0'];
    }
    return ir_call(l->ir, row->by, all, used);
}

/* n x^(n - 1) dx, the exponent being a constant. */
static Ref power_slope(Lower *l, const Ref *args, Ref d)
{
    double n = ir_numbers(l->ir, args[1])[0];
    if (!d)
        return 0;
    Ref lower =
        n > 1 ? ir_call(l->ir, FN_powerCompensated, REFS(l->ir, args[0], ir_int(l->ir, n - 1)), 2) : number(l, 1);
    return times(l, ir_binary(l->ir, OP_mul, lower, number(l, n)), d);
}

static Ref limited_slope(Lower *l, const SlopeRow *row, const Ref *args, Ref d)
{
    Ref within = ir_binary(l->ir, OP_step, ir_unary(l->ir, OP_abs, args[0]), number(l, WAVE_EXP_LIMIT));
    return ir_binary(l->ir, OP_mul, call_sibling(l, row, args, 1, 0), times(l, within, d));
}

static Ref call_slope(Lower *l, Ref ref, const Ref *slopes)
{
    const IrNode node = *ir_at(l->ir, ref);
    Ref args[16];
    for (int i = 0; i < node.count && i < 16; i++)
        args[i] = ir_arg(l->ir, ref, i);
    const SlopeRow *row = slope_row((int)node.payload);
    Ref d = slopes[row->argument];
    switch (row->kind) {
    case SLOPE_flat:
        return 0;
    case SLOPE_gradient:
        if (!d)
            return 0;
        return ir_binary(l->ir, OP_dot, ir_swizzle(l->ir, call_sibling(l, row, args, node.count, 0), "xyz"), d);
    case SLOPE_along:
        return d ? call_sibling(l, row, args, node.count, d) : 0;
    case SLOPE_limited:
        return d ? limited_slope(l, row, args, d) : 0;
    case SLOPE_factor:
        return d ? ir_binary(l->ir, OP_mul, call_sibling(l, row, args, node.count, 0), d) : 0;
    case SLOPE_power:
        return power_slope(l, args, d);
    case SLOPE_difference:
        break;
    }
    return difference_slope(l, ref, args, slopes, node.count);
}

/* A function of the program gets a function of its derivative. What its arguments change by was set when it was made. */
static Ref apply_slope(Lower *l, Ref ref, Direction direction)
{
    const IrNode node = *ir_at(l->ir, ref);
    Ref args[8];
    int function = (int)node.payload;
    Ref slope = slope_of(l, l->ir->functions[function].result, direction);
    if (!slope)
        return 0;
    for (int i = 0; i < node.count; i++)
        args[i] = ir_arg(l->ir, ref, i);
    uint8_t hint = l->ir->hint;
    l->ir->hint = l->ir->functions[function].hint;
    int derived = ir_function(l->ir, l->ir->functions[function].arguments, l->ir->functions[function].count, slope);
    l->ir->hint = hint;
    return ir_make(l->ir, (Op)node.op, ir_type(l->ir, slope), (uint32_t)derived, args, node.count);
}

static Ref input_slope(Lower *l, Ref ref, Direction direction)
{
    const Input input = (Input)ir_at(l->ir, ref)->payload;
    static const struct {
        Input of, by[2];
    } tangents[] = {{INPUT_X, {INPUT_XU, INPUT_XV}}, {INPUT_P, {INPUT_DU, INPUT_DV}}};
    if (direction == DIRECTION_right || direction == DIRECTION_up) {
        for (int i = 0; i < change_count; i++)
            if (change_table[i].of == input && (direction == DIRECTION_right) == !strcmp(change_table[i].by, "dFdx"))
                return ir_input(l->ir, change_table[i].input);
        return 0;
    }
    bool by_v = direction == DIRECTION_v;
    if (input == INPUT_U)
        return ir_const(l->ir, TYPE_vec2, (double[]){!by_v, by_v});
    for (size_t i = 0; i < sizeof tangents / sizeof *tangents; i++)
        if (tangents[i].of == input)
            return ir_input(l->ir, tangents[i].by[by_v]);
    return 0;
}

static Ref differentiate(Lower *l, Ref ref, Direction direction)
{
    Ref slopes[UINT8_MAX];
    switch (ir_at(l->ir, ref)->op) {
#define SLOPE_ALONG(name, function)                                                                                    \
    case OP_##name:                                                                                                    \
        return function(l, ref, direction);
#define SLOPE_NODE(name, function)                                                                                     \
    case OP_##name:                                                                                                    \
        return operand_slopes(l, ref, direction, slopes) ? function(l, ref, slopes) : 0;
#define SLOPE(name, slope)                                                                                             \
    case OP_##name:                                                                                                    \
        return operand_slopes(l, ref, direction, slopes) ? lanes_slope(l, ref, slopes) : 0;
#include "grammar/ops.def"
    default:
        return 0;
    }
}

/* What a value's derivative is made of: the operands', and where it runs a function the result's. */
static int parts_of(const Ir *ir, Ref ref) { return ir_applies(ir, ref) ? 1 : ir_at(ir, ref)->count; }

static Ref part_of(const Ir *ir, Ref ref, int i)
{
    return ir_applies(ir, ref) ? ir->functions[ir_at(ir, ref)->payload].result : ir_arg(ir, ref, i);
}

static void push_unknown(Lower *l, Ref ref, Direction direction)
{
    if (*memo_of(l, ref, direction) == UNKNOWN)
        ARENA_PUSH(l->session->arena, l->to_differ, l->to_differ_count, l->to_differ_room, ref);
}

/* Its operands' are known. */
static void find_slope(Lower *l, Ref value, Direction direction)
{
    uint8_t hint = l->ir->hint;
    l->ir->hint = ir_at(l->ir, value)->hint;
    Ref slope = widened(l, differentiate(l, value, direction), ir_type(l->ir, value));
    l->ir->hint = hint;
    if (slope && ir_is_number(l->ir, slope, 0))
        slope = 0;
    slope_set(l, value, direction, slope);
    if (slope && (direction == DIRECTION_right || direction == DIRECTION_up))
        for (int d = 0; d < DIRECTION_COUNT; d++) /* footprints count as constant */
            if (*memo_of(l, slope, (Direction)d) == UNKNOWN && !ir_is(l->ir, slope, OP_const))
                slope_set(l, slope, (Direction)d, 0);
}

/* Operands first, the left one before the right, on a stack of its own: a tree of maps may be deeper than the caller's stack. */
Ref slope_of(Lower *l, Ref value, Direction direction)
{
    size_t before = l->to_differ_count;
    push_unknown(l, value, direction);
    while (l->to_differ_count > before) {
        Ref ref = l->to_differ[l->to_differ_count - 1];
        size_t now = l->to_differ_count;
        for (int i = parts_of(l->ir, ref) - 1; i >= 0 && *memo_of(l, ref, direction) == UNKNOWN; i--)
            push_unknown(l, part_of(l->ir, ref, i), direction);
        if (l->to_differ_count > now)
            continue;
        l->to_differ_count--;
        if (*memo_of(l, ref, direction) == UNKNOWN)
            find_slope(l, ref, direction);
    }
    Ref slope = *memo_of(l, value, direction);
    return slope == FLAT ? 0 : slope;
}
