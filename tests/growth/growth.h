/* Documents that grow: one table of them, for test_growth.c and matbench growth. */
#ifndef MATC_GROWTH_H
#define MATC_GROWTH_H
#include "compiler/matc.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* a row's longest document has this many times the parts of its shortest */
enum { GROWTH_FACTOR = 8 };

typedef struct {
    const char *name;
    const char *options; /* "coordinates=long O0 ..."; see growth.c */
    int count;           /* parts of the shortest document */
    bool faulty;         /* the document has errors */
    bool deep;           /* the maps are nested; else they are siblings */
    const char *head;    /* text before the parts; deep: the outermost map */
    const char *part;    /* $ is its number, @ the part before it */
    const char *middle;  /* text after the parts */
    const char *close;   /* then this text once for each part */
    const char *tail;    /* text at the end */
} GrowthRow;

extern const GrowthRow growth_table[];
extern const int growth_count;

/* A row's document of `count` parts; from malloc. */
char *growth_text(const GrowthRow *row, int count, size_t *size);
/* CPU seconds of this thread to read the document and to compile its last material to every
 * output, and the sizes. */
typedef struct {
    double seconds;
    size_t read, written; /* bytes of the document, of the outputs and diagnostics */
    int errors;
} GrowthRun;
GrowthRun growth_run(const GrowthRow *row, int count);
/* The time of the fastest of several runs. */
double growth_seconds(const GrowthRow *row, int count, int runs);
/* Reads a scene, and counts its size; growth_scene.c. */
void growth_scene(const char *text, const MatcOptions *options, GrowthRun *run);
/* Writes and reads a mesh file with that ending: includes CPU seconds of the importing process;
 * growth_mesh.c. */
void growth_mesh(const char *text, const char *ending, GrowthRun *run);
/* Writes a part of a row, with its number for $ and a reference to the previous part for @. */
void growth_put_part(FILE *out, const char *part, int number);

/* Kinds of batch runs, for one `matc -d`; growth_batch.c. */
typedef enum {
    GROWTH_FRESH,     /* into a new folder */
    GROWTH_UNCHANGED, /* a second run without changes */
    GROWTH_CACHED,    /* into a new folder, all programs from a cache */
    GROWTH_FEWER      /* after a run with twice as many, so that half of the files are removed */
} GrowthBefore;
typedef struct {
    const char *name, *options; /* options of the command line */
    int count;                  /* number of documents of the shorter batch */
    GrowthBefore before;
    const char *part; /* one document */
} GrowthBatch;
extern const GrowthBatch growth_batches[];
extern const int growth_batch_count;
/* CPU seconds of the program matc with `count` documents of a row: the fastest of several runs.
 * Infinite if it fails. */
double growth_batch_seconds(const GrowthBatch *row, const char *matc, int count, int runs);
#endif
