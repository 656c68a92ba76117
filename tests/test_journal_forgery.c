/* A journal written by somebody who knows how, or carried elsewhere: the next run renames and removes nothing that no run made. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/journal/world.h"
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* -- written by somebody who knows how: magic, the journal's inode, count, steps, hash */

typedef struct {
    const char *magic;
    uint32_t count;
    uint64_t moved; /* from the journal's inode */
    Step steps[2];
} Forged;

static void forge(const World *w, const Forged *f)
{
    Bytes bytes = {0};
    struct stat info;
    assert_int_equal(stat(world_at(w, "out/.matc-commit/journal"), &info), 0);
    uint64_t own = info.st_ino + f->moved;
    bytes_add(&bytes, f->magic, 8);
    bytes_add(&bytes, &own, sizeof own);
    bytes_number(&bytes, f->count);
    for (int i = 0; i < 2 && f->steps[i].name; i++) {
        bytes_number(&bytes, f->steps[i].kind);
        bytes_number(&bytes, (uint32_t)f->steps[i].number);
        bytes_add(&bytes, &f->steps[i].hash, sizeof(Key));
        bytes_text(&bytes, f->steps[i].name);
    }
    Key hash = key_of_bytes(bytes.at, bytes.size);
    bytes_add(&bytes, &hash, sizeof hash);
    world_put_journal(w, bytes.at, bytes.size);
    bytes_free(&bytes);
}

/* Whatever the step, and whether it has a file to bring or the hash of the one that is there. */
static void names_outside_the_folder_are_refused(void **state)
{
    World *w = *state;
    char absolute[2 * PATH_ROOM];
    const char *const names[] = {
        "../beside.frag", absolute, "sub/below.frag", "./notes.txt", "sub/", "/", "..", ".", ""};
    strcpy(absolute, world_at(w, "beside.frag"));
    world_put(w, "out/.matc-commit/7.old", "planted");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (int kind = 0; kind < STEP_KINDS; kind++)
            for (int number = 7; number <= 8; number++) {
                const Step step = {(StepKind)kind, number, world_hash("precious"), names[i]};
                forge(w, &(Forged){"matc jr2", 1, 0, {step}});
                world_assert_refused(w, "damaged");
            }
}

static void one_that_counts_wrong_is_refused(void **state)
{
    World *w = *state;
    const Step step = {STEP_put, 8, world_hash("other"), "notes.txt"}, none = {STEP_KINDS, 8, {0, 0}, "notes.txt"},
               negative = {STEP_put, -1, {0, 0}, "notes.txt"};
    const Forged all[] = {
        {"matc jr2", 2, 0, {step}},           {"matc jr2", 0, 0, {step}}, {"matc jr2", UINT32_MAX, 0, {step}},
        {"matc jr2", 1u << 31, 0, {step}},    {"matc jr2", 1, 0, {none}}, {"matc jr2", 1, 0, {negative}},
        {"matc jr2", 2, 0, {step, negative}}, {"matc jr1", 1, 0, {step}}, {"matc jr3", 1, 0, {step}}};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        forge(w, &all[i]);
        world_assert_refused(w, "damaged");
    }
}

/* Names of files that no run made: only bytes tell whether one did. */
static void what_a_run_did_not_write_stays(void **state)
{
    World *w = *state;
    world_put(w, "out/.matc-commit/7.old", "planted");
    for (int kind = 0; kind < STEP_KINDS; kind++)
        for (int number = 7; number <= 8; number++) {
            const Step step = {(StepKind)kind, number, world_hash("other"), "notes.txt"};
            if (!world_is_there(w, "out/.matc-commit"))
                world_end_a_run(w);
            world_put(w, "out/.matc-commit/7.old", "planted");
            forge(w, &(Forged){"matc jr2", 1, 0, {step}});
            assert_null(steps_recover(w->out));
            assert_true(world_has(w, "out/notes.txt", "precious"));
            assert_false(world_is_there(w, "out/.matc-commit"));
        }
}

/* Folders that matc makes, or anybody, under the names of files. */
static void folders_stay(void **state)
{
    static const char *const names[] = {"sub", ".matc-commit"};
    World *w = *state;
    for (int i = 0; i < 2; i++)
        for (int kind = 0; kind < STEP_KINDS; kind++) {
            if (!world_is_there(w, "out/.matc-commit"))
                world_end_a_run(w);
            world_put(w, "out/.matc-commit/7.old", "planted");
            forge(w, &(Forged){"matc jr2", 1, 0, {{(StepKind)kind, 7, {0, 0}, names[i]}}});
            assert_null(steps_recover(w->out));
            assert_true(world_has(w, "out/sub/below.frag", "precious"));
            assert_false(world_is_there(w, "out/.matc-commit"));
        }
}

/* -- carried elsewhere */

/* A copy of the whole folder, as archives make it. */
static void a_copy_of_a_journal_is_refused(void **state)
{
    World *w = *state;
    char command[4 * PATH_ROOM];
    forge(w, &(Forged){"matc jr2", 1, 1, {{STEP_put, 8, world_hash("precious"), "notes.txt"}}});
    world_assert_refused(w, "copy");
    world_put_journal(w, w->journal, w->size);
    snprintf(command, sizeof command, "cp -rp '%s/out' '%s/copy'", w->root, w->root);
    assert_int_equal(system(command), 0);
    int own = w->out;
    w->out = open(world_at(w, "copy"), O_RDONLY | O_DIRECTORY);
    world_assert_refused(w, "copy");
    close(w->out);
    w->out = own;
}

/* The very journal in a folder with other files of these names: they stay as they are. */
static void a_journal_that_was_moved_harms_no_other_folder(void **state)
{
    static const char *const names[] = {"other/changed.frag", "other/coming.frag", "other/going.frag",
                                        "other/manifest.json"};
    World *w = *state;
    mkdir(world_at(w, "other"), 0777);
    for (int i = 0; i < 4; i++)
        world_put(w, names[i], "precious");
    assert_int_equal(rename(world_at(w, "out/.matc-commit"), world_at(w, "other/.matc-commit")), 0);
    int other = open(world_at(w, "other"), O_RDONLY | O_DIRECTORY);
    assert_null(steps_recover(other));
    close(other);
    for (int i = 0; i < 4; i++)
        assert_true(world_has(w, names[i], "precious"));
    assert_false(world_is_there(w, "other/.matc-commit"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        WORLD_TEST(names_outside_the_folder_are_refused), WORLD_TEST(one_that_counts_wrong_is_refused),
        WORLD_TEST(what_a_run_did_not_write_stays),       WORLD_TEST(folders_stay),
        WORLD_TEST(a_copy_of_a_journal_is_refused),       WORLD_TEST(a_journal_that_was_moved_harms_no_other_folder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
