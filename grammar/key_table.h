/* The rows of keys.def. */
#ifndef MATC_KEY_TABLE_H
#define MATC_KEY_TABLE_H

typedef enum {
#define KEY(name, where, doc, example) KEY_##name,
#include "keys.def"
    KEY_COUNT
} Key;
typedef struct {
    const char *name, *where, *doc, *example;
} KeyRow;
extern const KeyRow key_table[KEY_COUNT];
#endif
