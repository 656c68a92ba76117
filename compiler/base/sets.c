/* String and key sets: hash indices over growing arrays. */
#include "compiler/base/sets.h"
#include "compiler/base/memory.h"
#include <stdlib.h>
#include <string.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

enum { FIRST_CAPACITY = 64 };

void *sets_resize(void *memory, size_t size)
{
    void *more = realloc(memory, size ? size : 1);
    if (!more)
        memory_exhausted();
    return more;
}

char *sets_copy(const char *text)
{
    size_t size = strlen(text) + 1;
    return memcpy(sets_resize(NULL, size), text, size);
}

static uint32_t string_hash(const char *string)
{
    return (uint32_t)XXH3_64bits(string, strlen(string));
}
static uint32_t key_hash(Key key) { return (uint32_t)key.low; }

/* Returns a capacity greater than `capacity`. */
static int more_capacity(int capacity) { return capacity ? 2 * capacity : FIRST_CAPACITY; }

int string_set_find(const StringSet *set, const char *string)
{
    for (HashProbe probe = hash_probe(&set->index, string_hash(string)); hash_probe_next(&probe);)
        if (!strcmp(set->at[probe.number], string))
            return (int)probe.number;
    return -1;
}

int string_set_add(StringSet *set, const char *string, bool *added)
{
    const int found = string_set_find(set, string);
    if (added)
        *added = found < 0;
    if (found >= 0)
        return found;
    if (set->count == set->capacity)
        set->at = sets_resize(set->at, (size_t)(set->capacity = more_capacity(set->capacity)) *
                                           sizeof *set->at);
    hash_index_add(NULL, &set->index, string_hash(string), (uint32_t)set->count);
    set->at[set->count] = sets_copy(string);
    return set->count++;
}

void string_set_free(StringSet *set)
{
    for (int i = 0; i < set->count; i++)
        free(set->at[i]);
    free(set->at);
    hash_index_free(&set->index);
    *set = (StringSet){0};
}

int key_set_find(const KeySet *set, Key key)
{
    for (HashProbe probe = hash_probe(&set->index, key_hash(key)); hash_probe_next(&probe);)
        if (key_equal(set->at[probe.number], key))
            return (int)probe.number;
    return -1;
}

int key_set_add(KeySet *set, Key key, bool *added)
{
    const int found = key_set_find(set, key);
    if (added)
        *added = found < 0;
    if (found >= 0)
        return found;
    if (set->count == set->capacity)
        set->at = sets_resize(set->at, (size_t)(set->capacity = more_capacity(set->capacity)) *
                                           sizeof *set->at);
    hash_index_add(NULL, &set->index, key_hash(key), (uint32_t)set->count);
    set->at[set->count] = key;
    return set->count++;
}

void key_set_free(KeySet *set)
{
    free(set->at);
    hash_index_free(&set->index);
    *set = (KeySet){0};
}
