/* The rows of keys.def as a const array. */
#include "key_table.h"

const KeyRow key_table[DOCUMENT_KEY_COUNT] = {
#define KEY(name, where, doc, example) {#name, where, doc, example},
#include "keys.def"
};
