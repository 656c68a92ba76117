/* Spelling suggestions: "did you mean". */
#ifndef MATC_SUGGEST_H
#define MATC_SUGGEST_H
#include "compiler/base/arena.h"

/* Returns the i-th name; NULL: the name is not a candidate. */
typedef const char *SuggestName(const void *user, int i);
/* Returns "; did you mean 'x'?" for the nearest of `count` names, "" if none is similar. */
const char *suggest(Arena *arena, const char *name, SuggestName *names, const void *user,
                    int count);

/* A list of names to choose from. */
typedef struct {
    SuggestName *name;
    const void *user;
    int count;
} NameChoice;
/* Returns "a, b, c": the candidates among the names. */
const char *suggest_list(Arena *arena, const NameChoice *names);
#endif
