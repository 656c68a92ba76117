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

/* Storage of constants in a batch: in programs; in a uniform block, for all of the document; or
 * in a uniform block, for those in which materials of one shape differ. */
typedef enum { NUMBERS_baked, NUMBERS_uniform, NUMBERS_auto } Numbers;

typedef struct {
    char *name;
    const char *opacity; /* opacity class, as matc_opacity returns */
    Bytes reported;      /* diagnostics, printed after those of the document */
    Unit *units;         /* array of one unit per request */
} BatchMaterial;

typedef struct {
    const char *path;
    char *text; /* text of the document, kept while the document and its materials are compiled */
    size_t size;
    /* Hash of everything that determines the programs of the document's materials, except included
     * files. */
    Key key;
    MatcDocument *parsed; /* the parsed document; NULL while not needed */
    BatchMaterial *materials;
    Unit *units; /* units of all materials */
    int material_count;
    int offset;     /* index of the first material; --material selects one */
    char **depends; /* the document and its included files */
    int depend_count;
    MatcRanges *ranges; /* set with --layout=auto, while the document is open */
    bool stored;        /* the document was loaded from the cache */
    /* Diagnostics were printed, so the document is not cached: a cached run would print none. */
    bool spoke;
    bool unreadable; /* reading failed, which was reported */
    bool once;       /* the input is a pipe, which can be read only once: its text is kept */
    Bytes reported;  /* diagnostics of the document */
    bool closed;
    /* programs to be rewritten for the document's materials, once all are known */
    int *again, again_count;
    pthread_mutex_t mutex; /* guards `parsed` */
} BatchDocument;

typedef struct {
    /* linked list of the program's materials; the first one names the program */
    Unit *first, *last;
    int unit_count;
    /* per place: the member that replaces the number; NULL: all numbers are literals */
    int *members;
    char *name; /* name of the program's files without suffix */
} BatchProgram;

/* A program to be written: of a unit, with the numbers at `members` from a uniform block (NULL:
 * none), under the name `base`. */
typedef struct {
    Unit *unit;
    const int *members;
    const char *base;
} BatchEdition;

typedef struct {
    const char *base, *suffix; /* parts of the program's name */
} BatchFile;

typedef struct {
    const CommandLine *line;
    const BatchCalls *calls;
    const char *requests[MAX_PASSES]; /* names of the requested passes */
    int request_count;
    Numbers numbers;
    unsigned outputs; /* MatcOutput flags of a program */
    MatcOptions options;
    BatchDocument *documents;
    int document_count;
    BatchProgram *programs;
    int program_count;
    MatcRanges ranges;  /* joined ranges of all documents, with --layout=auto */
    MatcLayout *layout; /* automatic layout; NULL: none */
    Outputs folders;    /* all output folders of the run */
    /* Stagings of the folder and of --textures, possibly the same; NULL: not given. */
    Staging *staging, *textures;
    MatcLinked *linked;    /* cache of linked vertex programs, for all options */
    Cache *cache;          /* the cache; NULL: disabled */
    pthread_mutex_t mutex; /* guards the members below */
    /* Input files in the output folder, by their names there. */
    StringSet within;
    KeySet seen;     /* programs that some thread already writes */
    StringSet files; /* files on which documents depend */
    Key *file_keys;  /* content hashes of the files */
    /* Number of documents whose diagnostics are complete; and number of leading documents whose
     * diagnostics were printed. */
    int closed, reported;
    Bytes general;     /* diagnostics that concern no document */
    atomic_bool fault; /* a fault occurred; any thread reads the flag */
} Batch;

/* -- batch_report.c */
/* Appends diagnostics, if any, to the document's (NULL: to the general ones). */
void batch_report(Batch *batch, BatchDocument *document, const char *text);
/* Appends diagnostics about a material, from any thread: they are sorted by material. */
void batch_report_of(Batch *batch, BatchDocument *document, int material, const char *text);
void batch_fault(Batch *batch);
/* Reports a fault of the document. */
void batch_complain(Batch *batch, BatchDocument *document, const char *what, const char *why);
/* Reports a fault of a file in a folder; the message names its path. */
void batch_complain_within(Batch *batch, BatchDocument *document, const char *folder,
                           const char *name, const char *why);
