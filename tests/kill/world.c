#include "tests/kill/world.h"
#include "tests/test.h"
#include "tests/value/folder.h"
#include "tests/value/read_whole.h"
#include <fcntl.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { SHOWN = 4 };

#define DOCUMENTS "../docs/a.yaml", "../docs/b.yaml", "../docs/c.yaml"
#define BATCH     "--no-validate", "-j1", "--emit=glsl,vertex", "-d", "out"
const Scenario scenarios[SCENARIOS] = {
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

void world_path(const World *w, const char *name, char path[PATH_CAPACITY])
{
    snprintf(path, PATH_CAPACITY, "%s/%s", w->root, name);
}

static void write_file(const char *path, const char *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* State of nftw's callback, which has no user argument. */
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

/* All names and bytes below a folder, except the cache's; `hidden`: also files that only the
 * next run removes. */
Bytes world_tree(const char *path, bool hidden)
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
        bytes_block(&tree, text ? text : "", text ? size : 0); /* a folder has no content */
        free(text);
        free(walked.paths[i]);
    }
    return tree;
}

static bool same(const Bytes *a, const Bytes *b)
{
    return a->size == b->size && !memcmp(a->at, b->at, a->size);
}

bool world_is(const World *w, const Bytes *tree, bool hidden)
{
    char now[PATH_CAPACITY];
    world_path(w, "now", now);
    Bytes there = world_tree(now, hidden);
    bool equal = same(&there, tree);
    bytes_free(&there);
    return equal;
}

/* The bytes of a file in a tree; NULL if it has no such file. */
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

/* True if `tree` has every output file of `wanted`, with the same bytes. */
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

bool world_index_is_true(const World *w)
{
    char path[PATH_CAPACITY];
    size_t size, before, after;
    world_path(w, "now", path);
    Bytes tree = world_tree(path, true);
    const char *now = in_tree(&tree, "/out/manifest.json", &size), *old, *new;
    old = in_tree(&w->before, "/out/manifest.json", &before);
    new = in_tree(&w->after, "/out/manifest.json", &after);
    bool fine = !now ||
                (old && before == size && !memcmp(now, old, size) && holds(&tree, &w->before)) ||
                (new &&after == size && !memcmp(now, new, size) && holds(&tree, &w->after));
    bytes_free(&tree);
    return fine;
}

/* Lists the names in the folder, for a report. */
static void show(const World *w)
{
    char command[2 * PATH_CAPACITY];
    snprintf(command, sizeof command,
             "cd '%s/now' && find . ! -path './cache/*' | sort | tr '\n' ' ' >&2; echo >&2; cat "
             "'%s/said' >&2",
             w->root, w->root);
    if (system(command))
        return;
}

/* Replaces one folder by a copy of another. */
static void copy(const World *w, const char *from, const char *name)
{
    char path[PATH_CAPACITY], to[PATH_CAPACITY];
    world_path(w, from, path);
    world_path(w, name, to);
    folder_remove(to);
    assert_true(folder_copy(path, to));
}

void world_reset(const World *w) { copy(w, "old", "now"); }

/* The child process: runs matc in the folder "now", with its output in the file "said". */
static void become_matc(const World *w, const char *const *arguments, long at, const char *how)
{
    char path[PATH_CAPACITY], number[32];
    const char *all[MAX_ARGUMENTS + 2] = {MATC_PROGRAM};
    for (int i = 0; i < MAX_ARGUMENTS && arguments[i]; i++)
        all[i + 1] = arguments[i];
    world_path(w, "said", path);
    int reported = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(reported, STDOUT_FILENO);
    dup2(reported, STDERR_FILENO);
    world_path(w, "calls", path);
    setenv("STRIKE_LOG", path, 1);
    snprintf(number, sizeof number, "%ld", at);
    setenv("STRIKE_AT", number, 1);
    setenv("STRIKE_HOW", how ? how : "", 1);
    if (how) {
        const char *options =
            /* ASan would refuse to start if it is not loaded first */
            getenv("ASAN_OPTIONS");
        char more[PATH_CAPACITY];
        snprintf(more, sizeof more, "%s:verify_asan_link_order=0", options ? options : "");
        setenv("ASAN_OPTIONS", more, 1);
        setenv("LD_PRELOAD", STRIKE_LIBRARY, 1);
    }
    world_path(w, "now", path);
    if (!chdir(path))
        execv(MATC_PROGRAM, (char *const *)all);
    _exit(127);
}

