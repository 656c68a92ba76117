/* Filtered forms of the maps: closed means over boxes where there are any, fading octaves for noise, samples for the rest. */
#include "compiler/lower/area.h"
#include <math.h>

enum { MOST_ARGUMENTS = 8 }; /* of a function */

static Ref zero3(Lower *l) { return ir_vec3(l->ir, 0, 0, 0); }

/* The mean of what the taps gave. */
static Ref mean_of(Lower *l, const Ref *values, int count)
{
    Ref sum = values[0];
    for (int i = 1; i < count; i++)
        sum = add(l, sum, values[i]);
    return count > 1 ? mul(l, sum, number(l, 1.0 / count)) : sum;
}

/* A function of a position and what follows it. */
static Ref call_at(Lower *l, int function, Ref position, const Ref *args, int count)
{
    Ref all[MOST_ARGUMENTS] = {position};
    for (int k = 0; k < count; k++)
        all[k + 1] = args[k];
    return ir_call(l->ir, function, all, count + 1);
}

/* Functions (middle, rest, args, edge) and, of the variance that it leaves out, (args, edge). */
typedef struct {
    Function filtered, variance;
    Type type;
    double factor; /* on the variance */
} Octaves;

static Ref octaves_variance(Lower *l, const Octaves *o, const Ref *args, int count, Ref edge)
{
    Ref all[MOST_ARGUMENTS];
    for (int k = 0; k < count; k++)
        all[k] = args[k];
    all[count] = edge;
    Ref variance = mul(l, ir_call(l->ir, o->variance, all, count + 1), number(l, o->factor));
    return ir_convert(l->ir, variance, o->type);
}

static Answer octaves(Lower *l, const Octaves *o, Answer p, const Ref *args, int count)
{
    Tap taps[MOST_TAPS];
    Ref values[MOST_TAPS] = {0}, all[MOST_ARGUMENTS];
    LongCoordinate parts;
    int tap_count = footprint_taps(l, p, taps);
    Ref edge = tap_count ? footprint_greatest_lane(l, taps[0].edges) : number(l, 0);
    bool is_long = affine_coordinate(l, p.value, 1, &parts);
    for (int i = 0; i < tap_count + !tap_count; i++) {
        int used = 0;
        Ref middle = tap_count ? taps[i].middle : p.value;
        all[used++] = is_long ? parts.whole : middle;
        all[used++] = !is_long         ? zero3(l)
                      : tap_count <= 1 ? parts.fraction
                                       : add(l, parts.fraction, sub(l, middle, p.value));
        for (int k = 0; k < count; k++)
            all[used++] = args[k];
        all[used++] = edge;
        values[i] = ir_call(l->ir, o->filtered, all, used);
    }
    Answer mean = answer_of(mean_of(l, values, tap_count + !tap_count));
    if (tap_count)
        mean.variance = octaves_variance(l, o, args, count, edge);
    return mean;
}

static bool is_plain(Lower *l, Answer p)
{
    LongCoordinate parts;
    return !footprint_edges(l, p) && !affine_coordinate(l, p.value, 1, &parts);
}

/* Noise, by its function where nothing is filtered. */
static Answer noise(Lower *l, int plain, const Octaves *o, Answer p, const Ref args[3])
{
    return is_plain(l, p) ? answer_of(call_at(l, plain, p.value, args, 3)) : octaves(l, o, p, args, 3);
}

Answer area_turbulence(Lower *l, Answer p, const Ref args[3])
{
    static const Octaves scalar = {FN_turbulenceFiltered, FN_turbulenceVariance, TYPE_float, 1};
    return noise(l, FN_turbulence, &scalar, p, args);
}

