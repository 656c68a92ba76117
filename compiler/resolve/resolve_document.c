/* The top level of a document: its materials, definitions and includes. */
#include "compiler/hints/lint.h"
#include "compiler/resolve/include.h"
#include "compiler/hints/hint.h"
#include "compiler/hints/common_error.h"
#include "compiler/resolve/resolve_definition.h"
#include "compiler/resolve/scene_check.h"
#include "compiler/base/text.h"
#include <stdlib.h>
#include <string.h>

bool resolve_is_name(const char *name)
{
    size_t size = strlen(name);
    if (!text_is_letter(name[0]) || size > LIMIT_NAME)
        return false;
    for (; *name; name++)
        if (!text_is_alphanumeric(*name) && !strchr("_-.", *name))
            return false;
    return true;
}

/* Returns a file's stem: "dir/rock.yaml" -> "rock"; "<stdin>" -> "stdin". */
static const char *stem(Session *session, const char *path)
{
    if (path[0] == '<' && path[strlen(path) - 1] == '>')
        return arena_string(session->arena, path + 1, strlen(path) - 2);
    const char *slash = strrchr(path, '/'), *start = slash ? slash + 1 : path,
               *dot = strrchr(start, '.');
    return arena_string(session->arena, start,
                        dot && dot != start ? (size_t)(dot - start) : strlen(start));
}

static bool read_defs(Resolver *r, Tree *document, int depth);

static bool read_include(Resolver *r, const Tree *name, int depth)
{
    bool fine;
    Tree *tree = include_read(r->session, name, depth, &fine);
    return tree ? read_defs(r, tree, depth + 1) : fine;
}

/* Names each definition after its key; a value with several keys gets the first. */
static void name_defs(const Tree *defs)
{
    for (uint32_t i = defs->count; i-- > 0;)
        defs->members[i].value->name = defs->members[i].key;
}

/* Checks that `defs:` is an object of names and values. Returns false after reporting another
 * form. */
static bool check_defs_form(Resolver *r, const Tree *defs)
{
    if (hint_assigned(r->session, defs))
        return false;
    if (defs->kind != TREE_object)
        diag_add(r->session, defs->span, DIAG_wrong_type, "defs",
                 "names with their values, `name: value`", tree_describe(r->session, defs));
    return defs->kind == TREE_object;
}

/* Collects `defs:` of the document, then those of its includes; each file's `colors:` applies to
 * that file only. */
static bool read_defs(Resolver *r, Tree *document, int depth)
{
    const Member *defs = tree_find(document, "defs"), *include = tree_find(document, "include");
    bool fine = resolve_color_space(r, document);
    if (defs && !tree_is_null(defs->value)) {
        if (!check_defs_form(r, defs->value)) {
            r->lacks_file = true;
            return false;
        }
        name_defs(defs->value);
        ARENA_PUSH(r->session->arena, r->defs, r->def_count, r->def_capacity, defs->value);
    }
    if (!include || tree_is_null(include->value))
        return fine;
    bool read = true;
    if (include->value->kind == TREE_list)
        for (uint32_t i = 0; i < include->value->count; i++)
            read &= read_include(r, include->value->items[i], depth);
    else
        read = read_include(r, include->value, depth);
    r->lacks_file |= !read;
    return fine && read;
}

/* Resolves materials: { name: material, ... } */
static bool resolve_list(Resolver *r, const Tree *list, NamedMaterial *materials)
{
    bool fine = true;
    for (uint32_t i = 0; i < list->count; i++) {
        const Member *member = &list->members[i];
        bool fault = false;
        if (!resolve_is_name(member->key)) {
            diag_add(r->session, member->span, DIAG_bad_name, member->key, LIMIT_NAME);
            fine = false;
        }
        materials[i] = (NamedMaterial){member->key, resolve_material(r, member->value, &fault)};
        if (!materials[i].node && !fault)
            diag_add(r->session, member->span, DIAG_missing_material_kind, "");
        fine &= materials[i].node != NULL;
    }
    return fine;
}

