/* --layout=auto: the resulting layouts are small, independent of the materials' order, and every
 * material has a case. */
#include "tests/test.h"
#include "compiler/layout/layout.h"
#include "compiler/pipeline.h"
#include "tests/layout_set.h"
#include "tests/value/read_whole.h"
#include <stdlib.h>

/* It is the same in every case that has it. */
static const FieldRow *field_of(const MaterialSet *set, Slot slot)
{
    const LayoutRow *row = set->layout->row;
    for (int number = 0; number < row->case_count; number++)
        for (int i = 0; i < row->cases[number].field_count; i++)
            if (row->cases[number].fields[i].source[0].slot == slot)
                return &row->cases[number].fields[i];
    return NULL;
}

/* Normal and three times eight bits; nothing else is in the layout, in its GLSL, or in the
 * program. */
static void diffuse_colors_take_eight_bytes(void **state)
{
    (void)state;
    MaterialSet set;
    set_open(&set, lambert, 1, 0);
    assert_int_equal(matc_layout_bytes(set.layout), 8);
    assert_true(set.layout->row->cases[0].field_count == 2 && set.layout->row->fixed_count == 0);
    MatcOptions options = set.documents[0].options;
    options.custom = set.layout;
    MatcProgram *program =
        matc_compile(set.documents[0].document, 0, MATC_FRAGMENT | MATC_UNPACK, &options);
    const char *unpack = matc_output(program, MATC_UNPACK, NULL);
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        char has[64], member[64];
        const bool there = slot == SLOT_normal || slot == SLOT_diffuse;
        snprintf(has, sizeof has, "#define SURFACE_HAS_%s\n", slot_table[slot].name);
        snprintf(member, sizeof member, " %s;", slot_table[slot].name);
        assert_true((strstr(unpack, has) != NULL) == there);
        assert_true((strstr(unpack, member) != NULL) == there);
    }
    assert_null(strstr(unpack, "sharedExponent"));
    assert_null(strstr(unpack, "logarithm"));
    assert_int_equal(matc_target_count(program), 1);
    assert_non_null(strstr(matc_layout_report(set.layout),
                           "specular                  0                  dropped"));
    matc_program_free(program);
    set_close(&set);
}

/* A slot that some materials compute and the draw call sets for the others is stored. */
static void ratios_of_the_draw_are_no_constants(void **state)
{
    (void)state;
    static const char *const ior[] = {"tests/layouts/ior.yaml"};
    MaterialSet set;
    set_open(&set, ior, 1, 0);
    assert_non_null(field_of(&set, SLOT_ior));
    assert_false(layout_fixed(set.layout->row, SLOT_ior));
    set_close(&set);
}

/* Components that are alike are stored once, what never changes not at all, light up to 1 as
 * colors are. */
static void ranges_make_fields(void **state)
{
    (void)state;
    MaterialSet set;
    set_open(&set, grays, 1, 0);
    const FieldRow *diffuse = field_of(&set, SLOT_diffuse),
                   *emissive = field_of(&set, SLOT_emissive);
    assert_true(diffuse && diffuse->gray && diffuse->bits < 8);
    assert_true(field_low(diffuse) >= 0.2 && field_high(diffuse) < 0.41);
    assert_true(emissive && !emissive->gray && emissive->encoding != ENCODING_sharedExponent);
    const FixedRow *specular = layout_fixed(set.layout->row, SLOT_specular);
    assert_true(specular && specular->value[2] == 0.3);
    assert_null(field_of(&set, SLOT_transparency));
    assert_true(field_of(&set, SLOT_shininess)->encoding == ENCODING_unorm); /* it is narrow */
    set_close(&set);
    set_open(&set, glow, 1, 0);
    assert_int_equal(field_of(&set, SLOT_emissive)->encoding, ENCODING_sharedExponent);
    assert_int_equal(field_of(&set, SLOT_interpolatedTransparency)->bits, 1);
    assert_non_null(field_of(&set, SLOT_transparencyShininess));
    assert_non_null(field_of(&set, SLOT_ambient));
    assert_true(layout_has_slot(set.layout->row, SLOT_ior));
    assert_false(layout_has_slot(set.layout->row, SLOT_alpha));
    set_close(&set);
}

/* A range that exceeds 1 keeps its upper end; a color whose red is constant is stored for its
 * green. */
static void ends_and_components_are_kept(void **state)
{
    (void)state;
    static const char *const bright[] = {"tests/layouts/bright.yaml"};
    MaterialSet set;
    set_open(&set, bright, 1, 0);
    const FieldRow *emissive = field_of(&set, SLOT_emissive),
                   *diffuse = field_of(&set, SLOT_diffuse);
    assert_true(emissive && field_high(emissive) >= 3);
    assert_true(diffuse && field_high(diffuse) >= 0.9 && !diffuse->gray);
    set_close(&set);
}

