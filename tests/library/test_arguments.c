/* Calls every function of matc.h with every kind of wrong argument: NULL, an index out of range, a
 * handle of a document or program with errors, uninitialized options, a value that is no
 * enumerator. The call has to fail, with a diagnostic if it returns an object that has diagnostics.
 * A function of the header without a row fails the test (api_rows.h). */
#include "tests/test.h"
#include "tests/api_rows.h"
#include "tests/compile_text.h"
#include <limits.h>
#include <math.h>

static const int outside[] = {-1, 1, 1000, INT_MAX, INT_MIN};
enum { OUTSIDE = sizeof outside / sizeof *outside };
static const char plain[] = "material: Phong\ndiffuse: { param: a, default: 1 }\n";

/* Arguments that the rows share: valid objects, and objects with errors. */
static struct {
    MatcOptions options, unset;
    MatcDocument *fine, *faulty;
    MatcProgram *program, *failed;
    MatcLayout *no_layout;
} of;

static int open_all(void **state)
{
    (void)state;
    of.options = quick();
    of.unset = (MatcOptions){.validate = true};
    of.fine = read_text(plain, &of.options);
    of.faulty = read_text("material: Phnog\n", &of.options);
    of.program = matc_compile(of.fine, 0, MATC_FRAGMENT, &of.options);
    of.failed = matc_compile(of.faulty, 0, MATC_FRAGMENT, &of.options);
    of.no_layout = matc_layout_read("a.yaml", "", 0, &of.options);
    return !matc_ok(of.program);
}

static int close_all(void **state)
{
    (void)state;
    matc_layout_free(of.no_layout);
    matc_program_free(of.program);
    matc_program_free(of.failed);
    matc_document_free(of.fine);
    matc_document_free(of.faulty);
    return 0;
}

static void assert_says(const char *text, const char *what)
{
    if (!text || !strstr(text, what))
        fail_msg("'%s' does not say '%s'", text ? text : "(NULL)", what);
}

/* -- the library as a whole */

static void wrong_version(void) { assert_string_equal(matc_version(), MATC_VERSION); }

static void wrong_linked_new(void) { matc_linked_free(matc_linked_new()); }
static void wrong_linked_free(void) { matc_linked_free(NULL); }

static void wrong_options_init(void)
{
    MatcOptions options;
    memset(&options, 'x', sizeof options);
    matc_options_init_sized(NULL, sizeof options);
    matc_options_init_sized(&options, 0);
    assert_int_equal(((unsigned char *)&options)[0], 'x');
    matc_options_init_sized(&options, sizeof(size_t)); /* a caller that knows no member */
    assert_int_equal(options.size, sizeof(size_t));
    assert_string_equal(matc_options_fault(&options), "size");
}

static void wrong_options_set(void)
{
    MatcOptions options = of.options;
    assert_false(matc_options_set(NULL, "target", "glsl330"));
    assert_false(matc_options_set(&options, NULL, "glsl330"));
    assert_false(matc_options_set(&options, "", ""));
    assert_false(matc_options_set(&options, "optimize", "2"));
    assert_false(matc_options_set(&options, "target", "glsl33"));
    assert_false(matc_options_set(&options, "warnings", "no-such"));
    assert_false(matc_options_set(&(MatcOptions){0}, "target", "glsl330"));
    assert_memory_equal(&options, &of.options, sizeof options);
}

static void wrong_options_fault(void)
{
    MatcOptions options = of.options;
    options.target = "";
    assert_null(matc_options_fault(NULL));
    assert_string_equal(matc_options_fault(&options), "target");
    assert_string_equal(matc_options_fault(&of.unset), "size");
    options = of.options;
    options.custom = of.no_layout;
    assert_string_equal(matc_options_fault(&options), "layout");
}

static void wrong_schema(void)
{
    char *whole = matc_schema(NULL); /* the schema of documents */
    assert_non_null(whole);
    free(whole);
    assert_null(matc_schema(""));
    assert_null(matc_schema("documents"));
}

static void wrong_list(void) { free(matc_list()); }

static void wrong_list_of(void)
{
    assert_null(matc_list_of(NULL));
    assert_null(matc_list_of(""));
    assert_null(matc_list_of("map"));
}

