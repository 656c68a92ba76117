/* Warnings by name: which are said, which are errors, in documents and programs, by the settings of MatcOptions.warnings. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "compiler/matc.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Two warnings of different names, at two places each. */
static const char *const doubtful =
    "material: Phong\n"
    "diffuse: { map: Blend, blend: [{ value: 1, input: 0 }, { value: 0, input: 1 }] }\n"
    "emissive: { map: Blend, blend: [{ value: 1, input: 0 }, { value: 0, input: 1 }] }\n"
    "specular: #ff0000\n"
    "transparency: #ff0000\n";

typedef struct {
    const char *settings;
    int unordered, unquoted; /* so many are said */
    bool fine;
    bool errors; /* unquoted_color is said as an error */
} Case;

static const Case cases[] = {
    {NULL, 2, 2, true, false},
    {"", 2, 2, true, false},
    {"no-unordered_items", 0, 2, true, false},
    {"no-unordered-items", 0, 2, true, false},
    {"no-unordered_items,no-unquoted_color", 0, 0, true, false},
    {"no-unordered_items,unordered_items", 2, 2, true, false},
    {"error", 2, 2, false, true},
    {"error=unquoted_color", 2, 2, false, true},
    {"error=unordered_items", 2, 2, false, false},
    {"error=layout_fixed", 2, 2, true, false},
    {"error,no-error", 2, 2, true, false},
    {"error,no-error=unordered_items,no-error=unquoted_color", 2, 2, true, false},
    {"error,no-error=unquoted_color", 2, 2, false, false},
    {"error,no-unordered_items,no-unquoted_color", 0, 0, true, false},
    {"no-unquoted_color,error", 2, 0, false, false},
};

static int count(const char *text, const char *word)
{
    int n = 0;
    for (const char *at = text; (at = strstr(at, word)); at += strlen(word))
        n++;
    return n;
}

static void settings_count(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const Case *c = &cases[i];
        MatcOptions options;
        matc_options_init(&options);
        options.warnings = c->settings;
        assert_null(matc_options_fault(&options));
        MatcDocument *document = matc_read("doubtful.yaml", doubtful, strlen(doubtful), &options);
        const char *said = matc_diagnostics(document, MATC_JSON);
        print_message("%s\n", c->settings ? c->settings : "none");
        assert_int_equal(count(said, "\"kind\": \"unordered_items\""), c->unordered);
        assert_int_equal(count(said, "\"kind\": \"unquoted_color\""), c->unquoted);
        assert_int_equal(matc_material_count(document), c->fine);
        assert_int_equal(matc_error_count(document) == 0, c->fine);
        assert_int_equal(count(said, "\"severity\": \"error\", \"kind\": \"unquoted_color\"") > 0, c->errors);
        const char *text = matc_diagnostics(document, MATC_TEXT);
        assert_int_equal(count(text, "[-Werror=unquoted_color]") > 0, c->errors);
        assert_int_equal(count(text, "[-Wunquoted_color]") > 0, c->unquoted && !c->errors);
        matc_document_free(document);
    }
}

/* Errors stay errors whatever is set, and a warning of a name that no warning has is a fault of the options. */
static void only_warnings_have_settings(void **state)
{
    static const char *const faults[] = {"no-unknown_map", "error=",     "no",     "unordered",
                                         "errors",         "no-error=x", "error,x"};
    (void)state;
    MatcOptions options;
    matc_options_init(&options);
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        options.warnings = NULL;
        assert_false(matc_options_set(&options, "warnings", faults[i]));
        assert_null(options.warnings);
        options.warnings = faults[i];
        assert_string_equal(matc_options_fault(&options), "warnings");
    }
    options.warnings = "no-unknown_map";
    MatcDocument *document = matc_read("a.yaml", "material: Phong\ndiffuse: { map: Wodo }\n", 39, &options);
    assert_int_equal(matc_error_count(document), 1);
    matc_document_free(document);
}

/* A warning of compiling, not of reading: the program is not ok. */
static void programs_have_them(void **state)
{
    static const char material[] = "material: Phong\nspecular: 0.3\nshininess: 0.5\n";
    static const char dull[] = "layout: dull\ntargets: [RGBA32UI]\nconstants: { shininess: 0.25 }\nfields:\n"
                               "  - { slot: normal, encoding: octahedral, bits: 12 }\n";
    (void)state;
    static const char *const settings[] = {NULL, "no-layout_fixed", "error=layout_fixed"};
    for (int i = 0; i < 3; i++) {
        MatcOptions options;
        matc_options_init(&options);
        options.validate = false;
        options.warnings = settings[i];
        MatcLayout *layout = matc_layout_read("dull.yaml", dull, sizeof dull - 1, &options);
        if (!matc_layout_ok(layout))
            fputs(matc_layout_diagnostics(layout, MATC_TEXT), stderr);
        options.custom = layout;
        MatcDocument *document = matc_read("a.yaml", material, sizeof material - 1, &options);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        assert_int_equal(matc_ok(program), i < 2);
        assert_int_equal(count(matc_program_diagnostics(program, MATC_JSON), "layout_fixed"), i != 1);
        matc_program_free(program);
        matc_document_free(document);
        matc_layout_free(layout);
    }
}

/* Each has its line on the page. */
static void a_page_lists_them(void **state)
{
    (void)state;
    char *page = matc_explain("warnings");
    assert_non_null(page);
    assert_non_null(strstr(page, "\n  unordered_items"));
    assert_non_null(strstr(page, "\n  layout_fixed"));
    assert_null(strstr(page, "unknown_map"));
    free(page);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(settings_count), cmocka_unit_test(only_warnings_have_settings),
                                       cmocka_unit_test(programs_have_them), cmocka_unit_test(a_page_lists_them)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
