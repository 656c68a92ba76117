/* Files that are written as a transaction. The output folder changes only in staging_commit(),
 * completely or not at all, even if the process is killed. Files with unchanged bytes are left
 * untouched. */
#ifndef MATC_STAGING_H
#define MATC_STAGING_H
#include "compiler/base/hash.h"

typedef struct Staging Staging;

typedef enum {
    /* Creates the folder if it is missing, and removes it if no file is committed. */
    STAGING_new_folder = 1,
    /* Replaces files even by equal bytes, since make compares modification times. */
    STAGING_renew = 2
} StagingHow;

typedef struct {
    const char *name;
    Key hash; /* hash of the bytes */
} StagingFile;

/* Opens a folder. Returns NULL and *why (not to be freed) on failure. An interrupted commit of
 * an earlier process is finished first. */
Staging *staging_open(const char *folder, unsigned how, const char **why);
/* Returns true if two stagings have the same folder, perhaps under different paths; the second
 * must then not be used. */
bool staging_same(const Staging *a, const Staging *b);
/* Stages a file, on any thread; each name at most once. Returns NULL or a fault. */
const char *staging_put(Staging *staging, const char *name, const void *bytes, size_t size);
/* Stages the index, which describes the folder's content: it is removed while the content
 * changes. At most one for each folder. */
const char *staging_put_index(Staging *staging, const char *name, const void *bytes, size_t size);
/* Removes a staged file from the staging. */
void staging_drop(Staging *staging, const char *name);
/* Returns true if the file is staged, to be moved into the folder. */
bool staging_holds(const Staging *staging, const char *name);
/* Returns this run's files of the folder, sorted by name; from malloc. */
StagingFile *staging_list(const Staging *staging, int *count);
/* Marks a file of an earlier run for removal, if this run does not write it. If its bytes no
 * longer have the hash, the file stays and *stays is true. Returns NULL, or a fault if the file
 * cannot be read. */
const char *staging_remove(Staging *staging, const char *name, Key hash, bool *stays);
/* Reads a file of the folder, with a terminating zero, from malloc. Returns NULL if it is
 * missing or a link; NULL and *why if it cannot be read. */
char *staging_read(const Staging *staging, const char *name, const char **why);
/* Carries out all moves and removals of all these folders, or none. Returns NULL or a fault. */
const char *staging_commit(Staging *const *stagings, int count);
/* Returns the number of files that commits have moved. */
int staging_written(const Staging *staging);
/* Discards uncommitted files and closes the staging. */
void staging_close(Staging *staging);
#endif
