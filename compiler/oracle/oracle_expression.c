/* Expression: evaluates its formula in double precision, by the VALUE lines of expression.def. */
#include "compiler/formula/formula.h"
#include "compiler/base/memory.h"
#include "compiler/base/vec3.h"
#include "compiler/oracle/oracle_maps.h"
#include "compiler/library/references.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STEP_WORK = 4 }; /* work per step of a formula; noise is charged by its octaves */

/* Sets v to the unit vector from the point to the eye, or against parallel rays. */
static void toward_viewer(const Environment *environment, double v[3])
{
    const double *root = environment->surface->root, w = root[channel_id(GROUP_E, 3)];
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = root[channel_id(GROUP_E, i)] - w * root[channel_id(GROUP_P, i)];
    reference_of(FN_safeNormalize)(NULL, way, v);
}

static void quantity_at(Environment *environment, const Node *node, Quantity quantity,
                        double result[4])
{
    const QuantityRow *row = &quantity_table[quantity];
    if (quantity == QUANTITY_V) {
        toward_viewer(environment, result);
        return;
    }
    if (quantity == QUANTITY_facing) {
        double n[4], v[3];
        quantity_at(environment, node, QUANTITY_N, n);
        toward_viewer(environment, v);
        for (int i = 0; i < 4; i++)
            result[i] = fmin(fabs(vec3_dot(n, v)), 1);
        return;
    }
    double group[3];
    oracle_query_input3(environment, node, row->group, group);
    if (quantity == QUANTITY_N)
        reference_of(FN_safeNormalize)(NULL, (const double[]){group[0], group[1], group[2]}, group);
    for (int i = 0; row->components[i]; i++)
        result[i] = group[row->components[i] - 'x'];
    for (int i = 1; !row->components[1] && i < 4; i++)
        result[i] = result[0];
}

/* Evaluates an input. A number is repeated in all components, as formula_value() expects. */
static void input_at(Environment *environment, const Item *item, double result[4])
{
    const int width = item->width ? item->width : item->input ? item->input->width : 3;
    for (int i = 0; i < width; i++)
        result[i] = oracle_query(environment, item->input, channel_id(GROUP_R, i));
    for (int i = 1; width == 1 && i < 4; i++)
        result[i] = result[0];
}

/* Sets the mesh attributes. A number is repeated in all components, as formula_value() expects. */
static void attributes_at(const Environment *environment, double result[LIMIT_ATTRIBUTES][4])
{
    const Graph *graph = environment->oracle->graph;
    const Surface *surface = environment->surface;
    for (int i = 0; i < graph->attribute_count; i++)
        for (int component = 0; component < 4; component++) {
            const int from = graph->attributes[i]->type == TYPE_float ? 0 : component;
            const bool has = surface->has >> (4 * i + from) & 1;
            result[i][component] =
                has ? surface->attributes[i][from] : graph->attributes[i]->initial[from];
        }
}

static double noise_work(const Formula *f, const FormulaStep *step)
{
    const bool octaves =
        step->row == TERM_fbm || step->row == TERM_fbm3 || step->row == TERM_turbulence;
    if (step->kind == FORMULA_term && (step->row == TERM_cells || step->row == TERM_celledge))
        return CALL_WORK * function_row(FN_cells3)->cost;
    if (step->kind != FORMULA_term ||
        (!octaves && step->row != TERM_noise && step->row != TERM_noise3))
        return 0;
    const double count = octaves ? f->steps[formula_argument(f, step, 1)].number : 1;
    return CALL_WORK * function_row(FN_noise)->cost * count *
           (step->row == TERM_fbm3 || step->row == TERM_noise3 ? 3 : 1);
}

/* Evaluates the formula; all components are computed and cached together. */
static void value_of(Environment *environment, const Node *node, double result[4])
{
    Oracle *oracle = environment->oracle;
    const Formula *f = node_param(node, P_Expression_is)->formula;
    const Value *with = node_param(node, P_Expression_with);
    const int inputs = with->kind == VALUE_items ? with->items->count : 0;
    FormulaPoint point = {.noise = &oracle->context};
    double(*values)[4] = malloc((f->count + (size_t)inputs) * sizeof *values);
    if (!values)
        memory_exhausted();
    memset(values, 0, (f->count + (size_t)inputs) * sizeof *values);
    bool known[QUANTITY_COUNT] = {false};
    for (size_t i = 0; i < f->count; i++) {
        const FormulaStep *step = &f->steps[i];
        if (step->kind == FORMULA_value && !known[step->row])
            quantity_at(environment, node, (Quantity)step->row, point.quantity[step->row]);
        if (step->kind == FORMULA_value)
            known[step->row] = true;
        oracle_spend(environment, STEP_WORK + noise_work(f, step));
    }
    for (int i = 0; i < inputs; i++)
        input_at(environment, &with->items->item[i], values[f->count + (size_t)i]);
    double attributes[LIMIT_ATTRIBUTES][4];
    if (f->meshed)
        attributes_at(environment, attributes);
    point.attributes = (const double(*)[4])attributes;
    point.inputs = (const double(*)[4])(values + f->count);
    point.values = values;
    if (!oracle_spent(oracle))
        formula_value(f, &point, result);
    free(values);
}

double oracle_Expression(Environment *environment, const Node *node, int channel)
{
    double own[4] = {0}, components[4];
    const int width = node->width;
    if (node_param(node, P_Expression_is)->kind == VALUE_formula)
        value_of(environment, node, own);
    graph_convert(width, own, group_of(channel) == GROUP_R ? 4 : 3, components);
    if (group_of(channel) == GROUP_IOR)
        components[0] = own[0];
    for (int component = 0; component < (group_of(channel) == GROUP_R ? 4 : 3); component++)
        memo_set(environment, node, channel_id(group_of(channel), component),
                 components[component]);
    return components[component_of(channel)];
}
