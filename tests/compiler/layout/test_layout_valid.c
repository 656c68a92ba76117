/* Rows of layouts.def, without drawing: bit ranges do not overlap, and glslang accepts every
 * layout in every GLSL version that the layout supports. */
#include "tests/test.h"
#include "compiler/layout/layout.h"
#include "compiler/matc.h"
#include <string.h>

/* Nothing overlaps, and all lies within its target. */
static void check_places(const LayoutRow *layout, int number)
{
    static unsigned char taken[LAYOUT_TARGETS][FIELD_COMPONENTS][32];
    Placement placement;
    memset(taken, 0, sizeof taken);
    const bool further = number >= layout->case_count - layout->further_count;
    const int last = layout_targets(layout) - 1;
    const FormatRow *end = &format_table[layout->formats[last]];
    /* fifteen of four bits, then with as many more as the rest takes */
    const int behind = number - (layout->case_count - layout->further_count);
    int bits = 0;
    while (further && bits < 4 && 1 << bits < layout->further_count)
        bits++;
    for (int more = 0; further && layout->further_count > 16 && behind >= 15 &&
                       1 << more < layout->further_count - 15;
         more++)
        bits++;
    memset(taken[0][0], 1, (size_t)(layout_case_bits(layout) + bits));
    if (further || (layout->further_count && !number))
        taken[last][end->components - 1][end->bits - 1] = 1;
    assert_null(layout_allocate(layout, number, &placement));
    for (int k = 0; k < placement.count; k++) {
        const Piece *piece = &placement.pieces[k];
        const FormatRow *format = &format_table[layout->formats[piece->target]];
        int components = format->words ? 1 : piece->size,
            bits = format->words ? piece->size : format->bits;
        assert_true(piece->component + components <= format->components &&
                    piece->shift + bits <= format->bits);
        for (int component = 0; component < components; component++)
            for (int bit = 0; bit < bits; bit++)
                assert_int_equal(
                    taken[piece->target][piece->component + component][piece->shift + bit]++, 0);
    }
}

/* The last case but further ones is for any material of the model Phong. */
static void pieces_have_places_of_their_own(void **state)
{
    (void)state;
    for (int i = 0; i < LAYOUT_COUNT; i++) {
        const LayoutRow *row = &layout_table[i];
        const int plain = row->case_count - row->further_count;
        for (int slot = 0; slot < SLOT_COUNT; slot++)
            for (int number = 0; number < plain; number++)
                assert_true(!layout_case_has_slot(&row->cases[number], (Slot)slot) ||
                            layout_case_has_slot(&row->cases[plain - 1], (Slot)slot));
        for (int number = 0; number < row->case_count; number++)
            check_places(row, number);
    }
}

static void old_glsl_has_no_whole_numbers(void **state)
{
    (void)state;
    MatcOptions options;
    matc_options_init(&options);
    static const char text[] = "material: Phong\n";
    MatcDocument *document = matc_read("test.yaml", text, sizeof text - 1, &options);
    options.layout = "integer";
    options.target = "glsl110";
    MatcProgram *program =
        matc_compile(document, 0, MATC_FRAGMENT | MATC_UNPACK | MATC_REFLECT, &options);
    assert_false(matc_ok(program));
    assert_non_null(strstr(matc_program_diagnostics(program, MATC_TEXT),
                           "layout integer needs integer render targets, which glsl110"));
    matc_program_free(program);
    options.target = NULL;
    program = matc_compile(document, 0, MATC_FRAGMENT | MATC_REFLECT, &options);
    assert_true(matc_ok(program));
    assert_int_equal(matc_target_count(program), 3);
    assert_string_equal(matc_target_format(program, 2), "RGBA32UI");
    assert_non_null(strstr(matc_output(program, MATC_REFLECT, NULL),
                           "\"location\": 2, \"format\": \"RGBA32UI\""));
    matc_program_free(program);
    matc_document_free(document);
}

/* Every layout in every GLSL that it has, for both passes that write one: glslang takes it, SPIR-V
 * too. */
static void every_layout_is_valid(void **state)
{
    (void)state;
    MatcOptions options;
    matc_options_init(&options);
    static const char text[] =
        "material: Phong\ndiffuse: { map: Granite }\nemissive: { map: Wood }\n"
        "transparency: { param: clear, default: 0.5 }\ninput: { map: BumpMap }\n";
    MatcDocument *document = matc_read("test.yaml", text, sizeof text - 1, &options);
    assert_int_equal(matc_material_count(document), 1);
    for (int i = 0; i < LAYOUT_COUNT * TARGET_COUNT * 4; i++) {
        const LayoutRow *layout = &layout_table[i / 4 % LAYOUT_COUNT];
        int target = i / 4 / LAYOUT_COUNT;
        options.layout = layout->name;
        options.target = target_table[target].name;
        options.optimize = i % 2 * 2;
        options.pass = pass_table[i / 2 % 2 ? PASS_gbuffer : PASS_plane].name;
        options.check = true;
        if (!target_table[target].words && layout_has_words(layout))
            continue;
        MatcProgram *program = matc_compile(
            document, 0,
            MATC_FRAGMENT | MATC_UNPACK | (target_table[target].spirv ? MATC_SPIRV : 0), &options);
        if (!matc_ok(program))
            fail_msg("%s, %s: %s", layout->name, options.target,
                     matc_program_diagnostics(program, MATC_TEXT));
        matc_program_free(program);
    }
    matc_document_free(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_have_places_of_their_own),
        cmocka_unit_test(old_glsl_has_no_whole_numbers),
        cmocka_unit_test(every_layout_is_valid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
