/* Checks the parts of a scene by the rows of scene.def. */
#include "compiler/resolve/scene_check.h"
#include "compiler/base/hash.h"
#include "compiler/base/hash_index.h"
#include "compiler/base/text.h"
#include "compiler/hints/common_error.h"
#include <string.h>

typedef struct {
    Session *session;
    Resolver resolver;     /* resolves values; its nodes belong to no program */
    const Tree *materials; /* `materials:` of the document; NULL: absent */
    const Tree *defs;      /* `defs:` of the document; NULL: absent */
    HashIndex met;         /* parts already checked, since aliases can share them */
    const Tree **parts;
    size_t part_count, part_capacity;
} SceneCheck;

/* -- Kinds and keys */

static const char *param_name(const void *user, int i)
{
    return scene_param_table[((const SceneKindRow *)user)->first + i].param.name;
}

/* Returns the name of the i-th kind if it has the given sort, otherwise NULL. */
static const char *kind_name(const void *user, int i)
{
    return scene_kind_table[i].sort == *(const SceneSort *)user ? scene_kind_table[i].name : NULL;
}

/* Returns the correct form for a message: `{ toneMapping: Filmic }`. */
static const char *written_kind(Session *session, const Tree *tree, SceneSort sort)
{
    Text written = text_new(session->arena);
    const char *name = scene_sort_table[sort].name;
    int kind = 0;
    while (kind < SCENE_KIND_COUNT && scene_kind_table[kind].sort != sort)
        kind++;
    const bool named = tree->kind == TREE_scalar && scene_kind_find(sort, tree->text) >= 0;
    text_format(&written, "`{ %s: %s%s }`", name, named ? tree->text : scene_kind_table[kind].name,
                tree->kind == TREE_object && tree->count ? ", ..." : "");
    return written.at;
}

static void report_missing_kind(Session *session, const Tree *tree, SceneSort sort)
{
    const char *name = scene_sort_table[sort].name;
    const Member *other = tree->kind == TREE_object ? common_error_case(tree, name) : NULL;
    if (other)
        diag_add(session, other->span, DIAG_key_case, other->key, name);
    else
        diag_add(session, tree->span, DIAG_scene_kind, name, name,
                 suggest_list(session->arena, &(NameChoice){kind_name, &sort, SCENE_KIND_COUNT}),
                 written_kind(session, tree, sort));
}

int scene_check_kind(Session *session, const Tree *tree, SceneSort sort)
{
    const char *name = scene_sort_table[sort].name;
    const Member *member = tree->kind == TREE_object ? tree_find(tree, name) : NULL;
    if (!member && tree->kind == TREE_object && scene_kind_only(sort) >= 0)
        return scene_kind_only(sort);
    if (!member)
        return report_missing_kind(session, tree, sort), -1;
    if (member->value->kind != TREE_scalar) {
        diag_add(session, member->value->span, DIAG_wrong_type, name, "a name",
                 tree_describe(session, member->value));
        return -1;
    }
    const int kind = scene_kind_find(sort, member->value->text);
    if (kind >= 0)
        return kind;
    const NameChoice names = {kind_name, &sort, SCENE_KIND_COUNT};
    const char *foreign =
        common_error_foreign(session, FOREIGN_SCENE, KIND_COUNT, member->value->text);
    diag_add(session, member->value->span, DIAG_unknown_scene_kind, name, member->value->text,
             foreign ? foreign
                     : diag_suggest_or_list(session, member->value->text, &names, "; there are "));
    return -1;
}

void scene_check_unknown(Session *session, SceneKind kind, const Member *member)
{
    const SceneKindRow *row = &scene_kind_table[kind];
    const bool scene = kind == SCENE_Scene;
    const NameChoice names = {param_name, row, row->count};
    const char *near =
        common_error_foreign(session, scene ? FOREIGN_TOP : FOREIGN_PLACE, KIND_COUNT, member->key);
    if (!near)
        near = diag_suggest_or_list(session, member->key, &names, scene ? NULL : "; it has ");
    if (scene)
        diag_add(session, member->span, DIAG_unknown_top_key, member->key, near);
    else
        diag_add(session, member->span, DIAG_unknown_key, row->name, member->key, near);
}

/* -- Values */

static const char *member_name(const void *user, int i)
{
    return ((const Tree *)user)->members[i].key;
}

static void check_material_name(SceneCheck *c, const Tree *name)
{
    static const Tree none = {.kind = TREE_object};
    const Tree *all = c->materials ? c->materials : &none;
    const NameChoice names = {member_name, all, (int)all->count};
    if (!tree_find(all, name->text))
        diag_add(c->session, name->span, DIAG_no_such_material, name->text,
                 diag_suggest_or_list(c->session, name->text, &names,
                                      all->count ? "; there are " : NULL));
}

/* Checks a material: a name, an inline material, or a file, which is not read. */
static void check_material(SceneCheck *c, Tree *tree)
{
    bool fault = false;
    if (tree->kind == TREE_scalar)
        check_material_name(c, tree);
    else if (tree->kind != TREE_object)
        diag_add(c->session, tree->span, DIAG_wrong_type, "material",
                 "a name, a material, or `{ file: name }`", tree_describe(c->session, tree));
    else if (!tree_find(tree, "file"))
        resolve_material(&c->resolver, tree, &fault);
}

