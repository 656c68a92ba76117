/* Which pictures are sRGB, where their maps do not say. In a file of `colors: srgb` it is those that feed a colour: there is a way from a
 * colour of a material to them, by parameters whose map's colour is passed on (COLORED of maps.def). All others give numbers.
 *
 *     colors: srgb
 *     material: Phong
 *     diffuse: { map: Blend, blend: [{ input: { map: ImageMap, image: a.png } }],   # a colour: sRGB
 *                input: { map: ImageMap, image: b.png } }                           # a coordinate: linear
 *     shininess: { map: ImageMap, image: c.png }                                    # a number: linear
 *
 * A picture of floats is always linear. A map that feeds both is one map, with one value: sRGB. */
#include "compiler/front/resolve.h"

void resolve_picture(Resolver *r, const Node *node, Value *params)
{
    Value *space = &params[P_ImageMap_colorspace - kind_table[KIND_ImageMap].first];
    const Value *image = &params[P_ImageMap_image - kind_table[KIND_ImageMap].first];
    const bool floats = image->kind == VALUE_image && image->image->bits == 32;
    if (floats && space->kind == VALUE_number && space->number[0] == WORD_ColorSpace_srgb)
        diag_add(r->session, space->span, DIAG_float_srgb);
    if (space->kind != VALUE_none)
        return;
    *space = (Value){.kind = VALUE_number, .type = TYPE_int, .number = {WORD_ColorSpace_linear}};
    const UndecidedPicture picture = {node, space};
    if (resolve_is_srgb(r, node->span.file) && !floats)
        ARENA_PUSH(r->session->arena, r->undecided, r->undecided_count, r->undecided_room, picture);
}

/* Nodes that feed a colour, and those of them whose own inputs are still to be looked at. */
typedef struct {
    bool *colored; /* by index */
    const Node **open;
    int count;
} Reach;

static void reach(Reach *reach, const Node *node)
{
    if (!node || reach->colored[node->index])
        return;
    reach->colored[node->index] = true;
    reach->open[reach->count++] = node;
}

static void reach_inputs(Reach *all, const Node *node)
{
    const int first = kind_table[node->kind].first;
    /* a Blend without items is its input */
    const bool passes = node->kind == KIND_Blend && node_param(node, P_Blend_blend)->kind != VALUE_items;
    for (int i = 0; i < kind_table[node->kind].count; i++) {
        const Value *value = &node->params[i];
        if (!param_is_colored(first + i) && !(passes && first + i == P_Blend_input))
            continue;
        if (value->kind == VALUE_node)
            reach(all, value->node);
        for (int k = 0; value->kind == VALUE_items && k < value->items->count; k++)
            reach(all, value->items->item[k].numbers ? NULL : value->items->item[k].input);
    }
}

void resolve_picture_spaces(Resolver *r, const NamedMaterial *materials, int count)
{
    if (!r->undecided_count)
        return;
    Reach all = {.colored = ARENA_ARRAY(r->session->arena, bool, r->node_count),
                 .open = ARENA_ARRAY(r->session->arena, const Node *, r->node_count)};
    for (int i = 0; i < count; i++)
        reach(&all, materials[i].node);
    while (all.count)
        reach_inputs(&all, all.open[--all.count]);
    for (size_t i = 0; i < r->undecided_count; i++)
        if (all.colored[r->undecided[i].node->index])
            r->undecided[i].colorspace->number[0] = WORD_ColorSpace_srgb;
}
