/* Growing texts, and conversion of numbers independent of the locale: functions of the C library
 * that depend on it are called here, in the "C" locale. */
#include "compiler/base/text.h"
#include "compiler/base/memory.h"
#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NUMBER_CAPACITY = 40, FORMAT_CAPACITY = 128, MAX_PLACES = 11, SIMPLE_DIGITS = 15 };

/* The thread's locale is "C" between enter() and leave(), which restores the previous locale. */
typedef struct {
    locale_t plain, before;
} Locale;

static Locale enter(void)
{
    Locale locale = {newlocale(LC_ALL_MASK, "C", (locale_t)0), (locale_t)0};
    if (!locale.plain)
        memory_exhausted();
    locale.before = uselocale(locale.plain);
    return locale;
}

static void leave(Locale locale)
{
    uselocale(locale.before);
    freelocale(locale.plain);
}

Text text_new(Arena *arena) { return (Text){arena, NULL, 0, 0}; }

/* The first capacity fits most names. */
void text_reserve(Text *text, size_t more)
{
    enum { FIRST_CAPACITY = 64 };
    const size_t need = text->size + more + 1;
    size_t capacity = text->capacity ? text->capacity : FIRST_CAPACITY;
    if (need <= text->capacity)
        return;
    while (capacity < need)
        capacity *= 2;
    text->at = arena_extend(text->arena, text->at, text->capacity, text->size, capacity);
    text->capacity = capacity;
}

void text_int(Text *text, long value)
{
    char digits[NUMBER_CAPACITY], *end = digits + sizeof digits, *at = end;
    unsigned long rest = value < 0 ? 0ul - (unsigned long)value : (unsigned long)value;
    do
        *--at = (char)('0' + rest % 10);
    while (rest /= 10);
    if (value < 0)
        *--at = '-';
    text_add(text, at, (size_t)(end - at));
}

/* Returns true if the format uses only %s, %d and %%, as most formats do. put_plain() then replaces
 * printf, which costs a thousand instructions a call. */
static bool is_plain(const char *format)
{
    for (const char *at = strchr(format, '%'); at; at = strchr(at + 2, '%'))
        if (at[1] != 's' && at[1] != 'd' && at[1] != '%')
            return false;
    return true;
}

static void put_plain(Text *text, const char *format, va_list args)
{
    for (const char *at = strchr(format, '%'); at; format = at + 2, at = strchr(format, '%')) {
        text_add(text, format, (size_t)(at - format));
        const char *string = at[1] == 's' ? va_arg(args, const char *) : NULL;
        if (at[1] == 's')
            text_put(text, string ? string : "(null)"); /* appends what printf prints for NULL */
        else if (at[1] == 'd')
            text_int(text, va_arg(args, int));
        else
            text_char(text, '%');
    }
    text_put(text, format);
}

void text_format_list(Text *text, const char *format, va_list args)
{
    if (is_plain(format)) {
        put_plain(text, format, args);
        return;
    }
    va_list again;
    va_copy(again, args);
    text_reserve(text, FORMAT_CAPACITY);
    size_t capacity = text->capacity - text->size;
    int size = vsnprintf(text->at + text->size, capacity, format, args);
    if (size > 0 && (size_t)size >= capacity) {
        text_reserve(text, (size_t)size);
        vsnprintf(text->at + text->size, (size_t)size + 1, format, again);
    }
    if (size > 0)
        text->size += (size_t)size;
    text->at[text->size] = 0;
    va_end(again);
}

void text_format(Text *text, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    text_format_list(text, format, args);
    va_end(args);
}

/* Appends whole / 10^places. */
static void put_decimal(Text *text, bool negative, uint64_t whole, int places)
{
    char digits[NUMBER_CAPACITY], *end = digits + sizeof digits, *at = end;
    if (places == 0)
        *--at = '0'; /* writes "2.0" for 2 */
    for (int i = 0; i < places; i++, whole /= 10)
        *--at = (char)('0' + whole % 10);
    *--at = '.';
    do
        *--at = (char)('0' + whole % 10);
    while (whole /= 10);
    if (negative)
        *--at = '-';
    text_add(text, at, (size_t)(end - at));
}

