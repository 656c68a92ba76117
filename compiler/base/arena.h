/* Memory that is given back all at once. Nothing is freed singly. Out of memory ends the process:
 * memory.h. */
#ifndef MATC_ARENA_H
#define MATC_ARENA_H
#include <stddef.h>

typedef struct ArenaBlock ArenaBlock;
typedef struct {
    ArenaBlock *block; /* newest; older ones hang behind it */
    char *next, *end;  /* free part of the newest block */
    size_t used;       /* bytes handed out, for --stats */
} Arena;

/* `size` bytes aligned for any type, not cleared. */
void *arena_alloc(Arena *arena, size_t size);
void *arena_zero(Arena *arena, size_t size);
/* Copy of `size` bytes, with a zero byte behind. */
char *arena_string(Arena *arena, const char *text, size_t size);
/* A copy of `count` elements of `size` bytes, in an array with a capacity of `room`. */
void *arena_copy(Arena *arena, const void *array, size_t count, size_t room, size_t size);
/* Makes an allocation of `size` bytes one of `wanted`: the newest grows where it lies, any other
 * moves, with its first `kept` bytes. */
void *arena_extend(Arena *arena, void *old, size_t size, size_t kept, size_t wanted);
/* An array that has room for `count` elements of `size`, doubled when it is full; the contents move
 * along. */
void *arena_grow(Arena *arena, void *array, size_t count, size_t *room, size_t size);
/* An array by number with room for `index`: zeros where nothing was put yet. */
void *arena_reach(Arena *arena, void *array, size_t index, size_t *room, size_t size);
/* Gives everything back but keeps the newest block for what comes next. */
void arena_reset(Arena *arena);
void arena_free(Arena *arena);
/* Moves all memory of `other` into `arena`, which frees it; `other` is empty afterwards. */
void arena_adopt(Arena *arena, Arena *other);

/* For a process that compiles again and again: what arenas give back stays with it, up to
 * ARENA_MOST_KEPT bytes of them, and its pages are taken as they are. glibc would give them to the
 * system at once, and fetch each anew. The library leaves that to its process. */
enum { ARENA_MOST_KEPT = 256 * 1024 * 1024 };
void arena_keep_pages(void);

#define ARENA_NEW(arena, Type)          ((Type *)arena_zero(arena, sizeof(Type)))
#define ARENA_ARRAY(arena, Type, count) ((Type *)arena_zero(arena, sizeof(Type) * (size_t)(count)))
/* Appends to a {Type *at; size_t count, room} list. */
#define ARENA_PUSH(arena, array, count, room, value)                                               \
    ((void)((count) < (room) ||                                                                    \
            ((array) = arena_grow(arena, array, count, &(room), sizeof *(array)))),                \
     (array)[(count)++] = (value))
#endif
