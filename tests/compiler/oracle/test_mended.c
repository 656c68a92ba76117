/* Documents that once exposed a fault, tried as by `matbench stress` in every mode and with
 * every pixel footprint. */
/* ctest: seconds=50 */
#include "tests/test.h"
#include "compiler/base/file.h"
#include "tests/sanitized.h"
#include "tests/stress/modes.h"
#include "tests/stress/stress.h"
#include "tests/value/documents.h"
#include "tests/value/share.h"
#include <stdlib.h>
#include <string.h>

enum { PIXELS = 10 / SANITIZED_STEP, POINTS = 16, SHARES = 6 };

/* Documents that once had a fault, in every mode, with every pixel. */
static void mended_documents_hold(void **state)
{
    (void)state;
    const char *only = getenv("STRESS_ONLY");
    int faults = 0, tried = 0;
    DocumentList list = documents_in(SOURCE_FOLDER "/tests/stress/mended");
    for (int i = 0; i < list.count * stress_mode_count; i++) {
        const StressMode *mode = &stress_modes[i % stress_mode_count];
        const char *path = list.paths[i / stress_mode_count];
        StressOptions options;
        TrialCount n = {0};
        if (only && !strstr(path, only))
            continue;
        stress_options_init(&options);
        stress_mode_set(mode, &options.options);
        options.first = i; /* each mode draws another pixel */
        options.count = PIXELS;
        const bool draws = !strcmp(mode->name, "box") || !strcmp(mode->name, "analyticAniso");
        /* drivers take their time with each program */
        const bool takes = !SANITIZED && share_takes(i / stress_mode_count, SHARES);
        options.draw_every = draws && takes ? PIXELS : 0;
        options.validate_every = 0;
        options.points = POINTS;
        size_t size;
        const char *why = NULL;
        char *text = file_read(path, &size, &why);
        assert_non_null(text);
        int found = stress_document(&options, text, size, &n);
        if (found)
            print_error("%s in mode %s: %d faults\n", path, mode->name, found);
        free(text);
        faults += found;
        tried++;
    }
    documents_free(&list);
    assert_true(tried > 0);
    assert_int_equal(faults, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mended_documents_hold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
