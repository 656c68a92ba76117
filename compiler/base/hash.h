/* 128-bit content hash. Equal keys are taken to mean equal contents. */
#ifndef MATC_HASH_H
#define MATC_HASH_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    uint64_t low, high;
} Key;

static inline bool key_equal(Key a, Key b) { return a.low == b.low && a.high == b.high; }
Key key_of_bytes(const void *bytes, size_t size);
/* Formats a key as 32 hexadecimal digits with a terminating zero; key_read() parses them. */
enum { KEY_TEXT = 33 };
void key_text(Key key, char text[KEY_TEXT]);
Key key_read(const char *digits);
#endif
