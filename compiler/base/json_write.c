/* Escapes strings for JSON. */
#include "compiler/base/json_write.h"
#include <string.h>

enum { REPLACEMENT = 0xFFFD };

/* Appends one character of `size` bytes, escaped if needed: `"` as \", ESC as \u001b, U+009B
 * (two bytes, which terminals read as ESC [) as \u009b. */
static void put_character(Text *out, const char *at, int size)
{
    const unsigned char first = (unsigned char)at[0];
    if (first == '"' || first == '\\')
        text_char(out, '\\');
    if (text_is_control(at, size))
        text_format(out, "\\u%04x", size == 1 ? first : (unsigned char)at[1]);
    else
        text_add(out, at, (size_t)size);
}

/* Returns the length of the prefix that needs no escapes: printing ASCII except `"` and `\`.
 * Nearly every text consists of it entirely. */
static size_t plain_length(const char *at, const char *end)
{
    const char *start = at;
    while (at < end && *at >= ' ' && *at < 0x7F && *at != '"' && *at != '\\')
        at++;
    return (size_t)(at - start);
}

void json_bytes(Text *out, const char *bytes, size_t size)
{
    const char *end = bytes + size;
    text_char(out, '"');
    for (int length; bytes < end; bytes += length ? length : 1) {
        size_t plain = plain_length(bytes, end);
        text_add(out, bytes, plain);
        bytes += plain;
        if (bytes == end)
            break;
        length = text_utf8_length((const unsigned char *)bytes, (const unsigned char *)end);
        if (length)
            put_character(out, bytes, length);
        else
            text_format(out, "\\u%04x", REPLACEMENT);
    }
    text_char(out, '"');
}

void json_string(Text *out, const char *string) { json_bytes(out, string, strlen(string)); }

void json_key(Text *out, const char *key)
{
    json_string(out, key);
    text_put(out, ": ");
}

void json_member(Text *out, const char *key, const char *value)
{
    json_key(out, key);
    json_string(out, value);
}

void json_next(Text *out, const char *key, const char *value)
{
    text_put(out, ", ");
    json_member(out, key, value);
}
