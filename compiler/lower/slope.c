/* Derivatives by the chain rule, from the SLOPE lines of ops.def and the rows of slopes.def.
 * Every (value, direction) is differentiated once.
 *
 *     r = mul(a, b), a = sin(u), b = 3, along u: da = cos(u), db = 0
 *     mul's line is PLUS(TIMES(b, da), TIMES(a, db)): TIMES with a missing derivative makes no
 *     node, and PLUS with one operand returns that operand, so the result is 3 cos(u), without
 *     terms to fold */
#include "compiler/lower/slope.h"
#include "compiler/lower/address.h"
#include "compiler/ir/build_words.h"
#include <string.h>

enum { UNKNOWN = 0, COMPONENT_OPERANDS = 3 };
static const Ref FLAT = UINT32_MAX; /* memo entry of a value that is constant along the direction */

static Ref *memo_of(Lower *l, Ref value, Direction direction)
{
    l->slopes =
        arena_reach(l->session->arena, l->slopes, value, &l->slope_capacity, sizeof *l->slopes);
    return &l->slopes[value][direction];
}

void slope_set(Lower *l, Ref value, Direction direction, Ref slope)
{
    *memo_of(l, value, direction) = slope ? slope : FLAT;
}

/* Repeats a scalar derivative over all components of a vector. */
static Ref widened(Ir *ir, Ref value, Type type)
{
    return value && type_table[type].components > 1 ? build_splat(ir, value, type) : value;
}

/* Selects a where the mask is 1, and b where it is 0. */
static Ref pick(Ir *ir, const Ref x[3])
{
    Ref mask = x[0], a = x[1], b = x[2];
    if (!a && !b)
        return 0;
    return build_plus(ir, build_times(ir, mask, a),
                      build_times(ir, build_sub(ir, build_float(ir, 1), mask), b));
}

/* Returns sqrt(1 - a^2), bounded from below: at the ends of an arc the derivative is limited
 * rather than infinite. */
static Ref arc(Ir *ir, Ref a)
{
    const double least = 1e-6;
    Ref rest = build_sub(ir, build_float(ir, 1), build_square(ir, a));
    return build_sqrt(ir, build_max(ir, rest, build_float(ir, least)));
}

#define PLUS(a, b)    build_plus(ir, a, b)
#define TIMES(a, b)   build_times(ir, a, b)
#define OVER(a, b)    build_over(ir, a, b)
#define MINUS(a)      build_minus(ir, a)
#define PICK(m, a, b) pick(ir, REFS(ir, m, a, b))
#define ARC(a)        arc(ir, a)

static Ref operand(const Ir *ir, Ref ref, int i)
{
    return i < ir_at(ir, ref)->count ? ir_arg(ir, ref, i) : 0;
}

/* Returns the derivative of an operation that works per component: the SLOPE lines of ops.def. */
static Ref components_slope(Ir *ir, Ref r, const Ref *slopes)
{
    Ref a = operand(ir, r, 0), b = operand(ir, r, 1), c = operand(ir, r, 2);
    Ref da = slopes[0], db = slopes[1], dc = slopes[2];
    switch (ir_at(ir, r)->op) {
#define SLOPE(name, slope)                                                                         \
    case OP_##name:                                                                                \
        return slope;
#include "grammar/ops.def"
    default:
        return 0;
    }
}

static Ref vec_slope(Ir *ir, Ref ref, const Ref *slopes)
{
    Ref parts[4];
    int count = ir_at(ir, ref)->count;
    for (int i = 0; i < count; i++) {
        Type type = ir_type(ir, ir_arg(ir, ref, i));
        parts[i] = build_or_zero(ir, slopes[i], type);
    }
    return build_vec_of(ir, ir_type(ir, ref), parts, count);
}

static Ref swizzle_slope(Ir *ir, Ref ref, const Ref *slopes)
{
    return build_components(ir, slopes[0], ir_at(ir, ref)->payload, ir_components(ir, ref));
}

/* Returns the derivative of a select. A condition with a finite difference (bump.c) counts as
 * a number from 0 to 1; other conditions are constant. */
static Ref select_slope(Ir *ir, Ref ref, const Ref *slopes)
{
    const Type type = ir_type(ir, ref);
    Ref condition = ir_arg(ir, ref, 0), a = ir_arg(ir, ref, 1), b = ir_arg(ir, ref, 2), within = 0;
    if (slopes[1] && build_is_guard(ir, ref))
        within = build_guard(ir, condition, slopes[1]);
    else if (slopes[1] || slopes[2])
        within = build_select(ir, condition, build_or_zero(ir, slopes[1], type),
                              build_or_zero(ir, slopes[2], type));
    return build_plus(ir, within, slopes[0] ? build_mul(ir, build_sub(ir, a, b), slopes[0]) : 0);
}

