/* Library chunks of a program, in dependency order, and the uniforms that they declare. */
#ifndef MATC_CHUNKS_H
#define MATC_CHUNKS_H
#include "compiler/base/session.h"
#include "compiler/ir/job.h"
#include "compiler/library/chunk.h"

typedef struct {
    const Chunk **at; /* dependencies precede their users */
    size_t count, capacity;
} Chunks;

/* Adds a chunk after its dependencies. */
void chunks_add_found(Session *session, Chunks *chunks, const Chunk *chunk);
/* Adds a chunk and all its dependencies, each once, in the variant for the job's target and
 * choices. Returns false if the chunk does not exist. */
bool chunks_add(Session *session, Chunks *chunks, const char *name, const Job *job);
/* Returns true if a chunk declares a uniform of that name. */
bool chunks_declare(const Chunks *chunks, const char *name);
#endif
