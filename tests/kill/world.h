/* Runs of matc over a folder that are disturbed at one system call: the process is killed before
 * the call, or the call fails (strike.c). A failed check ends the test. */
#ifndef TESTS_KILL_WORLD_H
#define TESTS_KILL_WORLD_H
#include "compiler/base/bytes.h"
#include "tests/sanitized.h"
#include <stdbool.h>

enum { PATH_CAPACITY = 1024, MAX_ARGUMENTS = 20, MAX_CALLS = 1000, SCENARIOS = 7 };
enum { STRIKE_STEP = SANITIZED ? 4 : 1 }; /* a strike at every STRIKE_STEP-th call */

typedef struct {
    const char *name;
    const char *before[MAX_ARGUMENTS]; /* arguments of an earlier run; empty: none */
    const char *run[MAX_ARGUMENTS];
    /* the same with a faulty document; empty: no such run */
    const char *faulty[MAX_ARGUMENTS];
    bool index; /* out/manifest.json lists the files of out */
    bool cache;
} Scenario;
extern const Scenario scenarios[SCENARIOS];

/* Below root: the documents, the folder "old" from before the run, and "now", in which matc
 * runs. */
typedef struct {
    char root[PATH_CAPACITY / 4];
    Bytes before, after;    /* the folder before the run, and as expected after it */
    char *calls[MAX_CALLS]; /* names of the calls in order, from 1 */
    long call_count;
    int wrong;
    int left;   /* runs that succeeded and left files to remove */
    int halves; /* runs that failed while moving files */
} World;

/* The scenario and the number of the struck call. */
typedef struct {
    const Scenario *scenario;
    long n;
    const char *how;
} Strike;

/* Setup and teardown of a test, whose state is a World. */
#define WORLD_TEST(name) cmocka_unit_test_setup_teardown(name, world_make, world_remove)
int world_make(void **state);
int world_remove(void **state);

/* Records the folder before the run and after it, and the calls, from an undisturbed run. */
void world_prepare(World *w, const Scenario *s);
/* Restores "now" to its state before the run. */
void world_reset(const World *w);
/* Returns matc's exit status; -1: killed. Call number `at`, from 1, is struck by the method
 * `how` of strike.c; NULL: none. */
int world_run(World *w, const char *const *arguments, long at, const char *how);
/* True if the output of the last run contains the text. */
bool world_says(const World *w, const char *what);
/* Counts and reports a failed check. */
void world_check(World *w, bool fine, const Strike *at, const char *what);

/* A path below the root. */
void world_path(const World *w, const char *name, char path[PATH_CAPACITY]);
/* All names and bytes below a folder, except the cache's; without files that only the next run
 * removes, unless `hidden`. */
Bytes world_tree(const char *path, bool hidden);
/* True if "now" has the content of the tree. */
bool world_is(const World *w, const Bytes *tree, bool hidden);
/* True if there is no manifest, or the old one with all old files, or the new one with all new
 * files. */
bool world_index_is_true(const World *w);
/* True if a call's name is in a list, which ends with NULL. */
bool call_is_one_of(const char *name, const char *const *names);
#endif
