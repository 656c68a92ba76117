/* The command line of matc. */
#ifndef MATC_OPTIONS_H
#define MATC_OPTIONS_H
#include "compiler/base/arena.h"
#include "compiler/matc.h"
#include "runtime/gl/context.h"

enum { MOST_PASSES = 8 };
#define OPTIONS_SCHEMA    "document" /* what --schema asks for by itself */
#define OPTIONS_CASES_ALL "all" /* --cases: the unpacking text reads every case of the layout */

/* Outputs that a run may write, in the order of --emit's names. */
typedef enum {
    EMIT_glsl,
    EMIT_vertex,
    EMIT_unpack,
    EMIT_reflect,
    EMIT_spirv,
    EMIT_ir,
    EMIT_dot,
    EMIT_layout,
    EMIT_tessvertex,
    EMIT_tesscontrol,
    EMIT_tesseval,
    EMIT_geometryvertex,
    EMIT_geometry,
    EMIT_displace,
    EMIT_compute,
    EMIT_tree,
    EMIT_COUNT
} Emit;
typedef struct {
    const char *name, *suffix;
    unsigned output;   /* MatcOutput; 0: the tree, which is the document's */
    const char *spirv; /* suffix of a stage's SPIR-V; NULL: it is none, or is the fragment's */
} EmitRow;
extern const EmitRow emit_table[EMIT_COUNT];

typedef struct {
    MatcOptions compile;
    Arena words;         /* texts that were made of arguments, and what is said of them */
    const char **inputs; /* of the arguments, and of the lists among them */
    int input_count;
    const char **lists; /* files of inputs, "@list.txt" */
    char **list_texts;  /* what the inputs out of lists lie in */
    int list_count;
    const char *cache;               /* --cache, or MATC_CACHE */
    bool cache_named;                /* by --cache */
    int cache_limit;                 /* --cache-limit, in MiB; 0: the default */
    bool cache_stats;                /* --cache-stats */
    const char *passes[MOST_PASSES]; /* --pass, which is a list with -d */
    int pass_count;
    char *pass_list;         /* what they lie in */
    int threads;             /* -j; 0: as many as there are processors */
    const char *output;      /* -o */
    const char *folder;      /* -d */
    const char *depfile;     /* -MF */
    const char *target;      /* -MT */
    bool depend;             /* -MD */
    bool emit[EMIT_COUNT];   /* --emit */
    bool emit_named;         /* by --emit; else it is the default */
    const char *material;    /* --material */
    const char *eval;        /* --eval */
    const char *explain;     /* --explain */
    const char *textures;    /* --textures */
    double max_error, range; /* --max-error, --range; 0: not given */
    GlKind gl;               /* --gl */
    double layout_error;     /* --layout-error; 0: not given */
    const char *cases;       /* --cases: used or all; NULL: used */
    bool pareto, stats, watch, help, version;
    const char *list;          /* --list: of which kind, "" for all; NULL */
    const char *schema;        /* --schema: of which file; NULL */
    struct WatchList *watched; /* with --watch: files that a run read or wanted */
    MatcForm diagnostics;
} CommandLine;

/* Reads the arguments; the lists it makes are from malloc. False: *fault says what is wrong. */
bool options_read(CommandLine *line, int argc, char **argv, const char **fault);
void options_free(CommandLine *line);
/* NULL, or what does not go together. options_check.c */
const char *options_check(CommandLine *line);
/* Follows the suffix of -o where no option selects the output or the target; NULL, or how it
 * contradicts one. options_suffix.c */
const char *options_suffix(CommandLine *line);
/* Outputs that an --emit needs of a program (MatcOutput, or-ed), the text that is written, and the
 * suffix of its files: for a target of SPIR-V, stages as SPIR-V instead of GLSL. */
unsigned options_emit_outputs(const MatcOptions *options, int emit);
const char *options_emit_text(const MatcOptions *options, int emit, const MatcProgram *program,
                              size_t *size);
const char *options_emit_suffix(const MatcOptions *options, int emit);
/* The text of --help, in the arena. */
const char *options_help(Arena *arena);
#endif
