/* Reads a tree into a SceneNodeDesc, by the rows of scene.def. A key that no row has is an error.
 */
#include "runtime/scene_reader/scene_node.h"
#include "compiler/resolve/scene_check.h"
#include <string.h>

static const SceneKindRow *row_of(const SceneNodeDesc *desc)
{
    return &scene_kind_table[desc->kind];
}

static bool fail(SceneReader *r) { return r->fine = false; }

/* Rejects uniforms: a scene's numbers must be constant. */
static bool is_number(SceneReader *r, const SceneParamRow *row, const Value *value)
{
    if (value->kind != VALUE_uniform)
        return true;
    diag_add(r->session, value->span, DIAG_param_here, row->param.name,
             "values of a scene are not uniforms of a program");
    return fail(r);
}

static bool are_numbers(SceneReader *r, const SceneParamRow *row, const Transform *transform)
{
    const Value *const parts[] = {&transform->scale, &transform->translation, &transform->rotation,
                                  &transform->shear};
    bool fine = true;
    for (int i = 0; i < 4; i++)
        fine &= is_number(r, row, parts[i]);
    return fine;
}

static bool read_plain(SceneReader *r, const SceneParamRow *row, Tree *tree, Value *value)
{
    if (!resolve_param(&r->resolver, &row->param, tree, value))
        return fail(r);
    return value->kind == VALUE_transform ? are_numbers(r, row, value->transform)
                                          : is_number(r, row, value);
}

static bool read_value(SceneReader *r, const Member *member, SceneNodeDesc *desc, int place)
{
    const SceneParamRow *row = &scene_param_table[row_of(desc)->first + place];
    if (row->value == SCENE_VALUE_plain)
        return read_plain(r, row, member->value, &desc->values[place]);
    if (tree_is_null(member->value))
        return true;
    const bool list = member->value->kind == TREE_list;
    if (row->value == SCENE_VALUE_list && !list) {
        diag_add(r->session, member->value->span, DIAG_wrong_type, row->param.name, "a list",
                 tree_describe(r->session, member->value));
        return fail(r);
    }
    desc->given[place] = member->value;
    return true;
}

static void set_defaults(SceneReader *r, SceneNodeDesc *desc)
{
    for (int i = 0; i < row_of(desc)->count; i++) {
        const SceneParamRow *row = &scene_param_table[row_of(desc)->first + i];
        desc->given[i] = NULL;
        desc->values[i] = row->value == SCENE_VALUE_plain && row->param.components
                              ? resolve_default(&r->resolver, &row->param)
                              : (Value){0};
    }
}

static bool unknown_key(SceneReader *r, const SceneNodeDesc *desc, const Member *member)
{
    scene_check_unknown(r->session, desc->kind, member);
    return fail(r);
}

/* Reads all members except the one that names the kind, and keys for which `skips` returns true. */
static bool read_members(SceneReader *r, const Tree *tree, bool (*skips)(const char *key),
                         SceneNodeDesc *desc)
{
    const SceneKindRow *row = row_of(desc);
    bool fine = true;
    set_defaults(r, desc);
    for (uint32_t i = 0; i < tree->count; i++) {
        const Member *member = &tree->members[i];
        int place = 0;
        while (place < row->count &&
               strcmp(scene_param_table[row->first + place].param.name, member->key) != 0)
            place++;
        if (place < row->count)
            fine &= read_value(r, member, desc, place);
        else if (strcmp(member->key, scene_sort_table[row->sort].name) != 0 &&
                 !(skips && skips(member->key)))
            fine = unknown_key(r, desc, member);
    }
    return fine;
}

bool scene_node_read(SceneReader *r, Tree *tree, SceneSort sort, SceneNodeDesc *desc)
{
    if (tree->failed)
        return false; /* the errors of this alias were already reported */
    const int kind = scene_check_kind(r->session, tree, sort);
    desc->kind = (SceneKind)(kind < 0 ? 0 : kind);
    desc->tree = tree;
    if (kind < 0)
        fail(r);
    tree->failed = kind < 0 || !read_members(r, tree, NULL, desc);
    return !tree->failed;
}

static bool is_document_key(const char *key)
{
    return resolve_is_document_key(key) || !strcmp(key, "materials");
}

bool scene_node_read_document(SceneReader *r, Tree *tree, SceneNodeDesc *desc)
{
    *desc = (SceneNodeDesc){.kind = SCENE_Scene, .tree = tree};
    return read_members(r, tree, is_document_key, desc);
}

void scene_node_default(SceneReader *r, SceneSort sort, SceneNodeDesc *desc)
{
    int kind = 0;
    while (scene_kind_table[kind].sort != sort)
        kind++;
    desc->kind = (SceneKind)kind;
    desc->tree = NULL;
    set_defaults(r, desc);
}

static int place_of(const SceneNodeDesc *desc, int param) { return param - row_of(desc)->first; }

void scene_node_preset(SceneNodeDesc *desc, int key)
{
    const Keyword word = (Keyword)scene_node_number(desc, key);
    for (int i = 0; i < scene_preset_count; i++) {
        const ScenePresetRow *row = &scene_preset_table[i];
        const char *name = scene_param_table[row->param].param.name;
        if (row->key == key && row->word == word && !(desc->tree && tree_find(desc->tree, name)))
            desc->values[place_of(desc, row->param)].number[0] = row->value;
    }
}

double scene_node_number(const SceneNodeDesc *desc, int param)
{
    return desc->values[place_of(desc, param)].number[0];
}

void scene_node_vector(const SceneNodeDesc *desc, int param, double vector[3])
{
    double components[4];
    value_number(&desc->values[place_of(desc, param)], TYPE_vec3, components);
    memcpy(vector, components, 3 * sizeof *vector);
}

const Transform *scene_node_transform(const SceneNodeDesc *desc, int param)
{
    const Value *value = &desc->values[place_of(desc, param)];
    return value->kind == VALUE_transform ? value->transform : NULL;
}

const char *scene_node_name(SceneReader *r, const Tree *given)
{
    if (!given || (given->kind == TREE_scalar && *given->text))
        return given ? given->text : NULL;
    diag_add(r->session, given->span, DIAG_wrong_type, "name", "a string",
             tree_describe(r->session, given));
    fail(r);
    return NULL;
}

Tree *scene_node_given(const SceneNodeDesc *desc, int param)
{
    return desc->given[place_of(desc, param)];
}

Span scene_node_span(const SceneNodeDesc *desc, int param)
{
    const SceneParamRow *row = &scene_param_table[param];
    const Member *member = desc->tree ? tree_find(desc->tree, row->param.name) : NULL;
    return member ? member->value->span : desc->tree ? desc->tree->span : NO_SPAN;
}
