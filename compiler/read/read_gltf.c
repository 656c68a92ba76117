/* Converts the materials of a glTF 2.0 file to a document with materials of kind `glTF`. Values
 * keep their positions in the JSON, so that faults are reported there.
 *
 *     "materials": [{ "name": "Bark", "pbrMetallicRoughness": { "roughnessFactor": 0.8,
 *         "baseColorTexture": { "index": 0 } } }]
 *     becomes    materials: { Bark: { material: glTF, roughnessFactor: 0.8,
 *                baseColorTexture: { map: ImageMap, image: bark.png, colorspace: srgb } } }
 *
 * Members of a material, of its pbrMetallicRoughness and of its extensions become parameters of
 * the same name, if the material glTF has them; others are reported as ignored. If a primitive
 * has no material, one named `default` is added. */
#include "compiler/base/names.h"
#include "compiler/base/text.h"
#include "compiler/read/gltf_chunks.h"
#include "compiler/read/read.h"
#include "grammar/tables.h"
#include <stdlib.h>
#include <string.h>

enum {
    LINEAR_FILTER = 9729,
    NEAREST = 9728,
    CLAMP = 33071,
    MIRROR = 33648,
    REPEAT = 10497
}; /* values of OpenGL constants that samplers use */

typedef struct {
    Session *session;
    const Tree *root;
    Names names; /* names of the materials so far */
    Names stems; /* names that several materials of the file share */
    int *last;   /* per name stem: the number appended to the last duplicate */
    size_t last_count, last_capacity;
    /* Per material: a primitive with this material has vertex colors. The last entry is for
     * primitives without a material. */
    bool *colored;
    uint32_t material_count;
    bool bare; /* a primitive has no material */
} Gltf;

/* An object under construction. */
typedef struct {
    Member *members;
    size_t count, capacity;
} Keys;

static void put(Gltf *g, Keys *made, const char *key, Tree *value)
{
    const Member member = {key, value, value->span, (uint32_t)strlen(key)};
    ARENA_PUSH(g->session->arena, made->members, made->count, made->capacity, member);
}

static Tree *word(Gltf *g, const char *text, Span span)
{
    Tree *tree = ARENA_NEW(g->session->arena, Tree);
    *tree =
        (Tree){.kind = TREE_scalar, .plain = true, .span = span, .count = (uint32_t)strlen(text)};
    tree->text = text;
    return tree;
}

static Tree *number(Gltf *g, double value, Span span)
{
    Text text = text_new(g->session->arena);
    text_plain(&text, value);
    return word(g, text.at, span);
}

static Tree *object(Gltf *g, const Keys *made, Span span)
{
    Tree *tree = ARENA_NEW(g->session->arena, Tree);
    *tree = (Tree){.kind = TREE_object, .span = span};
    tree_set_members(g->session, tree, made->members, made->count);
    return tree;
}

static Tree *value_of(const Tree *tree, const char *key)
{
    const Member *member = tree && tree->kind == TREE_object ? tree_find(tree, key) : NULL;
    return member ? member->value : NULL;
}

static int whole_of(const Tree *tree, int without)
{
    double value;
    return tree && tree->kind == TREE_scalar && tree_number(tree, &value) && value >= 0 &&
                   value <= LIMIT_TREE_NODES && value == (int)value
               ? (int)value
               : without;
}

/* Returns the item of a top-level list with the given index; NULL after reporting an invalid
 * index. */
static Tree *item_of(Gltf *g, const char *list, const Tree *index)
{
    const Tree *items = value_of(g->root, list);
    const int i = whole_of(index, -1);
    if (items && items->kind == TREE_list && i >= 0 && (uint32_t)i < items->count)
        return items->items[i];
    diag_add(g->session, index->span, DIAG_gltf_index, list,
             index->kind == TREE_scalar ? index->text : tree_describe(g->session, index));
    return NULL;
}

