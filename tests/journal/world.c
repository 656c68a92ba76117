#include "tests/journal/world.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/value/folder.h"
#include <fcntl.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_FILES = 64, MOST_SECONDS = 60 };

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
void world_add_contents(Bytes *tree, const char *path, mode_t mode)
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

Bytes world_tree(const char *path)
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
        world_add_contents(&tree, walked.paths[i], info.st_mode);
        free(walked.paths[i]);
    }
    return tree;
}

void world_assert_is(const World *w, const Bytes *wanted)
{
    Bytes now = world_tree(w->root);
    bool same = now.size == wanted->size && !memcmp(now.at, wanted->at, now.size);
    bytes_free(&now);
    assert_true(same);
}

const char *world_at(const World *w, const char *name)
{
    static char paths[4][2 * PATH_ROOM];
    static int next;
    char *path = paths[next++ & 3];
    snprintf(path, sizeof paths[0], "%s/%s", w->root, name);
    return path;
}

void world_put_bytes(const World *w, const char *name, const void *bytes, size_t size)
{
    int file = open(world_at(w, name), O_WRONLY | O_CREAT | O_TRUNC, 0666); /* the same file, if it is there */
    assert_true(file >= 0);
    assert_int_equal(write(file, bytes, size), size);
    close(file);
}

void world_put(const World *w, const char *name, const char *text) { world_put_bytes(w, name, text, strlen(text)); }

bool world_has(const World *w, const char *name, const char *text)
{
    char bytes[PATH_ROOM] = "";
    int file = open(world_at(w, name), O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
    bool same = file >= 0 && read(file, bytes, sizeof bytes - 1) >= 0 && !strcmp(bytes, text);
    if (file >= 0)
        close(file);
    return same;
}

bool world_is_there(const World *w, const char *name)
{
    return !faccessat(AT_FDCWD, world_at(w, name), F_OK, AT_SYMLINK_NOFOLLOW);
}

/* -- a run that was ended */

Key world_hash(const char *text) { return key_of_bytes(text, strlen(text)); }

void world_end_a_run(World *w)
{
    Waiting waiting;
    Step all[] = {{STEP_put, 0, world_hash(CHANGED), "changed.frag"},
                  {STEP_put, 1, world_hash(COMING), "coming.frag"},
                  {.kind = STEP_remove, .number = 3, .name = "going.frag"},
                  {STEP_index, 2, world_hash(MANIFEST), "manifest.json"}};
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
    int file = open(world_at(w, "out/.matc-commit/journal"), O_RDONLY);
    assert_int_equal(fstat(file, &info), 0);
    w->size = (size_t)info.st_size;
    w->journal = malloc(w->size);
    assert_int_equal(read(file, w->journal, w->size), w->size);
    close(file);
}

int world_make(void **state)
{
    World *w = calloc(1, sizeof *w);
    *state = w;
    strcpy(w->root, access("/dev/shm", W_OK) ? "/tmp/matc_journalXXXXXX" : "/dev/shm/matc_journalXXXXXX");
    if (!mkdtemp(w->root))
        return -1;
    alarm(MOST_SECONDS);
    mkdir(world_at(w, "out"), 0777);
    mkdir(world_at(w, "out/sub"), 0777);
    world_put(w, "beside.frag", "precious");
    world_put(w, "out/sub/below.frag", "precious");
    world_put(w, "out/notes.txt", "precious");
    world_put(w, "out/changed.frag", "// changed.frag, old\n");
    world_put(w, "out/going.frag", "// going.frag, old\n");
    world_put(w, "out/manifest.json", "{\"old\": 1}\n");
    w->out = open(world_at(w, "out"), O_RDONLY | O_DIRECTORY);
    w->before = world_tree(w->root);
    world_end_a_run(w);
    read_journal(w);
    w->ended = world_tree(w->root);
    return 0;
}

int world_remove(void **state)
{
    World *w = *state;
    alarm(0);
    close(w->out);
    folder_remove(w->root);
    bytes_free(&w->before);
    bytes_free(&w->ended);
    free(w->journal);
    free(w);
    return 0;
}

void world_put_journal(const World *w, const void *bytes, size_t size)
{
    world_put_bytes(w, "out/.matc-commit/journal", bytes, size);
}

void world_assert_refused(const World *w, const char *word)
{
    Bytes now = world_tree(w->root);
    for (int i = 0; i < 2; i++) {
        const char *why = steps_recover(w->out);
        assert_non_null(why);
        assert_non_null(strstr(why, ".matc-commit"));
        assert_non_null(strstr(why, word));
        world_assert_is(w, &now);
    }
    bytes_free(&now);
}
