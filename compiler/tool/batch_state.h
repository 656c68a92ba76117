/* State that the parts of a batch share. Private to batch*.c and manifest.c. */
#ifndef MATC_BATCH_STATE_H
#define MATC_BATCH_STATE_H
#include "compiler/tool/batch.h"
#include "compiler/tool/cache.h"
#include "compiler/base/sets.h"
#include "compiler/base/output.h"
#include "compiler/tool/unit.h"
#include <pthread.h>
#include <stdatomic.h>

enum { LONGEST_NAME = 256, LONGEST_PATH = 4096 };

/* Where a batch keeps constants: in programs; in a buffer, for those of the document; or in a
 * buffer for those in which materials of one shape differ. */
typedef enum { NUMBERS_baked, NUMBERS_uniform, NUMBERS_auto } Numbers;

typedef struct {
    char *name;
    const char *opacity; /* matc_opacity */
    Bytes said;          /* diagnostics, which follow those of the document */
    Unit *units;         /* by request */
} BatchMaterial;

typedef struct {
    const char *path;
    char *text; /* while its materials are compiled, and it itself */
    size_t size;
    /* of all that its materials' programs depend on but for the files it is made from */
    Key key;
    MatcDocument *parsed; /* while someone needs it */
    BatchMaterial *materials;
    Unit *units; /* of all of them */
    int material_count;
    int offset;     /* of the first in the document: --material takes one */
    char **depends; /* files that it was made from, itself first */
    int depend_count;
    MatcRanges *ranges; /* with --layout=auto, while it is open */
    bool stored;        /* the cache has it */
    /* something was said of it, so that it is not kept: the next run would be silent */
    bool spoke;
    bool unreadable; /* which is said */
    bool once;       /* a pipe, which can be read but once: its text is kept */
    Bytes said;      /* diagnostics */
    bool closed;
    int *again, again_count; /* programs to be written for its materials, once all are known */
    pthread_mutex_t mutex;   /* of `parsed` */
} BatchDocument;

typedef struct {
    Unit *first, *last; /* its materials, linked; the first one gives it its name */
    int unit_count;
    int *members; /* by place: the member that it becomes; NULL: all numbers stand in the program */
    char *name;   /* of its files, without suffix */
} BatchProgram;

/* A program to be written: a unit's, with the numbers at those places from a buffer (NULL: none),
 * under that name. */
typedef struct {
    Unit *unit;
    const int *members;
    const char *base;
} BatchEdition;

typedef struct {
    const char *base, *suffix; /* of its name */
} BatchFile;

typedef struct {
    const CommandLine *line;
    const BatchCalls *calls;
    const char *requests[MOST_PASSES]; /* passes asked for */
    int request_count;
    Numbers numbers;
    unsigned outputs; /* MatcOutput of a program */
    MatcOptions options;
    BatchDocument *documents;
    int document_count;
    BatchProgram *programs;
    int program_count;
    MatcRanges ranges;  /* of all documents, with --layout=auto */
    MatcLayout *layout; /* made for the set, or NULL */
    Outputs folders;    /* all that is written */
    /* of the folder, and of --textures, which may be the same; NULL: none */
    Staging *staging, *textures;
    MatcLinked *linked;    /* in the options of all */
    Cache *cache;          /* NULL: none */
    pthread_mutex_t mutex; /* of what follows */
    /* files that the batch reads and that lie in its folder, by their names there */
    StringSet within;
    KeySet seen;     /* programs that someone writes already */
    StringSet files; /* what documents are made from, as it was read */
    Key *file_keys;  /* its contents */
    /* documents whose diagnostics are complete; and were said, from the first on */
    int closed, said;
    Bytes general;     /* diagnostics of no document */
    atomic_bool fault; /* any thread reads it */
} Batch;

/* -- batch_say.c */
/* Adds diagnostics to those of the document (NULL: of none), if there are any. */
void batch_say(Batch *batch, BatchDocument *document, const char *text);
/* Reports something about a material, from any thread: messages are sorted by material. */
void batch_say_of(Batch *batch, BatchDocument *document, int material, const char *text);
void batch_fault(Batch *batch);
/* Something against the document, which is a fault. */
void batch_complain(Batch *batch, BatchDocument *document, const char *what, const char *why);
/* Reports something about a file in that folder; the message names the place. */
void batch_complain_within(Batch *batch, BatchDocument *document, const char *folder,
                           const char *name, const char *why);