static bool is_scene_key(const char *key)
{
    const SceneKindRow *row = &scene_kind_table[SCENE_Scene];
    for (int i = row->first; i < row->first + row->count; i++)
        if (!strcmp(scene_param_table[i].param.name, key))
            return true;
    return false;
}

bool resolve_is_scene(const Tree *document)
{
    for (uint32_t i = 0; document->kind == TREE_object && i < document->count; i++)
        if (is_scene_key(document->members[i].key))
            return !tree_find(document, "material") && !tree_find(document, "ref");
    return false;
}

enum { OWN_KEYS = 6 };
static const char *top_key(const void *user, int i)
{
    (void)user;
    static const char *const keys[OWN_KEYS] = {"material", "materials", "defs",
                                               "include",  "colors",    "ref"};
    return i < OWN_KEYS
               ? keys[i]
               : scene_param_table[scene_kind_table[SCENE_Scene].first + i - OWN_KEYS].param.name;
}

static bool check_top(Resolver *r, const Tree *document, bool many)
{
    bool fine = true;
    for (uint32_t i = 0; many && i < document->count; i++) {
        const Member *member = &document->members[i];
        if (resolve_is_document_key(member->key) || is_scene_key(member->key) ||
            !strcmp(member->key, "materials"))
            continue;
        bool both = !strcmp(member->key, "material") || !strcmp(member->key, "ref");
        const char *near = common_error_foreign(r->session, FOREIGN_TOP, KIND_COUNT, member->key);
        if (!near)
            near = diag_suggest(r->session, member->key, top_key, NULL,
                                OWN_KEYS + scene_kind_table[SCENE_Scene].count);
        diag_add(r->session, member->span, both ? DIAG_both_materials : DIAG_unknown_top_key,
                 member->key, near);
        fine = false;
    }
    return fine;
}

/* Returns true for an object that a scene instances, which runtime/scene_reader reads. */
static bool is_scene_object(const Tree *tree)
{
    return tree->kind == TREE_object && tree_find(tree, "object");
}

/* Checks an unused definition, with the defaults of its parameters. */
static void check_def(Resolver *r, const Member *def)
{
    Tree *tree = def->value;
    bool fault = false;
    if (resolve_is_definition(tree) && !(tree = resolve_definition(r, def, NULL)))
        return;
    if (tree->made != MADE_node && !tree->failed) {
        def->value->open = tree != def->value;
        r->definition = def->value->open ? def : NULL;
        resolve_any(r, tree, tree->kind == TREE_object && tree_find(tree, "material"), false,
                    &fault);
        r->definition = NULL;
        def->value->open = false;
    }
}

/* Unused definitions are checked too: their faults count as faults of the document. */
static void check_defs(Resolver *r, const Tree *document)
{
    const bool scene = resolve_is_scene(document);
    for (size_t i = 0; i < r->def_count; i++)
        for (uint32_t k = 0; k < r->defs[i]->count; k++) {
            const Member *def = &r->defs[i]->members[k];
            if (def->value->made != MADE_node && !def->value->failed &&
                !(scene && is_scene_object(def->value)))
                check_def(r, def);
        }
}

/* Returns true for a document of definitions for `include:`, without a material to compile. */
static bool has_definitions_only(const Tree *document)
{
    for (uint32_t i = 0; i < document->count; i++)
        if (!resolve_is_document_key(document->members[i].key))
            return false;
    return tree_find(document, "defs") || tree_find(document, "include");
}

static void *report_no_material(Session *session, const Tree *document)
{
    static const char *const keys[] = {"material", "materials", "ref"};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        const Member *other = common_error_case(document, keys[i]);
        if (other)
            return diag_add(session, other->span, DIAG_key_case, other->key, keys[i]);
    }
    if (common_error_keys(session, document) || hint_document(session, document))
        return NULL;
    return diag_add(session, document->span, DIAG_no_material, hint_no_material(session, document));
}

