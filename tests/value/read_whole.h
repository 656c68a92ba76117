/* Reads a whole file unchanged, for tests and benchmarks. */
#ifndef MATC_VALUE_READ_WHOLE_H
#define MATC_VALUE_READ_WHOLE_H
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

/* Returns the file's bytes with a zero appended, from malloc; NULL and no size if it cannot be
 * read. */
static inline char *read_whole(const char *path, size_t *size)
{
    struct stat info;
    FILE *file = fopen(path, "rb");
    char *bytes = file && !fstat(fileno(file), &info) ? malloc((size_t)info.st_size + 1) : NULL;
    *size = bytes ? fread(bytes, 1, (size_t)info.st_size, file) : 0;
    if (bytes)
        bytes[*size] = 0;
    if (file)
        fclose(file);
    return bytes;
}
#endif
