/* Walks over the JSON of a glTF file once, guided by the table of known members:
 *
 *     { "materials": [{ "gloss": 1 }, { "gloss": 1 }] }
 *     root -> materials: list of `material` -> gloss: no row, reported for the first material only
 *
 * Each member is visited once, and the walk is only as deep as the table, so that its time is
 * linear in the size of the file. */
#include "compiler/read/gltf_unread.h"
#include "compiler/base/names.h"
#include <math.h>
#include <string.h>

typedef struct {
    GltfObject object;
    const char *name;
    GltfObject content;
} Row;

static const Row members[] = {
#define GLTF_MEMBER(object, member, content) {GLTF_##object, #member, GLTF_##content},
#include "grammar/gltf.def"
};
static const Row extensions[] = {
#define GLTF_EXTENSION(object, extension, content) {GLTF_##object, #extension, GLTF_##content},
#include "grammar/gltf.def"
};
enum {
    MEMBERS = sizeof members / sizeof *members,
    EXTENSIONS = sizeof extensions / sizeof *extensions
};

typedef struct {
    Session *session;
    Names reported; /* names of members and extensions */
} Walk;

static GltfObject find(const Row *rows, int count, GltfObject object, const char *name)
{
    for (int i = 0; i < count; i++)
        if (rows[i].object == object && !strcmp(rows[i].name, name))
            return rows[i].content;
    return GLTF_NONE;
}

GltfObject gltf_unread_member(GltfObject object, const char *member)
{
    return find(members, MEMBERS, object, member);
}

GltfObject gltf_unread_extension(GltfObject object, const char *extension)
{
    return find(extensions, EXTENSIONS, object, extension);
}

static void report(Walk *w, const Member *member)
{
    const size_t known = w->reported.count;
    if ((size_t)names_add(w->session->arena, &w->reported, member->key) == known)
        diag_add(w->session, member->span, DIAG_gltf_unread, member->key);
}

static void walk(Walk *w, const Tree *tree, GltfObject object);

static void walk_extensions(Walk *w, const Tree *tree, GltfObject object)
{
    for (uint32_t i = 0; tree->kind == TREE_object && i < tree->count; i++) {
        const GltfObject content = gltf_unread_extension(object, tree->members[i].key);
        if (content == GLTF_NONE)
            report(w, &tree->members[i]);
        else
            walk(w, tree->members[i].value, content);
    }
}

static bool is_offset(const Tree *tree)
{
    double value;
    return tree->kind == TREE_scalar && tree_number(tree, &value) && value >= 0 &&
           value == floor(value);
}

static void walk_member(Walk *w, const Member *member, GltfObject object)
{
    const GltfObject content = gltf_unread_member(object, member->key);
    if (!strcmp(member->key, "extensions"))
        walk_extensions(w, member->value, object);
    else if (!strcmp(member->key, "byteOffset") && !is_offset(member->value))
        diag_add(w->session, member->value->span, DIAG_gltf_offset,
                 tree_describe(w->session, member->value));
    else if (content != GLTF_NONE)
        walk(w, member->value, content);
    else if (strcmp(member->key, "name") != 0 && strcmp(member->key, "extras") != 0)
        report(w, member);
}

/* Walks an object, or a list of objects. */
static void walk(Walk *w, const Tree *tree, GltfObject object)
{
    if (object == GLTF_leaf)
        return;
    if (tree->kind == TREE_list)
        for (uint32_t i = 0; i < tree->count; i++)
            if (tree->items[i]->kind == TREE_object)
                walk(w, tree->items[i], object);
    for (uint32_t i = 0; tree->kind == TREE_object && i < tree->count; i++)
        walk_member(w, &tree->members[i], object);
}

static bool is_known(const char *extension)
{
    for (int i = 0; i < EXTENSIONS; i++)
        if (!strcmp(extensions[i].name, extension))
            return true;
    return false;
}

void gltf_unread_report(Session *session, const Tree *root)
{
    Walk w = {.session = session};
    const Member *required = tree_find(root, "extensionsRequired");
    const Tree *list = required ? required->value : NULL;
    walk(&w, root, GLTF_root);
    for (uint32_t i = 0; list && list->kind == TREE_list && i < list->count; i++)
        if (list->items[i]->kind == TREE_scalar && !is_known(list->items[i]->text))
            diag_add(session, list->items[i]->span, DIAG_gltf_required, list->items[i]->text);
}
