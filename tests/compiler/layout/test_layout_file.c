/* Layouts from files: matc's output for a layout reads back as the same layout, and user-defined
 * layouts keep their stated errors. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/layout/layout_read.h"
#include "compiler/layout/custom.h"
#include "tests/draw/kept.h"
#include "tests/value/read_whole.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void fields_are_equal(const FieldRow *a, const FieldRow *b)
{
    assert_true(a->encoding == b->encoding && a->bits == b->bits && a->count == b->count &&
                a->gray == b->gray);
    assert_true(a->low == b->low && a->high == b->high);
    for (int i = 0; i < a->count; i++)
        assert_true(a->source[i].slot == b->source[i].slot &&
                    a->source[i].component == b->source[i].component);
}

static void constants_are_equal(const FixedRow *a, const FixedRow *b, int count)
{
    for (int i = 0; i < count; i++) {
        assert_int_equal(a[i].slot, b[i].slot);
        assert_memory_equal(a[i].value, b[i].value,
                            (size_t)type_table[slot_table[a[i].slot].type].components *
                                sizeof(double));
    }
}

static void rows_are_equal(const LayoutRow *a, const LayoutRow *b)
{
    assert_string_equal(a->name, b->name);
    assert_string_equal(a->doc, b->doc);
    assert_memory_equal(a->formats, b->formats, sizeof a->formats);
    assert_int_equal(a->case_count, b->case_count);
    assert_int_equal(a->further_count, b->further_count);
    for (int number = 0; number < a->case_count; number++) {
        assert_string_equal(a->cases[number].doc, b->cases[number].doc);
        assert_int_equal(a->cases[number].fixed_count, b->cases[number].fixed_count);
        constants_are_equal(a->cases[number].fixed, b->cases[number].fixed,
                            a->cases[number].fixed_count);
        assert_int_equal(a->cases[number].field_count, b->cases[number].field_count);
        for (int i = 0; i < a->cases[number].field_count; i++)
            fields_are_equal(&a->cases[number].fields[i], &b->cases[number].fields[i]);
    }
    assert_int_equal(a->fixed_count, b->fixed_count);
    for (int i = 0; i < a->fixed_count; i++) {
        assert_int_equal(a->fixed[i].slot, b->fixed[i].slot);
        assert_memory_equal(a->fixed[i].value, b->fixed[i].value, sizeof a->fixed[i].value);
    }
}

static MatcLayout *read_text(const char *text)
{
    MatcOptions options;
    matc_options_init(&options);
    MatcLayout *layout = matc_layout_read("test.yaml", text, strlen(text), &options);
    if (!matc_layout_ok(layout))
        fail_msg("%s%s", text, matc_layout_diagnostics(layout, MATC_TEXT));
    return layout;
}

static void reads_back(const LayoutRow *row)
{
    Arena arena = {0};
    Text text = text_new(&arena);
    layout_write(&text, row);
    MatcLayout *layout = read_text(text.at);
    rows_are_equal(row, layout->row);
    assert_string_equal(matc_layout_text(layout), text.at);
    assert_int_equal(matc_layout_bytes(layout), layout_bytes(row));
    matc_layout_free(layout);
    arena_free(&arena);
}

static void what_is_written_reads_back(void **state)
{
    (void)state;
    for (int i = 0; i < LAYOUT_COUNT; i++)
        reads_back(&layout_table[i]);
}

/* Constants, ranges and gray components, which no built-in layout has; numbers that need all of
 * their digits. */
static void all_of_a_file_reads_back(void **state)
{
    (void)state;
    MatcLayout *layout = read_text(
        "layout: all\ndoc: \"A \\\"quoted\\\" one, with a \\\\.\"\ntargets: [RGBA32UI, RGBA16F]\n"
        "fields:\n"
        "  - { slot: normal, encoding: octahedral, bits: 16 }\n"
        "  - { slot: diffuse, encoding: unorm, bits: 9, range: [0.1, 0.30000000000000004] }\n"
        "  - { slot: specular.bgr, encoding: root, bits: 7 }\n"
        "  - { slot: ambient, encoding: root, bits: 5, gray: true }\n"
        "  - { slot: [emissive.b, shininess, emissive.rg], encoding: raw }\n"
        "constants: { transparency: [0.5, 0.25, 1e-7], ior: 1.5 }\n");
    const LayoutRow *row = layout->row;
    assert_int_equal(row->cases[0].fields[2].source[0].component, 2);
    assert_int_equal(row->cases[0].fields[3].count, 1);
    assert_true(row->cases[0].fields[1].high == 0.30000000000000004);
    assert_true(row->fixed[0].value[2] == 1e-7 && row->fixed[1].value[0] == 1.5);
    reads_back(row);
    matc_layout_free(layout);
}

