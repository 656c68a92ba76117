/* The cache: what is served is what was put there, whatever happens to its files and however many work on them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "compiler/tool/cache.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <pthread.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { HEADER = 40, PATH_ROOM = 256, PROCESSES = 8, ROUNDS = 400, KEYS = 60 };

typedef struct {
    char root[PATH_ROOM / 2]; /* made for the test, removed after it */
    char path[PATH_ROOM];     /* of the cache, below it */
} Folder;

static int remove_file(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    (void)info, (void)kind, (void)walk;
    return remove(path);
}

static int make_folder(void **state)
{
    Folder *folder = calloc(1, sizeof *folder);
    strcpy(folder->root, "/tmp/matc_cacheXXXXXX");
    *state = folder;
    if (!mkdtemp(folder->root))
        return -1;
    snprintf(folder->path, sizeof folder->path, "%s/above/cache", folder->root);
    return 0;
}

static int remove_folder(void **state)
{
    Folder *folder = *state;
    nftw(folder->root, remove_file, 16, FTW_DEPTH | FTW_PHYS);
    free(folder);
    return 0;
}

static Cache *open_cache(const Folder *folder, uint64_t limit)
{
    const char *why = NULL;
    Cache *cache = cache_open(folder->path, limit, &why);
    if (!cache)
        fprintf(stderr, "%s: %s\n", folder->path, why);
    assert_non_null(cache);
    return cache;
}

static Key key_of(uint64_t n) { return (Key){n * 0x9E3779B97F4A7C15u, ~n * 0xD1B54A32D192ED03u}; }

/* A number of the statistics; -1 if there is no such line. */
static long statistic(const Folder *folder, const char *name)
{
    char *text = cache_statistics(folder->path);
    assert_non_null(text);
    const char *line = strstr(text, name);
    long value = line ? strtol(line + strlen(name), NULL, 10) : -1;
    free(text);
    return value;
}

/* The file of a key. */
static const char *entry_path(const Folder *folder, Key key)
{
    static char path[2 * PATH_ROOM];
    char digits[33];
    snprintf(digits, sizeof digits, "%016llx%016llx", (unsigned long long)key.high, (unsigned long long)key.low);
    snprintf(path, sizeof path, "%s/%.2s/%s", folder->path, digits, digits + 2);
    return path;
}

static void write_bytes(const char *path, const char *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static size_t read_bytes(const char *path, char *bytes, size_t room)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t size = fread(bytes, 1, room, file);
    fclose(file);
    return size;
}

static void assert_hit(Cache *cache, Key key, const char *bytes, size_t size)
{
    size_t got = 0;
    char *blob = cache_get(cache, key, &got);
    assert_non_null(blob);
    assert_int_equal(got, size);
    assert_memory_equal(blob, bytes, size);
    assert_int_equal(blob[size], 0);
    free(blob);
}

static void assert_miss(Cache *cache, Key key)
{
    size_t size;
    assert_null(cache_get(cache, key, &size));
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

static const char blob[] = "void main() { gl_FragColor = vec4(1.0); }";

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
    assert_int_equal(read_bytes(entry_path(folder, key_of(7)), file, sizeof file), HEADER + sizeof blob);
    for (size_t size = 0; size <= sizeof file; size++) {
        write_bytes(entry_path(folder, key_of(7)), file, size);
        if (size == HEADER + sizeof blob)
            assert_hit(cache, key_of(7), blob, sizeof blob);
        else
            assert_miss(cache, key_of(7));
    }
    cache_close(cache);
}

/* An entry that is another entry's file, a folder, a link, a pipe, a huge file. */
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

/* What the blob of a key is, of a length that differs from key to key. */
static size_t blob_of(uint64_t n, char *bytes)
{
    size_t size = 100 + (size_t)(n * 977 % 5000);
    for (size_t i = 0; i < size; i++)
        bytes[i] = (char)(n * 31 + i * 7);
    return size;
}

/* Gets and puts in an order of its own; false if anything wrong was served. */
static bool hammer(Cache *cache, unsigned seed, int rounds)
{
    char wanted[8192];
    for (int i = 0; i < rounds; i++) {
        seed = seed * 1664525 + 1013904223;
        uint64_t n = (seed >> 16) % KEYS;
        size_t size = blob_of(n, wanted), got;
        char *bytes = cache_get(cache, key_of(n), &got);
        bool fine = !bytes || (got == size && !memcmp(bytes, wanted, size));
        free(bytes);
        if (!fine)
            return false;
        if (!bytes || seed >> 28 == 0)
            cache_put(cache, key_of(n), wanted, size);
    }
    return true;
}

