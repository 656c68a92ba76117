/* What the benchmarks share: time, medians, tables. */
#ifndef MATBENCH_H
#define MATBENCH_H
#include "compiler/matc.h"
#include <stdbool.h>
#include <stddef.h>

/* Seconds on the monotonic clock. */
double bench_now(void);
/* Median of a list, which it sorts. */
double bench_median(double *values, int count);
/* Greatest resident memory of the process so far, in KiB. */
long bench_peak_memory(void);

/* A number of so many decimals, or "-" for NAN: what was not measured. --untimed leaves all times out, so that what is left does not
 * depend on the machine: tests/docs/figures.sh holds docs/ against it. */
enum { BENCH_NUMBER = 32 };
#define NUMBER(decimals, value) bench_number((char[BENCH_NUMBER]){0}, decimals, value)
const char *bench_number(char text[BENCH_NUMBER], int decimals, double value);
/* It is the subcommand's first option. */
bool bench_untimed(int argc, char **argv);

/* Says on a terminal what is measured now; "" takes it away, before a line is printed. Nothing where standard error is none. */
void bench_show(const char *what);

/* Seconds of the processor that a compilation of a document's first material takes, the least of so many runs; NAN for none. */
double bench_compile_least(const char *text, size_t size, const MatcOptions *options, int runs);
/* Instructions of its program for a layout, --aa=none, behind spirv-opt -O. -1: it does not compile, or spirv-opt is not there. */
int bench_count(const char *path, const char *text, size_t size, const char *layout);

/* One subcommand each; the exit status. */
/* --untimed, the program matc. */
int bench_compile(int argc, char **argv);
/* glslang VERTEX FRAGMENT: only validates; what bench_compile compares a process of matc with. */
int bench_glslang(int argc, char **argv);
int bench_instructions(int argc, char **argv);
/* --untimed. */
int bench_layout(int argc, char **argv);
/* Nanoseconds a pixel that the pass takes which writes a layout of layout_table, and one that reads all of it. */
typedef struct GlContext GlContext;
bool bench_layout_cost(GlContext *gl, int layout, double *write, double *read);
/* Its second table: whole passes. */
int bench_layout_frame(bool timed);
/* Its third: light passes of sets of materials. */
int bench_layout_set(bool timed);
/* Run time against error: --quick --gl=KIND --csv FILE --plot BASENAME --page FILE. */
int bench_error(int argc, char **argv);
/* Many materials in one process: --untimed --count N --matc PROGRAM --speed --scene. */
int bench_batch(int argc, char **argv);
/* --untimed: what is stated alone, since drivers differ. 1: one errs by more than is stated. */
int bench_functions(int argc, char **argv);
/* Noise beside that of others: --untimed --gl=KIND. */
int bench_noise(int argc, char **argv);
/* What a frame takes: --untimed --gl=KIND --size=WIDTHxHEIGHT --csv FILE, names of tables. 1: pictures differ that must not. */
int bench_render(int argc, char **argv);
/* Tables of Hartmann 2010, with its numbers beside ours: --untimed --quick --gl=KIND, names of tables. */
int bench_thesis(int argc, char **argv);
/* Shadows by every method: errors of their ends, times: --untimed --gl=KIND --triangles=N --mesh=FILE --maps=TEXELS, names of tables. */
int bench_shadows(int argc, char **argv);
/* The rows of grammar/cells.def, measured. */
int bench_cells(int argc, char **argv);
/* Voxels and rays through them, and the thesis' tables: --untimed --gl=KIND --mesh=FILE --lift=HEIGHT --voxels=N --meshes=FOLDER --size=PIXELS, names of tables. */
int bench_indirect(int argc, char **argv);
/* Displaced triangles: --untimed --gl=KIND --map=FILE --triangles=N, names of tables. */
int bench_displacement(int argc, char **argv);
/* Principled materials in 16 bytes a pixel: --untimed. 1: a slot is off by more than is promised. */
int bench_surfaces(int argc, char **argv);
int bench_stress(int argc, char **argv);
/* How the time to compile grows with the document: names of rows of tests/growth/growth.def, or none for all. */
int bench_guards(int argc, char **argv);
int bench_growth(int argc, char **argv);
#endif
