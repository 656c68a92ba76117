/* Chunks by name and variant: name.<choice>.110, name.110, name.<choice>, name; the first that exists. */
#include "link.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_CHUNK_NAME = 96 };

static int by_name(const void *name, const void *chunk) { return strcmp(name, ((const Chunk *)chunk)->name); }

static const Chunk *find(const char *name)
{
    return bsearch(name, chunk_table, (size_t)chunk_count, sizeof *chunk_table, by_name);
}

static const Chunk *find_variant(const char *name, int length, const char *choice, bool of_110)
{
    char full[LONGEST_CHUNK_NAME];
    snprintf(full, sizeof full, "%.*s%s%s%s", length, name, *choice ? "." : "", choice, of_110 ? ".110" : "");
    return find(full);
}

/* name.<choice> of any axis, or for GLSL 1.10 name.<choice>.110. */
static const Chunk *of_choice(const char *name, int length, const Job *job, bool of_110)
{
    const Chunk *chunk = NULL;
    for (int axis = 0; axis < AXIS_COUNT && !chunk; axis++)
        if (axis_table[axis].chunks)
            chunk = find_variant(name, length, choice_table[job->choice[axis]].name, of_110);
    return chunk;
}

static const Chunk *variant(const char *name, int length, const Job *job)
{
    bool old = job->target == TARGET_glsl110;
    const Chunk *chunk = old ? of_choice(name, length, job, true) : NULL;
    if (!chunk && old)
        chunk = find_variant(name, length, "", true);
    if (!chunk)
        chunk = of_choice(name, length, job, false);
    return chunk ? chunk : find_variant(name, length, "", false);
}

static bool add(Compile *c, Chunks *chunks, const char *name, int length, const Job *job)
{
    const Chunk *chunk = variant(name, length, job);
    if (!chunk)
        return false;
    for (size_t i = 0; i < chunks->count; i++)
        if (chunks->at[i] == chunk)
            return true;
    for (const char *need = chunk->needs; *need;) {
        int size = (int)strcspn(need, " ");
        if (!add(c, chunks, need, size, job))
            return false;
        need += size;
        need += strspn(need, " ");
    }
    ARENA_PUSH(c->arena, chunks->at, chunks->count, chunks->room, chunk);
    return true;
}

bool chunks_add(Compile *c, Chunks *chunks, const char *name, const Job *job)
{
    return add(c, chunks, name, (int)strlen(name), job);
}
