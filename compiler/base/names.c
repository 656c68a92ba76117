/* Open addressing over a growing list. The table's own address goes into the hash: whoever writes a document cannot choose
 * names that fall on one another. */
#include "compiler/base/names.h"
#include <string.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

enum { FIRST_TABLE = 64 };

/* Where the name is, or belongs. */
static uint32_t *place_of(const Names *names, const char *name)
{
    uint32_t at = (uint32_t)XXH3_64bits_withSeed(name, strlen(name), (uintptr_t)names->table) & names->mask;
    while (names->table[at] && strcmp(names->at[names->table[at] - 1], name) != 0)
        at = (at + 1) & names->mask;
    return &names->table[at];
}

int names_find(const Names *names, const char *name) { return names->table ? (int)*place_of(names, name) - 1 : -1; }

static void grow(Arena *arena, Names *names)
{
    names->mask = names->table ? 2 * names->mask + 1 : FIRST_TABLE - 1;
    names->table = ARENA_ARRAY(arena, uint32_t, names->mask + 1);
    for (size_t i = 0; i < names->count; i++)
        *place_of(names, names->at[i]) = (uint32_t)i + 1;
}

int names_add(Arena *arena, Names *names, const char *name)
{
    if (2 * names->count >= names->mask)
        grow(arena, names);
    uint32_t *place = place_of(names, name);
    if (!*place) {
        ARENA_PUSH(arena, names->at, names->count, names->room, name);
        *place = (uint32_t)names->count;
    }
    return (int)*place - 1;
}
