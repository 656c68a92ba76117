/* A folder within a folder, where files wait. Its file "journal" is locked while its process lives; a folder whose journal is not
 * is of a process that was ended, and whoever comes next undoes what its journal tells, if it tells anything, and removes it. Internal to staging*.c. */
#ifndef MATC_STAGING_FOLDER_H
#define MATC_STAGING_FOLDER_H
#include "compiler/base/hash.h"

enum { WAITING_NAME = 32 };

/* The name of one whose files are being moved: only one process at a time has it. */
extern const char waiting_commit[];

typedef struct {
    int folder;  /* that the files are for: the caller's */
    int at;      /* this one, open; -1: none */
    int journal; /* open and locked */
    char name[WAITING_NAME];
} Waiting;

typedef enum {
    TAKEN,
    TAKEN_none, /* it is not there any more */
    TAKEN_by_other,
    TAKEN_strange /* matc makes nothing like it */
} Taken;

/* Makes one with an empty journal. NULL, or why not. */
const char *waiting_make(Waiting *waiting, int folder);
/* Opens one of this user that a process left. A link of its name goes; what it leads to stays. */
Taken waiting_take(Waiting *waiting, int folder, const char *name);
/* Gives it another name. False: errno. */
bool waiting_rename(Waiting *waiting, const char *name);
/* Empties its journal: what is in it is of no more use. False: errno. */
bool waiting_finish(const Waiting *waiting);
/* Closes it, and leaves it to the next run. */
void waiting_leave(Waiting *waiting);
/* Removes the files that a run makes in it, and itself. What cannot be removed the next run removes. False: it has other files, and
 * stays with them. */
bool waiting_remove(Waiting *waiting);
/* Removes those in the folder that processes left, but for a commit. */
void waiting_clean(int folder);

/* A new file of these bytes. NULL, or why not: then there is none. */
const char *waiting_write(const Waiting *waiting, const char *name, const void *bytes, size_t size);
/* The hash of a file's bytes. 0; or errno, EINVAL where it is no regular file. */
int waiting_hash(int folder, const char *name, Key *hash);
/* Writes all, or says why not. */
const char *waiting_put(int file, const void *bytes, size_t size);
#endif
