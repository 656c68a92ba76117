/* Open-addressing tables over growing arrays. */
#include "compiler/base/sets.h"
#include <stdlib.h>
#include <string.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

enum { FIRST_ROOM = 64 }; /* a power of two; a table is twice as long */

void *sets_resize(void *memory, size_t size)
{
    void *more = realloc(memory, size ? size : 1);
    if (!more)
        abort();
    return more;
}

char *sets_copy(const char *text)
{
    size_t size = strlen(text) + 1;
    return memcpy(sets_resize(NULL, size), text, size);
}

static uint32_t string_hash(const char *string) { return (uint32_t)XXH3_64bits(string, strlen(string)); }
static uint32_t key_hash(Key key) { return (uint32_t)key.low; }

/* The place of the string, or the free one where it belongs. */
static uint32_t string_place(const StringSet *set, const char *string)
{
    uint32_t at = string_hash(string) & set->mask;
    while (set->table[at] && strcmp(set->at[set->table[at] - 1], string) != 0)
        at = (at + 1) & set->mask;
    return at;
}

static uint32_t key_place(const KeySet *set, Key key)
{
    uint32_t at = key_hash(key) & set->mask;
    while (set->table[at] && !key_equal(set->at[set->table[at] - 1], key))
        at = (at + 1) & set->mask;
    return at;
}

/* A table for twice as many, empty. */
static int *new_table(int *old, int *room, uint32_t *mask)
{
    *room = *room ? 2 * *room : FIRST_ROOM;
    *mask = 2 * (uint32_t)*room - 1;
    free(old);
    return memset(sets_resize(NULL, (*mask + 1) * sizeof *old), 0, (*mask + 1) * sizeof *old);
}

int string_set_add(StringSet *set, const char *string, bool *added)
{
    if (set->count == set->room) {
        set->table = new_table(set->table, &set->room, &set->mask);
        set->at = sets_resize(set->at, (size_t)set->room * sizeof *set->at);
        for (int i = 0; i < set->count; i++)
            set->table[string_place(set, set->at[i])] = i + 1;
    }
    uint32_t at = string_place(set, string);
    if (added)
        *added = !set->table[at];
    if (!set->table[at]) {
        set->at[set->count++] = sets_copy(string);
        set->table[at] = set->count;
    }
    return set->table[at] - 1;
}

int string_set_find(const StringSet *set, const char *string)
{
    return set->count ? set->table[string_place(set, string)] - 1 : -1;
}

void string_set_free(StringSet *set)
{
    for (int i = 0; i < set->count; i++)
        free(set->at[i]);
    free(set->at);
    free(set->table);
    *set = (StringSet){0};
}

int key_set_add(KeySet *set, Key key, bool *added)
{
    if (set->count == set->room) {
        set->table = new_table(set->table, &set->room, &set->mask);
        set->at = sets_resize(set->at, (size_t)set->room * sizeof *set->at);
        for (int i = 0; i < set->count; i++)
            set->table[key_place(set, set->at[i])] = i + 1;
    }
    uint32_t at = key_place(set, key);
    if (added)
        *added = !set->table[at];
    if (!set->table[at]) {
        set->at[set->count++] = key;
        set->table[at] = set->count;
    }
    return set->table[at] - 1;
}

int key_set_find(const KeySet *set, Key key) { return set->count ? set->table[key_place(set, key)] - 1 : -1; }

void key_set_free(KeySet *set)
{
    free(set->at);
    free(set->table);
    *set = (KeySet){0};
}
