/* Commits that a process left half done, and their completion by the next process
 * (staging_commit.c). */
#include "tests/test.h"
#include "compiler/base/staging/staging.h"
#include "compiler/base/staging/staging_commit.h"
#include "tests/value/folder.h"
#include "tests/value/read_whole.h"
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { PATH_CAPACITY = 512 };
enum { TICK_NS = 20000000 }; /* longer than a step of the file system's clock */

/* The output folder of a run that ended after it wrote its list of intents: replace "old" by "new"
 * in a.frag, remove b.frag, replace the manifest. */
typedef struct {
    char path[PATH_CAPACITY / 2];
    int folder;
    Stage stage;
} Interrupted;

static void write_text(const Interrupted *run, const char *name, const char *text)
{
    char path[PATH_CAPACITY];
    snprintf(path, sizeof path, "%s/%s", run->path, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static void assert_file(const Interrupted *run, const char *name, const char *wanted)
{
    char path[PATH_CAPACITY];
    size_t size;
    snprintf(path, sizeof path, "%s/%s", run->path, name);
    char *text = read_whole(path, &size);
    if (wanted)
        assert_string_equal(text ? text : "absent", wanted);
    else
        assert_null(text);
    free(text);
}

static void add_list(const Interrupted *run)
{
    Bytes intents = {0};
    intent_add(&intents, &(Intent){.kind = INTENT_hide, .number = 1, .name = "manifest.json"});
    intent_add(&intents, &(Intent){.kind = INTENT_put, .number = 0, .name = "a.frag"});
    intent_add(
        &intents,
        &(Intent){.kind = INTENT_remove, .hash = key_of_bytes("stale", 5), .name = "b.frag"});
    intent_add(&intents, &(Intent){.kind = INTENT_put, .number = 1, .name = "manifest.json"});
    assert_null(intents_write(&run->stage, &intents));
    bytes_free(&intents);
}

static int interrupt(void **state)
{
    Interrupted *run = calloc(1, sizeof *run);
    *state = run;
    strcpy(run->path, "/tmp/matc_stagingXXXXXX");
    if (!mkdtemp(run->path))
        return -1;
    run->folder = open(run->path, O_RDONLY | O_DIRECTORY);
    write_text(run, "a.frag", "old");
    write_text(run, "b.frag", "stale");
    write_text(run, "manifest.json", "old index");
    nanosleep(&(struct timespec){0, TICK_NS}, NULL);
    assert_null(stage_make(&run->stage, run->folder));
    assert_null(stage_write(&run->stage, "0", "new", 3));
    assert_null(stage_write(&run->stage, "1", "new index", 9));
    add_list(run);
    nanosleep(&(struct timespec){0, TICK_NS}, NULL);
    return 0;
}

static int discard(void **state)
{
    Interrupted *run = *state;
    close(run->folder);
    folder_remove(run->path);
    free(run);
    return 0;
}

/* Opens and closes the folder as a next run that writes nothing. Returns NULL or its fault. */
static const char *open_next(const Interrupted *run)
{
    const char *why;
    staging_close(staging_open(run->path, 0, &why));
    return why;
}

static bool is_staged(const Interrupted *run)
{
    return !faccessat(run->folder, run->stage.name, F_OK, 0);
}

static void the_next_run_finishes_it(void **state)
{
    Interrupted *run = *state;
    stage_leave(&run->stage);
    assert_null(open_next(run));
    assert_file(run, "a.frag", "new");
    assert_file(run, "b.frag", NULL);
    assert_file(run, "manifest.json", "new index");
    assert_false(is_staged(run));
}

/* All moves are already done, and the list is still there. */
static void what_is_done_is_not_done_again(void **state)
{
    Interrupted *run = *state;
    unlinkat(run->folder, "manifest.json", 0);
    renameat(run->stage.at, "0", run->folder, "a.frag");
    unlinkat(run->folder, "b.frag", 0);
    renameat(run->stage.at, "1", run->folder, "manifest.json");
    stage_leave(&run->stage);
    assert_null(open_next(run));
    assert_file(run, "a.frag", "new");
    assert_file(run, "manifest.json", "new index");
    assert_false(is_staged(run));
}

static void a_file_that_came_since_stays(void **state)
{
    Interrupted *run = *state;
    unlinkat(run->folder, "manifest.json", 0); /* where a kill would leave it */
    stage_leave(&run->stage);
    write_text(run, "a.frag", "by hand");
    write_text(run, "b.frag", "by hand, too");
    assert_null(open_next(run));
    assert_file(run, "a.frag", "by hand");
    assert_file(run, "b.frag", "by hand, too");
    assert_file(run, "manifest.json", "new index");
}

static void a_run_that_lives_is_left_alone(void **state)
{
    Interrupted *run = *state;
    assert_null(open_next(run));
    assert_file(run, "a.frag", "old");
    assert_true(is_staged(run));
    stage_leave(&run->stage);
}

static void a_folder_of_somebody_else_is_left_alone(void **state)
{
    Interrupted *run = *state;
    if (fchown(run->stage.at, 65534, (gid_t)-1)) {
        print_message("skipped: only root can give a folder away\n");
        stage_leave(&run->stage);
        return;
    }
    stage_leave(&run->stage);
    assert_null(open_next(run));
    assert_file(run, "a.frag", "old");
    assert_true(is_staged(run));
}

/* A damaged list is an error at once, and no file changes. */
static void assert_refused(const Interrupted *run)
{
    const char *why = open_next(run);
    assert_non_null(why);
    assert_non_null(strstr(why, "damaged"));
    assert_file(run, "a.frag", "old");
    assert_file(run, "b.frag", "stale");
    assert_file(run, "manifest.json", "old index");
    assert_true(is_staged(run));
}

static void a_list_that_cannot_be_read_is_an_error(void **state)
{
    Interrupted *run = *state;
    unlinkat(run->stage.at, "intents", 0);
    mkdirat(run->stage.at, "intents", 0700);
    stage_leave(&run->stage);
    assert_refused(run);
}

static void a_pipe_for_a_list_is_an_error(void **state)
{
    Interrupted *run = *state;
    unlinkat(run->stage.at, "intents", 0);
    assert_int_equal(mkfifoat(run->stage.at, "intents", 0600), 0);
    stage_leave(&run->stage);
    assert_refused(run);
}

static void a_name_outside_the_folder_is_an_error(void **state)
{
    Interrupted *run = *state;
    Bytes intents = {0};
    intent_add(&intents, &(Intent){.kind = INTENT_put, .number = 0, .name = "../outside"});
    assert_null(intents_write(&run->stage, &intents));
    bytes_free(&intents);
    stage_leave(&run->stage);
    assert_refused(run);
}

static void an_intent_of_no_kind_is_an_error(void **state)
{
    Interrupted *run = *state;
    Bytes intents = {0};
    intent_add(&intents, &(Intent){.kind = INTENT_KINDS, .number = 0, .name = "a.frag"});
    assert_null(intents_write(&run->stage, &intents));
    bytes_free(&intents);
    stage_leave(&run->stage);
    assert_refused(run);
}

#define STAGING_TEST(name) cmocka_unit_test_setup_teardown(name, interrupt, discard)
int main(void)
{
    const struct CMUnitTest tests[] = {
        STAGING_TEST(the_next_run_finishes_it),
        STAGING_TEST(what_is_done_is_not_done_again),
        STAGING_TEST(a_file_that_came_since_stays),
        STAGING_TEST(a_run_that_lives_is_left_alone),
        STAGING_TEST(a_folder_of_somebody_else_is_left_alone),
        STAGING_TEST(a_list_that_cannot_be_read_is_an_error),
        STAGING_TEST(a_pipe_for_a_list_is_an_error),
        STAGING_TEST(a_name_outside_the_folder_is_an_error),
        STAGING_TEST(an_intent_of_no_kind_is_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
