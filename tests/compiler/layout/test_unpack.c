/* The GLSL that unpacks a whole layout, drawn with the words of each of its cases: every slot
 * that a case leaves out has the case's own value, or the layout's default for absent slots, and
 * never another case's value. */
#include "tests/test.h"
#include "compiler/layout/layout.h"
#include "compiler/matc.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/pass_values.h"
#include "tests/stress/choices.h"
#include <stdio.h>
#include <string.h>

enum { SIDE = 32, CAPACITY = 1 << 14 }; /* a column a slot, a row a case */

/* first[] and last[]: a word of each case. */
static size_t put_words(char *text, const LayoutRow *row, const char *name, int target,
                        int component)
{
    size_t size =
        (size_t)snprintf(text, CAPACITY, "const uint %s[%d] = uint[](", name, row->case_count);
    for (int i = 0; i < row->case_count; i++)
        size += (size_t)snprintf(text + size, CAPACITY - size, "%s%.0fu", i ? ", " : "",
                                 layout_case_code(row, i, target, component));
    return size + (size_t)snprintf(text + size, CAPACITY - size, ");\n");
}

static void put_body(char text[CAPACITY], const LayoutRow *row)
{
    static const char *const fill[] = {"", ", vec3(0.0)", ", vec2(0.0)", ", 0.0", ""};
    const int last = layout_targets(row) - 1;
    size_t size = put_words(text, row, "first", 0, 0);
    size += put_words(text + size, row, "last", last, 3);
    size += (size_t)snprintf(
        text + size, CAPACITY - size,
        "vec4 passPixel(ivec2 p) {\n    int i = min(p.y, %d);\n    Surface s = unpackTexels(",
        row->case_count - 1);
    for (int target = 0; target <= last; target++)
        size += (size_t)snprintf(text + size, CAPACITY - size, "%suvec4(%s, 0u, 0u, %s)",
                                 target ? ", " : "", target ? "0u" : "first[i]",
                                 target == last ? "last[i]" : "0u");
    size += (size_t)snprintf(text + size, CAPACITY - size, ");\n");
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (layout_has_slot(row, (Slot)slot))
            size += (size_t)snprintf(
                text + size, CAPACITY - size, "    if (p.x == %d) return vec4(s.%s%s);\n", slot,
                slot_table[slot].name, fill[type_table[slot_table[slot].type].components]);
    size += (size_t)snprintf(text + size, CAPACITY - size, "    return vec4(0.0);\n}\n");
    assert_true(size < CAPACITY);
}

static void check_case(const LayoutRow *row, int number, float (*reported)[4])
{
    const CaseRow *fields = &row->cases[number];
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        if (!layout_has_slot(row, (Slot)slot) || layout_case_has_slot(fields, (Slot)slot))
            continue;
        const FixedRow *own = layout_case_fixed(fields, (Slot)slot);
        for (int component = 0; component < type_table[slot_table[slot].type].components;
             component++) {
            const double want = own ? own->value[component] : slot_table[slot].absent,
                         is = reported[number * SIDE + slot][component];
            if (is != (float)want)
                fail_msg("%s, case %d: %s is %g, not %g", row->name, number, slot_table[slot].name,
                         is, want);
        }
    }
}

static void cases_have_what_they_leave_out(void **state)
{
    (void)state;
    static const char document[] = "material: Phong\n";
    static const Layout layouts[] = {LAYOUT_compact, LAYOUT_integer};
    static float reported[SIDE * SIDE][4];
    static char body[CAPACITY];
    GlContext *gl = frame_context();
    for (int i = 0; i < 2; i++) {
        const LayoutRow *row = &layout_table[layouts[i]];
        assert_true(row->case_count > 4 && row->case_count <= SIDE && (int)SLOT_COUNT <= (int)SIDE);
        MatcOptions options;
        matc_options_init(&options);
        options.layout = row->name;
        MatcDocument *read = matc_read("test.yaml", document, strlen(document), &options);
        MatcProgram *program = matc_compile(read, 0, MATC_UNPACK, &options);
        assert_true(matc_ok(program));
        put_body(body, row);
        const ScreenPassText text = {.body = {matc_output(program, MATC_UNPACK, NULL), body},
                                     .format = "RGBA32F"};
        pass_values(gl, &text, SIDE, reported);
        for (int number = 0; number < row->case_count; number++)
            check_case(row, number, reported);
        matc_program_free(program);
        matc_document_free(read);
    }
    gl_close(gl);
}

/* -- cases together against each by itself */

enum { TRIES = 6, CODE_BITS = 14 /* of the first word, that may tell cases apart */, ABSENT = -7 };