/* Formats integers and short decimals, the majority of a document's constants, without printf:
 * value = whole / 10^places. Returns false for any other number. */
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
        put_decimal(text, value < 0, (uint64_t)whole, places);
        return true;
    }
    return false;
}

/* Formats the remaining floats from 1e-3 to 1e6: the shortest decimal that reads back, in exact
 * integer arithmetic. The float is m 2^q. A decimal reads back if it is less than half of 2^q
 * away, or exactly half and m is even. All numbers are in units of 2^(q - 1) / 10^places. */
static bool ordinary_float(Text *text, double value)
{
    static const uint64_t power[MAX_PLACES + 1] = {
        1,       10,       100,       1000,       10000,       100000,
        1000000, 10000000, 100000000, 1000000000, 10000000000, 100000000000};
    int q;
    const double size = fabs(value);
    const uint64_t m = (uint64_t)ldexp(frexp(size, &q), FLT_MANT_DIG);
    /* A power of two is excluded: the gap below it is narrower. */
    if (!(size >= 1e-3 && size < 1e6) || m == 1 << (FLT_MANT_DIG - 1))
        return false;
    const int shift = FLT_MANT_DIG + 1 - q; /* 1 << shift is 1 / 10^places */
    for (int places = 0; places <= MAX_PLACES; places++) {
        uint64_t scaled = 2 * m * power[places], whole = scaled >> shift,
                 rest = scaled - (whole << shift);
        uint64_t half = (uint64_t)1 << (shift - 1);
        whole += rest > half || (rest == half && whole & 1);
        uint64_t back = whole << shift, off = back > scaled ? back - scaled : scaled - back;
        if (off < power[places] || (off == power[places] && m % 2 == 0)) {
            put_decimal(text, value < 0, whole, places);
            return true;
        }
    }
    return false;
}

/* Formats any number by printf, with the fewest digits that read back. `least` is the number of
 * digits that always survive a round trip: fewer digits would print the same decimal. Subnormal
 * numbers, and doubles from 1e6 on, begin at 1 digit. */
static void shortest(Text *text, double value, int least, bool is_float)
{
    char digits[NUMBER_CAPACITY];
    const int most = is_float ? FLT_DECIMAL_DIG : DBL_DECIMAL_DIG;
    const Locale locale = enter();
    for (int precision = least; precision <= most; precision++) {
        snprintf(digits, sizeof digits, "%.*g", precision, value);
        if (is_float ? strtof(digits, NULL) == (float)value : strtod(digits, NULL) == value)
            break;
    }
    leave(locale);
    text_put(text, digits);
    if (!strpbrk(digits, ".en"))
        text_put(text, ".0");
}

void text_float(Text *text, double value)
{
    if (fabs(value) > FLT_MAX)
        value = copysign(FLT_MAX, value);
    value = (float)value;
    if (!short_decimal(text, value, true) && !ordinary_float(text, value))
        shortest(text, value, fabs(value) < FLT_MIN ? 1 : FLT_DIG, true);
}

void text_double(Text *text, double value)
{
    if (!short_decimal(text, value, false))
        shortest(text, value, fabs(value) < DBL_MIN || fabs(value) >= 1e6 ? 1 : DBL_DIG, false);
}

void text_rounded(Text *text, double value, int digits)
{
    const Locale locale = enter();
    text_format(text, "%.*g", digits, value);
    leave(locale);
}

const char *text_error(int error)
{
    const Locale locale = enter();
    const char *reported = strerror(error);
    leave(locale);
    return reported;
}

