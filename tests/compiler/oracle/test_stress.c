/* A short run of `matbench stress`: a random document has one meaning for the oracle, the IR and
 * the drawn program. */
/* ctest: seconds=10 */
#include "tests/test.h"
#include "tests/sanitized.h"
#include "tests/stress/generate.h"
#include "tests/stress/shrink.h"
#include "tests/stress/stress.h"
#include <string.h>

enum { TREES = SANITIZED ? 100 : 400, RELIEFS = SANITIZED ? 20 : 60 };

static void random_trees_hold(void **state)
{
    (void)state;
    StressOptions options;
    TrialCount n = {0};
    stress_options_init(&options);
    options.count = TREES;
    options.validate_every = 20;
    options.draw_every = 32;
    int faults = stress_run(&options, &n);
    print_message("%ld trees, %ld values, %ld validated, %ld drawn\n", n.trees, n.values,
                  n.validated, n.programs);
    assert_int_equal(faults, 0);
    assert_int_equal(n.trees, TREES);
    assert_true(n.values > 10 * TREES && n.programs > TREES / 32 && n.judged > 5 * TREES / 2);
}

/* Trees of displacements, each way of finding their slopes: nearly all of a document is there to be
 * differentiated. */
static void random_reliefs_hold(void **state)
{
    (void)state;
    static const char *const derivatives[] = {"auto", "analytic", "finite"};
    for (size_t i = 0; i < sizeof derivatives / sizeof *derivatives; i++) {
        StressOptions options;
        TrialCount n = {0};
        stress_options_init(&options);
        options.generate = generate_relief;
        options.options.derivatives = derivatives[i];
        options.options.aa = "none";
        options.count = RELIEFS;
        options.validate_every = options.draw_every = 0;
        assert_int_equal(stress_run(&options, &n), 0);
        print_message("%s: %ld trees, %ld values, %ld known slopes\n", derivatives[i], n.trees,
                      n.values, n.slopes);
        assert_true(n.slopes > RELIEFS || !strcmp(derivatives[i], "finite"));
    }
}

/* Trees that once had a fault. */
static void mended_trees_hold(void **state)
{
    (void)state;
    static const struct {
        uint64_t seed;
        long first;
        /* Blend: values that are one as floats, and their distance a divisor at -O0 */
    } trees[] = {{20261121, 6118}};
    for (size_t i = 0; i < sizeof trees / sizeof *trees; i++) {
        StressOptions options;
        TrialCount n = {0};
        stress_options_init(&options);
        options.seed = trees[i].seed;
        options.first = trees[i].first;
        options.count = 1;
        assert_int_equal(stress_run(&options, &n), 0);
        assert_int_equal(n.trees, 1);
    }
}

/* One seed, one document: a fault's seed is all that is needed to see it again. */
static void a_seed_is_a_document(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < 50; i++) {
        Arena arena = {0};
        Choices first, again;
        Text a = text_new(&arena), b = text_new(&arena);
        choices_random(&first, 5, i);
        generate_document(&first, &a);
        choices_script(&again, first.made, first.count);
        generate_document(&again, &b);
        assert_string_equal(a.at, b.at);
        assert_int_equal(first.count, again.count);
        arena_free(&arena);
    }
}

/* Fails where any two neighbors sum to 100 or more. */
static bool has_pair(void *user, const uint32_t *script, int count)
{
    (void)user;
    for (int i = 0; i + 1 < count; i++)
        if (script[i] + script[i + 1] >= 100)
            return true;
    return false;
}

static void scripts_shrink(void **state)
{
    (void)state;
    uint32_t script[200];
    for (int i = 0; i < 200; i++)
        script[i] = (uint32_t)(i * 37 % 90);
    Shrinker shrinker = {has_pair, NULL, 5000};
    int count = shrink(&shrinker, script, 200);
    assert_int_equal(count, 2);
    assert_int_equal(script[0] + script[1], 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_seed_is_a_document), cmocka_unit_test(scripts_shrink),
        cmocka_unit_test(mended_trees_hold),    cmocka_unit_test(random_trees_hold),
        cmocka_unit_test(random_reliefs_hold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
