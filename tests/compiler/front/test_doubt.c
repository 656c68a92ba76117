/* The MOVES lines of maps.def against the oracle: a transformer changes exactly the coordinates
 * of its line. */
#include "tests/test.h"
#include "compiler/matc.h"
#include "grammar/tables.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name, *parameters; /* which change what they can */
} transformers[] = {{"UVTransform", "scaleU: 3, scaleV: 5, offsetU: 0.3"},
                    {"XYZTransform", "transform: { translation: [3, 2, 1] }"},
                    {"Turbulence", "amount: [3, 3, 3]"},
                    {"CellCentre", "jitter: 0.5"}};
enum { TRANSFORMERS = sizeof transformers / sizeof *transformers, POINTS = 40 };

/* All slots at a point, of a map that reads coordinates by way of `input`. */
static char *values(const char *reader, const char *input, int point)
{
    char text[512], at[64];
    MatcOptions options;
    const char *fault;
    matc_options_init(&options);
    options.warnings = "no-unread_transform";
    snprintf(text, sizeof text, "material: Phong\ndiffuse: { map: %s, input: %s }\n", reader,
             input);
    snprintf(at, sizeof at, "u=%.3f v=%.3f x=%.3f y=0.7 z=-0.4", point * 0.137, point * 0.311,
             point * 0.213);
    MatcDocument *document = matc_read("moves.yaml", text, strlen(text), &options);
    char *result = matc_eval(document, 0, at, &options, &fault);
    if (!result)
        fprintf(stderr, "%s%s", text, matc_diagnostics(document, MATC_TEXT));
    assert_non_null(result);
    matc_document_free(document);
    return result;
}

/* Somewhere, what the reader sees is another with the transformer than without. */
static bool changes(const char *reader, int transformer)
{
    char input[256];
    bool changed = false;
    snprintf(input, sizeof input, "{ map: %s, %s }", transformers[transformer].name,
             transformers[transformer].parameters);
    for (int point = 0; point < POINTS && !changed; point++) {
        char *with = values(reader, input, point), *without = values(reader, "null", point);
        changed = strcmp(with, without) != 0;
        free(with);
        free(without);
    }
    return changed;
}

static void moves_are_what_changes(void **state)
{
    (void)state;
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        int i = 0;
        while (i < TRANSFORMERS && strcmp(transformers[i].name, kind_table[kind].name) != 0)
            i++;
        /* a new one wants a row */
        assert_int_equal(section_of((Kind)kind) == SECTION_transform, i < TRANSFORMERS);
        if (i == TRANSFORMERS) {
            assert_int_equal(kind_table[kind].moves, 0);
            continue;
        }
        assert_int_equal((kind_table[kind].moves & MOVES_xyz) != 0,
                         changes("Gradient, direction: [1, 2, 4]", i));
        assert_int_equal((kind_table[kind].moves & MOVES_uv) != 0, changes("Checker", i));
    }
}

/* Definitions that nobody uses, and what a fault stands beside, are not doubted. */
static void lints_judge_what_is_used(void **state)
{
    static const struct {
        const char *text;
        bool doubted;
    } documents[] = {
        {"defs: { a: { map: Granite, input: { map: UVTransform } } }\nmaterial: Phong\n", false},
        {"defs: { a: { map: Granite, input: { map: UVTransform } } }\nmaterial: Phong\nspecular: { "
         "ref: a }\n",
         true},
        {"material: Phong\nspecular: { map: UVTransform }\ndiffuse: { map: Nothing }\n", false},
        {"material: Phong\nspecular: { map: UVTransform }\n", true},
        {"defs: { a: { map: ImageMap }, b: { map: Blend } }\nmaterial: Phong\n", false},
        {"defs: { a: { map: ImageMap } }\nmaterial: Phong\nspecular: { ref: a }\n", true},
        {"defs: { b: { map: Blend } }\nmaterial: Phong\nspecular: { ref: b }\n", true},
        {"material: Phong\nemissive: 128\n", false},
        {"material: Phong\nemissive: [128, 0, 0]\n", true},
        {"material: Phong\ndiffuse: 128\n", true},
    };
    (void)state;
    for (size_t i = 0; i < sizeof documents / sizeof *documents; i++) {
        MatcOptions options;
        matc_options_init(&options);
        MatcDocument *document =
            matc_read("doubt.yaml", documents[i].text, strlen(documents[i].text), &options);
        assert_int_equal(strstr(matc_diagnostics(document, MATC_TEXT), "warning") != NULL,
                         documents[i].doubted);
        matc_document_free(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(moves_are_what_changes),
                                       cmocka_unit_test(lints_judge_what_is_used)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
