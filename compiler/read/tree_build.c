/* Builds a Tree: values, texts, lists and objects in the order in which the YAML and JSON
 * parsers find them. */
#include "compiler/read/tree_build.h"
#include "compiler/base/memory.h"
#include <stdlib.h>
#include <string.h>

enum { VALUES_CAPACITY = 16, TEXT_CAPACITY = 1024, LONG_TEXT = 128 };

Tree *tree_build_value(TreeBuilder *b, TreeKind kind, Span span)
{
    if (++b->values > LIMIT_TREE_NODES)
        return diag_add(b->session, span, DIAG_too_many, LIMIT_TREE_NODES);
    if (!b->values_left_count) {
        b->values_left = ARENA_ARRAY(b->session->arena, Tree, VALUES_CAPACITY);
        b->values_left_count = VALUES_CAPACITY;
    }
    b->values_left_count--;
    Tree *tree = b->values_left++;
    tree->kind = (uint8_t)kind;
    tree->span = span;
    return tree;
}

char *tree_build_text(TreeBuilder *b, size_t size)
{
    if (size >= LONG_TEXT)
        return arena_zero(b->session->arena, size + 1);
    if ((size_t)(b->text_end - b->text) < size + 1) {
        b->text = arena_alloc(b->session->arena, TEXT_CAPACITY);
        b->text_end = b->text + TEXT_CAPACITY;
    }
    char *text = b->text;
    b->text += size + 1;
    text[size] = 0;
    return text;
}

void tree_build_check_text(TreeBuilder *b, const char *text, size_t size, Span span)
{
    if (!b->zero.end && memchr(text, 0, size))
        b->zero = span;
}

/* Stacks use malloc; an arena would retain every size a stack has had. */
void *tree_build_capacity(void *stack, size_t count, size_t *capacity, size_t size)
{
    if (count < *capacity)
        return stack;
    *capacity = *capacity ? 2 * *capacity : 64;
    stack = realloc(stack, *capacity * size);
    if (!stack)
        memory_exhausted();
    return stack;
}

void tree_build_item(TreeBuilder *b, Tree *item)
{
    b->items = tree_build_capacity(b->items, b->item_count, &b->item_capacity, sizeof *b->items);
    b->items[b->item_count++] = item;
}

void tree_build_member(TreeBuilder *b, Member member)
{
    b->members =
        tree_build_capacity(b->members, b->member_count, &b->member_capacity, sizeof *b->members);
    b->members[b->member_count++] = member;
}

void tree_build_list(TreeBuilder *b, Tree *list, size_t from)
{
    const size_t size = (b->item_count - from) * sizeof *list->items;
    list->count = (uint32_t)(b->item_count - from);
    list->items = size ? memcpy(arena_alloc(b->session->arena, size), b->items + from, size) : NULL;
    b->item_count = from;
}

/* tree_find() returns the first member of a key, so any other member with that key is a
 * duplicate. */
static void check_duplicates(TreeBuilder *b, const Tree *object)
{
    for (uint32_t i = 0; i < object->count; i++) {
        const Member *member = &object->members[i],
                     *first = tree_find_bytes(object, member->key, member->size);
        if (first == member)
            continue;
        diag_add(b->session, member->span, DIAG_duplicate_key, member->key);
        diag_add(b->session, first->span, DIAG_first_given);
    }
}

static void set_members(TreeBuilder *b, Tree *object, size_t from)
{
    const size_t count = b->member_count - from;
    tree_set_members(b->session, object, count ? b->members + from : NULL, count);
    b->member_count = from;
}

void tree_build_object(TreeBuilder *b, Tree *object, size_t from)
{
    set_members(b, object, from);
    check_duplicates(b, object);
}

/* Keeps the first of members with equal keys. */
static void drop_later(TreeBuilder *b, Tree *object, uint32_t own, size_t from)
{
    for (uint32_t i = 0; i < object->count; i++) {
        const Member *member = &object->members[i];
        if (i < own || tree_find_bytes(object, member->key, member->size) == member)
            tree_build_member(b, *member);
    }
    if (b->member_count - from < object->count)
        set_members(b, object, from);
    b->member_count = from;
}

bool tree_build_merge(TreeBuilder *b, Tree *object, Tree *const *bases, size_t count)
{
    const uint32_t own = object->count;
    const size_t from = b->member_count;
    for (uint32_t i = 0; i < own; i++)
        tree_build_member(b, object->members[i]);
    for (size_t k = 0; k < count; k++) {
        if (bases[k]->kind != TREE_object)
            return diag_add(b->session, bases[k]->span, DIAG_bad_merge,
                            tree_describe(b->session, bases[k]));
        b->values += (int)bases[k]->count; /* merging copies members */
        if (b->values > LIMIT_TREE_NODES)
            return diag_add(b->session, object->span, DIAG_too_many, LIMIT_TREE_NODES);
        for (uint32_t i = 0; i < bases[k]->count; i++)
            if (!tree_find_bytes(object, bases[k]->members[i].key, bases[k]->members[i].size))
                tree_build_member(b, bases[k]->members[i]);
    }
    set_members(b, object, from);
    drop_later(b, object, own, from);
    return true;
}

void tree_build_done(TreeBuilder *b)
{
    free(b->items);
    free(b->members);
}