/* Returns the exit status; -1: killed. */
int world_run(World *w, const char *const *arguments, long at, const char *how)
{
    int status = 0;
    pid_t child = fork();
    if (!child)
        become_matc(w, arguments, at, how);
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool world_says(const World *w, const char *what)
{
    char path[PATH_CAPACITY];
    size_t size;
    world_path(w, "said", path);
    char *reported = read_whole(path, &size);
    bool any = reported && strstr(reported, what);
    free(reported);
    return any;
}

void world_check(World *w, bool fine, const Strike *at, const char *what)
{
    if (fine)
        return;
    fprintf(stderr, "%s, call %ld (%s) %s: %s\n", at->scenario->name, at->n, w->calls[at->n],
            at->how, what);
    if (++w->wrong <= SHOWN)
        show(w);
}

static void put_document(const World *w, const char *name, const char *text)
{
    char path[PATH_CAPACITY];
    world_path(w, name, path);
    write_file(path, text, strlen(text));
}

int world_make(void **state)
{
    World *w = calloc(1, sizeof *w);
    char path[PATH_CAPACITY];
    *state = w;
    /* a memory file system */
    strcpy(w->root, access("/dev/shm", W_OK) ? "/tmp/matc_killXXXXXX" : "/dev/shm/matc_killXXXXXX");
    if (!mkdtemp(w->root))
        return -1;
    world_path(w, "docs", path);
    mkdir(path, 0777);
    put_document(w, "docs/a.yaml", "material: Phong\ndiffuse: { map: Checker }\n");
    put_document(w, "docs/b.yaml",
                 "materials:\n  b: { material: Phong, diffuse: { map: Leopard } }\n");
    put_document(w, "docs/b2.yaml",
                 "materials:\n  b: { material: Phong, diffuse: { map: Gradient } }\n");
    put_document(w, "docs/c.yaml", "material: Phong\nspecular: { map: UVTransform }\n");
    put_document(w, "docs/d.yaml",
                 "materials:\n  d: { material: Phong, diffuse: { map: Granite } }\n"
                 "  e: { material: Phong, diffuse: { map: Wood } }\n");
    put_document(
        w, "docs/r.yaml",
        "materials:\n  r: { material: Phong, diffuse: { map: Carpenter, roughness: 0.9 } }\n");
    put_document(w, "docs/r2.yaml",
                 "materials:\n  r: { material: Phong, specular: { map: Carpenter, color: 0.3, "
                 "roughness: 0.5 } }\n"
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

int world_remove(void **state)
{
    World *w = *state;
    folder_remove(w->root);
    bytes_free(&w->before);
    bytes_free(&w->after);
    forget_calls(w);
    free(w);
    return 0;
}

/* Reads the names of the last run's calls. */
static void read_calls(World *w)
{
    char path[PATH_CAPACITY], *rest;
    size_t size;
    world_path(w, "calls", path);
    char *text = read_whole(path, &size);
    forget_calls(w);
    for (char *name = strtok_r(text, "\n", &rest); name && w->call_count + 1 < MAX_CALLS;
         name = strtok_r(NULL, "\n", &rest))
        w->calls[++w->call_count] = strdup(name);
    free(text);
    assert_in_range(w->call_count, 10, MAX_CALLS - 2);
}

bool call_is_one_of(const char *name, const char *const *names)
{
    while (*names && strcmp(*names, name) != 0)
        names++;
    return *names != NULL;
}

/* Records the folder before the run and after it, and the calls. */
void world_prepare(World *w, const Scenario *s)
{
    char path[PATH_CAPACITY];
    world_path(w, "old", path);
    folder_remove(path);
    mkdir(path, 0777);
    world_reset(w);
    if (s->before[0])
        assert_int_equal(world_run(w, s->before, 0, NULL), 0);
    copy(w, "now", "old");
    bytes_free(&w->before);
    bytes_free(&w->after);
    w->before = world_tree(path, true);
    assert_int_equal(world_run(w, s->run, 0, "kill"), 0); /* 0: calls are only counted */
    world_path(w, "now", path);
    w->after = world_tree(path, true);
    read_calls(w);
}
