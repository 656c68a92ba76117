/* Numbers of things that stand elsewhere, found by their hashes: the one open-addressing table of
 * the compiler. Its slots hold hash and number, so that it grows without asking for a hash again,
 * and so that hardly any but the wanted thing is compared.
 *
 *     slots of 8, "a" having the hash 5, "b" and "c" having 13: both belong into slot 5, as 13 & 7
 *         is 5
 *     5: {5, "a"}   6: {13, "b"}   7: {13, "c"}
 *     a probe for 13 begins at 5, passes "a", whose hash is another, meets "b", then "c", and ends
 *         at 0, which is free
 *
 * Three tables have a form of their own, and say why: the nodes of an IR (ir.c), the memo of
 * lowering (lower.c), a tree's keys (tree.c). */
#ifndef MATC_HASH_INDEX_H
#define MATC_HASH_INDEX_H
#include "compiler/base/arena.h"
#include <stdbool.h>
#include <stdint.h>

typedef struct {
    uint32_t hash, number; /* the number from 1; 0: the slot is free */
} HashSlot;

/* All zero: nothing is in it. */
typedef struct {
    HashSlot *slots;
    uint32_t mask; /* slots less one; they are a power of two, and at most half of them are taken */
    uint32_t count;
} HashIndex;

/* Adds a number, whatever is there already. Memory is the arena's; NULL: malloc's, until
 * hash_index_free. */
void hash_index_add(Arena *arena, HashIndex *index, uint32_t hash, uint32_t number);
/* A copy with the same entries; later additions to one do not show in the other. */
HashIndex hash_index_copy(Arena *arena, const HashIndex *index);
void hash_index_free(HashIndex *index);

/* A walk over the numbers that have a hash: while (hash_probe_next(&probe)) compare what has
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

/* Hash of an address, whose lowest bits are always zero. */
static inline uint32_t hash_pointer(const void *pointer)
{
    return (uint32_t)((uintptr_t)pointer * 0x9E3779B97F4A7C15u >> 32);
}
#endif
