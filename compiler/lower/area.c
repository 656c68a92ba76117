/* Filtered forms of the maps: closed-form means over boxes where they exist, fading octaves for
 * noise, samples for the rest. */
#include "compiler/lower/address.h"
#include "compiler/lower/area.h"
#include "compiler/lower/cells.h"
#include <math.h>

enum { MAX_ARGUMENTS = 8 }; /* max arguments of a library function */

/* Returns the mean of the values at all taps. */
static Ref mean_of(Lower *l, const Ref *values, int count)
{
    Ir *ir = l->ir;
    Ref sum = values[0];
    for (int i = 1; i < count; i++)
        sum = build_add(ir, sum, values[i]);
    return count > 1 ? build_scale(ir, sum, 1.0 / count) : sum;
}

/* Calls a library function of a position and further arguments. */
static Ref call_at(Lower *l, int function, Ref position, const Ref *args, int count)
{
    Ref all[MAX_ARGUMENTS] = {position};
    for (int k = 0; k < count; k++)
        all[k + 1] = args[k];
    return build_call_of(l->ir, function, all, count + 1);
}

/* Library functions of a fading noise: the mean (middle, rest, args, edge), and the variance
 * that it leaves out (args, edge). */
typedef struct {
    Function filtered, variance;
    Type type;
    double factor; /* factor of the variance */
} Octaves;

static Ref octaves_variance(Lower *l, const Octaves *o, const Ref *args, int count, Ref edge)
{
    Ir *ir = l->ir;
    Ref all[MAX_ARGUMENTS];
    for (int k = 0; k < count; k++)
        all[k] = args[k];
    all[count] = edge;
    Ref variance = build_scale(ir, build_call_of(ir, o->variance, all, count + 1), o->factor);
    return build_convert(ir, variance, o->type);
}

static MapValue octaves(Lower *l, const Octaves *o, MapValue p, const Ref *args, int count)
{
    Ir *ir = l->ir;
    Tap taps[MAX_TAPS];
    Ref values[MAX_TAPS] = {0}, all[MAX_ARGUMENTS];
    LongCoordinate parts;
    int tap_count = footprint_taps(l, p, taps);
    Ref edge = tap_count ? footprint_greatest_component(l, taps[0].edges) : build_float(ir, 0);
    bool is_long = affine_coordinate(l, p.value, 1, &parts);
    for (int i = 0; i < tap_count + !tap_count; i++) {
        int used = 0;
        Ref middle = tap_count ? taps[i].middle : p.value;
        all[used++] = is_long ? parts.whole : middle;
        all[used++] = !is_long ? build_vec3(ir, 0, 0, 0)
                      : tap_count <= 1
                          ? parts.fraction
                          : build_add(ir, parts.fraction, build_sub(ir, middle, p.value));
        for (int k = 0; k < count; k++)
            all[used++] = args[k];
        all[used++] = edge;
        values[i] = build_call_of(ir, o->filtered, all, used);
    }
    MapValue mean = map_value_of(mean_of(l, values, tap_count + !tap_count));
    if (tap_count)
        mean.variance = octaves_variance(l, o, args, count, edge);
    return mean;
}

static bool is_plain(Lower *l, MapValue p)
{
    LongCoordinate parts;
    return !footprint_edges(l, p) && !affine_coordinate(l, p.value, 1, &parts);
}

/* Lowers noise; calls the plain function where nothing is filtered. */
static MapValue noise(Lower *l, int plain, const Octaves *o, MapValue p, const Ref args[3])
{
    return is_plain(l, p) ? map_value_of(call_at(l, plain, p.value, args, 3))
                          : octaves(l, o, p, args, 3);
}

MapValue area_turbulence(Lower *l, MapValue p, const Ref args[3])
{
    static const Octaves scalar = {FN_turbulenceFiltered, FN_turbulenceVariance, TYPE_float, 1};
    return noise(l, FN_turbulence, &scalar, p, args);
}

