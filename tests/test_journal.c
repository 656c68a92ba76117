/* A run was ended in the middle of moving its files, and its journal was damaged, replaced or carried elsewhere before the next run
 * reads it. That run undoes all or refuses and touches nothing; and nothing that others put there goes or changes its name. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "compiler/base/bytes.h"
#include "compiler/base/staging_journal.h"
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

enum { PATH_ROOM = 256, MOST_FILES = 64, MOST_SECONDS = 60, JOURNAL_LIMIT = 64 << 20 };

/* The folder that is written to is root/out; nothing beside it may change either. */
typedef struct {
    char root[PATH_ROOM];
    int out;
    Bytes before, ended; /* the tree below root before the run, and when it was ended */
    char *journal;
    size_t size;
} World;

/* -- trees */

static struct {
    char *paths[MOST_FILES];
    int count;
} walked; /* nftw takes no argument of one's own */

static int note(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    (void)info, (void)kind, (void)walk;
    assert_in_range(walked.count, 0, MOST_FILES - 1);
    walked.paths[walked.count++] = strdup(path);
    return 0;
}

static int by_name(const void *a, const void *b) { return strcmp(*(char *const *)a, *(char *const *)b); }

/* A file's bytes, where a link leads; of anything else nothing. */
static void add_contents(Bytes *tree, const char *path, mode_t mode)
{
    char bytes[1 << 12];
    ssize_t size = 0;
    int file = S_ISREG(mode) ? open(path, O_RDONLY) : -1;
    if (S_ISLNK(mode))
        size = readlink(path, bytes, sizeof bytes);
    else if (file >= 0)
        size = read(file, bytes, sizeof bytes);
    if (file >= 0)
        close(file);
    bytes_block(tree, bytes, (size_t)size);
}

/* Names, kinds and bytes of all that lies there. */
static Bytes tree_of(const char *path)
{
    Bytes tree = {0};
    walked.count = 0;
    assert_int_equal(nftw(path, note, 16, FTW_PHYS), 0);
    qsort(walked.paths, (size_t)walked.count, sizeof *walked.paths, by_name);
    for (int i = 0; i < walked.count; i++) {
        struct stat info;
        assert_int_equal(lstat(walked.paths[i], &info), 0);
        bytes_text(&tree, walked.paths[i]);
        bytes_number(&tree, info.st_mode);
        add_contents(&tree, walked.paths[i], info.st_mode);
        free(walked.paths[i]);
    }
    return tree;
}

static void assert_is(const World *w, const Bytes *wanted)
{
    Bytes now = tree_of(w->root);
    bool same = now.size == wanted->size && !memcmp(now.at, wanted->at, now.size);
    bytes_free(&now);
    assert_true(same);
}

static int remove_one(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    (void)info, (void)kind, (void)walk;
    return remove(path);
}

/* A path below the root, until the next but three. */
static const char *at(const World *w, const char *name)
{
    static char paths[4][2 * PATH_ROOM];
    static int next;
    char *path = paths[next++ & 3];
    snprintf(path, sizeof paths[0], "%s/%s", w->root, name);
    return path;
}

static void put_bytes(const World *w, const char *name, const void *bytes, size_t size)
{
    int file = open(at(w, name), O_WRONLY | O_CREAT | O_TRUNC, 0666); /* the same file, if it is there */
    assert_true(file >= 0);
    assert_int_equal(write(file, bytes, size), size);
    close(file);
}

static void put(const World *w, const char *name, const char *text) { put_bytes(w, name, text, strlen(text)); }

