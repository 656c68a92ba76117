/* Runs of matc over a folder that are disturbed at one system call: the process is killed before
 * the call, or the call fails (strike.c). A failed check ends the test. */
#ifndef TESTS_KILL_WORLD_H
#define TESTS_KILL_WORLD_H
#include "compiler/base/bytes.h"
#include "tests/sanitized.h"
#include <stdbool.h>

enum { PATH_CAPACITY = 1024, MAX_ARGUMENTS = 20, MAX_CALLS = 1000, SCENARIOS = 7 };
enum { STRIKE_STEP = SANITIZED ? 4 : 1 }; /* calls from one that is struck to the next */

typedef struct {
    const char *name;
    const char *before[MAX_ARGUMENTS]; /* what was run earlier; none: nothing was */
    const char *run[MAX_ARGUMENTS];
    /* the same with a document that has a fault; none: no such run */
    const char *faulty[MAX_ARGUMENTS];
    bool index; /* out/manifest.json is an index of out */
    bool cache;
} Scenario;
extern const Scenario scenarios[SCENARIOS];

/* Below root: the documents, the folder "old" as it was before the run, and "now", in which matc
 * runs. */
typedef struct {
    char root[PATH_CAPACITY / 4];
    Bytes before, after;    /* the folder as it was before the run, and as it should be after it */
    char *calls[MAX_CALLS]; /* names, in their order, from 1 */
    long call_count;
    int wrong;
    int left;   /* runs that succeeded but left files to remove */
    int halves; /* runs that failed while they moved files */
} World;

/* Where a scenario was struck: at its n-th call. */
typedef struct {
    const Scenario *scenario;
    long n;
    const char *how;
} Strike;

/* Setup and teardown of a test, whose state is a World. */
#define WORLD_TEST(name) cmocka_unit_test_setup_teardown(name, world_make, world_remove)
int world_make(void **state);
int world_remove(void **state);

/* The folder before the run, and after it, and the calls: from a run that is not struck. */
void world_prepare(World *w, const Scenario *s);
/* "now" is as it was before the run. */
void world_reset(const World *w);
/* matc's exit status; -1: it was killed. At its call number `at`, from 1, it is struck as `how`
 * says, words of strike.c; NULL: never. */
int world_run(World *w, const char *const *arguments, long at, const char *how);
/* The output of the last run contains that text. */
bool world_says(const World *w, const char *what);
/* Counts what is not fine, and says it. */
void world_check(World *w, bool fine, const Strike *at, const char *what);

/* A path below the root. */
void world_path(const World *w, const char *name, char path[PATH_CAPACITY]);
/* All names below a folder and all bytes, but for the GPU scene's; without what only a next run
 * removes, unless `hidden`. */
Bytes world_tree(const char *path, bool hidden);
/* "now" is such a tree. */
bool world_is(const World *w, const Bytes *tree, bool hidden);
/* There is no manifest, or the old one with all old files, or the new one with all new files. */
bool world_index_is_true(const World *w);
/* A call's name is in a list, which ends with NULL. */
bool call_is_one_of(const char *name, const char *const *names);
#endif
