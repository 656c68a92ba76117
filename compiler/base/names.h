/* A list of names in the order in which they came, each once, that is searched by hashing. */
#ifndef MATC_NAMES_H
#define MATC_NAMES_H
#include "compiler/base/hash_index.h"

typedef struct {
    const char **at;
    size_t count, room;
    HashIndex index;
    uint64_t seed; /* of the hashes */
} Names;

/* The name's index, or -1. */
int names_find(const Names *names, const char *name);
/* Number of the name; an unknown one is appended. The text is not copied. */
int names_add(Arena *arena, Names *names, const char *name);

/* Names that are given out, each to one. */
typedef struct {
    Names given;
    int *last; /* by index: the number that was put behind the name last */
    size_t last_count, last_room;
} FreshNames;

/* The wanted name where nobody has it, else "clay2", "clay3"; behind a digit "layer1_2". */
const char *names_fresh(Arena *arena, FreshNames *fresh, const char *wanted);
#endif