static int all_bits(const MaterialSet *set)
{
    int bits = 0;
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        bits += field_of(set, (Slot)slot) ? auto_field_bits(field_of(set, (Slot)slot)) : 0;
    return bits;
}

/* Bits of the largest case. */
static int placed_bits(const MaterialSet *set)
{
    int most = 0;
    for (int number = 0; number < set->layout->row->case_count; number++) {
        int bits = layout_case_bits(set->layout->row);
        Placement placement;
        assert_null(layout_allocate(set->layout->row, number, &placement));
        for (int i = 0; i < placement.count; i++)
            bits += placement.pieces[i].size;
        most = bits > most ? bits : most;
    }
    return most;
}

/* The stated error buys bits; what the report says of a field is what encodings.def says. */
static void smaller_errors_take_more_bits(void **state)
{
    (void)state;
    static const double errors[] = {0.02, 0.005, 0, 0.0005, 0.0001};
    int before = 0;
    for (size_t i = 0; i < sizeof errors / sizeof *errors; i++) {
        MaterialSet set;
        set_open(&set, glow, 1, errors[i]);
        const int bits = all_bits(&set), placed = placed_bits(&set),
                  bytes = matc_layout_bytes(set.layout);
        print_message("error %g: %d bits, %d of them together, %d bytes\n", errors[i], bits, placed,
                      bytes);
        assert_true(bits > before && bytes * 8 >= placed && bytes * 8 < placed + 64);
        before = bits;
        set_close(&set);
    }
}

/* A normal of three equal components is not one gray number: no encoding of directions takes that.
 */
static void a_direction_is_one_whatever_its_components(void **state)
{
    (void)state;
    static const char *const alike[] = {"examples/conversions/floatToNormal.yaml"};
    MaterialSet set;
    set_open(&set, alike, 1, 0);
    assert_true(matc_layout_ok(set.layout));
    assert_non_null(strstr(matc_layout_text(set.layout), "octahedral"));
    set_close(&set);
}

/* Any order, any split over threads: the same ranges, the same layout. */
static void joining_has_no_order(void **state)
{
    (void)state;
    static const char *const all[] = {"tests/layouts/lambert.yaml", "tests/layouts/grays.yaml",
                                      "tests/layouts/mixed.yaml"};
    MaterialSet set;
    MatcRanges parts[3], back, split;
    set_open(&set, all, 3, 0);
    for (int i = 0; i < 3; i++) {
        matc_ranges_init(&parts[i]);
        for (int k = 0; k < set.documents[i].graph->material_count; k++)
            add_material(&parts[i], set.documents[i].document, k, &set.documents[i].options);
    }
    matc_ranges_init(&back);
    for (int i = 2; i >= 0; i--)
        matc_ranges_join(&back, &parts[i]);
    split = parts[1];
    matc_ranges_join(&parts[2], &parts[0]);
    matc_ranges_join(&split, &parts[2]);
    assert_memory_equal(&back, &set.ranges, sizeof back);
    assert_memory_equal(&split, &set.ranges, sizeof split);
    MatcLayout *layout = matc_layout_for(&split, 0, &set.documents[0].options);
    assert_string_equal(matc_layout_text(layout), matc_layout_text(set.layout));
    assert_string_equal(matc_layout_report(layout), matc_layout_report(set.layout));
    matc_layout_free(layout);
    set_close(&set);
}

/* Materials that have little together take turns with the same bits; alone they need no cases. */
static void mixed_sets_have_cases(void **state)
{
    (void)state;
    MaterialSet set;
    set_open(&set, mixed, 1, 0);
    const LayoutRow *row = set.layout->row;
    const char *report = matc_layout_report(set.layout), *text = matc_layout_text(set.layout);
    assert_int_equal(matc_layout_bytes(set.layout), 16);
    assert_true(row->case_count > 1 && !layout_is_whole(row));
    assert_non_null(strstr(
        report,
        "16 bytes a pixel in 4 cases for 11 materials; one case would take 28, compact has"));
    assert_non_null(strstr(
        report, "\n2                         2                  normal, diffuse, transparency, "
                "transparencyShininess, ambient, ior\n"));
    assert_non_null(strstr(report, "refused"));
    MatcLayout *back = matc_layout_read("back.yaml", text, strlen(text), &set.documents[0].options);
    assert_true(matc_layout_ok(back));
    assert_string_equal(matc_layout_text(back), text);
    matc_layout_free(back);
    size_t size;
    char *example = read_whole(SOURCE_FOLDER "/examples/layouts/mixed.yaml", &size);
    assert_non_null(example);
    assert_non_null(strstr(example, strchr(text, '\n'))); /* but for its name */
    free(example);
    MatcOptions options = set.documents[0].options;
    options.custom = set.layout;
    MatcProgram *program = matc_compile(set.documents[0].document, 0, MATC_UNPACK, &options);
    const char *unpack = matc_output(program, MATC_UNPACK, NULL);
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        char has[64];
        snprintf(has, sizeof has, "#define SURFACE_HAS_%s\n", slot_table[slot].name);
        assert_true((strstr(unpack, has) != NULL) == (slot != SLOT_alpha && slot < SLOT_metalness));
    }
    assert_non_null(strstr(unpack, "uint number = target0.x & 3u;"));
    matc_program_free(program);
    set_close(&set);
}

