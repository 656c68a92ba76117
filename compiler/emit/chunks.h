/* Library chunks: which are needed, in dependency order, and the uniforms they declare. */
#ifndef MATC_CHUNKS_H
#define MATC_CHUNKS_H
#include "compiler/base/session.h"
#include "compiler/ir/job.h"
#include "compiler/library/chunk.h"

typedef struct {
    const Chunk **at; /* users after what they need */
    size_t count, room;
} Chunks;

/* Adds one behind those that it needs. */
void chunks_add_found(Session *session, Chunks *chunks, const Chunk *chunk);
/* Adds a chunk and all it needs, each once, in the variant for the job's target and choices. False
 * if there is none. */
bool chunks_add(Session *session, Chunks *chunks, const char *name, const Job *job);
/* One of them declares a uniform of that name. */
bool chunks_declare(const Chunks *chunks, const char *name);
#endif
