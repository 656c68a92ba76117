/* The cache: a get returns exactly what was put, whatever happens to the cache's files. */
#include "tests/test.h"
#include "tests/cache_folder.h"
#include <errno.h>
#include <signal.h>
#include <stdbool.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

static size_t read_bytes(const char *path, char *bytes, size_t capacity)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t size = fread(bytes, 1, capacity, file);
    fclose(file);
    return size;
}

static void what_was_put_is_found_by_every_run(void **state)
{
    const Folder *folder = *state;
    char *large = malloc(1 << 20);
    for (int i = 0; i < 1 << 20; i++)
        large[i] = (char)(i * 7 ^ i >> 9);
    Cache *cache = open_cache(folder, 0);
    assert_miss(cache, key_of(1));
    cache_put(cache, key_of(1), "one", 3);
    cache_put(cache, key_of(2), "", 0);
    cache_put(cache, key_of(3), large, 1 << 20);
    cache_put(cache, key_of(4), "old", 3);
    cache_put(cache, key_of(4), "newer", 5);
    cache_close(cache);
    cache = open_cache(folder, 0);
    assert_hit(cache, key_of(1), "one", 3);
    assert_hit(cache, key_of(2), "", 0);
    assert_hit(cache, key_of(3), large, 1 << 20);
    assert_hit(cache, key_of(4), "newer", 5);
    assert_null(cache_trouble(cache));
    cache_close(cache);
    assert_int_equal(statistic(folder, "entries"), 4);
    assert_int_equal(statistic(folder, "bytes"), 3 + 0 + (1 << 20) + 5 + 4 * HEADER);
    assert_int_equal(statistic(folder, "hits"), 4);
    assert_int_equal(statistic(folder, "misses"), 1);
    assert_int_equal(statistic(folder, "damaged"), 0);
    free(large);
}

static void keys_that_differ_in_a_bit_are_different(void **state)
{
    Cache *cache = open_cache(*state, 0);
    const Key key = key_of(5);
    cache_put(cache, key, "mine", 4);
    for (int bit = 0; bit < 128; bit++) {
        Key other = key;
        *(bit < 64 ? &other.low : &other.high) ^= (uint64_t)1 << bit % 64;
        assert_miss(cache, other);
        cache_put(cache, other, &(char){(char)bit}, 1);
    }
    assert_hit(cache, key, "mine", 4);
    for (int bit = 0; bit < 128; bit++) {
        Key other = key;
        *(bit < 64 ? &other.low : &other.high) ^= (uint64_t)1 << bit % 64;
        assert_hit(cache, other, &(char){(char)bit}, 1);
    }
    cache_close(cache);
}

static void an_entry_with_any_byte_changed_is_not_served(void **state)
{
    const Folder *folder = *state;
    static const unsigned char flips[] = {0x01, 0x80, 0xFF};
    char file[HEADER + sizeof blob];
    Cache *cache = open_cache(folder, 0);
    cache_put(cache, key_of(6), blob, sizeof blob);
    assert_int_equal(read_bytes(entry_path(folder, key_of(6)), file, sizeof file), sizeof file);
    for (size_t i = 0; i < sizeof file; i++)
        for (size_t k = 0; k < sizeof flips; k++) {
            file[i] = (char)(file[i] ^ flips[k]);
            write_bytes(entry_path(folder, key_of(6)), file, sizeof file);
            assert_miss(cache, key_of(6));
            assert_int_equal(access(entry_path(folder, key_of(6)), F_OK), -1); /* gone */
            file[i] = (char)(file[i] ^ flips[k]);
        }
    write_bytes(entry_path(folder, key_of(6)), file, sizeof file);
    assert_hit(cache, key_of(6), blob, sizeof blob);
    cache_close(cache);
    assert_int_equal(statistic(folder, "damaged"), sizeof file * sizeof flips);
}

static void an_entry_of_another_length_is_not_served(void **state)
{
    const Folder *folder = *state;
    char file[HEADER + sizeof blob + 8] = {0};
    Cache *cache = open_cache(folder, 0);
    cache_put(cache, key_of(7), blob, sizeof blob);
    assert_int_equal(read_bytes(entry_path(folder, key_of(7)), file, sizeof file),
                     HEADER + sizeof blob);
    for (size_t size = 0; size <= sizeof file; size++) {
        write_bytes(entry_path(folder, key_of(7)), file, size);
        if (size == HEADER + sizeof blob)
            assert_hit(cache, key_of(7), blob, sizeof blob);
        else
            assert_miss(cache, key_of(7));
    }
    cache_close(cache);
}

