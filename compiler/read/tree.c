/* Queries of a Tree, and its text form. */
#include "compiler/read/tree.h"
#include "compiler/base/hash.h"
#include "compiler/base/json_write.h"
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

const char *tree_describe(Session *session, const Tree *tree)
{
    double number;
    Text text = text_new(session->arena);
    if (tree->kind == TREE_list)
        return "a list";
    if (tree->kind == TREE_object)
        return "an object";
    if (tree_is_null(tree))
        return "nothing";
    if (diag_full(session))
        return "something";
    text_format(&text, tree_number(tree, &number) ? "the number %.*s" : "'%.*s'", LIMIT_NAME,
                tree->text);
    return text.at;
}

enum { LARGE_OBJECT = 16 }; /* min number of members for a hash table */

uint32_t tree_hash(const char *key, size_t size) { return (uint32_t)key_of_bytes(key, size).low; }

static bool has_key(const Member *member, const char *key, size_t size)
{
    return member->size == size && !memcmp(member->key, key, size);
}

/* Returns a power of two that leaves at least half of the table empty. */
static uint32_t table_size(uint32_t count)
{
    uint32_t size = 64;
    while (size < 2 * count)
        size *= 2;
    return size;
}

/* Returns the hash table entry of a key: the number of the first member with the key, from 1, or
 * 0. The table follows the members in the same allocation and never grows. */
static uint32_t *table_entry(const Tree *object, const char *key, size_t size)
{
    uint32_t *table = (uint32_t *)(object->members + object->count),
             mask = table_size(object->count) - 1;
    uint32_t at = tree_hash(key, size) & mask;
    while (table[at] && !has_key(&object->members[table[at] - 1], key, size))
        at = (at + 1) & mask;
    return &table[at];
}

void tree_set_members(Session *session, Tree *object, const Member *members, size_t count)
{
    const size_t size = count * sizeof *members;
    const size_t table = count > LARGE_OBJECT ? table_size((uint32_t)count) * sizeof(uint32_t) : 0;
    object->count = (uint32_t)count;
    if (!count)
        return;
    object->members = arena_alloc(session->arena, size + table);
    memcpy(object->members, members, size);
    memset(object->members + count, 0, table);
    for (uint32_t i = 0; table && i < count; i++) {
        uint32_t *entry = table_entry(object, members[i].key, members[i].size);
        if (!*entry)
            *entry = i + 1;
    }
}

const Member *tree_find_bytes(const Tree *object, const char *key, size_t size)
{
    if (object->kind != TREE_object)
        return NULL;
    if (object->count > LARGE_OBJECT) {
        uint32_t found = *table_entry(object, key, size);
        return found ? &object->members[found - 1] : NULL;
    }
    for (uint32_t i = 0; i < object->count; i++)
        if (has_key(&object->members[i], key, size))
            return &object->members[i];
    return NULL;
}

const Member *tree_find(const Tree *object, const char *key)
{
    return tree_find_bytes(object, key, strlen(key));
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
            json_bytes(out, tree->text, tree->count);
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
