/* Converts the materials of a glTF 2.0 file to a document with materials of kind `glTF`. Values
 * keep their positions in the JSON, so that faults are reported there.
 *
 *     "materials": [{ "name": "Bark", "pbrMetallicRoughness": { "roughnessFactor": 0.8,
 *         "baseColorTexture": { "index": 0 } } }]
 *     becomes    materials: { Bark: { material: glTF, roughnessFactor: 0.8,
 *                baseColorTexture: { map: ImageMap, image: bark.png, colorspace: srgb } } }
 *
 * Members of a material, of its pbrMetallicRoughness and of its extensions become parameters of
 * the same name, if grammar/gltf.def lists them for that object; gltf_unread.c reports the others.
 * KHR_materials_unlit and KHR_materials_pbrSpecularGlossiness: gltf_workflow.c. If a primitive
 * has no material, one named `default` is added. */
#include "compiler/base/names.h"
#include "compiler/base/text.h"
#include "compiler/read/gltf_chunks.h"
#include "compiler/read/gltf_unread.h"
#include "compiler/read/gltf_workflow.h"
#include "compiler/read/read.h"
#include "grammar/tables.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    LINEAR_FILTER = 9729,
    NEAREST = 9728,
    CLAMP = 33071,
    MIRROR = 33648,
    REPEAT = 10497
}; /* values of OpenGL constants that samplers use */
enum { MAX_TEXTURE_COORDINATES = 7 };

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

static void put(Gltf *g, GltfKeys *made, const char *key, Tree *value)
{
    gltf_workflow_put(g->session, made, key, value);
}

static Tree *word(Gltf *g, const char *text, Span span)
{
    return gltf_workflow_word(g->session, text, span);
}

static Tree *number(Gltf *g, double value, Span span)
{
    return gltf_workflow_number(g->session, value, span);
}