static bool has(const World *w, const char *name, const char *text)
{
    char bytes[PATH_ROOM] = "";
    int file = open(at(w, name), O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
    bool same = file >= 0 && read(file, bytes, sizeof bytes - 1) >= 0 && !strcmp(bytes, text);
    if (file >= 0)
        close(file);
    return same;
}

static bool is_there(const World *w, const char *name)
{
    return !faccessat(AT_FDCWD, at(w, name), F_OK, AT_SYMLINK_NOFOLLOW);
}

/* -- a run that was ended */

static Key hash_of(const char *text) { return key_of_bytes(text, strlen(text)); }

#define CHANGED  "// changed.frag, new\n"
#define COMING   "// coming.frag, new\n"
#define MANIFEST "{\"new\": 1}\n"

/* One file changes, one comes, one goes, and the manifest is another. It ends when all is moved, before that counts. */
static void end_a_run(World *w)
{
    Waiting waiting;
    Step all[] = {{STEP_put, 0, hash_of(CHANGED), "changed.frag"},
                  {STEP_put, 1, hash_of(COMING), "coming.frag"},
                  {.kind = STEP_remove, .number = 3, .name = "going.frag"},
                  {STEP_index, 2, hash_of(MANIFEST), "manifest.json"}};
    const Steps steps = {all, 4};
    assert_null(waiting_make(&waiting, w->out));
    assert_null(waiting_write(&waiting, "0", CHANGED, strlen(CHANGED)));
    assert_null(waiting_write(&waiting, "1", COMING, strlen(COMING)));
    assert_null(waiting_write(&waiting, "2", MANIFEST, strlen(MANIFEST)));
    assert_null(steps_begin(&waiting, &steps));
    assert_null(steps_do(&waiting, &steps));
    waiting_leave(&waiting);
}

static void read_journal(World *w)
{
    struct stat info;
    int file = open(at(w, "out/.matc-commit/journal"), O_RDONLY);
    assert_int_equal(fstat(file, &info), 0);
    w->size = (size_t)info.st_size;
    w->journal = malloc(w->size);
    assert_int_equal(read(file, w->journal, w->size), w->size);
    close(file);
}

static int make_world(void **state)
{
    World *w = calloc(1, sizeof *w);
    *state = w;
    strcpy(w->root, access("/dev/shm", W_OK) ? "/tmp/matc_journalXXXXXX" : "/dev/shm/matc_journalXXXXXX");
    if (!mkdtemp(w->root))
        return -1;
    alarm(MOST_SECONDS);
    mkdir(at(w, "out"), 0777);
    mkdir(at(w, "out/sub"), 0777);
    put(w, "beside.frag", "precious");
    put(w, "out/sub/below.frag", "precious");
    put(w, "out/notes.txt", "precious");
    put(w, "out/changed.frag", "// changed.frag, old\n");
    put(w, "out/going.frag", "// going.frag, old\n");
    put(w, "out/manifest.json", "{\"old\": 1}\n");
    w->out = open(at(w, "out"), O_RDONLY | O_DIRECTORY);
    w->before = tree_of(w->root);
    end_a_run(w);
    read_journal(w);
    w->ended = tree_of(w->root);
    return 0;
}

static int remove_world(void **state)
{
    World *w = *state;
    alarm(0);
    close(w->out);
    nftw(w->root, remove_one, 16, FTW_DEPTH | FTW_PHYS);
    bytes_free(&w->before);
    bytes_free(&w->ended);
    free(w->journal);
    free(w);
    return 0;
}

static void put_journal(const World *w, const void *bytes, size_t size)
{
    put_bytes(w, "out/.matc-commit/journal", bytes, size);
}

/* It says why, and all is as it is: twice, since the first may have left something. */
static void assert_refused(const World *w, const char *word)
{
    Bytes now = tree_of(w->root);
    for (int i = 0; i < 2; i++) {
        const char *why = steps_recover(w->out);
        assert_non_null(why);
        assert_non_null(strstr(why, ".matc-commit"));
        assert_non_null(strstr(why, word));
        assert_is(w, &now);
    }
    bytes_free(&now);
}

/* -- damaged */

static void a_whole_journal_is_undone(void **state)
{
    World *w = *state;
    assert_true(has(w, "out/changed.frag", CHANGED) && has(w, "out/coming.frag", COMING));
    assert_true(has(w, "out/manifest.json", MANIFEST) && !is_there(w, "out/going.frag"));
    assert_null(steps_recover(w->out));
    assert_is(w, &w->before);
}

static void an_empty_one_is_of_a_run_that_was_done(void **state)
{
    World *w = *state;
    put_journal(w, "", 0);
    assert_null(steps_recover(w->out));
    assert_true(has(w, "out/changed.frag", CHANGED) && has(w, "out/coming.frag", COMING));
    assert_true(has(w, "out/manifest.json", MANIFEST) && !is_there(w, "out/going.frag"));
    assert_false(is_there(w, "out/.matc-commit"));
}

static void one_that_was_cut_is_refused(void **state)
{
    World *w = *state;
    for (size_t size = 1; size < w->size; size++) {
        put_journal(w, w->journal, size);
        assert_refused(w, "damaged");
    }
    put_journal(w, w->journal, w->size);
    assert_null(steps_recover(w->out));
    assert_is(w, &w->before);
}

static void one_with_a_bit_turned_is_refused(void **state)
{
    World *w = *state;
    for (size_t bit = 0; bit < 8 * w->size; bit++) {
        w->journal[bit / 8] ^= (char)(1 << bit % 8);
        put_journal(w, w->journal, w->size);
        assert_refused(w, "damaged");
        w->journal[bit / 8] ^= (char)(1 << bit % 8);
    }
}

static void one_with_something_behind_it_is_refused(void **state)
{
    World *w = *state;
    char longer[1 << 12] = "";
    memcpy(longer, w->journal, w->size);
    for (size_t more = 1; more < 64; more++) {
        put_journal(w, longer, w->size + more);
        assert_refused(w, "damaged");
    }
}

static void files_that_are_no_journals_are_refused(void **state)
{
    static const char *const texts[] = {
        "{", "\n", "matc jr1", "matc jr2", "#!/bin/sh\n", "{\"files\": {}}\n", "put out/notes.txt by manifest.json"};
    World *w = *state;
    char zeros[1 << 12] = "";
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        put_journal(w, texts[i], strlen(texts[i]));
        assert_refused(w, "damaged");
    }
    put_journal(w, zeros, sizeof zeros);
    assert_refused(w, "damaged");
    assert_int_equal(truncate(at(w, "out/.matc-commit/journal"), (off_t)JOURNAL_LIMIT + 1), 0);
    assert_refused(w, "damaged");
    assert_int_equal(truncate(at(w, "out/.matc-commit/journal"), (off_t)1 << 40), 0);
    assert_refused(w, "damaged");
}

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
    assert_int_equal(stat(at(w, "out/.matc-commit/journal"), &info), 0);
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
    put_journal(w, bytes.at, bytes.size);
    bytes_free(&bytes);
}

