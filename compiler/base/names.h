/* An ordered set of names: each name once, in order of insertion, found by hashing. */
#ifndef MATC_NAMES_H
#define MATC_NAMES_H
#include "compiler/base/hash_index.h"

typedef struct {
    const char **at;
    size_t count, capacity;
    HashIndex index;
    uint64_t seed; /* seed of the hashes */
} Names;

/* Returns the index of the name; -1: none. */
int names_find(const Names *names, const char *name);
/* Returns the index of the name and appends a new one. The text is not copied. */
int names_add(Arena *arena, Names *names, const char *name);

/* Generator of unique names. */
typedef struct {
    Names given;
    int *last; /* per name: the last number that was appended to the name */
    size_t last_count, last_capacity;
} FreshNames;

/* Returns `wanted` if it is still free, otherwise "clay2", "clay3", ...; after a digit
 * "layer1_2". */
const char *names_fresh(Arena *arena, FreshNames *fresh, const char *wanted);
#endif
