/* The rows of keys.def. */
#ifndef MATC_KEY_TABLE_H
#define MATC_KEY_TABLE_H

typedef enum {
#define KEY(name, where, doc, example) DOCUMENT_KEY_##name,
#include "keys.def"
    DOCUMENT_KEY_COUNT
} DocumentKey;
typedef struct {
    const char *name, *where, *doc, *example;
} KeyRow;
extern const KeyRow key_table[DOCUMENT_KEY_COUNT];
#endif
