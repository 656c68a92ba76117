/* A text that grows, and numbers as text: the shortest form that reads back exactly. All of this is
 * the same in every locale, and no other file of the library asks for the locale: neither printf of
 * fractions, nor strtod, ctype.h or strerror (tests/sources/locale.sh). */
#ifndef MATC_TEXT_H
#define MATC_TEXT_H
#include "compiler/base/arena.h"
#include <stdarg.h>
#include <stdbool.h>
#include <string.h>

typedef struct {
    Arena *arena;
    char *at; /* zero-terminated once something was added */
    size_t size, room;
} Text;

Text text_new(Arena *arena);
/* Room for so many bytes more, and a zero byte. */
void text_reserve(Text *text, size_t more);
static inline void text_add(Text *text, const char *bytes, size_t size)
{
    if (text->size + size >= text->room)
        text_reserve(text, size);
    if (size)
        memcpy(text->at + text->size, bytes, size);
    text->size += size;
    text->at[text->size] = 0;
}
/* known here, most often */
static inline void text_put(Text *text, const char *string)
{
    text_add(text, string, strlen(string));
}
static inline void text_char(Text *text, char c)
{
    if (text->size + 1 >= text->room)
        text_reserve(text, 1);
    text->at[text->size++] = c;
    text->at[text->size] = 0;
}
void text_int(Text *text, long value);
/* printf of whole numbers and strings; numbers with a fraction go through the functions below. */
void text_format(Text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
void text_format_list(Text *text, const char *format, va_list args);
/* A float literal of GLSL: always with a point or an exponent; a number beyond a float is taken to
 * the greatest. */
void text_float(Text *text, double value);
/* A double that reads back exactly. */
void text_double(Text *text, double value);
/* So many digits as are asked for, as %.*g has them: "0.0977", "1e+06", "12". */
void text_rounded(Text *text, double value, int digits);
/* Reads a decimal number that takes up all of the string, rounded to nearest; one that is too large
 * is infinite. What stands behind the string's end does not continue a number: a zero, a space. */
bool text_number(const char *string, size_t size, double *value);
/* Length of the UTF-8 sequence at `at`, 0 if it is none: overlong forms, surrogates and numbers
 * past U+10FFFF are none. */
int text_utf8_length(const unsigned char *at, const unsigned char *end);
/* Whether a character of UTF-8 is a control character, below U+0020 or U+007F to U+009F: terminals
 * may obey both kinds. */
bool text_is_control(const char *at, int size);
/* Text of a document as it can be shown: control characters but tabs, and what is not UTF-8, become
 * \x and two digits a byte. */
void text_visible(Text *text, const char *string, size_t size);
/* A whole number without a point: "0.5", "12", "1000000". */
void text_plain(Text *out, double value);

/* An address without its %20: RFC 3986. "a%20b.png" -> "a b.png". */
const char *text_decoded(Arena *arena, const char *uri);

/* Message of the system for an errno, in English. */
const char *text_error(int error);

/* Of ASCII. */
static inline bool text_is_digit(char c) { return c >= '0' && c <= '9'; }
static inline bool text_is_lower(char c) { return c >= 'a' && c <= 'z'; }
static inline bool text_is_upper(char c) { return c >= 'A' && c <= 'Z'; }
static inline bool text_is_letter(char c) { return text_is_lower(c) || text_is_upper(c); }
static inline bool text_is_alphanumeric(char c) { return text_is_letter(c) || text_is_digit(c); }
static inline char text_lower(char c) { return text_is_upper(c) ? (char)(c - 'A' + 'a') : c; }
/* Whether two strings are the same but for the case of letters; their first bytes, if they have so
 * many. */
bool text_same(const char *a, const char *b);
bool text_same_start(const char *a, const char *b, size_t size);
/* The value of a hexadecimal digit, or -1. */
static inline int text_hex_digit(char c)
{
    const char letter = text_lower(c);
    return text_is_digit(c) ? c - '0' : letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : -1;
}
#endif
