/* The maps Cells and CellCentre, by cells.h. */
#include "compiler/lower/map_value.h"
#include "compiler/lower/cells.h"
#include "compiler/lower/bump.h"

/* Returns the jitter, clamped to [0, 1] since a uniform may have any value: within that range
 * the search for points is complete and its values are bounded. */
static Ref find_jitter(Lower *l, const Node *node, int param)
{
    Ref jitter = lower_param(l, node_param(node, param), TYPE_float);
    return build_clamp(l->ir, jitter, build_float(l->ir, 0), build_float(l->ir, 1));
}

/* Sets the slope of a discontinuous value by finite differences over a step of its own
 * coordinate. The step is added to the remainder, so that it is not lost to rounding far from
 * the origin. */
static void note_steps(Lower *l, const Cells *cells, Ref value, Ref q)
{
    Ir *ir = l->ir;
    Ref rate[3] = {0};
    const double step = kind_table[KIND_Cells].step;
    for (int i = 0; i < cells->dimensions; i++) {
        double along[4] = {0};
        along[i] = step;
        Ref there = cells_at(l, cells, q, ir_const(ir, ir_type(ir, q), along));
        rate[i] = build_scale(ir, build_sub(ir, there, value), 1 / step);
    }
    bump_rise(l, value, q, rate);
}

static int keyword_of(const Node *node, int param, Keyword first)
{
    return (int)node_param(node, param)->number[0] - (int)first;
}

MapValue lower_Cells(Lower *l, const Node *node, Group group, const Env *env)
{
    const Value *dimensions = node_param(node, P_Cells_dimensions);
    lower_reject_uniform(l, dimensions, "dimensions", "squares and cubes are different functions");
    double number[4];
    value_number(dimensions, TYPE_float, number);
    const Node *input = lower_param_node(node, P_Cells_input);
    const Cells cells = {.dimensions =
                             (int)clamp(number[0], CELLS_FEWEST_DIMENSIONS, CELLS_MAX_DIMENSIONS),
                         .distance = keyword_of(node, P_Cells_distance, KEYWORD_Distance_euclidean),
                         .measure = keyword_of(node, P_Cells_value, KEYWORD_CellsValue_F1),
                         .jitter = find_jitter(l, node, P_Cells_jitter)};
    MapValue q = lower_map_value(l, input, cells.dimensions == 2 ? GROUP_U : GROUP_X, env);
    if (cells.dimensions == 2)
        q = map_value_swizzle(l, q, "xy");
    MapValue value = cells_over_pixel(l, &cells, q);
    if (l->relief && cells.measure == CELLS_VALUE_random)
        note_steps(l, &cells, value.value, q.value);
    return map_value_as_group(l, lower_waved(l, node, value), group);
}

MapValue lower_CellCentre(Lower *l, const Node *node, Group group, const Env *env)
{
    Ir *ir = l->ir;
    MapValue q = lower_map_value(l, lower_param_node(node, P_CellCentre_input), group, env);
    if (group != GROUP_X && group != GROUP_U)
        return q;
    const Cells cells = {.dimensions = group == GROUP_U ? 2 : 3,
                         .distance =
                             keyword_of(node, P_CellCentre_distance, KEYWORD_Distance_euclidean),
                         .measure = CELLS_VALUE_centre,
                         .jitter = find_jitter(l, node, P_CellCentre_jitter)};
    if (group == GROUP_X)
        return cells_over_pixel(l, &cells, q);
    MapValue uv = cells_over_pixel(l, &cells, map_value_swizzle(l, q, "xy")),
             w = map_value_swizzle(l, q, "z");
    MapValue moved = map_value_of(build_vec(ir, TYPE_vec3, uv.value, w.value));
    if (uv.variance || w.variance)
        moved.variance = build_vec(ir, TYPE_vec3, build_or_zero(ir, uv.variance, TYPE_vec2),
                                   build_or_zero(ir, w.variance, TYPE_float));
    return moved;
}
