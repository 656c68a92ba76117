/* Generates valid documents of random structure from the tables of grammar/: any kind, any
 * parameter, ordinary and hostile numbers. */
#ifndef MATC_STRESS_GENERATE_H
#define MATC_STRESS_GENERATE_H
#include "choices.h"
#include "compiler/base/text.h"

/* Bound of parameters that may be any number, as for coordinates. */
#define GENERATE_GREATEST 1e8

enum { LARGEST_TREE = 50 }; /* maps of a document */

/* A whole document as text, of one material. */
void generate_document(Choices *c, Text *out);
/* A document whose normal is a BumpMap's, over a tree of maps. */
void generate_relief(Choices *c, Text *out);
/* One map as text, of about `size` maps at most, which refers to no definition. */
void generate_map(Choices *c, Text *out, int size);
/* A formula of inputs i0, i1, ..., so many. generate_formula.c */
void generate_formula(Choices *c, Text *out, int inputs);
/* A number that a document may have for a parameter: `hostile` are those at limits, zeros, tiny and
 * huge ones. */
double generate_number(Choices *c, double low, double high, bool hostile);
/* Answers the compiler's requests for files: the picture of documents is made in memory. */
char *generate_file(void *user, const char *path, size_t *size, const char **why);
#endif
