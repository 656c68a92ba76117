/* Tree -> Graph: walks the document from its materials and creates typed nodes. A subtree that
 * is shared by an alias or a reference becomes one node. Names, types, defaults and ranges of
 * parameters come from the tables. */
#include "compiler/base/stack.h"
#include "compiler/hints/hint.h"
#include "compiler/hints/common_error.h"
#include "compiler/resolve/resolve_definition.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool is_material(Kind kind) { return kind_table[kind].lowering == LOWERING_MATERIAL; }

/* Names of kinds, then aliases, then presets: one list for lookup and suggestions. */
static int kind_name_count(void) { return KIND_COUNT + alias_count + preset_count; }

static const char *kind_name(int i, Kind *kind)
{
    if (i < KIND_COUNT) {
        *kind = (Kind)i;
        return kind_table[i].name;
    }
    i -= KIND_COUNT;
    *kind = i < alias_count ? alias_table[i].kind : preset_table[i - alias_count].kind;
    return i < alias_count ? alias_table[i].alias : preset_table[i - alias_count].name;
}

static const char *name_of_group(const void *material, int i)
{
    Kind kind;
    const char *name = kind_name(i, &kind);
    return is_material(kind) == *(const bool *)material ? name : NULL;
}

/* Returns a hint for an unknown kind: matc's name for it, a similar name, or where all names are
 * listed. */
static const char *near_kind(Resolver *r, const char *name, bool material)
{
    const char *near = common_error_foreign(r->session, material ? FOREIGN_MATERIAL : FOREIGN_MAP,
                                            KIND_COUNT, name);
    const NameChoice names = {name_of_group, &material, material ? KIND_COUNT : kind_name_count()};
    if (!near)
        near = hint_definition(r, name);
    if (!near)
        near = diag_suggest_or_list(r->session, name, &names, material ? "; there are " : NULL);
    return *near || diag_full(r->session) ? near : "; see matc --list";
}

/* Finds the kind with a name; *preset is set if the name is a preset. */
static bool find_kind(Resolver *r, const Tree *name, bool material, Kind *kind, const char **preset)
{
    if (name->kind != TREE_scalar) {
        const bool use = name->kind == TREE_object && tree_find(name, "ref");
        diag_add(r->session, name->span, use ? DIAG_ref_in_kind : DIAG_wrong_type,
                 material ? "`material:`" : "`map:`",
                 material && name->kind == TREE_object && !use
                     ? "a name, with the parameters at the same level, `material: Phong`"
                     : "a name",
                 tree_describe(r->session, name));
        return false;
    }
    /* the name belongs to a kind of the other group, map or material */
    bool other = false;
    for (int i = 0; i < kind_name_count(); i++) {
        const char *known = kind_name(i, kind);
        /* fast path: most names differ in the first letter */
        if (*known != *name->text || strcmp(known, name->text) != 0)
            continue;
        other |= is_material(*kind) != material;
        if (is_material(*kind) == material) {
            *preset = i >= KIND_COUNT + alias_count ? name->text : NULL;
            return true;
        }
    }
    const DiagKind unknown = material ? DIAG_unknown_material : DIAG_unknown_map;
    const DiagKind swapped = material ? DIAG_map_not_material : DIAG_material_not_map;
    const char *near =
        other ? common_error_foreign(r->session, material ? FOREIGN_MATERIAL : FOREIGN_MAP,
                                     KIND_COUNT, name->text)
              : near_kind(r, name->text, material);
    diag_add(r->session, name->span, other ? swapped : unknown, name->text, near ? near : "");
    return false;
}

static const char *param_name(const void *kind, int i)
{
    return param_table[((const KindRow *)kind)->first + i].name;
}

static bool resolve_node_param(Resolver *r, const ParamRow *row, Tree *tree, Value *value)
{
    if (hint_number_list(r, row, tree))
        return false;
    bool fault = false;
    const char *outer = r->param;
    const bool outer_one = r->one_number;
    r->param = row->name;
    r->one_number = row->type == PARAM_Map && param_is_number((int)(row - param_table));
    const Node *node =
        row->type == PARAM_Map ? resolve_map(r, tree, &fault) : resolve_material(r, tree, &fault);
    r->param = outer;
    r->one_number = outer_one;
    *value = (Value){.kind = node ? VALUE_node : VALUE_none, .node = node};
    if (fault || !node || node->kind != KIND_Constant)
        return !fault;
    return !hint_number_color(r, row, tree, &node->params[0]) &&
           resolve_in_range(r, row, tree, &node->params[0]);
}