MapValue area_vector_turbulence(Lower *l, MapValue p, const Ref args[3])
{
    /* Variance of a component 0.26^2, of the scalar noise 1/4; for simplex noise 0.256^2 and
     * 0.232. */
    static const Octaves lattice = {FN_vectorTurbulenceFiltered, FN_turbulenceVariance, TYPE_vec3,
                                    0.26 * 0.26 / 0.25};
    static const Octaves simplex = {FN_vectorTurbulenceFiltered, FN_turbulenceVariance, TYPE_vec3,
                                    0.256 * 0.256 / 0.232};
    bool is_simplex = l->job->choice[AXIS_noise] == CHOICE_noise_simplex;
    return noise(l, FN_vectorTurbulence, is_simplex ? &simplex : &lattice, p, args);
}

/* Calls the map's own function at a point. */
static MapValue point(Lower *l, Kind kind, MapValue p, const Ref *args, int count)
{
    return map_value_of(call_at(l, FN_FIRST_MAP + (int)kind, p.value, args, count));
}

/* Fades four samples to the mean of all cells where cells are small: from 1.5 cells per pixel
 * on, completely at 3.5. There the samples are noisier than the mean. */
static MapValue far_away(Lower *l, Kind kind, MapValue p, const Ref *args, MapValue near)
{
    Ir *ir = l->ir;
    const double begin = 1.5, width = 2;
    Ref edges = kind_table[kind].far == FAR_unknown ? 0 : footprint_edges(l, p);
    MapValue far;
    if (!edges || !cells_far(l, (Far)kind_table[kind].far, args, &far))
        return near;
    Ref beyond = build_sub(ir, footprint_greatest_component(l, edges), build_float(ir, begin));
    Ref share =
        build_clamp(ir, build_scale(ir, beyond, 1 / width), build_float(ir, 0), build_float(ir, 1));
    Ref value = build_mix(ir, near.value, far.value, share);
    return (MapValue){value, build_mix(ir, near.variance, far.variance, share), NULL};
}

/* Samples the map over the footprint. Returns the mean, and the variance, which is exactly 0
 * where all samples are equal. */
static MapValue sampled(Lower *l, Kind kind, MapValue p, const Ref *args, int count)
{
    Ir *ir = l->ir;
    Ref points[MAX_TAPS], values[MAX_TAPS] = {0}, squares[MAX_TAPS] = {0};
    int point_count = footprint_points(l, p.value, points);
    if (!point_count)
        return point(l, kind, p, args, count);
    for (int i = 0; i < point_count; i++)
        values[i] = call_at(l, FN_FIRST_MAP + (int)kind, points[i], args, count);
    Ref mean = mean_of(l, values, point_count);
    for (int i = 0; i < point_count; i++) {
        Ref apart = build_sub(ir, values[i], mean);
        squares[i] = build_square(ir, apart);
    }
    return far_away(l, kind, p, args, (MapValue){mean, mean_of(l, squares, point_count), NULL});
}

/* Returns closed-form means over boxes, by functions (middle, edges, args). */
static MapValue boxes(Lower *l, Kind kind, MapValue p, const Ref *args, int count)
{
    Tap taps[MAX_TAPS];
    Ref values[MAX_TAPS] = {0}, all[MAX_ARGUMENTS];
    int tap_count = footprint_taps(l, p, taps);
    for (int k = 0; k < count; k++)
        all[k + 1] = args[k];
    for (int i = 0; i < tap_count; i++) {
        all[0] = taps[i].edges;
        values[i] = call_at(l, kind_table[kind].mean, taps[i].middle, all, count + 1);
    }
    return tap_count ? map_value_of(mean_of(l, values, tap_count)) : point(l, kind, p, args, count);
}

static MapValue fading(Lower *l, Kind kind, MapValue p, const Ref *args, int count)
{
    const Octaves own = {(Function)kind_table[kind].mean, (Function)kind_table[kind].variance,
                         TYPE_float, 1};
    return is_plain(l, p) ? point(l, kind, p, args, count) : octaves(l, &own, p, args, count);
}

