/* Objects of the document's `defs:`, which Instances name. They are listed with maps and
 * materials, and have the key `object`. */
#include "runtime/scene_reader/scene_part.h"
#include <string.h>

static bool is_object(const Tree *tree)
{
    return tree->kind == TREE_object && tree_find(tree, "object");
}

static const char *definition_name(const void *user, int i)
{
    return ((const Tree *)user)->members[i].key;
}

void scene_definition_open(SceneReader *r, const Tree *document)
{
    const Member *defs = tree_find(document, "defs");
    if (!defs || defs->value->kind != TREE_object)
        return; /* a wrong type is reported with the materials */
    r->definitions = defs->value;
    r->instanced = ARENA_ARRAY(r->session->arena, bool, defs->value->count + 1);
}

Tree *scene_definition_find(SceneReader *r, const Tree *name)
{
    static const Tree none = {.kind = TREE_object};
    const Tree *all = r->definitions ? r->definitions : &none;
    const Member *found = name->kind == TREE_scalar ? tree_find(all, name->text) : NULL;
    if (found && is_object(found->value)) {
        r->instanced[found - all->members] = true;
        return found->value;
    }
    if (found || name->kind != TREE_scalar)
        diag_add(r->session, name->span, DIAG_wrong_type, "of",
                 "the name of an object under `defs:`",
                 found ? "a map or a material" : tree_describe(r->session, name));
    else
        diag_add(r->session, name->span, DIAG_unknown_ref, name->text,
                 diag_suggest(r->session, name->text, definition_name, all, (int)all->count));
    r->fine = false;
    return NULL;
}

Tree *scene_definition_unused(const SceneReader *r, uint32_t i)
{
    Tree *tree = r->definitions->members[i].value;
    return is_object(tree) && !r->instanced[i] ? tree : NULL;
}

Tree *scene_definition_others(SceneReader *r, Tree *defs)
{
    if (defs->kind != TREE_object)
        return defs;
    Tree *others = ARENA_NEW(r->session->arena, Tree);
    Member *members = ARENA_ARRAY(r->session->arena, Member, defs->count + 1);
    size_t count = 0;
    for (uint32_t i = 0; i < defs->count; i++)
        if (!is_object(defs->members[i].value))
            members[count++] = defs->members[i];
    *others = (Tree){.kind = TREE_object, .span = defs->span};
    tree_set_members(r->session, others, members, count);
    return others;
}
