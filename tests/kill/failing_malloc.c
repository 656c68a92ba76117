/* A preloaded allocator whose calls fail by count: with FAIL_AT=n the n-th call of malloc(),
 * calloc() or realloc() returns NULL, with FAIL_AFTERWARDS=1 also each later call; FAIL_COUNT=1
 * prints the number of calls at exit. Used by tests/tool/out_of_memory.sh.
 *
 * FAIL_AT=3 LD_PRELOAD=libfailing_malloc.so matc ...: two allocations succeed, the third fails,
 * the fourth succeeds. */
#include <errno.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);

static atomic_long calls;

static long setting(const char *name)
{
    const char *text = getenv(name);
    return text ? atol(text) : 0;
}

static int fails(void)
{
    const long call = ++calls, first = setting("FAIL_AT");
    if (first <= 0 || call < first || (call > first && !setting("FAIL_AFTERWARDS")))
        return 0;
    errno = ENOMEM;
    return 1;
}

void *malloc(size_t size) { return fails() ? NULL : __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return fails() ? NULL : __libc_calloc(count, size); }
void *realloc(void *old, size_t size) { return fails() ? NULL : __libc_realloc(old, size); }

__attribute__((destructor)) static void print_count(void)
{
    if (setting("FAIL_COUNT"))
        dprintf(2, "allocations %ld\n", (long)calls);
}
