/* The progress line of a terminal: written at most ten times per second, over itself, and erased
 * at the end. */
#include "tests/test.h"
#include "compiler/base/progress.h"

static void lines_are_rare(void **state)
{
    static const struct {
        double now;
        const char *written;
    } steps[] = {
        {100, "\r\033[Ka\r"}, {100.05, ""},         {100.099, ""}, {100.101, "\r\033[Ka\r"},
        {100.15, ""},         {105, "\r\033[Ka\r"}, {105.01, ""}};
    (void)state;
    Arena arena = {0};
    double last = 0;
    assert_string_equal(progress_erase(&last), ""); /* nothing is there to be erased */
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        Text text = text_new(&arena);
        assert_string_equal(progress_line(&text, "a", steps[i].now, &last), steps[i].written);
    }
    assert_string_equal(progress_erase(&last), "\r\033[K");
    assert_string_equal(progress_erase(&last), "");
    Text text = text_new(&arena);
    assert_string_equal(progress_line(&text, "b", 105.02, &last), "\r\033[Kb\r");
    arena_free(&arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(lines_are_rare)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
