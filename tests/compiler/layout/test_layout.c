/* Layouts, drawn: a value that is packed into a G-buffer and unpacked lies within the stated
 * error of its field, for random and hostile values, in every GLSL version, optimized or not. A
 * new layout needs only its row in the table. */
/* ctest: seconds=18 */
#include "tests/test.h"
#include "compiler/layout/layout.h"
#include "compiler/oracle/oracle.h"
#include "compiler/library/normal.h"
#include "tests/layout_values.h"
#include "tests/draw/gbuffer.h"
#include "tests/value/half.h"

typedef struct {
    Drawer core, compat;
    Point points[POINT_COUNT];
    float read[POINT_COUNT * 4];
    uint64_t seed;
    int last_case;
    int cases; /* bits: which cases of layouts were drawn */
} Fixture;

static int set_up(void **state)
{
    Fixture *f = calloc(1, sizeof *f);
    *state = f;
    points_make(f->points);
    return !drawer_open(&f->core, true, f->points, POINT_COUNT) ||
           !drawer_open(&f->compat, false, f->points, POINT_COUNT);
}

static int tear_down(void **state)
{
    Fixture *f = *state;
    drawer_close(&f->core);
    drawer_close(&f->compat);
    free(f);
    return 0;
}

/* Expected slots of a point: the normal is in eye space. */
static void want_slots(const Point *point, bool front, const SlotValues *values, SlotValues *want)
{
    const float *n = point->input[INPUT_eyeN];
    double length = sqrt((double)n[0] * n[0] + (double)n[1] * n[1] + (double)n[2] * n[2]),
           side = front ? 1 : -1;
    *want = *values;
    for (int i = 0; i < 3; i++)
        want->component[SLOT_normal][i] = length < 1e-37 ? (i == 2) * side : side * n[i] / length;
}

/* Below this an exponent's logarithm, or a half float, has no code near. */
static double least_of(Encoding encoding)
{
    switch (encoding) {
    case ENCODING_logarithm:
        return 1. / 32;
    case ENCODING_raw:
    case ENCODING_plain:
        return ldexp(1, -14);
    default:
        return ldexp(1, -20); /* a subnormal half float, the last step of a shared exponent */
    }
}

static const char *place_text(const Gbuffer *g, Slot slot)
{
    static char text[128];
    snprintf(text, sizeof text, "layout %s, %s, slot %s", g->layout->name,
             target_table[g->shading.target].name, slot_table[slot].name);
    return text;
}

static void check_component(const Gbuffer *g, const Piece *piece, int i, const SlotValues *want,
                            double got)
{
    const FieldRow *field = piece->field;
    const SlotComponent *source = &field->source[piece->first];
    double low = field_low(field), high = field_high(field), greatest = 0;
    double value = fmin(fmax(want->component[source[i].slot][source[i].component], low), high);
    for (int k = 0; k < piece->count; k++)
        greatest =
            fmax(greatest,
                 fabs(fmin(fmax(want->component[source[k].slot][source[k].component], low), high)));
    bool together = field->encoding == ENCODING_sharedExponent;
    bool relative = encoding_table[field->encoding].unit == UNIT_relative;
    double of = relative ? (together ? greatest : fabs(value)) : 1;
    double bound = (field_error(field) + 5e-6) * of + (relative ? least_of(field->encoding) : 0);
    if (!(fabs(got - value) <= bound))
        fail_msg("%s: %.9g comes back as %.9g, the bound is %.3g", place_text(g, source[i].slot),
                 value, got, bound);
}

static void check_normal(const Gbuffer *g, const Piece *piece, const double want[3],
                         const float *got)
{
    double n[3] = {got[0], got[1], got[2]}, length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    double angle = normal_angle(want, n), bound = field_error(piece->field) + 1e-4;
    if (!(angle <= bound && fabs(length - 1) < 1e-6))
        fail_msg("%s: (%g %g %g) comes back as (%g %g %g), %g degrees off; the bound is %g",
                 place_text(g, SLOT_normal), want[0], want[1], want[2], n[0], n[1], n[2], angle,
                 bound);
}

/* Drawn values: those at the first point, and its side. */
typedef struct {
    const SlotValues *values;
    bool front;
} Drawn;