MapValue area_volume(Lower *l, Kind kind, MapValue p, const Ref *args, int count)
{
    static MapValue (*const filters[])(Lower *, Kind, MapValue, const Ref *,
                                       int) = {[FILTER_samples] = sampled,
                                               [FILTER_point] = point,
                                               [FILTER_box] = boxes,
                                               [FILTER_octaves] = fading};
    return filters[kind_table[kind].filter](l, kind, p, args, count);
}

/* Returns q without its integer part. The derivative is q's, even if the parts of a long
 * coordinate assign it to the integer part. */
static Ref within_period(Lower *l, Ref q)
{
    Ir *ir = l->ir;
    LongCoordinate parts;
    if (!affine_coordinate(l, q, 1, &parts))
        return build_fract(ir, q);
    Ref part = build_fract(ir, parts.fraction);
    for (int d = 0; d < DIRECTION_COUNT; d++)
        slope_set(l, part, (Direction)d, slope_of(l, q, (Direction)d));
    return part;
}

Ref area_odd_share(Lower *l, MapValue q)
{
    Ir *ir = l->ir;
    static const char *const component[] = {"x", "y", "z"};
    int components = ir_components(ir, q.value);
    Ref edges = footprint_edges(l, q), product;
    if (!edges)
        return 0;
    Ref part = within_period(l, q.value), longer = footprint_longer(l, q, &edges);
    if (longer) {
        product = build_call(ir, components == 2 ? FN_stripesAlong2 : FN_stripesAlong3, part,
                             longer, edges);
    } else {
        Ref stripes = build_call(ir, components == 2 ? FN_stripes2 : FN_stripes3, part, edges);
        product = build_swizzle(ir, stripes, component[0]);
        for (int k = 1; k < components; k++)
            product = build_mul(ir, product, build_swizzle(ir, stripes, component[k]));
    }
    return build_sub(ir, build_float(ir, 0.5), build_scale(ir, product, 0.5));
}

/* Returns true for a varying, or components of one: all pixels of a quad have the value, helper
 * invocations included. */
static bool is_varying(const Ir *ir, Ref uv)
{
    while (ir_is(ir, uv, OP_swizzle))
        uv = ir_arg(ir, uv, 0);
    return ir_is(ir, uv, OP_input) || ir_is(ir, uv, OP_attribute);
}

/* Returns true if the coordinate may depend on a number in a storage buffer that materials
 * share. Mesa's llvmpipe reads 0 from the buffer in helper invocations, so a quad at a
 * triangle's edge would span the whole image, and its coarsest mipmap would be drawn. */
static bool may_read_buffer(const Lower *l, Ref uv)
{
    return l->job->instances && !is_varying(l->ir, uv);
}

/* Selects the library function. The sampler derives the footprint from the neighboring pixels
 * (texture) if these surely compute the same coordinate without a seam between them. Otherwise
 * the program passes the footprint (textureGrad): in branches, in the functions of filters,
 * where the view ray makes the texture coordinate, and where numbers come from a buffer. GLSL
 * 1.10 lacks textureGrad, so it has no sampler in filter functions, and no buffers. */
Function area_picture_function(const Lower *l, Ref uv, bool smooth)
{
    const bool by_ray = l->job->pass == PASS_sky || l->job->pass == PASS_plane;
    const bool passed = l->arms || l->filters || by_ray || may_read_buffer(l, uv);
    if (!smooth)
        return FN_imageNearest;
    if (l->job->choice[AXIS_aa] != CHOICE_aa_auto)
        return FN_imageBilinear;
    if (!target_table[l->job->target].words)
        return l->filters ? FN_imageBilinear : FN_imageSampled;
    return passed ? FN_imageSampledOver : FN_imageSampled;
}

static bool is_sampler(Function function)
{
    return function == FN_imageSampled || function == FN_imageSampledOver;
}

static Addressed addressed(const Picture *p)
{
    return (Addressed){p->address, p->function != FN_imageNearest, p->size};
}

/* Returns the coordinate that the function reads for uv; a sampler gets uv itself. */
static Ref place_of(Lower *l, const Picture *p, Ref uv)
{
    const Addressed a = addressed(p);
    return is_sampler(p->function) ? uv : address_place(l->ir, &a, uv);
}

