/* Included files of documents. */
#ifndef MATC_INCLUDE_H
#define MATC_INCLUDE_H
#include "compiler/read/tree.h"

/* Reads the file that an `include:` names in a document of nesting level `depth`. Returns its
 * object, or NULL: with *fine the file was read before; otherwise a fault was reported. */
Tree *include_read(Session *session, const Tree *name, int depth, bool *fine);
#endif
