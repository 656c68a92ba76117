/* Definitions with parameters. */
#ifndef MATC_RESOLVE_DEFINITION_H
#define MATC_RESOLVE_DEFINITION_H
#include "compiler/resolve/resolve.h"

/* It says `params:` or `doc:`. */
bool resolve_is_definition(const Tree *tree);
/* The tree that a use of a definition stands for, `{ ref: name, parameter: argument }`; equal ones
 * have one. NULL for a use: with its defaults, to be checked. NULL: told. */
Tree *resolve_definition(Resolver *r, const Member *definition, const Tree *use);
/* Shows the other place of the fault that was said last, of what the use stands for. */
void resolve_say_use(Resolver *r, const Member *definition, const Tree *use);
#endif
