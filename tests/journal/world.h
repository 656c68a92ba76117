/* A folder whose run was ended in the middle of moving its files, for the tests of its journal: what lies there, the journal's bytes,
 * and what the next run makes of it. Faults are those of the test. */
#ifndef MATC_JOURNAL_WORLD_H
#define MATC_JOURNAL_WORLD_H
#include "compiler/base/bytes.h"
#include "compiler/base/staging_journal.h"
#include <sys/types.h>

enum { PATH_ROOM = 256 };

/* The folder that is written to is root/out; nothing beside it may change either. */
typedef struct {
    char root[PATH_ROOM];
    int out;
    Bytes before, ended; /* the tree below root before the run, and when it was ended */
    char *journal;
    size_t size;
} World;

#define CHANGED  "// changed.frag, new\n"
#define COMING   "// coming.frag, new\n"
#define MANIFEST "{\"new\": 1}\n"

/* Setup and teardown of a test, whose state is a World. */
#define WORLD_TEST(name) cmocka_unit_test_setup_teardown(name, world_make, world_remove)
int world_make(void **state);
int world_remove(void **state);

/* A path below the root, until the next but three. */
const char *world_at(const World *world, const char *name);
void world_put_bytes(const World *world, const char *name, const void *bytes, size_t size);
void world_put(const World *world, const char *name, const char *text);
/* Whether it is a file with that text; whether anything has that name. */
bool world_has(const World *world, const char *name, const char *text);
bool world_is_there(const World *world, const char *name);

/* Names, kinds and bytes of all that lies there; of one file. */
Bytes world_tree(const char *path);
void world_add_contents(Bytes *tree, const char *path, mode_t mode);
void world_assert_is(const World *world, const Bytes *wanted);

Key world_hash(const char *text);
/* One file changes, one comes, one goes, and the manifest is another. It ends when all is moved, before that counts. */
void world_end_a_run(World *world);
void world_put_journal(const World *world, const void *bytes, size_t size);
/* The next run says why, and all is as it is: twice, since the first may have left something. */
void world_assert_refused(const World *world, const char *word);
#endif
