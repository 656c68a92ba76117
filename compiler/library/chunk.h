/* The library's GLSL, embedded. */
#ifndef MATC_CHUNK_H
#define MATC_CHUNK_H
#include <stdbool.h>

/* A uniform that a chunk declares. */
typedef struct {
    const char *type; /* "mat3", "highp sampler2D" */
    const char *name; /* NULL behind the last */
    bool sampler;
} ChunkUniform;

/* An embedded GLSL file of compiler/library/. Made by compiler/gen/embed.c. */
typedef struct {
    const char *name;  /* "wood", "lattice.groimp.110" */
    const char *needs; /* names, a space between */
    const ChunkUniform *uniforms;
    const char *body; /* the text after the first line, without the declarations of uniforms */
} Chunk;
extern const Chunk chunk_table[]; /* sorted by name */
extern const int chunk_count;
#endif