/* Differentiates dot and cross, which are linear in each operand. */
static Ref bilinear_slope(Ir *ir, Ref ref, const Ref *slopes)
{
    Op op = (Op)ir_at(ir, ref)->op;
    Ref a = ir_arg(ir, ref, 0), b = ir_arg(ir, ref, 1);
    Ref by_a = slopes[0] ? build_binary(ir, op, slopes[0], b) : 0;
    Ref by_b = slopes[1] ? build_binary(ir, op, a, slopes[1]) : 0;
    return build_plus(ir, by_a, by_b);
}

static Ref length_slope(Ir *ir, Ref ref, const Ref *slopes)
{
    const double least = 1e-30;
    Ref toward = build_dot(ir, ir_arg(ir, ref, 0), slopes[0]);
    return build_over(ir, toward, build_max(ir, ref, build_float(ir, least)));
}

/* Differentiates a matrix times a vector: the matrix times the vector's derivative, plus the
 * columns' derivatives times the vector. */
static Ref linear_slope(Ir *ir, Ref ref, const Ref *slopes)
{
    Ref moved[5], turned[5];
    int count = ir_at(ir, ref)->count;
    bool turns = false;
    for (int i = 1; i < count; i++) {
        moved[i] = ir_arg(ir, ref, i);
        turned[i] = build_or_zero(ir, slopes[i], ir_type(ir, moved[i]));
        turns |= slopes[i] != 0;
    }
    moved[0] = slopes[0];
    turned[0] = ir_arg(ir, ref, 0);
    return build_plus(ir, moved[0] ? build_linear(ir, moved, count) : 0,
                      turns ? build_linear(ir, turned, count) : 0);
}

/* Returns the central difference of f(a + h d) and f(a - h d), for a library function without a
 * row in slopes.def: the error is h^2 / 6 of the third derivative. */
static Ref difference_slope(Ir *ir, Ref ref, const Ref *args, const Ref *slopes, int count)
{
    const double step = 1.0 / 256;
    Ref ends[2], moved[16];
    for (int side = 0; side < 2; side++) {
        for (int i = 0; i < count; i++)
            moved[i] = build_plus(
                ir, args[i],
                slopes[i] ? build_times(ir, build_float(ir, side ? -step : step), slopes[i]) : 0);
        ends[side] = build_call_of(ir, (int)ir_at(ir, ref)->payload, moved, count);
    }
    return build_scale(ir, build_sub(ir, ends[0], ends[1]), 0.5 / step);
}

/* Calls the function that slopes.def names, with the arguments that it shares with this one. */
static Ref call_sibling(Ir *ir, const SlopeRow *row, const Ref *args, int count, Ref direction)
{
    Ref all[16];
    int used = 0;
    for (const char *from = row->arguments; *from; from++) {
        if (*from == 'd')
            all[used++] = direction;
        else if (*from == 'r')
            all[used++] = build_vec3(ir, 0, 0, 0);
        else if (*from == 'w')
            all[used++] = build_float(ir, 0);
        else if (*from - '0' < count)
            all[used++] = args[*from - '0'];
    }
    return build_call_of(ir, row->by, all, used);
}

/* Differentiates a power with a constant exponent: n x^(n - 1) dx. */
static Ref power_slope(Ir *ir, const Ref *args, Ref d)
{
    double n = ir_numbers(ir, args[1])[0];
    if (!d)
        return 0;
    Ref lower = n > 1 ? build_call(ir, FN_powerCompensated, args[0], build_int(ir, n - 1))
                      : build_float(ir, 1);
    return build_times(ir, build_scale(ir, lower, n), d);
}

static Ref limited_slope(Ir *ir, const SlopeRow *row, const Ref *args, Ref d)
{
    Ref within = build_step(ir, build_abs(ir, args[0]), build_float(ir, WAVE_EXP_LIMIT));
    return build_mul(ir, call_sibling(ir, row, args, 1, 0), build_times(ir, within, d));
}

