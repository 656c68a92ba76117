/* Kills runs before each of their system calls in turn, and in the middle of each write; then
 * the next run handles whatever was left. The expected result is that of an undisturbed run. */
/* ctest: alone seconds=26 */
#include "tests/test.h"
#include "tests/kill/world.h"
#include <fcntl.h>
#include <ftw.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

enum { OLD_SECONDS = 7200 };

/* Makes the cache's temporary files as old as abandoned ones, and its last cleanup long past. */
static bool temporary_found;
static int age(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    const struct timespec times[2] = {{.tv_sec = time(NULL) - OLD_SECONDS},
                                      {.tv_sec = time(NULL) - OLD_SECONDS}};
    (void)info;
    if (kind == FTW_F && !strncmp(path + walk->base, ".tmp", 4)) {
        temporary_found = true;
        return utimensat(AT_FDCWD, path, times, 0);
    }
    return strcmp(path + walk->base, "statistics") ? 0 : remove(path);
}

static bool age_cache(const World *w)
{
    char path[PATH_CAPACITY];
    world_path(w, "now/cache", path);
    temporary_found = false;
    nftw(path, age, 16, FTW_PHYS);
    return temporary_found;
}

static void check_after_kill(World *w, const Strike *at)
{
    const Scenario *s = at->scenario;
    world_check(w, !s->index || world_index_is_true(w), at, "the manifest is not true");
    if (!s->cache && world_is(w, &w->before, true))
        return; /* the next run is the one that was tried first */
    if (s->cache)
        age_cache(w);
    if (s->faulty[0] && at->n % 3 == 0) {
        world_check(w, world_run(w, s->faulty, 0, NULL) == 1, at, "a faulty run ends otherwise");
        world_check(w, world_is(w, &w->before, true) || world_is(w, &w->after, true), at,
                    "a faulty run leaves what is neither old nor new");
    }
    world_check(w, world_run(w, s->run, 0, NULL) == 0, at, "the next run fails");
    world_check(w, world_is(w, &w->after, true), at, "the next run leaves another folder");
    if (s->cache)
        world_check(w, !age_cache(w), at, "temporary files in the cache");
}

/* Calls that can change a folder. A kill between two of these leaves the state after the first. */
static const char *const changes[] = {"open",  "openat",    "write",  "writev",   "pwrite",
                                      "mkdir", "mkdirat",   "linkat", "renameat", "unlinkat",
                                      "rmdir", "ftruncate", NULL};

static void a_run_that_is_ended_at_any_call_is_made_good_by_the_next(void **state)
{
    World *w = *state;
    for (int i = 0; i < SCENARIOS; i++) {
        const Scenario *s = &scenarios[i];
        world_prepare(w, s);
        for (long n = 1; n <= w->call_count; n += STRIKE_STEP) {
            if (n > 1 && !call_is_one_of(w->calls[n - 1], changes))
                continue;
            Strike at = {s, n, "killed"};
            world_reset(w);
            world_check(w, world_run(w, s->run, n, "kill") == -1, &at, "it was not killed");
            check_after_kill(w, &at);
            if (strcmp(w->calls[n], "write") != 0)
                continue;
            at.how = "killed in it";
            world_reset(w);
            world_check(w, world_run(w, s->run, n, "half") == -1, &at, "it was not killed");
            check_after_kill(w, &at);
        }
        printf("%s: killed at %ld calls\n", s->name, w->call_count);
    }
    assert_int_equal(w->wrong, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        WORLD_TEST(a_run_that_is_ended_at_any_call_is_made_good_by_the_next),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
