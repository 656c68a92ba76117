/* Chunks by name and variant: name.<noise>.110, name.<noise>, name.110, name; the first that exists. */
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

static const Chunk *variant(const char *name, int length, Target target, Noise noise)
{
    char full[LONGEST_CHUNK_NAME];
    for (int i = 0; i < 4; i++) {
        bool of_noise = i < 2, of_110 = i % 2 == 0;
        if (of_110 && target != TARGET_glsl110)
            continue;
        snprintf(full, sizeof full, "%.*s%s%s%s", length, name, of_noise ? "." : "", of_noise ? noise_names[noise] : "",
                 of_110 ? ".110" : "");
        const Chunk *chunk = find(full);
        if (chunk)
            return chunk;
    }
    return NULL;
}

static bool add(Compile *c, Chunks *chunks, const char *name, int length, Target target, Noise noise)
{
    const Chunk *chunk = variant(name, length, target, noise);
    if (!chunk)
        return false;
    for (size_t i = 0; i < chunks->count; i++)
        if (chunks->at[i] == chunk)
            return true;
    for (const char *need = chunk->needs; *need;) {
        int size = (int)strcspn(need, " ");
        if (!add(c, chunks, need, size, target, noise))
            return false;
        need += size;
        need += strspn(need, " ");
    }
    ARENA_PUSH(c->arena, chunks->at, chunks->count, chunks->room, chunk);
    return true;
}

bool chunks_add(Compile *c, Chunks *chunks, const char *name, Target target, Noise noise)
{
    return add(c, chunks, name, (int)strlen(name), target, noise);
}
