/* Questions about a Tree, and its text form. */
#include "tree.h"
#include <string.h>

bool tree_is_null(const Tree *tree)
{
    return tree->kind == TREE_scalar && tree->plain &&
           (!tree->count || !strcmp(tree->text, "~") || !strcmp(tree->text, "null"));
}

bool tree_number(const Tree *tree, double *value)
{
    return tree->kind == TREE_scalar && tree->plain && text_number(tree->text, tree->count, value);
}

const char *tree_describe(Compile *c, const Tree *tree)
{
    double number;
    Text text = text_new(c->arena);
    if (tree->kind == TREE_list)
        return "a list";
    if (tree->kind == TREE_object)
        return "an object";
    if (tree_is_null(tree))
        return "nothing";
    if (tree_number(tree, &number))
        text_format(&text, "the number %s", tree->text);
    else
        text_format(&text, "'%.*s'", LIMIT_NAME, tree->text);
    return text.at;
}

enum { LARGE_OBJECT = 16 }; /* members from which on a hash table pays */

uint32_t tree_hash(const char *key)
{
    uint32_t hash = 2166136261u;
    for (; *key; key++)
        hash = (hash ^ (unsigned char)*key) * 16777619u;
    return hash ^ hash >> 15;
}

void tree_index(Compile *c, Tree *object)
{
    if (object->count <= LARGE_OBJECT)
        return;
    uint32_t size = 64;
    while (size < 2 * object->count)
        size *= 2;
    object->table = ARENA_ARRAY(c->arena, uint32_t, size);
    object->mask = size - 1;
    for (uint32_t i = 0; i < object->count; i++) {
        uint32_t at = tree_hash(object->members[i].key) & object->mask;
        while (object->table[at] && strcmp(object->members[object->table[at] - 1].key, object->members[i].key) != 0)
            at = (at + 1) & object->mask;
        if (!object->table[at])
            object->table[at] = i + 1;
    }
}

const Member *tree_find(const Tree *object, const char *key)
{
    if (object->kind != TREE_object)
        return NULL;
    if (object->table) {
        uint32_t at = tree_hash(key) & object->mask;
        while (object->table[at] && strcmp(object->members[object->table[at] - 1].key, key) != 0)
            at = (at + 1) & object->mask;
        return object->table[at] ? &object->members[object->table[at] - 1] : NULL;
    }
    for (uint32_t i = 0; i < object->count; i++)
        if (*object->members[i].key == *key &&
            !strcmp(object->members[i].key, key)) /* most differ in the first letter */
            return &object->members[i];
    return NULL;
}

static void indent(Text *out, int depth)
{
    text_char(out, '\n');
    for (int i = 0; i < depth; i++)
        text_put(out, "  ");
}

static bool print_shared(Text *out, Tree *tree)
{
    if (!tree->shared)
        return false;
    text_format(out, "%cat%u ", tree->printed ? '*' : '&', tree->span.start);
    bool again = tree->printed;
    tree->printed = true;
    return again;
}

static void print(Text *out, Tree *tree, int depth)
{
    if (print_shared(out, tree))
        return;
    if (tree->kind == TREE_scalar) {
        if (tree->plain)
            text_put(out, tree->text);
        else
            text_json(out, tree->text, tree->count);
        return;
    }
    if (!tree->count) {
        text_put(out, tree->kind == TREE_list ? "[]" : "{}");
        return;
    }
    for (uint32_t i = 0; i < tree->count; i++) {
        indent(out, depth);
        if (tree->kind == TREE_list)
            text_put(out, "- ");
        else
            text_format(out, "%s: ", tree->members[i].key);
        print(out, tree->kind == TREE_list ? tree->items[i] : tree->members[i].value, depth + 1);
    }
}

void tree_print(Text *out, Tree *tree)
{
    Text body = text_new(out->arena);
    print(&body, tree, 0);
    if (body.size)
        text_put(out, body.at[0] == '\n' ? body.at + 1 : body.at);
    text_char(out, '\n');
}
