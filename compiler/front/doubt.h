/* Warnings about what is no fault, and shows nothing of what was meant. */
#ifndef MATC_DOUBT_H
#define MATC_DOUBT_H
#include "compiler/base/session.h"
#include "compiler/front/graph.h"

/* Of a graph without faults; `nodes` are its materials and maps that are no bare numbers, in the order of their indices. */
void doubt_graph(Session *session, const Graph *graph, const Node *const *nodes, size_t count);
/* Parts of a material that no G-buffer holds, or not as they are. */
void doubt_lost(Session *session, const Node *material);
#endif
