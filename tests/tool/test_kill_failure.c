/* Makes each call of a run fail in turn, alone and as on a full disk, and runs on a read-only
 * disk. */
/* ctest: alone seconds=54 */
#include "tests/test.h"
#include "tests/kill/world.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>

/* A run that reports a failure has changed nothing, or it failed while it moved files: then the
 * manifest, if there is one, matches the files, and the next run finishes the moves. A run that
 * reports no failure has written all of its files. */
static void check_failure(World *w, const Strike *at)
{
    const Scenario *s = at->scenario;
    int status = world_run(w, s->run, at->n, at->how);
    bool unchanged = status == 1 && world_is(w, &w->before, true);
    if (status == 1)
        world_check(w, world_says(w, "error: "), at, "it does not say why");
    else
        world_check(w, status == 0 && world_is(w, &w->after, false), at, "it left another folder");
    if (unchanged || (!status && world_is(w, &w->after, true)))
        return;
    w->left += !status;
    w->halves += status == 1;
    world_check(w,
                status == 0 || strcmp(w->calls[at->n], "renameat") == 0 ||
                    strcmp(w->calls[at->n], "unlinkat") == 0,
                at, "it failed elsewhere than in the middle of its moves");
    world_check(w, !s->index || world_index_is_true(w), at, "the manifest is not true");
    world_check(w, world_run(w, s->run, 0, NULL) == 0 && world_is(w, &w->after, true), at,
                "the next run does not make it good");
}

/* Calls that fail on a full disk. */
static const char *const grows[] = {"openat",    "write",  "mkdir",  "mkdirat", "linkat",
                                    "fdatasync", "writev", "pwrite", NULL};

static void a_run_of_which_a_call_fails_does_nothing_or_is_finished_by_the_next(void **state)
{
    static const int errors[] = {ENOSPC, EIO, EACCES};
    World *w = *state;
    char how[16];
    for (int i = 0; i < SCENARIOS; i++) {
        const Scenario *s = &scenarios[i];
        world_prepare(w, s);
        w->left = w->halves = 0;
        for (long n = 1; n <= w->call_count; n += STRIKE_STEP) {
            snprintf(how, sizeof how, "%d", errors[n % 3]);
            world_reset(w);
            check_failure(w, &(Strike){s, n, how});
            if (!call_is_one_of(w->calls[n], grows))
                continue;
            world_reset(w);
            check_failure(w, &(Strike){s, n, "full"});
        }
        printf("%s: %ld calls failed, %d of them among the moves, %d while it removed what it had "
               "used\n",
               s->name, w->call_count, w->halves, w->left);
    }
    assert_int_equal(w->wrong, 0);
}

/* An unchanged batch only reads: its folder may belong to another user, or be on a read-only
 * disk. */
static void an_unchanged_batch_writes_nothing(void **state)
{
    World *w = *state;
    for (int i = 0; i < SCENARIOS; i++) {
        const Scenario *s = &scenarios[i];
        if (!s->index || s->cache ||
            !strcmp(s->name, "a batch with textures and a depfile elsewhere"))
            continue;
        world_prepare(w, s);
        const Strike at = {s, 1, "of a disk that is not written"};
        world_check(w, world_run(w, s->run, 1, "readonly") == 0, &at, "it fails");
        world_check(w, world_is(w, &w->after, true), &at, "it changes something");
    }
    assert_int_equal(w->wrong, 0);
}

/* A test's name, or a part of it and *: that one alone. */
int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        WORLD_TEST(an_unchanged_batch_writes_nothing),
        WORLD_TEST(a_run_of_which_a_call_fails_does_nothing_or_is_finished_by_the_next),
    };
    cmocka_set_test_filter(argc > 1 ? argv[1] : NULL);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