static void check_slot(Fixture *f, Gbuffer *g, Slot slot, const Placement *placement, Drawn drawn)
{
    if (!gbuffer_read(g, slot, f->read))
        fail_msg("%s", g->error);
    for (int i = 0; i < POINT_COUNT; i++) {
        SlotValues want;
        want_slots(&f->points[i], drawn.front, drawn.values, &want);
        for (int k = 0; k < placement->count; k++) {
            const Piece *piece = &placement->pieces[k];
            const SlotComponent *source = &piece->field->source[piece->first];
            if (source[0].slot == SLOT_normal && slot == SLOT_normal)
                check_normal(g, piece, want.component[slot], &f->read[4 * i]);
            for (int component = 0; slot != SLOT_normal && component < piece->count; component++)
                if (source[component].slot == slot)
                    check_component(g, piece, component, &want,
                                    f->read[4 * i + source[component].component]);
        }
    }
}

/* Floats of a target of half floats are zero or normal ones; `raw` alone lets any through. */
static void check_halves(Fixture *f, Gbuffer *g)
{
    for (int i = 0; i < g->layout->cases[0].field_count; i++)
        if (g->layout->cases[0].fields[i].encoding == ENCODING_raw)
            return;
    for (int target = 0; target < g->targets.spec.color_count; target++) {
        if (framebuffer_has_words(&g->targets, target))
            continue;
        assert_true(framebuffer_read(g->drawer->gl, &g->targets, target, f->read));
        for (int i = 0; i < 4 * POINT_COUNT; i++)
            if (!half_is_plain(f->read[i]))
                fail_msg("layout %s stores %.9g", g->layout->name, f->read[i]);
    }
}

/* Returns the layout's case that was drawn. */
static int drawn_case(Gbuffer *g)
{
    static GLuint words[POINT_COUNT][4];
    if (g->layout->case_count == 1)
        return 0;
    assert_true(framebuffer_read_words(g->drawer->gl, &g->targets, 0, &words[0][0]));
    const int targets = layout_targets(g->layout);
    const GLuint first = words[0][0];
    assert_true(framebuffer_read_words(g->drawer->gl, &g->targets, targets - 1, &words[0][0]));
    const int number = layout_case_of(
        g->layout, first, words[0][format_table[g->layout->formats[targets - 1]].components - 1]);
    assert_true(number < g->layout->case_count);
    return number;
}

/* A slot that the case leaves out is as absent ones are. */
static void check_absent(Fixture *f, Gbuffer *g, Slot slot, const SlotValues *values)
{
    if (!gbuffer_read(g, slot, f->read))
        fail_msg("%s", g->error);
    for (int component = 0; component < type_table[slot_table[slot].type].components; component++) {
        assert_true(values->component[slot][component] == slot_table[slot].absent);
        assert_true(f->read[component] == slot_table[slot].absent);
    }
}

static void draw_and_check(Fixture *f, Document *d, Gbuffer *g, bool front)
{
    ReferenceContext context = {0};
    Surface surface;
    SlotValues values;
    Placement placement;
    point_surface(&f->points[0], front, &surface);
    Oracle *oracle = oracle_open(d->graph, &context);
    oracle_material(oracle, d->graph->materials[0].node, &surface, &values);
    oracle_close(oracle);
    if (!gbuffer_draw(g, front))
        fail_msg("%s", g->error);
    int number = drawn_case(g);
    f->cases |= 1 << number;
    f->last_case = number;
    assert_null(layout_allocate(g->layout, number, &placement));
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (layout_case_has_slot(&g->layout->cases[number], (Slot)slot))
            check_slot(f, g, (Slot)slot, &placement, (Drawn){&values, front});
        else if (layout_has_slot(g->layout, (Slot)slot))
            check_absent(f, g, (Slot)slot, &values);
    check_halves(f, g);
}

static Drawer *drawer_for(Fixture *f, Target target)
{
    return target_table[target].in_out ? &f->core : &f->compat;
}

static bool can_draw(const LayoutRow *layout, int target)
{
    return !target_table[target].spirv && (target_table[target].words || !layout_has_words(layout));
}

