/* A commit as a list of intents that is carried out by its own process or by the next one.
 * Internal to staging*.c. */
#ifndef MATC_STAGING_COMMIT_H
#define MATC_STAGING_COMMIT_H
#include "compiler/base/bytes.h"
#include "compiler/base/staging_folder.h"
#include <time.h>

typedef enum {
    INTENT_hide,   /* the folder's index goes while what it lists changes */
    INTENT_put,    /* a staged file takes its place in the folder */
    INTENT_remove, /* a file with that hash goes */
    INTENT_KINDS
} IntentKind;

typedef struct {
    IntentKind kind;
    int number;       /* the staged file, see intent_file(); of a hidden index: the new one */
    Key hash;         /* of a file to remove */
    const char *name; /* in the folder */
} Intent;

enum { STAGED_NAME = 16 };
void intent_file(char name[STAGED_NAME], int number);

void intent_add(Bytes *intents, const Intent *intent);
/* Writes the list beside the staged files. From then on the next run finishes it after a kill. */
const char *intents_write(const Stage *stage, const Bytes *intents);
/* Carries the list out, in its order, and adds to *done for each intent. `since`: when the list was written, if
 * its process has ended: what is done already, or was changed later, is left alone; else NULL. NULL, or
 * the reason of the first failure. */
const char *intents_apply(const Stage *stage, const Bytes *intents, const struct timespec *since, int *done);
/* Withdraws a list of which nothing is done. */
void intents_withdraw(const Stage *stage);
/* Locks the folder against other commits, for half a minute at most, and finishes those of ended
 * processes. NULL, or the reason: then it is not locked. */
const char *intents_lock(int folder);
void intents_unlock(int folder);
#endif
