/* A cache folder for a test, and access to its content: entries by key, and its statistics. */
#ifndef TESTS_CACHE_FOLDER_H
#define TESTS_CACHE_FOLDER_H
#include "compiler/tool/cache.h"
#include "tests/value/folder.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { HEADER = 40, PATH_CAPACITY = 256 }; /* bytes of an entry's header */

typedef struct {
    char root[PATH_CAPACITY / 2]; /* created for the test, removed after it */
    char path[PATH_CAPACITY];     /* of the cache, in `root` */
} Folder;

static inline int make_folder(void **state)
{
    Folder *folder = calloc(1, sizeof *folder);
    strcpy(folder->root, "/tmp/matc_cacheXXXXXX");
    *state = folder;
    if (!mkdtemp(folder->root))
        return -1;
    snprintf(folder->path, sizeof folder->path, "%s/above/cache", folder->root);
    return 0;
}

static inline int remove_folder(void **state)
{
    Folder *folder = *state;
    folder_remove(folder->root);
    free(folder);
    return 0;
}

static inline Cache *open_cache(const Folder *folder, uint64_t limit)
{
    const char *why = NULL;
    Cache *cache = cache_open(folder->path, limit, &why);
    if (!cache)
        fprintf(stderr, "%s: %s\n", folder->path, why);
    assert_non_null(cache);
    return cache;
}

static inline Key key_of(uint64_t n)
{
    return (Key){n * 0x9E3779B97F4A7C15u, ~n * 0xD1B54A32D192ED03u};
}

/* Returns a number of the cache's statistics, or -1 if the line is absent. */
static inline long statistic(const Folder *folder, const char *name)
{
    char *text = cache_statistics(folder->path);
    assert_non_null(text);
    const char *line = strstr(text, name);
    long value = line ? strtol(line + strlen(name), NULL, 10) : -1;
    free(text);
    return value;
}

/* Path of a key's entry. */
static inline const char *entry_path(const Folder *folder, Key key)
{
    static char path[2 * PATH_CAPACITY];
    char digits[33];
    snprintf(digits, sizeof digits, "%016llx%016llx", (unsigned long long)key.high,
             (unsigned long long)key.low);
    snprintf(path, sizeof path, "%s/%.2s/%s", folder->path, digits, digits + 2);
    return path;
}

static inline void write_bytes(const char *path, const char *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static inline void assert_hit(Cache *cache, Key key, const char *bytes, size_t size)
{
    size_t got = 0;
    char *blob = cache_get(cache, key, &got);
    assert_non_null(blob);
    assert_int_equal(got, size);
    assert_memory_equal(blob, bytes, size);
    assert_int_equal(blob[size], 0);
    free(blob);
}

static inline void assert_miss(Cache *cache, Key key)
{
    size_t size;
    assert_null(cache_get(cache, key, &size));
}

/* A blob for tests that check its content. */
static const char blob[] = "void main() { gl_FragColor = vec4(1.0); }";

/* Setup and teardown of a test, whose state is a Folder. */
#define FOLDER_TEST(name) cmocka_unit_test_setup_teardown(name, make_folder, remove_folder)
#endif
