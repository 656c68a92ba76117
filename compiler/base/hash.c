/* 128-bit content hashes (XXH3). */
#include "compiler/base/hash.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

Key key_of_bytes(const void *bytes, size_t size)
{
    XXH128_hash_t hash = XXH3_128bits(bytes, size);
    return (Key){hash.low64, hash.high64};
}

void key_text(Key key, char text[KEY_TEXT])
{
    snprintf(text, KEY_TEXT, "%016llx%016llx", (unsigned long long)key.high,
             (unsigned long long)key.low);
}

Key key_read(const char *digits)
{
    char half[17] = {0};
    Key key;
    memcpy(half, digits, 16);
    key.high = strtoull(half, NULL, 16);
    key.low = strtoull(digits + 16, NULL, 16);
    return key;
}
