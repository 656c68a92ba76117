/* A growing row of bytes, and a reader that never runs past its end: what the cache keeps. */
#ifndef MATC_BYTES_H
#define MATC_BYTES_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    char *at; /* from malloc */
    size_t size, room;
} Bytes;

void bytes_add(Bytes *bytes, const void *from, size_t size);
void bytes_number(Bytes *bytes, uint32_t number);
/* Its size, then itself and a zero byte. */
void bytes_block(Bytes *bytes, const void *from, size_t size);
void bytes_text(Bytes *bytes, const char *text);
void bytes_free(Bytes *bytes);

typedef struct {
    const char *at, *end;
    bool broken; /* it ended too early */
} BytesReader;

/* NULL, or 0, when broken. */
const void *bytes_take(BytesReader *reader, size_t size);
uint32_t bytes_take_number(BytesReader *reader);
const char *bytes_take_block(BytesReader *reader, size_t *size);
const char *bytes_take_text(BytesReader *reader); /* "" when broken */
#endif
