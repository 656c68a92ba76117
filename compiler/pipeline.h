/* The compiler's stages, for the library's API (document.c, program.c) and the tests. */
#ifndef MATC_PIPELINE_H
#define MATC_PIPELINE_H
#include "compiler/emit/emit.h"
#include "compiler/read/tree.h"

typedef struct {
    Interface interface;
    const char *fragment, *vertex; /* texts of the programs; `vertex` is NULL without validation */
    size_t fragment_size;
} Products;

/* Parses a text to a Tree and resolves the Tree to a Graph. */
Graph *compile_front(Session *session, uint32_t source, Tree **tree);
/* Lowers a material of the graph to the Ir, and optimizes it. */
Ir *compile_ir(Session *session, const Graph *graph, const Node *material, const Job *job);
/* Returns the max displacement of a vertex from the intervals of an optimized IR; 0: no
 * displacement, INFINITY: unbounded. */
double compile_displacement_bound(const Ir *ir);
/* Emits GLSL for the Ir, and validates the GLSL. */
bool compile_back(Session *session, const Ir *ir, const Job *job, Products *products);
/* Converts options to a job; otherwise returns the first option with an unknown value. choice.c */
const char *choice_job(const MatcOptions *options, Job *job);
#endif