/* Whatever the step, and whether it has a file to bring or the hash of the one that is there. */
static void names_outside_the_folder_are_refused(void **state)
{
    World *w = *state;
    char absolute[2 * PATH_ROOM];
    const char *const names[] = {
        "../beside.frag", absolute, "sub/below.frag", "./notes.txt", "sub/", "/", "..", ".", ""};
    strcpy(absolute, at(w, "beside.frag"));
    put(w, "out/.matc-commit/7.old", "planted");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (int kind = 0; kind < STEP_KINDS; kind++)
            for (int number = 7; number <= 8; number++) {
                const Step step = {(StepKind)kind, number, hash_of("precious"), names[i]};
                forge(w, &(Forged){"matc jr2", 1, 0, {step}});
                assert_refused(w, "damaged");
            }
}

static void one_that_counts_wrong_is_refused(void **state)
{
    World *w = *state;
    const Step step = {STEP_put, 8, hash_of("other"), "notes.txt"}, none = {STEP_KINDS, 8, {0, 0}, "notes.txt"},
               negative = {STEP_put, -1, {0, 0}, "notes.txt"};
    const Forged all[] = {
        {"matc jr2", 2, 0, {step}},           {"matc jr2", 0, 0, {step}}, {"matc jr2", UINT32_MAX, 0, {step}},
        {"matc jr2", 1u << 31, 0, {step}},    {"matc jr2", 1, 0, {none}}, {"matc jr2", 1, 0, {negative}},
        {"matc jr2", 2, 0, {step, negative}}, {"matc jr1", 1, 0, {step}}, {"matc jr3", 1, 0, {step}}};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        forge(w, &all[i]);
        assert_refused(w, "damaged");
    }
}

/* Names of files that no run made: only bytes tell whether one did. */
static void what_a_run_did_not_write_stays(void **state)
{
    World *w = *state;
    put(w, "out/.matc-commit/7.old", "planted");
    for (int kind = 0; kind < STEP_KINDS; kind++)
        for (int number = 7; number <= 8; number++) {
            const Step step = {(StepKind)kind, number, hash_of("other"), "notes.txt"};
            if (!is_there(w, "out/.matc-commit"))
                end_a_run(w);
            put(w, "out/.matc-commit/7.old", "planted");
            forge(w, &(Forged){"matc jr2", 1, 0, {step}});
            assert_null(steps_recover(w->out));
            assert_true(has(w, "out/notes.txt", "precious"));
            assert_false(is_there(w, "out/.matc-commit"));
        }
}

/* Folders that matc makes, or anybody, under the names of files. */
static void folders_stay(void **state)
{
    static const char *const names[] = {"sub", ".matc-commit"};
    World *w = *state;
    for (int i = 0; i < 2; i++)
        for (int kind = 0; kind < STEP_KINDS; kind++) {
            if (!is_there(w, "out/.matc-commit"))
                end_a_run(w);
            put(w, "out/.matc-commit/7.old", "planted");
            forge(w, &(Forged){"matc jr2", 1, 0, {{(StepKind)kind, 7, {0, 0}, names[i]}}});
            assert_null(steps_recover(w->out));
            assert_true(has(w, "out/sub/below.frag", "precious"));
            assert_false(is_there(w, "out/.matc-commit"));
        }
}

