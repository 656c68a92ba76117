/* A growing byte buffer, and a bounds-checked reader: the serialization of cache entries. */
#ifndef MATC_BYTES_H
#define MATC_BYTES_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    char *at; /* memory allocated by malloc */
    size_t size, capacity;
} Bytes;

void bytes_add(Bytes *bytes, const void *from, size_t size);
void bytes_number(Bytes *bytes, uint32_t number);
/* Appends the size, the bytes and a zero byte. */
void bytes_block(Bytes *bytes, const void *from, size_t size);
void bytes_text(Bytes *bytes, const char *text);
void bytes_free(Bytes *bytes);

typedef struct {
    const char *at, *end;
    bool broken; /* a read went past the end */
} BytesReader;

/* Each function returns NULL or 0 once the reader is broken, except bytes_take_text(). */
const void *bytes_take(BytesReader *reader, size_t size);
uint32_t bytes_take_number(BytesReader *reader);
const char *bytes_take_block(BytesReader *reader, size_t *size);
const char *bytes_take_text(BytesReader *reader); /* returns "" when broken */
#endif