static void wrong_explain(void)
{
    assert_null(matc_explain(NULL));
    assert_null(matc_explain(""));
    assert_null(matc_explain("no such name"));
}

/* -- documents */

static void assert_read_fails(MatcDocument *d, const char *what)
{
    assert_non_null(d);
    assert_int_equal(matc_material_count(d), 0);
    assert_true(matc_error_count(d) > 0);
    assert_says(matc_diagnostics(d, MATC_TEXT), what);
    matc_document_free(d);
}

static void wrong_read(void)
{
    MatcOptions options = of.options;
    const char *const folders[] = {NULL};
    assert_read_fails(matc_read("a.yaml", NULL, 0, NULL), "'text' is NULL");
    assert_read_fails(matc_read("a.yaml", NULL, 100, NULL), "'text' is NULL");
    assert_read_fails(matc_read(NULL, NULL, SIZE_MAX, &of.unset), "'text' is NULL");
    assert_read_fails(matc_read("a.yaml", plain, strlen(plain), &of.unset), "matc_options_init");
    assert_read_fails(matc_read("a.yaml", "", 0, NULL), "error");
    assert_read_fails(matc_read("a.yaml", "a\0b", 3, NULL), "error");
    options.include_count = INT_MIN;
    options.include = folders;
    options.member_count = -1;
    /* text from memory needs no name */
    MatcDocument *d = matc_read(NULL, plain, strlen(plain), &options);
    assert_int_equal(matc_error_count(d), 0);
    assert_int_equal(matc_material_count(d), 1);
    matc_document_free(d);
    options.include = NULL;
    options.include_count = 5;
    d = matc_read("a.yaml", "include: bricks.yaml\nmaterial: Phong\n", 37, &options);
    assert_true(matc_error_count(d) == 0);
    matc_document_free(d);
}

static void wrong_document_free(void) { matc_document_free(NULL); }

static void wrong_material_count(void)
{
    assert_int_equal(matc_material_count(NULL), 0);
    assert_int_equal(matc_material_count(of.faulty), 0);
}

static void wrong_material_name(void)
{
    assert_null(matc_material_name(NULL, 0));
    assert_null(matc_material_name(of.faulty, 0));
    for (int i = 0; i < OUTSIDE; i++)
        assert_null(matc_material_name(of.fine, outside[i]));
}

static void wrong_material_find(void)
{
    assert_int_equal(matc_material_find(NULL, "a"), -1);
    assert_int_equal(matc_material_find(of.fine, NULL), -1);
    assert_int_equal(matc_material_find(of.fine, ""), -1);
    assert_int_equal(matc_material_find(of.faulty, "test"), -1);
}

static void wrong_depend_count(void) { assert_int_equal(matc_depend_count(NULL), 0); }

static void wrong_depend(void)
{
    assert_null(matc_depend(NULL, 0));
    for (int i = 0; i < OUTSIDE; i++)
        assert_null(matc_depend(of.fine, outside[i]));
}

static void wrong_tree_text(void)
{
    MatcDocument *d = matc_read("a.yaml", NULL, 0, NULL);
    assert_string_equal(matc_tree_text(NULL), "");
    assert_string_equal(matc_tree_text(d), "");
    matc_document_free(d);
}

static void wrong_definitions(void)
{
    assert_null(matc_definitions(NULL));
    assert_null(matc_definitions(of.faulty));
    assert_null(matc_definitions(of.fine));
}

static void wrong_explain_definition(void)
{
    assert_null(matc_explain_definition(NULL, "a"));
    assert_null(matc_explain_definition(of.fine, NULL));
    assert_null(matc_explain_definition(of.fine, "a"));
    assert_null(matc_explain_definition(of.faulty, "a"));
}

static void wrong_document_schema(void)
{
    assert_null(matc_document_schema(NULL));
    assert_null(matc_document_schema(of.faulty));
}

static void wrong_diagnostics(void)
{
    assert_string_equal(matc_diagnostics(NULL, MATC_TEXT), "");
    /* an invalid form gives complete JSON */
    const char *json = matc_diagnostics(of.faulty, (MatcForm)7);
    assert_true(json[0] == '[' && strchr(json, ']'));
}

