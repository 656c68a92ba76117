/* State that every stage shares: options, memory, sources, diagnostics, the files that were
 * read. The session is the first argument of every stage. It knows nothing about materials. */
#ifndef MATC_SESSION_H
#define MATC_SESSION_H
#include "compiler/base/arena.h"
#include "compiler/base/diag.h"
#include "compiler/matc.h"
#include "compiler/base/names.h"
#include "compiler/base/source.h"
#include "compiler/base/suggest.h"
#include <stdbool.h>

/* All limits of the compiler. */
enum {
    LIMIT_DOCUMENT_MIB = 64,  /* size of a source text */
    LIMIT_DEPTH = 256,        /* nesting depth of a document, and of waves */
    LIMIT_GRAPH_DEPTH = 2048, /* depth of nested maps, including references */
    /* Maps and references on one path while a document is resolved. */
    LIMIT_REFERENCES = 4096,
    /* Depth of maps or references up to which the caller's stack is used: stack.h. */
    LIMIT_SHALLOW = 64,
    /* KiB of stack per level of a deeper graph: eight times what the deepest chain needs. */
    LIMIT_LEVEL_KIB = 4,
    LIMIT_TREE_NODES = 4000000, /* values of a document */
    LIMIT_IR_NODES = 2000000,   /* nodes of a program */
    LIMIT_INCLUDE_DEPTH = 16,   /* nesting depth of includes */
    LIMIT_NAME = 64,            /* characters of a name */
    LIMIT_QUOTE = 256,          /* bytes of a quoted name or text in a message */
    LIMIT_IMAGE_SIDE = 16384,   /* pixels along an image's edge */
    LIMIT_PIXELS_MIB = 1024,    /* decoded images of a document */
    LIMIT_WAVES = 256,          /* waves of a chain, including nested chains */
    LIMIT_PARAMS = 4096,        /* uniforms of a document */
    /* mesh attributes of a document: the locations of 16 that are free */
    LIMIT_ATTRIBUTES = 5,
    LIMIT_DEFINITION_PARAMS = 64, /* parameters of a definition */
    /* Values that are copied when definitions are instantiated with arguments. */
    LIMIT_COPIES = 200000,
    LIMIT_FORMULA = 1 << 21, /* bytes of a formula */
    LIMIT_INCLUDES = 256,    /* files that a document includes, directly or indirectly */
    /* %TAG lines of a YAML document: libyaml compares each with all preceding ones. */
    LIMIT_TAGS = 64,
    LIMIT_WALK = 256, /* items of a Blend that are tested in sequence */
    /* Nesting depth of branches in a program; deeper values are computed without a branch. */
    LIMIT_BRANCHES = 128,
    /* Nodes that are reexamined for the arms of a select: range.c. */
    LIMIT_GUARD_STEPS = 512,
    /* nesting depth of reexamined nodes; each level takes 512 bytes of stack */
    LIMIT_GUARD_DEPTH = 64,
    LIMIT_LAYOUT_CASES = 32,  /* cases of a layout */
    LIMIT_LAYOUT_FIELDS = 64, /* fields of a case */
    /* Steps of the oracle for the values of one point: oracle_work.c. */
    LIMIT_WORK = 2000000000,
    /* the limit for all measured points of a material, as a multiple of LIMIT_WORK */
    LIMIT_WORK_POINTS = 4,
    LIMIT_FILTERS = 4, /* nested filters; each evaluates its input 27 times */
};

typedef struct {
    const char *name; /* stage: "read", "lower", an optimizer pass ... */
    double seconds;   /* elapsed wall-clock time */
    int nodes;        /* number of live IR nodes after the stage; 0 before IR exists */
    int cost;         /* cost of the live nodes in scalar operations */
} StageStats;

typedef struct Session {
    const MatcOptions *options;
    Arena *arena; /* arena that lives as long as the result */
    DiagList diags;
    Text message; /* message of the diagnostic that is being added */
    Source *sources;
    size_t source_count, source_capacity;
    Names depends; /* files read, the document first */
    StageStats *stats;
    size_t stat_count, stat_capacity;
    double stage_start;
    int optimize; /* level of -O */
    bool check;   /* runs ir_check after every pass */
    bool measure; /* collects statistics of every stage */
} Session;

/* Adds a diagnostic of a kind; the arguments of its format follow. Always returns NULL, so that
 * a reader can return the result. */
void *diag_add(Session *session, Span span, DiagKind kind, ...);
/* Returns true when MAX_DIAGS diagnostics are stored: later ones are dropped, and only errors are
 * counted. */
bool diag_full(const Session *session);
/* Returns "; did you mean 'x'?" as suggest() does, or "" if no more diagnostics are stored. */
const char *diag_suggest(const Session *session, const char *name, SuggestName *names,
                         const void *user, int count);
/* Proposes a similar name; without a similar name lists all names after the text `before`. A
 * NULL `before` omits the list (too long). */
const char *diag_suggest_or_list(const Session *session, const char *name, const NameChoice *names,
                                 const char *before);
/* Returns all diagnostics so far as text or as a JSON array, in the arena. */
const char *diag_all(Session *session, MatcForm form);
/* Returns the settings of -W; NULL if absent. */
const char *session_warnings(const Session *session);
/* Returns the seconds of a monotonic clock. */
double session_now(void);
/* Marks the end of a stage for --stats. */
void session_stage_done(Session *session, const char *name, int nodes, int cost);
/* Reads a file by the reader of the options. Returns a zero-terminated text, or NULL and *why. */
char *session_read_file(Session *session, const char *path, size_t *size, const char **why);
/* Adds a file to the dependencies of the result, once. */
void session_depend_on(Session *session, const char *path);
/* Resolves `path` relative to the folder of the file `from`. */
const char *session_path_beside(Session *session, const char *from, const char *path);

/* Opens a session. The options must outlive the session. */
Session session_open(const MatcOptions *options, Arena *arena);
#endif
