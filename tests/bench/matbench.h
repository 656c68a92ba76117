/* Functions that the benchmarks share: time, medians, tables. */
#ifndef MATBENCH_H
#define MATBENCH_H
#include "compiler/base/option.h"
#include "compiler/matc.h"
#include "runtime/gl/context.h"
#include <stdbool.h>
#include <stddef.h>

/* Seconds on the monotonic clock. */
double bench_now(void);
/* Sorts a list and returns its median. */
double bench_median(double *values, int count);
/* Peak resident memory of the process so far, in KiB. */
long bench_peak_memory(void);

/* Formats a number with `decimals` decimals, or "-" for NAN, an unmeasured value. --untimed
 * omits all times, so that the output does not depend on the machine: tests/docs/figures.sh
 * compares docs with it. */
enum { BENCH_NUMBER = 32 };
#define NUMBER(decimals, value) bench_number((char[BENCH_NUMBER]){0}, decimals, value)
const char *bench_number(char text[BENCH_NUMBER], int decimals, double value);
/* Options of all subcommands. Missing options are 0 or NULL, except `timed`, which is true. */
typedef struct {
    bool timed; /* false after --untimed */
    bool quick, speed, scene, cache, help;
    GlKind gl;
    const char *csv, *plot, *page, *mesh, *meshes, *lift, *map, *only, *matc;
    int count, triangles, maps, voxels, pixels, size[2];
    double seconds;
    SuggestName *table; /* names of the subcommand's tables; NULL: none */
    unsigned tables;    /* a bit for each selected table; 0: none */
    const char **words; /* arguments of a subcommand without tables */
    int word_count;
    char **arguments; /* all arguments from the subcommand on */
    int argument_count;
    Arena arena;
} BenchOptions;

/* Rows of a subcommand's options, which end with BENCH_HELP. */
#define BENCH_AT(member) offsetof(BenchOptions, member)
#define BENCH_TEXT(name_, member, label_, help_)                                                   \
    {                                                                                              \
        name_, OPTION_text, BENCH_AT(member), .label = label_, .help = help_                       \
    }
#define BENCH_FLAG(name_, member, help_)                                                           \
    {                                                                                              \
        name_, OPTION_flag, BENCH_AT(member), .help = help_                                        \
    }
#define BENCH_INT(name_, member, label_, min_, max_, wants_, help_)                                \
    {                                                                                              \
        name_, OPTION_int, BENCH_AT(member), .label = label_, .min = min_, .max = max_,            \
                                             .wants = name_ " wants " wants_, .help = help_        \
    }
#define BENCH_UNTIMED                                                                              \
    {                                                                                              \
        "--untimed", OPTION_clear, BENCH_AT(timed),                                                \
            .help = "print - for what depends on the machine"                                      \
    }
#define BENCH_GL                                                                                   \
    {                                                                                              \
        "--gl", OPTION_index, BENCH_AT(gl),                                                        \
            .words = {bench_gl_name, NULL, GL_KIND_count}, .label = "=KIND",                       \
            .help = "osmesa (default), egl: a GPU where there is one"                              \
    }
#define BENCH_HELP                                                                                 \
    {                                                                                              \
        "--help", OPTION_flag, BENCH_AT(help), .help = ""                                          \
    }
const char *bench_gl_name(const void *user, int i);

/* Shows the current measurement on a terminal; "" erases it before a line is printed. Does
 * nothing if standard error is no terminal. */
void bench_show(const char *what);

/* Minimum CPU seconds to compile a document's first material, over `runs` runs; NAN on an error. */
double bench_compile_least(const char *text, size_t size, const MatcOptions *options, int runs);
/* Instructions of its program for a layout, --aa=none, after spirv-opt -O. -1 on a compile error
 * or without spirv-opt. */
int bench_count(const char *path, const char *text, size_t size, const char *layout);

/* Run a subcommand and return the exit status. matbench.c has a row for each, with its options and
 * tables. */
int bench_batch(const BenchOptions *options);
int bench_cells(const BenchOptions *options);
int bench_compile(const BenchOptions *options);
int bench_displacement(const BenchOptions *options);
int bench_error(const BenchOptions *options);
int bench_functions(const BenchOptions *options); /* status 1: an error exceeds its stated bound */
int bench_glslang(const BenchOptions *options);
int bench_growth(const BenchOptions *options);
int bench_guards(const BenchOptions *options);
int bench_indirect(const BenchOptions *options);
int bench_instructions(const BenchOptions *options);
int bench_layout(const BenchOptions *options);
int bench_noise(const BenchOptions *options);
int bench_render(const BenchOptions *options); /* status 1: pictures that must be equal differ */
int bench_shadows(const BenchOptions *options);
int bench_stress(const BenchOptions *options);
/* status 1: the error of a slot exceeds its bound */
int bench_surfaces(const BenchOptions *options);
int bench_thesis(const BenchOptions *options);
extern const Option bench_batch_options[], bench_displacement_options[], bench_error_options[],
    bench_indirect_options[], bench_noise_options[], bench_render_options[],
    bench_shadows_options[], bench_thesis_options[];
SuggestName bench_displacement_table, bench_indirect_table_name, bench_render_table,
    bench_shadows_table, bench_thesis_table;

/* Measures nanoseconds per pixel of the pass that writes a layout of layout_table, and of one
 * that reads all of it. */
bool bench_layout_cost(GlContext *gl, int layout, double *write, double *read);
/* Prints the second table of bench_layout: whole passes. */
int bench_layout_frame(bool timed);
/* Prints the third table: light passes of sets of materials. */
int bench_layout_set(bool timed);
#endif
