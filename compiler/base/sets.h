/* Sets of strings and of keys, numbered in order of insertion. Memory is from malloc. */
#ifndef MATC_SETS_H
#define MATC_SETS_H
#include "compiler/base/hash.h"
#include "compiler/base/hash_index.h"

typedef struct {
    char **at;
    int count, capacity;
    HashIndex index;
} StringSet;

/* Adds a copy of the string and returns its number. *added reports whether the string is new;
 * NULL: not needed. */
int string_set_add(StringSet *set, const char *string, bool *added);
/* Returns the string's number; -1: none. */
int string_set_find(const StringSet *set, const char *string);
void string_set_free(StringSet *set);

typedef struct {
    Key *at;
    int count, capacity;
    HashIndex index;
} KeySet;

int key_set_add(KeySet *set, Key key, bool *added);
int key_set_find(const KeySet *set, Key key);
void key_set_free(KeySet *set);

/* realloc and strdup that end the process when memory is exhausted. */
void *sets_resize(void *memory, size_t size);
char *sets_copy(const char *text);
#endif
