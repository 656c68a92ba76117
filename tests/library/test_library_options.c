/* The library's options: names and their values, option structs of older and newer versions. */
#include "tests/test.h"
#include "grammar/tables.h"
#include "tests/compile_text.h"

/* Every option that takes one of a few names, and those names as matc.h has them. */
static const struct {
    const char *option, *values;
} named_options[] = {
    {"target", "glsl110, glsl330, glsl450, essl300, spirv"},
    {"pass", "gbuffer, plane, sky, shadow, depth, value"},
    {"slot", "normal, diffuse, alpha, specular, shininess, transparency, transparencyShininess, "
             "interpolatedTransparency, "
             "diffuseTransparency, ambient, emissive, ior"},
    {"layout", "thesis, radix, thin, integer, compact"},
    {"precision", "fast, balanced, exact"},
    {"noise", "lattice, groimp, simplex"},
    {"aa", "auto, none, box, aniso"},
    {"derivatives", "auto, finite, analytic"},
    {"coordinates", "plain, long"},
    {"powers", "squaring, pow, compensated"},
    {"trigonometry", "native, bounded"},
    {"constants", "auto, baked, uniform"},
    {"normals", "eye, world"},
};
enum { NAMED_OPTIONS = sizeof named_options / sizeof *named_options };

static void every_value_of_an_option_is_taken(void **state)
{
    (void)state;
    for (int i = 0; i < NAMED_OPTIONS; i++) {
        char values[256], *rest;
        snprintf(values, sizeof values, "%s", named_options[i].values);
        for (char *value = strtok_r(values, ", ", &rest); value;
             value = strtok_r(NULL, ", ", &rest)) {
            MatcOptions options = quick();
            assert_true(matc_options_set(&options, named_options[i].option, value));
            assert_null(matc_options_fault(&options));
        }
    }
    for (int axis = 0; axis < AXIS_COUNT; axis++) { /* none is left out above */
        int rows = 0;
        for (int i = 0; i < NAMED_OPTIONS; i++)
            rows += !strcmp(named_options[i].option, axis_table[axis].name);
        assert_int_equal(rows, 1);
    }
}

/* The members that hold names, which the caller may have set to anything. */
static void put_value(MatcOptions *options, const char *option, const char *value)
{
    const struct {
        const char *option;
        const char **member;
    } members[] = {{"target", &options->target},
                   {"pass", &options->pass},
                   {"slot", &options->slot},
                   {"layout", &options->layout},
                   {"precision", &options->precision},
                   {"noise", &options->noise},
                   {"aa", &options->aa},
                   {"derivatives", &options->derivatives},
                   {"coordinates", &options->coordinates},
                   {"powers", &options->powers},
                   {"trigonometry", &options->trigonometry},
                   {"constants", &options->constants},
                   {"normals", &options->normals}};
    for (size_t i = 0; i < sizeof members / sizeof *members; i++)
        if (!strcmp(members[i].option, option))
            *members[i].member = value;
}

/* Unknown values are refused by name, and a program that sets one nevertheless gets the list of
 * values. */
static void unknown_values_are_refused(void **state)
{
    (void)state;
    static const char *const unknown[] = {"nonsense", "", "Auto", "none,box", "fast "};
    for (int i = 0; i < NAMED_OPTIONS * 5; i++) {
        const char *option = named_options[i / 5].option, *value = unknown[i % 5];
        MatcOptions options = quick();
        MatcDocument *document = read_text(checker_text, &options);
        assert_false(matc_options_set(&options, option, value));
        assert_null(matc_options_fault(&options));
        put_value(&options, option, value);
        assert_string_equal(matc_options_fault(&options), option);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        char want[512];
        snprintf(want, sizeof want, "error: %s: unknown value '%s'; expected %s", option, value,
                 named_options[i / 5].values);
        assert_false(matc_ok(program));
        if (!strstr(matc_program_diagnostics(program, MATC_TEXT), want))
            fail_msg("'%s' is wanted, not '%s'", want,
                     matc_program_diagnostics(program, MATC_TEXT));
        matc_program_free(program);
        matc_document_free(document);
    }
    MatcOptions options = quick();
    assert_false(matc_options_set(&options, "nonsense", "auto"));
    assert_false(matc_options_set(&options, "optimize", "2"));
}

/* A program compiled with fewer options: memory after its struct is not accessed, and missing
 * options have their defaults. */
static void older_options_work(void **state)
{
    (void)state;
    enum { KNOWN = offsetof(MatcOptions, optimize) };
    union {
        MatcOptions options;
        unsigned char bytes[sizeof(MatcOptions)];
    } old;
    memset(old.bytes, 0xaa, sizeof old.bytes);
    matc_options_init_sized(&old.options, KNOWN);
    assert_true(matc_options_set(&old.options, "pass", "shadow"));
    for (size_t i = KNOWN; i < sizeof old.bytes; i++)
        assert_int_equal(old.bytes[i], 0xaa);
    assert_null(matc_options_fault(&old.options));
    char *text = compile_text(checker_text, MATC_FRAGMENT, &old.options);
    MatcOptions now;
    matc_options_init(&now);
    now.pass = "shadow";
    char *same = compile_text(checker_text, MATC_FRAGMENT, &now);
    assert_string_equal(text, same);
    free(text);
    free(same);
    old.options.size = offsetof(MatcOptions, pass);
    assert_false(matc_options_set(&old.options, "pass", "sky"));
}

/* And one that was compiled with more. */
static void newer_options_work(void **state)
{
    (void)state;
    struct {
        MatcOptions options;
        long more[4];
    } newer;
    memset(&newer, 0xaa, sizeof newer);
    matc_options_init_sized(&newer.options, sizeof newer);
    assert_int_equal(newer.options.size, sizeof newer);
    assert_int_equal(newer.more[3], 0);
    free(compile_text(checker_text, MATC_FRAGMENT, &newer.options));
    assert_string_equal(matc_version(), MATC_VERSION);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_value_of_an_option_is_taken),
        cmocka_unit_test(unknown_values_are_refused),
        cmocka_unit_test(older_options_work),
        cmocka_unit_test(newer_options_work),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
