/* Runs that are ended before each of their calls in turn, and runs of which each call in turn fails (tests/kill/strike.c). Then the
 * next run finds whatever was left. What is right is told by runs that nothing happens to. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "compiler/base/bytes.h"
#include "tests/value/read_whole.h"
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { PATH_ROOM = 1024, MOST_ARGUMENTS = 20, SHOWN = 4, MOST_CALLS = 1000, OLD_SECONDS = 7200 };

typedef struct {
    const char *name;
    const char *before[MOST_ARGUMENTS]; /* what was run earlier; none: nothing was */
    const char *run[MOST_ARGUMENTS];
    const char *faulty[MOST_ARGUMENTS]; /* the same with a document that has a fault; none: no such run */
    bool index;                         /* out/manifest.json is an index of out */
    bool cache;
} Scenario;

#define DOCUMENTS "../docs/a.yaml", "../docs/b.yaml", "../docs/c.yaml"
#define BATCH     "--no-validate", "-j1", "--emit=glsl,vertex", "-d", "out"
static const Scenario scenarios[] = {
    {"a first batch", {NULL}, {BATCH, "-MD", DOCUMENTS}, {NULL}, true, false},
    {"a batch over another, with files that come, change, stay and go",
     {BATCH, "-MD", "../docs/a.yaml", "../docs/b2.yaml", "../docs/d.yaml"},
     {BATCH, "-MD", DOCUMENTS},
     {BATCH, "-MD", DOCUMENTS, "../docs/bad.yaml"},
     true,
     false},
    {"a batch with textures and a depfile elsewhere",
     {BATCH, "--textures", "ktx", "-MD", "-MF", "made.d", "../docs/r2.yaml"},
     {BATCH, "--textures", "ktx", "-MD", "-MF", "made.d", "../docs/r.yaml"},
     {NULL},
     true,
     false},
    {"a batch that the cache does not know",
     {BATCH, "--cache", "cache", "../docs/d.yaml"},
     {BATCH, "--cache", "cache", DOCUMENTS},
     {NULL},
     true,
     true},
    {"a batch out of a cache",
     {BATCH, "--cache", "cache", DOCUMENTS, "../docs/d.yaml"},
     {BATCH, "--cache", "cache", DOCUMENTS},
     {NULL},
     true,
     true},
    {"one file", {NULL}, {"--no-validate", "../docs/a.yaml", "-o", "a.frag"}, {NULL}, false, false},
    {"one file over another, with a depfile",
     {"--no-validate", "-MD", "../docs/b2.yaml", "-o", "b.frag"},
     {"--no-validate", "-MD", "../docs/b.yaml", "-o", "b.frag"},
     {NULL},
     false,
     false},
};

typedef struct {
    char root[PATH_ROOM / 4];
    Bytes before, after;     /* the folder as it was before the run, and as it should be after it */
    char *calls[MOST_CALLS]; /* names, in their order, from 1 */
    long call_count;
    int wrong, left;
} World;

/* -- folders, and what is in them */

static int remove_file(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    (void)info, (void)kind, (void)walk;
    return remove(path);
}

static void remove_tree(const char *path) { nftw(path, remove_file, 16, FTW_DEPTH | FTW_PHYS); }

static void in_root(const World *w, const char *name, char path[PATH_ROOM])
{
    snprintf(path, PATH_ROOM, "%s/%s", w->root, name);
}

