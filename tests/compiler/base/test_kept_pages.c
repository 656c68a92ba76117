/* A process that keeps its memory pages requests no new pages when it compiles the same
 * documents a second time. Pages are counted by the system, not timed. */
/* ctest: small-pages */
#include "tests/test.h"
#include "compiler/base/arena.h"
#include "compiler/matc.h"
#include "tests/sanitized.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

enum { ITEMS = 600, RUNS = 8, FEW_PAGES = 64 }; /* a program takes over a thousand */

static long pages(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
}

static void compile(const char *text, size_t size)
{
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    MatcDocument *document = matc_read("pages.yaml", text, size, &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    assert_true(matc_ok(program));
    matc_program_free(program);
    matc_document_free(document);
}

static void pages_are_taken_once(void **state)
{
    (void)state;
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    fputs("material: Phong\ndiffuse:\n  map: Blend\n  blend:\n", out);
    for (int i = 0; i < ITEMS; i++)
        fprintf(
            out,
            "  - { value: %d, input: { map: Checker, input: { map: UVTransform, scaleU: %d } } }\n",
            i, i + 1);
    fclose(out);
    arena_keep_pages();
    const long before = pages();
    compile(text, size);
    const long first = pages() - before;
    for (int i = 0; i < RUNS; i++)
        compile(text, size);
    const long after = pages();
    for (int i = 0; i < RUNS; i++)
        compile(text, size);
    const long again = (pages() - after) / RUNS;
    print_message("%ld pages for the first, %ld for each of the last\n", first, again);
    free(text);
    assert_true(first > 4 * FEW_PAGES);
    if (!SANITIZED) /* which have a malloc of their own */
        assert_true(again <= FEW_PAGES);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(pages_are_taken_once)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