static Ref call_slope(Ir *ir, Ref ref, const Ref *slopes)
{
    const IrNode node = *ir_at(ir, ref);
    Ref args[16];
    for (int i = 0; i < node.count && i < 16; i++)
        args[i] = ir_arg(ir, ref, i);
    const SlopeRow *row = slope_row((int)node.payload);
    Ref d = slopes[row->argument];
    switch (row->kind) {
    case SLOPE_flat:
        return 0;
    case SLOPE_gradient:
        if (!d)
            return 0;
        return build_dot(ir,
                         build_swizzle(ir, call_sibling(ir, row, args, node.count, 0),
                                       ir_components(ir, d) == 2 ? "xy" : "xyz"),
                         d);
    case SLOPE_along:
        return d ? call_sibling(ir, row, args, node.count, d) : 0;
    case SLOPE_limited:
        return d ? limited_slope(ir, row, args, d) : 0;
    case SLOPE_factor:
        return d ? build_mul(ir, call_sibling(ir, row, args, node.count, 0), d) : 0;
    case SLOPE_power:
        return power_slope(ir, args, d);
    case SLOPE_difference:
        break;
    }
    return difference_slope(ir, ref, args, slopes, node.count);
}

/* Returns the derivative of a call of a program's function: a call of another function. Its
 * arguments' derivatives were set when it was made. */
static Ref apply_slope(Lower *l, Ref ref, Direction direction)
{
    IrNode node = *ir_at(l->ir, ref);
    Ref args[8];
    int function = (int)node.payload;
    Ref slope = slope_of(l, l->ir->functions[function].result, direction);
    if (!slope)
        return 0;
    for (int i = 0; i < node.count; i++)
        args[i] = ir_arg(l->ir, ref, i);
    uint32_t origin = l->ir->origin;
    l->ir->origin = l->ir->functions[function].origin;
    int derived = ir_function(l->ir, l->ir->functions[function].arguments,
                              l->ir->functions[function].count, slope);
    l->ir->origin = origin;
    node.type = ir_at(l->ir, slope)->type;
    node.payload = (uint32_t)derived;
    return ir_make(l->ir, node, args);
}

static Ref input_slope(Lower *l, Ref ref, Direction direction)
{
    Ir *ir = l->ir;
    const Input input = (Input)ir_at(ir, ref)->payload;
    static const struct {
        Input of, by[2];
    } tangents[] = {{INPUT_X, {INPUT_XU, INPUT_XV}},
                    {INPUT_P, {INPUT_DU, INPUT_DV}},
                    {INPUT_vertexX, {INPUT_vertexXU, INPUT_vertexXV}},
                    {INPUT_vertexP, {INPUT_vertexDU, INPUT_vertexDV}},
                    {INPUT_cornerX, {INPUT_cornerXU, INPUT_cornerXV}},
                    {INPUT_cornerP, {INPUT_cornerDU, INPUT_cornerDV}}};
    if (direction == DIRECTION_right || direction == DIRECTION_up) {
        if (input == INPUT_DU || input == INPUT_DV)
            /* no footprint reads the rotation of tangents; only slope_mesh_tangent() does */
            return 0;
        for (int i = 0; i < change_count; i++)
            if (change_table[i].of == input &&
                (direction == DIRECTION_right) == !strcmp(change_table[i].by, "dFdx"))
                return build_input(ir, change_table[i].input);
        return 0;
    }
    bool by_v = direction == DIRECTION_v;
    if (input == INPUT_U || input == INPUT_vertexU || input == INPUT_cornerU)
        return ir_const(ir, TYPE_vec2, (double[]){!by_v, by_v});
    for (size_t i = 0; i < sizeof tangents / sizeof *tangents; i++)
        if (tangents[i].of == input)
            return build_input(ir, tangents[i].by[by_v]);
    return 0;
}

/* Finds the derivatives of the operands, 0 for none, at least COMPONENT_OPERANDS of them. Returns
 * true if any operand changes. */
static bool operand_slopes(Lower *l, Ref ref, Direction direction, Ref *slopes)
{
    bool any = false;
    for (int i = 0; i < COMPONENT_OPERANDS; i++)
        slopes[i] = 0;
    for (int i = 0; i < ir_at(l->ir, ref)->count; i++) {
        slopes[i] = slope_of(l, ir_arg(l->ir, ref, i), direction);
        any |= slopes[i] != 0;
    }
    return any;
}

static Ref sum_slope(Lower *l, const SlopeSum *sum, Direction direction)
{
    Ref slope = 0;
    for (int i = 0; i < sum->count; i++)
        slope = build_plus(
            l->ir, slope,
            build_times(l->ir, sum->terms[i].factor, slope_of(l, sum->terms[i].of, direction)));
    return slope;
}

