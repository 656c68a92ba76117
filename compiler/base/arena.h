/* Arena (bump) allocator: allocations are freed all at once, never singly. Exhausted memory ends
 * the process: see memory.h. */
#ifndef MATC_ARENA_H
#define MATC_ARENA_H
#include <stddef.h>

typedef struct ArenaBlock ArenaBlock;
typedef struct {
    ArenaBlock *block; /* newest block; linked to the older ones */
    char *next, *end;  /* free part of the newest block */
    size_t used;       /* bytes handed out, for --stats */
} Arena;

/* Returns `size` bytes aligned for any type; arena_alloc() leaves them uninitialized,
 * arena_zero() clears them. */
void *arena_alloc(Arena *arena, size_t size);
void *arena_zero(Arena *arena, size_t size);
/* Copies `size` bytes and appends a zero byte. */
char *arena_string(Arena *arena, const char *text, size_t size);
/* Copies `count` elements of `size` bytes into a new array of `capacity` elements. */
void *arena_copy(Arena *arena, const void *array, size_t count, size_t capacity, size_t size);
/* Grows an allocation from `size` to `wanted` bytes and returns its address. The newest
 * allocation grows in place; any other is moved, and its first `kept` bytes are copied. */
void *arena_extend(Arena *arena, void *old, size_t size, size_t kept, size_t wanted);
/* Ensures that the array has capacity for one element more than `count`: doubles *capacity when the
 * array is full and moves the elements of `size` bytes. */
void *arena_grow(Arena *arena, void *array, size_t count, size_t *capacity, size_t size);
/* Ensures that the array has an element `index`; new elements are zero. */
void *arena_reach(Arena *arena, void *array, size_t index, size_t *capacity, size_t size);
/* Frees all allocations but keeps the newest block for reuse. */
void arena_reset(Arena *arena);
void arena_free(Arena *arena);
/* Moves all memory of `other` into `arena`, which frees it; `other` is empty afterwards. */
void arena_adopt(Arena *arena, Arena *other);

/* Tells malloc to retain freed memory, up to ARENA_MAX_KEPT bytes, instead of returning it to
 * the system. Meant for a process that compiles many times: by default glibc unmaps freed blocks
 * at once, and new pages have to be faulted in. The library leaves the choice to its host
 * process. */
enum { ARENA_MAX_KEPT = 256 * 1024 * 1024 };
void arena_keep_pages(void);

#define ARENA_NEW(arena, Type)          ((Type *)arena_zero(arena, sizeof(Type)))
#define ARENA_ARRAY(arena, Type, count) ((Type *)arena_zero(arena, sizeof(Type) * (size_t)(count)))
/* Appends `value` to a list {Type *at; size_t count, capacity}. */
#define ARENA_PUSH(arena, array, count, capacity, value)                                           \
    ((void)((count) < (capacity) ||                                                                \
            ((array) = arena_grow(arena, array, count, &(capacity), sizeof *(array)))),            \
     (array)[(count)++] = (value))
#endif
