/* MatcOptions.warnings: which warnings of documents and programs are reported, and which become
 * errors. */
#include "tests/test.h"
#include "compiler/base/warnings.h"
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
    int unordered, unquoted; /* how many are reported */
    bool fine;
    bool errors; /* unquoted_color is reported as an error */
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
        const char *reported = matc_diagnostics(document, MATC_JSON);
        print_message("%s\n", c->settings ? c->settings : "none");
        assert_int_equal(count(reported, "\"kind\": \"unordered_items\""), c->unordered);
        assert_int_equal(count(reported, "\"kind\": \"unquoted_color\""), c->unquoted);
        assert_int_equal(matc_material_count(document), c->fine);
        assert_int_equal(matc_error_count(document) == 0, c->fine);
        assert_int_equal(count(reported, "\"severity\": \"error\", \"kind\": \"unquoted_color\"") >
                             0,
                         c->errors);
        const char *text = matc_diagnostics(document, MATC_TEXT);
        assert_int_equal(count(text, "[-Werror=unquoted_color]") > 0, c->errors);
        assert_int_equal(count(text, "[-Wunquoted_color]") > 0, c->unquoted && !c->errors);
        matc_document_free(document);
    }
}

/* Advice about hex colors: number and place of its notes, and documents without it. */
static const struct {
    const char *settings, *text;
    int notes, line; /* line of the first note */
} advised[] = {
    {"linear_colors", "material: Phong\ndiffuse: \"#808080\"\n", 1, 2},
    {"linear-colors", "material: Phong\ndiffuse: \"#808080\"\n", 1, 2},
    {"linear_colors", "material: Phong\ndiffuse: \"#123\"\nspecular: \"#808080\"\n", 1, 2},
    {"linear_colors", "material: Phong\ndiffuse: { param: tint, default: \"#80808080\" }\n", 1, 2},
    {"linear_colors", "material: Phong\nspecular: .5\ndiffuse: \"= mix(#fff, #808080, u)\"\n", 1,
     3},
    {"linear_colors", "material: Phong\ndiffuse: \"= attribute(\\\"tint\\\", vec3, #808080)\"\n", 1,
     2},
    {"linear_colors", "defs:\n  grey: \"#808080\"\nmaterial: Phong\ndiffuse: { ref: grey }\n", 1,
     2},
    {"error,linear_colors", "material: Phong\ndiffuse: \"#808080\"\n", 1, 2},
    {"linear_colors,error", "material: Phong\ndiffuse: \"#808080\"\n", 1, 2},
    {"linear_colors,error=linear_colors", "material: Phong\ndiffuse: \"#808080\"\n", 1, 2},
    /* both readings differ in one component alone */
    {"linear_colors", "material: Phong\ndiffuse: \"#ffff80\"\n", 1, 2},
    {"linear_colors", "material: Phong\ndiffuse: \"#ff8000\"\n", 1, 2},
    {"linear_colors", "material: Phong\ndiffuse: \"#80ff00\"\n", 1, 2},
    /* near misses: advice is off, the file has `colors:`, or both readings are the same light */
    {NULL, "material: Phong\ndiffuse: \"#808080\"\n", 0, 0},
    {"", "material: Phong\ndiffuse: \"#808080\"\n", 0, 0},
    {"error", "material: Phong\ndiffuse: \"#808080\"\n", 0, 0},
    {"error=linear_colors", "material: Phong\ndiffuse: \"#808080\"\n", 0, 0},
    {"no-unquoted_color", "material: Phong\ndiffuse: \"#808080\"\n", 0, 0},
    {"linear_colors,no-linear_colors", "material: Phong\ndiffuse: \"#808080\"\n", 0, 0},
    {"linear_colors", "material: Phong\ndiffuse: \"#808080\"\ncolors: linear\n", 0, 0},
    {"linear_colors", "colors: srgb\nmaterial: Phong\ndiffuse: \"#808080\"\n", 0, 0},
    {"linear_colors", "colors: srgb\nmaterial: Phong\ndiffuse: \"= mix(#808080, #fff, u)\"\n", 0,
     0},
    {"linear_colors", "material: Phong\ndiffuse: \"#ff00ff\"\nspecular: \"#000\"\n", 0, 0},
    {"linear_colors", "material: Phong\ndiffuse: \"#ff00ff80\"\n", 0, 0},
    {"linear_colors", "material: Phong\ndiffuse: linear(#808080)\nspecular: \"srgb(#808080)\"\n", 0,
     0},
    {"linear_colors", "material: Phong\ndiffuse: gray\nspecular: [0.2, 0.3, 0.4]\nshininess: 0.5\n",
     0, 0},
};

