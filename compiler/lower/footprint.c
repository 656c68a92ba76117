/* Footprints by differentiation: a width passes through every transform as a derivative does.
 *
 *     u changes by .01 to the next pixel on the right, and by 0 to the one above; a Checker
 *     reads v = 8 u
 *     slopes of v:  .08 and 0
 *     footprint_edges: sqrt(.08^2 + 0^2) = .08 of the checker's coordinate
 *     if a mean below left a variance of .0001 in v: sqrt(.08^2 + 12 * .0001) = .087 */
#include "compiler/lower/footprint.h"

static const double BOX_VARIANCE = 12;   /* a box filter of width b has the variance b^2 / 12 */
static const double MIN_DIVISOR = 1e-37; /* min divisor, a normal (not denormal) float */

bool footprint_may_average(Kind kind)
{
    const KindRow *row = &kind_table[kind];
    if (row->lowering == LOWERING_VOLUME)
        return row->filter == FILTER_box || row->filter == FILTER_point;
    return kind == KIND_Checker || kind == KIND_VolumeChecker || kind == KIND_Gradient;
}

bool footprint_is_filtered(const Lower *l)
{
    const Choice aa = l->job->choice[AXIS_aa];
    if (aa == CHOICE_aa_auto)
        return l->map && l->map->index < l->averaged_below && footprint_may_average(l->map->kind) &&
               !l->filters;
    return aa != CHOICE_aa_none && !l->filters;
}

/* Returns the edge of one box that replaces the convolution of two. For a scalar, whose box is
 * all that is known, the variances add. For a vector the greater edge is taken per component,
 * which is as good for checkers and noise, and cheaper. */
static Ref together(Lower *l, Ref a, Ref b)
{
    Ir *ir = l->ir;
    if (!a && !b)
        return 0;
    if (!a || !b)
        return build_abs(ir, a ? a : b);
    if (ir_components(ir, a) > 1)
        return build_max(ir, build_abs(ir, a), build_abs(ir, b));
    return build_sqrt(ir, build_add(ir, build_square(ir, a), build_square(ir, b)));
}

/* Returns the edge of a box from the slopes, combined with the variance that the slopes do not
 * account for: variances add. */
static Ref with_variance(Lower *l, Ref edges, Ref variance)
{
    Ir *ir = l->ir;
    if (!variance)
        return edges;
    Ref square = build_scale(ir, variance, BOX_VARIANCE);
    return build_sqrt(ir, edges ? build_add(ir, build_square(ir, edges), square) : square);
}

Ref footprint_longer(Lower *l, MapValue coordinate, Ref *edges)
{
    Ir *ir = l->ir;
    Ref right = slope_detached(l, coordinate.value, DIRECTION_right),
        up = slope_detached(l, coordinate.value, DIRECTION_up);
    if (l->job->choice[AXIS_aa] != CHOICE_aa_aniso || !footprint_is_filtered(l) || !right || !up)
        return 0;
    Ref wide = build_lt(ir, build_dot(ir, up, up), build_dot(ir, right, right));
    Ref longer = build_select(ir, wide, right, up), shorter = build_select(ir, wide, up, right);
    Ref part = build_scale(ir, longer, 1.0 / MAX_TAPS);
    *edges = with_variance(l, together(l, part, shorter), coordinate.variance);
    return longer;
}

int footprint_taps(Lower *l, MapValue coordinate, Tap taps[MAX_TAPS])
{
    Ir *ir = l->ir;
    Ref edges = footprint_edges(l, coordinate);
    if (!edges)
        return 0;
    Ref longer = footprint_longer(l, coordinate, &edges);
    if (!longer) {
        taps[0] = (Tap){coordinate.value, edges};
        return 1;
    }
    for (int i = 0; i < MAX_TAPS; i++)
        taps[i] = (Tap){
            build_add(ir, coordinate.value, build_scale(ir, longer, (i + 0.5) / MAX_TAPS - 0.5)),
            edges};
    return MAX_TAPS;
}

/* Places the points on a rotated grid, so that every row and column of the pixel's 4 x 4
 * subpixels has one point. */
int footprint_points(Lower *l, Ref coordinate, Ref points[MAX_TAPS])
{
    Ir *ir = l->ir;
    static const double offset[MAX_TAPS][2] = {
        {-1.0 / 8, -3.0 / 8}, {3.0 / 8, -1.0 / 8}, {-3.0 / 8, 1.0 / 8}, {1.0 / 8, 3.0 / 8}};
    Ref right = slope_detached(l, coordinate, DIRECTION_right),
        up = slope_detached(l, coordinate, DIRECTION_up);
    Type type = ir_type(ir, coordinate);
    if (!footprint_is_filtered(l) || (!right && !up))
        return 0;
    right = build_or_zero(ir, right, type);
    up = build_or_zero(ir, up, type);
    for (int i = 0; i < MAX_TAPS; i++)
        points[i] = build_add(
            ir, coordinate,
            build_add(ir, build_scale(ir, right, offset[i][0]), build_scale(ir, up, offset[i][1])));
    return MAX_TAPS;
}

Ref footprint_edges(Lower *l, MapValue a)
{
    if (!footprint_is_filtered(l))
        return 0;
    Ref right = slope_detached(l, a.value, DIRECTION_right),
        up = slope_detached(l, a.value, DIRECTION_up);
    return with_variance(l, together(l, right, up), a.variance);
}

Ref footprint_greatest_component(Lower *l, Ref value)
{
    Ir *ir = l->ir;
    static const char *const component[] = {"x", "y", "z", "w"};
    Ref greatest = build_swizzle(ir, value, "x");
    for (int i = 1; i < ir_components(ir, value); i++)
        greatest = build_max(ir, greatest, build_swizzle(ir, value, component[i]));
    return greatest;
}

/* Returns max(b / 2 - |x|, 0): the length by which a box of edge b around x reaches over 0. */
static Ref footprint_over(Lower *l, Ref x, Ref edge)
{
    Ir *ir = l->ir;
    Ref over = build_sub(ir, build_scale(ir, edge, 0.5), build_abs(ir, x));
    return build_max(ir, over, build_float(ir, 0));
}

Ref footprint_over_edge(Lower *l, Ref part, Ref edge)
{
    Ir *ir = l->ir;
    return build_div(ir, part, build_max(ir, edge, build_float(ir, MIN_DIVISOR)));
}

/* Computes the quotient, at most 1/2, before the product, so that neither overflows or
 * underflows a float. */
Ref footprint_box_corner(Lower *l, Ref x, Ref edge)
{
    Ir *ir = l->ir;
    Ref over = footprint_over(l, x, edge);
    return build_mul(ir, build_scale(ir, over, 0.5), footprint_over_edge(l, over, edge));
}