static Ref differentiate(Lower *l, Ref ref, Direction direction)
{
    const SlopeSum *sum = slope_sum_of(l, ref);
    Ref slopes[UINT8_MAX], texels = address_texels(l->ir, ref);
    if (sum)
        return sum_slope(l, sum, direction);
    if (texels)
        return slope_of(l, texels, direction);
    switch (ir_at(l->ir, ref)->op) {
#define SLOPE_ALONG(name, function)                                                                \
    case OP_##name:                                                                                \
        return function(l, ref, direction);
#define SLOPE_NODE(name, function)                                                                 \
    case OP_##name:                                                                                \
        return operand_slopes(l, ref, direction, slopes) ? function(l->ir, ref, slopes) : 0;
#define SLOPE(name, slope)                                                                         \
    case OP_##name:                                                                                \
        return operand_slopes(l, ref, direction, slopes) ? components_slope(l->ir, ref, slopes) : 0;
#include "grammar/ops.def"
    default:
        return 0;
    }
}

/* Returns the number of nodes whose derivatives are needed: the operands; the result of a called
 * function; the texels of a sampler; or the terms of a SlopeSum. */
static int parts_of(Lower *l, Ref ref)
{
    const SlopeSum *sum = slope_sum_of(l, ref);
    if (sum)
        return sum->count;
    return ir_applies(l->ir, ref) || address_texels(l->ir, ref) ? 1 : ir_at(l->ir, ref)->count;
}

static Ref part_of(Lower *l, Ref ref, int i)
{
    Ir *ir = l->ir;
    const SlopeSum *sum = slope_sum_of(l, ref);
    if (sum)
        return sum->terms[i].of;
    if (ir_applies(ir, ref))
        return ir->functions[ir_at(ir, ref)->payload].result;
    Ref texels = address_texels(ir, ref);
    return texels ? texels : ir_arg(ir, ref, i);
}

static void push_unknown(Lower *l, Ref ref, Direction direction)
{
    if (*memo_of(l, ref, direction) == UNKNOWN)
        ARENA_PUSH(l->session->arena, l->to_differ, l->to_differ_count, l->to_differ_capacity, ref);
}

/* Differentiates a value whose operands' derivatives are known. */
static void find_slope(Lower *l, Ref value, Direction direction)
{
    uint32_t origin = l->ir->origin;
    l->ir->origin = ir_at(l->ir, value)->origin;
    Ref slope = widened(l->ir, differentiate(l, value, direction), ir_type(l->ir, value));
    l->ir->origin = origin;
    if (slope && ir_is_number(l->ir, slope, 0))
        slope = 0;
    slope_set(l, value, direction, slope);
}

/* Visits operands first, from left to right, on an explicit stack: a tree of maps may be deeper
 * than the caller's stack. */
Ref slope_of(Lower *l, Ref value, Direction direction)
{
    size_t before = l->to_differ_count;
    push_unknown(l, value, direction);
    while (l->to_differ_count > before) {
        Ref ref = l->to_differ[l->to_differ_count - 1];
        size_t now = l->to_differ_count;
        for (int i = parts_of(l, ref) - 1; i >= 0 && *memo_of(l, ref, direction) == UNKNOWN; i--)
            push_unknown(l, part_of(l, ref, i), direction);
        if (l->to_differ_count > now)
            continue;
        l->to_differ_count--;
        if (*memo_of(l, ref, direction) == UNKNOWN)
            find_slope(l, ref, direction);
    }
    Ref slope = *memo_of(l, value, direction);
    return slope == FLAT ? 0 : slope;
}

Ref slope_detached(Lower *l, Ref value, Direction direction)
{
    Ref slope = slope_of(l, value, direction);
    if (!slope || ir_is(l->ir, slope, OP_const) || ir_is(l->ir, slope, OP_input) ||
        ir_is(l->ir, slope, OP_attribute))
        return slope;
    l->detached = true;
    return build_detach(l->ir, slope);
}

static Ref attach(Ir *ir, Ref ref, const void *user)
{
    (void)user;
    return ir_is(ir, ref, OP_detach) ? ir_arg(ir, ref, 0) : ref;
}

static bool has_marks(Ir *ir)
{
    const uint8_t *live = ir_live_kept(ir);
    for (Ref ref = 1; ref < ir->count; ref++)
        if (ir_is(ir, ref, OP_detach) && live[ref])
            return true;
    return false;
}

void slope_done(Lower *l)
{
    if (l->detached && has_marks(l->ir))
        ir_sweep(l->ir, attach, NULL);
    arena_reset(&l->ir->scratch);
}
