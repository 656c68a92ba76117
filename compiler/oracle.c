/* The oracle's core: surface points, environments with their memo, and delegation (semantics.md, section 1). */
#include "oracle.h"
#include "oracle_maps.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>

void *oracle_alloc(size_t count, size_t size)
{
    void *memory = calloc(count ? count : 1, size);
    if (!memory)
        abort();
    return memory;
}

void oracle_surface_default(Surface *surface)
{
    *surface = (Surface){.front = true, .local_u = {1, 0, 0}, .local_v = {0, 1, 0}};
    surface->root[channel_id(GROUP_N, 2)] = 1;
    surface->root[channel_id(GROUP_DU, 0)] = 1;
    surface->root[channel_id(GROUP_DV, 1)] = 1;
    surface->root[channel_id(GROUP_IOR, 0)] = 1;
}

/* W and the colour are channels that no surface sets: at the root they are always 0. */
static bool on_surface(const ChannelRow *row)
{
    return row->group != GROUP_R && !(row->group == GROUP_U && row->lane == 2);
}

bool oracle_surface_set(Surface *surface, const char *name, double value)
{
    for (int i = 0; i < CHANNEL_COUNT; i++) {
        const ChannelRow *row = &channel_table[i];
        if (strcmp(row->name, name) != 0)
            continue;
        if (!on_surface(row))
            return false;
        surface->root[channel_id(row->group, row->lane)] = value;
        return true;
    }
    return false;
}

Oracle *oracle_open(const Graph *graph, const ReferenceContext *context)
{
    Oracle *oracle = oracle_alloc(1, sizeof *oracle);
    oracle->graph = graph;
    oracle->context = *context;
    oracle->reliefs = oracle_alloc((size_t)graph->node_count, sizeof *oracle->reliefs);
    return oracle;
}

void oracle_exact_derivatives(Oracle *oracle, bool exact) { oracle->exact = exact; }
void oracle_slope_side(Oracle *oracle, int side) { oracle->side = side; }

void oracle_close(Oracle *oracle)
{
    if (!oracle)
        return;
    for (int i = 0; i < oracle->graph->node_count; i++)
        free(oracle->reliefs[i]);
    for (int i = 0; i < oracle->memo_count; i++)
        free(oracle->memos[i]);
    free(oracle->reliefs);
    free(oracle->memos);
    free(oracle);
}

static void add_memo(Oracle *oracle)
{
    Memo **memos = realloc(oracle->memos, ((size_t)oracle->memo_count + 1) * sizeof *memos);
    if (!memos)
        abort();
    oracle->memos = memos;
    memos[oracle->memo_count++] = oracle_alloc((size_t)oracle->graph->node_count, CHANNEL_ID_COUNT * sizeof(Memo));
}

/* A new stamp makes every cell stale, so that the memo of a depth need not be cleared between points. */
Environment environment_open(Oracle *oracle, const Surface *surface, int depth)
{
    while (oracle->memo_count <= depth)
        add_memo(oracle);
    return (Environment){oracle, surface, oracle->memos[depth], ++oracle->stamp, depth};
}

double oracle_ask(Environment *environment, const Node *map, int channel)
{
    if (!map)
        return environment->surface->root[channel];
    Memo *memo = &environment->memo[(size_t)map->index * CHANNEL_ID_COUNT + (size_t)channel];
    if (memo->stamp == environment->stamp)
        return memo->value;
    memo->value = oracle_answer(environment, map, channel);
    memo->stamp = environment->stamp;
    return memo->value;
}

/* NULL when the parameter is not there. */
static const Node *map_of(const Value *value)
{
    if (value->kind == VALUE_none)
        return NULL;
    assert(value->kind == VALUE_node);
    return value->node;
}

double oracle_ask_param(Environment *environment, const Node *node, int param, int channel)
{
    return oracle_ask(environment, map_of(node_param(node, param)), channel);
}

/* `input` is the first parameter of every map that has one; test_oracle checks it. */
double oracle_ask_input(Environment *environment, const Node *node, int channel)
{
    return oracle_ask_param(environment, node, kind_table[node->kind].first, channel);
}

void oracle_ask_input3(Environment *environment, const Node *node, Group group, double result[3])
{
    for (int lane = 0; lane < 3; lane++)
        result[lane] = oracle_ask_input(environment, node, channel_id(group, lane));
}

double oracle_float(const Value *value)
{
    double lanes[4];
    value_number(value, TYPE_float, lanes);
    return lanes[0];
}

void oracle_vec3(const Value *value, double result[3])
{
    double lanes[4];
    value_number(value, TYPE_vec3, lanes);
    memcpy(result, lanes, 3 * sizeof *result);
}

double oracle_number(const Node *node, int param) { return oracle_float(node_param(node, param)); }

void oracle_number3(const Node *node, int param, double result[3]) { oracle_vec3(node_param(node, param), result); }

void oracle_call(const Environment *environment, int function, const double *args, double *result)
{
    function_row(function)->reference(&environment->oracle->context, args, result);
}

double oracle_channel(Oracle *oracle, const Node *map, int channel, const Surface *surface)
{
    assert(channel >= 0 && channel < CHANNEL_ID_COUNT);
    Environment environment = environment_open(oracle, surface, 0);
    return oracle_ask(&environment, map, channel);
}
