/* The next run undoes one that was ended; what others put there since stays and keeps its name, also where the journal should be. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/journal/world.h"
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

/* -- changed in the meantime */

static void files_that_came_since_stay(void **state)
{
    static const char *const names[] = {"out/changed.frag", "out/coming.frag", "out/going.frag", "out/manifest.json"};
    World *w = *state;
    for (int which = 1; which < 16; which++) {
        if (!world_is_there(w, "out/.matc-commit"))
            world_end_a_run(w);
        for (int i = 0; i < 4; i++)
            if (which >> i & 1)
                world_put(w, names[i], "mine");
        assert_null(steps_recover(w->out));
        for (int i = 0; i < 4; i++)
            assert_int_equal(world_has(w, names[i], "mine"), which >> i & 1);
        assert_false(world_is_there(w, "out/.matc-commit"));
        for (int i = 0; i < 4; i++) /* as before the run */
            unlink(world_at(w, names[i]));
        world_put(w, names[0], "// changed.frag, old\n");
        world_put(w, names[2], "// going.frag, old\n");
        world_put(w, names[3], "{\"old\": 1}\n");
    }
}

/* A run that would renew an equal file was ended before it came to that. */
static void an_equal_file_that_was_not_replaced_yet_stays(void **state)
{
    World *w = *state;
    Waiting waiting;
    Step step = {STEP_put, 0, world_hash("precious"), "notes.txt"};
    assert_null(steps_recover(w->out));
    assert_null(waiting_make(&waiting, w->out));
    assert_null(waiting_write(&waiting, "0", "precious", strlen("precious")));
    assert_null(steps_begin(&waiting, &(Steps){&step, 1}));
    waiting_leave(&waiting);
    assert_null(steps_recover(w->out));
    world_assert_is(w, &w->before);
}

static void links_and_pipes_that_came_since_stay(void **state)
{
    World *w = *state;
    unlink(world_at(w, "out/changed.frag"));
    unlink(world_at(w, "out/coming.frag"));
    world_put(w, "beside.frag", CHANGED); /* what it leads to has the very bytes */
    assert_int_equal(symlink("../beside.frag", world_at(w, "out/changed.frag")), 0);
    assert_int_equal(mkfifo(world_at(w, "out/coming.frag"), 0666), 0);
    assert_int_equal(mkdir(world_at(w, "out/going.frag"), 0777), 0);
    Bytes beside = {0}, now = {0};
    world_add_contents(&beside, world_at(w, "out/changed.frag"), S_IFLNK);
    assert_null(steps_recover(w->out));
    world_add_contents(&now, world_at(w, "out/changed.frag"), S_IFLNK);
    assert_int_equal(beside.size, now.size);
    assert_memory_equal(beside.at, now.at, now.size);
    bytes_free(&beside);
    bytes_free(&now);
    assert_true(world_has(w, "beside.frag", CHANGED));
    assert_true(world_is_there(w, "out/coming.frag") && world_is_there(w, "out/going.frag"));
    assert_true(world_has(w, "out/manifest.json", "{\"old\": 1}\n"));
}

/* -- what is no journal at all */

static void make_socket(const char *path)
{
    struct sockaddr_un address = {.sun_family = AF_UNIX};
    int file = socket(AF_UNIX, SOCK_STREAM, 0);
    snprintf(address.sun_path, sizeof address.sun_path, "%s", path);
    assert_int_equal(bind(file, (struct sockaddr *)&address, sizeof address), 0);
    close(file);
}

/* 0: a folder, 1: a pipe, 2: a link to a file, 3: a link to nothing, 4: a socket, 5: a file. */
static void plant(const World *w, int kind, const char *name)
{
    const char *path = world_at(w, name);
    switch (kind) {
    case 0:
        assert_int_equal(mkdir(path, 0777), 0);
        break;
    case 1:
        assert_int_equal(mkfifo(path, 0666), 0);
        break;
    case 2:
    case 3:
        assert_int_equal(symlink(world_at(w, kind == 2 ? "beside.frag" : "nothing"), path), 0);
        break;
    case 4:
        make_socket(path);
        break;
    default:
        world_put(w, name, "precious");
    }
}

static void what_stands_for_a_journal_is_refused(void **state)
{
    World *w = *state;
    for (int kind = 0; kind < 5; kind++) {
        remove(world_at(w, "out/.matc-commit/journal"));
        plant(w, kind, "out/.matc-commit/journal");
        world_assert_refused(w, "move it away");
    }
}

static void what_stands_for_the_folder_is_refused(void **state)
{
    static const int kinds[] = {1, 4, 5};
    World *w = *state;
    assert_null(steps_recover(w->out));
    for (int i = 0; i < 3; i++) {
        plant(w, kinds[i], "out/.matc-commit");
        world_assert_refused(w, "move it away");
        remove(world_at(w, "out/.matc-commit"));
    }
    plant(w, 5, "out/.matc-stage-abcdef");
    waiting_clean(w->out);
    assert_true(world_has(w, "out/.matc-stage-abcdef", "precious"));
    remove(world_at(w, "out/.matc-stage-abcdef"));
    for (int kind = 2; kind <= 3; kind++) { /* a link goes, and no more */
        plant(w, kind, "out/.matc-commit");
        assert_null(steps_recover(w->out));
        world_assert_is(w, &w->before);
    }
}

/* What matc put there is seen to; the rest is said, and stays. */
static void other_files_beside_a_journal_stay(void **state)
{
    World *w = *state;
    world_put(w, "out/.matc-commit/notes.txt", "precious");
    world_put(w, "out/.matc-commit/.old", "precious");
    world_put(w, "out/.matc-commit/1.older", "precious");
    mkdir(world_at(w, "out/.matc-commit/sub"), 0777);
    for (int i = 0; i < 2; i++) {
        const char *why = steps_recover(w->out);
        assert_non_null(why);
        assert_non_null(strstr(why, "other files than matc's are in .matc-commit"));
        assert_true(world_has(w, "out/changed.frag", "// changed.frag, old\n") &&
                    world_has(w, "out/going.frag", "// going.frag, old\n"));
        assert_true(world_has(w, "out/manifest.json", "{\"old\": 1}\n") && !world_is_there(w, "out/coming.frag"));
        assert_true(world_has(w, "out/.matc-commit/notes.txt", "precious") &&
                    world_has(w, "out/.matc-commit/.old", "precious"));
        assert_true(world_has(w, "out/.matc-commit/1.older", "precious") && world_is_there(w, "out/.matc-commit/sub"));
        assert_false(world_is_there(w, "out/.matc-commit/0.old"));
    }
    unlink(world_at(w, "out/.matc-commit/notes.txt"));
    unlink(world_at(w, "out/.matc-commit/.old"));
    unlink(world_at(w, "out/.matc-commit/1.older"));
    rmdir(world_at(w, "out/.matc-commit/sub"));
    assert_null(steps_recover(w->out));
    world_assert_is(w, &w->before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        WORLD_TEST(files_that_came_since_stay),
        WORLD_TEST(an_equal_file_that_was_not_replaced_yet_stays),
        WORLD_TEST(links_and_pipes_that_came_since_stay),
        WORLD_TEST(what_stands_for_a_journal_is_refused),
        WORLD_TEST(what_stands_for_the_folder_is_refused),
        WORLD_TEST(other_files_beside_a_journal_stay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