/* Multiplies by the image's share for a border, which is black. */
static Ref with_border(Lower *l, const Picture *p, Ref value, const Ref at[2])
{
    const Addressed a = addressed(p);
    Ref share = address_share(l->ir, &a, at[0], at[1]);
    return share ? build_mul(l->ir, value, build_splat(l->ir, share, TYPE_vec4)) : value;
}

typedef struct {
    Ref right, up; /* change of uv to the neighboring pixels; 0: none */
} Spread;

static Spread spread_of(Lower *l, Ref uv)
{
    Ref right = slope_detached(l, uv, DIRECTION_right), up = slope_detached(l, uv, DIRECTION_up);
    return (Spread){right, up};
}

static Ref picture_over(Lower *l, Function function, const Picture *p, Ref point, Spread spread)
{
    Ir *ir = l->ir;
    Ref right = build_or_zero(ir, spread.right, TYPE_vec2),
        up = build_or_zero(ir, spread.up, TYPE_vec2);
    return build_call(ir, function, p->sampler, point, p->size, right, up);
}

/* Returns the texels that a pixel covers, per component; 0: none, or the address is no border. */
static Ref texels_across(Lower *l, const Picture *p, Spread spread)
{
    Ir *ir = l->ir;
    if (p->address != KEYWORD_Address_border || (!spread.right && !spread.up))
        return 0;
    Ref right = build_abs(ir, build_or_zero(ir, spread.right, TYPE_vec2));
    Ref up = build_abs(ir, build_or_zero(ir, spread.up, TYPE_vec2));
    return build_mul(ir, build_max(ir, right, up), p->size);
}

Ref area_picture_near(Lower *l, const Picture *p, Ref point, Ref uv)
{
    Ir *ir = l->ir;
    Ref place = place_of(l, p, point), wide = 0, value;
    if (is_sampler(p->function))
        wide = texels_across(
            l, p, p->address == KEYWORD_Address_border ? spread_of(l, uv) : (Spread){0, 0});
    if (p->function == FN_imageSampledOver)
        value = picture_over(l, p->function, p, place, spread_of(l, uv));
    else
        value = build_call(ir, p->function, p->sampler, place, p->size);
    return with_border(l, p, value, (Ref[]){point, wide});
}

/* Returns the slope of an image whose sampler does all addressing. With the neighbors' footprint
 * the image is read outside of every branch, which is faster than passing a footprint within
 * one: on an H100 three reads take 0.2 ns a pixel, with passed footprints 0.8. */
static Ref rise_over(Lower *l, const Picture *p, Ref uv, Ref component, Ref shown)
{
    Ir *ir = l->ir;
    const Keyword wrap = ir->textures[ir_at(ir, p->sampler)->payload].wrap;
    const Spread spread = spread_of(l, uv);
    Ref args[7] = {p->sampler, uv, p->size, component};
    int count = 4;
    if (wrap != KEYWORD_Address_repeat)
        args[count++] = build_int(ir, wrap - KEYWORD_Address_repeat);
    args[count++] = build_or_zero(ir, spread.right, TYPE_vec2);
    args[count++] = build_or_zero(ir, spread.up, TYPE_vec2);
    if (wrap != KEYWORD_Address_repeat)
        return build_call_of(ir, FN_imageRiseBeyond, args, count);
    if (p->function == FN_imageSampledOver)
        return build_call_of(ir, FN_imageRiseOver, args, count);
    args[count++] = shown;
    return build_call_of(ir, FN_imageRiseNear, args, count);
}

/* Returns the change over one texel. GLSL 1.10 cannot fetch texels of a texture with mipmaps. */
Ref area_picture_rise(Lower *l, const Picture *p, Ref uv, int component, Ref shown)
{
    Ir *ir = l->ir;
    Ref number = build_int(ir, component);
    if (p->address != KEYWORD_Address_repeat)
        return 0;
    if (p->function == FN_imageBilinear)
        return build_call(ir, FN_imageRise, p->sampler, uv, p->size, number);
    if (!is_sampler(p->function) || !target_table[l->job->target].words)
        return 0;
    return rise_over(l, p, uv, number, shown);
}