/* A limit that a part of the keys exceeds, so that all of them trim, too. */
static void many_processes_share_a_folder(void **state)
{
    const Folder *folder = *state;
    const uint64_t limit = 60000;
    int wrong = 0, status;
    for (unsigned i = 0; i < PROCESSES; i++) {
        pid_t child = fork();
        assert_true(child >= 0);
        if (child)
            continue;
        const char *why;
        bool fine = true;
        for (unsigned run = 0; run < 4 && fine; run++) {
            Cache *cache = cache_open(folder->path, limit, &why);
            fine = cache && hammer(cache, i * 4 + run, ROUNDS) && !cache_trouble(cache);
            cache_close(cache);
        }
        _exit(!fine);
    }
    for (int i = 0; i < PROCESSES; i++)
        wrong += wait(&status) < 0 || status != 0;
    assert_int_equal(wrong, 0);
    cache_close(open_cache(folder, limit));
    assert_true((uint64_t)statistic(folder, "bytes") <= limit);
    assert_int_equal(statistic(folder, "hits") + statistic(folder, "misses"), PROCESSES * 4 * ROUNDS);
    assert_int_equal(statistic(folder, "damaged"), 0);
    assert_true(statistic(folder, "removed") > 0);
    assert_int_equal(statistic(folder, "failed"), 0);
}

typedef struct {
    Cache *cache;
    unsigned seed;
    bool fine;
} Worker;

static void *work(void *data)
{
    Worker *worker = data;
    worker->fine = hammer(worker->cache, worker->seed, 4 * ROUNDS);
    return NULL;
}

static void many_threads_share_a_cache(void **state)
{
    pthread_t threads[PROCESSES];
    Worker workers[PROCESSES];
    Cache *cache = open_cache(*state, 60000);
    for (unsigned i = 0; i < PROCESSES; i++) {
        workers[i] = (Worker){cache, i, false};
        assert_int_equal(pthread_create(&threads[i], NULL, work, &workers[i]), 0);
    }
    for (int i = 0; i < PROCESSES; i++) {
        pthread_join(threads[i], NULL);
        assert_true(workers[i].fine);
    }
    assert_null(cache_trouble(cache));
    cache_close(cache);
    assert_true(statistic(*state, "bytes") <= 60000);
    assert_int_equal(statistic(*state, "hits") + statistic(*state, "misses"), PROCESSES * 4 * ROUNDS);
}

static void set_age(const Folder *folder, uint64_t n, int seconds)
{
    struct timespec then[2] = {{time(NULL) - seconds, 0}, {time(NULL) - seconds, 0}};
    assert_int_equal(utimensat(AT_FDCWD, entry_path(folder, key_of(n)), then, 0), 0);
}

/* Ten entries of 100 bytes, aged in an order of their own; one that is old is used. */
static void the_least_recently_used_go_first(void **state)
{
    enum { ENTRIES = 10, SIZE = 100 - HEADER, USED = 3 };
    static const int rank[ENTRIES] = {4, 9, 0, 7, 2, 8, 1, 6, 3, 5}; /* 9 is the oldest */
    const Folder *folder = *state;
    char bytes[SIZE] = {0};
    Cache *cache = open_cache(folder, 0);
    for (uint64_t i = 0; i < ENTRIES; i++) {
        cache_put(cache, key_of(i), bytes, SIZE);
        set_age(folder, i, 1000 + 100 * rank[i]);
    }
    assert_hit(cache, key_of(USED), bytes, SIZE);
    cache_close(cache);
    cache_close(open_cache(folder, 600)); /* to 600 - 60 or below: five stay */
    assert_int_equal(statistic(folder, "entries"), 5);
    assert_int_equal(statistic(folder, "removed"), 5);
    cache = open_cache(folder, 0);
    for (uint64_t i = 0; i < ENTRIES; i++) {
        if (i == USED || rank[i] < 4)
            assert_hit(cache, key_of(i), bytes, SIZE);
        else
            assert_miss(cache, key_of(i));
    }
    cache_close(cache);
}