/* Prints a warning that concerns no document. */
void batch_warn(Batch *batch, const char *what, const char *why);
/* Prints the diagnostics of completed documents up to the first incomplete one. The caller holds
 * the mutex. */
void batch_report_complete(Batch *batch);
/* Appends the diagnostics of a document's materials to the document's own. No thread may work on
 * the document. */
void batch_join_reports(BatchDocument *document);
/* Prints diagnostics found after all documents were read. */
void batch_report_rest(Batch *batch);

/* -- batch_state.c */
Unit *batch_unit(const Batch *batch, int document, int material, int request);
/* Returns the name of the files of a material's program; includes the pass if there are several. */
void batch_name(const Batch *batch, const Unit *unit, char name[LONGEST_NAME]);
/* Stages a file of a program, or of the layout. */
void batch_put_file(Batch *batch, BatchDocument *document, BatchFile file, const char *bytes,
                    size_t size);
/* Returns true for outputs that are written for every program. */
bool batch_is_of_program(int emit);
/* Opens every document, processes its parts and closes it, on all threads. */
void batch_phase(Batch *batch, int (*open)(void *, int), void (*work)(void *, int, int),
                 void (*close)(void *, int));

/* -- batch_inputs.c */
/* Lists the files whose changes affect the batch: documents, included files, lists and a layout. */
void batch_inputs(const Batch *batch, StringSet *files);
/* Reports each output that would replace an input. Call it when all outputs are staged. */
void batch_spare_inputs(Batch *batch);
/* Returns true if the folder's file of that name is an input. Call it after
 * batch_spare_inputs(). */
bool batch_reads(const Batch *batch, const char *name);

/* -- batch_layout.c */
void batch_make_layout(Batch *batch); /* Makes the layout for --layout=auto. */
/* Writes the files that all programs share: the unpacking GLSL, and the layout itself. */
void batch_write_layout(Batch *batch);
/* Returns the layout cases that the materials write, 1 << case; 0: all are read back. */
unsigned batch_cases(const Batch *batch);

/* -- batch_document.c */
bool batch_open(Batch *batch, BatchDocument *document);
/* Returns the parsed document; on any thread. */
const MatcDocument *batch_document_parsed(Batch *batch, BatchDocument *document);
/* Lists its materials and included files by parsing the document. Returns false after reporting
 * faults. */
bool batch_document_list(Batch *batch, BatchDocument *document);
void batch_document_make_capacity(BatchDocument *document, int materials, int requests,
                                  int depends);
void batch_close(BatchDocument *document);
void batch_document_free(BatchDocument *document, int requests);

/* -- batch_compile.c: compiles a material's requests; rewrites a program */
void batch_compile_material(Batch *batch, int document, int material);
void batch_compile_again(Batch *batch, BatchDocument *document, BatchProgram *program);

/* -- batch_cache.c: cache entries of documents and programs. Without a cache a document's key is
 * the hash of its text alone. */
bool batch_stored_open(Batch *batch);
void batch_stored_key(const Batch *batch, BatchDocument *document);
bool batch_stored_document(Batch *batch, BatchDocument *document);
/* Stores the document's entry unless it is up to date. No thread may work on the document. */
void batch_store_document(Batch *batch, BatchDocument *document);
bool batch_stored_ranges(Batch *batch, BatchDocument *document);
void batch_store_ranges(Batch *batch, const BatchDocument *document);
/* Writes the program's files from the cache; batch_store_program() adds them. */
bool batch_stored_program(Batch *batch, BatchDocument *document, const BatchEdition *edition);
void batch_store_program(Batch *batch, const BatchEdition *edition, MatcProgram *program);

/* Groups units into programs by key or by shape, selects the numbers that come from a uniform
 * block, names the programs, and lists those to be rewritten. batch_group.c */
void batch_group(Batch *batch);
/* Writes the manifest as JSON. manifest.c */
void manifest_put(const Batch *batch, Bytes *to);
/* Marks files for removal that the old manifest lists and this batch does not write. */
void manifest_remove_stale(Batch *batch, const char *old);
#endif
