/* File watching: every kind of change to a file is noticed once, by notifications and by polling
 * alone. */
#include "tests/test.h"
#include "compiler/base/watch.h"
#include "tests/value/folder.h"
#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { PATH_CAPACITY = 128, FILES = 4, LONG_MS = 5000, SHORT_MS = 120 };

typedef struct {
    char root[PATH_CAPACITY / 2];
    char paths[FILES][PATH_CAPACITY]; /* a, b, below/c, link: the last leads to elsewhere/d */
    const char *list[FILES];
    bool poll_only;
} Fixture;

static void sleep_ms(int ms)
{
    nanosleep(&(struct timespec){ms / 1000, ms % 1000 * 1000000L}, NULL);
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec * 1e3 + (double)time.tv_nsec * 1e-6;
}

static void put(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

/* Replaces a file as editors save: by rename. */
static void replace(const char *path, const char *text)
{
    char beside[PATH_CAPACITY + 8];
    snprintf(beside, sizeof beside, "%s.new", path);
    put(beside, text);
    assert_int_equal(rename(beside, path), 0);
}

static const char *in_root(const Fixture *f, const char *name)
{
    static char path[2 * PATH_CAPACITY];
    snprintf(path, sizeof path, "%s/%s", f->root, name);
    return path;
}

static int make(void **state, bool poll_only)
{
    static const char *const names[FILES] = {"a", "b", "below/c", "link"};
    Fixture *f = calloc(1, sizeof *f);
    *state = f;
    f->poll_only = poll_only;
    strcpy(f->root, "/tmp/matc_watchXXXXXX");
    if (!mkdtemp(f->root) || mkdir(in_root(f, "below"), 0700) ||
        mkdir(in_root(f, "elsewhere"), 0700))
        return -1;
    put(in_root(f, "elsewhere/d"), "d");
    for (int i = 0; i < FILES; i++) {
        snprintf(f->paths[i], PATH_CAPACITY, "%s/%s", f->root, names[i]);
        f->list[i] = f->paths[i];
        if (i < FILES - 1)
            put(f->paths[i], names[i]);
    }
    if (symlink("elsewhere/d", f->paths[FILES - 1]))
        return -1;
    sleep_ms(40); /* so that these are older than the watch */
    return 0;
}

static int make_with_notices(void **state) { return make(state, false); }
static int make_without(void **state) { return make(state, true); }

static int remove_all(void **state)
{
    Fixture *f = *state;
    folder_remove(f->root);
    free(f);
    return 0;
}

static Watch *open_watch(const Fixture *f, int count)
{
    Watch *watch = watch_open();
    if (f->poll_only)
        watch_poll_only(watch);
    watch_set(watch, f->list, count);
    return watch;
}

/* Waits and finds exactly the file of that index, and then nothing more. */
static void assert_change(Watch *watch, int file)
{
    assert_int_equal(watch_wait(watch, LONG_MS), 1);
    for (int i = 0; i < FILES; i++)
        assert_int_equal(watch_changed(watch, i), i == file);
}

static void assert_quiet(Watch *watch) { assert_int_equal(watch_wait(watch, SHORT_MS), 0); }

static void every_kind_of_change_is_seen_once(void **state)
{
    const Fixture *f = *state;
    Watch *watch = open_watch(f, FILES);
    assert_quiet(watch);
    put(f->paths[0], "more than before");
    assert_change(watch, 0);
    replace(f->paths[1], "b"); /* of the same size */
    assert_change(watch, 1);
    unlink(f->paths[1]);
    assert_change(watch, 1);
    put(f->paths[1], "again");
    assert_change(watch, 1);
    put(f->paths[2], "below");
    assert_change(watch, 2);
    put(in_root(f, "elsewhere/d"), "through a link");
    assert_change(watch, 3);
    assert_int_equal(chmod(f->paths[0], 0600), 0); /* may be readable now */
    assert_change(watch, 0);
    assert_quiet(watch);
    put(in_root(f, "other"), "is of no interest");
    assert_quiet(watch);
    watch_close(watch);
}

static void a_file_that_is_not_there_yet_is_waited_for(void **state)
{
    Fixture *f = *state;
    snprintf(f->paths[0], PATH_CAPACITY, "%s/x/y/z", f->root);
    Watch *watch = open_watch(f, 1);
    assert_quiet(watch);
    assert_int_equal(mkdir(in_root(f, "x"), 0700), 0);
    assert_quiet(watch);
    assert_int_equal(mkdir(in_root(f, "x/y"), 0700), 0);
    assert_quiet(watch);
    put(f->paths[0], "z");
    assert_change(watch, 0);
    assert_quiet(watch);
    watch_close(watch);
}

static void a_folder_may_go_and_come(void **state)
{
    const Fixture *f = *state;
    char away[2 * PATH_CAPACITY];
    snprintf(away, sizeof away, "%s", in_root(f, "away"));
    Watch *watch = open_watch(f, FILES);
    assert_int_equal(rename(in_root(f, "below"), away), 0);
    assert_change(watch, 2);
    assert_quiet(watch);
    assert_int_equal(mkdir(in_root(f, "below"), 0700), 0);
    put(f->paths[2], "another one");
    assert_change(watch, 2);
    put(f->paths[2], "changed in the new folder");
    assert_change(watch, 2);
    put(in_root(f, "away/c"), "no longer of interest");
    assert_quiet(watch);
    unlink(f->paths[2]);
    rmdir(in_root(f, "below"));
    assert_change(watch, 2);
    watch_close(watch);
}

static void *save_in_a_row(void *data)
{
    const Fixture *f = data;
    char text[32] = "";
    for (int i = 0; i < 10; i++) {
        sleep_ms(15);
        strcat(text, "x");
        put(f->paths[i % 2], text);
    }
    return NULL;
}

/* One report, or a few if the machine is too busy to save that fast; not ten. */
static void a_row_of_changes_is_one(void **state)
{
    Fixture *f = *state;
    pthread_t thread;
    bool seen[2] = {false, false};
    int reports = 0;
    Watch *watch = open_watch(f, FILES);
    assert_int_equal(pthread_create(&thread, NULL, save_in_a_row, f), 0);
    while (watch_wait(watch, 1000) > 0) {
        reports++;
        for (int i = 0; i < 2; i++)
            seen[i] |= watch_changed(watch, i);
    }
    pthread_join(thread, NULL);
    assert_true(seen[0] && seen[1]);
    assert_in_range(reports, 1, 3);
    watch_close(watch);
}

/* A file that changes while it is read is reported by the next wait, whether it is known or new. */
static void nothing_is_missed_between_two_waits(void **state)
{
    const Fixture *f = *state;
    Watch *watch = open_watch(f, 2);
    put(f->paths[0], "the first change");
    assert_int_equal(watch_wait(watch, LONG_MS), 1);
    put(f->paths[0], "while it is read");
    sleep_ms(40);
    put(f->paths[2], "a file that is read for the first time");
    watch_set(watch, f->list, FILES);
    assert_int_equal(watch_wait(watch, LONG_MS), 2);
    assert_true(watch_changed(watch, 0) && watch_changed(watch, 2));
    assert_quiet(watch);
    watch_set(watch, f->list + 1, 2); /* of the first, nothing more */
    put(f->paths[0], "unwatched");
    assert_quiet(watch);
    watch_set(watch, f->list, 0);
    assert_quiet(watch);
    watch_close(watch);
}

static void a_wait_ends_in_time(void **state)
{
    const Fixture *f = *state;
    Watch *watch = open_watch(f, FILES);
    double start = now();
    assert_int_equal(watch_wait(watch, 0), 0);
    assert_true(now() - start < 50);
    assert_int_equal(watch_wait(watch, 150), 0);
    assert_true(now() - start >= 150);
    watch_close(watch);
}

/* A write of the same size in the same tick of the clock: only the notice reveals it. */
static void a_write_that_does_not_show_is_seen(void **state)
{
    const Fixture *f = *state;
    struct stat before;
    Watch *watch = open_watch(f, FILES);
    assert_int_equal(stat(f->paths[0], &before), 0);
    for (int i = 0; i < 5; i++) {
        put(f->paths[0], i % 2 ? "a" : "A");
        const struct timespec times[2] = {before.st_atim, before.st_mtim};
        assert_int_equal(utimensat(AT_FDCWD, f->paths[0], times, 0), 0);
        assert_change(watch, 0);
    }
    watch_close(watch);
}

/* As copies that keep times have it: only the size is another. */
static void another_size_at_the_same_time_is_seen(void **state)
{
    const Fixture *f = *state;
    struct stat before;
    Watch *watch = open_watch(f, FILES);
    assert_int_equal(stat(f->paths[0], &before), 0);
    put(f->paths[0], "longer");
    assert_int_equal(utimensat(AT_FDCWD, f->paths[0],
                               (const struct timespec[]){before.st_atim, before.st_mtim}, 0),
                     0);
    assert_change(watch, 0);
    watch_close(watch);
}

static void *save_later(void *data)
{
    sleep_ms(100);
    put(((const Fixture *)data)->paths[0], "later");
    return NULL;
}

/* A notice is faster than the next look would be. */
static void a_notice_is_quick(void **state)
{
    Fixture *f = *state;
    pthread_t thread;
    Watch *watch = open_watch(f, FILES);
    double start = now();
    assert_int_equal(pthread_create(&thread, NULL, save_later, f), 0);
    assert_change(watch, 0);
    /* 100, 50 of quiet, and what a busy machine adds; a look comes after 1000 */
    assert_true(now() - start < 800);
    pthread_join(thread, NULL);
    watch_close(watch);
}

int main(void)
{
#define BOTH(name)                                                                                 \
    cmocka_unit_test_setup_teardown(name, make_with_notices, remove_all),                          \
        cmocka_unit_test_setup_teardown(name, make_without, remove_all)
#define NOTICES(name) cmocka_unit_test_setup_teardown(name, make_with_notices, remove_all)
    const struct CMUnitTest tests[] = {
        BOTH(every_kind_of_change_is_seen_once),
        BOTH(a_file_that_is_not_there_yet_is_waited_for),
        BOTH(a_folder_may_go_and_come),
        BOTH(a_row_of_changes_is_one),
        BOTH(nothing_is_missed_between_two_waits),
        BOTH(a_wait_ends_in_time),
        BOTH(another_size_at_the_same_time_is_seen),
#ifdef __linux__
        NOTICES(a_write_that_does_not_show_is_seen),
        NOTICES(a_notice_is_quick),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