/* The absent slots decide the case, at every level of -O. */
static void check_case(const Fixture *f, int layout, Kept kept)
{
    static const int cases[] = {[ALL] = 3, [OPAQUE] = 0, [CLEAR] = 1, [GLOW] = 2};
    if (layout == LAYOUT_compact)
        assert_int_equal(f->last_case, cases[kept]);
}

static void check_uniforms(Fixture *f, Document *d, int layout, int target, int level)
{
    Gbuffer g;
    double values[PARAMS][4];
    MatcOptions options = d->options;
    options.layout = layout_table[layout].name;
    options.target = target_table[target].name;
    options.optimize = level;
    options.check = true;
    if (!gbuffer_open(&g, drawer_for(f, (Target)target), d, 0, &options))
        fail_msg("%s", g.error);
    for (int set = 0; set < SETS; set++) {
        make_values(&f->seed, set, values);
        set_values(d, values);
        draw_and_check(f, d, &g, set % 3 != 1);
    }
    gbuffer_close(&g);
}

static void what_is_packed_comes_back(void **state)
{
    Fixture *f = *state;
    double values[PARAMS][4];
    for (int kept = ALL; kept < KEPT_COUNT; kept++) {
        Document d;
        make_values(&f->seed, FIRST_RANDOM, values);
        open_values(&d, values, true, (Kept)kept);
        for (int layout = 0; layout < LAYOUT_COUNT; layout++)
            for (int target = 0; target < TARGET_COUNT; target++)
                for (int level = 0; level <= 2; level += 2)
                    if (can_draw(&layout_table[layout], target) &&
                        (!kept || layout_table[layout].case_count > 1)) {
                        check_uniforms(f, &d, layout, target, level);
                        check_case(f, layout, (Kept)kept);
                    }
        document_close(&d);
    }
    assert_int_equal(f->cases, 15); /* all four of compact */
}

/* Constants are packed by the C references when the shader is written. */
static void constants_come_back(void **state)
{
    Fixture *f = *state;
    for (int set = 0; set < SETS; set++) {
        double values[PARAMS][4];
        Document d;
        make_values(&f->seed, set, values);
        open_values(&d, values, false, (Kept)(set % KEPT_COUNT));
        for (int layout = 0; layout < LAYOUT_COUNT; layout++) {
            Gbuffer g;
            MatcOptions options = d.options;
            options.layout = layout_table[layout].name;
            options.check = true;
            options.validate = set == 0;
            if (!gbuffer_open(&g, &f->core, &d, 0, &options))
                fail_msg("%s", g.error);
            draw_and_check(f, &d, &g, true);
            gbuffer_close(&g);
        }
        document_close(&d);
    }
}

/* Layouts as a document of one's own will make them: every format, every encoding, at several
 * widths. */
