/* Lists that hold maps: the items of a Blend, and plain lists of maps. A list is resolved once,
 * even if it is shared by aliases. */
#include "compiler/hints/common_error.h"
#include "compiler/resolve/resolve.h"
#include <string.h>

static const char *item_key(const void *user, int i)
{
    (void)user;
    return i ? "input" : "value";
}

/* Resolves an item: { value: number, input: map } */
static bool resolve_item(Resolver *r, Tree *tree, Item *item)
{
    *item = (Item){.span = tree->span};
    item->value = (Value){.kind = VALUE_number, .type = TYPE_float};
    if (tree->kind != TREE_object) {
        diag_add(r->session, tree->span, DIAG_wrong_type, "an item",
                 "`{ value: number, input: map }`", tree_describe(r->session, tree));
        return false;
    }
    bool fine = true, fault = false;
    for (uint32_t i = 0; i < tree->count; i++) {
        const Member *member = &tree->members[i];
        if (!strcmp(member->key, "value")) {
            fine &= resolve_number(r, "value", member->value, (ComponentCount){1, 1}, &item->value);
        } else if (!strcmp(member->key, "input")) {
            item->input = resolve_map(r, member->value, &fault);
        } else {
            if (!common_error_key(r->session, member->span, member->key))
                diag_add(r->session, member->span, DIAG_item_keys, member->key,
                         diag_suggest(r->session, member->key, item_key, NULL, 2));
            fine = false;
        }
    }
    return fine && !fault;
}

bool resolve_items(Resolver *r, Tree *tree, Value *value)
{
    if (tree->kind != TREE_list) {
        diag_add(r->session, tree->span, DIAG_wrong_type, "blend",
                 "a list of items, `[{ value: 0, input: black }, { value: 1, input: white }]`",
                 tree_describe(r->session, tree));
        return false;
    }
    if (tree->made == MADE_items) {
        *value = (Value){.kind = VALUE_items, .items = tree->items_made};
        return true;
    }
    Item *item = ARENA_ARRAY(r->session->arena, Item, tree->count);
    Items *items = ARENA_NEW(r->session->arena, Items);
    *items = (Items){(int)tree->count, item};
    bool fine = true;
    const Item *descends = NULL;
    for (uint32_t i = 0; i < tree->count; i++) {
        fine &= resolve_item(r, tree->items[i], &item[i]);
        if (fine && i && item[i].value.kind == VALUE_number &&
            item[i - 1].value.kind == VALUE_number)
            if (!descends && item[i].value.number[0] < item[i - 1].value.number[0])
                descends = &item[i];
    }
    if (descends)
        diag_add(r->session, descends->span, DIAG_unordered_items);
    *value = (Value){.kind = VALUE_items, .items = items};
    if (fine) {
        tree->items_made = items;
        tree->made = MADE_items;
    }
    return fine;
}

/* Gives the maps of a list the values 0, 1, 2, ... */
bool resolve_map_list(Resolver *r, const char *name, Tree *tree, Value *value)
{
    if (tree->kind != TREE_list) {
        diag_add(r->session, tree->span, DIAG_wrong_type, name, "a list of maps, `[black, white]`",
                 tree_describe(r->session, tree));
        return false;
    }
    if (tree->made != MADE_list) {
        bool fault = false;
        Item *item = ARENA_ARRAY(r->session->arena, Item, tree->count);
        Items *items = ARENA_NEW(r->session->arena, Items);
        for (uint32_t i = 0; i < tree->count; i++) {
            Tree *map = tree->items[i];
            item[i] = (Item){.span = map->span,
                             .value = {.kind = VALUE_number, .type = TYPE_float, .number = {i}}};
            item[i].input = resolve_map(r, map, &fault);
        }
        if (fault)
            return false;
        *items = (Items){(int)tree->count, item};
        tree->items_made = items;
        tree->made = MADE_list;
    }
    *value = (Value){.kind = VALUE_items, .items = tree->items_made};
    return true;
}
