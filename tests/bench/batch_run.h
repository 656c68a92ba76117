/* A folder of documents, and processes of matc that compile them. */
#ifndef BATCH_RUN_H
#define BATCH_RUN_H
#include "compiler/base/text.h"
#include <stdbool.h>

enum { BATCH_PATH = 1024, BATCH_ARGUMENTS = 16 };

typedef struct {
    char path[256];   /* created below TMPDIR for the run, removed after it */
    const char *matc; /* path of matc */
    size_t bytes;     /* bytes of all documents */
} BatchFolder;

/* Time and memory of a process. */
typedef struct {
    double seconds, cpu; /* wall time; CPU time of all threads */
    long memory;         /* peak resident, KiB; 0: the process was too short */
} BatchTimes;

bool batch_folder_make(BatchFolder *folder, const char *matc);
void batch_folder_remove(const BatchFolder *folder);
/* Writes documents 0 to count - 1, their pictures, and NAME.txt, a list of the documents. */
bool batch_folder_fill(BatchFolder *folder, const char *name, int count,
                       void (*write)(int index, Text *out));
/* Writes NAME.txt, a list of some of the documents, optionally in reverse order. */
bool batch_folder_list(const BatchFolder *folder, const char *name, int first, int end, bool back);
/* Runs matc -d FOLDER/out @FOLDER/list arguments..., terminated by NULL. A failure prints matc's
 * messages. */
bool batch_run(const BatchFolder *folder, const char *list, const char *out,
               const char *const *arguments, BatchTimes *times);
/* Content of FOLDER/cache. */
typedef struct {
    long entries, bytes;
} BatchCache;
BatchCache batch_cache(const BatchFolder *folder);
/* Removes FOLDER/name and all below it. */
void batch_clear(const BatchFolder *folder, const char *name);
/* FOLDER/out/name as a text from malloc; NULL if it cannot be read. */
char *batch_read(const BatchFolder *folder, const char *out, const char *name);
#endif