Answer area_vector_turbulence(Lower *l, Answer p, const Ref args[3])
{
    /* a lane has the variance 0.26^2, the scalar noise 1/4; of simplex noise 0.256^2, 0.232 */
    static const Octaves lattice = {FN_vectorTurbulenceFiltered, FN_turbulenceVariance, TYPE_vec3, 0.26 * 0.26 / 0.25};
    static const Octaves simplex = {FN_vectorTurbulenceFiltered, FN_turbulenceVariance, TYPE_vec3,
                                    0.256 * 0.256 / 0.232};
    bool is_simplex = l->job->choice[AXIS_noise] == CHOICE_noise_simplex;
    return noise(l, FN_vectorTurbulence, is_simplex ? &simplex : &lattice, p, args);
}

/* Samples over the footprint: their mean, and their variance, which is exactly 0 where all are alike. */
static Answer sampled(Lower *l, int function, Ref p, const Ref *args, int count)
{
    Ref points[MOST_TAPS], values[MOST_TAPS] = {0}, squares[MOST_TAPS] = {0};
    int point_count = footprint_points(l, p, points);
    if (!point_count)
        return answer_of(call_at(l, function, p, args, count));
    for (int i = 0; i < point_count; i++)
        values[i] = call_at(l, function, points[i], args, count);
    Ref mean = mean_of(l, values, point_count);
    for (int i = 0; i < point_count; i++) {
        Ref apart = sub(l, values[i], mean);
        squares[i] = mul(l, apart, apart);
    }
    return (Answer){mean, mean_of(l, squares, point_count), NULL};
}

static Ref leopard(Lower *l, Answer p)
{
    Tap taps[MOST_TAPS];
    Ref values[MOST_TAPS] = {0};
    int count = footprint_taps(l, p, taps);
    for (int i = 0; i < count; i++)
        values[i] = ir_call(l->ir, FN_leopardFiltered, REFS(l->ir, taps[i].middle, taps[i].edges), 2);
    return count ? mean_of(l, values, count) : ir_call(l->ir, FN_FIRST_MAP + KIND_Leopard, &p.value, 1);
}

/* Wood is nearly linear over a pixel: it is filtered by the wave that follows it. */
Answer area_volume(Lower *l, Kind kind, Answer p, const Ref *args, int count)
{
    static const Octaves granite = {FN_graniteFiltered, FN_graniteVariance, TYPE_float, 1};
    const int plain = FN_FIRST_MAP + (int)kind;
    switch (kind) {
    case KIND_Granite:
        return is_plain(l, p) ? answer_of(call_at(l, plain, p.value, args, count))
                              : octaves(l, &granite, p, args, count);
    case KIND_Leopard:
        return answer_of(leopard(l, p));
    case KIND_Wood:
        return answer_of(call_at(l, plain, p.value, args, count));
    default:
        return sampled(l, plain, p.value, args, count);
    }
}

/* q without its whole part. It changes as q does, also where the parts of a long coordinate leave the change to the whole one. */
static Ref within_period(Lower *l, Ref q)
{
    LongCoordinate parts;
    if (!affine_coordinate(l, q, 1, &parts))
        return ir_unary(l->ir, OP_fract, q);
    Ref part = ir_unary(l->ir, OP_fract, parts.fraction);
    for (int d = 0; d < DIRECTION_COUNT; d++)
        slope_set(l, part, (Direction)d, slope_of(l, q, (Direction)d));
    return part;
}

Ref area_odd_share(Lower *l, Answer q)
{
    static const char *const lane[] = {"x", "y", "z"};
    int lanes = ir_lanes(l->ir, q.value);
    Ref edges = footprint_edges(l, q), product;
    if (!edges)
        return 0;
    Ref part = within_period(l, q.value), longer = footprint_longer(l, q, &edges);
    if (longer) {
        product = ir_call(l->ir, lanes == 2 ? FN_stripesAlong2 : FN_stripesAlong3, REFS(l->ir, part, longer, edges), 3);
    } else {
        Ref stripes = ir_call(l->ir, lanes == 2 ? FN_stripes2 : FN_stripes3, REFS(l->ir, part, edges), 2);
        product = ir_swizzle(l->ir, stripes, lane[0]);
        for (int k = 1; k < lanes; k++)
            product = mul(l, product, ir_swizzle(l->ir, stripes, lane[k]));
    }
    return sub(l, number(l, 0.5), mul(l, product, number(l, 0.5)));
}