static bool resolve_holder(Resolver *r, const ParamRow *row, Tree *tree, Value *value)
{
    if (row->type == PARAM_Maps) /* maps are resolved together with the formula that reads them */
        return true;
    if (row->type == PARAM_List)
        return resolve_map_list(r, row->name, tree, value);
    return row->type == PARAM_Items ? resolve_items(r, tree, value)
                                    : resolve_node_param(r, row, tree, value);
}

/* Resolves a parameter. A null value is treated as absent. */
bool resolve_param(Resolver *r, const ParamRow *row, Tree *tree, Value *value)
{
    if (tree_is_null(tree)) {
        *value = resolve_null(r, row, tree);
        return true;
    }
    const bool holds = row->type == PARAM_Map || row->type == PARAM_Material ||
                       row->type == PARAM_Items || row->type == PARAM_Maps ||
                       row->type == PARAM_List;
    const bool fine =
        holds ? resolve_holder(r, row, tree, value) : resolve_leaf(r, row, tree, value);
    value->given = true;
    value->span = tree->span;
    return fine;
}

static void set_presets(const char *preset, Kind kind, Value *params)
{
    for (int i = 0; preset && i < preset_count; i++)
        if (!strcmp(preset_table[i].name, preset))
            params[preset_table[i].param - kind_table[kind].first].number[0] = preset_table[i].init;
}

/* Returns a hint for an unknown parameter: matc's name for it, a similar name, or all names. */
static const char *near_param(Resolver *r, const KindRow *row, const char *key)
{
    enum { MAX_LISTED = 12 }; /* longer lists do not help within a message */
    const char *foreign =
        common_error_foreign(r->session, FOREIGN_PARAM, (Kind)(row - kind_table), key);
    if (!foreign)
        foreign = common_error_foreign(r->session, FOREIGN_KEY, KIND_COUNT, key);
    const NameChoice names = {param_name, row, row->count};
    if (foreign || row->count <= MAX_LISTED)
        return foreign ? foreign : diag_suggest_or_list(r->session, key, &names, "; it has ");
    const char *near = diag_suggest(r->session, key, names.name, names.user, names.count);
    if (*near || diag_full(r->session))
        return near;
    Text all = text_new(r->session->arena);
    text_format(&all, "; matc --explain %s lists all %d", row->name, row->count);
    return all.at;
}

static bool resolve_member(Resolver *r, const Member *member, Kind kind, const char *name,
                           Value *params)
{
    const KindRow *row = &kind_table[kind];
    for (int i = 0; i < row->count; i++)
        if (!strcmp(param_table[row->first + i].name, member->key))
            return resolve_param(r, &param_table[row->first + i], member->value, &params[i]);
    if (common_error_key(r->session, member->span, member->key))
        return false;
    const char *near = near_param(r, row, member->key);
    diag_add(r->session, member->span, DIAG_unknown_key, name, member->key, near);
    return false;
}

/* Owner of the maps in a material's parameter: the slot, if the parameter is one. */
static const char *slot_name(const char *param)
{
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (!strcmp(slot_table[slot].name, param))
            return slot_table[slot].name;
    return NULL;
}

/* Returns the author's name of a tree, which is stored until the tree is resolved. */
static const char *own_name(const Tree *tree)
{
    return tree->made == MADE_nothing ? tree->name : NULL;
}