/* -- carried elsewhere */

/* A copy of the whole folder, as archives make it. */
static void a_copy_of_a_journal_is_refused(void **state)
{
    World *w = *state;
    char command[4 * PATH_ROOM];
    forge(w, &(Forged){"matc jr2", 1, 1, {{STEP_put, 8, hash_of("precious"), "notes.txt"}}});
    assert_refused(w, "copy");
    put_journal(w, w->journal, w->size);
    snprintf(command, sizeof command, "cp -rp '%s/out' '%s/copy'", w->root, w->root);
    assert_int_equal(system(command), 0);
    int own = w->out;
    w->out = open(at(w, "copy"), O_RDONLY | O_DIRECTORY);
    assert_refused(w, "copy");
    close(w->out);
    w->out = own;
}

/* The very journal in a folder with other files of these names: they stay as they are. */
static void a_journal_that_was_moved_harms_no_other_folder(void **state)
{
    static const char *const names[] = {"other/changed.frag", "other/coming.frag", "other/going.frag",
                                        "other/manifest.json"};
    World *w = *state;
    mkdir(at(w, "other"), 0777);
    for (int i = 0; i < 4; i++)
        put(w, names[i], "precious");
    assert_int_equal(rename(at(w, "out/.matc-commit"), at(w, "other/.matc-commit")), 0);
    int other = open(at(w, "other"), O_RDONLY | O_DIRECTORY);
    assert_null(steps_recover(other));
    close(other);
    for (int i = 0; i < 4; i++)
        assert_true(has(w, names[i], "precious"));
    assert_false(is_there(w, "other/.matc-commit"));
}

/* -- changed in the meantime */

static void files_that_came_since_stay(void **state)
{
    static const char *const names[] = {"out/changed.frag", "out/coming.frag", "out/going.frag", "out/manifest.json"};
    World *w = *state;
    for (int which = 1; which < 16; which++) {
        if (!is_there(w, "out/.matc-commit"))
            end_a_run(w);
        for (int i = 0; i < 4; i++)
            if (which >> i & 1)
                put(w, names[i], "mine");
        assert_null(steps_recover(w->out));
        for (int i = 0; i < 4; i++)
            assert_int_equal(has(w, names[i], "mine"), which >> i & 1);
        assert_false(is_there(w, "out/.matc-commit"));
        for (int i = 0; i < 4; i++) /* as before the run */
            unlink(at(w, names[i]));
        put(w, names[0], "// changed.frag, old\n");
        put(w, names[2], "// going.frag, old\n");
        put(w, names[3], "{\"old\": 1}\n");
    }
}

/* A run that would renew an equal file was ended before it came to that. */
static void an_equal_file_that_was_not_replaced_yet_stays(void **state)
{
    World *w = *state;
    Waiting waiting;
    Step step = {STEP_put, 0, hash_of("precious"), "notes.txt"};
    assert_null(steps_recover(w->out));
    assert_null(waiting_make(&waiting, w->out));
    assert_null(waiting_write(&waiting, "0", "precious", strlen("precious")));
    assert_null(steps_begin(&waiting, &(Steps){&step, 1}));
    waiting_leave(&waiting);
    assert_null(steps_recover(w->out));
    assert_is(w, &w->before);
}

static void links_and_pipes_that_came_since_stay(void **state)
{
    World *w = *state;
    unlink(at(w, "out/changed.frag"));
    unlink(at(w, "out/coming.frag"));
    put(w, "beside.frag", CHANGED); /* what it leads to has the very bytes */
    assert_int_equal(symlink("../beside.frag", at(w, "out/changed.frag")), 0);
    assert_int_equal(mkfifo(at(w, "out/coming.frag"), 0666), 0);
    assert_int_equal(mkdir(at(w, "out/going.frag"), 0777), 0);
    Bytes beside = {0}, now = {0};
    add_contents(&beside, at(w, "out/changed.frag"), S_IFLNK);
    assert_null(steps_recover(w->out));
    add_contents(&now, at(w, "out/changed.frag"), S_IFLNK);
    assert_int_equal(beside.size, now.size);
    assert_memory_equal(beside.at, now.at, now.size);
    bytes_free(&beside);
    bytes_free(&now);
    assert_true(has(w, "beside.frag", CHANGED));
    assert_true(is_there(w, "out/coming.frag") && is_there(w, "out/going.frag"));
    assert_true(has(w, "out/manifest.json", "{\"old\": 1}\n"));
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
    const char *path = at(w, name);
    switch (kind) {
    case 0:
        assert_int_equal(mkdir(path, 0777), 0);
        break;
    case 1:
        assert_int_equal(mkfifo(path, 0666), 0);
        break;
    case 2:
    case 3:
        assert_int_equal(symlink(at(w, kind == 2 ? "beside.frag" : "nothing"), path), 0);
        break;
    case 4:
        make_socket(path);
        break;
    default:
        put(w, name, "precious");
    }
}

