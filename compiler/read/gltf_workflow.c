#include "compiler/read/gltf_workflow.h"
#include "compiler/base/text.h"
#include <math.h>
#include <string.h>

enum { COLOR = 3 };
/* Bounds of the reflectance at normal incidence; 1 has no finite index of refraction. */
#define MIN_REFLECTANCE 0.0001
#define MAX_REFLECTANCE 0.98

void gltf_workflow_put(Session *session, GltfKeys *made, const char *key, Tree *value)
{
    const Member member = {key, value, value->span, (uint32_t)strlen(key)};
    ARENA_PUSH(session->arena, made->members, made->count, made->capacity, member);
}

Tree *gltf_workflow_word(Session *session, const char *text, Span span)
{
    Tree *tree = ARENA_NEW(session->arena, Tree);
    *tree =
        (Tree){.kind = TREE_scalar, .plain = true, .span = span, .count = (uint32_t)strlen(text)};
    tree->text = text;
    return tree;
}

Tree *gltf_workflow_number(Session *session, double value, Span span)
{
    Text text = text_new(session->arena);
    text_plain(&text, value);
    return gltf_workflow_word(session, text.at, span);
}

Tree *gltf_workflow_object(Session *session, const GltfKeys *made, Span span)
{
    Tree *tree = ARENA_NEW(session->arena, Tree);
    *tree = (Tree){.kind = TREE_object, .span = span};
    tree_set_members(session, tree, made->members, made->count);
    return tree;
}

static Tree *list_of(Session *session, Tree **items, uint32_t count, Span span)
{
    Tree *tree = ARENA_NEW(session->arena, Tree);
    *tree = (Tree){.kind = TREE_list, .span = span, .count = count};
    tree->items = items;
    return tree;
}

static Tree *key_of(const GltfKeys *keys, const char *key)
{
    for (size_t i = 0; i < keys->count; i++)
        if (!strcmp(keys->members[i].key, key))
            return keys->members[i].value;
    return NULL;
}

static Tree *member_of(const Tree *tree, const char *key)
{
    const Member *member = tree_find(tree, key);
    return member ? member->value : NULL;
}

/* Returns a map Expression with a formula of `texture`, a specular-glossiness texture, and of
 * `gloss`, its alpha. */
static Tree *formula(Session *session, Tree *glossy, const char *is)
{
    GltfKeys alpha = {0}, with = {0}, map = {0};
    const Span span = glossy->span;
    for (uint32_t i = 0; i < glossy->count; i++)
        gltf_workflow_put(session, &alpha, glossy->members[i].key, glossy->members[i].value);
    gltf_workflow_put(session, &alpha, "channel", gltf_workflow_word(session, "a", span));
    if (strstr(is, "gloss"))
        gltf_workflow_put(session, &with, "gloss", gltf_workflow_object(session, &alpha, span));
    else
        gltf_workflow_put(session, &with, "texture", glossy);
    gltf_workflow_put(session, &map, "map", gltf_workflow_word(session, "Expression", span));
    gltf_workflow_put(session, &map, "is", gltf_workflow_word(session, is, span));
    gltf_workflow_put(session, &map, "with", gltf_workflow_object(session, &with, span));
    return gltf_workflow_object(session, &map, span);
}

/* Returns the specular factor; 1 unless the file gives three numbers. */
static void read_specular(const Tree *factor, double color[COLOR])
{
    for (uint32_t i = 0; i < COLOR; i++) {
        color[i] = 1;
        if (factor && factor->kind == TREE_list && i < factor->count)
            tree_number(factor->items[i], &color[i]);
    }
}

/* Adds the index of refraction and the tint of a constant specular color. The index is a formula,
 * since those of metals are beyond the usual range. */
static void put_specular(Session *session, GltfKeys *made, const double color[COLOR], Span span)
{
    Tree **items = ARENA_ARRAY(session->arena, Tree *, COLOR);
    const double greatest = fmax(color[0], fmax(color[1], color[2])),
                 most = fmin(fmax(greatest, MIN_REFLECTANCE), MAX_REFLECTANCE);
    Text text = text_new(session->arena);
    text_format(&text, "= ");
    text_plain(&text, (1 + sqrt(most)) / (1 - sqrt(most)));
    gltf_workflow_put(session, made, "ior", gltf_workflow_word(session, text.at, span));
    if (color[0] == most && color[1] == most && color[2] == most)
        return;
    for (int i = 0; i < COLOR; i++)
        items[i] = gltf_workflow_number(session, color[i] / most, span);
    gltf_workflow_put(session, made, "specularColorFactor", list_of(session, items, COLOR, span));
}

