/* Lints: warnings about documents that are valid but without the probably intended effect. */
#ifndef MATC_LINT_H
#define MATC_LINT_H
#include "compiler/base/session.h"
#include "compiler/graph/graph.h"
#include "grammar/unit_table.h"

/* Lints a graph without faults; `nodes` are its materials and maps that are not plain numbers,
 * in the order of their indices. */
void lint_graph(Session *session, const Graph *graph, const Node *const *nodes, size_t count);
/* Warns about a constant of unusual magnitude for its unit; lint_units() checks all parameters
 * of a node. A NULL `unit` disables the check. */
void lint_unit(Session *session, const char *name, const UnitRow *unit, const Value *value);
void lint_units(Session *session, const Node *node);
#endif