static void wrong_error_count(void) { assert_int_equal(matc_error_count(NULL), 0); }

static void wrong_set_default(void)
{
    const double components[4] = {1, 2, 3, 4};
    double before[4] = {9, 9, 9, 9};
    assert_false(matc_set_default(NULL, "a", components, 1, before));
    assert_false(matc_set_default(of.faulty, "a", components, 1, before));
    assert_false(matc_set_default(of.fine, NULL, components, 1, before));
    assert_false(matc_set_default(of.fine, "b", components, 1, before));
    assert_false(matc_set_default(of.fine, "a", NULL, 1, before));
    assert_false(matc_set_default(of.fine, "a", components, 0, before));
    assert_false(matc_set_default(of.fine, "a", components, 4, before));
    assert_false(matc_set_default(of.fine, "a", components, -1, before));
    assert_true(before[0] == 9);
}

/* -- values */

static void assert_no_value(const MatcDocument *d, int material, const char *point,
                            const MatcOptions *options)
{
    const char *fault = NULL;
    assert_null(matc_eval(d, material, point, options, &fault));
    assert_non_null(fault);
    assert_null(matc_eval(d, material, point, options, NULL));
    const MatcNumbers numbers = matc_eval_slot(d, material, point, options);
    assert_true(numbers.components == 0 && numbers.fault);
}

static void wrong_eval(void)
{
    MatcOptions options = of.options;
    options.slot = "none";
    assert_no_value(NULL, 0, "", NULL);
    assert_no_value(of.faulty, 0, "", NULL);
    assert_no_value(of.fine, 0, "", &of.unset);
    assert_no_value(of.fine, 0, "", &options);
    assert_no_value(of.fine, 0, "u=", NULL);
    assert_no_value(of.fine, 0, "nothing=1", NULL);
    for (int i = 0; i < OUTSIDE; i++)
        assert_no_value(of.fine, outside[i], "", NULL);
    char *values = matc_eval(of.fine, 0, NULL, NULL, NULL); /* default inputs */
    assert_non_null(values);
    free(values);
}

static void wrong_moves(void)
{
    assert_int_equal(matc_moves(NULL, 0, NULL), MATC_MOVES_none);
    assert_int_equal(matc_moves(of.faulty, 0, NULL), MATC_MOVES_none);
    assert_int_equal(matc_moves(of.fine, 0, &of.unset), MATC_MOVES_none);
    for (int i = 0; i < OUTSIDE; i++)
        assert_int_equal(matc_moves(of.fine, outside[i], NULL), MATC_MOVES_none);
}

static void wrong_move(void)
{
    MatcPoint point = {.normal = {0, 0, 1}};
    assert_false(matc_move(NULL, 0, NULL, &point, 1));
    assert_false(matc_move(of.faulty, 0, NULL, &point, 1));
    assert_false(matc_move(of.fine, 0, &of.unset, &point, 1));
    assert_false(matc_move(of.fine, 0, NULL, NULL, 1));
    assert_false(matc_move(of.fine, 0, NULL, &point, -1));
    assert_true(matc_move(of.fine, 0, NULL, NULL, 0));
    for (int i = 0; i < OUTSIDE; i++)
        assert_false(matc_move(of.fine, outside[i], NULL, &point, 1));
}

static void wrong_has_volume(void)
{
    assert_false(matc_has_volume(NULL, 0));
    assert_false(matc_has_volume(of.faulty, 0));
    for (int i = 0; i < OUTSIDE; i++)
        assert_false(matc_has_volume(of.fine, outside[i]));
}

static void wrong_solid(void)
{
    static const char text[] = "material: Phong\ndisplacementVolume: { map: Granite }\n";
    MatcDocument *volume = read_text(text, &of.options);
    MatcSolid point = {.at = {.normal = {0, 0, 1}}};
    assert_false(matc_solid(NULL, 0, NULL, &point, 1));
    assert_false(matc_solid(of.fine, 0, NULL, &point, 1)); /* no volume */
    assert_true(matc_has_volume(volume, 0));
    assert_false(matc_solid(volume, 0, &of.unset, &point, 1));
    assert_false(matc_solid(volume, 0, NULL, NULL, 1));
    assert_false(matc_solid(volume, 0, NULL, &point, INT_MIN));
    assert_false(matc_solid(volume, 1, NULL, &point, 1));
    matc_document_free(volume);
}

