/* The command line of matc. */
#ifndef MATC_OPTIONS_H
#define MATC_OPTIONS_H
#include "matc.h"

/* Outputs that a run may write, in the order of --emit's names. */
typedef enum {
    EMIT_glsl,
    EMIT_vertex,
    EMIT_unpack,
    EMIT_reflect,
    EMIT_spirv,
    EMIT_ir,
    EMIT_dot,
    EMIT_tree,
    EMIT_COUNT
} Emit;
typedef struct {
    const char *name, *suffix;
    unsigned output; /* MatcOutput; 0: the tree, which is the document's */
} EmitRow;
extern const EmitRow emit_table[EMIT_COUNT];

/* Names under which materials were written to the folder of -d in this run. */
typedef struct {
    char **at;
    int count;
} Names;

typedef struct {
    MatcOptions compile;
    Names *taken;
    const char **inputs;
    int input_count;
    const char *output;    /* -o */
    const char *folder;    /* -d */
    const char *depfile;   /* -MF */
    const char *target;    /* -MT */
    bool depend;           /* -MD */
    bool emit[EMIT_COUNT]; /* --emit */
    const char *material;  /* --material */
    const char *eval;      /* --eval */
    const char *explain;   /* --explain */
    const char *textures;  /* --textures */
    const char *max_error; /* --max-error */
    const char *range;     /* --range */
    const char *gl;        /* --gl */
    bool pareto, list, schema, stats, help, version;
    MatcForm diagnostics;
} CommandLine;

/* Reads the arguments; the lists it makes are from malloc. False: *fault says what is wrong. */
bool options_read(CommandLine *line, int argc, char **argv, const char **fault);
extern const char *const options_help;
#endif