Ref area_picture(Lower *l, Function function, Ref sampler, Ref uv, Ref size)
{
    Ref points[MOST_TAPS], values[MOST_TAPS] = {0};
    Ref right = slope_of(l, uv, DIRECTION_right), up = slope_of(l, uv, DIRECTION_up);
    if (!footprint_is_filtered(l) || (!right && !up))
        return ir_call(l->ir, function, REFS(l->ir, sampler, uv, size), 3);
    Ref none = ir_const(l->ir, TYPE_vec2, (double[]){0, 0});
    if (function == FN_imageBilinear)
        return ir_call(l->ir, FN_imageFiltered, REFS(l->ir, sampler, uv, size, right ? right : none, up ? up : none),
                       5);
    int count = footprint_points(l, uv, points);
    for (int i = 0; i < count; i++)
        values[i] = ir_call(l->ir, function, REFS(l->ir, sampler, points[i], size), 3);
    return mean_of(l, values, count);
}

Ref area_known_inverse(Lower *l, Ref low, Ref high)
{
    const double width = ir_known(l->ir, high)[0] - ir_known(l->ir, low)[0];
    if (width == 0)
        return number(l, 0);
    if (ir_is(l->ir, low, OP_const) && ir_is(l->ir, high, OP_const))
        return number(l, 1 / width);
    return ir_binary(l->ir, OP_div, number(l, 1), sub(l, high, low));
}

/* A step: the share of the box that is not below it; of no box, whether t is. */
static Ref step_share(Lower *l, Ref from, Ref edge)
{
    Ref zero = number(l, 0), one = number(l, 1), least = ir_unary(l->ir, OP_neg, edge);
    Ref along = add(l, over_edge(l, ir_ternary(l->ir, OP_clamp, from, least, edge), edge), number(l, 0.5));
    Ref is_box = ir_binary(l->ir, OP_lt, zero, edge);
    return ir_select(l->ir, is_box, ir_ternary(l->ir, OP_clamp, along, zero, one),
                     ir_binary(l->ir, OP_step, zero, from));
}

/* The mean of a ramp of width w over a box of edge b is a ramp too, as wide as the wider of the two, with both its bends rounded over
 * the narrower one: nothing cancels, whichever is how many times the other. Of the bends only one is near.
 *   w = 1, b = 4: the ramp begins at low - 3/2 and ends at high + 3/2; where it begins the box reaches to
 *   low + 1/2, and its mean is 1/32: a bend's share of 1/8, over 4 */
Ref area_ramp(Lower *l, Ref t, Ref edge, Ref low, Ref high)
{
    Ref zero = number(l, 0), one = number(l, 1), from = sub(l, t, low);
    if (ir_known(l->ir, high)[0] <= ir_known(l->ir, low)[0])
        return step_share(l, from, edge);
    Ref width = sub(l, high, low);
    Ref wider = ir_binary(l->ir, OP_max, edge, width), narrower = ir_binary(l->ir, OP_min, edge, width);
    Ref more = mul(l, sub(l, wider, width), number(l, 0.5));
    Ref begin = add(l, from, more), end = sub(l, sub(l, t, high), more);
    Ref place = ir_ternary(l->ir, OP_clamp, begin, ir_unary(l->ir, OP_neg, wider), add(l, wider, wider));
    Ref bends = sub(l, footprint_box_corner(l, begin, narrower), footprint_box_corner(l, end, narrower));
    Ref share = ir_ternary(l->ir, OP_clamp, over_edge(l, place, wider), zero, one);
    return add(l, share, over_edge(l, bends, wider));
}
