/* Growing texts and locale-free numbers. The caller has the "C" locale in force (compile.c sees to it). */
#include "text.h"
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NUMBER_ROOM = 40, FLOAT_DIGITS = 9, DOUBLE_DIGITS = 17 };

Text text_new(Arena *arena) { return (Text){arena, NULL, 0, 0}; }

static void reserve(Text *text, size_t more)
{
    size_t need = text->size + more + 1;
    if (need <= text->room)
        return;
    size_t room = text->room ? text->room * 2 : 256;
    while (room < need)
        room *= 2;
    char *moved = arena_alloc(text->arena, room);
    if (text->size)
        memcpy(moved, text->at, text->size);
    text->at = moved;
    text->room = room;
}

void text_add(Text *text, const char *bytes, size_t size)
{
    reserve(text, size);
    if (size)
        memcpy(text->at + text->size, bytes, size);
    text->size += size;
    text->at[text->size] = 0;
}

void text_put(Text *text, const char *string) { text_add(text, string, strlen(string)); }
void text_char(Text *text, char c) { text_add(text, &c, 1); }

void text_int(Text *text, long value)
{
    char digits[NUMBER_ROOM], *end = digits + sizeof digits, *at = end;
    unsigned long rest = value < 0 ? 0ul - (unsigned long)value : (unsigned long)value;
    do
        *--at = (char)('0' + rest % 10);
    while (rest /= 10);
    if (value < 0)
        *--at = '-';
    text_add(text, at, (size_t)(end - at));
}

void text_format_list(Text *text, const char *format, va_list args)
{
    va_list again;
    va_copy(again, args);
    int size = vsnprintf(NULL, 0, format, args);
    if (size > 0) {
        reserve(text, (size_t)size);
        vsnprintf(text->at + text->size, (size_t)size + 1, format, again);
        text->size += (size_t)size;
    }
    va_end(again);
}

void text_format(Text *text, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    text_format_list(text, format, args);
    va_end(args);
}

/* Whole numbers and short decimals, most constants of a document, without printf: value = whole / 10^places. */
static bool short_decimal(Text *text, double value, bool is_float)
{
    static const double power[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
    double size = fabs(value);
    if (size >= 1e6 || (value == 0 && signbit(value)))
        return false;
    for (int places = 0; places <= 6; places++) {
        double whole = nearbyint(size * power[places]);
        double back = whole / power[places];
        if (whole > 9e6 || (is_float ? (float)back != (float)size : back != size))
            continue;
        char digits[NUMBER_ROOM], *end = digits + sizeof digits, *at = end;
        long rest = (long)whole;
        if (places == 0)
            *--at = '0'; /* "2.0" */
        for (int i = 0; i < places; i++, rest /= 10)
            *--at = (char)('0' + rest % 10);
        *--at = '.';
        do
            *--at = (char)('0' + rest % 10);
        while (rest /= 10);
        if (value < 0)
            *--at = '-';
        text_add(text, at, (size_t)(end - at));
        return true;
    }
    return false;
}

static void shortest(Text *text, double value, int most, bool is_float)
{
    char digits[NUMBER_ROOM];
    for (int precision = 1; precision <= most; precision++) {
        snprintf(digits, sizeof digits, "%.*g", precision, value);
        if (is_float ? strtof(digits, NULL) == (float)value : strtod(digits, NULL) == value)
            break;
    }
    text_put(text, digits);
    if (!strpbrk(digits, ".en"))
        text_put(text, ".0");
}

void text_float(Text *text, double value)
{
    if (fabs(value) > FLT_MAX)
        value = copysign(FLT_MAX, value);
    value = (float)value;
    if (!short_decimal(text, value, true))
        shortest(text, value, FLOAT_DIGITS, true);
}

void text_double(Text *text, double value)
{
    if (!short_decimal(text, value, false))
        shortest(text, value, DOUBLE_DIGITS, false);
}

void text_json(Text *text, const char *string, size_t size)
{
    text_char(text, '"');
    for (size_t i = 0; i < size; i++) {
        unsigned char c = (unsigned char)string[i];
        if (c == '"' || c == '\\')
            text_format(text, "\\%c", c);
        else if (c < 0x20)
            text_format(text, "\\u%04x", c);
        else
            text_char(text, (char)c);
    }
    text_char(text, '"');
}

bool text_number(const char *string, size_t size, double *value)
{
    if (!size || size >= 64 || !strchr("+-.0123456789", string[0]))
        return false;
    for (size_t i = 0; i < size; i++)
        if (!strchr("+-.eE0123456789", string[i]) || !string[i])
            return false; /* no hexadecimal, no "inf" */
    char copy[64], *end;
    memcpy(copy, string, size);
    copy[size] = 0;
    *value = strtod(copy, &end);
    return *end == 0 && end != copy;
}

int utf8_length(const unsigned char *at, const unsigned char *end)
{
    if (at[0] < 0x80)
        return 1;
    int length = at[0] >= 0xF0 ? 4 : at[0] >= 0xE0 ? 3 : 2;
    if (at[0] < 0xC2 || at[0] > 0xF4 || end - at < length)
        return 0;
    for (int i = 1; i < length; i++)
        if ((at[i] & 0xC0) != 0x80)
            return 0;
    if ((at[0] == 0xE0 && at[1] < 0xA0) || (at[0] == 0xED && at[1] > 0x9F) || (at[0] == 0xF0 && at[1] < 0x90) ||
        (at[0] == 0xF4 && at[1] > 0x8F))
        return 0;
    return length;
}
