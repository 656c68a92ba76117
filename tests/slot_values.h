/* The C reference's values of a document's slots, against published numbers. */
#ifndef TESTS_SLOT_VALUES_H
#define TESTS_SLOT_VALUES_H
#include "tests/test.h"
#include "tests/compile_text.h"
#include <math.h>

static const double CLOSE = 1e-3; /* tolerance of published values */

/* The reference's values, and the messages of reading; `at` is a point. */
static inline char *values_at(const char *text, const char *at, char **reported)
{
    MatcOptions options = quick();
    options.pixels = true;
    const char *fault;
    MatcDocument *document = read_text(text, &options);
    char *result = matc_eval(document, 0, at, &options, &fault);
    if (!result)
        fprintf(stderr, "%s\n%s", text, matc_diagnostics(document, MATC_TEXT));
    assert_non_null(result);
    if (reported)
        *reported = strdup(matc_diagnostics(document, MATC_TEXT));
    matc_document_free(document);
    return result;
}

/* Parses a slot's components out of that text; returns their number. */
static inline int read_slot(const char *values, const char *slot, double got[3])
{
    char line[64];
    const int length = snprintf(line, sizeof line, "\n%s ", slot);
    const char *found = strstr(values, line);
    if (!strncmp(values, line + 1, length - 1)) /* the first line has no newline before it */
        return sscanf(values + length - 1, "%lf %lf %lf", &got[0], &got[1], &got[2]);
    assert_non_null(found);
    return sscanf(found + length, "%lf %lf %lf", &got[0], &got[1], &got[2]);
}

static inline void expect_slot(const char *values, const char *slot, const double *want,
                               int components)
{
    double got[3] = {NAN, NAN, NAN};
    assert_true(read_slot(values, slot, got) >= components);
    for (int i = 0; i < components; i++)
        if (!(fabs(got[i] - want[i]) <= CLOSE))
            fail_msg("%s: got %g, want %g\n%s", slot, got[i], want[i], values);
}
#endif
