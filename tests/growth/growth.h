/* Documents that grow: one table of them, for test_growth.c and matbench growth. */
#ifndef MATC_GROWTH_H
#define MATC_GROWTH_H
#include "compiler/matc.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* a row's longest document has so many times the parts of its shortest */
enum { GROWTH_FACTOR = 8 };

typedef struct {
    const char *name;
    const char *options; /* "coordinates=long O0 ..."; see growth.c */
    int count;           /* parts of the shortest document */
    bool faulty;         /* the document has errors */
    bool deep;           /* the parts are maps over one another; else they stand side by side */
    const char *head;    /* what stands before the parts; deep: the map over all of them */
    const char *part;    /* $ is its number, @ the part before it */
    const char *middle;  /* behind the parts */
    const char *close;   /* then, once for each part */
    const char *tail;    /* what stands behind all of it */
} GrowthRow;

extern const GrowthRow growth_table[];
extern const int growth_count;

/* A row's document of that many parts; from malloc. */
char *growth_text(const GrowthRow *row, int count, size_t *size);
/* CPU seconds of this thread to read the document and to compile its last material into everything,
 * and what it came to. */
typedef struct {
    double seconds;
    size_t read, written; /* bytes of the document, of the outputs and diagnostics */
    int errors;
} GrowthRun;
GrowthRun growth_run(const GrowthRow *row, int count);
/* The quickest of several runs. */
double growth_seconds(const GrowthRow *row, int count, int runs);
/* Reads a scene, and counts what it came to; growth_scene.c. */
void growth_scene(const char *text, const MatcOptions *options, GrowthRun *run);
/* Writes a file of a mesh, of that ending, and reads it: CPU seconds of the process that imports
 * it, too; growth_mesh.c. */
void growth_mesh(const char *text, const char *ending, GrowthRun *run);
/* A part of a row, with its number for $ and a reference to the part before it for @. */
void growth_put_part(FILE *out, const char *part, int number);

/* Documents side by side, for one `matc -d`; growth_batch.c. */
typedef enum {
    GROWTH_FRESH,     /* into a new folder */
    GROWTH_UNCHANGED, /* again, with nothing changed */
    GROWTH_CACHED,    /* into a new folder, all of them from a cache */
    GROWTH_FEWER      /* where twice as many have been: half of the files go */
} GrowthBefore;
typedef struct {
    const char *name, *options; /* of the command line */
    int count;                  /* documents of the shorter batch */
    GrowthBefore before;
    const char *part; /* one document */
} GrowthBatch;
extern const GrowthBatch growth_batches[];
extern const int growth_batch_count;
/* CPU seconds of matc, the program of that name, with so many of a row's documents: the quickest of
 * several runs. Infinite: it fails. */
double growth_batch_seconds(const GrowthBatch *row, const char *matc, int count, int runs);
#endif
