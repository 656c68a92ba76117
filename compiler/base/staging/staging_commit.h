/* A commit as a list of intents. The process that wrote the list carries it out, or, after a kill,
 * the next process that opens the folder. Internal to staging*.c. */
#ifndef MATC_STAGING_COMMIT_H
#define MATC_STAGING_COMMIT_H
#include "compiler/base/bytes.h"
#include "compiler/base/staging/staging_folder.h"
#include <time.h>

typedef enum {
    INTENT_hide,   /* remove the folder's index while the files that it lists change */
    INTENT_put,    /* move a staged file into the output folder */
    INTENT_remove, /* remove a file of the last run; after a kill only if it has this hash */
    INTENT_KINDS
} IntentKind;

typedef struct {
    IntentKind kind;
    int number;       /* staged file, see intent_file(); for hide: the new index */
    Key hash;         /* INTENT_remove: hash of the file to be removed */
    const char *name; /* file name in the output folder */
} Intent;

enum { STAGED_NAME = 16 };
void intent_file(char name[STAGED_NAME], int number);

void intent_add(Bytes *intents, const Intent *intent);
/* Writes the list into the staging folder. From then on a kill does not stop the commit: the
 * next run finishes it. Returns NULL or a fault. */
const char *intents_write(const Stage *stage, const Bytes *intents);
/* Carries out the list in order and counts the finished intents in *done. Returns NULL or the
 * first fault. `since` is NULL in the process that wrote the list. In a later process `since` is
 * the time at which the list was written: intents that are already done, and files that changed
 * later, are skipped. */
const char *intents_apply(const Stage *stage, const Bytes *intents, const struct timespec *since,
                          int *done);
/* Deletes a list of which no intent was carried out. */
void intents_withdraw(const Stage *stage);
/* Locks the folder against other commits, waiting at most 30 s, and finishes the commits of
 * ended processes. Returns NULL, or a fault; the folder is then not locked. */
const char *intents_lock(int folder);
void intents_unlock(int folder);
#endif