/* Translates a sampler: address mode and filter. */
static void put_sampler(Gltf *g, Keys *made, const Tree *texture)
{
    const Tree *index = value_of(texture, "sampler"),
               *sampler = index ? item_of(g, "samplers", index) : NULL;
    const Tree *s = value_of(sampler, "wrapS"), *t = value_of(sampler, "wrapT"),
               *filter = value_of(sampler, "magFilter");
    const int wrap = whole_of(s, REPEAT);
    if (wrap != whole_of(t, REPEAT))
        diag_add(g->session, (s ? s : t)->span, DIAG_gltf_unread,
                 "an image with different wrap modes along u and v");
    if (wrap == CLAMP || wrap == MIRROR)
        put(g, made, "address", word(g, wrap == CLAMP ? "clamp" : "mirror", s->span));
    if (whole_of(filter, LINEAR_FILTER) == NEAREST)
        put(g, made, "bilinearFiltering", word(g, "false", filter->span));
    else
        put(g, made, "texels", word(g, "centre", texture->span));
}

/* Translates KHR_texture_transform: (u, v) times `scale` plus `offset`, with v pointing down.
 * Here v points up: v' = 1 - (sy (1 - v) + oy). */
static void put_transform(Gltf *g, Keys *made, const Tree *info, Tree *coordinates)
{
    const Tree *transform = value_of(value_of(info, "extensions"), "KHR_texture_transform");
    const Tree *lists[2] = {value_of(transform, "offset"), value_of(transform, "scale")};
    double to[2][2] = {{0, 0}, {1, 1}}, turn = 0;
    Keys map = {0};
    for (int i = 0; i < 4; i++)
        if (lists[i / 2] && lists[i / 2]->kind == TREE_list && lists[i / 2]->count == 2)
            tree_number(lists[i / 2]->items[i % 2], &to[i / 2][i % 2]);
    const Tree *rotation = value_of(transform, "rotation");
    if (rotation && tree_number(rotation, &turn) && turn != 0)
        diag_add(g->session, rotation->span, DIAG_gltf_unread,
                 "an image with a rotated texture transform");
    const bool moved = to[0][0] != 0 || to[0][1] != 0 || to[1][0] != 1 || to[1][1] != 1;
    if (!moved || to[1][0] == 0 || to[1][1] == 0) {
        if (coordinates)
            put(g, made, "input", coordinates);
        return;
    }
    const Span span = transform->span;
    put(g, &map, "map", word(g, "UVTransform", span));
    put(g, &map, "scaleU", number(g, to[1][0], span));
    put(g, &map, "scaleV", number(g, to[1][1], span));
    put(g, &map, "offsetU", number(g, -to[0][0] / to[1][0], span));
    put(g, &map, "offsetV", number(g, -(1 - to[1][1] - to[0][1]) / to[1][1], span));
    if (coordinates)
        put(g, &map, "input", coordinates);
    put(g, made, "input", object(g, &map, span));
}

/* Returns the map for the second set of texture coordinates, which is a mesh attribute; NULL for
 * the first set. Tangents are always those of the first set. */
static Tree *coordinates_of(Gltf *g, const Tree *info, bool normals)
{
    const Tree *set = value_of(info, "texCoord");
    const int number = set ? whole_of(set, -1) : 0;
    if (number == 1 && !normals)
        return word(g, "= attribute(\"uv1\", vec2)", set->span);
    if (number)
        diag_add(g->session, set->span, DIAG_gltf_unread,
                 number == 1 ? "a second set of texture coordinates, of normals,"
                             : "a third set of texture coordinates");
    return NULL;
}

/* Writes an image's path: the external file's name, or a fragment path for an embedded image. */
static void put_image(Gltf *g, Keys *made, const Tree *image, const Tree *number)
{
    const Tree *uri = value_of(image, "uri");
    const bool file = uri && uri->kind == TREE_scalar && strncmp(uri->text, "data:", 5) != 0;
    put(g, made, "image",
        file ? word(g, text_decoded(g->session->arena, uri->text), uri->span)
             : word(g, gltf_chunks_picture(g->session, image->span.file, number->text),
                    image->span));
}

/* Converts a texture reference { index, texCoord } to an ImageMap; NULL after reporting why it
 * is impossible. */
