/* Files that documents include. */
#ifndef MATC_INCLUDE_H
#define MATC_INCLUDE_H
#include "compiler/read/tree.h"

/* The object that a file holds, of which a document of that depth says the name. NULL and *fine: it
 * was read before; else a diagnostic says why. */
Tree *include_read(Session *session, const Tree *name, int depth, bool *fine);
#endif
