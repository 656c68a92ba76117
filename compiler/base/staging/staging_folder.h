/* Staging folders: hidden folders ".matc-stage-XXXXXX" within an output folder, each locked
 * while its process is alive. New files wait there, so that moving them is a rename. Internal to
 * staging*.c. */
#ifndef MATC_STAGING_FOLDER_H
#define MATC_STAGING_FOLDER_H
#include "compiler/base/hash.h"

enum { STAGE_NAME = 32 };

typedef struct {
    int folder; /* the output folder, which the caller keeps open */
    int at;     /* the staging folder, open and locked; -1: closed */
    char name[STAGE_NAME];
} Stage;

/* Creates an empty staging folder and locks it. Returns NULL or a fault. */
const char *stage_make(Stage *stage, int folder);
/* Writes a file, replacing an existing one. Returns NULL, or a fault; the file is then absent. */
const char *stage_write(const Stage *stage, const char *name, const void *bytes, size_t size);
/* Closes the folder and leaves it to the next run. */
void stage_leave(Stage *stage);
/* Removes the folder and its files. The next run removes files that cannot be removed now. */
void stage_remove(Stage *stage);
/* Calls `finish` for each staging folder whose process has ended, and removes the folder if
 * `finish` returns NULL. Stops at the first fault that `finish` returns, and returns it. */
const char *stage_each_abandoned(int folder, const char *(*finish)(const Stage *stage));

/* Hashes a file's bytes without following a link. Returns 0 or errno; EINVAL if it is not a
 * regular file. */
int stage_hash(int folder, const char *name, Key *hash);
#endif