static bool is_object(const Tree *tree)
{
    return tree->kind == TREE_object && tree_find(tree, "object");
}

/* Checks the name of an object under `defs:`. */
static void check_name(SceneCheck *c, const Tree *name)
{
    const Member *found =
        c->defs && name->kind == TREE_scalar ? tree_find(c->defs, name->text) : NULL;
    if (found && is_object(found->value))
        return;
    if (found || name->kind != TREE_scalar)
        diag_add(c->session, name->span, DIAG_wrong_type, "of",
                 "the name of an object under `defs:`",
                 found ? "a map or a material" : tree_describe(c->session, name));
    else
        diag_add(c->session, name->span, DIAG_unknown_ref, name->text,
                 c->defs ? diag_suggest(c->session, name->text, member_name, c->defs,
                                        (int)c->defs->count)
                         : "");
}

/* Rejects a param, which would be a uniform of a program; a scene has no program. */
static void check_plain(SceneCheck *c, const ParamRow *row, Tree *tree)
{
    Value value;
    if (resolve_param(&c->resolver, row, tree, &value) && value.kind == VALUE_uniform)
        diag_add(c->session, value.span, DIAG_param_here, row->name,
                 "values of a scene are not uniforms of a program");
}

static void check_part(SceneCheck *c, Tree *tree, SceneSort sort);

static void check_list(SceneCheck *c, const SceneParamRow *row, const Tree *list)
{
    if (list->kind != TREE_list)
        diag_add(c->session, list->span, DIAG_wrong_type, row->param.name, "a list",
                 tree_describe(c->session, list));
    for (uint32_t i = 0; list->kind == TREE_list && i < list->count; i++)
        check_part(c, list->items[i], row->of);
}

static void check_value(SceneCheck *c, const SceneParamRow *row, Tree *tree)
{
    if (tree_is_null(tree))
        return;
    switch (row->value) {
    case SCENE_VALUE_plain:
        check_plain(c, &row->param, tree);
        break;
    case SCENE_VALUE_material:
        check_material(c, tree);
        break;
    case SCENE_VALUE_name:
        check_name(c, tree);
        break;
    case SCENE_VALUE_one:
        check_part(c, tree, row->of);
        break;
    case SCENE_VALUE_list:
        check_list(c, row, tree);
        break;
    case SCENE_VALUE_file:
        break;
    }
}

static const SceneParamRow *find_row(SceneKind kind, const char *key)
{
    const SceneKindRow *row = &scene_kind_table[kind];
    for (int i = row->first; i < row->first + row->count; i++)
        if (!strcmp(scene_param_table[i].param.name, key))
            return &scene_param_table[i];
    return NULL;
}

/* Lists and objects shared by aliases are checked once: nested aliases could expand
 * exponentially. */
static bool is_met(SceneCheck *c, const Tree *tree)
{
    HashProbe probe = hash_probe(&c->met, hash_pointer(tree));
    while (hash_probe_next(&probe))
        if (c->parts[probe.number] == tree)
            return true;
    hash_index_add(c->session->arena, &c->met, hash_pointer(tree), (uint32_t)c->part_count);
    ARENA_PUSH(c->session->arena, c->parts, c->part_count, c->part_capacity, tree);
    return false;
}

static void check_part(SceneCheck *c, Tree *tree, SceneSort sort)
{
    const int kind = is_met(c, tree) ? -1 : scene_check_kind(c->session, tree, sort);
    for (uint32_t i = 0; kind >= 0 && i < tree->count; i++) {
        const Member *member = &tree->members[i];
        const SceneParamRow *row = find_row((SceneKind)kind, member->key);
        if (row)
            check_value(c, row, member->value);
        else if (strcmp(member->key, scene_sort_table[sort].name) != 0)
            scene_check_unknown(c->session, (SceneKind)kind, member);
    }
}

void scene_check(const Resolver *r, const Tree *document)
{
    const Member *materials = tree_find(document, "materials"), *defs = tree_find(document, "defs");
    SceneCheck c = {.session = r->session};
    c.resolver = (Resolver){.session = r->session,
                            .defs = r->defs,
                            .def_count = r->def_count,
                            .lacks_file = r->lacks_file,
                            .file_colors = r->file_colors,
                            .file_color_capacity = r->file_color_capacity};
    c.materials = materials && materials->value->kind == TREE_object ? materials->value : NULL;
    c.defs = defs && defs->value->kind == TREE_object ? defs->value : NULL;
    for (uint32_t i = 0; i < document->count; i++) {
        const SceneParamRow *row = find_row(SCENE_Scene, document->members[i].key);
        if (row)
            check_value(&c, row, document->members[i].value);
    }
    for (uint32_t i = 0; c.defs && i < c.defs->count; i++)
        if (is_object(c.defs->members[i].value))
            check_part(&c, c.defs->members[i].value, SCENE_SORT_object);
}
