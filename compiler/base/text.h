/* A growing text, and numbers as text in the shortest form that reads back exactly. Results are
 * the same in every locale. No other file of the library depends on the locale:
 * tests/sources/locale.sh forbids printf of fractions, strtod, ctype.h and strerror. */
#ifndef MATC_TEXT_H
#define MATC_TEXT_H
#include "compiler/base/arena.h"
#include <stdarg.h>
#include <stdbool.h>
#include <string.h>

typedef struct {
    Arena *arena;
    char *at; /* characters, zero-terminated after the first addition */
    size_t size, capacity;
} Text;

Text text_new(Arena *arena);
/* Reserves capacity for `more` bytes and a terminating zero. */
void text_reserve(Text *text, size_t more);
static inline void text_add(Text *text, const char *bytes, size_t size)
{
    if (text->size + size >= text->capacity)
        text_reserve(text, size);
    if (size)
        memcpy(text->at + text->size, bytes, size);
    text->size += size;
    text->at[text->size] = 0;
}
/* Inline: the compiler knows the length of most strings. */
static inline void text_put(Text *text, const char *string)
{
    text_add(text, string, strlen(string));
}
static inline void text_char(Text *text, char c)
{
    if (text->size + 1 >= text->capacity)
        text_reserve(text, 1);
    text->at[text->size++] = c;
    text->at[text->size] = 0;
}
void text_int(Text *text, long value);
/* printf of integers and strings; numbers with a fraction go through the functions below. */
void text_format(Text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
void text_format_list(Text *text, const char *format, va_list args);
/* Appends a GLSL float literal: always with a point or an exponent. A number outside a float's
 * range is clamped to the largest float. */
void text_float(Text *text, double value);
/* Appends a double that reads back exactly. */
void text_double(Text *text, double value);
/* Appends a number with `digits` significant digits, as %.*g: "0.0977", "1e+06", "12". */
void text_rounded(Text *text, double value, int digits);
/* Parses a decimal number that fills the whole string, rounded to nearest; too large a number
 * becomes infinite. The byte after the string must not continue a number: a zero, a space. */
bool text_number(const char *string, size_t size, double *value);
/* Returns the length of the UTF-8 sequence at `at`, 0 if it is invalid: overlong forms,
 * surrogates and code points above U+10FFFF are invalid. */
int text_utf8_length(const unsigned char *at, const unsigned char *end);
/* Returns true for a UTF-8 control character: below U+0020, or U+007F to U+009F. Terminals may obey
 * either group. */
bool text_is_control(const char *at, int size);
/* Appends text of a document in printable form: control characters except tabs, and bytes that
 * are not UTF-8, become \x and two digits per byte. */
void text_visible(Text *text, const char *string, size_t size);
/* Appends a number without a trailing ".0": "0.5", "12", "1000000". */
void text_plain(Text *out, double value);

/* Decodes percent escapes of a URI (RFC 3986): "a%20b.png" -> "a b.png". */
const char *text_decoded(Arena *arena, const char *uri);

/* Returns the system's message for an errno, in English. */
const char *text_error(int error);

/* Character classes of ASCII. */
static inline bool text_is_digit(char c) { return c >= '0' && c <= '9'; }
static inline bool text_is_lower(char c) { return c >= 'a' && c <= 'z'; }
static inline bool text_is_upper(char c) { return c >= 'A' && c <= 'Z'; }
static inline bool text_is_letter(char c) { return text_is_lower(c) || text_is_upper(c); }
static inline bool text_is_alphanumeric(char c) { return text_is_letter(c) || text_is_digit(c); }
static inline char text_lower(char c) { return text_is_upper(c) ? (char)(c - 'A' + 'a') : c; }
/* Compares strings, ignoring the case of ASCII letters; text_same_start() compares at most
 * `size` bytes. */
bool text_same(const char *a, const char *b);
bool text_same_start(const char *a, const char *b, size_t size);
/* Returns the value of a hexadecimal digit; -1: none. */
static inline int text_hex_digit(char c)
{
    const char letter = text_lower(c);
    return text_is_digit(c) ? c - '0' : letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : -1;
}
#endif
