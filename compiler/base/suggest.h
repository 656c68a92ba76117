/* "Did you mean". */
#ifndef MATC_SUGGEST_H
#define MATC_SUGGEST_H
#include "compiler/base/arena.h"

/* The i-th of some names; NULL: it does not count. */
typedef const char *SuggestName(const void *user, int i);
/* "; did you mean 'x'?" for the nearest of `count` names, "" when none is near. */
const char *suggest(Arena *arena, const char *name, SuggestName *names, const void *user,
                    int count);

/* Names to choose from. */
typedef struct {
    SuggestName *name;
    const void *user;
    int count;
} NameChoice;
/* "a, b, c" of those that count. */
const char *suggest_list(Arena *arena, const NameChoice *names);
#endif