/* Adds the same of a texture. */
static void put_specular_texture(Session *session, GltfKeys *made, const double color[COLOR],
                                 Tree *glossy)
{
    Text text = text_new(session->arena);
    text_format(&text, "color = texture.rgb * [");
    for (int i = 0; i < COLOR; i++) {
        text_plain(&text, color[i]);
        text_format(&text, i < COLOR - 1 ? ", " : "]; most = clamp(maxcomponent(color), ");
    }
    text_plain(&text, MIN_REFLECTANCE);
    text_format(&text, ", ");
    text_plain(&text, MAX_REFLECTANCE);
    const size_t size = text.size;
    text_format(&text, "); color / most");
    const char *tint = arena_string(session->arena, text.at, text.size);
    text.size = size;
    text_format(&text, "); (1 + sqrt(most)) / (1 - sqrt(most))");
    gltf_workflow_put(session, made, "ior", formula(session, glossy, text.at));
    gltf_workflow_put(session, made, "specularColorFactor", formula(session, glossy, tint));
}

static void put_roughness(Session *session, GltfKeys *made, const GltfGlossiness *parts)
{
    const Tree *glossiness = member_of(parts->from, "glossinessFactor");
    double factor = 1;
    Text text = text_new(session->arena);
    if (glossiness)
        tree_number(glossiness, &factor);
    text_format(&text, "1 - ");
    text_plain(&text, factor);
    text_format(&text, " * gloss");
    gltf_workflow_put(session, made, "roughnessFactor",
                      parts->glossy ? formula(session, parts->glossy, text.at)
                                    : gltf_workflow_number(session, 1 - factor, parts->from->span));
}

/* F = ((ior - 1) / (ior + 1))^2 is the greatest component of the specular color. */
void gltf_workflow_glossiness(Session *session, GltfKeys *made, const GltfGlossiness *parts)
{
    const Span span = parts->from->span;
    Tree *diffuse = member_of(parts->from, "diffuseFactor");
    double color[COLOR];
    read_specular(member_of(parts->from, "specularFactor"), color);
    if (diffuse)
        gltf_workflow_put(session, made, "baseColorFactor", diffuse);
    if (parts->diffuse)
        gltf_workflow_put(session, made, "baseColorTexture", parts->diffuse);
    gltf_workflow_put(session, made, "metallicFactor", gltf_workflow_number(session, 0, span));
    put_roughness(session, made, parts);
    if (parts->glossy)
        put_specular_texture(session, made, color, parts->glossy);
    else
        put_specular(session, made, color, span);
}

/* Returns black with the alpha of a base color. */
static Tree *black(Session *session, const Tree *color, Span span)
{
    Tree **items = ARENA_ARRAY(session->arena, Tree *, COLOR + 1);
    const bool alpha = color && color->kind == TREE_list && color->count == COLOR + 1;
    for (int i = 0; i < COLOR; i++)
        items[i] = gltf_workflow_number(session, 0, span);
    items[COLOR] = alpha ? color->items[COLOR] : gltf_workflow_number(session, 1, span);
    return list_of(session, items, COLOR + 1, span);
}

GltfKeys gltf_workflow_unlit(Session *session, const GltfKeys *lit, Span span)
{
    static const char *const kept[] = {"material", "alphaMode", "alphaCutoff", "baseColorTexture"};
    GltfKeys made = {0};
    Tree *color = key_of(lit, "baseColorFactor"), *texture = key_of(lit, "baseColorTexture");
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++) {
        Tree *value = key_of(lit, kept[i]);
        if (value)
            gltf_workflow_put(session, &made, kept[i], value);
    }
    gltf_workflow_put(session, &made, "baseColorFactor", black(session, color, span));
    if (color && color->kind == TREE_list && color->count > COLOR)
        color = list_of(session, color->items, COLOR, color->span);
    gltf_workflow_put(session, &made, "emissiveFactor",
                      color ? color : gltf_workflow_number(session, 1, span));
    if (texture)
        gltf_workflow_put(session, &made, "emissiveTexture", texture);
    gltf_workflow_put(session, &made, "metallicFactor", gltf_workflow_number(session, 0, span));
    gltf_workflow_put(session, &made, "ior", gltf_workflow_number(session, 1, span));
    return made;
}
