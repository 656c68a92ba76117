/* What the parts of a batch share. Private to batch*.c and manifest.c. */
#ifndef MATC_BATCH_STATE_H
#define MATC_BATCH_STATE_H
#include "batch.h"
#include "sets.h"
#include "stage.h"
#include "unit.h"
#include <pthread.h>

enum { MOST_TURNS = PASS_COUNT, LONGEST_NAME = 256 };

/* What a batch does with numbers: they stand in programs; those of the document come from a buffer; or those do in which
 * materials of one shape differ. */
typedef enum { NUMBERS_baked, NUMBERS_uniform, NUMBERS_auto } Numbers;

typedef struct {
    const char *name; /* of the document's list */
    const char *opacity;
    Unit units[MOST_TURNS]; /* by turn */
} BatchMaterial;

typedef struct {
    const char *path;
    MatcDocument *document; /* while its materials are compiled */
    BatchMaterial *materials;
    int material_count;
    int offset;     /* of the first in the document: --material takes one */
    char **names;   /* copies, by material */
    char **depends; /* files that it was made from */
    int depend_count;
    Bytes said; /* diagnostics */
    bool fault, closed;
    int *again, again_count; /* programs to be written for its materials, once all are known */
} BatchDocument;

typedef struct {
    Unit *first, *last; /* its materials, linked; the first one gives it its name */
    int unit_count;
    int *members; /* by place: the member that it becomes; NULL: all numbers stand in the program */
    char *name;   /* of its files, without suffix */
} BatchProgram;

typedef struct {
    const CommandLine *line;
    const BatchCalls *calls;
    const char *turns[MOST_TURNS]; /* passes asked for */
    int turn_count;
    Numbers numbers;
    unsigned outputs; /* MatcOutput of a program */
    MatcOptions options;
    BatchDocument *documents;
    int document_count;
    BatchProgram *programs;
    int program_count;
    Stage *stage, *textures;
    pthread_mutex_t mutex; /* of what follows */
    KeySet seen;           /* programs that someone writes already */
    int closed, said;      /* documents whose diagnostics are complete; and were said, from the first on */
    Bytes general;         /* diagnostics of no document */
    bool fault;
} Batch;

/* Programs out of units: groups them by key or by shape, decides which numbers come from a buffer, names them, and lists what
 * must be written again. batch_group.c */
void batch_group(Batch *batch);
/* Writes the files of a program for one of its materials; `base` is their name. Takes what the manifest needs of it. */
bool batch_write(Batch *batch, BatchDocument *document, Unit *unit, MatcProgram *program, const char *base);
/* Something against the document: text, as it is said. */
void batch_complain(Batch *batch, BatchDocument *document, const char *what, const char *why);
/* The manifest as JSON, in the arena. manifest.c */
const char *manifest_text(const Batch *batch, Arena *arena);
/* Removes files that the old manifest names and this batch did not make. */
void manifest_remove_stale(const Batch *batch, const char *old);
Unit *batch_unit(const Batch *batch, int document, int material, int turn);
/* Of the files of a material's program: its name, and the pass unless that goes without saying. */
void batch_name(const Batch *batch, const Unit *unit, char name[LONGEST_NAME]);
#endif
