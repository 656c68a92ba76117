/* Tree -> SceneThing, by the rows of scene.def. Every key that no row has is a fault. */
#include "runtime/scene/scene_thing.h"
#include "compiler/front/mistake.h"
#include <string.h>

static const SceneKindRow *row_of(const SceneThing *thing) { return &scene_kind_table[thing->kind]; }

static bool fail(SceneReader *r) { return r->fine = false; }

static const char *param_name(const void *user, int i)
{
    return scene_param_table[((const SceneKindRow *)user)->first + i].param.name;
}

/* The i-th of all kinds, if it is of the sort. */
static const char *kind_name(const void *user, int i)
{
    return scene_kind_table[i].sort == *(const SceneSort *)user ? scene_kind_table[i].name : NULL;
}

/* A value that only a shader could be told later has no place in a scene. */
static bool is_number(SceneReader *r, const SceneParamRow *row, const Value *value)
{
    if (value->kind != VALUE_uniform)
        return true;
    diag_add(r->session, value->span, DIAG_param_here, row->param.name,
             "it is of a scene, and no uniform of a program");
    return fail(r);
}

static bool are_numbers(SceneReader *r, const SceneParamRow *row, const Transform *transform)
{
    const Value *const parts[] = {&transform->scale, &transform->translation, &transform->rotation, &transform->shear};
    bool fine = true;
    for (int i = 0; i < 4; i++)
        fine &= is_number(r, row, parts[i]);
    return fine;
}

static bool read_plain(SceneReader *r, const SceneParamRow *row, Tree *tree, Value *value)
{
    if (!resolve_param(&r->resolver, &row->param, tree, value))
        return fail(r);
    return value->kind == VALUE_transform ? are_numbers(r, row, value->transform) : is_number(r, row, value);
}

static bool read_value(SceneReader *r, const Member *member, SceneThing *thing, int place)
{
    const SceneParamRow *row = &scene_param_table[row_of(thing)->first + place];
    if (row->value == SCENE_VALUE_plain)
        return read_plain(r, row, member->value, &thing->values[place]);
    if (tree_is_null(member->value))
        return true;
    const bool list = member->value->kind == TREE_list;
    if (row->value == SCENE_VALUE_list && !list) {
        diag_add(r->session, member->value->span, DIAG_wrong_type, row->param.name, "a list",
                 tree_describe(r->session, member->value));
        return fail(r);
    }
    thing->given[place] = member->value;
    return true;
}

static void set_defaults(SceneReader *r, SceneThing *thing)
{
    for (int i = 0; i < row_of(thing)->count; i++) {
        const SceneParamRow *row = &scene_param_table[row_of(thing)->first + i];
        thing->given[i] = NULL;
        thing->values[i] = row->value == SCENE_VALUE_plain && row->param.lanes
                               ? resolve_default(&r->resolver, &row->param)
                               : (Value){0};
    }
}

static bool unknown_key(SceneReader *r, const SceneThing *thing, const Member *member)
{
    const SceneKindRow *row = row_of(thing);
    const NameChoice names = {param_name, row, row->count};
    const char *foreign = mistake_foreign(r->session, FOREIGN_PLACE, KIND_COUNT, member->key);
    if (thing->kind == SCENE_Scene)
        diag_add(r->session, member->span, DIAG_unknown_top_key, member->key,
                 diag_suggest(r->session, member->key, param_name, row, row->count));
    else
        diag_add(r->session, member->span, DIAG_unknown_key, row->name, member->key,
                 foreign ? foreign : diag_suggest_or_list(r->session, member->key, &names, "; it has "));
    return fail(r);
}

/* Every member but the one that names the kind, and `skips`: keys that belong to others. */
static bool read_members(SceneReader *r, const Tree *tree, bool (*skips)(const char *key), SceneThing *thing)
{
    const SceneKindRow *row = row_of(thing);
    bool fine = true;
    set_defaults(r, thing);
    for (uint32_t i = 0; i < tree->count; i++) {
        const Member *member = &tree->members[i];
        int place = 0;
        while (place < row->count && strcmp(scene_param_table[row->first + place].param.name, member->key) != 0)
            place++;
        if (place < row->count)
            fine &= read_value(r, member, thing, place);
        else if (strcmp(member->key, scene_sort_table[row->sort].name) != 0 && !(skips && skips(member->key)))
            fine &= unknown_key(r, thing, member);
    }
    return fine;
}

/* As it is to be written: `toneMapping: { toneMapping: Filmic }`. */
static const char *written_kind(SceneReader *r, const Tree *tree, SceneSort sort)
{
    Text written = text_new(r->session->arena);
    const char *name = scene_sort_table[sort].name;
    int kind = 0;
    while (kind < SCENE_KIND_COUNT && scene_kind_table[kind].sort != sort)
        kind++;
    const bool named = tree->kind == TREE_scalar && scene_kind_find(sort, tree->text) >= 0;
    text_format(&written, "`{ %s: %s%s }`", name, named ? tree->text : scene_kind_table[kind].name,
                tree->kind == TREE_object && tree->count ? ", ..." : "");
    return written.at;
}