/* Something to know, of no document, which is no fault. */
void batch_warn(Batch *batch, const char *what, const char *why);
/* Says the diagnostics up to the first document that is not done. The mutex is held. */
void batch_say_complete(Batch *batch);
/* Puts what was said of its materials behind what was said of the document. No thread works on
 * it. */
void batch_join_said(BatchDocument *document);
/* Reports what was found after all documents were read. */
void batch_say_rest(Batch *batch);

/* -- batch_state.c */
Unit *batch_unit(const Batch *batch, int document, int material, int request);
/* Name of the files of a material's program, with the pass unless it is the only one. */
void batch_name(const Batch *batch, const Unit *unit, char name[LONGEST_NAME]);
/* A file of a program, or of the layout. */
void batch_put_file(Batch *batch, BatchDocument *document, BatchFile file, const char *bytes,
                    size_t size);
/* An output that every program has a file of. */
bool batch_is_of_program(int emit);
/* Every document is opened, its parts worked on and closed, by all threads. */
void batch_phase(Batch *batch, int (*open)(void *, int), void (*work)(void *, int, int),
                 void (*close)(void *, int));

/* -- batch_inputs.c */
/* The files that change the batch when they change: documents, what they are made from, lists and a
 * layout. */
void batch_inputs(const Batch *batch, StringSet *files);
/* Complains of each output that would replace an input. Once all outputs are in the staging. */
void batch_spare_inputs(Batch *batch);
/* The folder's file of that name is an input. After that. */
bool batch_reads(const Batch *batch, const char *name);

/* -- batch_layout.c */
void batch_make_layout(Batch *batch); /* with --layout=auto */
/* One file for all programs: the GLSL that unpacks, and the layout itself. */
void batch_write_layout(Batch *batch);
/* Cases of the layout that the materials write, 1 << number; 0: all are read back. */
unsigned batch_cases(const Batch *batch);

/* -- batch_document.c */
bool batch_open(Batch *batch, BatchDocument *document);
/* The open document, from any thread. */
const MatcDocument *batch_document_parsed(Batch *batch, BatchDocument *document);
/* Its materials and the files that it is made from, by parsing it. False: it has faults, which are
 * said. */
bool batch_document_list(Batch *batch, BatchDocument *document);
void batch_document_make_room(BatchDocument *document, int materials, int requests, int depends);
void batch_close(BatchDocument *document);
void batch_document_free(BatchDocument *document, int requests);

/* -- batch_compile.c: a material's requests; a program again */
void batch_compile_material(Batch *batch, int document, int material);
void batch_compile_again(Batch *batch, BatchDocument *document, BatchProgram *program);

/* -- batch_cache.c: what the cache knows of a document and of a program. Without a cache a key is
 * of the text alone. */
bool batch_stored_open(Batch *batch);
void batch_stored_key(const Batch *batch, BatchDocument *document);
bool batch_stored_document(Batch *batch, BatchDocument *document);
/* Writes its entry, unless it is there as it would be. No thread works on the document. */
void batch_store_document(Batch *batch, BatchDocument *document);
bool batch_stored_ranges(Batch *batch, BatchDocument *document);
void batch_store_ranges(Batch *batch, const BatchDocument *document);
/* Writes the program's files. */
bool batch_stored_program(Batch *batch, BatchDocument *document, const BatchEdition *edition);
void batch_store_program(Batch *batch, const BatchEdition *edition, MatcProgram *program);

/* Programs out of units: groups them by key or by shape, decides which numbers come from a buffer,
 * names them, and lists what must be written again. batch_group.c */
void batch_group(Batch *batch);
/* The manifest as JSON. manifest.c */
void manifest_put(const Batch *batch, Bytes *to);
/* Files that the old manifest names and this batch does not make are to go. */
void manifest_remove_stale(Batch *batch, const char *old);
#endif