/* An entry's file is replaced by that of another entry, a folder, a link, a pipe, a huge file. */
static void a_foreign_entry_is_not_served(void **state)
{
    const Folder *folder = *state;
    const Key mine = {1, 0}, other = {2, 0}; /* of one folder */
    char file[HEADER + sizeof blob];
    Cache *cache = open_cache(folder, 0);
    cache_put(cache, mine, blob, sizeof blob);
    size_t size = read_bytes(entry_path(folder, mine), file, sizeof file);
    write_bytes(entry_path(folder, other), file, size);
    assert_miss(cache, other);
    assert_int_equal(symlink("0000000000000000000000000000000001", entry_path(folder, other)), 0);
    assert_miss(cache, other);
    assert_int_equal(mkfifo(entry_path(folder, other), 0600), 0);
    alarm(10); /* a hang ends here */
    assert_miss(cache, other);
    alarm(0);
    write_bytes(entry_path(folder, other), file, size);
    assert_int_equal(truncate(entry_path(folder, other), (off_t)1 << 40), 0);
    assert_miss(cache, other);
    assert_int_equal(mkdir(entry_path(folder, other), 0700), 0);
    assert_miss(cache, other);
    cache_put(cache, other, "x", 1); /* cannot be kept: that is all */
    assert_non_null(cache_trouble(cache));
    assert_hit(cache, mine, blob, sizeof blob);
    cache_close(cache);
    assert_int_equal(statistic(folder, "failed"), 1);
}

/* Runs in a process without superuser rights, which would bypass permissions. */
static bool in_child(bool (*does)(const Folder *folder), const Folder *folder)
{
    int status;
    pid_t child = fork();
    if (!child) {
        if (!geteuid() && (setgid(65534) || setuid(65534)))
            _exit(2);
        _exit(!does(folder));
    }
    return waitpid(child, &status, 0) == child && status == 0;
}

static bool use_read_only(const Folder *folder)
{
    const char *why;
    size_t size;
    Cache *cache = cache_open(folder->path, 1000, &why);
    char *bytes = cache ? cache_get(cache, key_of(8), &size) : NULL;
    cache_put(cache, key_of(9), blob, sizeof blob);
    bool fine =
        bytes && size == sizeof blob && cache_trouble(cache) && !cache_get(cache, key_of(9), &size);
    free(bytes);
    cache_close(cache);
    return fine;
}

static int change_mode(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    (void)info, (void)walk;
    return chmod(path, kind == FTW_F ? 0444 : 0555);
}

static int change_back(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    (void)info, (void)walk;
    return chmod(path, kind == FTW_F ? 0644 : 0755);
}

static void a_read_only_folder_serves_what_it_has(void **state)
{
    const Folder *folder = *state;
    Cache *cache = open_cache(folder, 0);
    cache_put(cache, key_of(8), blob, sizeof blob);
    cache_close(cache);
    nftw(folder->root, change_mode, 16, FTW_PHYS);
    bool fine = in_child(use_read_only, folder);
    nftw(folder->root, change_back, 16, FTW_PHYS);
    assert_true(fine);
}

/* Simulates a full disk: writing fails after some bytes. */
static bool use_full(const Folder *folder)
{
    const char *why;
    size_t size;
    char bytes[5000] = {0};
    signal(SIGXFSZ, SIG_IGN);
    struct rlimit limit = {2000, 2000};
    Cache *cache = cache_open(folder->path, 0, &why);
    if (!cache || setrlimit(RLIMIT_FSIZE, &limit))
        return false;
    cache_put(cache, key_of(10), bytes, sizeof bytes);
    cache_put(cache, key_of(11), bytes, 1000);
    char *small = cache_get(cache, key_of(11), &size);
    bool fine =
        small && size == 1000 && cache_trouble(cache) && !cache_get(cache, key_of(10), &size);
    free(small);
    cache_close(cache);
    return fine;
}

static void a_full_folder_loses_nothing_else(void **state)
{
    const Folder *folder = *state;
    assert_int_equal(chmod(folder->root, 0777), 0);
    assert_true(in_child(use_full, folder));
    assert_int_equal(statistic(folder, "entries"), 1);
    assert_int_equal(statistic(folder, "failed"), 1);
}