static bool missing_kind(SceneReader *r, const Tree *tree, SceneSort sort)
{
    const char *name = scene_sort_table[sort].name;
    const Member *other = tree->kind == TREE_object ? mistake_case(tree, name) : NULL;
    if (other)
        diag_add(r->session, other->span, DIAG_key_case, other->key, name);
    else
        diag_add(r->session, tree->span, DIAG_scene_kind, name, name,
                 suggest_list(r->session->arena, &(NameChoice){kind_name, &sort, SCENE_KIND_COUNT}),
                 written_kind(r, tree, sort));
    return fail(r);
}

/* -1: told. */
static int find_kind(SceneReader *r, const Tree *tree, SceneSort sort)
{
    const char *name = scene_sort_table[sort].name;
    const Member *member = tree->kind == TREE_object ? tree_find(tree, name) : NULL;
    if (!member && tree->kind == TREE_object && scene_kind_only(sort) >= 0)
        return scene_kind_only(sort);
    if (!member)
        return missing_kind(r, tree, sort), -1;
    if (member->value->kind != TREE_scalar) {
        diag_add(r->session, member->value->span, DIAG_wrong_type, name, "a name",
                 tree_describe(r->session, member->value));
        return fail(r), -1;
    }
    const int kind = scene_kind_find(sort, member->value->text);
    if (kind < 0) {
        const NameChoice names = {kind_name, &sort, SCENE_KIND_COUNT};
        const char *foreign = mistake_foreign(r->session, FOREIGN_SCENE, KIND_COUNT, member->value->text);
        diag_add(r->session, member->value->span, DIAG_unknown_scene_kind, name, member->value->text,
                 foreign ? foreign : diag_suggest_or_list(r->session, member->value->text, &names, "; there are "));
        fail(r);
    }
    return kind;
}

bool scene_thing_read(SceneReader *r, Tree *tree, SceneSort sort, SceneThing *thing)
{
    if (tree->failed)
        return false; /* an alias of what was told already */
    const int kind = find_kind(r, tree, sort);
    thing->kind = (SceneKind)(kind < 0 ? 0 : kind);
    thing->tree = tree;
    tree->failed = kind < 0 || !read_members(r, tree, NULL, thing);
    return !tree->failed;
}

static bool is_document_key(const char *key) { return resolve_is_document_key(key) || !strcmp(key, "materials"); }

bool scene_thing_read_document(SceneReader *r, Tree *tree, SceneThing *thing)
{
    *thing = (SceneThing){.kind = SCENE_Scene, .tree = tree};
    return read_members(r, tree, is_document_key, thing);
}

void scene_thing_default(SceneReader *r, SceneSort sort, SceneThing *thing)
{
    int kind = 0;
    while (scene_kind_table[kind].sort != sort)
        kind++;
    thing->kind = (SceneKind)kind;
    thing->tree = NULL;
    set_defaults(r, thing);
}

static int place_of(const SceneThing *thing, int param) { return param - row_of(thing)->first; }

void scene_thing_preset(SceneThing *thing, Word preset)
{
    for (int i = 0; i < scene_preset_count; i++) {
        const ScenePresetRow *row = &scene_preset_table[i];
        const char *name = scene_param_table[row->param].param.name;
        if (row->kind == thing->kind && row->word == preset && !(thing->tree && tree_find(thing->tree, name)))
            thing->values[place_of(thing, row->param)].number[0] = row->value;
    }
}

double scene_thing_number(const SceneThing *thing, int param)
{
    return thing->values[place_of(thing, param)].number[0];
}

void scene_thing_vector(const SceneThing *thing, int param, double vector[3])
{
    double lanes[4];
    value_number(&thing->values[place_of(thing, param)], TYPE_vec3, lanes);
    memcpy(vector, lanes, 3 * sizeof *vector);
}

const Transform *scene_thing_transform(const SceneThing *thing, int param)
{
    const Value *value = &thing->values[place_of(thing, param)];
    return value->kind == VALUE_transform ? value->transform : NULL;
}

Tree *scene_thing_given(const SceneThing *thing, int param) { return thing->given[place_of(thing, param)]; }

Span scene_thing_span(const SceneThing *thing, int param)
{
    const SceneParamRow *row = &scene_param_table[param];
    const Member *member = thing->tree ? tree_find(thing->tree, row->param.name) : NULL;
    return member ? member->value->span : thing->tree ? thing->tree->span : NO_SPAN;
}