static Tree *picture(Gltf *g, const Tree *info, bool srgb, bool normals)
{
    const Tree *index = value_of(info, "index");
    Tree *coordinates = coordinates_of(g, info, normals);
    const Tree *texture = index ? item_of(g, "textures", index) : NULL,
               *source = value_of(texture, "source");
    const Tree *image = source ? item_of(g, "images", source) : NULL;
    if (!image) {
        if (!index || (texture && !source))
            diag_add(g->session, info->span, DIAG_gltf_unread, "a texture without an image");
        return NULL;
    }
    Keys made = {0};
    put(g, &made, "map", word(g, "ImageMap", info->span));
    put_image(g, &made, image, source);
    put(g, &made, "colorspace", word(g, srgb ? "srgb" : "linear", info->span));
    put_sampler(g, &made, texture);
    put_transform(g, &made, info, coordinates);
    return object(g, &made, info->span);
}

static int find_param(const char *name)
{
    const KindRow *row = &kind_table[KIND_glTF];
    for (int i = row->first; i < row->first + row->count; i++)
        if (!strcmp(param_table[i].name, name))
            return i;
    return -1;
}

static bool ends_in_texture(const char *key)
{
    const size_t size = strlen(key), end = sizeof "Texture" - 1;
    return size > end && !strcmp(key + size - end, "Texture");
}

/* Adds an ImageMap, and the factor that accompanies its index. */
static void put_picture(Gltf *g, Keys *made, const Member *member, int param)
{
    static const struct {
        const char *texture, *key, *param;
    } factors[] = {{"normalTexture", "scale", "normalScale"},
                   {"clearcoatNormalTexture", "scale", "clearcoatNormalScale"},
                   {"occlusionTexture", "strength", "occlusionStrength"}};
    Tree *map = picture(g, member->value, param_is_colored(param),
                        strstr(member->key, "ormalTexture") != NULL);
    if (map)
        put(g, made, param_table[param].name, map);
    for (int i = 0; i < 3; i++) {
        Tree *factor = value_of(member->value, factors[i].key);
        if (map && factor && !strcmp(member->key, factors[i].texture))
            put(g, made, factors[i].param, factor);
    }
}

static void put_members(Gltf *g, Keys *made, const Tree *from, bool outermost)
{
    static const char *const skipped[] = {"name", "extras", "doubleSided", "pbrMetallicRoughness",
                                          "extensions"};
    for (uint32_t i = 0; from && from->kind == TREE_object && i < from->count; i++) {
        const Member *member = &from->members[i];
        const char *key = strcmp(member->key, "iridescenceThicknessMaximum")
                              ? member->key
                              : "iridescenceThickness";
        const int param = find_param(key);
        bool skip = false;
        for (int k = 0; outermost && k < 5; k++)
            skip |= !strcmp(key, skipped[k]);
        if (skip)
            continue;
        if (param < 0)
            diag_add(g->session, member->span, DIAG_gltf_unread, member->key);
        else if (ends_in_texture(key))
            put_picture(g, made, member, param);
        else
            put(g, made, param_table[param].name, member->value);
    }
}

/* Returns the number of the last duplicate of a name. Each number is tried once, so n materials
 * of one name take n steps. */
static int *last_twin(Gltf *g, const char *stem)
{
    const int first = 1, known = names_find(&g->stems, stem);
    if (known >= 0)
        return &g->last[known];
    ARENA_PUSH(g->session->arena, g->last, g->last_count, g->last_capacity, first);
    return &g->last[names_add(g->session->arena, &g->stems, stem)];
}

/* Returns a unique name made of letters, digits, '_', '-' and '.', starting with a letter. */
static const char *name_for(Gltf *g, const Tree *given, uint32_t number)
{
    Text text = text_new(g->session->arena);
    const char *from = given && given->kind == TREE_scalar ? given->text : "";
    if (!text_is_letter(*from))
        text_format(&text, *from ? "material" : "material%u", (unsigned)number);
    for (; *from && text.size + 12 < LIMIT_NAME; from++)
        text_char(&text, text_is_alphanumeric(*from) || *from == '-' || *from == '.' ? *from : '_');
    const size_t size = text.size;
    int *last = names_find(&g->names, text.at) < 0
                    ? NULL
                    : last_twin(g, arena_string(g->session->arena, text.at, size));
    while (last && names_find(&g->names, text.at) >= 0) {
        text.size = size;
        text_format(&text, "_%d", ++*last);
    }
    names_add(g->session->arena, &g->names, text.at);
    return text.at;
}

