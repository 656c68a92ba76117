/* Feeds a fuzz target with files, with all files of folders, or with standard input (AFL++). */
#include "fuzz.h"
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>

static int files; /* nftw has no user argument */

static void feed_stream(FILE *file)
{
    size_t size = 0, capacity = 1 << 16;
    char *bytes = malloc(capacity);
    while (bytes && (size += fread(bytes + size, 1, capacity - size, file)) == capacity)
        bytes = realloc(bytes, capacity *= 2);
    if (!bytes)
        abort();
    /* exact size, so that a sanitizer detects reads past the end */
    char *fitted = malloc(size ? size : 1);
    for (size_t i = 0; fitted && i < size; i++)
        fitted[i] = bytes[i];
    free(bytes);
    if (fitted)
        LLVMFuzzerTestOneInput((const uint8_t *)fitted, size);
    free(fitted);
    files++;
}

static int feed_file(const char *path, const struct stat *info, int type, struct FTW *where)
{
    (void)info, (void)where;
    FILE *file = type == FTW_F ? fopen(path, "rb") : NULL;
    if (!file)
        return 0;
    feed_stream(file);
    fclose(file);
    return 0;
}

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++)
        if (nftw(argv[i], feed_file, 16, FTW_PHYS) != 0)
            return 1;
    if (argc == 1)
        feed_stream(stdin);
    printf("%d inputs\n", files);
    return files == 0;
}