static void advice_is_a_note(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof advised / sizeof *advised; i++) {
        char line[64];
        MatcOptions options;
        matc_options_init(&options);
        options.warnings = advised[i].settings;
        MatcDocument *document =
            matc_read("a.yaml", advised[i].text, strlen(advised[i].text), &options);
        const char *json = matc_diagnostics(document, MATC_JSON);
        print_message("%s: %s%s", advised[i].settings ? advised[i].settings : "none",
                      advised[i].text, json);
        assert_int_equal(matc_material_count(document), 1);
        assert_int_equal(matc_error_count(document), 0);
        assert_int_equal(count(json, "\"kind\": \"linear_colors\""), advised[i].notes);
        assert_int_equal(count(json, "\"severity\": \"note\", \"kind\": \"linear_colors\""),
                         advised[i].notes);
        snprintf(line, sizeof line, "\"line\": %d,", advised[i].line);
        assert_int_equal(count(json, line), advised[i].notes);
        matc_document_free(document);
    }
}

/* Advice prints both readings of a byte of 128 (IEC 61966-2-1): 128 / 255, and ((128 / 255 + .055)
 * / 1.055)^2.4. It is sorted by its own line, not as a note about another warning. */
static void advice_says_both_readings(void **state)
{
    static const char text[] =
        "material: Phong\ndiffuse: \"#808080\"\ntransparency: #ff0000\nspecular: #ff0000\n";
    (void)state;
    MatcOptions options;
    matc_options_init(&options);
    options.warnings = "linear_colors";
    MatcDocument *document = matc_read("a.yaml", text, sizeof text - 1, &options);
    const char *reported = matc_diagnostics(document, MATC_TEXT);
    const char *advice = strstr(reported, "a.yaml:2:10: note: "),
               *third = strstr(reported, "a.yaml:3:"), *fourth = strstr(reported, "a.yaml:4:");
    assert_non_null(advice);
    assert_non_null(strstr(advice, "'#808080' is [0.502, 0.502, 0.502]; if colors come from a "
                                   "color picker, write `colors: srgb`"));
    assert_non_null(
        strstr(advice, "[0.216, 0.216, 0.216], otherwise `colors: linear` [-Wlinear_colors]"));
    assert_true(advice < third && third < fourth);
    matc_document_free(document);
}

/* Advice about a definition's line is found at its use, here after a warning about a later line; it
 * is printed first. */
static void advice_goes_before_later_warnings(void **state)
{
    static const char text[] = "defs:\n  grey: \"#808080\"\nmaterial: Phong\n"
                               "diffuse: #ff0000\nspecular: { ref: grey }\n";
    (void)state;
    MatcOptions options;
    matc_options_init(&options);
    options.warnings = "linear_colors";
    MatcDocument *document = matc_read("a.yaml", text, sizeof text - 1, &options);
    const char *reported = matc_diagnostics(document, MATC_TEXT);
    const char *advice = strstr(reported, "a.yaml:2:9: note: "),
               *warning = strstr(reported, "a.yaml:4:");
    assert_true(advice && warning);
    assert_true(advice < warning);
    matc_document_free(document);
}

/* `colors:` counts for one file: the palette has none, the document that includes it has one. */
static char *palette_file(void *user, const char *path, size_t *size, const char **why)
{
    static const char palette[] = "defs: { grey: \"#808080\" }\n";
    (void)user, (void)path, (void)why;
    char *text = malloc(sizeof palette);
    assert_non_null(text);
    memcpy(text, palette, *size = sizeof palette - 1);
    text[*size] = 0;
    return text;
}

