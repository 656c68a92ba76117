/* Every function of matc.h answers every call: of a document with faults, an index beyond what there is, a program or a layout that is not ok, no options. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/compile_text.h"
#include <limits.h>

static const int indexes[] = {-1, 1, 7, INT_MAX, INT_MIN};
enum { INDEXES = sizeof indexes / sizeof *indexes };

/* What a document of so many materials says of one that it has not. */
static void ask_document(MatcDocument *d, int material, const MatcOptions *options)
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
    assert_true(numbers.lanes == 0 && numbers.fault);
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

/* What is no part of a program. */
static void ask_beyond(MatcProgram *p, int index)
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

static void ask_failed(MatcProgram *p)
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
    assert_int_equal(matc_constant_count(p) + matc_constant_bytes(p) + matc_place_count(p) + matc_target_count(p), 0);
    assert_int_equal(matc_case(p), -1);
    assert_null(matc_place(p, 0));
    matc_constant_block(p, block);
    assert_int_equal(block[0], 7);
    for (int i = 0; i < INDEXES; i++)
        ask_beyond(p, indexes[i]);
    ask_beyond(p, 0);
}

static const char *const faulty[] = {
    "", "{", "material: Phnog\n", "defs: { a: red }\n", "material: Phong\ndiffuse: { ref: a }\n", "[1"};

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
        ask_document(d, 1, NULL);
        assert_null(matc_material_name(d, 0));
        MatcProgram *p = matc_compile(d, 0, MATC_FRAGMENT, NULL);
        ask_failed(p);
        matc_program_free(p);
        matc_document_free(d);
    }
}

static void materials_beyond(void **state)
{
    (void)state;
    MatcOptions options = quick();
    for (int none = 0; none < 2; none++) {
        MatcDocument *d = read_text("material: Phong\ndiffuse: { param: a, default: 1 }\n", none ? NULL : &options);
        for (int i = 0; i < INDEXES; i++) {
            ask_document(d, indexes[i], none ? NULL : &options);
            MatcProgram *p = matc_compile(d, indexes[i], MATC_FRAGMENT, &options);
            ask_failed(p);
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
    ask_failed(p);
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
        ask_beyond(p, indexes[i]);
    ask_beyond(p, -1);
    matc_program_free(p);
    matc_document_free(d);
}

static void layouts_of_nothing(void **state)
{
    (void)state;
    MatcRanges ranges;
    matc_ranges_init(&ranges);
    MatcLayout *made[] = {matc_layout_for(&ranges, 0, NULL), matc_layout_read("a.yaml", "", 0, NULL),
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
        cmocka_unit_test(faulty_documents),          cmocka_unit_test(materials_beyond),
        cmocka_unit_test(options_that_mean_nothing), cmocka_unit_test(parts_beyond),
        cmocka_unit_test(layouts_of_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
