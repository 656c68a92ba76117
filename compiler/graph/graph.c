/* Queries of a Graph, and the conversion of numbers between types. */
#include "compiler/graph/graph.h"
#include "grammar/lobe_table.h"
#include <string.h>

/* Narrowing to one component takes the mean, to several the first components. Widening copies a
 * single component; otherwise it fills with 0, and alpha with 1. */
void graph_convert(int from_components, const double *from, int to_components, double *to)
{
    double result[4] = {0, 0, 0, 1};
    if (to_components == 1 && from_components > 1) {
        double sum = 0;
        for (int i = 0; i < from_components; i++)
            sum += from[i];
        result[0] = sum / from_components;
    } else {
        for (int i = 0; i < (from_components == 1 && to_components < 4 ? to_components
                             : from_components == 1                    ? 3
                                                                       : from_components);
             i++)
            result[i] = from[from_components == 1 ? 0 : i];
    }
    memcpy(to, result, sizeof(double) * (size_t)to_components);
}

void value_number(const Value *value, Type want, double result[4])
{
    const double *from = value->kind == VALUE_uniform ? value->uniform->initial : value->number;
    graph_convert(type_table[value->type].components, from, type_table[want].components, result);
}

/* Per kind: the first parameter of DISPLACEMENT_PARAMS. */
static const int displacement_param[KIND_COUNT] = {
#define MATERIAL(name, sort, doc) [KIND_##name] = P_##name##_displacement,
#include "grammar/materials.def"
#include "grammar/maps.def"
};

Displacement graph_displacement(const Node *material)
{
    const Value *first = node_param(material, displacement_param[material->kind]);
    return (Displacement){first, first + 1, first + 2, first + 3, first + 4, first + 5};
}

bool graph_displaces(const Node *material)
{
    const Displacement d = graph_displacement(material);
    return d.height->kind == VALUE_node || d.vector->kind == VALUE_node ||
           d.volume->kind == VALUE_node;
}

bool graph_displaces_volume(const Node *material)
{
    return graph_displacement(material).volume->kind == VALUE_node;
}

bool value_is_zero(const Value *value)
{
    if (value->kind == VALUE_node && value->node->kind == KIND_Constant)
        value = &value->node->params[0];
    for (int component = 0;
         value->kind == VALUE_number && component < type_table[value->type].components; component++)
        if (value->number[component] != 0)
            return false;
    return value->kind == VALUE_number || value->kind == VALUE_none;
}

/* Returns a parameter's map; NULL: none. */
static const Node *map_of(const Node *material, int param)
{
    const Value *value = node_param(material, param);
    return value->kind == VALUE_node ? value->node : NULL;
}

bool graph_coat_follows(const Graph *graph, const Node *coated)
{
    if (coated->kind == KIND_Principled)
        return map_of(coated, P_Principled_coatNormal) == map_of(coated, P_Principled_input);
    const Node *base = map_of(coated, P_Layer_base), *map = map_of(coated, P_Layer_coatNormal);
    if (!base || !(graph->models[base->index] & MODEL_RELIEF))
        return !map;
    return (base->kind == KIND_Phong && map_of(base, P_Phong_input) == map) ||
           (base->kind == KIND_Principled && map_of(base, P_Principled_input) == map);
}

/* Returns the lobes of a Principled that are not known to be zero. Diffuse transmission needs
 * thin walls. */
static unsigned lobes_of(const Graph *graph, const Node *principled)
{
    const bool thin = !value_is_zero(node_param(principled, P_Principled_thinWalled)),
               coated = !value_is_zero(node_param(principled, P_Principled_coat));
    unsigned lobes = 0;
    for (int lobe = 0; lobe < LOBE_COUNT; lobe++) {
        const bool there = lobe == LOBE_coatNormal
                               ? coated && !graph_coat_follows(graph, principled)
                               : !value_is_zero(node_param(principled, lobe_table[lobe].param));
        lobes |= there && (thin || lobe != LOBE_diffuseTransparency) ? MODEL_LOBE(lobe) : 0;
    }
    return lobes;
}

/* Returns true unless the emission strength or color is zero. A glTF material without
 * emissiveFactor has strength 1 and a black color. */
static unsigned principled_emits(const Node *material)
{
    const bool dark = value_is_zero(node_param(material, P_Principled_emission)) ||
                      value_is_zero(node_param(material, P_Principled_emissionColor));
    return dark ? 0 : MODEL_EMITS;
}

static unsigned phong_emits(const Node *material)
{
    return value_is_zero(node_param(material, P_Phong_emissive)) ? 0 : MODEL_EMITS;
}

static unsigned bump_of(const Node *map) { return map ? MODEL_RELIEF : 0; }

/* Models of a material that selects or mixes other materials: if one is a Principled, all become
 * Principled. An AlgorithmSwitch shows its first material only; a missing front of a SideSwitch
 * is gray. */
static unsigned models_of(const Graph *graph, const Node *node)
{
    const KindRow *row = &kind_table[node->kind];
    unsigned models = 0;
    if (node->kind == KIND_Principled)
        return 1u << MODEL_Principled | lobes_of(graph, node) | principled_emits(node) |
               bump_of(map_of(node, P_Principled_input));
    if (node->kind == KIND_Phong)
        return 1u << MODEL_Phong | phong_emits(node) | bump_of(map_of(node, P_Phong_input));
    if (node->kind == KIND_Layer)
        models |= 1u << MODEL_Principled | MODEL_LOBE(LOBE_coat) |
                  (graph_coat_follows(graph, node) ? 0 : MODEL_LOBE(LOBE_coatNormal));
    for (int i = 0; i < row->count && !(models && node->kind == KIND_AlgorithmSwitch); i++)
        if (param_table[row->first + i].type == PARAM_Material)
            models |=
                node->params[i].kind == VALUE_node ? graph->models[node->params[i].node->index] : 0;
    return models >> MODEL_Principled & 1 ? models & ~(1u << MODEL_Phong)
                                          : models | 1u << MODEL_Phong;
}

void graph_find_models(Graph *graph, const Node *const *nodes, size_t count)
{
    for (size_t i = 0; i < count; i++)
        graph->models[nodes[i]->index] = models_of(graph, nodes[i]);
}
