/* Footprints by differentiation: a width goes through every transform as a derivative does. */
#include "compiler/lower/footprint.h"

static const double BOX_VARIANCE = 12;     /* a box of edge b has the variance b^2 / 12 */
static const double LEAST_DIVISOR = 1e-37; /* a float that is no denormal */

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

/* The edge of a box as far as slopes tell, and the box that varies as much as what they do not: their variances add. */
static Ref with_variance(Lower *l, Ref edges, Ref variance)
{
    if (!variance)
        return edges;
    Ref square = scaled(l, variance, BOX_VARIANCE);
    return unary(l, OP_sqrt, edges ? add(l, mul(l, edges, edges), square) : square);
}

Ref footprint_longer(Lower *l, Answer coordinate, Ref *edges)
{
    Ref right = slope_of(l, coordinate.value, DIRECTION_right), up = slope_of(l, coordinate.value, DIRECTION_up);
    if (l->job->choice[AXIS_aa] != CHOICE_aa_aniso || !footprint_is_filtered(l) || !right || !up)
        return 0;
    Ref wide = ir_binary(l->ir, OP_lt, ir_binary(l->ir, OP_dot, up, up), ir_binary(l->ir, OP_dot, right, right));
    Ref longer = ir_select(l->ir, wide, right, up), shorter = ir_select(l->ir, wide, up, right);
    Ref part = scaled(l, longer, 1.0 / MOST_TAPS);
    *edges = with_variance(l, together(l, part, shorter), coordinate.variance);
    return longer;
}

int footprint_taps(Lower *l, Answer coordinate, Tap taps[MOST_TAPS])
{
    Ref edges = footprint_edges(l, coordinate);
    if (!edges)
        return 0;
    Ref longer = footprint_longer(l, coordinate, &edges);
    if (!longer) {
        taps[0] = (Tap){coordinate.value, edges};
        return 1;
    }
    for (int i = 0; i < MOST_TAPS; i++)
        taps[i] = (Tap){add(l, coordinate.value, scaled(l, longer, (i + 0.5) / MOST_TAPS - 0.5)), edges};
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

Ref footprint_edges(Lower *l, Answer a)
{
    if (!footprint_is_filtered(l))
        return 0;
    Ref right = slope_of(l, a.value, DIRECTION_right), up = slope_of(l, a.value, DIRECTION_up);
    return with_variance(l, together(l, right, up), a.variance);
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
