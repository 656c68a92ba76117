/* Small resolved documents made by hand: nodes with the tables' defaults, and setters for other
 * values. A Builder owns all that it makes. */
#ifndef MATC_GRAPH_BUILDER_H
#define MATC_GRAPH_BUILDER_H
#include "compiler/graph/graph.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>

enum { BUILDER_BLOCKS = 512 };

typedef struct {
    Graph graph; /* only node_count is maintained */
    void *blocks[BUILDER_BLOCKS];
    int block_count;
} Builder;

static inline void *build_alloc(Builder *b, size_t size)
{
    assert(b->block_count < BUILDER_BLOCKS);
    void *block = calloc(1, size);
    if (!block)
        abort();
    return b->blocks[b->block_count++] = block;
}

static inline void build_free(Builder *b)
{
    while (b->block_count)
        free(b->blocks[--b->block_count]);
}

static inline Value build_number(double number)
{
    return (Value){.kind = VALUE_number, .type = TYPE_float, .number = {number}};
}

static inline Value build_components(int components, double x, double y, double z, double w)
{
    static const Type types[] = {TYPE_float, TYPE_float, TYPE_vec2, TYPE_vec3, TYPE_vec4};
    return (Value){.kind = VALUE_number, .type = types[components], .number = {x, y, z, w}};
}

static inline Value *build_param(const Node *node, int param)
{
    return (Value *)node_param(node, param);
}

/* Makes a node without its parameters' defaults. */
static inline Node *build_bare(Builder *b, Kind kind)
{
    Node *node = build_alloc(b, sizeof *node);
    node->kind = kind;
    node->params = build_alloc(b, (size_t)kind_table[kind].count * sizeof(Value) + 1);
    return node;
}

static inline Node *build_constant(Builder *b, Value value)
{
    Node *node = build_bare(b, KIND_Constant);
    *build_param(node, P_Constant_value) = value;
    node->index = b->graph.node_count++;
    return node;
}

static inline Value build_default(Builder *b, const ParamRow *row)
{
    Value value = {.kind = VALUE_number, .number = {row->init[0], row->init[1], row->init[2]}};
    if (row->components == 0)
        return (Value){.kind = VALUE_none};
    if (row->type == PARAM_Map) {
        Value components =
            build_components(row->components, row->init[0], row->init[1], row->init[2], 0);
        return (Value){.kind = VALUE_node, .node = build_constant(b, components)};
    }
    value.type = row->type == PARAM_Vec3   ? TYPE_vec3
                 : row->type == PARAM_Int  ? TYPE_int
                 : row->type == PARAM_Bool ? TYPE_bool
                                           : TYPE_float;
    return value;
}

static inline Node *build_node(Builder *b, Kind kind)
{
    Node *node = build_bare(b, kind);
    const KindRow *row = &kind_table[kind];
    for (int i = row->first; i < row->first + row->count; i++)
        *build_param(node, i) = build_default(b, &param_table[i]);
    node->index = b->graph.node_count++;
    return node;
}

static inline void build_set(Node *node, int param, double number)
{
    Value *value = build_param(node, param);
    value->kind = VALUE_number;
    value->number[0] = number;
}

static inline void build_set3(Node *node, int param, double x, double y, double z)
{
    *build_param(node, param) = build_components(3, x, y, z, 0);
}

static inline void build_link(Node *node, int param, const Node *input)
{
    *build_param(node, param) = (Value){.kind = input ? VALUE_node : VALUE_none, .node = input};
}

static inline Node *build_gradient(Builder *b, double x, double y, double z)
{
    Node *node = build_node(b, KIND_Gradient);
    build_set3(node, P_Gradient_direction, x, y, z);
    return node;
}

static inline Wave *build_wave(Builder *b, WaveKind kind)
{
    Wave *wave = build_alloc(b, sizeof *wave);
    *wave = (Wave){.kind = kind, .factor = build_number(1), .shift = build_number(0)};
    return wave;
}
#endif
