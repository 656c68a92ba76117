/* The stages of compile.c, for the library's surface (document.c, program.c) and the tests. */
#ifndef MATC_PIPELINE_H
#define MATC_PIPELINE_H
#include "compiler/emit/emit.h"
#include "compiler/read/tree.h"

typedef struct {
    Interface interface;
    const char *fragment, *vertex; /* the vertex program is NULL where nothing is validated */
    size_t fragment_size;
} Products;

/* Text -> Tree -> Graph. */
Graph *compile_front(Session *session, uint32_t source, Tree **tree);
/* Graph -> Ir, lowered and optimised. */
Ir *compile_ir(Session *session, const Graph *graph, const Node *material, const Job *job);
/* No vertex moves farther, by the intervals of an optimised IR; 0: none moves, INFINITY: they tell
 * no bound. */
double compile_displacement_bound(const Ir *ir);
/* Ir -> GLSL -> valid. */
bool compile_back(Session *session, const Ir *ir, const Job *job, Products *products);
/* The job that options name; otherwise which of them does not exist. choice.c */
const char *choice_job(const MatcOptions *options, Job *job);
#endif
