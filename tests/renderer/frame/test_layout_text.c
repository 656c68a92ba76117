/* Data layouts shared by C and GLSL: offsets in C's enum and in the embedded GLSL equal sums
 * made by hand. */
#include "gen/bisection_layout.h"
#include "gen/render_text.h"
#include "tests/test.h"
#include <stdio.h>
#include <string.h>

/* Name in GLSL, value in C, and the value computed by hand. */
static const struct {
    const char *name;
    int here, expected;
} words[] = {
    {"BISECT_BASE", BISECTION_BASE, 22},
    {"HIGH", BISECTION_HIGH, 0},
    {"MERGED_ALL", BISECTION_MERGED_ALL, 11},
    {"GROUPS_CHOSEN", BISECTION_GROUPS_CHOSEN, 16 + 4},
    {"LIGHT", BISECTION_LIGHT, 28},
    {"BOX", BISECTION_BOX, 28 + 4 * 16},
    {"EXTENT", BISECTION_EXTENT, 92 + 2 * 3},
    {"STATE_WORDS", BISECTION_STATE_WORDS, 98 + 3 * 16},
    {"LIST_WANTED", BISECTION_LIST_WANTED, 3},
    {"LIST_DUE", BISECTION_LIST_DUE, 3 + 2 + 2},
};

static void test_bisection(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        char declared[80];
        snprintf(declared, sizeof declared, "const uint %s = %du;", words[i].name,
                 words[i].expected);
        assert_int_equal(words[i].here, words[i].expected);
        if (!strstr(render_text_bisect, declared))
            fail_msg("bisect.glsl does not declare %s", declared);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_bisection)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
