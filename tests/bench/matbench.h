/* What the benchmarks share: time, medians, tables. */
#ifndef MATBENCH_H
#define MATBENCH_H
#include <stdbool.h>
#include <stddef.h>

/* Seconds on the monotonic clock. */
double bench_now(void);
/* Median of a list, which it sorts. */
double bench_median(double *values, int count);
/* Greatest resident memory of the process so far, in KiB. */
long bench_peak_memory(void);

/* One subcommand each; the exit status. */
int bench_compile(int argc, char **argv);
/* glslang VERTEX FRAGMENT: only validates; what bench_compile compares a process of matc with. */
int bench_glslang(int argc, char **argv);
int bench_instructions(int argc, char **argv);
int bench_layout(int argc, char **argv);
/* Nanoseconds a pixel that the pass takes which writes a layout of layout_table, and one that reads all of it. */
typedef struct GlContext GlContext;
bool bench_layout_cost(GlContext *gl, int layout, double *write, double *read);
/* Its second table: whole passes. */
int bench_layout_frame(void);
/* Run time against error: --quick --gl=KIND --csv FILE --plot BASENAME --page FILE. */
int bench_error(int argc, char **argv);
/* Many materials in one process: --count N --matc PROGRAM --speed --scene. */
int bench_batch(int argc, char **argv);
int bench_stress(int argc, char **argv);
/* How the time to compile grows with the document: names of rows of tests/growth/growth.def, or none for all. */
int bench_growth(int argc, char **argv);
#endif