#define SLOT3(slot)                                                                                \
    {                                                                                              \
        {SLOT_##slot, 0}, {SLOT_##slot, 1}, { SLOT_##slot, 2 }                                     \
    }
#define TRIPLE(code, bits_, slot)                                                                  \
    {                                                                                              \
        .encoding = ENCODING_##code, .bits = bits_, .count = 3, .source = SLOT3(slot)              \
    }
#define SINGLE(code, bits_, slot)                                                                  \
    {                                                                                              \
        .encoding = ENCODING_##code, .bits = bits_, .count = 1, .source = { {SLOT_##slot, 0} }     \
    }
#define CASE_OF(fields)                                                                            \
    &(CaseRow){fields, sizeof fields / sizeof *fields, "", NULL, 0}, 1, NULL, 0, 0

static void try_row(Fixture *f, Document *d, const LayoutRow *row)
{
    for (int target = 0; target < TARGET_COUNT; target++)
        for (int level = 0; level <= 2; level += 2) {
            Gbuffer g;
            MatcOptions options = d->options;
            options.target = target_table[target].name;
            options.optimize = level;
            if (!can_draw(row, target))
                continue;
            if (!gbuffer_open_layout(&g, drawer_for(f, (Target)target), d, row, &options))
                fail_msg("%s: %s", row->name, g.error);
            draw_and_check(f, d, &g, true);
            gbuffer_close(&g);
        }
}

static void any_rows_are_a_layout(void **state)
{
    static const FieldRow one[] = {TRIPLE(octahedral, 16, normal)};
    static const FieldRow two[] = {TRIPLE(octahedral, 8, normal), TRIPLE(unorm, 5, diffuse),
                                   TRIPLE(unorm, 8, specular)};
    static const FieldRow three[] = {TRIPLE(sphere, 8, normal), TRIPLE(unorm, 16, diffuse),
                                     TRIPLE(root, 12, specular), SINGLE(logarithm, 4, shininess)};
    static const FieldRow four[] = {TRIPLE(sharedExponent, 9, emissive),
                                    TRIPLE(half, 16, ambient),
                                    SINGLE(half, 16, ior),
                                    SINGLE(full, 32, shininess),
                                    TRIPLE(sphere, 12, normal),
                                    TRIPLE(unorm, 2, transparency)};
    static const FieldRow five[] = {TRIPLE(octahedralRadix, 8, normal),
                                    TRIPLE(raw, 16, diffuse),
                                    TRIPLE(plain, 16, specular),
                                    {.encoding = ENCODING_pair,
                                     .bits = 7,
                                     .count = 2,
                                     .source = {{SLOT_ambient, 2}, {SLOT_emissive, 0}}},
                                    TRIPLE(octahedralWhole, 8, normal),
                                    SINGLE(plain, 16, shininess)};
    static const FieldRow six[] = {TRIPLE(octahedral, 7, normal), TRIPLE(octahedral, 12, normal),
                                   SINGLE(logarithm, 16, shininess),
                                   TRIPLE(sharedExponent, 4, emissive), TRIPLE(raw, 16, diffuse)};
    const LayoutRow rows[] = {
        {"one", "", {FORMAT_R32UI}, CASE_OF(one)},
        {"two", "", {FORMAT_RG32UI}, CASE_OF(two)},
        {"three", "", {FORMAT_RGBA16UI, FORMAT_RGBA16UI}, CASE_OF(three)},
        {"four", "", {FORMAT_RGBA32UI, FORMAT_R32UI, FORMAT_RG32UI}, CASE_OF(four)},
        {"five", "", {FORMAT_RGBA16F, FORMAT_RGBA16F, FORMAT_RGBA32F}, CASE_OF(five)},
        {"six", "", {FORMAT_RGBA16F, FORMAT_RGBA32UI}, CASE_OF(six)},
    };
    Fixture *f = *state;
    for (int set = 0; set < 4; set++) {
        double values[PARAMS][4];
        Document d;
        make_values(&f->seed, FIRST_RANDOM * (set % 2) + set, values);
        open_values(&d, values, false, ALL);
        for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
            try_row(f, &d, &rows[i]);
        document_close(&d);
    }
}

/* Rows that do not fit, or have bits that their encoding lacks, are reported. */
static void rows_that_do_not_fit_are_reported(void **state)
{
    (void)state;
    static const FieldRow full[] = {TRIPLE(octahedral, 12, normal), TRIPLE(unorm, 3, diffuse)};
    static const FieldRow wide[] = {TRIPLE(octahedral, 17, normal)};
    static const FieldRow odd[] = {SINGLE(radix, 8, shininess)};
    static const FieldRow floats[] = {TRIPLE(plain, 16, diffuse)};
    Placement placement;
    assert_ptr_equal(
        layout_allocate(&(LayoutRow){"", "", {FORMAT_R32UI}, CASE_OF(full)}, 0, &placement),
        &full[1]);
    assert_ptr_equal(
        layout_allocate(&(LayoutRow){"", "", {FORMAT_R32UI}, CASE_OF(wide)}, 0, &placement), wide);
    assert_ptr_equal(
        layout_allocate(&(LayoutRow){"", "", {FORMAT_RGBA16F}, CASE_OF(odd)}, 0, &placement), odd);
    assert_ptr_equal(
        layout_allocate(&(LayoutRow){"", "", {FORMAT_R32UI}, CASE_OF(floats)}, 0, &placement),
        floats);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_packed_comes_back),
        cmocka_unit_test(constants_come_back),
        cmocka_unit_test(any_rows_are_a_layout),
        cmocka_unit_test(rows_that_do_not_fit_are_reported),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