/* -- programs */

static void assert_not_compiled(MatcProgram *p, const char *what)
{
    assert_non_null(p);
    assert_false(matc_ok(p));
    assert_says(matc_program_diagnostics(p, MATC_TEXT), what);
    matc_program_free(p);
}

static void wrong_compile(void)
{
    MatcOptions options = of.options;
    assert_not_compiled(matc_compile(NULL, 0, MATC_FRAGMENT, NULL), "'document' is NULL");
    assert_not_compiled(matc_compile(NULL, -1, UINT_MAX, &of.unset), "matc_options_init");
    assert_not_compiled(matc_compile(of.faulty, 0, MATC_FRAGMENT, NULL), "no material 0");
    assert_not_compiled(matc_compile(of.fine, 0, 1u << 17, &of.options),
                        "not values of MatcOutput");
    assert_not_compiled(matc_compile(of.fine, 0, UINT_MAX, &of.options),
                        "not values of MatcOutput");
    options.pass = "passes";
    assert_not_compiled(matc_compile(of.fine, 0, MATC_FRAGMENT, &options), "pass");
    options = of.options;
    options.custom = of.no_layout;
    assert_not_compiled(matc_compile(of.fine, 0, MATC_FRAGMENT, &options), "layout");
    options = of.options;
    options.members = (const int[]){0, 0, 0};
    options.member_count = 3000;
    assert_not_compiled(matc_compile(of.fine, 0, MATC_FRAGMENT, &options), "3000 members");
    for (int i = 0; i < OUTSIDE; i++)
        assert_not_compiled(matc_compile(of.fine, outside[i], MATC_FRAGMENT, NULL), "no material");
}

static void wrong_emit(void)
{
    MatcProgram *p = matc_compile(of.fine, 0, MATC_KEY, &of.options);
    assert_false(matc_emit(NULL, MATC_FRAGMENT));
    assert_false(matc_emit(of.failed, MATC_FRAGMENT));
    assert_false(matc_emit(p, 1u << 31));
    assert_says(matc_program_diagnostics(p, MATC_TEXT), "not values of MatcOutput");
    matc_program_free(p);
}

static void wrong_ok(void) { assert_false(matc_ok(NULL) || matc_ok(of.failed)); }

static void wrong_output(void)
{
    static const unsigned outputs[] = {0, MATC_DOT, MATC_FRAGMENT | MATC_VERTEX, 1u << 17,
                                       1u << 31};
    MatcProgram *const programs[] = {NULL, of.failed, of.program};
    for (size_t p = 0; p < 3; p++)
        for (size_t i = 0; i < sizeof outputs / sizeof *outputs; i++) {
            size_t size = 7;
            assert_null(matc_output(programs[p], (MatcOutput)outputs[i], &size));
            assert_int_equal(size, 0);
            assert_null(matc_output(programs[p], (MatcOutput)outputs[i], NULL));
        }
}

static void wrong_spirv(void)
{
    size_t size = 7;
    assert_null(matc_spirv(NULL, MATC_FRAGMENT, &size));
    assert_int_equal(size, 0);
    assert_null(matc_spirv(of.failed, MATC_FRAGMENT, NULL));
    assert_null(matc_spirv(of.program, MATC_FRAGMENT, NULL)); /* SPIR-V was not requested */
    assert_null(matc_spirv(of.program, (MatcOutput)-1, NULL));
}

static void wrong_program_free(void) { matc_program_free(NULL); }
static void wrong_pass(void) { assert_null(matc_pass(NULL)); }
static void wrong_opacity(void) { assert_true(!matc_opacity(NULL) && !matc_opacity(of.failed)); }

static void wrong_displacement_bound(void)
{
    assert_true(matc_displacement_bound(NULL) == 0 && matc_displacement_bound(of.failed) == 0);
}

static void wrong_key(void) { assert_true(!matc_key(NULL) && !matc_key(of.failed)); }
static void wrong_shape(void) { assert_true(!matc_shape(NULL) && !matc_shape(of.failed)); }