static void advice_is_by_file(void **state)
{
    static const char text[] = "include: palette.yaml\ncolors: srgb\nmaterial: Phong\ndiffuse: { "
                               "ref: grey }\nspecular: \"#404040\"\n";
    (void)state;
    MatcOptions options;
    matc_options_init(&options);
    options.warnings = "linear_colors";
    options.read_file = palette_file;
    MatcDocument *document = matc_read("a.yaml", text, sizeof text - 1, &options);
    const char *reported = matc_diagnostics(document, MATC_TEXT);
    assert_int_equal(count(reported, "note: "), 1);
    assert_non_null(strstr(reported, "palette.yaml:1:15: note: hex colors"));
    matc_document_free(document);
}

/* Two files without `colors:` get a note each, in either order of reading. */
static void each_file_is_advised(void **state)
{
    static const char *const texts[] = {
        "include: palette.yaml\nmaterial: Phong\ndiffuse: { ref: grey }\nspecular: \"#404040\"\n",
        "include: palette.yaml\nmaterial: Phong\nspecular: { ref: grey }\ndiffuse: \"#404040\"\n",
    };
    (void)state;
    MatcOptions options;
    matc_options_init(&options);
    options.warnings = "linear_colors";
    options.read_file = palette_file;
    for (int i = 0; i < 2; i++) {
        MatcDocument *document = matc_read("a.yaml", texts[i], strlen(texts[i]), &options);
        const char *reported = matc_diagnostics(document, MATC_TEXT);
        assert_int_equal(count(reported, "note: hex colors"), 2);
        assert_non_null(strstr(reported, "palette.yaml:1:15: note: "));
        assert_non_null(strstr(reported, "a.yaml:4:"));
        matc_document_free(document);
    }
}

/* Settings do not change errors, and an unknown name is a fault of the options. */
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
    MatcDocument *document =
        matc_read("a.yaml", "material: Phong\ndiffuse: { map: Wodo }\n", 39, &options);
    assert_int_equal(matc_error_count(document), 1);
    matc_document_free(document);
}

/* A warning that compiling reports: as an error it makes the program fail. */
static void programs_have_them(void **state)
{
    static const char material[] = "material: Phong\nspecular: 0.3\nshininess: 0.5\n";
    static const char dull[] =
        "layout: dull\ntargets: [RGBA32UI]\nconstants: { shininess: 0.25 }\nfields:\n"
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
        assert_int_equal(count(matc_program_diagnostics(program, MATC_JSON), "layout_fixed"),
                         i != 1);
        matc_program_free(program);
        matc_document_free(document);
        matc_layout_free(layout);
    }
}

/* `matc --explain warnings` has a line for each warning. */
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

/* A build that names a warning as version 0.1 did sets the warning of today. */
static void the_old_name_is_an_alias(void **state)
{
    (void)state;
    size_t size;
    assert_null(warnings_fault("no-parted,error=dropped", &size));
    assert_int_equal(warnings_severity("no-parted", DIAG_dropped), SEVERITY_none);
    assert_int_equal(warnings_severity("error=parted", DIAG_dropped), SEVERITY_error);
    assert_int_equal(warnings_severity("no-parted", DIAG_unstored), SEVERITY_warning);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(settings_count),
                                       cmocka_unit_test(only_warnings_have_settings),
                                       cmocka_unit_test(programs_have_them),
                                       cmocka_unit_test(advice_is_a_note),
                                       cmocka_unit_test(advice_says_both_readings),
                                       cmocka_unit_test(advice_is_by_file),
                                       cmocka_unit_test(advice_goes_before_later_warnings),
                                       cmocka_unit_test(each_file_is_advised),
                                       cmocka_unit_test(the_old_name_is_an_alias),
                                       cmocka_unit_test(a_page_lists_them)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