/* Resolves { map: Kind, param: value, ... }, or the equivalent with `material:`. */
static const Node *resolve_node(Resolver *r, Tree *tree, bool material, bool outermost)
{
    const char *key = material ? "material" : "map", *preset;
    const Member *name = tree_find(tree, key);
    Kind kind;
    if (!name) {
        const Member *other = common_error_case(tree, key);
        if (other)
            return diag_add(r->session, other->span, DIAG_key_case, other->key, key);
        if (common_error_keys(r->session, tree) || hint_object(r, tree, material))
            return NULL;
        const char *hint = tree_find(tree, material ? "map" : "material")
                               ? material ? ", not `map:`" : ", not `material:`"
                               : "";
        return diag_add(r->session, tree->span,
                        material ? DIAG_missing_material_kind : DIAG_missing_kind, hint);
    }
    if (!find_kind(r, name->value, material, &kind, &preset))
        return NULL;
    const KindRow *row = &kind_table[kind];
    Value *params = ARENA_ARRAY(r->session->arena, Value, row->count);
    const char *outer = r->param;
    bool fine = true;
    r->param = NULL;
    r->one_number = false;
    for (int i = 0; i < row->count; i++)
        if (!tree_find(tree, param_table[row->first + i].name))
            params[i] = resolve_default(r, &param_table[row->first + i]);
    set_presets(preset, kind, params);
    for (uint32_t i = 0; i < tree->count; i++) {
        const Member *member = &tree->members[i];
        if (material)
            r->owner = slot_name(member->key);
        if (strcmp(member->key, key) != 0 && !(outermost && resolve_is_document_key(member->key)))
            fine &= resolve_member(r, member, kind, name->value->text, params);
    }
    if (kind == KIND_Expression)
        fine &= resolve_expression(r, tree, params);
    r->param = outer;
    const Node of = {
        .kind = kind, .span = name->value->span, .params = params, .name = own_name(tree)};
    if (resolve_is_foreign(kind))
        return fine ? resolve_translate(r, of) : NULL;
    const Node *node = resolve_make_node(r, of);
    if (kind == KIND_ImageMap && fine && node)
        resolve_picture(r, node, params);
    return fine ? node : NULL;
}

typedef struct {
    const Resolver *resolver;
    size_t def;
} DefNames;

static const char *def_name(const void *user, int i)
{
    const DefNames *names = user;
    return names->resolver->defs[names->def]->members[i].key;
}

/* Finds the definition of { ref: name }. */
static const Member *find_def(Resolver *r, const Tree *name)
{
    if (name->kind != TREE_scalar)
        return diag_add(r->session, name->span, DIAG_wrong_type, "ref", "a name",
                        tree_describe(r->session, name));
    const char *near = "";
    for (size_t i = 0; i < r->def_count; i++) {
        const Member *member = tree_find(r->defs[i], name->text);
        if (member)
            return member;
        DefNames names = {r, i};
        if (!*near)
            near = diag_suggest(r->session, name->text, def_name, &names, (int)r->defs[i]->count);
    }
    const char *shipped = hint_shipped(r->session, name->text);
    return r->lacks_file ? NULL
                         : diag_add(r->session, name->span, DIAG_unknown_ref, name->text,
                                    shipped ? shipped : near);
}

static bool says_material(Resolver *r, const Tree *tree)
{
    const Member *ref = tree_find(tree, "ref");
    bool material = tree_find(tree, "material") != NULL;
    for (size_t i = 0; i < r->def_count && ref && ref->value->kind == TREE_scalar && !material;
         i++) {
        const Member *def = tree_find(r->defs[i], ref->value->text);
        material = def && tree_find(def->value, "material");
    }
    return material;
}

/* Resolves maps and materials among the arguments before the definition is marked as open, since
 * they may use the same definition. Their faults are reported here, once. */
static void resolve_given(Resolver *r, const Tree *use)
{
    for (uint32_t i = 0; i < use->count; i++) {
        Tree *given = use->members[i].value;
        bool fault = false;
        if (given->kind != TREE_object ||
            !(tree_find(given, "map") || tree_find(given, "material") || tree_find(given, "ref")))
            continue;
        if (says_material(r, given))
            resolve_material(r, given, &fault);
        else
            resolve_map(r, given, &fault);
    }
}

static const Node *resolve_use(Resolver *r, Tree *use, const Member *def, bool material)
{
    bool fault = false;
    Tree *tree = resolve_definition(r, def, use);
    if (!tree)
        return NULL;
    const Member *outer = r->definition;
    const char *owner = r->owner;
    r->owner = def->key;
    resolve_given(r, use);
    r->owner = owner;
    r->definition = def;
    def->value->open = true;
    const Node *node = material ? resolve_material(r, tree, &fault) : resolve_map(r, tree, &fault);
    def->value->open = false;
    r->definition = outer;
    if (fault)
        resolve_report_use(r, def, use);
    return node;
}

