/* Selects the color space of images whose maps do not give one. In a file with `colors: srgb`,
 * images that feed a color are sRGB: those reached from a material's color through parameters
 * whose color is passed on (COLORED of maps.def). All other images hold linear numbers.
 *
 *     colors: srgb
 *     material: Phong
 *     diffuse: { map: Blend, blend: [{ input: { map: ImageMap, image: a.png } }],  # color: sRGB
 *                input: { map: ImageMap, image: b.png } }      # coordinate: linear
 *     shininess: { map: ImageMap, image: c.png }               # number: linear
 *
 * A float image is always linear. A map that feeds both a color and a number is one map with one
 * value: sRGB.
 *
 * glTF defines the color space of its images: sRGB for colors whatever the file's `colors:`,
 * linear for others, with texel centers inside the texels. A document's material `glTF`
 * therefore behaves as a .gltf (read_gltf.c), unless its maps state otherwise. The textures of
 * UsdPreview and the MaterialX images of StandardSurface also cover the unit square from edge to
 * edge, so their texel centers are inside the texels, too. Their color space is not defined by
 * the material but by the texture's sourceColorSpace or the file's colorspace; here by the map
 * and the document. */
#include "compiler/resolve/resolve.h"

void resolve_picture(Resolver *r, const Node *node, Value *params)
{
    Value *space = &params[P_ImageMap_colorspace - kind_table[KIND_ImageMap].first];
    const Value *image = &params[P_ImageMap_image - kind_table[KIND_ImageMap].first];
    const bool floats = image->kind == VALUE_image && image->image->bits == 32;
    if (floats && space->kind == VALUE_number && space->number[0] == KEYWORD_ColorSpace_srgb)
        diag_add(r->session, space->span, DIAG_float_srgb);
    Value *texels = &params[P_ImageMap_texels - kind_table[KIND_ImageMap].first];
    const bool decided = space->kind != VALUE_none;
    if (!decided)
        *space =
            (Value){.kind = VALUE_number, .type = TYPE_int, .number = {KEYWORD_ColorSpace_linear}};
    const UndecidedPicture picture = {node, decided || floats ? NULL : space,
                                      texels->given ? NULL : texels};
    if (picture.colorspace || picture.texels)
        ARENA_PUSH(r->session->arena, r->undecided, r->undecided_count, r->undecided_capacity,
                   picture);
}

/* Depth-first search from a set of nodes, either along color parameters only or along all;
 * `open` is the stack of unvisited nodes. */
typedef struct {
    bool any_way, *met; /* `any_way`: follow all parameters; `met`: visited nodes, by index */
    const Node **open;
    int count;
} Reach;

static void reach(Reach *reach, const Node *node)
{
    if (!node || reach->met[node->index])
        return;
    reach->met[node->index] = true;
    reach->open[reach->count++] = node;
}

static void reach_inputs(Reach *all, const Node *node)
{
    const int first = kind_table[node->kind].first;
    /* a Blend without items passes its input on */
    const bool passes =
        node->kind == KIND_Blend && node_param(node, P_Blend_blend)->kind != VALUE_items;
    for (int i = 0; i < kind_table[node->kind].count; i++) {
        const Value *value = &node->params[i];
        if (!all->any_way && !param_is_colored(first + i) &&
            !(passes && first + i == P_Blend_input))
            continue;
        if (value->kind == VALUE_node)
            reach(all, value->node);
        for (int k = 0; value->kind == VALUE_items && k < value->items->count; k++)
            reach(all, value->items->item[k].numbers && !all->any_way
                           ? NULL
                           : value->items->item[k].input);
    }
}

static bool is_gltf(Kind written) { return written == KIND_glTF; }

/* Returns the nodes below materials whose written kind satisfies `such`. */
static const bool *reached_of(const Resolver *r, bool (*such)(Kind written), bool any_way)
{
    Reach all = {.any_way = any_way,
                 .met = ARENA_ARRAY(r->session->arena, bool, r->node_count),
                 .open = ARENA_ARRAY(r->session->arena, const Node *, r->node_count)};
    for (size_t i = 0; i < r->named_count; i++)
        reach(&all, such(r->nodes[i]->written) ? r->nodes[i] : NULL);
    while (all.count)
        reach_inputs(&all, all.open[--all.count]);
    return all.met;
}

static const bool *reached_of_colours(const Resolver *r, const NamedMaterial *materials, int count)
{
    Reach all = {.met = ARENA_ARRAY(r->session->arena, bool, r->node_count),
                 .open = ARENA_ARRAY(r->session->arena, const Node *, r->node_count)};
    for (int i = 0; i < count; i++)
        reach(&all, materials[i].node);
    while (all.count)
        reach_inputs(&all, all.open[--all.count]);
    return all.met;
}

void resolve_picture_spaces(Resolver *r, const NamedMaterial *materials, int count)
{
    if (!r->undecided_count)
        return;
    const bool *colored = reached_of_colours(r, materials, count),
               *below = reached_of(r, resolve_is_foreign, true),
               *tinting = reached_of(r, is_gltf, false);
    for (size_t i = 0; i < r->undecided_count; i++) {
        const UndecidedPicture *picture = &r->undecided[i];
        const int node = picture->node->index;
        if (picture->colorspace &&
            (tinting[node] || (colored[node] && resolve_is_srgb(r, picture->node->span.file))))
            picture->colorspace->number[0] = KEYWORD_ColorSpace_srgb;
        if (picture->texels && below[node])
            picture->texels->number[0] = KEYWORD_Texels_centre;
    }
}
