/* The command line of matc. */
#ifndef MATC_OPTIONS_H
#define MATC_OPTIONS_H
#include "compiler/base/arena.h"
#include "compiler/matc.h"
#include "runtime/gl/context.h"

enum { MAX_PASSES = 8 };
#define OPTIONS_SCHEMA    "document" /* default of --schema */
#define OPTIONS_CASES_ALL "all" /* --cases: the unpacking text reads every case of the layout */

/* Outputs of a run, in the order of --emit's names. */
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
    unsigned output;   /* MatcOutput; 0: the tree, which belongs to the document */
    const char *spirv; /* suffix of a stage's SPIR-V; NULL: no stage, or the fragment stage */
} EmitRow;
extern const EmitRow emit_table[EMIT_COUNT];

typedef struct {
    MatcOptions compile;
    Arena words;         /* arena of strings derived from arguments, and of messages about them */
    const char **inputs; /* paths of documents: arguments, and lines of list files */
    int input_count;
    const char **lists; /* files with lists of inputs, "@list.txt" */
    char **list_texts;  /* buffers of the inputs from lists */
    int list_count;
    const char *cache;              /* --cache, or MATC_CACHE */
    bool cache_named;               /* --cache is given */
    int cache_limit;                /* --cache-limit, in MiB; 0: the default */
    bool cache_stats;               /* --cache-stats */
    const char *passes[MAX_PASSES]; /* --pass, a list with -d */
    int pass_count;
    char *pass_list;         /* buffer of the passes */
    int threads;             /* -j; 0: the number of processors */
    const char *output;      /* -o: output file */
    const char *folder;      /* -d: output folder */
    const char *depfile;     /* -MF: path of the depfile */
    const char *target;      /* -MT: target in the depfile */
    bool depend;             /* -MD: write a depfile */
    bool emit[EMIT_COUNT];   /* --emit: requested outputs */
    bool emit_named;         /* --emit is given; otherwise `emit` has the default */
    const char *material;    /* --material: name of the material */
    const char *eval;        /* --eval: point to evaluate */
    const char *explain;     /* --explain: name to explain */
    const char *textures;    /* --textures: folder of generated textures */
    double max_error, range; /* --max-error, --range; 0: not given */
    GlKind gl;               /* --gl: the OpenGL context that measures */
    double layout_error;     /* --layout-error; 0: not given */
    const char *cases;       /* --cases: used or all; NULL: used */
    bool pareto, stats, watch, help, version;
    const char *list;          /* --list: the kind, "" for all; NULL: not given */
    const char *schema;        /* --schema: the file type; NULL: not given */
    struct WatchList *watched; /* set with --watch: files that a run read or looked for */
    MatcForm diagnostics;
} CommandLine;

/* Parses the arguments; allocates lists by malloc. Returns false and *fault on failure. */
bool options_read(CommandLine *line, int argc, char **argv, const char **fault);
void options_free(CommandLine *line);
/* Returns NULL, or a fault of options that cannot be combined. options_check.c */
const char *options_check(CommandLine *line);
/* Derives the output or the target from the suffix of -o unless an option selects it. Returns
 * NULL, or a fault if the suffix contradicts an option. options_suffix.c */
const char *options_suffix(CommandLine *line);
/* Return, for an --emit: the MatcOutputs (or-ed) that it needs of a program, the text that is
 * written, and its files' suffix. For the target spirv stages are SPIR-V instead of GLSL. */
unsigned options_emit_outputs(const MatcOptions *options, int emit);
const char *options_emit_text(const MatcOptions *options, int emit, const MatcProgram *program,
                              size_t *size);
const char *options_emit_suffix(const MatcOptions *options, int emit);
/* Returns the text of --help, in the arena. */
const char *options_help(Arena *arena);
#endif
