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
    int count;       /* documents: d0.yaml, d1.yaml, ... */
    cJSON *manifest; /* of the last run */
} BatchSet;

/* A new folder below /tmp, with the examples' picture in it. */
bool batch_set_open(BatchSet *set);
void batch_set_close(BatchSet *set);
/* Adds the text and `variants` more of it: every number with a fraction times a factor, every digit
 * of a colour another one. Those that are no valid document are left out. The number of documents
 * added. */
int batch_set_add(BatchSet *set, const char *text, int variants);
/* Runs matc with these options; false: it failed, or its manifest is none. */
bool batch_set_run(BatchSet *set, const char *matc, const char *options);
/* A file of the last run, from malloc; NULL: it is not there. */
char *batch_set_file(const BatchSet *set, const char *name, size_t *size);
/* "layout" is that file of the run which ends in .layout.yaml. */
char *batch_set_layout(const BatchSet *set, size_t *size);
#endif