static void what_stands_for_a_journal_is_refused(void **state)
{
    World *w = *state;
    for (int kind = 0; kind < 5; kind++) {
        remove(at(w, "out/.matc-commit/journal"));
        plant(w, kind, "out/.matc-commit/journal");
        assert_refused(w, "move it away");
    }
}

static void what_stands_for_the_folder_is_refused(void **state)
{
    static const int kinds[] = {1, 4, 5};
    World *w = *state;
    assert_null(steps_recover(w->out));
    for (int i = 0; i < 3; i++) {
        plant(w, kinds[i], "out/.matc-commit");
        assert_refused(w, "move it away");
        remove(at(w, "out/.matc-commit"));
    }
    plant(w, 5, "out/.matc-stage-abcdef");
    waiting_clean(w->out);
    assert_true(has(w, "out/.matc-stage-abcdef", "precious"));
    remove(at(w, "out/.matc-stage-abcdef"));
    for (int kind = 2; kind <= 3; kind++) { /* a link goes, and no more */
        plant(w, kind, "out/.matc-commit");
        assert_null(steps_recover(w->out));
        assert_is(w, &w->before);
    }
}

/* What matc put there is seen to; the rest is said, and stays. */
static void other_files_beside_a_journal_stay(void **state)
{
    World *w = *state;
    put(w, "out/.matc-commit/notes.txt", "precious");
    put(w, "out/.matc-commit/.old", "precious");
    put(w, "out/.matc-commit/1.older", "precious");
    mkdir(at(w, "out/.matc-commit/sub"), 0777);
    for (int i = 0; i < 2; i++) {
        const char *why = steps_recover(w->out);
        assert_non_null(why);
        assert_non_null(strstr(why, "other files than matc's are in .matc-commit"));
        assert_true(has(w, "out/changed.frag", "// changed.frag, old\n") &&
                    has(w, "out/going.frag", "// going.frag, old\n"));
        assert_true(has(w, "out/manifest.json", "{\"old\": 1}\n") && !is_there(w, "out/coming.frag"));
        assert_true(has(w, "out/.matc-commit/notes.txt", "precious") && has(w, "out/.matc-commit/.old", "precious"));
        assert_true(has(w, "out/.matc-commit/1.older", "precious") && is_there(w, "out/.matc-commit/sub"));
        assert_false(is_there(w, "out/.matc-commit/0.old"));
    }
    unlink(at(w, "out/.matc-commit/notes.txt"));
    unlink(at(w, "out/.matc-commit/.old"));
    unlink(at(w, "out/.matc-commit/1.older"));
    rmdir(at(w, "out/.matc-commit/sub"));
    assert_null(steps_recover(w->out));
    assert_is(w, &w->before);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, make_world, remove_world)
    const struct CMUnitTest tests[] = {
        TEST(a_whole_journal_is_undone),
        TEST(an_empty_one_is_of_a_run_that_was_done),
        TEST(one_that_was_cut_is_refused),
        TEST(one_with_a_bit_turned_is_refused),
        TEST(one_with_something_behind_it_is_refused),
        TEST(files_that_are_no_journals_are_refused),
        TEST(names_outside_the_folder_are_refused),
        TEST(one_that_counts_wrong_is_refused),
        TEST(what_a_run_did_not_write_stays),
        TEST(folders_stay),
        TEST(a_copy_of_a_journal_is_refused),
        TEST(a_journal_that_was_moved_harms_no_other_folder),
        TEST(files_that_came_since_stay),
        TEST(an_equal_file_that_was_not_replaced_yet_stays),
        TEST(links_and_pipes_that_came_since_stay),
        TEST(what_stands_for_a_journal_is_refused),
        TEST(what_stands_for_the_folder_is_refused),
        TEST(other_files_beside_a_journal_stay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
