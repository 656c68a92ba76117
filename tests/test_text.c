/* Texts: numbers are the shortest decimals that read back, and formats of any length fit. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "compiler/text.h"
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
    static const double special[] = {0,    -0.,     1,        0.1,      1e6,     999999.9,    9.9999999,       0.001,
                                     1e-3, 8.5e-4,  16777216, 16777217, FLT_MAX, FLT_MIN,     FLT_TRUE_MIN,    1e15,
                                     1e21, 0.00125, 1 / 3.,   2 / 3.,   1e5 / 3, 123456.7891, 9007199254740993};
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
              true);                                                        /* ordinary ones */
        check(&arena, (float)ldexp(1, (int)(draw(&seed) % 60) - 30), true); /* where the gaps change */
        check(&arena, (double)(draw(&seed) % 256) / 255, false);
        check(&arena, (double)(draw(&seed) >> 11) / 9007199254740992., false);
    }
    arena_free(&arena);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_short_and_read_back),
        cmocka_unit_test(formats_of_any_length_fit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
