/* Cache of vertex/fragment interfaces that were already linked successfully. */
#ifndef MATC_LINKED_H
#define MATC_LINKED_H
#include "compiler/base/hash.h"
#include "compiler/matc.h"

/* Functions of a thread-safe cache. A NULL cache is always empty. */
bool linked_before(MatcLinked *linked, Key interface);
void linked_add(MatcLinked *linked, Key interface);
#endif
