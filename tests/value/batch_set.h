/* Documents in a folder of their own, with variants that differ in numbers, compiled by matc -d
 * as one batch. */
#ifndef MATC_VALUE_BATCH_SET_H
#define MATC_VALUE_BATCH_SET_H
#include <cjson/cJSON.h>
#include <stdbool.h>
#include <stddef.h>

enum { SET_PATH = 512 };

typedef struct {
    char folder[64];
    int count;       /* number of documents d0.yaml, d1.yaml, ... */
    cJSON *manifest; /* manifest of the last run */
} BatchSet;

/* Creates a folder below /tmp that contains the examples' picture. */
bool batch_set_open(BatchSet *set);
void batch_set_close(BatchSet *set);
/* Adds the text and `variants` versions of it: every number with a fraction is multiplied by a
 * factor, every digit of a color replaced. Invalid documents are skipped. Returns the number of
 * documents added. */
int batch_set_add(BatchSet *set, const char *text, int variants);
/* Runs matc with these options; false if it failed or its manifest is invalid. */
bool batch_set_run(BatchSet *set, const char *matc, const char *options);
/* A file of the last run, from malloc; NULL if it is missing. */
char *batch_set_file(const BatchSet *set, const char *name, size_t *size);
/* The last run's file that ends in .layout.yaml. */
char *batch_set_layout(const BatchSet *set, size_t *size);
#endif