/* With 1023 steps over [0.2, 0.7], the code of 0.2 is 0, that of 0.7 is 1023, that of 0.45 half of
 * that, rounded up. Values beyond the ends have the code of the nearer end. */
static void a_range_is_counted_from_its_lower_end(void **state)
{
    (void)state;
    static const char material[] =
        "{ material: Phong, diffuse: [0.2, 0.45, 0.7], specular: [0.1, 0.7, 0.9] }\n";
    MatcOptions options;
    matc_options_init(&options);
    MatcLayout *layout =
        read_text("layout: range\ntargets: [RG32UI]\nfields:\n"
                  "  - { slot: diffuse, encoding: unorm, bits: 10, range: [0.2, 0.7] }\n"
                  "  - { slot: specular, encoding: unorm, bits: 10, range: [0.2, 0.7] }\n");
    options.custom = layout;
    MatcDocument *document = matc_read("test.yaml", material, sizeof material - 1, &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    char words[64];
    snprintf(words, sizeof words, "uvec4(%uu, %uu, 0u, 0u)", 0u | 512u << 10 | 1023u << 20,
             0u | 1023u << 10 | 1023u << 20);
    assert_true(matc_ok(program));
    if (!strstr(matc_output(program, MATC_FRAGMENT, NULL), words))
        fail_msg("no %s in\n%s", words, matc_output(program, MATC_FRAGMENT, NULL));
    matc_program_free(program);
    matc_document_free(document);
    matc_layout_free(layout);
}

/* JSON is read as documents are, and a layout's faults are none of a document's. */
static void json_is_read_too(void **state)
{
    (void)state;
    static const char text[] =
        "{ \"layout\": \"j\", \"targets\": [\"R32UI\"],\n"
        "  \"fields\": [{ \"slot\": \"diffuse\", \"encoding\": \"unorm\", \"bits\": 10 }] }\n";
    MatcOptions options;
    matc_options_init(&options);
    MatcLayout *layout = matc_layout_read("j.json", text, sizeof text - 1, &options);
    assert_true(matc_layout_ok(layout));
    assert_string_equal(matc_layout_name(layout), "j");
    options.custom = layout;
    MatcDocument *document = matc_read("test.yaml", "material: Phong\n", 16, &options);
    MatcProgram *program =
        matc_compile(document, 0, MATC_FRAGMENT | MATC_UNPACK | MATC_REFLECT, &options);
    assert_true(matc_ok(program));
    assert_int_equal(matc_target_count(program), 1);
    assert_string_equal(matc_target_format(program, 0), "R32UI");
    assert_non_null(strstr(matc_output(program, MATC_REFLECT, NULL), "\"layout\": \"j\""));
    assert_null(strstr(matc_output(program, MATC_UNPACK, NULL), "normal;"));
    matc_program_free(program);
    options.target = "glsl110";
    program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    assert_non_null(strstr(matc_program_diagnostics(program, MATC_TEXT),
                           "layout j needs integer render targets"));
    matc_program_free(program);
    matc_document_free(document);
    matc_layout_free(layout);
    layout = matc_layout_read("k.yaml", "layout: k\n", 10, &options);
    assert_false(matc_layout_ok(layout));
    options.target = NULL;
    options.custom = layout;
    assert_string_equal(matc_options_fault(&options), "layout");
    matc_layout_free(layout);
}

/* A material that has another value where the layout has a constant is warned of. */
static void another_constant_is_reported(void **state)
{
    (void)state;
    static const char same[] = "material: RGBA\n",
                      other[] = "material: Phong\nspecular: 0.5\nshininess: 0.9\n";
    MatcLayout *layout = read_text(
        "layout: k\ntargets: [R32UI]\nfields: [{ slot: diffuse, encoding: root, bits: 8 }]\n"
        "constants: { shininess: 4 }\n");
    MatcOptions options;
    matc_options_init(&options);
    options.custom = layout;
    for (int i = 0; i < 2; i++) {
        MatcDocument *document =
            matc_read("test.yaml", i ? other : same, strlen(i ? other : same), &options);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        assert_true(matc_ok(program));
        const char *reported = matc_program_diagnostics(program, MATC_TEXT);
        assert_true((strstr(reported, "warning: layout k returns a constant shininess") != NULL) ==
                    (i == 1));
        matc_program_free(program);
        matc_document_free(document);
    }
    matc_layout_free(layout);
}

/* The example layouts, with materials that they are for, in every case of theirs;
 * test_layout_claims has mixed. */
static void examples_keep_what_they_promise(void **state)
{
    (void)state;
    static const struct {
        const char *layout, *document;
    } tries[] = {
        {"lambert", "examples/checker.yaml"},        {"lambert", "examples/materials/lambert.yaml"},
        {"foliage", "tests/layouts/bark.yaml"},      {"foliage", "tests/layouts/leaf.yaml"},
        {"halves", "examples/materials/phong.yaml"}, {"halves", "examples/materials/lava.yaml"},
    };
    static Point points[POINT_COUNT];
    Drawer drawer;
    Kept kept = {0};
    points_make(points);
    assert_true(drawer_open(&drawer, true, points, POINT_COUNT));
    for (size_t i = 0; i < sizeof tries / sizeof *tries; i++) {
        char path[256];
        Document d;
        snprintf(path, sizeof path, SOURCE_FOLDER "/examples/layouts/%s.yaml", tries[i].layout);
        size_t size;
        char *text = read_whole(path, &size);
        assert_non_null(text);
        MatcLayout *layout = read_text(text);
        snprintf(path, sizeof path, SOURCE_FOLDER "/%s", tries[i].document);
        assert_true(document_open(&d, path));
        MatcOptions options = d.options;
        options.custom = layout;
        if (!kept_check(&kept, &drawer, &(KeptMaterial){&d, 0, &options}, NULL))
            print_message("%s: %s\n", tries[i].document, kept.error);
        document_close(&d);
        matc_layout_free(layout);
        free(text);
    }
    drawer_close(&drawer);
    print_message("%d materials, %ld values, errors up to %.3f of their bounds\n", kept.materials,
                  kept.values, kept.worst);
    assert_string_equal(kept.error, "");
    assert_true(kept.values > 10000 && kept.worst > 0.5);
}

/* The text that reads back the cases in `cases` of compact, and the case that a material takes.
 * From malloc. */
static char *unpacking(const char *document, unsigned cases, int *taken)
{
    MatcOptions options;
    matc_options_init(&options);
    options.cases = cases;
    MatcDocument *d = matc_read("test.yaml", document, strlen(document), &options);
    MatcProgram *program = matc_compile(d, 0, MATC_UNPACK, &options);
    assert_true(matc_ok(program));
    *taken = matc_case(program);
    char *text = strdup(matc_output(program, MATC_UNPACK, NULL));
    matc_program_free(program);
    matc_document_free(d);
    return text;
}

/* Cases that the materials of a set do not use are not in the text that unpacks them: neither codes
 * nor slots. */
static void unpacking_holds_what_is_taken(void **state)
{
    (void)state;
    static const struct {
        const char *document;
        int number, share; /* its case; of all bytes, at most this percent */
        const char *there, *gone;
    } tries[] = {
        {"material: Phong\ndiffuse: .5\n", 0, 30, "SURFACE_HAS_shininess", "number"},
        {"material: Phong\ndiffuse: .5\ntransparency: .5\n", 1, 30,
         "SURFACE_HAS_diffuseTransparency", "SURFACE_HAS_emissive"},
        {"material: Principled\n", 4, 30, "SURFACE_HAS_roughness", "SURFACE_HAS_shininess"},
        {"material: Principled\nfuzz: 1\n", 9, 35, "SURFACE_HAS_fuzzColor", "SURFACE_HAS_coat"},
    };
    int taken;
    char *all = unpacking(tries[0].document, 0, &taken);
    unsigned cases = 0;
    for (size_t i = 0; i < sizeof tries / sizeof *tries; i++) {
        char *text = unpacking(tries[i].document, 1u << tries[i].number, &taken);
        print_message("case %d: %zu of %zu bytes\n", taken, strlen(text), strlen(all));
        assert_int_equal(taken, tries[i].number);
        assert_true(100 * strlen(text) < tries[i].share * strlen(all));
        assert_non_null(strstr(text, tries[i].there));
        assert_null(strstr(text, tries[i].gone));
        cases |= 1u << taken;
        free(text);
    }
    char *text = unpacking(tries[0].document, cases, &taken);
    assert_non_null(strstr(text, "if (number == 0u) {"));
    assert_non_null(strstr(text, "if (number == 4u) {")); /* the last, 9, needs no question */
    assert_null(strstr(text, "number == 9u"));
    assert_null(strstr(text, "coat"));
    free(text);
    free(all);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_reads_back),
        cmocka_unit_test(all_of_a_file_reads_back),
        cmocka_unit_test(a_range_is_counted_from_its_lower_end),
        cmocka_unit_test(json_is_read_too),
        cmocka_unit_test(another_constant_is_reported),
        cmocka_unit_test(unpacking_holds_what_is_taken),
        cmocka_unit_test(examples_keep_what_they_promise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