static void write_file(const char *path, const char *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

static int by_name(const void *a, const void *b) { return strcmp(*(char *const *)a, *(char *const *)b); }

/* Of nftw, which takes no argument of one's own. */
static struct {
    char *paths[256];
    int count;
} walked;

static int note(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    (void)info, (void)walk;
    if (kind != FTW_DP && walked.count < 256)
        walked.paths[walked.count++] = strdup(path);
    return 0;
}

/* All names below a folder and all bytes, but for the cache's; those that only a next run removes are left out where that is said. */
static Bytes tree_of(const char *path, bool hidden)
{
    Bytes tree = {0};
    walked.count = 0;
    nftw(path, note, 16, FTW_PHYS);
    qsort(walked.paths, (size_t)walked.count, sizeof *walked.paths, by_name);
    for (int i = 0; i < walked.count; i++) {
        const char *name = walked.paths[i] + strlen(path);
        struct stat info;
        size_t size;
        bool skipped = !strncmp(name, "/cache", 6) || (!hidden && strstr(name, "/.matc-"));
        if (skipped || lstat(walked.paths[i], &info)) {
            free(walked.paths[i]);
            continue;
        }
        bytes_text(&tree, name);
        char *text = S_ISREG(info.st_mode) ? read_whole(walked.paths[i], &size) : NULL;
        bytes_block(&tree, text ? text : "", text ? size : 0); /* a folder has none */
        free(text);
        free(walked.paths[i]);
    }
    return tree;
}

static bool same(const Bytes *a, const Bytes *b) { return a->size == b->size && !memcmp(a->at, b->at, a->size); }

static bool is_now(const World *w, const Bytes *tree, bool hidden)
{
    char now[PATH_ROOM];
    in_root(w, "now", now);
    Bytes there = tree_of(now, hidden);
    bool equal = same(&there, tree);
    bytes_free(&there);
    return equal;
}

/* Names of what is in the folder now, for a report. */
static void show_now(const World *w)
{
    char command[2 * PATH_ROOM];
    snprintf(command, sizeof command,
             "cd '%s/now' && find . ! -path './cache/*' | sort | tr '\n' ' ' >&2; echo >&2; cat '%s/said' >&2", w->root,
             w->root);
    if (system(command))
        return;
}

/* Where nftw's files are copied to, and how much of their paths is the folder that they come from. */
static struct {
    const char *to;
    size_t skip;
} copied;

static int copy_one(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    char to[2 * PATH_ROOM];
    size_t size;
    (void)info, (void)walk;
    snprintf(to, sizeof to, "%s%s", copied.to, path + copied.skip);
    if (kind == FTW_D)
        return mkdir(to, 0777);
    char *bytes = read_whole(path, &size);
    write_file(to, bytes, size);
    free(bytes);
    return 0;
}

/* The folder of one name becomes what that of another is. */
static void copy_tree(const World *w, const char *from, const char *name)
{
    char path[PATH_ROOM], to[PATH_ROOM];
    in_root(w, from, path);
    in_root(w, name, to);
    remove_tree(to);
    copied.to = to;
    copied.skip = strlen(path);
    assert_int_equal(nftw(path, copy_one, 16, FTW_PHYS), 0);
}

static void reset(const World *w) { copy_tree(w, "old", "now"); }

/* -- running */

/* The child: matc in the folder "now", with what it says in the file "said". */
static void become_matc(const World *w, const char *const *arguments, long at, const char *how)
{
    char path[PATH_ROOM], number[32];
    const char *all[MOST_ARGUMENTS + 2] = {MATC_PROGRAM};
    for (int i = 0; i < MOST_ARGUMENTS && arguments[i]; i++)
        all[i + 1] = arguments[i];
    in_root(w, "said", path);
    int said = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(said, STDOUT_FILENO);
    dup2(said, STDERR_FILENO);
    in_root(w, "calls", path);
    setenv("STRIKE_LOG", path, 1);
    snprintf(number, sizeof number, "%ld", at);
    setenv("STRIKE_AT", number, 1);
    setenv("STRIKE_HOW", how ? how : "", 1);
    if (how) {
        const char *options =
            getenv("ASAN_OPTIONS"); /* a sanitizer wants to be the first that is loaded, but need not be */
        char more[PATH_ROOM];
        snprintf(more, sizeof more, "%s:verify_asan_link_order=0", options ? options : "");
        setenv("ASAN_OPTIONS", more, 1);
        setenv("LD_PRELOAD", STRIKE_LIBRARY, 1);
    }
    in_root(w, "now", path);
    if (!chdir(path))
        execv(MATC_PROGRAM, (char *const *)all);
    _exit(127);
}

/* Its exit status; -1: it was killed. */
static int run(World *w, const char *const *arguments, long at, const char *how)
{
    int status = 0;
    pid_t child = fork();
    if (!child)
        become_matc(w, arguments, at, how);
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static bool says(const World *w, const char *what)
{
    char path[PATH_ROOM];
    size_t size;
    in_root(w, "said", path);
    char *said = read_whole(path, &size);
    bool any = said && strstr(said, what);
    free(said);
    return any;
}

/* -- what must be true */

/* Where a scenario was struck: at its n-th call. */
typedef struct {
    const Scenario *scenario;
    long n;
    const char *how;
} Strike;

static void check(World *w, bool fine, const Strike *at, const char *what)
{
    if (fine)
        return;
    fprintf(stderr, "%s, call %ld (%s) %s: %s\n", at->scenario->name, at->n, w->calls[at->n], at->how, what);
    if (++w->wrong <= SHOWN)
        show_now(w);
}

/* The bytes of a file in a tree_of; NULL: it is not there. */
static const char *in_tree(const Bytes *tree, const char *name, size_t *size)
{
    BytesReader from = {tree->at, tree->at + tree->size, false};
    const char *found = NULL;
    while (!found && from.at < from.end && !from.broken) {
        const char *text = bytes_take_text(&from), *bytes = bytes_take_block(&from, size);
        found = strcmp(text, name) ? NULL : bytes;
    }
    return found;
}

/* Every file of that tree is in the other with the same bytes. */
static bool holds(const Bytes *tree, const Bytes *wanted)
{
    BytesReader from = {wanted->at, wanted->at + wanted->size, false};
    bool all = true;
    while (all && from.at < from.end && !from.broken) {
        size_t size, there;
        const char *name = bytes_take_text(&from), *bytes = bytes_take_block(&from, &size);
        if (strncmp(name, "/out/", 5) != 0)
            continue;
        const char *found = in_tree(tree, name, &there);
        all = found && bytes && there == size && !memcmp(found, bytes, size);
    }
    return all;
}

/* A manifest that is there tells what is there: it is the old one over all the old files, or the new one over all the new ones. */
static bool index_is_true(const World *w)
{
    char path[PATH_ROOM];
    size_t size, before, after;
    in_root(w, "now", path);
    Bytes tree = tree_of(path, true);
    const char *now = in_tree(&tree, "/out/manifest.json", &size), *old, *new;
    old = in_tree(&w->before, "/out/manifest.json", &before);
    new = in_tree(&w->after, "/out/manifest.json", &after);
    bool fine = !now || (old && before == size && !memcmp(now, old, size) && holds(&tree, &w->before)) ||
                (new &&after == size && !memcmp(now, new, size) && holds(&tree, &w->after));
    bytes_free(&tree);
    return fine;
}

/* Temporary files of the cache are as old as those that lost their writer, and it was looked through long ago. */
static bool temporary_found;
static int age(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    const struct timespec times[2] = {{.tv_sec = time(NULL) - OLD_SECONDS}, {.tv_sec = time(NULL) - OLD_SECONDS}};
    (void)info;
    if (kind == FTW_F && !strncmp(path + walk->base, ".tmp", 4)) {
        temporary_found = true;
        return utimensat(AT_FDCWD, path, times, 0);
    }
    return strcmp(path + walk->base, "statistics") ? 0 : remove(path);
}

static bool age_cache(const World *w)
{
    char path[PATH_ROOM];
    in_root(w, "now/cache", path);
    temporary_found = false;
    nftw(path, age, 16, FTW_PHYS);
    return temporary_found;
}

/* -- worlds */

static void put_document(const World *w, const char *name, const char *text)
{
    char path[PATH_ROOM];
    in_root(w, name, path);
    write_file(path, text, strlen(text));
}

static int make_world(void **state)
{
    World *w = calloc(1, sizeof *w);
    char path[PATH_ROOM];
    *state = w;
    strcpy(w->root, access("/dev/shm", W_OK) ? "/tmp/matc_killXXXXXX" : "/dev/shm/matc_killXXXXXX"); /* in memory */
    if (!mkdtemp(w->root))
        return -1;
    in_root(w, "docs", path);
    mkdir(path, 0777);
    put_document(w, "docs/a.yaml", "material: Phong\ndiffuse: { map: Checker }\n");
    put_document(w, "docs/b.yaml", "materials:\n  b: { material: Phong, diffuse: { map: Leopard } }\n");
    put_document(w, "docs/b2.yaml", "materials:\n  b: { material: Phong, diffuse: { map: Gradient } }\n");
    put_document(w, "docs/c.yaml", "material: Phong\nspecular: { map: UVTransform }\n");
    put_document(w, "docs/d.yaml",
                 "materials:\n  d: { material: Phong, diffuse: { map: Granite } }\n"
                 "  e: { material: Phong, diffuse: { map: Wood } }\n");
    put_document(w, "docs/r.yaml",
                 "materials:\n  r: { material: Phong, diffuse: { map: Carpenter, roughness: 0.9 } }\n");
    put_document(w, "docs/r2.yaml",
                 "materials:\n  r: { material: Phong, specular: { map: Carpenter, color: 0.3, roughness: 0.5 } }\n"
                 "  s: { material: Phong }\n");
    put_document(w, "docs/bad.yaml", "material: Fong\n");
    return 0;
}

static void forget_calls(World *w)
{
    for (long n = 1; n <= w->call_count; n++)
        free(w->calls[n]);
    w->call_count = 0;
}

static int remove_world(void **state)
{
    World *w = *state;
    remove_tree(w->root);
    bytes_free(&w->before);
    bytes_free(&w->after);
    forget_calls(w);
    free(w);
    return 0;
}

/* What the last run called. */
static void read_calls(World *w)
{
    char path[PATH_ROOM], *rest;
    size_t size;
    in_root(w, "calls", path);
    char *text = read_whole(path, &size);
    forget_calls(w);
    for (char *name = strtok_r(text, "\n", &rest); name && w->call_count + 1 < MOST_CALLS;
         name = strtok_r(NULL, "\n", &rest))
        w->calls[++w->call_count] = strdup(name);
    free(text);
    assert_in_range(w->call_count, 10, MOST_CALLS - 2);
}

static bool is_one_of(const char *name, const char *const *names)
{
    while (*names && strcmp(*names, name) != 0)
        names++;
    return *names != NULL;
}

/* The folder before the run, and after it, and the calls. */
static void prepare(World *w, const Scenario *s)
{
    char path[PATH_ROOM];
    in_root(w, "old", path);
    remove_tree(path);
    mkdir(path, 0777);
    reset(w);
    if (s->before[0])
        assert_int_equal(run(w, s->before, 0, NULL), 0);
    copy_tree(w, "now", "old");
    bytes_free(&w->before);
    bytes_free(&w->after);
    w->before = tree_of(path, true);
    assert_int_equal(run(w, s->run, 0, "kill"), 0); /* at call 0: it only counts */
    in_root(w, "now", path);
    w->after = tree_of(path, true);
    read_calls(w);
}

/* -- the tests */

static void check_after_kill(World *w, const Strike *at)
{
    const Scenario *s = at->scenario;
    check(w, !s->index || index_is_true(w), at, "the manifest is not true");
    if (!s->cache && is_now(w, &w->before, true))
        return; /* the next run is the one that was tried first */
    if (s->cache)
        age_cache(w);
    if (s->faulty[0] && at->n % 3 == 0) {
        check(w, run(w, s->faulty, 0, NULL) == 1, at, "a faulty run ends otherwise");
        check(w, is_now(w, &w->before, true) || is_now(w, &w->after, true), at,
              "a faulty run leaves what is neither old nor new");
    }
    check(w, run(w, s->run, 0, NULL) == 0, at, "the next run fails");
    check(w, is_now(w, &w->after, true), at, "the next run leaves another folder");
    if (s->cache)
        check(w, !age_cache(w), at, "temporary files in the cache");
}

/* What can change a folder. Between two of these a kill leaves what it leaves behind the first. */
static const char *const changes[] = {"open",   "openat",   "write",    "writev", "pwrite",    "mkdir", "mkdirat",
                                      "linkat", "renameat", "unlinkat", "rmdir",  "ftruncate", NULL};

static void a_run_that_is_ended_at_any_call_is_made_good_by_the_next(void **state)
{
    World *w = *state;
    for (size_t i = 0; i < sizeof scenarios / sizeof *scenarios; i++) {
        const Scenario *s = &scenarios[i];
        prepare(w, s);
        for (long n = 1; n <= w->call_count; n++) {
            if (n > 1 && !is_one_of(w->calls[n - 1], changes))
                continue;
            Strike at = {s, n, "killed"};
            reset(w);
            check(w, run(w, s->run, n, "kill") == -1, &at, "it was not killed");
            check_after_kill(w, &at);
            if (strcmp(w->calls[n], "write") != 0)
                continue;
            at.how = "killed in it";
            reset(w);
            check(w, run(w, s->run, n, "half") == -1, &at, "it was not killed");
            check_after_kill(w, &at);
        }
        printf("%s: killed at %ld calls\n", s->name, w->call_count);
    }
    assert_int_equal(w->wrong, 0);
}

/* A run that says that it failed has changed nothing and left nothing; one that says that it did not has done all. What it could not
 * remove in the end is the only thing that may lie there, and the next run removes it. */
static void check_failure(World *w, const Strike *at)
{
    const Scenario *s = at->scenario;
    int status = run(w, s->run, at->n, at->how);
    if (status == 1) {
        check(w, says(w, "error: "), at, "it does not say why");
        check(w, is_now(w, &w->before, true), at, "it failed and left a changed folder");
    } else {
        check(w, status == 0, at, "it ended otherwise");
        check(w, is_now(w, &w->after, false), at, "it left another folder");
        if (is_now(w, &w->after, true))
            return;
        w->left++;
        check(w, run(w, s->run, 0, NULL) == 0 && is_now(w, &w->after, true), at, "the next run does not make it good");
    }
}

/* Calls that a full disk lets fail. */
static const char *const grows[] = {"openat",    "write",  "mkdir",  "mkdirat", "linkat",
                                    "fdatasync", "writev", "pwrite", NULL};

static void a_run_of_which_a_call_fails_does_all_or_nothing(void **state)
{
    static const int errors[] = {ENOSPC, EIO, EACCES};
    World *w = *state;
    char how[16];
    for (size_t i = 0; i < sizeof scenarios / sizeof *scenarios; i++) {
        const Scenario *s = &scenarios[i];
        prepare(w, s);
        w->left = 0;
        for (long n = 1; n <= w->call_count; n++) {
            snprintf(how, sizeof how, "%d", errors[n % 3]);
            reset(w);
            check_failure(w, &(Strike){s, n, how});
            if (!is_one_of(w->calls[n], grows))
                continue;
            reset(w);
            check_failure(w, &(Strike){s, n, "full"});
        }
        printf("%s: %ld calls failed, %d of them while it removed what it had used\n", s->name, w->call_count, w->left);
    }
    assert_int_equal(w->wrong, 0);
}

/* A batch that is as it was looks, and no more: its folder may be another's, or on a disk that cannot be written. */
static void an_unchanged_batch_writes_nothing(void **state)
{
    World *w = *state;
    for (size_t i = 0; i < sizeof scenarios / sizeof *scenarios; i++) {
        const Scenario *s = &scenarios[i];
        if (!s->index || s->cache || !strcmp(s->name, "a batch with textures and a depfile elsewhere"))
            continue;
        prepare(w, s);
        const Strike at = {s, 1, "of a disk that is not written"};
        check(w, run(w, s->run, 1, "readonly") == 0, &at, "it fails");
        check(w, is_now(w, &w->after, true), &at, "it changes something");
    }
    assert_int_equal(w->wrong, 0);
}

/* A test's name, or a part of it and *: that one alone. */
int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_run_that_is_ended_at_any_call_is_made_good_by_the_next, make_world,
                                        remove_world),
        cmocka_unit_test_setup_teardown(an_unchanged_batch_writes_nothing, make_world, remove_world),
        cmocka_unit_test_setup_teardown(a_run_of_which_a_call_fails_does_all_or_nothing, make_world, remove_world),
    };
    cmocka_set_test_filter(argc > 1 ? argv[1] : NULL);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