/* At every level, in every pass, and with numbers that come from a buffer, each material of the set
 * has a case; one that the set is not for is refused, and its slots are reported. */
static void none_is_without_a_case(void **state)
{
    (void)state;
    static const char *const constants[] = {"baked", "uniform"}, *const passes[] = {"gbuffer",
                                                                                    "plane"};
    static const char other[] = "material: Phong\nemissive: 5\ntransparency: 0.5\nambient: 0\n";
    MaterialSet set;
    set_open(&set, mixed, 1, 0);
    for (int i = 0; i < 12; i++) {
        MatcOptions options = set.documents[0].options;
        options.custom = set.layout;
        options.optimize = i / 4;
        options.constants = constants[i % 2];
        options.pass = passes[i / 2 % 2];
        for (int k = 0; k < set.documents[0].graph->material_count; k++) {
            MatcProgram *program =
                matc_compile(set.documents[0].document, k, MATC_FRAGMENT, &options);
            if (!matc_ok(program))
                fail_msg("-O%d, %s, %s: %s", i / 4, constants[i % 2], options.pass,
                         matc_program_diagnostics(program, MATC_TEXT));
            matc_program_free(program);
        }
        MatcDocument *document = matc_read("other.yaml", other, sizeof other - 1, &options);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        assert_false(matc_ok(program));
        assert_null(matc_output(program, MATC_FRAGMENT, NULL));
        assert_non_null(strstr(matc_program_diagnostics(program, MATC_TEXT),
                               "other.yaml:1:11: error: layout auto has no case that stores all "
                               "slots of this material: diffuse, transparency, emissive, ior\n"));
        matc_program_free(program);
        matc_document_free(document);
    }
    set_close(&set);
}

/* The layout holds the exponent of one of the two materials for both: the other has no lobe, so
 * that there is no warning. */
static void constants_are_for_those_to_which_they_matter(void **state)
{
    (void)state;
    static const char *const gloss[] = {"tests/layouts/gloss.yaml"};
    MaterialSet set;
    set_open(&set, gloss, 1, 0);
    assert_non_null(layout_fixed(set.layout->row, SLOT_shininess));
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < set.documents[0].graph->material_count; k++) {
            MatcOptions options = set.documents[0].options;
            options.custom = set.layout;
            options.optimize = i;
            MatcProgram *program =
                matc_compile(set.documents[0].document, k, MATC_FRAGMENT, &options);
            assert_string_equal(matc_program_diagnostics(program, MATC_TEXT), "");
            matc_program_free(program);
        }
    set_close(&set);
}

static void none_is_reported(void **state)
{
    (void)state;
    MatcRanges ranges;
    MatcOptions options;
    char *fault;
    matc_options_init(&options);
    matc_ranges_init(&ranges);
    MatcLayout *layout = matc_layout_for(&ranges, 0, &options);
    assert_false(matc_layout_ok(layout));
    assert_non_null(strstr(matc_layout_diagnostics(layout, MATC_TEXT), "no materials"));
    matc_layout_free(layout);
    static const char text[] = "material: Phong\nambient: { material: SunSkyLight, sun: { param: "
                               "s, default: [0, 1, 1] } }\n";
    MatcDocument *document = matc_read("test.yaml", text, sizeof text - 1, &options);
    assert_false(matc_ranges_add(&ranges, document, 0, &options, &fault));
    assert_non_null(fault);
    assert_int_equal(ranges.materials, 0);
    free(fault);
    matc_document_free(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(diffuse_colors_take_eight_bytes),
        cmocka_unit_test(ratios_of_the_draw_are_no_constants),
        cmocka_unit_test(ranges_make_fields),
        cmocka_unit_test(ends_and_components_are_kept),
        cmocka_unit_test(smaller_errors_take_more_bits),
        cmocka_unit_test(a_direction_is_one_whatever_its_components),
        cmocka_unit_test(joining_has_no_order),
        cmocka_unit_test(mixed_sets_have_cases),
        cmocka_unit_test(none_is_without_a_case),
        cmocka_unit_test(constants_are_for_those_to_which_they_matter),
        cmocka_unit_test(none_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
