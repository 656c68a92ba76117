/* Nodes of a Graph. A node is numbered after all nodes below it, when its width and the depth of
 * its graph are known. Defaults are nodes, too. */
#include "compiler/formula/formula.h"
#include "compiler/resolve/resolve.h"

/* -- Widths (numbers of components) of maps */

enum { SURFACE_WIDTH = 3 };

static int width_of(const Value *map)
{
    return map->kind == VALUE_node ? map->node->width : SURFACE_WIDTH;
}

/* Returns the width that can represent both operands: a number is replicated to all components,
 * and two components cannot be widened to a color. */
static int joined(int a, int b) { return a + b == 3 ? 3 : a > b ? a : b; }

/* Returns the width that can represent all items; 0 for an empty list. */
static int width_of_items(const Value *list)
{
    const Items *items = list->kind == VALUE_items ? list->items : NULL;
    int width = 0;
    for (int i = 0; items && i < items->count; i++) {
        const Node *node = items->item[i].input;
        const int own = node ? node->width : SURFACE_WIDTH;
        width = i ? joined(width, own) : own;
    }
    return width;
}

/* Returns the width of the maps that determine the node's color; 0: none. A missing map is
 * replaced by the others, or by the input. */
static int width_of_colours(const Node *node)
{
    const int first = kind_table[node->kind].first, count = kind_table[node->kind].count;
    int width = 0;
    for (int i = 0; i < count; i++) {
        const Value *value = &node->params[i];
        const bool is_map = value->kind == VALUE_node || value->kind == VALUE_items;
        const int own = !is_map || !param_is_colored(first + i) ? 0
                        : value->kind == VALUE_node             ? value->node->width
                                                                : width_of_items(value);
        width = !width ? own : own ? joined(width, own) : width;
    }
    return width;
}

/* Returns the number of components of a map's value in formulas, from those of the maps below; 0
 * for a material. */
static int width_of_node(const Node *node)
{
    const Value *formula = node->kind == KIND_Expression ? node_param(node, P_Expression_is) : NULL;
    switch (node->kind) {
    case KIND_Constant:
        return type_table[node->params->type].components;
    case KIND_RGBColor:
    case KIND_Combine:
        return 3;
    case KIND_Graytone:
    case KIND_Carpenter:
    case KIND_Separate:
        return 1;
    case KIND_ImageMap:
        return node_param(node, P_ImageMap_channel)->kind == VALUE_number ? 1 : 3;
    case KIND_Expression:
        return formula->kind == VALUE_formula ? formula->formula->width : 1;
    default:
        break;
    }
    if (kind_table[node->kind].lowering == LOWERING_MATERIAL)
        return 0;
    const int own = width_of_colours(node);
    if (own)
        return own;
    const Section section = section_of(node->kind);
    const bool is_number =
        section == SECTION_volume || section == SECTION_dimensions || node->kind == KIND_Switch;
    return is_number ? 1 : width_of(&node->params[0]);
}

/* -- Depth and filters */

static void below(Node *node, const Node *child)
{
    if (!child)
        return;
    if (child->depth >= node->depth)
        node->depth = child->depth + 1;
    if (child->filters > node->filters)
        node->filters = child->filters;
    node->steps |= child->steps;
}

/* Computes depth and filters of a node from the nodes below, and checks their limits. */
static bool measure(Resolver *r, Node *node)
{
    for (int i = 0; i < kind_table[node->kind].count; i++) {
        const Value *value = &node->params[i];
        if (value->kind == VALUE_node)
            below(node, value->node);
        for (int k = 0; value->kind == VALUE_items && k < value->items->count; k++)
            below(node, value->items->item[k].input);
    }
    node->filters +=
        node->kind == KIND_Smooth3D || node->kind == KIND_Laplace3D || node->kind == KIND_Triplanar;
    node->steps |= kind_table[node->kind].step_components > 0;
    if (node->depth > LIMIT_GRAPH_DEPTH)
        diag_add(r->session, node->span, DIAG_too_deep, LIMIT_GRAPH_DEPTH);
    else if (node->filters > LIMIT_FILTERS)
        diag_add(r->session, node->span, DIAG_too_many_filters, LIMIT_FILTERS);
    else
        return true;
    return false;
}

const Node *resolve_make_node(Resolver *r, Node of)
{
    Node *node = ARENA_NEW(r->session->arena, Node);
    *node = of;
    node->index = r->node_count++;
    node->owner = r->owner;
    ARENA_PUSH(r->session->arena, r->nodes, r->named_count, r->named_capacity, node);
    node->written = of.written ? of.written : of.kind; /* kind 0 is never a translated material */
    node->width = (int8_t)width_of_node(node);
    return measure(r, node) ? node : NULL;
}

const Node *resolve_make_constant(Resolver *r, Node of, Value number)
{
    Value *value = ARENA_NEW(r->session->arena, Value);
    Node *node = ARENA_NEW(r->session->arena, Node);
    *value = number;
    *node = of;
    node->kind = KIND_Constant;
    node->index = r->node_count++;
    node->params = value;
    node->owner = r->owner;
    node->width = (int8_t)width_of_node(node);
    return node;
}

static const Node *make_default(Resolver *r, Value number, int components)
{
    Value *value = ARENA_NEW(r->session->arena, Value);
    Node *node = ARENA_NEW(r->session->arena, Node);
    *value = number;
    *node = (Node){.kind = KIND_Constant,
                   .index = r->node_count++,
                   .params = value,
                   .width = (int8_t)components};
    return node;
}

Value resolve_default(Resolver *r, const ParamRow *row)
{
    static const Type type_of_components[] = {TYPE_float, TYPE_float, TYPE_vec2, TYPE_vec3};
    Value value = {.kind = VALUE_none};
    if (!row->components)
        return value;
    value.kind = VALUE_number;
    value.type = type_of_components[row->components];
    memcpy(value.number, row->init, sizeof row->init);
    if (row->type != PARAM_Map)
        return value;
    const Node **made = &r->defaults[row - param_table];
    *made = *made ? *made : make_default(r, value, row->components);
    return (Value){.kind = VALUE_node, .node = *made};
}