/* Reads mipmaps. The footprint is that of the unfolded coordinate, which is reversed where the
 * image is mirrored. */
static Ref picture_filtered(Lower *l, const Picture *p, Ref uv, Spread spread)
{
    const Addressed a = addressed(p);
    Ref unfolded = address_unfolded(l->ir, &a, uv), wide = texels_across(l, p, spread);
    Ref place = place_of(l, p, uv);
    Ref value = picture_over(l, FN_imageFiltered, p, place, spread_of(l, unfolded));
    return with_border(l, p, value, (Ref[]){uv, wide});
}

Ref area_picture(Lower *l, const Picture *p, Ref uv)
{
    Ref points[MAX_TAPS], values[MAX_TAPS] = {0};
    const Spread spread = spread_of(l, uv);
    const bool has_mipmaps =
        target_table[l->job->target].words || p->address == KEYWORD_Address_repeat;
    if (is_sampler(p->function) || !footprint_is_filtered(l) || (!spread.right && !spread.up))
        return area_picture_near(l, p, uv, uv);
    if (p->function == FN_imageBilinear && has_mipmaps)
        return picture_filtered(l, p, uv, spread);
    int count = footprint_points(l, uv, points);
    for (int i = 0; i < count; i++)
        values[i] = area_picture_near(l, p, points[i], uv);
    return mean_of(l, values, count);
}

Ref area_known_inverse(Lower *l, Ref low, Ref high)
{
    Ir *ir = l->ir;
    const double width = ir_known(ir, high)[0] - ir_known(ir, low)[0];
    if (width == 0)
        return build_float(ir, 0);
    if (ir_is(ir, low, OP_const) && ir_is(ir, high, OP_const))
        return build_float(ir, 1 / width);
    return build_div(ir, build_float(ir, 1), build_sub(ir, high, low));
}

/* Returns the share of the box that a step has passed; without a box, 1 or 0 by the point t. */
static Ref step_share(Lower *l, Ref from, Ref edge)
{
    Ir *ir = l->ir;
    Ref zero = build_float(ir, 0), one = build_float(ir, 1), least = build_neg(ir, edge);
    Ref along = build_add(ir, footprint_over_edge(l, build_clamp(ir, from, least, edge), edge),
                          build_float(ir, 0.5));
    Ref is_box = build_lt(ir, zero, edge);
    return build_select(ir, is_box, build_clamp(ir, along, zero, one), build_step(ir, zero, from));
}

/* The mean of a ramp of width w over a box of edge b is a ramp too, as wide as the wider of the
 * two, with both its bends rounded over the narrower one. Nothing cancels, whatever the ratio of
 * both widths. At most one bend is near.
 *   w = 1, b = 4: the ramp begins at low - 3/2 and ends at high + 3/2; where it begins the box
 *   reaches to low + 1/2, and its mean is 1/32: a bend's share of 1/8, over 4 */
Ref area_ramp(Lower *l, Ref t, Ref edge, Ref low, Ref high)
{
    Ir *ir = l->ir;
    Ref zero = build_float(ir, 0), one = build_float(ir, 1), from = build_sub(ir, t, low);
    if (ir_known(ir, high)[0] <= ir_known(ir, low)[0])
        return step_share(l, from, edge);
    Ref width = build_sub(ir, high, low);
    Ref wider = build_max(ir, edge, width), narrower = build_min(ir, edge, width);
    Ref more = build_scale(ir, build_sub(ir, wider, width), 0.5);
    Ref begin = build_add(ir, from, more), end = build_sub(ir, build_sub(ir, t, high), more);
    Ref position = build_clamp(ir, begin, build_neg(ir, wider), build_add(ir, wider, wider));
    Ref bends = build_sub(ir, footprint_box_corner(l, begin, narrower),
                          footprint_box_corner(l, end, narrower));
    Ref share = build_clamp(ir, footprint_over_edge(l, position, wider), zero, one);
    return build_add(ir, share, footprint_over_edge(l, bends, wider));
}
