/* Generates valid documents of random structure from the tables of grammar/: any kind, any
 * parameter, ordinary and hostile numbers. */
#ifndef MATC_STRESS_GENERATE_H
#define MATC_STRESS_GENERATE_H
#include "choices.h"
#include "compiler/base/text.h"

/* Bound of unbounded parameters, equal to that of coordinates. */
#define GENERATE_GREATEST 1e8

enum { LARGEST_TREE = 50 }; /* max maps of a document */

/* Writes a whole document of one material. */
void generate_document(Choices *c, Text *out);
/* Writes a document whose normal is a BumpMap over a tree of maps. */
void generate_relief(Choices *c, Text *out);
/* Writes one map of at most about `size` maps, without references to definitions. */
void generate_map(Choices *c, Text *out, int size);
/* Writes a formula of the inputs i0, i1, ..., `inputs` in number. generate_formula.c */
void generate_formula(Choices *c, Text *out, int inputs);
/* A parameter's number: if `hostile`, at a limit, zero, tiny or huge. */
double generate_number(Choices *c, double low, double high, bool hostile);
/* File reader for the compiler: the documents' picture is made in memory. */
char *generate_file(void *user, const char *path, size_t *size, const char **why);
#endif
