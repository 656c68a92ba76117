/* Out-of-memory handling: the process ends. The library guarantees nothing after a failed
 * allocation, so its functions need not report one: see matc.h. */
#ifndef MATC_MEMORY_H
#define MATC_MEMORY_H

/* Writes "out of memory" to standard error and aborts. The library itself prints nothing else:
 * an abort without a message would look like a bug. */
_Noreturn void memory_exhausted(void);
/* Returns the result of malloc(), realloc() or strdup(); ends the process if it is NULL. */
void *memory_checked(void *allocated);
#endif
