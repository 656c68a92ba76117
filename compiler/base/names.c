/* A hash index over a growing list. Hashes are seeded with an address, so that a document's
 * author cannot choose names that collide. */
#include "compiler/base/names.h"
#include "compiler/base/text.h"
#include <string.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

static uint32_t hash_of(const Names *names, const char *name)
{
    return (uint32_t)XXH3_64bits_withSeed(name, strlen(name), names->seed);
}

static int find(const Names *names, const char *name, uint32_t hash)
{
    for (HashProbe probe = hash_probe(&names->index, hash); hash_probe_next(&probe);)
        if (!strcmp(names->at[probe.number], name))
            return (int)probe.number;
    return -1;
}

int names_find(const Names *names, const char *name)
{
    return names->count ? find(names, name, hash_of(names, name)) : -1;
}

int names_add(Arena *arena, Names *names, const char *name)
{
    if (!names->count)
        names->seed = (uintptr_t)arena_alloc(arena, 1);
    const uint32_t hash = hash_of(names, name);
    const int found = find(names, name, hash);
    if (found >= 0)
        return found;
    hash_index_add(arena, &names->index, hash, (uint32_t)names->count);
    ARENA_PUSH(arena, names->at, names->count, names->capacity, name);
    return (int)names->count - 1;
}

static int give(Arena *arena, FreshNames *fresh, const char *name)
{
    const int first = 1;
    ARENA_PUSH(arena, fresh->last, fresh->last_count, fresh->last_capacity, first);
    return names_add(arena, &fresh->given, name);
}

static const char *numbered(Arena *arena, const char *name, int number)
{
    Text text = text_new(arena);
    text_put(&text, name);
    if (text_is_digit(name[strlen(name) - 1]))
        text_char(&text, '_');
    text_int(&text, number);
    return text.at;
}

const char *names_fresh(Arena *arena, FreshNames *fresh, const char *wanted)
{
    const int known = names_find(&fresh->given, wanted);
    const char *name = wanted;
    while (known >= 0 && names_find(&fresh->given, name) >= 0)
        name = numbered(arena, wanted, ++fresh->last[known]);
    give(arena, fresh, name);
    return name;
}
