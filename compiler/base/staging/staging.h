/* Files that are written together: nothing of their folder changes until all is known to be well,
 * then all of it, whatever may fail or end the process; and what is there already stays as it
 * is. */
#ifndef MATC_STAGING_H
#define MATC_STAGING_H
#include "compiler/base/hash.h"

typedef struct Staging Staging;

typedef enum {
    /* the folder is made if need be, and goes again if nothing comes into it */
    STAGING_new_folder = 1,
    /* files are replaced by equal ones, too: their times tell make that they are made */
    STAGING_renew = 2
} StagingHow;

typedef struct {
    const char *name;
    Key hash; /* of its bytes */
} StagingFile;

/* NULL: *why, which need not be freed. What an earlier process left in the middle is undone. */
Staging *staging_open(const char *folder, unsigned how, const char **why);
/* Both are of one folder, by whatever name: then the second must not be used. */
bool staging_same(const Staging *a, const Staging *b);
/* Keeps a file for the folder. Any thread; a name once. NULL, or why not. */
const char *staging_put(Staging *staging, const char *name, const void *bytes, size_t size);
/* Stages the index, which describes the folder's content: it is removed while the content changes.
 * At most one for each folder. */
const char *staging_put_index(Staging *staging, const char *name, const void *bytes, size_t size);
/* Forgets a file again. */
void staging_drop(Staging *staging, const char *name);
/* The file is to be moved into the folder. */
bool staging_holds(const Staging *staging, const char *name);
/* Files of this run that the folder will have, sorted by name; from malloc. */
StagingFile *staging_list(const Staging *staging, int *count);
/* A file of the folder that an earlier run wrote, with that hash, and this one does not: it will
 * go, unless it is another file by now: then *stays. NULL, or why it cannot be known. */
const char *staging_remove(Staging *staging, const char *name, Key hash, bool *stays);
/* A file of the folder, with a zero byte behind, from malloc. NULL: there is none, or a link; or it
 * cannot be read, and *why. */
char *staging_read(const Staging *staging, const char *name, const char **why);
/* Moves and removes what is to be, in all these folders or in none. NULL, or why not. */
const char *staging_commit(Staging *const *stagings, int count);
/* Files that commit moved. */
int staging_written(const Staging *staging);
/* Gives up what was not committed. */
void staging_close(Staging *staging);
#endif