static void what_is_no_folder_is_refused(void **state)
{
    const Folder *folder = *state;
    const char *why = NULL;
    char path[PATH_CAPACITY];
    size_t size;
    snprintf(path, sizeof path, "%s/file", folder->root);
    write_bytes(path, "x", 1);
    assert_null(cache_open(path, 0, &why));
    assert_string_equal(why, strerror(ENOTDIR));
    snprintf(path, sizeof path, "%s/file/below", folder->root);
    assert_null(cache_open(path, 0, &why));
    assert_string_equal(why, strerror(ENOTDIR));
    assert_null(cache_statistics(path));
    cache_put(NULL, key_of(1), "x", 1); /* no cache: always empty */
    assert_null(cache_get(NULL, key_of(1), &size));
    assert_null(cache_trouble(NULL));
    cache_close(NULL);
}

/* A checksum is no signature: a user with write access can forge an entry by rehashing, as here. */
static void what_others_may_write_is_not_read(void **state)
{
    const Folder *folder = *state;
    const char *why = NULL;
    const uid_t other = 65534;
    Cache *cache = open_cache(folder, 0);
    cache_put(cache, key_of(1), blob, sizeof blob);
    cache_put(cache, key_of(2), blob, sizeof blob);
    assert_hit(cache, key_of(1), blob, sizeof blob);
    assert_int_equal(chmod(entry_path(folder, key_of(1)), 0664), 0);
    assert_miss(cache, key_of(1));
    if (!geteuid()) {
        assert_int_equal(chown(entry_path(folder, key_of(2)), other, other), 0);
        assert_miss(cache, key_of(2));
    }
    cache_close(cache);
    static const mode_t open_modes[] = {0775, 0757, 0777, 01777};
    for (size_t i = 0; i < sizeof open_modes / sizeof *open_modes; i++) {
        assert_int_equal(chmod(folder->path, open_modes[i]), 0);
        assert_null(cache_open(folder->path, 0, &why));
        assert_string_equal(
            why, "others may write to the folder, and could forge its entries (chmod go-w)");
    }
    assert_int_equal(chmod(folder->path, 0755), 0);
    cache_close(open_cache(folder, 0));
    if (geteuid())
        return;
    assert_int_equal(chown(folder->path, other, other), 0);
    assert_null(cache_open(folder->path, 0, &why));
    assert_string_equal(why, "the folder belongs to another user, who could forge its entries");
}

/* With any umask, the folders that a cache creates are accessible only to the user. */
static void what_is_made_can_be_opened_again(void **state)
{
    const Folder *folder = *state;
    const mode_t before = umask(0);
    Cache *cache = open_cache(folder, 0);
    cache_put(cache, key_of(1), blob, sizeof blob);
    cache_close(cache);
    umask(before);
    cache = open_cache(folder, 0);
    assert_hit(cache, key_of(1), blob, sizeof blob);
    cache_close(cache);
}

static void damaged_statistics_are_no_fault(void **state)
{
    static const char *const texts[] = {"", "hits", "hits -1\nbytes x\n", "\xff\xfe",
                                        "bytes 99999999999999999999999999\n"};
    const Folder *folder = *state;
    char path[2 * PATH_CAPACITY];
    snprintf(path, sizeof path, "%s/statistics", folder->path);
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        Cache *cache = open_cache(folder, 1000);
        write_bytes(path, texts[i], strlen(texts[i]));
        cache_put(cache, key_of(i), blob, sizeof blob);
        assert_hit(cache, key_of(i), blob, sizeof blob);
        cache_close(cache);
        assert_int_equal(statistic(folder, "entries"), i + 1);
    }
    char tag[2 * PATH_CAPACITY], text[64] = {0};
    snprintf(tag, sizeof tag, "%s/CACHEDIR.TAG", folder->path);
    read_bytes(tag, text, sizeof text - 1);
    assert_int_equal(strncmp(text, "Signature: 8a477f597d28d172789f06886806bc55\n", 44), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(what_was_put_is_found_by_every_run),
        FOLDER_TEST(keys_that_differ_in_a_bit_are_different),
        FOLDER_TEST(an_entry_with_any_byte_changed_is_not_served),
        FOLDER_TEST(an_entry_of_another_length_is_not_served),
        FOLDER_TEST(a_foreign_entry_is_not_served),
        FOLDER_TEST(a_read_only_folder_serves_what_it_has),
        FOLDER_TEST(a_full_folder_loses_nothing_else),
        FOLDER_TEST(what_is_no_folder_is_refused),
        FOLDER_TEST(what_others_may_write_is_not_read),
        FOLDER_TEST(what_is_made_can_be_opened_again),
        FOLDER_TEST(damaged_statistics_are_no_fault),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
