/* Growing byte buffers. */
#include "compiler/base/bytes.h"
#include "compiler/base/memory.h"
#include <stdlib.h>
#include <string.h>

void bytes_add(Bytes *bytes, const void *from, size_t size)
{
    if (bytes->size + size > bytes->capacity) {
        bytes->capacity = 2 * bytes->capacity + size + 64;
        bytes->at = realloc(bytes->at, bytes->capacity);
        if (!bytes->at)
            memory_exhausted();
    }
    if (size)
        memcpy(bytes->at + bytes->size, from, size);
    bytes->size += size;
}

void bytes_number(Bytes *bytes, uint32_t number) { bytes_add(bytes, &number, sizeof number); }

void bytes_block(Bytes *bytes, const void *from, size_t size)
{
    bytes_number(bytes, (uint32_t)size);
    bytes_add(bytes, from, size);
    bytes_add(bytes, "", 1);
}

void bytes_text(Bytes *bytes, const char *text) { bytes_block(bytes, text, strlen(text)); }

void bytes_free(Bytes *bytes)
{
    free(bytes->at);
    *bytes = (Bytes){0};
}

const void *bytes_take(BytesReader *r, size_t size)
{
    const char *taken = r->at;
    r->broken |= size > (size_t)(r->end - r->at);
    if (r->broken)
        return NULL;
    r->at += size;
    return taken;
}

uint32_t bytes_take_number(BytesReader *r)
{
    uint32_t number = 0;
    const void *taken = bytes_take(r, sizeof number);
    if (taken)
        memcpy(&number, taken, sizeof number);
    return number;
}

const char *bytes_take_block(BytesReader *r, size_t *size)
{
    *size = bytes_take_number(r);
    const char *taken = bytes_take(r, *size + 1);
    if (taken && taken[*size]) {
        r->broken = true;
        return NULL;
    }
    return taken;
}

const char *bytes_take_text(BytesReader *r)
{
    size_t size;
    const char *text = bytes_take_block(r, &size);
    return text ? text : "";
}
