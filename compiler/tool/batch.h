/* Compiles many documents into one folder as a set: equal programs are written once, and a
 * manifest lists the programs of each material. */
#ifndef MATC_BATCH_H
#define MATC_BATCH_H
#include "grammar/tables.h"
#include "compiler/tool/options.h"

typedef struct {
    /* Prints diagnostics, in the order of the documents. */
    void (*say)(void *user, const char *text);
    /* Reports documents read so far; called on any thread, one call at a time. */
    void (*progress)(void *user, int done, int documents);
    /* Reports that the cache could not store an entry. */
    void (*trouble)(void *user, const char *folder, const char *why);
    /* Changes the options for one material (--max-error). Returns false after reporting a
     * failure. The number of threads must then be 1. */
    bool (*choose)(void *user, const MatcDocument *document, int material, MatcOptions *options);
    void *user;
} BatchCalls;

typedef struct {
    int documents, materials, programs;
    int passes[PASS_COUNT]; /* number of programs per pass */
    /* number of programs whose materials differ in constants of a uniform block */
    int buffered;
    int written; /* number of files that changed */
} BatchResult;

/* Compiles all inputs of the command line into its folder. Returns false and writes nothing if
 * there is any fault. */
bool batch_run(const CommandLine *line, const BatchCalls *calls, BatchResult *result);
#endif
