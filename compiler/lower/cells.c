/* Cellular noise. Where cells are finer than a pixel, their mean replaces them, by the factors
 * of grammar/cells.def:
 *
 *     F1 of squares, a pixel .7 cells wide: F1's factor is .62, of which 1.43 * .62 - .43 = .46
 *     is kept: .43 + .46 (F1(q) - .43)
 *     from 1.8 cells per pixel on only the mean is left, and no point is searched for */
#include "compiler/lower/cells.h"
#include "compiler/lower/area.h"

/* Statistics of F1 and similar values at jitter 0, 1/2 and 1, and the widths at which they fade:
 * a row of cells.def. */
typedef struct {
    double mean[3], variance[3], slope[3], narrow, wide;
} Statistics;

enum { DISTANCES = KEYWORD_Distance_chebyshev - KEYWORD_Distance_euclidean + 1 };

static const Statistics statistics[CELLS_MAX_DIMENSIONS - CELLS_FEWEST_DIMENSIONS + 1][DISTANCES]
                                  [CELLS_VALUE_COUNT] = {
#define THREE(a, b, c)                                                                             \
    {                                                                                              \
        a, b, c                                                                                    \
    }
#define CELLS(dimensions, distance, measure, mean, variance, slope, narrow, wide)                  \
    [dimensions -                                                                                  \
        CELLS_FEWEST_DIMENSIONS][KEYWORD_Distance_##distance - KEYWORD_Distance_euclidean]         \
                                [CELLS_VALUE_##measure] = {mean, variance, slope, narrow, wide},
#include "grammar/cells.def"
};

/* Returns the parabola through the numbers at jitter 0, 1/2 and 1, as a function of the jitter. */
static Ref by_jitter(Lower *l, const Cells *cells, const double at[3])
{
    Ir *ir = l->ir;
    const double bend = 2 * (at[0] - 2 * at[1] + at[2]), rise = at[2] - at[0] - bend;
    Ref slope = build_add(ir, build_scale(ir, cells->jitter, bend), build_float(ir, rise));
    return build_add(ir, build_mul(ir, cells->jitter, slope), build_float(ir, at[0]));
}

static Ref call(Lower *l, const Cells *cells, Ref p, Ref rest)
{
    Ir *ir = l->ir;
    static const Function functions[][2] = {{FN_cells2, FN_cells3},
                                            {FN_cells2Random, FN_cells3Random},
                                            {FN_cells2Centre, FN_cells3Centre}};
    const int which =
        cells->measure == CELLS_VALUE_centre ? 2 : cells->measure == CELLS_VALUE_random;
    const Function function = functions[which][cells->dimensions - CELLS_FEWEST_DIMENSIONS];
    Ref distance = build_int(ir, cells->distance);
    Ref args[] = {p, rest, cells->jitter, distance, which ? 0 : build_int(ir, cells->measure)};
    return build_call_of(ir, function, args, which ? 4 : 5);
}

Ref cells_at(Lower *l, const Cells *cells, Ref q, Ref beside)
{
    Ir *ir = l->ir;
    LongCoordinate parts = {q, 0};
    if (affine_coordinate(l, q, 1, &parts) && beside)
        beside = build_add(ir, parts.fraction, beside);
    Ref rest = beside ? beside : parts.fraction;
    return call(l, cells, parts.whole, build_or_zero(ir, rest, ir_type(ir, q)));
}

/* Returns the value at the center of one box of the footprint. */
static Ref at_tap(Lower *l, const Cells *cells, Ref q, Ref middle)
{
    LongCoordinate parts;
    const bool apart = middle != q && affine_coordinate(l, q, 1, &parts);
    return apart ? cells_at(l, cells, q, build_sub(l->ir, middle, q))
                 : cells_at(l, cells, middle, 0);
}

/* Effect of a mean over a square of that edge: the factor on a value's distance from the mean,
 * and the variance left out in addition to the slope. */
typedef struct {
    Ref share, variance;
} Fading;

static Fading fading(Lower *l, const Cells *cells, Ref edge)
{
    Ir *ir = l->ir;
    const double widest = 64; /* max edge in cells; the value has faded completely long before */
    const Statistics *s =
        &statistics[cells->dimensions - CELLS_FEWEST_DIMENSIONS][cells->distance][cells->measure];
    Ref one = build_float(ir, 1), width = build_min(ir, edge, build_float(ir, widest)),
        area = build_square(ir, width);
    Ref narrow = build_float(ir, s->narrow), wide = build_float(ir, s->wide);
    Ref loss = build_call(ir, FN_cellsLoss, cells->measure >= CELLS_VALUE_random ? width : area,
                          narrow, wide);
    Ref share = build_sub(ir, one, loss), kept = build_square(ir, share);
    Ref left = build_mul(ir, by_jitter(l, cells, s->variance),
                         build_mul(ir, loss, build_add(ir, one, share)));
    Ref shown = build_scale(
        ir, build_mul(ir, by_jitter(l, cells, s->slope), build_mul(ir, kept, area)), 1.0 / 12);
    Ref variance = build_max(ir, build_sub(ir, left, shown), build_float(ir, 0));
    return (Fading){share, variance};
}

MapValue cells_over_pixel(Lower *l, const Cells *cells, MapValue q)
{
    Ir *ir = l->ir;
    Tap taps[MAX_TAPS];
    const int count = footprint_taps(l, q, taps);
    if (!count)
        return map_value_of(cells_at(l, cells, q.value, 0));
    const Type type = cells->measure == CELLS_VALUE_centre ? ir_type(ir, q.value) : TYPE_float;
    const Statistics *s =
        &statistics[cells->dimensions - CELLS_FEWEST_DIMENSIONS][cells->distance][cells->measure];
    const Fading fade = fading(l, cells, footprint_greatest_component(l, taps[0].edges));
    Ref shows = build_lt(ir, build_float(ir, 0), fade.share), sum = 0;
    for (int i = 0; i < count; i++) {
        Ref value = build_guard(ir, shows, at_tap(l, cells, q.value, taps[i].middle));
        Ref mean =
            cells->measure == CELLS_VALUE_centre ? taps[i].middle : by_jitter(l, cells, s->mean);
        Ref faded = build_mix(ir, mean, value, fade.share);
        sum = sum ? build_add(ir, sum, faded) : faded;
    }
    Ref variance = build_splat(ir, fade.variance, type);
    return (MapValue){count > 1 ? build_scale(ir, sum, 1.0 / count) : sum, variance, NULL};
}

Ref cells_of(Lower *l, Ref p, bool edge)
{
    const Cells cells = {.dimensions = CELLS_MAX_DIMENSIONS,
                         .measure = edge ? CELLS_VALUE_edge : CELLS_VALUE_F1,
                         .jitter = build_float(l->ir, 1)};
    return cells_over_pixel(l, &cells, map_value_of(p)).value;
}

bool cells_far(Lower *l, Far far, const Ref *args, MapValue *made)
{
    Ir *ir = l->ir;
    enum { JITTER, STYLE, DIMENSIONS };
    Ref mean = build_float(ir, 0.5);
    *made = (MapValue){mean, build_float(ir, 1.0 / 12), NULL};
    if (far == FAR_number)
        return true;
    if (far != FAR_point || !ir_is(ir, args[STYLE], OP_const) ||
        !ir_is(ir, args[DIMENSIONS], OP_const))
        return false;
    if (ir_known(ir, args[STYLE])[0] != 0)
        return true; /* style 1 shows a random number of the nearest point's cell */
    const int flat = ir_known(ir, args[DIMENSIONS])[0] < CELLS_MAX_DIMENSIONS;
    const Cells cells = {.jitter =
                             build_clamp(ir, args[JITTER], build_float(ir, 0), build_float(ir, 1))};
    const Statistics *s = &statistics[!flat][0][CELLS_VALUE_F1];
    mean = by_jitter(l, &cells, s->mean);
    *made = (MapValue){mean, by_jitter(l, &cells, s->variance), NULL};
    return true;
}
