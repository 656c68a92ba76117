/* Footprints by differentiation: a width goes through every transform as a derivative does. */
#include "compiler/lower/footprint.h"

static const double BOX_VARIANCE = 12;     /* a box of edge b has the variance b^2 / 12 */
static const double LEAST_DIVISOR = 1e-37; /* a float that is no denormal */

static const Ref NO_VARIANCE = UINT32_MAX; /* in the memo: known to be none */

bool footprint_is_filtered(const Lower *l) { return l->job->choice[AXIS_aa] != CHOICE_aa_none && !l->filters; }

static Ref unary(Lower *l, Op op, Ref a) { return a ? ir_unary(l->ir, op, a) : 0; }

/* The edge of one box that stands for two, one after the other. Of a number, whose box is all that is known: their variances add. Of
 * a coordinate by lane the greater one, which is as good for checkers and noise, and cheaper. */
static Ref together(Lower *l, Ref a, Ref b)
{
    if (!a || !b)
        return unary(l, OP_abs, a ? a : b);
    if (ir_lanes(l->ir, a) > 1)
        return ir_binary(l->ir, OP_max, unary(l, OP_abs, a), unary(l, OP_abs, b));
    return unary(l, OP_sqrt, add(l, mul(l, a, a), mul(l, b, b)));
}

static Ref filled(Lower *l, Ref value, Type type) { return value ? value : ir_const(l->ir, type, (double[4]){0}); }

static Ref scaled(Lower *l, Ref value, double factor) { return mul(l, value, number(l, factor)); }

Ref footprint_longer(Lower *l, Ref coordinate, Ref *edges)
{
    Ref right = slope_of(l, coordinate, DIRECTION_right), up = slope_of(l, coordinate, DIRECTION_up);
    if (l->job->choice[AXIS_aa] != CHOICE_aa_aniso || !footprint_is_filtered(l) || !right || !up)
        return 0;
    Ref wide = ir_binary(l->ir, OP_lt, ir_binary(l->ir, OP_dot, up, up), ir_binary(l->ir, OP_dot, right, right));
    Ref longer = ir_select(l->ir, wide, right, up), shorter = ir_select(l->ir, wide, up, right);
    Ref part = scaled(l, longer, 1.0 / MOST_TAPS), variance = footprint_variance(l, coordinate);
    *edges = together(l, part, shorter);
    if (variance)
        *edges = unary(l, OP_sqrt, add(l, mul(l, *edges, *edges), scaled(l, variance, BOX_VARIANCE)));
    return longer;
}

int footprint_taps(Lower *l, Ref coordinate, Tap taps[MOST_TAPS])
{
    Ref edges = footprint_edges(l, coordinate);
    if (!edges)
        return 0;
    Ref longer = footprint_longer(l, coordinate, &edges);
    if (!longer) {
        taps[0] = (Tap){coordinate, edges};
        return 1;
    }
    for (int i = 0; i < MOST_TAPS; i++)
        taps[i] = (Tap){add(l, coordinate, scaled(l, longer, (i + 0.5) / MOST_TAPS - 0.5)), edges};
    return MOST_TAPS;
}

/* A grid that is turned, so that every row and column of the pixel's sixteenths has a point. */
int footprint_points(Lower *l, Ref coordinate, Ref points[MOST_TAPS])
{
    static const double place[MOST_TAPS][2] = {
        {-1.0 / 8, -3.0 / 8}, {3.0 / 8, -1.0 / 8}, {-3.0 / 8, 1.0 / 8}, {1.0 / 8, 3.0 / 8}};
    Ref right = slope_of(l, coordinate, DIRECTION_right), up = slope_of(l, coordinate, DIRECTION_up);
    Type type = ir_type(l->ir, coordinate);
    if (!footprint_is_filtered(l) || (!right && !up))
        return 0;
    right = filled(l, right, type);
    up = filled(l, up, type);
    for (int i = 0; i < MOST_TAPS; i++)
        points[i] = add(l, coordinate, add(l, scaled(l, right, place[i][0]), scaled(l, up, place[i][1])));
    return MOST_TAPS;
}

Ref footprint_edges(Lower *l, Ref value)
{
    if (!footprint_is_filtered(l))
        return 0;
    Ref right = slope_of(l, value, DIRECTION_right), up = slope_of(l, value, DIRECTION_up);
    Ref edges = together(l, right, up);
    Ref variance = footprint_variance(l, value);
    if (variance) {
        Ref square = scaled(l, variance, BOX_VARIANCE);
        edges = unary(l, OP_sqrt, edges ? add(l, mul(l, edges, edges), square) : square);
    }
    return edges;
}

Ref footprint_greatest_lane(Lower *l, Ref value)
{
    static const char *const lane[] = {"x", "y", "z", "w"};
    Ref greatest = ir_swizzle(l->ir, value, "x");
    for (int i = 1; i < ir_lanes(l->ir, value); i++)
        greatest = ir_binary(l->ir, OP_max, greatest, ir_swizzle(l->ir, value, lane[i]));
    return greatest;
}

Ref box_over(Lower *l, Ref x, Ref edge)
{
    Ref over = sub(l, scaled(l, edge, 0.5), unary(l, OP_abs, x));
    return ir_binary(l->ir, OP_max, over, number(l, 0));
}

Ref over_edge(Lower *l, Ref part, Ref edge)
{
    return ir_binary(l->ir, OP_div, part, ir_binary(l->ir, OP_max, edge, number(l, LEAST_DIVISOR)));
}

/* The quotient, at most 1/2, comes before the product, which is then neither too great nor too small for a float. */
Ref footprint_box_corner(Lower *l, Ref x, Ref edge)
{
    Ref over = box_over(l, x, edge);
    return mul(l, scaled(l, over, 0.5), over_edge(l, over, edge));
}