bool text_same_start(const char *a, const char *b, size_t size)
{
    for (size_t i = 0; i < size; i++)
        if (text_lower(a[i]) != text_lower(b[i]) || !a[i])
            return a[i] == b[i];
    return true;
}

bool text_same(const char *a, const char *b) { return text_same_start(a, b, SIZE_MAX); }

bool text_is_control(const char *at, int size)
{
    const unsigned char first = (unsigned char)at[0];
    if (size == 1)
        return first < 0x20 || first == 0x7F;
    return size == 2 && first == 0xC2 && (unsigned char)at[1] < 0xA0;
}

/* Parses numbers of up to 15 digits without an exponent, as most are. The digits and the power
 * of ten are exact doubles; their quotient is rounded once and therefore nearest (Clinger,
 * 1990). "-12.50" is -(1250 / 10^2). Returns false for any other text. */
static bool simple_number(const char *string, size_t size, double *value)
{
    static const double power[SIMPLE_DIGITS + 1] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                    1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const char *at = string, *end = string + size, *point = NULL;
    uint64_t whole = 0;
    int digits = 0;
    for (at += *at == '-'; at < end; at++) {
        if (*at == '.' && !point)
            point = at + 1;
        else if (text_is_digit(*at) && ++digits <= SIMPLE_DIGITS)
            whole = 10 * whole + (uint64_t)(*at - '0');
        else
            return false;
    }
    if (!digits)
        return false;
    const double magnitude = (double)whole / power[point ? end - point : 0];
    *value = *string == '-' ? -magnitude : magnitude;
    return true;
}

bool text_number(const char *string, size_t size, double *value)
{
    char *end;
    if (size && simple_number(string, size, value))
        return true;
    if (!size || !strchr("+-.0123456789", string[0]))
        return false;
    for (size_t i = 0; i < size; i++)
        if (!strchr("+-.eE0123456789", string[i]) || !string[i])
            return false; /* rejects hexadecimal and "inf" */
    const Locale locale = enter();
    *value = strtod(string, &end);
    leave(locale);
    return end == string + size;
}

int text_utf8_length(const unsigned char *at, const unsigned char *end)
{
    if (at[0] < 0x80)
        return 1;
    int length = at[0] >= 0xF0 ? 4 : at[0] >= 0xE0 ? 3 : 2;
    if (at[0] < 0xC2 || at[0] > 0xF4 || end - at < length)
        return 0;
    for (int i = 1; i < length; i++)
        if ((at[i] & 0xC0) != 0x80)
            return 0;
    if ((at[0] == 0xE0 && at[1] < 0xA0) || (at[0] == 0xED && at[1] > 0x9F) ||
        (at[0] == 0xF0 && at[1] < 0x90) || (at[0] == 0xF4 && at[1] > 0x8F))
        return 0;
    return length;
}

void text_visible(Text *text, const char *string, size_t size)
{
    for (const char *end = string + size; string < end;) {
        int length = text_utf8_length((const unsigned char *)string, (const unsigned char *)end);
        bool shown = length && (!text_is_control(string, length) || *string == '\t');
        const char *next = string + (length ? length : 1);
        if (shown)
            text_add(text, string, (size_t)length);
        for (; !shown && string < next; string++)
            text_format(text, "\\x%02x", (unsigned char)*string);
        string = next;
    }
}

void text_plain(Text *out, double value)
{
    if (value == trunc(value) && fabs(value) < 1e9)
        text_int(out, (long)value);
    else
        text_double(out, value);
}

const char *text_decoded(Arena *arena, const char *uri)
{
    Text text = text_new(arena);
    text_put(&text, "");
    for (; *uri; uri++) {
        const int high = *uri == '%' ? text_hex_digit(uri[1]) : -1,
                  low = high >= 0 ? text_hex_digit(uri[2]) : -1;
        const bool code = low >= 0 && high + low > 0;
        text_char(&text, code ? (char)(16 * high + low) : *uri);
        uri += code ? 2 : 0;
    }
    return text.at;
}
