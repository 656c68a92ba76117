/* Removes and copies folders of tests and benchmarks. */
#ifndef TESTS_VALUE_FOLDER_H
#define TESTS_VALUE_FOLDER_H
#include "tests/value/read_whole.h"
#include <ftw.h>
#include <stdbool.h>
#include <string.h>

enum { FOLDER_PATH = 2048, FOLDER_HANDLES = 16 };

static inline int folder_remove_one(const char *path, const struct stat *info, int kind,
                                    struct FTW *walk)
{
    (void)info, (void)kind, (void)walk;
    return remove(path);
}

/* Removes a folder with its content; links are not followed. */
static inline void folder_remove(const char *path)
{
    nftw(path, folder_remove_one, FOLDER_HANDLES, FTW_DEPTH | FTW_PHYS);
}

/* Target folder of nftw's callback, and the length of the source folder's path. */
static struct {
    const char *to;
    size_t skip;
} folder_copied;

static inline int folder_copy_one(const char *path, const struct stat *info, int kind,
                                  struct FTW *walk)
{
    char to[FOLDER_PATH];
    size_t size;
    (void)info, (void)walk;
    snprintf(to, sizeof to, "%s%s", folder_copied.to, path + folder_copied.skip);
    if (kind == FTW_D)
        return mkdir(to, 0777);
    char *bytes = read_whole(path, &size);
    FILE *file = bytes ? fopen(to, "wb") : NULL;
    const bool written = file && fwrite(bytes, 1, size, file) == size;
    free(bytes);
    return file && !fclose(file) && written ? 0 : -1;
}

/* Copies a folder's content to a path that does not exist. */
static inline bool folder_copy(const char *from, const char *to)
{
    folder_copied.to = to;
    folder_copied.skip = strlen(from);
    return !nftw(from, folder_copy_one, FOLDER_HANDLES, FTW_PHYS);
}
#endif
