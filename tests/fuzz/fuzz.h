/* The entry point that libFuzzer, AFL++ or feed.c calls once per input. */
#ifndef MATC_FUZZ_H
#define MATC_FUZZ_H
#include <stddef.h>
#include <stdint.h>

/* Returns 0; a fault aborts. */
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

/* A reader of files for MatcOptions: includes and pictures do not exist. */
static inline char *fuzz_no_file(void *user, const char *path, size_t *size, const char **why)
{
    (void)user, (void)path, (void)size;
    *why = "no files here";
    return NULL;
}
#endif
