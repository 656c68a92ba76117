/* Every function of matc.h handles every call: a document with errors, an index out of range, a
 * program or layout that is not ok, missing options. */
#include "tests/test.h"
#include "tests/compile_text.h"
#include <limits.h>

static const int indexes[] = {-1, 1, 7, INT_MAX, INT_MIN};
enum { INDEXES = sizeof indexes / sizeof *indexes };

/* Calls every function of a document with a material that it lacks. */
static void query_document(MatcDocument *d, int material, const MatcOptions *options)
{
    const char *fault = NULL;
    MatcPoint point = {.normal = {0, 0, 1}};
    MatcSolid solid = {.at = point};
    MatcRanges ranges;
    char *words = NULL;
    matc_ranges_init(&ranges);
    assert_null(matc_material_name(d, material));
    assert_null(matc_depend(d, material));
    assert_null(matc_eval(d, material, "u=0.5", options, &fault));
    assert_non_null(fault);
    MatcNumbers numbers = matc_eval_slot(d, material, "", options);
    assert_true(numbers.components == 0 && numbers.fault);
    assert_int_equal(matc_moves(d, material, options), MATC_MOVES_none);
    assert_false(matc_move(d, material, options, &point, 1));
    assert_false(matc_has_volume(d, material));
    assert_false(matc_solid(d, material, options, &solid, 1));
    assert_false(matc_ranges_add(&ranges, d, material, options, &words));
    assert_non_null(words);
    free(words);
    assert_int_equal(ranges.materials, 0);
    assert_int_equal(matc_material_find(d, ""), -1);
    assert_false(matc_set_default(d, "none", (const double[]){1}, 1, NULL));
    words = matc_explain_definition(d, "none");
    assert_null(words);
}

/* Calls every function of a program with an index that it lacks. */
static void query_beyond(MatcProgram *p, int index)
{
    assert_null(matc_texture(p, index));
    assert_null(matc_uniform(p, index));
    assert_null(matc_attribute(p, index));
    assert_null(matc_constant(p, index));
    assert_null(matc_target_format(p, index));
    assert_null(matc_output(p, (MatcOutput)0, NULL));
    assert_null(matc_output(p, (MatcOutput)(MATC_FRAGMENT | MATC_VERTEX), NULL));
    assert_null(matc_output(p, (MatcOutput)(1u << 30), NULL));
    assert_null(matc_spirv(p, (MatcOutput)0, NULL));
}

static void query_failed(MatcProgram *p)
{
    size_t size = 7;
    char block[1] = {7};
    assert_false(matc_ok(p));
    assert_false(matc_emit(p, MATC_FRAGMENT | MATC_REFLECT | MATC_SPIRV));
    assert_null(matc_output(p, MATC_FRAGMENT, &size));
    assert_int_equal(size, 0);
    assert_null(matc_spirv(p, MATC_FRAGMENT, &size));
    assert_null(matc_opacity(p));
    assert_null(matc_key(p));
    assert_null(matc_shape(p));
    assert_non_null(matc_pass(p));
    assert_non_null(matc_program_diagnostics(p, MATC_TEXT));
    assert_non_null(matc_program_diagnostics(p, MATC_JSON));
    assert_true(matc_displacement_bound(p) == 0);
    assert_int_equal(matc_texture_count(p) + matc_uniform_count(p) + matc_attribute_count(p), 0);
    assert_int_equal(matc_constant_count(p) + matc_constant_bytes(p) + matc_place_count(p) +
                         matc_target_count(p),
                     0);
    assert_int_equal(matc_case(p), -1);
    assert_null(matc_place(p, 0));
    matc_constant_block(p, block);
    assert_int_equal(block[0], 7);
    for (int i = 0; i < INDEXES; i++)
        query_beyond(p, indexes[i]);
    query_beyond(p, 0);
}

static const char *const faulty[] = {
    "",  "{", "material: Phnog\n", "defs: { a: red }\n", "material: Phong\ndiffuse: { ref: a }\n",
    "[1"};

static void assert_reports(const char *diagnostics, const char *text)
{
    if (!strstr(diagnostics, text))
        fail_msg("'%s' does not say '%s'", diagnostics, text);
}