static void the_limit_holds_while_a_run_goes_on(void **state)
{
    const Folder *folder = *state;
    const uint64_t limit = 20000;
    char bytes[1000] = {0};
    Cache *cache = open_cache(folder, limit);
    for (uint64_t i = 0; i < 200; i++) {
        cache_put(cache, key_of(i), bytes, sizeof bytes);
        assert_true((uint64_t)statistic(folder, "bytes") <= limit);
        assert_hit(cache, key_of(i), bytes, sizeof bytes);
    }
    char *large = calloc(1, limit);
    cache_put(cache, key_of(1000), large, limit); /* would push out all others */
    free(large);
    assert_miss(cache, key_of(1000));
    cache_close(cache);
    assert_true(statistic(folder, "bytes") > (long)limit / 2);
    assert_int_equal(statistic(folder, "limit"), limit);
    assert_int_equal(statistic(folder, "failed"), 1);
}

/* Only the cache's own files are ever removed; its temporaries without a writer are. */
static void trimming_leaves_other_files_alone(void **state)
{
    const Folder *folder = *state;
    char path[2 * PATH_ROOM], stale[2 * PATH_ROOM], fresh[2 * PATH_ROOM];
    Cache *cache = open_cache(folder, 0);
    cache_put(cache, (Key){0, 0}, blob, sizeof blob);
    snprintf(path, sizeof path, "%s/00/holiday.jpg", folder->path);
    snprintf(stale, sizeof stale, "%s/00/.tmp12-3", folder->path);
    snprintf(fresh, sizeof fresh, "%s/00/.tmp12-4", folder->path);
    write_bytes(path, blob, sizeof blob);
    write_bytes(stale, blob, sizeof blob);
    write_bytes(fresh, blob, sizeof blob);
    struct timespec then[2] = {{time(NULL) - 7200, 0}, {time(NULL) - 7200, 0}};
    assert_int_equal(utimensat(AT_FDCWD, stale, then, 0), 0);
    cache_close(cache);
    cache_close(open_cache(folder, 1));
    assert_int_equal(access(path, F_OK), 0);
    assert_int_equal(access(fresh, F_OK), 0);
    assert_int_equal(access(stale, F_OK), -1);
    assert_int_equal(statistic(folder, "entries"), 0);
}

/* In a process that is not the superuser's, to whom every folder is open. */
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
    bool fine = bytes && size == sizeof blob && cache_trouble(cache) && !cache_get(cache, key_of(9), &size);
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

/* As on a full disk: writing ends after some bytes. */
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
    bool fine = small && size == 1000 && cache_trouble(cache) && !cache_get(cache, key_of(10), &size);
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
    char path[PATH_ROOM];
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

static void damaged_statistics_are_no_fault(void **state)
{
    static const char *const texts[] = {"", "hits", "hits -1\nbytes x\n", "\xff\xfe",
                                        "bytes 99999999999999999999999999\n"};
    const Folder *folder = *state;
    char path[2 * PATH_ROOM];
    snprintf(path, sizeof path, "%s/statistics", folder->path);
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        Cache *cache = open_cache(folder, 1000);
        write_bytes(path, texts[i], strlen(texts[i]));
        cache_put(cache, key_of(i), blob, sizeof blob);
        assert_hit(cache, key_of(i), blob, sizeof blob);
        cache_close(cache);
        assert_int_equal(statistic(folder, "entries"), i + 1);
    }
    char tag[2 * PATH_ROOM], text[64] = {0};
    snprintf(tag, sizeof tag, "%s/CACHEDIR.TAG", folder->path);
    read_bytes(tag, text, sizeof text - 1);
    assert_int_equal(strncmp(text, "Signature: 8a477f597d28d172789f06886806bc55\n", 44), 0);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, make_folder, remove_folder)
    const struct CMUnitTest tests[] = {
        TEST(what_was_put_is_found_by_every_run),
        TEST(keys_that_differ_in_a_bit_are_different),
        TEST(an_entry_with_any_byte_changed_is_not_served),
        TEST(an_entry_of_another_length_is_not_served),
        TEST(a_foreign_entry_is_not_served),
        TEST(many_processes_share_a_folder),
        TEST(many_threads_share_a_cache),
        TEST(the_least_recently_used_go_first),
        TEST(the_limit_holds_while_a_run_goes_on),
        TEST(trimming_leaves_other_files_alone),
        TEST(a_read_only_folder_serves_what_it_has),
        TEST(a_full_folder_loses_nothing_else),
        TEST(what_is_no_folder_is_refused),
        TEST(damaged_statistics_are_no_fault),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
