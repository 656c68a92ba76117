/* Ends the process when memory is exhausted. */
#include "compiler/base/memory.h"
#include <stdlib.h>
#include <unistd.h>

void memory_exhausted(void)
{
    static const char line[] = "matc: out of memory\n";
    /* write(), because stdio might allocate */
    ssize_t written = write(STDERR_FILENO, line, sizeof line - 1);
    (void)written;
    abort();
}

void *memory_checked(void *allocated)
{
    if (!allocated)
        memory_exhausted();
    return allocated;
}
