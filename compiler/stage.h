/* The files of a batch: nothing of the folder changes until all is known to be well, and what is there already stays as it is. */
#ifndef MATC_STAGE_H
#define MATC_STAGE_H
#include <stdbool.h>
#include <stddef.h>

typedef struct Stage Stage;

/* NULL: *why, which need not be freed. The folder is made if need be, and goes again if nothing comes into it. */
Stage *stage_open(const char *folder, const char **why);
/* Keeps a file for the folder; equal bytes there already are left alone. Any thread; a name once. NULL, or why not. */
const char *stage_put(Stage *stage, const char *name, const void *bytes, size_t size);
/* Forgets a file again. */
void stage_drop(Stage *stage, const char *name);
/* The file is to be moved into the folder. */
bool stage_holds(const Stage *stage, const char *name);
/* Moves all files into the folder. NULL, or why not. */
const char *stage_commit(Stage *stage);
/* A file of the folder that an earlier run wrote and this one did not is removed. After the commit. */
void stage_remove_stale(Stage *stage, const char *name);
/* Files that commit moved. */
int stage_written(const Stage *stage);
/* Gives up what was not committed. */
void stage_close(Stage *stage);
#endif
