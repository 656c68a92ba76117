/* Cache entries of a wrong size: each is a miss, counts as damaged, and is replaced. Also the
 * size limits for reading and writing an entry. */
#include "tests/test.h"
#include "tests/cache_folder.h"
#include <fcntl.h>
#include <sys/stat.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

/* The header is 40 bytes: magic, version, key, the blob's size, its checksum. */
enum { SIZE_AT = 24, WHOLE = HEADER + sizeof blob };

static size_t read_bytes(const char *path, char *bytes, size_t capacity)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t size = fread(bytes, 1, capacity, file);
    fclose(file);
    return size;
}

/* Replaces an entry's file by this one. The entry must then be a miss, be removed, be counted once
 * as damaged, and be replaced by the next put. */
static void assert_replaced(const Folder *folder, const char *file, size_t size)
{
    const Key key = key_of(12);
    Cache *cache = open_cache(folder, 0);
    cache_close(cache);
    const long damaged = statistic(folder, "damaged"), misses = statistic(folder, "misses");
    cache = open_cache(folder, 0);
    cache_put(cache, key, blob, sizeof blob);
    write_bytes(entry_path(folder, key), file, size);
    assert_miss(cache, key);
    assert_int_equal(access(entry_path(folder, key), F_OK), -1);
    assert_miss(cache, key); /* not there: no second damage */
    cache_put(cache, key, blob, sizeof blob);
    assert_hit(cache, key, blob, sizeof blob);
    assert_null(cache_trouble(cache));
    cache_close(cache);
    assert_int_equal(statistic(folder, "damaged"), damaged + 1);
    assert_int_equal(statistic(folder, "misses"), misses + 2);
    assert_int_equal(statistic(folder, "entries"), 1);
}

static void an_entry_of_a_wrong_size_is_replaced(void **state)
{
    static const size_t sizes[] = {0, 1, HEADER - 1, HEADER, HEADER + 1, WHOLE - 1, WHOLE + 1};
    static const uint64_t stated[] = {0, sizeof blob - 1, sizeof blob + 1, WHOLE, UINT64_MAX};
    const Folder *folder = *state;
    char file[WHOLE + 1] = {0};
    uint64_t size;
    Cache *cache = open_cache(folder, 0);
    cache_put(cache, key_of(12), blob, sizeof blob);
    cache_close(cache);
    assert_int_equal(read_bytes(entry_path(folder, key_of(12)), file, sizeof file), WHOLE);
    memcpy(&size, file + SIZE_AT, sizeof size);
    assert_int_equal(size, sizeof blob);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        assert_replaced(folder, file, sizes[i]);
    for (size_t i = 0; i < sizeof stated / sizeof *stated; i++) {
        memcpy(file + SIZE_AT, &stated[i], sizeof size);
        assert_replaced(folder, file, WHOLE);
    }
}

/* cache_keep() trusts a key that is the hash of the blob, but not a file of another size. */
static void an_entry_of_a_wrong_size_is_not_kept(void **state)
{
    const Folder *folder = *state;
    char file[WHOLE + 1] = {0};
    Cache *cache = open_cache(folder, 0);
    cache_keep(cache, key_of(13), blob, sizeof blob);
    assert_int_equal(read_bytes(entry_path(folder, key_of(13)), file, sizeof file), WHOLE);
    for (size_t size = WHOLE - 1; size <= WHOLE + 1; size++) {
        write_bytes(entry_path(folder, key_of(13)), file, size);
        cache_keep(cache, key_of(13), blob, sizeof blob);
        assert_hit(cache, key_of(13), blob, sizeof blob);
    }
    cache_close(cache);
    assert_int_equal(statistic(folder, "damaged"), 0);
}

/* An entry of these zeros with a correct checksum, which takes no room on disk. */
static void write_zeros(const char *path, Key key, const char *zeros, size_t size)
{
    const uint32_t version = 1;
    const uint64_t tail[] = {size,
                             XXH3_64bits_withSeed(zeros, size, XXH3_64bits(&key, sizeof key))};
    char header[HEADER] = "matc";
    memcpy(header + 4, &version, sizeof version);
    memcpy(header + 8, &key, sizeof key);
    memcpy(header + SIZE_AT, tail, sizeof tail);
    write_bytes(path, header, sizeof header);
    assert_int_equal(truncate(path, (off_t)(HEADER + size)), 0);
}

/* A blob has at most 256 MiB; one of a cache with a limit has, with its header, at most nine tenths
 * of that. */
static void an_entry_over_the_limit_is_neither_read_nor_written(void **state)
{
    enum { LARGEST = 256 << 20, LIMIT = 1000, LARGEST_WITHIN = 900 - HEADER };
    const Folder *folder = *state;
    char *bytes = calloc(1, (size_t)LARGEST + 1);
    Cache *cache = open_cache(folder, 0);
    assert_non_null(bytes);
    cache_put(cache, key_of(14), blob, sizeof blob); /* makes the folder of the key */
    write_zeros(entry_path(folder, key_of(14)), key_of(14), bytes, LARGEST);
    assert_hit(cache, key_of(14), bytes, LARGEST);
    write_zeros(entry_path(folder, key_of(14)), key_of(14), bytes, (size_t)LARGEST + 1);
    assert_miss(cache, key_of(14));
    assert_int_equal(access(entry_path(folder, key_of(14)), F_OK), -1);
    cache_put(cache, key_of(15), bytes, (size_t)LARGEST + 1);
    assert_int_equal(access(entry_path(folder, key_of(15)), F_OK), -1);
    cache_close(cache);
    assert_int_equal(statistic(folder, "damaged"), 1);
    assert_int_equal(statistic(folder, "failed"), 1);
    cache = open_cache(folder, LIMIT);
    cache_put(cache, key_of(16), bytes, LARGEST_WITHIN);
    assert_hit(cache, key_of(16), bytes, LARGEST_WITHIN);
    cache_put(cache, key_of(17), bytes, LARGEST_WITHIN + 1);
    assert_miss(cache, key_of(17));
    cache_close(cache);
    assert_int_equal(statistic(folder, "failed"), 2);
    free(bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(an_entry_of_a_wrong_size_is_replaced),
        FOLDER_TEST(an_entry_of_a_wrong_size_is_not_kept),
        FOLDER_TEST(an_entry_over_the_limit_is_neither_read_nor_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
