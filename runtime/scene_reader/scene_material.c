/* Materials of a scene: a name of `materials:`, an inline material, or one of another file. The
 * document's own materials are resolved together: an inline one is appended to `materials:`. */
#include "compiler/base/text.h"
#include "compiler/document.h"
#include "runtime/scene_reader/scene_part.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define HASH_FACTOR 0x9E3779B1u /* hash factor: 2^32 / golden ratio */

static int fail(SceneReader *r)
{
    r->fine = false;
    return -1;
}

/* Returns the index of a material, added on first use: in scene->materials, or, for objects
 * outside the scene, in asides. */
static int use(SceneReader *r, MatcDocument *document, int index)
{
    Scene *scene = r->scene;
    const uint32_t hash = hash_pointer(document) ^ (uint32_t)index * HASH_FACTOR;
    const SceneMaterial *known = r->aside ? r->asides : scene->materials;
    HashIndex *places = r->aside ? &r->aside_used : &r->used;
    HashProbe probe = hash_probe(places, hash);
    while (hash_probe_next(&probe)) {
        const SceneMaterial *other = &known[probe.number];
        if (other->document == document && other->index == index)
            return (int)probe.number;
    }
    const SceneMaterial material = {document, index};
    size_t count = r->aside ? r->aside_count : (size_t)scene->material_count;
    hash_index_add(r->session->arena, places, hash, (uint32_t)count);
    if (r->aside) {
        ARENA_PUSH(r->session->arena, r->asides, r->aside_count, r->aside_capacity, material);
        return (int)count;
    }
    ARENA_PUSH(r->session->arena, scene->materials, count, r->used_capacity, material);
    scene->material_count = (int)count;
    return scene->material_count - 1;
}

static const char *member_name(const void *user, int i) { return ((const Member *)user)[i].key; }

static int read_name(SceneReader *r, const Tree *tree)
{
    const Member *found = r->named ? tree_find(r->named, tree->text) : NULL;
    if (found)
        return use(r, r->document, (int)(found - r->named->members));
    const NameChoice names = {member_name, r->materials, (int)r->named_count};
    diag_add(r->session, tree->span, DIAG_no_such_material, tree->text,
             diag_suggest_or_list(r->session, tree->text, &names,
                                  r->named_count ? "; there are " : NULL));
    return fail(r);
}

/* Appends an inline material under a unique name; an alias of the same tree gets the same index. */
static int read_inline(SceneReader *r, Tree *tree)
{
    char name[LIMIT_NAME];
    Arena *arena = r->session->arena;
    HashProbe probe = hash_probe(&r->inlines, hash_pointer(tree));
    while (hash_probe_next(&probe))
        if (r->materials[probe.number].value == tree)
            return use(r, r->document, (int)probe.number);
    do
        snprintf(name, sizeof name, "inline%zu", r->inline_number++);
    while (r->named && tree_find(r->named, name));
    hash_index_add(arena, &r->inlines, hash_pointer(tree), (uint32_t)r->material_count);
    const Member member = {arena_string(arena, name, strlen(name)), tree, tree->span,
                           (uint32_t)strlen(name)};
    ARENA_PUSH(arena, r->materials, r->material_count, r->material_capacity, member);
    return use(r, r->document, (int)r->material_count - 1);
}

/* Returns the first error of a document, without the lines that show its place, in the arena.
 * Warnings may precede it. */
static const char *first_error(SceneReader *r, MatcDocument *document)
{
    const char *all = matc_diagnostics(document, MATC_TEXT), *error = strstr(all, ": error: ");
    const char *line = error ? error : all;
    while (line > all && line[-1] != '\n')
        line--;
    return arena_string(r->session->arena, line, strcspn(line, "\n"));
}

/* Reads a document; returns its index in scene->documents, or -1 with a reason in *why. */
static int read_document_file(SceneReader *r, const char *path, const char **why)
{
    Scene *scene = r->scene;
    size_t size = 0, count = (size_t)scene->document_count;
    session_depend_on(r->session, path);
    char *text = session_read_file(r->session, path, &size, why);
    if (!text)
        return -1;
    MatcDocument *document = matc_read(path, text, size, r->session->options);
    free(text);
    for (int i = 1; i < matc_depend_count(document); i++)
        session_depend_on(r->session, matc_depend(document, i));
    ARENA_PUSH(r->session->arena, scene->documents, count, r->document_capacity, document);
    scene->document_count = (int)count;
    return (int)count - 1;
}

/* Returns the document of a path, read once and cached; NULL after an error was reported. */
static MatcDocument *open_document(SceneReader *r, const Tree *tree)
{
    const char *why = "";
    const char *path =
        session_path_beside(r->session, r->session->sources[tree->span.file].name, tree->text);
    const int known = names_find(&r->document_paths, path);
    if (known >= 0)
        return r->scene->documents[known];
    const int read = read_document_file(r, path, &why);
    if (read < 0)
        return diag_add(r->session, tree->span, DIAG_cannot_read, tree->text, why);
    names_add(r->session->arena, &r->document_paths, path);
    return r->scene->documents[read];
}

