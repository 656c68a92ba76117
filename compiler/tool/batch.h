/* Many documents into one folder, as one set: equal programs are written once, and a manifest says
 * which material uses which. */
#ifndef MATC_BATCH_H
#define MATC_BATCH_H
#include "grammar/tables.h"
#include "compiler/tool/options.h"

typedef struct {
    /* diagnostics, in the order of the documents */
    void (*say)(void *user, const char *text);
    /* documents read so far; on any thread, one at a time */
    void (*progress)(void *user, int done, int documents);
    /* the cache could not keep something */
    void (*trouble)(void *user, const char *folder, const char *why);
    /* Changes the options for one material (--max-error); false: it cannot, and has said why. Then
     * threads must be 1. */
    bool (*choose)(void *user, const MatcDocument *document, int material, MatcOptions *options);
    void *user;
} BatchCalls;

typedef struct {
    int documents, materials, programs;
    int passes[PASS_COUNT]; /* programs of each */
    int buffered;           /* programs whose materials differ in numbers from a buffer */
    int written;            /* files that changed */
} BatchResult;

/* Compiles all inputs of the command line into its folder. With any fault nothing is written, and
 * false. */
bool batch_run(const CommandLine *line, const BatchCalls *calls, BatchResult *result);
#endif