/* One row for each function that lists parts of a program. */
#define PARTS(part)                                                                                \
    static void wrong_##part##_count(void)                                                         \
    {                                                                                              \
        assert_int_equal(matc_##part##_count(NULL), 0);                                            \
        assert_int_equal(matc_##part##_count(of.failed), 0);                                       \
    }                                                                                              \
    static void wrong_##part(void)                                                                 \
    {                                                                                              \
        assert_null(matc_##part(NULL, 0));                                                         \
        assert_null(matc_##part(of.failed, 0));                                                    \
        for (int i = 0; i < OUTSIDE; i++)                                                          \
            if (outside[i] < 0 || outside[i] >= matc_##part##_count(of.program))                   \
                assert_null(matc_##part(of.program, outside[i]));                                  \
    }
PARTS(place)
PARTS(constant)
PARTS(texture)
PARTS(uniform)
PARTS(attribute)

static void wrong_constant_bytes(void)
{
    assert_int_equal(matc_constant_bytes(NULL) + matc_constant_bytes(of.failed), 0);
}

static void wrong_constant_block(void)
{
    char block[4] = {7, 7, 7, 7};
    matc_constant_block(NULL, block);
    matc_constant_block(of.failed, block);
    matc_constant_block(of.program, NULL);
    assert_int_equal(block[0], 7);
}

static void wrong_target_count(void)
{
    assert_int_equal(matc_target_count(NULL) + matc_target_count(of.failed), 0);
}
static void wrong_case(void) { assert_true(matc_case(NULL) == -1 && matc_case(of.failed) == -1); }

static void wrong_target_format(void)
{
    assert_null(matc_target_format(NULL, 0));
    assert_null(matc_target_format(of.failed, 0));
    assert_null(matc_target_format(of.program, -1));
    assert_null(matc_target_format(of.program, matc_target_count(of.program)));
}

static void wrong_program_diagnostics(void)
{
    assert_string_equal(matc_program_diagnostics(NULL, MATC_JSON), "");
    assert_int_equal(*matc_program_diagnostics(of.failed, (MatcForm)-1), '[');
}

/* -- layouts */

static void assert_no_layout(MatcLayout *layout, const char *what)
{
    assert_non_null(layout);
    assert_false(matc_layout_ok(layout));
    assert_says(matc_layout_diagnostics(layout, MATC_TEXT), what);
    matc_layout_free(layout);
}

static void wrong_layout_read(void)
{
    assert_no_layout(matc_layout_read("a.yaml", NULL, 0, NULL), "'text' is NULL");
    assert_no_layout(matc_layout_read(NULL, NULL, SIZE_MAX, NULL), "'text' is NULL");
    assert_no_layout(matc_layout_read(NULL, "layout: a\n", 10, NULL), "error");
    assert_no_layout(matc_layout_read("a.yaml", "layout: a\n", 10, &of.unset), "matc_options_init");
}

static void wrong_layout_for(void)
{
    static const double errors[] = {NAN, -1, INFINITY, -INFINITY, 2, 1e300};
    MatcRanges ranges;
    matc_ranges_init(&ranges);
    assert_no_layout(matc_layout_for(NULL, 0, NULL), "error");
    assert_no_layout(matc_layout_for(&ranges, 0, NULL), "error");
    assert_no_layout(matc_layout_for(&ranges, 0, &of.unset), "matc_options_init");
    assert_true(matc_ranges_add(&ranges, of.fine, 0, &of.options, NULL));
    for (size_t i = 0; i < sizeof errors / sizeof *errors; i++)
        assert_no_layout(matc_layout_for(&ranges, errors[i], NULL), "error");
}

static void wrong_layout_ok(void)
{
    assert_false(matc_layout_ok(NULL) || matc_layout_ok(of.no_layout));
}

static void wrong_layout_diagnostics(void)
{
    assert_string_equal(matc_layout_diagnostics(NULL, MATC_TEXT), "");
    assert_int_equal(*matc_layout_diagnostics(of.no_layout, (MatcForm)2), '[');
}

static void wrong_layout_name(void)
{
    assert_true(!matc_layout_name(NULL) && !matc_layout_name(of.no_layout));
}
static void wrong_layout_bytes(void)
{
    assert_int_equal(matc_layout_bytes(NULL) + matc_layout_bytes(of.no_layout), 0);
}
static void wrong_layout_text(void)
{
    assert_true(!matc_layout_text(NULL) && !matc_layout_text(of.no_layout));
}
static void wrong_layout_report(void)
{
    assert_true(!matc_layout_report(NULL) && !matc_layout_report(of.no_layout));
}
static void wrong_layout_free(void) { matc_layout_free(NULL); }

static void wrong_ranges_init(void) { matc_ranges_init(NULL); }

static void wrong_ranges_add(void)
{
    MatcRanges ranges;
    char *fault = NULL;
    matc_ranges_init(&ranges);
    const struct {
        MatcRanges *ranges;
        MatcDocument *document;
        int material;
        const MatcOptions *options;
    } wrong[] = {{NULL, of.fine, 0, NULL},          {&ranges, NULL, 0, NULL},
                 {&ranges, of.faulty, 0, NULL},     {&ranges, of.fine, 1, NULL},
                 {&ranges, of.fine, INT_MIN, NULL}, {&ranges, of.fine, 0, &of.unset}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_false(matc_ranges_add(wrong[i].ranges, wrong[i].document, wrong[i].material,
                                     wrong[i].options, &fault));
        assert_non_null(fault);
        assert_true(*fault);
        free(fault);
        assert_false(matc_ranges_add(wrong[i].ranges, wrong[i].document, wrong[i].material,
                                     wrong[i].options, NULL));
    }
    assert_int_equal(ranges.materials, 0);
}

static void wrong_ranges_join(void)
{
    MatcRanges ranges, before;
    matc_ranges_init(&ranges);
    before = ranges;
    matc_ranges_join(NULL, &ranges);
    matc_ranges_join(&ranges, NULL);
    assert_memory_equal(&ranges, &before, sizeof ranges);
}

#define ROW(name)                                                                                  \
    {                                                                                              \
        "matc_" #name, wrong_##name                                                                \
    }
static const ApiRow rows[] = {
    {"matc_options_init_sized", wrong_options_init},
    {"matc_eval_slot", wrong_eval},
    ROW(version),
    ROW(linked_new),
    ROW(linked_free),
    ROW(options_set),
    ROW(options_fault),
    ROW(read),
    ROW(document_free),
    ROW(material_count),
    ROW(material_name),
    ROW(material_find),
    ROW(depend_count),
    ROW(depend),
    ROW(tree_text),
    ROW(definitions),
    ROW(explain_definition),
    ROW(document_schema),
    ROW(compile),
    ROW(emit),
    ROW(ok),
    ROW(output),
    ROW(spirv),
    ROW(program_free),
    ROW(pass),
    ROW(opacity),
    ROW(displacement_bound),
    ROW(moves),
    ROW(move),
    ROW(has_volume),
    ROW(solid),
    ROW(set_default),
    ROW(key),
    ROW(shape),
    ROW(place_count),
    ROW(place),
    ROW(constant_count),
    ROW(constant),
    ROW(constant_bytes),
    ROW(constant_block),
    ROW(texture_count),
    ROW(texture),
    ROW(target_count),
    ROW(case),
    ROW(target_format),
    ROW(uniform_count),
    ROW(uniform),
    ROW(attribute_count),
    ROW(attribute),
    ROW(eval),
    ROW(diagnostics),
    ROW(program_diagnostics),
    ROW(error_count),
    ROW(layout_read),
    ROW(layout_ok),
    ROW(layout_diagnostics),
    ROW(layout_name),
    ROW(layout_bytes),
    ROW(layout_text),
    ROW(layout_report),
    ROW(layout_free),
    ROW(ranges_init),
    ROW(ranges_add),
    ROW(ranges_join),
    ROW(layout_for),
    ROW(schema),
    ROW(list),
    ROW(list_of),
    ROW(explain),
};

static void wrong_arguments_of_every_function(void **state)
{
    (void)state;
    api_rows_run("compiler/matc.h", rows, sizeof rows / sizeof *rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(wrong_arguments_of_every_function, open_all, close_all)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