/* Options of zeros, and of a size that no library had. */
static void unset_options(void **state)
{
    (void)state;
    static const char text[] = "material: Phong\n";
    static const size_t sizes[] = {0, 1, sizeof(size_t), offsetof(MatcOptions, optimize) - 1};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const MatcOptions zeros = {.size = sizes[i], .target = "essl300", .validate = true};
        MatcOptions changed = zeros;
        MatcRanges ranges;
        char *fault = NULL;
        MatcDocument *d = matc_read("a.yaml", text, strlen(text), &zeros);
        assert_int_equal(matc_material_count(d), 0);
        assert_int_equal(matc_error_count(d), 1);
        assert_reports(matc_diagnostics(d, MATC_TEXT), "matc_options_init");
        matc_document_free(d);
        d = matc_read("a.yaml", text, strlen(text), NULL);
        MatcProgram *p = matc_compile(d, 0, MATC_FRAGMENT, &zeros);
        query_failed(p);
        assert_reports(matc_program_diagnostics(p, MATC_TEXT), "matc_options_init");
        matc_program_free(p);
        const char *why = NULL;
        assert_null(matc_eval(d, 0, "u=0.5", &zeros, &why));
        assert_non_null(why);
        assert_non_null(matc_eval_slot(d, 0, "u=0.5", &zeros).fault);
        MatcPoint point = {.normal = {0, 0, 1}};
        assert_false(matc_move(d, 0, &zeros, &point, 1));
        matc_ranges_init(&ranges);
        assert_false(matc_ranges_add(&ranges, d, 0, &zeros, &fault));
        assert_reports(fault, "matc_options_init");
        free(fault);
        matc_document_free(d);
        MatcLayout *layout = matc_layout_read("a.yaml", "layout: a\n", 10, &zeros);
        assert_false(matc_layout_ok(layout));
        assert_reports(matc_layout_diagnostics(layout, MATC_TEXT), "matc_options_init");
        matc_layout_free(layout);
        layout = matc_layout_for(&ranges, 0, &zeros);
        assert_false(matc_layout_ok(layout));
        assert_reports(matc_layout_diagnostics(layout, MATC_TEXT), "matc_options_init");
        matc_layout_free(layout);
        assert_string_equal(matc_options_fault(&zeros), "size");
        assert_false(sizes[i] < offsetof(MatcOptions, pass) &&
                     matc_options_set(&changed, "pass", "sky"));
    }
}

/* An unrequested output is absent, even if it was computed for another. */
static void outputs_are_those_asked_for(void **state)
{
    (void)state;
    static const unsigned bits[] = {MATC_FRAGMENT, MATC_VERTEX,   MATC_UNPACK,   MATC_REFLECT,
                                    MATC_IR,       MATC_DOT,      MATC_LAYOUT,   MATC_TESSVERTEX,
                                    MATC_TESSEVAL, MATC_DISPLACE, MATC_GEOMETRY, MATC_TESSCONTROL,
                                    MATC_SPIRV,    MATC_STATS};
    MatcOptions options;
    matc_options_init(&options);
    options.target = "glsl450";
    MatcDocument *d = read_text(
        "material: Phong\ndisplacement: { map: Granite }\ndisplacementBound: 1\n", &options);
    for (size_t i = 0; i < sizeof bits / sizeof *bits; i++) {
        MatcProgram *p = matc_compile(d, 0, bits[i], &options);
        assert_true(matc_ok(p));
        for (size_t k = 0; k < sizeof bits / sizeof *bits; k++) {
            size_t size = 7;
            const char *output = matc_output(p, (MatcOutput)bits[k], &size);
            assert_true(k == i ? output && size : !output && !size);
        }
        assert_true(matc_emit(p, MATC_VERTEX));
        assert_non_null(matc_output(p, MATC_VERTEX, NULL));
        matc_program_free(p);
    }
    matc_document_free(d);
}

/* Values passed to matc_options_set may be freed, and the options may be copied. */
static void options_hold_their_values(void **state)
{
    (void)state;
    static const char *const values[][2] = {
        {"target", "essl300"}, {"pass", "shadow"},   {"slot", "normal"},
        {"layout", "integer"}, {"noise", "simplex"}, {"precision", "exact"},
        {"aa", "none"},        {"normals", "world"}, {"warnings", "no-no_maps,error"}};
    char name[32], value[64], lengthy[400];
    MatcOptions options, copy;
    matc_options_init(&options);
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        strcpy(name, values[i][0]);
        strcpy(value, values[i][1]);
        assert_true(matc_options_set(&options, name, value));
    }
    memset(name, 'x', sizeof name - 1);
    memset(value, 'x', sizeof value - 1);
    copy = options;
    memset(&options, 'x', sizeof options);
    assert_null(matc_options_fault(&copy));
    assert_string_equal(copy.target, "essl300");
    assert_string_equal(copy.layout, "integer");
    MatcDocument *d = matc_read("a.yaml", "material: Phong\nspecular: { map: Blend }\n", 40, &copy);
    assert_int_equal(matc_error_count(d), 1); /* no_items is an error now */
    matc_document_free(d);
    assert_true(matc_options_set(&copy, "warnings", NULL));
    d = matc_read("a.yaml", "material: Phong\nspecular: { map: Blend }\n", 40, &copy);
    assert_int_equal(matc_error_count(d), 0);
    matc_document_free(d);
    memset(lengthy, 0, sizeof lengthy);
    while (strlen(lengthy) < 300)
        strcat(lengthy, "no-no_maps,");
    lengthy[strlen(lengthy) - 1] = 0;
    assert_false(matc_options_set(&copy, "warnings", lengthy));
}

