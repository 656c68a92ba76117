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

/* With all that is in it; links are not followed. */
static inline void folder_remove(const char *path)
{
    nftw(path, folder_remove_one, FOLDER_HANDLES, FTW_DEPTH | FTW_PHYS);
}

/* Where nftw's files are copied to, and how much of their paths is the folder that they come
 * from. */
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

/* Its folders and files, where nothing is yet. */
static inline bool folder_copy(const char *from, const char *to)
{
    folder_copied.to = to;
    folder_copied.skip = strlen(from);
    return !nftw(from, folder_copy_one, FOLDER_HANDLES, FTW_PHYS);
}
#endif
