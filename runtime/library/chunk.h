/* The library's GLSL, embedded. */
#ifndef MATC_CHUNK_H
#define MATC_CHUNK_H

/* An embedded GLSL file of runtime/. Made by grammar/gen/embed.c. */
typedef struct {
    const char *name;     /* "wood", "lattice.groimp.110" */
    const char *needs;    /* names, a space between */
    const char *uniforms; /* its declarations: "mat3 matc_eyeFromWorld", one a line */
    const char *body;     /* the text after the first line, without the declarations */
} Chunk;
extern const Chunk chunk_table[]; /* sorted by name */
extern const int chunk_count;
#endif
