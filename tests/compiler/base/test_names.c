/* Interned names, strings and keys, numbered in order of insertion (names.c, sets.c): with many
 * more than the first table holds, every entry is found under its number, and no absent entry is
 * found. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/base/names.h"
#include "compiler/base/sets.h"
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { COUNT = 5000, NAME = 16, MAX_SECONDS = 60 };

/* Name of a number, in memory of its own. */
static const char *name_of(Arena *arena, int number)
{
    char *name = ARENA_ARRAY(arena, char, NAME);
    snprintf(name, NAME, "name%d", number);
    return name;
}

static void every_name_is_found_under_its_number(void **state)
{
    (void)state;
    Arena arena = {0};
    Names names = {0};
    assert_int_equal(names_find(&names, "name0"), -1);
    for (int i = 0; i < COUNT; i++) {
        assert_int_equal(names_find(&names, name_of(&arena, i)), -1);
        assert_int_equal(names_add(&arena, &names, name_of(&arena, i)), i);
        assert_int_equal(names_add(&arena, &names, name_of(&arena, i / 2)), i / 2);
        assert_int_equal(names.count, i + 1);
    }
    for (int i = 0; i < COUNT; i++) {
        assert_int_equal(names_find(&names, name_of(&arena, i)), i);
        assert_string_equal(names.at[i], name_of(&arena, i));
    }
    arena_free(&arena);
}

/* Names of one beginning, of no letters, of other cases. */
static void names_that_are_alike_are_several(void **state)
{
    static const char *const alike[] = {"",         "a",    "A",     "aa",     "a ",
                                        "\xC3\xA4", "name", "name1", "name10", "Name"};
    (void)state;
    Arena arena = {0};
    Names names = {0};
    const int count = sizeof alike / sizeof *alike;
    for (int round = 0; round < 2; round++)
        for (int i = 0; i < count; i++)
            assert_int_equal(names_add(&arena, &names, alike[i]), i);
    assert_int_equal(names_find(&names, "nam"), -1);
    assert_int_equal(names.count, count);
    arena_free(&arena);
}

static void a_set_of_strings_copies_and_finds_them(void **state)
{
    (void)state;
    StringSet set = {0};
    char name[NAME];
    bool added;
    assert_int_equal(string_set_find(&set, "name0"), -1);
    for (int i = 0; i < COUNT; i++) {
        snprintf(name, sizeof name, "name%d", i); /* always in the same place */
        assert_int_equal(string_set_add(&set, name, &added), i);
        assert_true(added);
        assert_int_equal(string_set_add(&set, name, &added), i);
        assert_false(added);
    }
    for (int i = 0; i < COUNT; i++) {
        snprintf(name, sizeof name, "name%d", i);
        assert_int_equal(string_set_find(&set, name), i);
        assert_string_equal(set.at[i], name);
    }
    assert_int_equal(string_set_find(&set, "name"), -1);
    assert_int_equal(set.count, COUNT);
    string_set_free(&set);
}

/* Keys with one half alike: both halves count. */
static void a_set_of_keys_looks_at_both_halves(void **state)
{
    (void)state;
    KeySet set = {0};
    bool added;
    assert_int_equal(key_set_find(&set, (Key){0, 0}), -1);
    for (int i = 0; i < COUNT; i++) {
        assert_int_equal(key_set_add(&set, (Key){(uint64_t)i % 7, (uint64_t)i}, &added), i);
        assert_true(added);
    }
    for (int i = 0; i < COUNT; i++) {
        assert_int_equal(key_set_add(&set, (Key){(uint64_t)i % 7, (uint64_t)i}, &added), i);
        assert_false(added);
        assert_int_equal(key_set_find(&set, (Key){(uint64_t)i % 7 + 1, (uint64_t)i}), -1);
        assert_int_equal(key_set_find(&set, (Key){(uint64_t)i % 7, (uint64_t)i}), i);
    }
    assert_int_equal(set.count, COUNT);
    key_set_free(&set);
}

static void two_keys_differ_in_any_bit(void **state)
{
    (void)state;
    const Key key = {0x0123456789abcdef, 0xfedcba9876543210};
    char text[KEY_TEXT];
    key_text(key, text);
    assert_int_equal(strlen(text), KEY_TEXT - 1);
    assert_true(key_equal(key, key_read(text)));
    for (int bit = 0; bit < 128; bit++) {
        Key other = {key.low ^ (bit < 64 ? 1ull << bit : 0),
                     key.high ^ (bit < 64 ? 0 : 1ull << (bit - 64))};
        assert_false(key_equal(key, other));
        key_text(other, text);
        assert_true(key_equal(other, key_read(text)));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_name_is_found_under_its_number),
        cmocka_unit_test(names_that_are_alike_are_several),
        cmocka_unit_test(a_set_of_strings_copies_and_finds_them),
        cmocka_unit_test(a_set_of_keys_looks_at_both_halves),
        cmocka_unit_test(two_keys_differ_in_any_bit),
    };
    alarm(MAX_SECONDS);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