/* Returns true for a list whose first item is a material: - material: Phong */
static bool lists_material(const Tree *document)
{
    return document->kind == TREE_list && document->count &&
           document->items[0]->kind == TREE_object && tree_find(document->items[0], "material");
}

static void report_nothing_to_compile(Session *session, const Tree *document)
{
    diag_add(session, document->span, DIAG_definitions_only,
             resolve_is_scene(document) ? "this is a scene; draw it with matview"
                                        : "the document only contains definitions, for `include:`");
}

/* Returns a top-level `ref:` with its arguments, without the other top-level keys. */
static Tree *outermost_use(Session *session, const Tree *document)
{
    Tree *use = ARENA_NEW(session->arena, Tree);
    Member *members = ARENA_ARRAY(session->arena, Member, document->count);
    size_t count = 0;
    for (uint32_t i = 0; i < document->count; i++)
        if (!resolve_is_document_key(document->members[i].key))
            members[count++] = document->members[i];
    *use = (Tree){.kind = TREE_object, .span = tree_find(document, "ref")->span};
    tree_set_members(session, use, members, count);
    return use;
}

static bool resolve_one(Resolver *r, Tree *document, NamedMaterial *material)
{
    bool fault = false;
    const char *name = stem(r->session, r->session->sources[document->span.file].name);
    Tree *tree = tree_find(document, "ref") ? outermost_use(r->session, document) : document;
    *material = (NamedMaterial){name, resolve_any(r, tree, true, true, &fault)};
    return !fault;
}

Graph *resolve(Session *session, Tree *document)
{
    Resolver r = {.session = session};
    if (document->kind == TREE_scalar && common_error_key(session, document->span, document->text))
        return NULL;
    if (document->kind != TREE_object)
        return lists_material(document) && hint_listed(session, document)
                   ? NULL
                   : diag_add(session, document->span, DIAG_document_not_object);
    const Member *many = tree_find(document, "materials"), *one = tree_find(document, "material");
    if (!one)
        one = tree_find(document, "ref");
    const bool scene = resolve_is_scene(document);
    if (!many && !one && !scene && !has_definitions_only(document))
        return report_no_material(session, document);
    bool fine = check_top(&r, document, many || scene);
    fine &= read_defs(&r, document, 0);
    if (many && many->value->kind != TREE_object)
        return diag_add(session, many->value->span, DIAG_wrong_type, "materials",
                        "names with their materials, `name: { material: Phong }`",
                        tree_describe(session, many->value));
    if (many && !many->value->count)
        return diag_add(session, many->value->span, DIAG_no_materials);
    Graph *graph = ARENA_NEW(session->arena, Graph);
    graph->material_count = many ? (int)many->value->count : one != NULL;
    NamedMaterial *materials = ARENA_ARRAY(session->arena, NamedMaterial, graph->material_count);
    graph->materials = materials;
    if (many)
        fine &= resolve_list(&r, many->value, materials);
    else if (one)
        fine &= resolve_one(&r, document, materials);
    check_defs(&r, document);
    if (scene)
        scene_check(&r, document);
    if (!many && !one && fine && !session->diags.errors)
        report_nothing_to_compile(session, document);
    resolve_picture_spaces(&r, materials, graph->material_count);
    graph->defs = r.defs;
    graph->def_count = (int)r.def_count;
    graph->node_count = r.node_count;
    graph->uniforms = r.uniforms;
    graph->uniform_count = (int)r.uniform_count;
    graph->uniform_names = r.uniform_names;
    graph->attributes = r.attributes;
    graph->attribute_count = (int)r.attribute_count;
    graph->attribute_names = r.attribute_names;
    graph->images = r.images;
    graph->image_count = (int)r.image_count;
    if (!fine || session->diags.errors)
        return NULL;
    graph->models = ARENA_ARRAY(session->arena, unsigned, graph->node_count);
    graph_find_models(graph, r.nodes, r.named_count);
    lint_graph(session, graph, r.nodes, r.named_count);
    diag_sort(&session->diags); /* lints are found in node order but printed in line order */
    return session->diags.errors ? NULL : graph;
}
