/* Cells and CellCentre. Where cells are finer than a pixel, their mean stands for them, by the factors of grammar/cells.def:
 *
 *     F1 of squares, a pixel .7 cells wide: F1's factor is .62, of which 1.43 * .62 - .43 = .46 is kept:  .43 + .46 (F1(q) - .43)
 *     from 1.8 cells on nothing is kept, and no point is searched for */
#include "compiler/lower/area.h"
#include "compiler/lower/relief.h"

/* What stands for F1 and its like, with jitter 0, 1/2 and 1, and how it fades: a row of cells.def. */
typedef struct {
    double mean[3], variance[3], slope[3], narrow, wide;
} Statistics;

enum { MEASURE_F1, MEASURE_F2, MEASURE_edge, MEASURE_random, MEASURE_centre, MEASURE_COUNT };
enum { DISTANCES = WORD_Distance_chebyshev - WORD_Distance_euclidean + 1, FEWEST_DIMENSIONS = 2, MOST_DIMENSIONS = 3 };

static const Statistics statistics[MOST_DIMENSIONS - FEWEST_DIMENSIONS + 1][DISTANCES][MEASURE_COUNT] = {
#define THREE(a, b, c) {a, b, c}
#define CELLS(dimensions, distance, measure, mean, variance, slope, narrow, wide)                                      \
    [dimensions - FEWEST_DIMENSIONS][WORD_Distance_##distance - WORD_Distance_euclidean][MEASURE_##measure] = {        \
        mean, variance, slope, narrow, wide},
#include "grammar/cells.def"
};

/* Cells of a coordinate. */
typedef struct {
    int dimensions, distance, measure;
    Ref jitter;
} Cells;

/* A param may be set to anything; the search for points is complete, and its values are bounded, from 0 to 1. */
static Ref find_jitter(Lower *l, const Node *node, int param)
{
    Ref jitter = lower_param(l, node_param(node, param), TYPE_float);
    return build_clamp(l->ir, jitter, build_float(l->ir, 0), build_float(l->ir, 1));
}

/* The parabola through the numbers at jitter 0, 1/2 and 1. */
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
    const int which = cells->measure == MEASURE_centre ? 2 : cells->measure == MEASURE_random;
    const Function function = functions[which][cells->dimensions - FEWEST_DIMENSIONS];
    Ref distance = build_int(ir, cells->distance);
    Ref args[] = {p, rest, cells->jitter, distance, which ? 0 : build_int(ir, cells->measure)};
    return build_call_of(ir, function, args, which ? 4 : 5);
}

/* At a place that lies `beside` the coordinate; 0: at itself. */
static Ref at_point(Lower *l, const Cells *cells, Ref q, Ref beside)
{
    Ir *ir = l->ir;
    LongCoordinate parts = {q, 0};
    if (affine_coordinate(l, q, 1, &parts) && beside)
        beside = build_add(ir, parts.fraction, beside);
    Ref rest = beside ? beside : parts.fraction;
    return call(l, cells, parts.whole, build_or_zero(ir, rest, ir_type(ir, q)));
}

/* In the middle of a box of the footprint. */
static Ref at_tap(Lower *l, const Cells *cells, Ref q, Ref middle)
{
    LongCoordinate parts;
    const bool apart = middle != q && affine_coordinate(l, q, 1, &parts);
    return apart ? at_point(l, cells, q, build_sub(l->ir, middle, q)) : at_point(l, cells, middle, 0);
}

/* What the mean over a square of that edge keeps of a value's distance from the mean, and what it leaves out of the variance, besides what its
 * slope shows. */
typedef struct {
    Ref share, variance;
} Fading;

static Fading fading(Lower *l, const Cells *cells, Ref edge)
{
    Ir *ir = l->ir;
    const double widest = 64; /* cells: nothing is kept long before */
    const Statistics *s = &statistics[cells->dimensions - FEWEST_DIMENSIONS][cells->distance][cells->measure];
    Ref one = build_float(ir, 1), width = build_min(ir, edge, build_float(ir, widest)), area = build_square(ir, width);
    Ref narrow = build_float(ir, s->narrow), wide = build_float(ir, s->wide);
    Ref loss = build_call(ir, FN_cellsLoss, cells->measure >= MEASURE_random ? width : area, narrow, wide);
    Ref share = build_sub(ir, one, loss), kept = build_square(ir, share);
    Ref left = build_mul(ir, by_jitter(l, cells, s->variance), build_mul(ir, loss, build_add(ir, one, share)));
    Ref shown = build_scale(ir, build_mul(ir, by_jitter(l, cells, s->slope), build_mul(ir, kept, area)), 1.0 / 12);
    Ref variance = build_max(ir, build_sub(ir, left, shown), build_float(ir, 0));
    return (Fading){share, variance};
}

