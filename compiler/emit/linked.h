/* Interfaces between vertex and fragment programs that were linked already. */
#ifndef MATC_LINKED_H
#define MATC_LINKED_H
#include "compiler/base/hash.h"
#include "compiler/matc.h"

/* From any thread. NULL knows nothing, and keeps nothing. */
bool linked_before(MatcLinked *linked, Key interface);
void linked_add(MatcLinked *linked, Key interface);
#endif
