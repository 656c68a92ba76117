/* State that every stage shares: options, memory, sources, diagnostics, the files that were read.
 * It is the first argument of every stage. A session knows no material. */
#ifndef MATC_SESSION_H
#define MATC_SESSION_H
#include "compiler/base/arena.h"
#include "compiler/base/diag.h"
#include "compiler/matc.h"
#include "compiler/base/names.h"
#include "compiler/base/source.h"
#include "compiler/base/suggest.h"
#include <stdbool.h>

/* Every limit of the compiler. */
enum {
    LIMIT_DOCUMENT_MIB = 64,  /* a source text */
    LIMIT_DEPTH = 256,        /* nesting of a document, and of waves */
    LIMIT_GRAPH_DEPTH = 2048, /* maps below one another, through references too */
    /* maps and references that are met on the way down while a document is resolved */
    LIMIT_REFERENCES = 4096,
    /* of either: those for which the caller's stack is taken; stack.h */
    LIMIT_SHALLOW = 64,
    /* of stack for each of the others, eight times what the deepest chain takes */
    LIMIT_LEVEL_KIB = 4,
    LIMIT_TREE_NODES = 4000000,   /* values in a document */
    LIMIT_IR_NODES = 2000000,     /* nodes of a program */
    LIMIT_INCLUDE_DEPTH = 16,     /* files that include files */
    LIMIT_NAME = 64,              /* letters of a name */
    LIMIT_QUOTE = 256,            /* bytes of a name or text in a message */
    LIMIT_IMAGE_SIDE = 16384,     /* pixels of a picture's edge */
    LIMIT_PIXELS_MIB = 1024,      /* the pictures of a document, where they are decoded */
    LIMIT_WAVES = 256,            /* waves of a chain, chains in it counted out */
    LIMIT_PARAMS = 4096,          /* uniforms of a document */
    LIMIT_ATTRIBUTES = 5,         /* of the mesh, of a document: so many locations of 16 are free */
    LIMIT_DEFINITION_PARAMS = 64, /* parameters of a definition */
    /* values that uses of definitions copy, with arguments in their places */
    LIMIT_COPIES = 200000,
    LIMIT_FORMULA = 1 << 21, /* bytes of a formula */
    LIMIT_INCLUDES = 256,    /* files that a document includes, or would */
    /* %TAG lines of a YAML document: libyaml compares each with all before it */
    LIMIT_TAGS = 64,
    LIMIT_WALK = 256, /* items of a Blend that are tried one after the other */
    /* branches within branches of a program; what lies deeper is computed without */
    LIMIT_BRANCHES = 128,
    /* nodes that are looked at again for the arms of a select: range.c */
    LIMIT_GUARD_STEPS = 512,
    LIMIT_GUARD_DEPTH = 64,   /* of them over one another: each takes half a KiB of stack */
    LIMIT_LAYOUT_CASES = 32,  /* cases of a layout */
    LIMIT_LAYOUT_FIELDS = 64, /* fields of a case */
    /* steps that the oracle takes for a point's values: oracle_work.c */
    LIMIT_WORK = 2000000000,
    LIMIT_WORK_POINTS = 4, /* times that for all points that a material is measured at */
    LIMIT_FILTERS = 4,     /* filters within filters: each makes 27 evaluations of one */
};

typedef struct {
    const char *name; /* "read", "lower", an optimiser pass ... */
    double seconds;   /* wall time */
    int nodes;        /* IR nodes that are alive after it; 0 before there is IR */
    int cost;         /* their cost in scalar operations */
} StageStats;

typedef struct Session {
    const MatcOptions *options;
    Arena *arena; /* lives as long as the result */
    DiagList diags;
    Text message; /* of the diagnostic that is being added */
    Source *sources;
    size_t source_count, source_room;
    Names depends; /* files read, the document first */
    StageStats *stats;
    size_t stat_count, stat_room;
    double stage_start;
    int optimize; /* level of -O */
    bool check;   /* ir_check after every pass */
    bool measure; /* keep statistics of every stage */
} Session;

/* Adds a diagnostic of that kind; its format's arguments follow. Always returns NULL,
 * so that a reader can return it. */
void *diag_add(Session *session, Span span, DiagKind kind, ...);
/* Further ones are only counted. */
bool diag_full(const Session *session);
/* "; did you mean 'x'?" as suggest() has it, "" where no further diagnostic is said. */
const char *diag_suggest(const Session *session, const char *name, SuggestName *names,
                         const void *user, int count);
/* Proposes a near name; if none is near, lists all names behind `before`. NULL: the list would be
 * too long. */
const char *diag_suggest_or_list(const Session *session, const char *name, const NameChoice *names,
                                 const char *before);
/* All diagnostics so far, as text or as a JSON array; in the arena. */
const char *diag_all(Session *session, MatcForm form);
/* The settings of warnings, as -W has them; NULL: none. */
const char *session_warnings(const Session *session);
/* Seconds of a clock that never goes back. */
double session_now(void);
/* Marks the end of a stage for --stats. */
void session_stage_done(Session *session, const char *name, int nodes, int cost);
/* Reads a file through the options' reader; NULL and a message when it cannot. The text is
 * zero-terminated. */
char *session_read_file(Session *session, const char *path, size_t *size, const char **why);
/* Adds a file to the list of what the result depends on, once. */
void session_depend_on(Session *session, const char *path);
/* `path` as seen from the file `from`: relative paths are relative to its folder. */
const char *session_path_beside(Session *session, const char *from, const char *path);

/* A session by these options, which outlive it. */
Session session_open(const MatcOptions *options, Arena *arena);
#endif
