/* A run was ended in the middle of moving its files, and its journal was damaged before the next run reads it. That run undoes all or
 * refuses and touches nothing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/journal/world.h"
#include <string.h>
#include <unistd.h>

static void a_whole_journal_is_undone(void **state)
{
    World *w = *state;
    assert_true(world_has(w, "out/changed.frag", CHANGED) && world_has(w, "out/coming.frag", COMING));
    assert_true(world_has(w, "out/manifest.json", MANIFEST) && !world_is_there(w, "out/going.frag"));
    assert_null(steps_recover(w->out));
    world_assert_is(w, &w->before);
}

static void an_empty_one_is_of_a_run_that_was_done(void **state)
{
    World *w = *state;
    world_put_journal(w, "", 0);
    assert_null(steps_recover(w->out));
    assert_true(world_has(w, "out/changed.frag", CHANGED) && world_has(w, "out/coming.frag", COMING));
    assert_true(world_has(w, "out/manifest.json", MANIFEST) && !world_is_there(w, "out/going.frag"));
    assert_false(world_is_there(w, "out/.matc-commit"));
}

static void one_that_was_cut_is_refused(void **state)
{
    World *w = *state;
    for (size_t size = 1; size < w->size; size++) {
        world_put_journal(w, w->journal, size);
        world_assert_refused(w, "damaged");
    }
    world_put_journal(w, w->journal, w->size);
    assert_null(steps_recover(w->out));
    world_assert_is(w, &w->before);
}

static void one_with_a_bit_turned_is_refused(void **state)
{
    World *w = *state;
    for (size_t bit = 0; bit < 8 * w->size; bit++) {
        w->journal[bit / 8] ^= (char)(1 << bit % 8);
        world_put_journal(w, w->journal, w->size);
        world_assert_refused(w, "damaged");
        w->journal[bit / 8] ^= (char)(1 << bit % 8);
    }
}

static void one_with_something_behind_it_is_refused(void **state)
{
    World *w = *state;
    char longer[1 << 12] = "";
    memcpy(longer, w->journal, w->size);
    for (size_t more = 1; more < 64; more++) {
        world_put_journal(w, longer, w->size + more);
        world_assert_refused(w, "damaged");
    }
}

enum { JOURNAL_LIMIT = 64 << 20 };

static void files_that_are_no_journals_are_refused(void **state)
{
    static const char *const texts[] = {
        "{", "\n", "matc jr1", "matc jr2", "#!/bin/sh\n", "{\"files\": {}}\n", "put out/notes.txt by manifest.json"};
    World *w = *state;
    char zeros[1 << 12] = "";
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        world_put_journal(w, texts[i], strlen(texts[i]));
        world_assert_refused(w, "damaged");
    }
    world_put_journal(w, zeros, sizeof zeros);
    world_assert_refused(w, "damaged");
    assert_int_equal(truncate(world_at(w, "out/.matc-commit/journal"), (off_t)JOURNAL_LIMIT + 1), 0);
    world_assert_refused(w, "damaged");
    assert_int_equal(truncate(world_at(w, "out/.matc-commit/journal"), (off_t)1 << 40), 0);
    world_assert_refused(w, "damaged");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        WORLD_TEST(a_whole_journal_is_undone),
        WORLD_TEST(an_empty_one_is_of_a_run_that_was_done),
        WORLD_TEST(one_that_was_cut_is_refused),
        WORLD_TEST(one_with_a_bit_turned_is_refused),
        WORLD_TEST(one_with_something_behind_it_is_refused),
        WORLD_TEST(files_that_are_no_journals_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
