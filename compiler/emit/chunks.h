/* Library chunks: which are needed, in dependency order, and the uniforms they declare. */
#ifndef MATC_CHUNKS_H
#define MATC_CHUNKS_H
#include "compiler/base/session.h"
#include "compiler/ir/job.h"

/* An embedded GLSL file of runtime/. Made by grammar/gen/embed.c. */
typedef struct {
    const char *name;     /* "wood", "lattice.groimp.110" */
    const char *needs;    /* names, a space between */
    const char *uniforms; /* its declarations: "mat3 matc_eyeFromWorld", one a line */
    const char *body;     /* the text after the first line, without the declarations */
} Chunk;
extern const Chunk chunk_table[]; /* sorted by name */
extern const int chunk_count;

typedef struct {
    const Chunk **at; /* users after what they need */
    size_t count, room;
} Chunks;

/* Adds a chunk and all it needs, each once, in the variant for the job's target and choices. False if there is none. */
bool chunks_add(Session *session, Chunks *chunks, const char *name, const Job *job);
#endif
