/* The cache used by many runs at once, and its size limit: no wrong entry is returned, and the
 * least recently used entries are evicted. */
#include "tests/test.h"
#include "tests/cache_folder.h"
#include <fcntl.h>
#include <pthread.h>
#include <stdbool.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>

enum { PROCESSES = 8, ROUNDS = 400, KEYS = 60 };

/* Blob of a key, of a length that differs from key to key. */
static size_t blob_of(uint64_t n, char *bytes)
{
    size_t size = 100 + (size_t)(n * 977 % 5000);
    for (size_t i = 0; i < size; i++)
        bytes[i] = (char)(n * 31 + i * 7);
    return size;
}

/* Gets and puts in a random order; false if a wrong entry was returned. */
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
    assert_int_equal(statistic(folder, "hits") + statistic(folder, "misses"),
                     PROCESSES * 4 * ROUNDS);
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
    assert_int_equal(statistic(*state, "hits") + statistic(*state, "misses"),
                     PROCESSES * 4 * ROUNDS);
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

/* Only the cache's own files are removed, including temporary files without a writer. */
static void trimming_leaves_other_files_alone(void **state)
{
    const Folder *folder = *state;
    char path[2 * PATH_CAPACITY], stale[2 * PATH_CAPACITY], fresh[2 * PATH_CAPACITY];
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(many_processes_share_a_folder),
        FOLDER_TEST(many_threads_share_a_cache),
        FOLDER_TEST(the_least_recently_used_go_first),
        FOLDER_TEST(the_limit_holds_while_a_run_goes_on),
        FOLDER_TEST(trimming_leaves_other_files_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
