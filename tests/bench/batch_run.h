/* A folder of documents, and processes of matc that compile them. */
#ifndef BATCH_RUN_H
#define BATCH_RUN_H
#include "compiler/base/text.h"
#include <stdbool.h>

enum { BATCH_PATH = 1024, BATCH_ARGUMENTS = 16 };

typedef struct {
    char path[256];   /* made below TMPDIR for the run, removed after it */
    const char *matc; /* the program */
    size_t bytes;     /* of all documents */
} BatchFolder;

/* Time and memory of a process. */
typedef struct {
    double seconds, cpu; /* wall, and of all threads */
    long memory;         /* greatest resident, KiB; 0: it ended too soon to tell */
} BatchTimes;

bool batch_folder_make(BatchFolder *folder, const char *matc);
void batch_folder_remove(const BatchFolder *folder);
/* Writes documents 0 to count - 1, what they need, and NAME.txt, which lists them. */
bool batch_folder_fill(BatchFolder *folder, const char *name, int count,
                       void (*write)(int index, Text *out));
/* Writes NAME.txt, which lists some of those documents, also from the last to the first. */
bool batch_folder_list(const BatchFolder *folder, const char *name, int first, int end, bool back);
/* matc -d FOLDER/out @FOLDER/list arguments..., NULL behind the last. It must succeed; else what it
 * says is shown. */
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