static Tree *object(Gltf *g, const GltfKeys *made, Span span)
{
    return gltf_workflow_object(g->session, made, span);
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
static void put_sampler(Gltf *g, GltfKeys *made, const Tree *texture)
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

static void read_pair(const Tree *list, double pair[2])
{
    for (int i = 0; list && list->kind == TREE_list && list->count == 2 && i < 2; i++)
        tree_number(list->items[i], &pair[i]);
}

/* A map UVTransform computes scale * rotate(-angle) * ((u, v) - offset). */
static Tree *uv_transform(Gltf *g, const double offset[2], const double scale[2], double angle,
                          Span span)
{
    GltfKeys map = {0};
    put(g, &map, "map", word(g, "UVTransform", span));
    if (scale[0] != 1 || scale[1] != 1) {
        put(g, &map, "scaleU", number(g, scale[0], span));
        put(g, &map, "scaleV", number(g, scale[1], span));
    }
    if (angle != 0)
        put(g, &map, "angle", number(g, angle, span));
    if (offset[0] != 0 || offset[1] != 0) {
        put(g, &map, "offsetU", number(g, offset[0], span));
        put(g, &map, "offsetV", number(g, offset[1], span));
    }
    return object(g, &map, span);
}

static void put_input(Gltf *g, Tree *map, Tree *input)
{
    GltfKeys made = {0};
    for (uint32_t i = 0; i < map->count; i++)
        put(g, &made, map->members[i].key, map->members[i].value);
    put(g, &made, "input", input);
    tree_set_members(g->session, map, made.members, made.count);
}

/* Translates KHR_texture_transform: with c = cos(rotation), s = sin(rotation) and v pointing down,
 * u' = c sx u + s sy v + ox and v' = -s sx u + c sy v + oy, so that a rotation by pi / 2 turns the
 * image clockwise. Here v points up, and both v and v' are one minus that:
 * (u', v') = R(rotation) S (u, v) + (s sy + ox, 1 - c sy - oy), with S the scale. A map without
 * rotation has its offset before the scale; otherwise one map scales, a second one rotates. */
static Tree *transformed(Gltf *g, const Tree *transform, Tree *coordinates)
{
    static const double none[2] = {0, 0}, one[2] = {1, 1};
    double by[2] = {0, 0}, scale[2] = {1, 1}, angle = 0;
    const Tree *rotation = value_of(transform, "rotation");
    read_pair(value_of(transform, "offset"), by);
    read_pair(value_of(transform, "scale"), scale);
    if (rotation)
        tree_number(rotation, &angle);
    const double c = cos(angle), s = sin(angle);
    const double x = s * scale[1] + by[0], y = 1 - c * scale[1] - by[1];
    if (x == 0 && y == 0 && scale[0] == 1 && scale[1] == 1 && angle == 0)
        return coordinates;
    const bool nested = angle != 0 || scale[0] == 0 || scale[1] == 0;
    const double offset[2] = {nested ? -(c * x + s * y) : -x / scale[0],
                              nested ? s * x - c * y : -y / scale[1]};
    const bool scaled = nested && (scale[0] != 1 || scale[1] != 1);
    Tree *map = uv_transform(g, offset, nested ? one : scale, -angle, transform->span);
    Tree *inner = scaled ? uv_transform(g, none, scale, 0, transform->span) : coordinates;
    if (scaled && coordinates)
        put_input(g, inner, coordinates);
    if (inner)
        put_input(g, map, inner);
    return map;
}

/* Returns the map for a further set of texture coordinates, which is a mesh attribute; NULL for
 * the first set. Tangents are always those of the first set. */
static Tree *coordinates_of(Gltf *g, const Tree *info, const Tree *transform, bool normals)
{
    const Tree *own = value_of(transform, "texCoord"),
               *set = own ? own : value_of(info, "texCoord");
    const int index = set ? whole_of(set, MAX_TEXTURE_COORDINATES + 1) : 0;
    Text text = text_new(g->session->arena);
    if (!index)
        return NULL;
    if (index > MAX_TEXTURE_COORDINATES) {
        diag_add(g->session, set->span, DIAG_gltf_unread, "this set of texture coordinates");
        return NULL;
    }
    if (normals)
        diag_add(g->session, set->span, DIAG_gltf_unread,
                 "the direction of a further set of texture coordinates, of normals,");
    text_format(&text, "= attribute(\"uv%d\", vec2)", index);
    return word(g, text.at, set->span);
}

/* Writes an image's path: the external file's name, or a fragment path for an embedded image. */
static void put_image(Gltf *g, GltfKeys *made, const Tree *image, const Tree *number)
{
    const Tree *uri = value_of(image, "uri");
    const bool file = uri && uri->kind == TREE_scalar && strncmp(uri->text, "data:", 5) != 0;
    put(g, made, "image",
        file ? word(g, text_decoded(g->session->arena, uri->text), uri->span)
             : word(g, gltf_chunks_picture(g->session, image->span.file, number->text),
                    image->span));
}

/* Returns the index of a texture's image. A texture may name images of further formats, beside
 * one that every reader knows. */
static const Tree *source_of(const Tree *texture)
{
    const Tree *extensions = value_of(texture, "extensions"), *source = value_of(texture, "source");
    const Tree *webp = value_of(value_of(extensions, "EXT_texture_webp"), "source"),
               *basis = value_of(value_of(extensions, "KHR_texture_basisu"), "source");
    if (webp && (GLTF_WEBP || !source))
        return webp;
    return source ? source : basis;
}

/* Converts a texture reference { index, texCoord } to an ImageMap; NULL after reporting why it
 * is impossible. */
static Tree *picture(Gltf *g, const Tree *info, bool srgb, bool normals)
{
    const Tree *index = value_of(info, "index"),
               *transform = value_of(value_of(info, "extensions"), "KHR_texture_transform");
    const Tree *texture = index ? item_of(g, "textures", index) : NULL,
               *source = source_of(texture);
    const Tree *image = source ? item_of(g, "images", source) : NULL;
    Tree *coordinates = coordinates_of(g, info, transform, normals);
    if (!image) {
        if (!index || (texture && !source))
            diag_add(g->session, info->span, DIAG_gltf_unread, "a texture without an image");
        return NULL;
    }
    GltfKeys made = {0};
    put(g, &made, "map", word(g, "ImageMap", info->span));
    put_image(g, &made, image, source);
    put(g, &made, "colorspace", word(g, srgb ? "srgb" : "linear", info->span));
    put_sampler(g, &made, texture);
    if (transform)
        coordinates = transformed(g, transform, coordinates);
    if (coordinates)
        put(g, &made, "input", coordinates);
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

/* Adds an ImageMap, and the factor that accompanies its index. */
static void put_picture(Gltf *g, GltfKeys *made, const Member *member, int param)
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

static void put_members(Gltf *g, GltfKeys *made, const Tree *from, GltfObject object)
{
    for (uint32_t i = 0; from && from->kind == TREE_object && i < from->count; i++) {
        const Member *member = &from->members[i];
        const GltfObject content = gltf_unread_member(object, member->key);
        const int param =
            find_param(strcmp(member->key, "iridescenceThicknessMaximum") ? member->key
                                                                          : "iridescenceThickness");
        if (content == GLTF_NONE || param < 0)
            continue;
        if (content != GLTF_leaf)
            put_picture(g, made, member, param);
        else
            put(g, made, param_table[param].name, member->value);
    }
}

/* Adds the parameters of KHR_materials_pbrSpecularGlossiness, in place of pbrMetallicRoughness. */
static void put_glossiness(Gltf *g, GltfKeys *made, const Tree *from)
{
    const Tree *diffuse = value_of(from, "diffuseTexture"),
               *glossy = value_of(from, "specularGlossinessTexture");
    const GltfGlossiness parts = {
        .from = from,
        .diffuse = diffuse ? picture(g, diffuse, true, false) : NULL,
        .glossy = glossy ? picture(g, glossy, true, false) : NULL,
    };
    gltf_workflow_glossiness(g->session, made, &parts);
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
static void put_vertex_color(Gltf *g, GltfKeys *made, Span span)
{
    Tree *color = word(g, "= vertexColor", span);
    for (size_t i = 0; i < made->count; i++)
        if (!strcmp(made->members[i].key, "baseColorTexture")) {
            const Tree *picture = made->members[i].value;
            GltfKeys map = {0}, with = {0}, alpha = {0};
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

static Tree *material_of(Gltf *g, const Tree *from, uint32_t index, Span span)
{
    GltfKeys made = {0};
    const Tree *extensions = value_of(from, "extensions"),
               *glossiness = value_of(extensions, "KHR_materials_pbrSpecularGlossiness");
    put(g, &made, "material", word(g, "glTF", span));
    if (glossiness && glossiness->kind == TREE_object)
        put_glossiness(g, &made, glossiness);
    else
        put_members(g, &made, value_of(from, "pbrMetallicRoughness"), GLTF_workflow);
    put_members(g, &made, from, GLTF_material);
    for (uint32_t i = 0; extensions && extensions->kind == TREE_object && i < extensions->count;
         i++)
        if (extensions->members[i].value != glossiness)
            put_members(g, &made, extensions->members[i].value,
                        gltf_unread_extension(GLTF_material, extensions->members[i].key));
    if (g->colored[index])
        put_vertex_color(g, &made, span);
    if (value_of(extensions, "KHR_materials_unlit"))
        made = gltf_workflow_unlit(g->session, &made, span);
    return object(g, &made, span);
}

Tree *read_gltf(TreeBuilder *b)
{
    Tree *root = read_json(b);
    Gltf g = {.session = b->session, .root = root};
    GltfKeys materials = {0}, document = {0};
    if (!root || root->kind != TREE_object)
        return root;
    const Tree *list = value_of(root, "materials");
    gltf_unread_report(b->session, root);
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
