/* Open addressing with linear probing: an entry is in the slot of its hash, or in the first slot
 * after it that was free. */
#include "compiler/base/hash_index.h"
#include "compiler/base/memory.h"
#include <stdlib.h>

enum { FIRST_SLOTS = 64 };

static HashSlot *new_slots(Arena *arena, size_t count)
{
    HashSlot *slots = arena ? ARENA_ARRAY(arena, HashSlot, count) : calloc(count, sizeof *slots);
    if (!slots)
        memory_exhausted();
    return slots;
}

static void put(HashIndex *index, HashSlot slot)
{
    uint32_t at = slot.hash & index->mask;
    while (index->slots[at].number)
        at = (at + 1) & index->mask;
    index->slots[at] = slot;
}

static void grow(Arena *arena, HashIndex *index)
{
    const HashIndex old = *index;
    const size_t count = old.slots ? 2 * ((size_t)old.mask + 1) : FIRST_SLOTS;
    index->slots = new_slots(arena, count);
    index->mask = (uint32_t)count - 1;
    for (size_t i = 0; old.slots && i <= old.mask; i++)
        if (old.slots[i].number)
            put(index, old.slots[i]);
    if (!arena)
        free(old.slots);
}

void hash_index_add(Arena *arena, HashIndex *index, uint32_t hash, uint32_t number)
{
    if (2 * index->count >= index->mask)
        grow(arena, index);
    put(index, (HashSlot){hash, number + 1});
    index->count++;
}

HashIndex hash_index_copy(Arena *arena, const HashIndex *index)
{
    HashIndex copy = *index;
    if (index->slots)
        copy.slots = arena_copy(arena, index->slots, index->mask + (size_t)1,
                                index->mask + (size_t)1, sizeof *index->slots);
    return copy;
}

void hash_index_free(HashIndex *index)
{
    free(index->slots);
    *index = (HashIndex){0};
}