static const char *material_name(const void *user, int i) { return matc_material_name(user, i); }

/* Checks that a tree has only the keys of { file: path, material: name }; the name is optional. */
static bool is_of_file(SceneReader *r, const Tree *tree)
{
    for (uint32_t i = 0; i < tree->count; i++) {
        const Member *member = &tree->members[i];
        const bool known = !strcmp(member->key, "file") || !strcmp(member->key, "material");
        if (!known)
            diag_add(r->session, member->span, DIAG_material_file_keys, member->key);
        else if (member->value->kind != TREE_scalar)
            diag_add(r->session, member->value->span, DIAG_wrong_type, member->key, "a name",
                     tree_describe(r->session, member->value));
        if (!known || member->value->kind != TREE_scalar)
            return false;
    }
    return true;
}

/* Returns the number of a document's material, by name or the only one; -1 after an error was
 * reported. */
static int find_material(SceneReader *r, const MatcDocument *document, const Tree *path,
                         const Member *name)
{
    const int count = matc_material_count(document);
    const char *wanted = name ? name->value->text : "";
    const int index = name ? matc_material_find(document, wanted) : count == 1 ? 0 : -1;
    const NameChoice names = {material_name, document, count};
    if (index < 0)
        diag_add(r->session, name ? name->value->span : path->span, DIAG_no_such_material, wanted,
                 diag_suggest_or_list(r->session, wanted, &names, "; there are "));
    return index;
}

/* Returns a document that has no errors; NULL after an error was reported. */
static MatcDocument *sound_document(SceneReader *r, const Tree *path)
{
    MatcDocument *document = open_document(r, path);
    if (!document || !matc_error_count(document))
        return document;
    return diag_add(r->session, path->span, DIAG_cannot_read, path->text, first_error(r, document));
}

static int read_file(SceneReader *r, const Tree *tree)
{
    if (!is_of_file(r, tree))
        return fail(r);
    const Tree *path = tree_find(tree, "file")->value;
    MatcDocument *document = sound_document(r, path);
    const int index = document ? find_material(r, document, path, tree_find(tree, "material")) : -1;
    return index < 0 ? fail(r) : use(r, document, index);
}

/* Parts without a material in the file use its last material, `default`. */
int scene_material_read_of(SceneReader *r, const Tree *path, int number)
{
    MatcDocument *document = sound_document(r, path);
    const int last = document ? matc_material_count(document) - 1 : -1;
    return last < 0 ? fail(r) : use(r, document, number < last ? number : last);
}

int scene_material_read(SceneReader *r, Tree *tree)
{
    if (tree->kind == TREE_scalar)
        return read_name(r, tree);
    if (tree->kind == TREE_object && tree_find(tree, "file"))
        return read_file(r, tree);
    if (tree->kind == TREE_object)
        return read_inline(r, tree);
    diag_add(r->session, tree->span, DIAG_wrong_type, "material",
             "a name, a material, or `{ file: name }`", tree_describe(r->session, tree));
    return fail(r);
}

void scene_material_open(SceneReader *r, const Tree *document)
{
    const Member *materials = tree_find(document, "materials");
    if (materials && materials->value->kind != TREE_object) {
        diag_add(r->session, materials->value->span, DIAG_wrong_type, "materials", "an object",
                 tree_describe(r->session, materials->value));
        r->fine = false;
    }
    if (!materials || materials->value->kind != TREE_object)
        return;
    for (uint32_t i = 0; i < materials->value->count; i++)
        ARENA_PUSH(r->session->arena, r->materials, r->material_count, r->material_capacity,
                   materials->value->members[i]);
    r->named_count = r->inline_number = r->material_count;
    r->named = materials->value;
}

/* Returns a copy of the document without scene keys and with all materials. */
static Tree *only_materials(SceneReader *r, const Tree *document)
{
    Arena *arena = r->session->arena;
    const Member *given = tree_find(document, "materials");
    Tree *tree = ARENA_NEW(arena, Tree), *materials = ARENA_NEW(arena, Tree);
    Member *members = ARENA_ARRAY(arena, Member, document->count + 1);
    size_t count = 0;
    for (uint32_t i = 0; i < document->count; i++)
        if (resolve_is_document_key(document->members[i].key)) {
            members[count] = document->members[i];
            if (document->members[i].value == r->definitions)
                members[count].value = scene_definition_others(r, document->members[i].value);
            count++;
        }
    *tree = (Tree){.kind = TREE_object, .span = document->span};
    *materials = (Tree){.kind = TREE_object, .span = given ? given->value->span : document->span};
    tree_set_members(r->session, materials, r->materials, r->material_count);
    if (r->material_count || given)
        members[count++] =
            (Member){"materials", given && !r->material_count ? given->value : materials,
                     given ? given->span : document->span, sizeof "materials" - 1};
    tree_set_members(r->session, tree, members, count);
    return tree;
}

void scene_material_resolve(SceneReader *r, const Tree *document)
{
    Tree *tree = only_materials(r, document);
    if (!tree->count)
        return; /* the scene has no materials */
    document_resolve(r->document, tree);
    r->fine &= r->document->graph != NULL;
}