static void faulty_documents(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof faulty / sizeof *faulty; i++) {
        MatcDocument *d = matc_read("faulty.yaml", faulty[i], strlen(faulty[i]), NULL);
        assert_int_equal(matc_material_count(d), 0);
        assert_non_null(matc_tree_text(d));
        assert_non_null(matc_diagnostics(d, MATC_JSON));
        free(matc_definitions(d));
        free(matc_document_schema(d));
        query_document(d, 1, NULL);
        assert_null(matc_material_name(d, 0));
        MatcProgram *p = matc_compile(d, 0, MATC_FRAGMENT, NULL);
        query_failed(p);
        assert_reports(matc_program_diagnostics(p, MATC_TEXT), "no material 0: the document has 0");
        matc_program_free(p);
        matc_document_free(d);
    }
}

static void materials_beyond(void **state)
{
    (void)state;
    MatcOptions options = quick();
    for (int none = 0; none < 2; none++) {
        MatcDocument *d = read_text("material: Phong\ndiffuse: { param: a, default: 1 }\n",
                                    none ? NULL : &options);
        for (int i = 0; i < INDEXES; i++) {
            query_document(d, indexes[i], none ? NULL : &options);
            MatcProgram *p = matc_compile(d, indexes[i], MATC_FRAGMENT, &options);
            query_failed(p);
            assert_reports(matc_program_diagnostics(p, MATC_TEXT), ": the document has 1");
            matc_program_free(p);
        }
        matc_document_free(d);
    }
}

static void options_that_mean_nothing(void **state)
{
    (void)state;
    MatcOptions options = quick();
    const char *fault;
    assert_null(matc_options_fault(NULL));
    assert_false(matc_options_set(&options, "taget", "glsl330"));
    options.target = "nonsense";
    MatcDocument *d = read_text("material: Phong\n", &options);
    MatcProgram *p = matc_compile(d, 0, MATC_FRAGMENT, &options);
    query_failed(p);
    assert_null(matc_eval(d, 0, "", &options, &fault));
    assert_non_null(fault);
    matc_program_free(p);
    matc_document_free(d);
}

/* One that is ok has what its counts say, and no more. */
static void parts_beyond(void **state)
{
    (void)state;
    MatcOptions options = quick();
    MatcDocument *d = read_text("material: Phong\ndiffuse: [.1, .2, .3]\n", NULL);
    MatcProgram *p = matc_compile(d, 0, MATC_FRAGMENT, &options);
    assert_true(matc_ok(p));
    assert_non_null(matc_opacity(p));
    assert_non_null(matc_target_format(p, 0));
    assert_null(matc_place(p, matc_place_count(p)));
    assert_null(matc_place(p, -1));
    assert_null(matc_target_format(p, matc_target_count(p)));
    assert_null(matc_output(p, MATC_DOT, NULL));
    for (int i = 2; i < INDEXES; i++)
        query_beyond(p, indexes[i]);
    query_beyond(p, -1);
    matc_program_free(p);
    matc_document_free(d);
}

static void layouts_of_nothing(void **state)
{
    (void)state;
    MatcRanges ranges;
    matc_ranges_init(&ranges);
    MatcLayout *made[] = {matc_layout_for(&ranges, 0, NULL),
                          matc_layout_read("a.yaml", "", 0, NULL),
                          matc_layout_read("a.json", "[", 1, NULL)};
    for (int i = 0; i < 3; i++) {
        assert_false(matc_layout_ok(made[i]));
        assert_null(matc_layout_name(made[i]));
        assert_int_equal(matc_layout_bytes(made[i]), 0);
        assert_null(matc_layout_text(made[i]));
        assert_null(matc_layout_report(made[i]));
        assert_true(*matc_layout_diagnostics(made[i], MATC_TEXT));
        matc_layout_free(made[i]);
    }
    matc_layout_free(NULL);
    matc_program_free(NULL);
    matc_document_free(NULL);
    matc_linked_free(NULL);
    assert_null(matc_list_of("nothing"));
    assert_null(matc_schema("nothing"));
    assert_null(matc_explain("nothing"));
    assert_null(matc_explain(""));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unset_options),
        cmocka_unit_test(outputs_are_those_asked_for),
        cmocka_unit_test(options_hold_their_values),
        cmocka_unit_test(faulty_documents),
        cmocka_unit_test(materials_beyond),
        cmocka_unit_test(options_that_mean_nothing),
        cmocka_unit_test(parts_beyond),
        cmocka_unit_test(layouts_of_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