/* The mean over the pixel, a box or several. The centre's mean is the place itself. */
static Answer over_pixel(Lower *l, const Cells *cells, Answer q)
{
    Ir *ir = l->ir;
    Tap taps[MOST_TAPS];
    const int count = footprint_taps(l, q, taps);
    if (!count)
        return answer_of(at_point(l, cells, q.value, 0));
    const Type type = cells->measure == MEASURE_centre ? ir_type(ir, q.value) : TYPE_float;
    const Statistics *s = &statistics[cells->dimensions - FEWEST_DIMENSIONS][cells->distance][cells->measure];
    const Fading fade = fading(l, cells, footprint_greatest_lane(l, taps[0].edges));
    Ref shows = build_lt(ir, build_float(ir, 0), fade.share), sum = 0;
    for (int i = 0; i < count; i++) {
        Ref value = build_guard(ir, shows, at_tap(l, cells, q.value, taps[i].middle));
        Ref mean = cells->measure == MEASURE_centre ? taps[i].middle : by_jitter(l, cells, s->mean);
        Ref faded = build_mix(ir, mean, value, fade.share);
        sum = sum ? build_add(ir, sum, faded) : faded;
    }
    Ref variance = build_splat(ir, fade.variance, type);
    return (Answer){count > 1 ? build_scale(ir, sum, 1.0 / count) : sum, variance, NULL};
}

/* What jumps has differences over a step of its own coordinate for its slope. The step is added to the rest, so that it is not lost far out. */
static void note_steps(Lower *l, const Cells *cells, Ref value, Ref q)
{
    Ir *ir = l->ir;
    Ref rate[3] = {0};
    const double step = kind_table[KIND_Cells].step;
    for (int i = 0; i < cells->dimensions; i++) {
        double along[4] = {0};
        along[i] = step;
        Ref there = at_point(l, cells, q, ir_const(ir, ir_type(ir, q), along));
        rate[i] = build_scale(ir, build_sub(ir, there, value), 1 / step);
    }
    relief_rise(l, value, q, rate);
}

static int word_of(const Node *node, int param, Word first)
{
    return (int)node_param(node, param)->number[0] - (int)first;
}

Answer lower_Cells(Lower *l, const Node *node, Group group, const Env *env)
{
    const Value *dimensions = node_param(node, P_Cells_dimensions);
    lower_reject_uniform(l, dimensions, "dimensions", "squares and cubes are different functions");
    double number[4];
    value_number(dimensions, TYPE_float, number);
    const Node *input = lower_param_node(node, P_Cells_input);
    const Cells cells = {.dimensions = (int)clamp(number[0], FEWEST_DIMENSIONS, MOST_DIMENSIONS),
                         .distance = word_of(node, P_Cells_distance, WORD_Distance_euclidean),
                         .measure = word_of(node, P_Cells_value, WORD_CellsValue_F1),
                         .jitter = find_jitter(l, node, P_Cells_jitter)};
    Answer q = lower_answer(l, input, cells.dimensions == 2 ? GROUP_U : GROUP_X, env);
    if (cells.dimensions == 2)
        q = answer_swizzle(l, q, "xy");
    Answer value = over_pixel(l, &cells, q);
    if (l->relief && cells.measure == MEASURE_random)
        note_steps(l, &cells, value.value, q.value);
    return answer_as_group(l, lower_waved(l, node, value), group);
}

Answer lower_CellCentre(Lower *l, const Node *node, Group group, const Env *env)
{
    Ir *ir = l->ir;
    Answer q = lower_answer(l, lower_param_node(node, P_CellCentre_input), group, env);
    if (group != GROUP_X && group != GROUP_U)
        return q;
    const Cells cells = {.dimensions = group == GROUP_U ? 2 : 3,
                         .distance = word_of(node, P_CellCentre_distance, WORD_Distance_euclidean),
                         .measure = MEASURE_centre,
                         .jitter = find_jitter(l, node, P_CellCentre_jitter)};
    if (group == GROUP_X)
        return over_pixel(l, &cells, q);
    Answer uv = over_pixel(l, &cells, answer_swizzle(l, q, "xy")), w = answer_swizzle(l, q, "z");
    Answer moved = answer_of(build_vec(ir, TYPE_vec3, uv.value, w.value));
    if (uv.variance || w.variance)
        moved.variance = build_vec(ir, TYPE_vec3, build_or_zero(ir, uv.variance, TYPE_vec2), build_or_zero(ir, w.variance, TYPE_float));
    return moved;
}