/* words_<target>_<component>[]: of each case any bits, but for those of its number. */
static size_t put_random_words(char *text, const LayoutRow *row, Choices *choices)
{
    const int last = layout_targets(row) - 1;
    size_t size = 0;
    for (int i = 0; i < 4 * (last + 1); i++) {
        size +=
            (size_t)snprintf(text + size, CAPACITY - size, "const uint words_%d_%d[%d] = uint[](",
                             i / 4, i % 4, row->case_count);
        for (int number = 0; number < row->case_count; number++) {
            uint32_t word = (uint32_t)(choose_part(choices) * 65536) << 16 |
                            (uint32_t)(choose_part(choices) * 65536);
            word = i == 0 ? word >> CODE_BITS << CODE_BITS : word;
            word = i == 4 * last + 3 ? word & 0x7FFFFFFFu : word;
            word |= (uint32_t)layout_case_code(row, number, i / 4, i % 4);
            size +=
                (size_t)snprintf(text + size, CAPACITY - size, "%s%uu", number ? ", " : "", word);
        }
        size += (size_t)snprintf(text + size, CAPACITY - size, ");\n");
    }
    return size;
}

static void put_random_body(char text[CAPACITY], const LayoutRow *row)
{
    static const char *const fill[] = {"", ", vec3(0.0)", ", vec2(0.0)", ", 0.0", ""};
    Choices choices;
    choices_random(&choices, 7, (uint64_t)row->case_count); /* the same words whatever is read */
    size_t size = put_random_words(text, row, &choices);
    size += (size_t)snprintf(
        text + size, CAPACITY - size,
        "vec4 passPixel(ivec2 p) {\n    int i = min(p.y, %d);\n    Surface s = unpackTexels(",
        row->case_count - 1);
    for (int target = 0; target < layout_targets(row); target++)
        size +=
            (size_t)snprintf(text + size, CAPACITY - size,
                             "%suvec4(words_%d_0[i], words_%d_1[i], words_%d_2[i], words_%d_3[i])",
                             target ? ", " : "", target, target, target, target);
    size += (size_t)snprintf(text + size, CAPACITY - size, ");\n");
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        size += (size_t)snprintf(
            text + size, CAPACITY - size,
            "#ifdef SURFACE_HAS_%s\n    if (p.x == %d) return vec4(s.%s%s);\n#endif\n",
            slot_table[slot].name, slot, slot_table[slot].name,
            fill[type_table[slot_table[slot].type].components]);
    size += (size_t)snprintf(text + size, CAPACITY - size, "    return vec4(%d.0);\n}\n", ABSENT);
    assert_true(size < CAPACITY);
}

/* Slots, by column, of random words of each case, by row, as the text for these cases has them. */
static void read_cases(GlContext *gl, const LayoutRow *row, unsigned cases, float (*reported)[4])
{
    static const char document[] = "material: Phong\n";
    static char body[CAPACITY];
    MatcOptions options;
    matc_options_init(&options);
    options.layout = row->name;
    options.cases = cases;
    MatcDocument *read = matc_read("test.yaml", document, strlen(document), &options);
    MatcProgram *program = matc_compile(read, 0, MATC_UNPACK, &options);
    assert_true(matc_ok(program));
    put_random_body(body, row);
    const ScreenPassText text = {.body = {matc_output(program, MATC_UNPACK, NULL), body},
                                 .format = "RGBA32F"};
    pass_values(gl, &text, SIDE, reported);
    matc_program_free(program);
    matc_document_free(read);
}

/* A slot that the case alone lacks is there because of others, and is as absent ones are. */
static bool agrees(int slot, const float together[4], const float alone[4])
{
    for (int component = 0; component < type_table[slot_table[slot].type].components; component++) {
        const float want =
            alone[0] == (float)ABSENT ? (float)slot_table[slot].absent : alone[component];
        if (!(together[component] == want))
            return false;
    }
    return true;
}

static void check_together(const LayoutRow *row, unsigned cases, float (*together)[4],
                           float (*alone)[4])
{
    for (int number = 0; number < row->case_count; number++)
        for (int slot = 0; slot < SLOT_COUNT; slot++) {
            const int at = number * SIDE + slot;
            if ((!cases || cases >> number & 1) && together[at][0] != (float)ABSENT &&
                !agrees(slot, together[at], alone[at]))
                fail_msg("%s, cases %x: %s of case %d is %g, alone %g", row->name, cases,
                         slot_table[slot].name, number, (double)together[at][0],
                         (double)alone[at][0]);
        }
}

/* Fields that cases share stand before the branches; the text of one case has none. */
static void cases_together_are_as_alone(void **state)
{
    (void)state;
    static const Layout layouts[] = {LAYOUT_compact, LAYOUT_integer};
    static float alone[SIDE * SIDE][4], together[SIDE * SIDE][4];
    Choices choices;
    GlContext *gl = frame_context();
    choices_random(&choices, 5, 0);
    for (int i = 0; i < 2; i++) {
        const LayoutRow *row = &layout_table[layouts[i]];
        for (int number = 0; number < row->case_count; number++) {
            read_cases(gl, row, 1u << number, together);
            memcpy(alone[number * SIDE], together[number * SIDE], SIDE * sizeof *alone);
        }
        for (int n = 0; n <= TRIES; n++) {
            unsigned cases = 0;
            for (int number = 0; number < row->case_count && n; number++)
                cases |= (unsigned)(choose_part(&choices) < 0.4) << number;
            read_cases(gl, row, cases, together);
            check_together(row, cases, together, alone);
        }
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cases_have_what_they_leave_out),
        cmocka_unit_test(cases_together_are_as_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