/* Finds the materials of primitives with vertex colors, and whether a primitive has no material,
 * in one pass over all primitives. */
static void find_primitives(Gltf *g)
{
    const Tree *meshes = value_of(g->root, "meshes"), *materials = value_of(g->root, "materials");
    g->material_count = materials && materials->kind == TREE_list ? materials->count : 0;
    g->colored = ARENA_ARRAY(g->session->arena, bool, g->material_count + 1);
    for (uint32_t m = 0; meshes && meshes->kind == TREE_list && m < meshes->count; m++) {
        const Tree *parts = value_of(meshes->items[m], "primitives");
        for (uint32_t i = 0; parts && parts->kind == TREE_list && i < parts->count; i++) {
            const Tree *material = value_of(parts->items[i], "material");
            const uint32_t number = (uint32_t)whole_of(material, (int)g->material_count);
            g->bare |= !material;
            if (number <= g->material_count &&
                value_of(value_of(parts->items[i], "attributes"), "COLOR_0"))
                g->colored[number] = true;
        }
    }
}

/* Vertex colors multiply the base color and its alpha. */
static void put_vertex_color(Gltf *g, Keys *made, Span span)
{
    Tree *color = word(g, "= vertexColor", span);
    for (size_t i = 0; i < made->count; i++)
        if (!strcmp(made->members[i].key, "baseColorTexture")) {
            const Tree *picture = made->members[i].value;
            Keys map = {0}, with = {0}, alpha = {0};
            for (uint32_t k = 0; k < picture->count; k++)
                put(g, &alpha, picture->members[k].key, picture->members[k].value);
            put(g, &alpha, "channel", word(g, "a", span));
            put(g, &with, "texture", made->members[i].value);
            put(g, &with, "alpha", object(g, &alpha, picture->span));
            put(g, &map, "map", word(g, "Expression", span));
            put(g, &map, "is", word(g, "[texture * vertexColor.rgb, alpha * vertexColor.a]", span));
            put(g, &map, "with", object(g, &with, span));
            made->members[i].value = object(g, &map, span);
            return;
        }
    put(g, made, "baseColorTexture", color);
}

static Tree *material_of(Gltf *g, const Tree *from, uint32_t number, Span span)
{
    Keys made = {0};
    const Tree *extensions = value_of(from, "extensions");
    put(g, &made, "material", word(g, "glTF", span));
    put_members(g, &made, value_of(from, "pbrMetallicRoughness"), false);
    put_members(g, &made, from, true);
    for (uint32_t i = 0; extensions && extensions->kind == TREE_object && i < extensions->count;
         i++)
        if (extensions->members[i].value->count)
            put_members(g, &made, extensions->members[i].value, false);
        else
            diag_add(g->session, extensions->members[i].span, DIAG_gltf_unread,
                     extensions->members[i].key);
    if (g->colored[number])
        put_vertex_color(g, &made, span);
    return object(g, &made, span);
}

Tree *read_gltf(TreeBuilder *b)
{
    Tree *root = read_json(b);
    Gltf g = {.session = b->session, .root = root};
    Keys materials = {0}, document = {0};
    if (!root || root->kind != TREE_object)
        return root;
    const Tree *list = value_of(root, "materials");
    find_primitives(&g);
    for (uint32_t i = 0; list && list->kind == TREE_list && i < list->count; i++) {
        const char *name = name_for(&g, value_of(list->items[i], "name"), i);
        put(&g, &materials, name, material_of(&g, list->items[i], i, list->items[i]->span));
    }
    const Span span = {root->span.start, root->span.start + 1, root->span.file};
    if (g.bare)
        put(&g, &materials, name_for(&g, word(&g, "default", span), 0),
            material_of(&g, NULL, g.material_count, span));
    put(&g, &document, "materials", object(&g, &materials, list ? list->span : span));
    return object(&g, &document, root->span);
}
