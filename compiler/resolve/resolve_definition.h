/* Instantiation of definitions with parameters. */
#ifndef MATC_RESOLVE_DEFINITION_H
#define MATC_RESOLVE_DEFINITION_H
#include "compiler/resolve/resolve.h"

/* Returns true if the tree has `params:` or `doc:`. */
bool resolve_is_definition(const Tree *tree);
/* Instantiates a definition for a use `{ ref: name, parameter: argument }`; equal uses share one
 * tree. A NULL use selects the defaults, to check the definition. Returns NULL after reporting a
 * fault. */
Tree *resolve_definition(Resolver *r, const Member *definition, const Tree *use);
/* Adds a note at the other place of the last reported fault in an instance of the definition. */
void resolve_report_use(Resolver *r, const Member *definition, const Tree *use);
#endif