void footprint_set_variance(Lower *l, Ref value, Ref variance)
{
    l->variances = arena_reach(l->session->arena, l->variances, value, &l->variance_room, sizeof *l->variances);
    l->variances[value] = variance ? variance : NO_VARIANCE;
}

void footprint_set_split(Lower *l, Ref value, Split split)
{
    l->splits = arena_reach(l->session->arena, l->splits, value, &l->split_room, sizeof *l->splits);
    l->splits[value] = split;
}

Split footprint_split(Lower *l, Ref value)
{
    for (; value; value = settled_operand(l, value))
        if (value < l->split_room && l->splits[value].share)
            return l->splits[value];
    return (Split){0, 0, 0};
}

#define sum(l, a, b) sum_of(l, REFS((l)->ir, a, b))
static Ref sum_of(Lower *l, const Ref x[2]) { return !x[0] ? x[1] : !x[1] ? x[0] : add(l, x[0], x[1]); }

static Ref lane_variance(Lower *l, Ref ref, const IrNode *node)
{
    Ref a = ir_arg(l->ir, ref, 0), b = node->count > 1 ? ir_arg(l->ir, ref, 1) : 0;
    Ref by_a = footprint_variance(l, a), by_b = b ? footprint_variance(l, b) : 0;
    switch (node->op) {
    case OP_neg:
    case OP_fract:
        return by_a;
    case OP_add:
    case OP_sub:
        return sum(l, by_a, by_b);
    case OP_mul:
        return sum(l, by_a ? mul(l, by_a, mul(l, b, b)) : 0, by_b ? mul(l, by_b, mul(l, a, a)) : 0);
    case OP_dot:
        return sum(l, by_a ? ir_binary(l->ir, OP_dot, by_a, mul(l, b, b)) : 0,
                   by_b ? ir_binary(l->ir, OP_dot, by_b, mul(l, a, a)) : 0);
    default:
        return 0;
    }
}

static Ref linear_variance(Lower *l, Ref ref, const IrNode *node)
{
    Ref args[5] = {footprint_variance(l, ir_arg(l->ir, ref, 0))};
    if (!args[0])
        return 0;
    for (int i = 1; i < node->count; i++)
        args[i] = mul(l, ir_arg(l->ir, ref, i), ir_arg(l->ir, ref, i));
    return ir_make(l->ir, OP_linear, (Type)node->type, 0, args, node->count);
}

static Ref vec_variance(Lower *l, Ref ref, const IrNode *node)
{
    Ref parts[4];
    bool any = false;
    for (int i = 0; i < node->count; i++) {
        Ref part = ir_arg(l->ir, ref, i), variance = footprint_variance(l, part);
        any |= variance != 0;
        parts[i] = filled(l, variance, ir_type(l->ir, part));
    }
    return any ? ir_vec(l->ir, (Type)node->type, parts, node->count) : 0;
}

/* Through what is linear; anything else is taken to leave none. */
static Ref derive(Lower *l, Ref ref)
{
    const IrNode node = *ir_at(l->ir, ref);
    Ref settled = settled_operand(l, ref);
    if (!node.count)
        return 0;
    if (settled)
        return footprint_variance(l, settled);
    if (node.op == OP_linear)
        return linear_variance(l, ref, &node);
    if (node.op == OP_vec)
        return vec_variance(l, ref, &node);
    if (node.op == OP_swizzle) {
        Ref whole = footprint_variance(l, ir_arg(l->ir, ref, 0));
        return whole ? ir_swizzle_lanes(l->ir, whole, node.payload, type_table[node.type].lanes) : 0;
    }
    Ref variance = lane_variance(l, ref, &node);
    bool narrow = variance && ir_lanes(l->ir, variance) < type_table[node.type].lanes;
    return narrow ? ir_vec(l->ir, (Type)node.type, REFS(l->ir, variance, variance, variance, variance),
                           type_table[node.type].lanes)
                  : variance;
}

static Ref known_variance(const Lower *l, Ref value) { return value < l->variance_room ? l->variances[value] : 0; }

static void push_unknown(Lower *l, Ref ref)
{
    if (!known_variance(l, ref))
        ARENA_PUSH(l->session->arena, l->to_vary, l->to_vary_count, l->to_vary_room, ref);
}

/* Operands of which a variance is made; the others are taken to have none. */
static int varying_operands(const IrNode *node)
{
    enum { MOST_VARYING = 2 };
    return node->op == OP_vec           ? node->count
           : node->op == OP_linear      ? 1
           : node->count < MOST_VARYING ? node->count
                                        : MOST_VARYING;
}

static void push_operands(Lower *l, Ref ref)
{
    Ref settled = settled_operand(l, ref);
    if (settled)
        push_unknown(l, settled);
    for (int i = varying_operands(ir_at(l->ir, ref)) - 1; i >= 0 && !settled; i--)
        push_unknown(l, ir_arg(l->ir, ref, i));
}

/* Operands first, the left one before the right, on a stack of its own. */
Ref footprint_variance(Lower *l, Ref value)
{
    size_t before = l->to_vary_count;
    push_unknown(l, value);
    while (l->to_vary_count > before) {
        Ref ref = l->to_vary[l->to_vary_count - 1];
        size_t now = l->to_vary_count;
        if (!known_variance(l, ref))
            push_operands(l, ref);
        if (l->to_vary_count > now)
            continue;
        l->to_vary_count--;
        if (!known_variance(l, ref))
            footprint_set_variance(l, ref, derive(l, ref));
    }
    Ref variance = known_variance(l, value);
    return variance == NO_VARIANCE ? 0 : variance;
}
