/* The end of a process that has no memory left. The library promises a caller nothing after a
 * failed allocation, so that no function of it has to hand one back: see matc.h. */
#ifndef MATC_MEMORY_H
#define MATC_MEMORY_H

/* Writes "out of memory" to standard error and aborts. This is the only line that the library
 * itself prints: an abort without a word is taken for a fault of the program. */
_Noreturn void memory_exhausted(void);
/* Returns what malloc(), realloc() or strdup() returned; NULL ends the process. */
void *memory_checked(void *allocated);
#endif
