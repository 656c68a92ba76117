/* Evaluates the maps Cells and CellCentre. */
#include "compiler/oracle/oracle_maps.h"

static int keyword_of(const Node *node, int param, Keyword first)
{
    return (int)node_param(node, param)->number[0] - (int)first;
}

/* Arguments of a library function: a position, a remainder of 0, and the further parameters. */
typedef struct {
    int dimensions;
    double jitter, distance, value;
} Question;

static void ask(const Environment *environment, const int functions[2], const Question *about,
                const double q[3], double result[4])
{
    double args[9] = {0};
    const int own = 2 * about->dimensions;
    for (int i = 0; i < about->dimensions; i++)
        args[i] = q[i];
    args[own] = about->jitter;
    args[own + 1] = about->distance;
    args[own + 2] = about->value;
    oracle_call(environment, functions[about->dimensions == 3], args, result);
}

/* A Cells map in an environment, as a function of its coordinate. */
typedef struct {
    const Environment *environment;
    const Node *node;
    int dimensions;
    bool random;
} Cells;

static double cells_at(const void *map, const double q[3])
{
    const Cells *c = map;
    static const int functions[][2] = {{FN_cells2, FN_cells3}, {FN_cells2Random, FN_cells3Random}};
    const Question about = {c->dimensions, oracle_number(c->node, P_Cells_jitter),
                            keyword_of(c->node, P_Cells_distance, KEYWORD_Distance_euclidean),
                            keyword_of(c->node, P_Cells_value, KEYWORD_CellsValue_F1)};
    double result[4];
    ask(c->environment, functions[c->random], &about, q, result);
    return oracle_waved(c->environment, c->node, result[0]);
}

static const double CELLS_STEP = 0.05;

double oracle_Cells(Environment *environment, const Node *node, int channel)
{
    if (component_of(channel) == 3)
        return 1;
    const Cells cells = {environment, node, oracle_number(node, P_Cells_dimensions) >= 3 ? 3 : 2,
                         keyword_of(node, P_Cells_value, KEYWORD_CellsValue_random) == 0};
    const Group group = cells.dimensions == 2 ? GROUP_U : GROUP_X;
    double q[3], q0[3];
    oracle_query_input3(environment, node, group, q);
    if (!environment->centre || !cells.random)
        return oracle_same_of_all(environment, node, channel, cells_at(&cells, q));
    oracle_query_input3(environment->centre, node, group, q0);
    const Stepped map = {
        cells_at, &cells, {CELLS_STEP, CELLS_STEP, cells.dimensions == 3 ? CELLS_STEP : 0}};
    return oracle_same_of_all(environment, node, channel, oracle_along_steps(&map, q0, q));
}

double oracle_CellCentre(Environment *environment, const Node *node, int channel)
{
    const Group group = group_of(channel);
    static const int functions[] = {FN_cells2Centre, FN_cells3Centre};
    if (!in_triple(channel, GROUP_X) && !(in_triple(channel, GROUP_U) && component_of(channel) < 2))
        return oracle_query_input(environment, node, channel);
    const Question about = {group == GROUP_U ? 2 : 3, oracle_number(node, P_CellCentre_jitter),
                            keyword_of(node, P_CellCentre_distance, KEYWORD_Distance_euclidean), 0};
    double q[3], point[4];
    oracle_query_input3(environment, node, group, q);
    ask(environment, functions, &about, q, point);
    for (int i = 0; i < about.dimensions; i++)
        memo_set(environment, node, channel_id(group, i), point[i]);
    return point[component_of(channel)];
}
