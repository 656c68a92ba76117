/* Staging folders: hidden folders ".matc-stage-XXXXXX" within an output folder, each locked while
 * its process lives. New files wait there, so that moving them is a rename. Internal to staging*.c. */
#ifndef MATC_STAGING_FOLDER_H
#define MATC_STAGING_FOLDER_H
#include "compiler/base/hash.h"

enum { STAGE_NAME = 32 };

typedef struct {
    int folder; /* the output folder, which the caller keeps open */
    int at;     /* the staging folder, open and locked; -1: none */
    char name[STAGE_NAME];
} Stage;

/* Makes an empty one. Returns NULL, or the reason of the failure. */
const char *stage_make(Stage *stage, int folder);
/* Writes a new file, and replaces one of the same name. NULL, or the reason: then there is none. */
const char *stage_write(const Stage *stage, const char *name, const void *bytes, size_t size);
/* Closes it and leaves it to the next run. */
void stage_leave(Stage *stage);
/* Removes its files and itself. The next run removes what cannot be removed now. */
void stage_remove(Stage *stage);
/* Gives each staging folder whose process has ended to `finish`, and removes those that it accepts.
 * The first reason that `finish` returns is the result. */
const char *stage_each_abandoned(int folder, const char *(*finish)(const Stage *stage));

/* Hashes a file's bytes. 0, or errno: EINVAL if it is no regular file. Follows no link. */
int stage_hash(int folder, const char *name, Key *hash);
#endif
