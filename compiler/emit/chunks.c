/* Finds library chunks by name and variant. The first existing file is used; for a target with
 * its own files such as .110 the order is name.<choice>.110, name.110, name.<choice>, name. */
#include "compiler/emit/chunks.h"
#include <string.h>

/* A chunk and its variants, which are adjacent in the table. */
typedef struct {
    const Chunk *first;
    int count, length; /* `length` is that of the name without the suffixes of variants */
} Variants;

static bool is_variant(const Chunk *chunk, const char *name, int length)
{
    return !strncmp(chunk->name, name, (size_t)length) &&
           (!chunk->name[length] || chunk->name[length] == '.');
}

static Variants variants_of(const char *name, int length)
{
    int low = 0, high = chunk_count;
    while (low < high) { /* binary search for the first name not less than the given one */
        int middle = (low + high) / 2;
        if (strncmp(chunk_table[middle].name, name, (size_t)length) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    Variants variants = {&chunk_table[low], 0, length};
    while (low + variants.count < chunk_count &&
           is_variant(variants.first + variants.count, name, length))
        variants.count++;
    return variants;
}

static const Chunk *find(const Variants *variants, const char *choice, const char *ending)
{
    const size_t size = strlen(choice);
    for (int i = 0; i < variants->count; i++) {
        const char *rest = variants->first[i].name + variants->length;
        if (size && (*rest++ != '.' || strncmp(rest, choice, size)))
            continue;
        if (!strcmp(rest + size, ending))
            return &variants->first[i];
    }
    return NULL;
}

/* Finds name.<choice> of any axis, with the given ending. */
static const Chunk *of_choice(const Variants *variants, const Job *job, const char *ending)
{
    const Chunk *chunk = NULL;
    for (int axis = 0; axis < AXIS_COUNT && !chunk; axis++)
        if (axis_table[axis].chunks)
            chunk = find(variants, choice_table[job->choice[axis]].name, ending);
    return chunk;
}

static const Chunk *variant(const char *name, int length, const Job *job)
{
    const Variants variants = variants_of(name, length);
    const char *own = target_table[job->target].library;
    const Chunk *chunk = own ? of_choice(&variants, job, own) : NULL;
    if (!chunk && own)
        chunk = find(&variants, "", own);
    if (!chunk)
        chunk = of_choice(&variants, job, "");
    return chunk ? chunk : find(&variants, "", "");
}

void chunks_add_found(Session *session, Chunks *chunks, const Chunk *chunk)
{
    for (size_t i = 0; i < chunks->count; i++)
        if (chunks->at[i] == chunk)
            return;
    ARENA_PUSH(session->arena, chunks->at, chunks->count, chunks->capacity, chunk);
}

static bool add(Session *session, Chunks *chunks, const char *name, int length, const Job *job)
{
    const Chunk *chunk = variant(name, length, job);
    if (!chunk)
        return false;
    for (size_t i = 0; i < chunks->count; i++)
        if (chunks->at[i] == chunk)
            return true;
    for (const char *need = chunk->needs; *need;) {
        int size = (int)strcspn(need, " ");
        if (!add(session, chunks, need, size, job))
            return false;
        need += size;
        need += strspn(need, " ");
    }
    chunks_add_found(session, chunks, chunk);
    return true;
}

bool chunks_add(Session *session, Chunks *chunks, const char *name, const Job *job)
{
    return add(session, chunks, name, (int)strlen(name), job);
}

bool chunks_declare(const Chunks *chunks, const char *name)
{
    for (size_t i = 0; i < chunks->count; i++)
        for (const ChunkUniform *uniform = chunks->at[i]->uniforms; uniform->name; uniform++)
            if (!strcmp(uniform->name, name))
                return true;
    return false;
}
