/* The oracle's core: surface points, environments with their memo, and delegation (semantics.md,
 * section 1). */
#include "compiler/oracle/oracle.h"
#include "compiler/base/memory.h"
#include "compiler/oracle/oracle_maps.h"
#include "compiler/library/references.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>

void oracle_surface_default(Surface *surface)
{
    *surface = (Surface){.front = true, .local_u = {1, 0, 0}, .local_v = {0, 1, 0}};
    surface->root[channel_id(GROUP_N, 2)] = 1;
    surface->root[channel_id(GROUP_DU, 0)] = 1;
    surface->root[channel_id(GROUP_DV, 1)] = 1;
    surface->root[channel_id(GROUP_IOR, 0)] = 1;
    surface->root[channel_id(GROUP_E, 2)] = 1;
}

/* Returns true for channels that a surface sets. W and the color are not set: at the root they
 * are always 0. */
static bool on_surface(const ChannelRow *row)
{
    return row->group != GROUP_R && !(row->group == GROUP_U && row->component == 2);
}

bool oracle_surface_set(Surface *surface, const char *name, double value)
{
    for (int i = 0; i < CHANNEL_COUNT; i++) {
        const ChannelRow *row = &channel_table[i];
        if (strcmp(row->name, name) != 0)
            continue;
        if (!on_surface(row))
            return false;
        surface->root[channel_id(row->group, row->component)] = value;
        return true;
    }
    return false;
}

bool oracle_surface_attribute(const Graph *graph, Surface *surface, const char *name, double value)
{
    static const char letters[2][5] = {"xyzw", "rgba"};
    const char *point = strchr(name, '.');
    const size_t size = point ? (size_t)(point - name) : strlen(name);
    for (int i = 0; i < graph->attribute_count; i++) {
        const MeshAttribute *attribute = graph->attributes[i];
        const int components = type_table[attribute->type].components;
        bool set = false;
        if (strlen(attribute->name) != size || memcmp(attribute->name, name, size) != 0)
            continue;
        for (int component = 0; component < components; component++) {
            const bool meant =
                point && point[1] && !point[2] &&
                (point[1] == letters[0][component] || point[1] == letters[1][component]);
            if (point && !meant)
                continue;
            surface->attributes[i][component] = value;
            surface->has |= 1u << (4 * i + component);
            set = true;
        }
        return set;
    }
    return false;
}

void oracle_derivatives(Oracle *oracle, Choice how) { oracle->derivatives = how; }

void oracle_slope_span(Oracle *oracle, double behind, double ahead)
{
    oracle->behind = behind;
    oracle->ahead = ahead;
}

void oracle_judge_slopes(Oracle *oracle, bool judge) { oracle->judges = judge; }

bool oracle_slopes_rough(Oracle *oracle)
{
    bool rough = oracle->rough;
    oracle->rough = false;
    return rough;
}

Oracle *oracle_open(const Graph *graph, const ReferenceContext *context)
{
    Oracle *oracle = calloc(1, sizeof *oracle);
    if (!oracle)
        memory_exhausted();
    oracle->graph = graph;
    oracle->context = *context;
    oracle_derivatives(oracle, CHOICE_derivatives_auto);
    oracle_slope_span(oracle, -1, 1);
    return oracle;
}

void oracle_close(Oracle *oracle)
{
    if (!oracle)
        return;
    arena_free(&oracle->arena);
    free(oracle);
}

/* Opens an environment. A new stamp invalidates every row, so that the memo of a depth need not
 * be cleared between points. */
Environment environment_open(Oracle *oracle, const Surface *surface, int depth)
{
    const Memo none = {0};
    while (oracle->memo_count <= (size_t)depth)
        ARENA_PUSH(&oracle->arena, oracle->memos, oracle->memo_count, oracle->memo_capacity, none);
    return (Environment){
        .oracle = oracle, .surface = surface, .stamp = ++oracle->stamp, .depth = depth};
}

double oracle_query(Environment *environment, const Node *map, int channel)
{
    double value;
    if (!map || group_is_draws(group_of(channel)))
        return environment->surface->root[channel];
    if (memo_find(environment, map, channel, &value))
        return value;
    oracle_spend(environment, MAP_VALUE_WORK);
    if (oracle_spent(environment->oracle))
        return 0;
    value = oracle_map_value(environment, map, channel);
    memo_set(environment, map, channel, value);
    return value;
}

/* Returns a parameter's map; NULL if the parameter is absent. */
static const Node *map_of(const Value *value)
{
    if (value->kind == VALUE_none)
        return NULL;
    assert(value->kind == VALUE_node);
    return value->node;
}

double oracle_query_param(Environment *environment, const Node *node, int param, int channel)
{
    return oracle_query(environment, map_of(node_param(node, param)), channel);
}

/* Evaluates the map `input`, the first parameter of every map that has one; test_oracle checks
 * this. */
double oracle_query_input(Environment *environment, const Node *node, int channel)
{
    return oracle_query_param(environment, node, kind_table[node->kind].first, channel);
}

void oracle_query_input3(Environment *environment, const Node *node, Group group, double result[3])
{
    for (int component = 0; component < 3; component++)
        result[component] = oracle_query_input(environment, node, channel_id(group, component));
}

double oracle_float(const Value *value)
{
    double components[4];
    value_number(value, TYPE_float, components);
    return components[0];
}

void oracle_vec3(const Value *value, double result[3])
{
    double components[4];
    value_number(value, TYPE_vec3, components);
    memcpy(result, components, 3 * sizeof *result);
}

double oracle_number(const Node *node, int param) { return oracle_float(node_param(node, param)); }

void oracle_number3(const Node *node, int param, double result[3])
{
    oracle_vec3(node_param(node, param), result);
}

double oracle_channel(Oracle *oracle, const Node *map, int channel, const Surface *surface)
{
    assert(channel >= 0 && channel < CHANNEL_ID_COUNT);
    Environment environment = environment_open(oracle, surface, 0);
    oracle->work = 0;
    return oracle_query(&environment, map, channel);
}
