/* Hash table from hashes to the numbers of elements stored elsewhere: the compiler's only
 * general open-addressing table. A slot holds hash and number. The table can therefore grow
 * without recomputing hashes, and an element is rarely compared unless it is the wanted one.
 *
 *     8 slots; "a" has the hash 5, "b" and "c" have 13: all belong in slot 13 & 7 = 5
 *     5: {5, "a"}   6: {13, "b"}   7: {13, "c"}
 *     a probe for 13 begins at 5, skips "a" (another hash), compares "b", then "c", and
 *         ends at 0, which is free
 *
 * Three hash tables have their own layout, with the reason in their files: the nodes of an IR
 * (ir.c), the memo of lowering (lower.c), the keys of a tree (tree.c). */
#ifndef MATC_HASH_INDEX_H
#define MATC_HASH_INDEX_H
#include "compiler/base/arena.h"
#include <stdbool.h>
#include <stdint.h>

typedef struct {
    uint32_t hash, number; /* `number` counts from 1; 0: the slot is free */
} HashSlot;

/* Zero-initialized: an empty index. */
typedef struct {
    HashSlot *slots;
    uint32_t mask; /* number of slots less 1; a power of two of slots, at most half of them used */
    uint32_t count;
} HashIndex;

/* Adds a number, without a search for an equal entry. Memory comes from the arena; with a NULL
 * arena from malloc, until hash_index_free(). */
void hash_index_add(Arena *arena, HashIndex *index, uint32_t hash, uint32_t number);
/* Returns a copy with the same entries. Later additions to either index do not affect the other. */
HashIndex hash_index_copy(Arena *arena, const HashIndex *index);
void hash_index_free(HashIndex *index);

/* Iterates over the numbers with a given hash: while (hash_probe_next(&probe)) compare element
 * probe.number. */
typedef struct {
    const HashIndex *index;
    uint32_t hash, at, number;
} HashProbe;

static inline HashProbe hash_probe(const HashIndex *index, uint32_t hash)
{
    return (HashProbe){index, hash, hash & index->mask, 0};
}

static inline bool hash_probe_next(HashProbe *probe)
{
    const HashIndex *index = probe->index;
    while (index->slots && index->slots[probe->at].number) {
        const HashSlot slot = index->slots[probe->at];
        probe->at = (probe->at + 1) & index->mask;
        probe->number = slot.number - 1;
        if (slot.hash == probe->hash)
            return true;
    }
    return false;
}

/* Hashes an address. The multiplication mixes its bits, since the lowest bits are always zero. */
static inline uint32_t hash_pointer(const void *pointer)
{
    return (uint32_t)((uintptr_t)pointer * 0x9E3779B97F4A7C15u >> 32);
}
#endif