static const Node *resolve_ref(Resolver *r, Tree *tree, bool material)
{
    const Member *ref = tree_find(tree, "ref"), *def = find_def(r, ref->value);
    bool fault = false;
    if (!def)
        return NULL;
    if (def->value->open)
        return diag_add(r->session, tree->span, DIAG_cycle, def->key);
    if (resolve_is_definition(def->value))
        return resolve_use(r, tree, def, material);
    if (tree->count > 1) {
        const Member *other = &tree->members[&tree->members[0] == ref];
        return diag_add(r->session, other->span, DIAG_ref_keys, def->key, other->key);
    }
    return material ? resolve_material(r, def->value, &fault) : resolve_map(r, def->value, &fault);
}

/* Resolves a text that begins with '=' as an Expression. */
static const Node *resolve_shorthand(Resolver *r, Tree *tree)
{
    Value *params = ARENA_ARRAY(r->session->arena, Value, kind_table[KIND_Expression].count);
    const Node of = {
        .kind = KIND_Expression, .span = tree->span, .params = params, .name = own_name(tree)};
    return resolve_formula(r, tree, NULL, params) ? resolve_make_node(r, of) : NULL;
}

/* Resolves a number, list, color or param as a Constant node. */
static const Node *resolve_constant(Resolver *r, Tree *tree)
{
    Value value;
    if (resolve_is_formula(tree))
        return resolve_shorthand(r, tree);
    if (common_error_map(r, tree) || common_error_param(r, tree) || hint_listed(r->session, tree) ||
        !resolve_number(r, r->param ? r->param : "a map", tree, (ComponentCount){1, 4}, &value))
        return NULL;
    return resolve_make_constant(r, (Node){.span = tree->span, .name = own_name(tree)}, value);
}

static const Node *resolve_new(Resolver *r, Tree *tree, bool material, bool outermost)
{
    if (tree->kind == TREE_object && tree_find(tree, "ref"))
        return resolve_ref(r, tree, material);
    if (material && tree->kind == TREE_scalar &&
        common_error_key(r->session, tree->span, tree->text))
        return NULL;
    if (material && hint_listed(r->session, tree))
        return NULL;
    if (material && tree->kind != TREE_object)
        return diag_add(r->session, tree->span, DIAG_missing_material_kind, "");
    if (tree->kind != TREE_object || (!material && tree_find(tree, "param")))
        return resolve_constant(r, tree);
    return resolve_node(r, tree, material, outermost);
}

typedef struct {
    Resolver *r;
    Tree *tree;
    bool material, outermost;
    const Node *node;
} Resolving;

static void resolve_on_stack(void *user)
{
    Resolving *of = user;
    of->node = resolve_new(of->r, of->tree, of->material, of->outermost);
}

/* Long chains of references could overflow the caller's stack: every LIMIT_SHALLOW levels
 * continue on a new stack. */
static const Node *resolve_below(Resolver *r, Tree *tree, bool material, bool outermost)
{
    Resolving of = {r, tree, material, outermost, NULL};
    if (r->depth % LIMIT_SHALLOW)
        return resolve_new(r, tree, material, outermost);
    stack_run(LIMIT_DEPTH, resolve_on_stack, &of);
    return of.node;
}

const Node *resolve_any(Resolver *r, Tree *tree, bool material, bool outermost, bool *fault)
{
    if (tree_is_null(tree))
        return NULL;
    if (tree->made == MADE_node && is_material(tree->node->kind) == material)
        return tree->node;
    const Node *node = NULL;
    const char *owner = r->owner;
    if (own_name(tree))
        r->owner = own_name(tree);
    if (r->depth >= LIMIT_REFERENCES)
        diag_add(r->session, tree->span, DIAG_too_deep, LIMIT_REFERENCES);
    else if (!tree->failed) {
        r->depth++;
        tree->open = true;
        node = resolve_below(r, tree, material, outermost);
        tree->open = false;
        r->depth--;
    }
    r->owner = owner;
    if (node) {
        tree->node = node;
        tree->made = MADE_node;
    }
    tree->failed = !node;
    *fault |= !node;
    return node;
}

const Node *resolve_map(Resolver *r, Tree *tree, bool *fault)
{
    return resolve_any(r, tree, false, false, fault);
}
const Node *resolve_material(Resolver *r, Tree *tree, bool *fault)
{
    return resolve_any(r, tree, true, false, fault);
}
