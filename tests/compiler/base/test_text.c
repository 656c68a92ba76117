/* Texts: numbers are written as the shortest decimals that read back, and are read to nearest;
 * formatted text may have any length. */
#include "tests/test.h"
#include "compiler/base/text.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 100000, LONGEST = 600 };

static uint64_t draw(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    return *state ^= *state << 17;
}

/* How many digits printf needs, by trying. */
static int fewest_digits(double value, bool is_float)
{
    char text[64];
    for (int digits = 1;; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (is_float ? strtof(text, NULL) == (float)value : strtod(text, NULL) == value)
            return digits;
    }
}

/* Digits from the first to the last that is not 0. */
static int digits_of(const char *text)
{
    int count = 0, significant = 0;
    for (; *text && *text != 'e'; text++) {
        if (*text < '0' || *text > '9' || (!count && *text == '0'))
            continue;
        count++;
        if (*text != '0')
            significant = count;
    }
    return significant;
}

static void check(Arena *arena, double value, bool is_float)
{
    Text text = text_new(arena);
    if (is_float)
        text_float(&text, value);
    else
        text_double(&text, value);
    bool back = is_float ? strtof(text.at, NULL) == (float)value : strtod(text.at, NULL) == value;
    bool shortest = value == 0 || digits_of(text.at) <= fewest_digits(value, is_float);
    if (!back || !shortest || !strpbrk(text.at, ".e") || signbit(value) != (*text.at == '-'))
        fail_msg("%.17g is written %s", value, text.at);
    arena_reset(arena);
}

static void numbers_are_short_and_read_back(void **state)
{
    (void)state;
    Arena arena = {0};
    static const double special[] = {
        0,    -0.,     1,        0.1,      1e6,     999999.9,    9.9999999,        0.001,
        1e-3, 8.5e-4,  16777216, 16777217, FLT_MAX, FLT_MIN,     FLT_TRUE_MIN,     1e15,
        1e21, 0.00125, 1 / 3.,   2 / 3.,   1e5 / 3, 123456.7891, 9007199254740993.};
    for (size_t i = 0; i < sizeof special / sizeof *special; i++)
        for (int sign = -1; sign < 2; sign += 2) {
            check(&arena, (float)(sign * special[i]), true);
            check(&arena, sign * special[i], false);
        }
    uint64_t seed = 88172645463325252u;
    for (int i = 0; i < ROUNDS; i++) {
        uint32_t bits = (uint32_t)draw(&seed);
        float any;
        memcpy(&any, &bits, sizeof any);
        if (isfinite(any))
            check(&arena, any, true);
        check(&arena, (float)ldexp((double)(draw(&seed) >> 11), -(int)(43 + draw(&seed) % 22)),
              true); /* ordinary ones */
        /* where the gaps change */
        check(&arena, (float)ldexp(1, (int)(draw(&seed) % 60) - 30), true);
        check(&arena, (double)(draw(&seed) % 256) / 255, false);
        check(&arena, (double)(draw(&seed) >> 11) / 9007199254740992., false);
    }
    arena_free(&arena);
}

static void check_read(const char *text)
{
    double value = -1, wanted = strtod(text, NULL);
    if (!text_number(text, strlen(text), &value) || memcmp(&value, &wanted, sizeof value) != 0)
        fail_msg("%s is read as %.17g, not %.17g", text, value, wanted);
}

/* By the C library's reader, which rounds to nearest: up to 15 digits, and beyond, take two
 * ways. */
