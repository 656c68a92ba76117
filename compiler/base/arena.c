/* Bump allocation in blocks that double in size. */
#include "compiler/base/arena.h"
#include "compiler/base/memory.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

enum { FIRST_BLOCK = 16 * 1024, LARGEST_BLOCK = 4 * 1024 * 1024, ALIGNMENT = 16 };

struct ArenaBlock {
    ArenaBlock *older;
    size_t size;
};

static size_t aligned(size_t size) { return (size + ALIGNMENT - 1) & ~(size_t)(ALIGNMENT - 1); }

static void add_block(Arena *arena, size_t least)
{
    size_t size = arena->block ? arena->block->size * 2 : FIRST_BLOCK;
    if (size > LARGEST_BLOCK)
        size = LARGEST_BLOCK;
    if (size < least)
        size = least;
    if (size > SIZE_MAX - 2 * sizeof(ArenaBlock))
        memory_exhausted();
    ArenaBlock *block = malloc(aligned(sizeof *block) + size);
    if (!block)
        memory_exhausted();
    block->older = arena->block;
    block->size = size;
    arena->block = block;
    arena->next = (char *)block + aligned(sizeof *block);
    arena->end = arena->next + size;
}

void *arena_alloc(Arena *arena, size_t size)
{
    if (size > SIZE_MAX / 2)
        memory_exhausted();
    size = aligned(size ? size : 1);
    if ((size_t)(arena->end - arena->next) < size)
        add_block(arena, size);
    void *result = arena->next;
    arena->next += size;
    arena->used += size;
    return result;
}

void *arena_zero(Arena *arena, size_t size) { return memset(arena_alloc(arena, size), 0, size); }

char *arena_string(Arena *arena, const char *text, size_t size)
{
    char *copy = arena_alloc(arena, size + 1);
    if (size)
        memcpy(copy, text, size);
    copy[size] = 0;
    return copy;
}

void *arena_copy(Arena *arena, const void *array, size_t count, size_t capacity, size_t size)
{
    void *copy = arena_alloc(arena, capacity * size);
    if (count)
        memcpy(copy, array, count * size);
    return copy;
}

void *arena_extend(Arena *arena, void *old, size_t size, size_t kept, size_t wanted)
{
    const size_t more = aligned(wanted) - aligned(size);
    if (old && (char *)old + aligned(size) == arena->next &&
        (size_t)(arena->end - arena->next) >= more) {
        arena->next += more;
        arena->used += more;
        return old;
    }
    void *moved = arena_alloc(arena, wanted);
    if (old && kept)
        memcpy(moved, old, kept);
    return moved;
}

void *arena_grow(Arena *arena, void *array, size_t count, size_t *capacity, size_t size)
{
    if (count < *capacity)
        return array;
    const size_t before = *capacity;
    *capacity = before ? before * 2 : 8;
    return arena_extend(arena, array, before * size, count * size, *capacity * size);
}

void *arena_reach(Arena *arena, void *array, size_t index, size_t *capacity, size_t size)
{
    if (index < *capacity)
        return array;
    size_t wanted = 2 * index + 64;
    void *moved = arena_zero(arena, wanted * size);
    if (*capacity)
        memcpy(moved, array, *capacity * size);
    *capacity = wanted;
    return moved;
}

void arena_reset(Arena *arena)
{
    ArenaBlock *kept = arena->block;
    if (!kept)
        return;
    for (ArenaBlock *block = kept->older, *older; block; block = older) {
        older = block->older;
        free(block);
    }
    kept->older = NULL;
    arena->next = (char *)kept + aligned(sizeof *kept);
}

/* Inserts the blocks of `other` below the newest block of `arena`, which remains the current
 * block. */
void arena_adopt(Arena *arena, Arena *other)
{
    ArenaBlock *oldest = other->block;
    if (!arena->block) {
        *arena = *other;
    } else if (oldest) {
        while (oldest->older)
            oldest = oldest->older;
        oldest->older = arena->block->older;
        arena->block->older = other->block;
        arena->used += other->used;
    }
    *other = (Arena){0};
}

void arena_free(Arena *arena)
{
    for (ArenaBlock *block = arena->block, *older; block; block = older) {
        older = block->older;
        free(block);
    }
    *arena = (Arena){0};
}

void arena_keep_pages(void)
{
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 4 * LARGEST_BLOCK);
    mallopt(M_TRIM_THRESHOLD, ARENA_MAX_KEPT);
#endif
}
