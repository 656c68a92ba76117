/* What a commit does, as a list of steps that can be undone, also by the next process. Internal to staging*.c. */
#ifndef MATC_STAGING_JOURNAL_H
#define MATC_STAGING_JOURNAL_H
#include "compiler/base/staging_folder.h"

typedef enum {
    STEP_put,    /* the folder gets a file that waits */
    STEP_remove, /* the folder loses a file */
    STEP_index, /* as put; it tells what is in the folder, so it is not there while that changes. The last step, if there is one */
    STEP_KINDS
} StepKind;

typedef struct {
    StepKind kind;
    int number;       /* where they wait the new file is called "N", the old one "N.old" */
    Key hash;         /* of the new file */
    const char *name; /* in the folder */
} Step;

typedef struct {
    Step *at;
    int count;
} Steps;

/* The new file's name where it waits. */
enum { NUMBER_NAME = 24 };
void step_file(char name[NUMBER_NAME], int number);

/* Writes the steps down and begins: the folder where files wait gets the name that one at a time has. NULL, or why not; nothing has
 * changed then. */
const char *steps_begin(Waiting *waiting, const Steps *steps);
/* Does them all. NULL, or why not: then they are to be undone. */
const char *steps_do(const Waiting *waiting, const Steps *steps);
/* From now on they are done, whatever comes. NULL, or why not. */
const char *steps_end(const Waiting *waiting);
/* Undoes those that were done. False, and errno: the next run must. */
bool steps_undo(const Waiting *waiting, const Steps *steps);
/* Undoes a commit in the middle of which its process ended. NULL, also where there is none; or why not. */
const char *steps_recover(int folder);
#endif