static void numbers_are_read_to_nearest(void **state)
{
    (void)state;
    static const char *const texts[] = {"0",
                                        "-0",
                                        "-0.0",
                                        "+1.5",
                                        "5.",
                                        ".5",
                                        "-.5",
                                        "000000000000000000001",
                                        "0.000000000000000000001",
                                        "999999999999999",
                                        "9999999999999999",
                                        "0.999999999999999",
                                        "0.9999999999999999",
                                        "9007199254740993",
                                        "1e22",
                                        "1e23",
                                        "1e999",
                                        "4.9e-324",
                                        "2.4703282292062328e-324"};
    static const char *const none[] = {"",    "-",   ".",  "-.", "1.2.3", "1,5", "0x10",
                                       "inf", "nan", "1e", "1 ", " 1",    "--1", "1-"};
    uint64_t seed = 88172645463325252u;
    double value;
    char text[64];
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        check_read(texts[i]);
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        assert_false(text_number(none[i], strlen(none[i]), &value));
    for (int i = 0; i < ROUNDS; i++) {
        const int digits = 1 + (int)(draw(&seed) % 18), places = (int)(draw(&seed) % 19);
        snprintf(text, sizeof text, "%.*f", places,
                 (double)(draw(&seed) >> 11) * pow(10, -(int)(draw(&seed) % 16)));
        check_read(text);
        snprintf(text, sizeof text, "-0.%0*llu", digits,
                 (unsigned long long)(draw(&seed) % 1000000000000000000u));
        check_read(text);
    }
}

static void formats_of_any_length_fit(void **state)
{
    (void)state;
    Arena arena = {0};
    char word[LONGEST + 1] = "", wanted[2 * LONGEST + 16];
    for (int size = 0; size < LONGEST; size++) {
        Text text = text_new(&arena);
        text_put(&text, word);
        text_format(&text, "<%s %d>", word, size);
        snprintf(wanted, sizeof wanted, "%s<%s %d>", word, word, size);
        assert_string_equal(text.at, wanted);
        assert_int_equal(text.size, strlen(wanted));
        word[size] = (char)('a' + size % 26);
        word[size + 1] = 0;
        arena_reset(&arena);
    }
    Text none = text_new(&arena);
    text_format(&none, "%s", "");
    assert_string_equal(none.at, "");
    arena_free(&arena);
}

/* Well-formed sequences, by the table of the Unicode standard: first and last of every row, and
 * what lies beside. */
static void only_unicode_is_utf8(void **state)
{
    (void)state;
    static const struct {
        const char *bytes;
        int length; /* of the character; 0: none */
    } cases[] = {
        {"\x00", 1},
        {"\x7F", 1},
        {"\x80", 0},
        {"\xBF", 0},
        {"\xC0\x80", 0},
        {"\xC1\xBF", 0},
        {"\xC2\x80", 2},
        {"\xDF\xBF", 2},
        {"\xC2\x7F", 0},
        {"\xC2\xC0", 0},
        {"\xE0\x9F\xBF", 0},
        {"\xE0\xA0\x80", 3},
        {"\xEC\xBF\xBF", 3},
        {"\xED\x9F\xBF", 3},
        {"\xED\xA0\x80", 0},
        {"\xED\xBF\xBF", 0},
        {"\xEE\x80\x80", 3},
        {"\xEF\xBF\xBF", 3},
        {"\xF0\x8F\xBF\xBF", 0},
        {"\xF0\x90\x80\x80", 4},
        {"\xF3\xBF\xBF\xBF", 4},
        {"\xF4\x8F\xBF\xBF", 4},
        {"\xF4\x90\x80\x80", 0},
        {"\xF5\x80\x80\x80", 0},
        {"\xFF", 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const unsigned char *at = (const unsigned char *)cases[i].bytes;
        size_t size = cases[i].bytes[0] ? strlen(cases[i].bytes) : 1;
        if (text_utf8_length(at, at + size) != cases[i].length)
            fail_msg("case %d: %d", (int)i, text_utf8_length(at, at + size));
        if (size > 1 && cases[i].length)
            assert_int_equal(text_utf8_length(at, at + size - 1), 0); /* cut off */
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_short_and_read_back),
        cmocka_unit_test(numbers_are_read_to_nearest),
        cmocka_unit_test(formats_of_any_length_fit),
        cmocka_unit_test(only_unicode_is_utf8),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
