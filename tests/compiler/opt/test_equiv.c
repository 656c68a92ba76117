/* Lowering and optimizer, tested without GLSL: the IR as written and the optimized IR of every
 * example, evaluated in double precision, equal the values of the oracle, which shares no code
 * with either. An IR's text reads back as the same text. */
/* ctest: seconds=14 */
#include "tests/test.h"
#include "tests/sanitized.h"
#include "tests/value/bounds.h"
#include "tests/value/documents.h"
#include "tests/value/evaluate.h"
#include "tests/value/points.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STEP = 4 * SANITIZED_STEP, SAMPLES = POINT_COUNT / STEP };
static const double bound = 1e-9;
/* Slopes of what a displacement computes are differences in the oracle, over 2^-26 of the surface's
 * size: rounding leaves 2^-26 of the steepest of the parts that they are made of. */
static const double slope_bound = 1e-7;

/* Every STEPth of the points, but for those whose numbers lead out of the range in which doubles
 * are as exact as wanted. */
static int sample_points(Point samples[SAMPLES])
{
    static Point points[POINT_COUNT];
    int count = 0;
    points_make(points);
    for (int i = 0; i < POINT_COUNT; i += STEP)
        if (!point_is_extreme(&points[i]))
            samples[count++] = points[i];
    return count;
}

typedef struct {
    Document document;
    Oracle *oracle;
    const Point *points;
    Hull *hulls[2];     /* by side */
    Choice derivatives; /* of finite ones the oracle's are exact */
    int count, faults;
    bool bent; /* what is displaced is curved */
    double worst;
} Test;

static void fault(Test *t, int material, Slot slot, const char *format, ...)
{
    va_list args;
    t->faults++;
    print_error("%s %s %s: ", document_name(&t->document),
                t->document.graph->materials[material].name, slot_table[slot].name);
    va_start(args, format);
    vprint_error(format, args);
    va_end(args);
    print_error("\n");
}

static bool has_slopes(const Test *t, int material, Choice derivatives)
{
    Subjects subjects;
    subjects_of(t->document.graph->materials[material].node, SLOT_normal, &subjects);
    return subjects_slopes(&subjects, derivatives);
}

/* A Triplanar weighs its maps by slopes of what its input answers. */
static bool has_slopes_within(const Test *t, int material)
{
    Subjects subjects;
    subjects_of(t->document.graph->materials[material].node, SLOT_diffuse, &subjects);
    return subjects.has[KIND_Triplanar];
}

/* Greater distances make a step h of the oracle's differences large compared with maps'
 * features: for a wave of 200 radians per unit, (200 h)^2 / 6 is 1e-8. */
static const float far = 100;

/* One slot at one level: every point and both sides. */
static void check_values(Test *t, int material, Slot slot, int level, const Ir *ir)
{
    const bool differs = slot == SLOT_normal && has_slopes(t, material, t->derivatives);
    const double most = differs ? slope_bound : bound;
    Arena arena = {0};
    ReferenceTexture textures[EVALUATE_TEXTURES];
    assert_true(evaluate_textures(&arena, ir, textures));
    ReferenceContext context = {ir->noise, textures};
    for (int i = 0; i < 2 * t->count; i++) {
        bool front = i < t->count;
        int point = i % t->count;
        if (differs && point_is_far(&t->points[point], far))
            continue;
        double inputs[INPUT_COUNT][4], result[MAX_OUTPUTS][4];
        evaluate_inputs(&t->points[point], front, inputs);
        if (t->bent)
            evaluate_bends(&t->points[point], inputs);
        ir_eval(ir, &context, (const double(*)[4])inputs, result);
        for (int component = 0; component < type_table[slot_table[slot].type].components;
             component++) {
            const Hull *hull = &t->hulls[front][point];
            double miss = hull_miss(hull, slot, component, result[0][component]);
            t->worst = fmax(t->worst, miss < bound ? miss : 0);
            if (miss <= most)
                continue;
            const float *x = t->points[point].input[INPUT_X], *u = t->points[point].input[INPUT_U];
            fault(
                t, material, slot,
                "-O%d lane %d: %.17g, oracle %.17g at u=%.9g v=%.9g x=%.9g y=%.9g z=%.9g front=%d",
                level, component, result[0][component], hull->value.component[slot][component],
                u[0], u[1], x[0], x[1], x[2], front);
            arena_free(&arena);
            return;
        }
    }
    arena_free(&arena);
}

static void check_text(Test *t, int material, Slot slot, Session *session, const Ir *ir)
{
    const char *why = ir_check(ir), *wrong = "";
    Text first = text_new(session->arena), second = text_new(session->arena);
    if (why)
        fault(t, material, slot, "ir_check: %s", why);
    ir_print(&first, ir);
    const Ir *back = ir_read(session, first.at, t->document.graph, &wrong);
    if (!back) {
        fault(t, material, slot, "ir_read: %s", wrong);
        return;
    }
    ir_print(&second, back);
    if (strcmp(first.at, second.at) != 0)
        fault(t, material, slot, "the text changes when it is read and printed again");
}

static void check_slot(Test *t, int material, Slot slot)
{
    for (int level = 0; level <= 2; level += 2) {
        Arena arena = {0};
        Session session = {
            .options = &t->document.options, .arena = &arena, .optimize = level, .check = true};
        Job job;
        choice_job(&(MatcOptions){.pass = "value"}, &job);
        job.slot = slot;
        job.choice[AXIS_derivatives] = (int)t->derivatives;
        if (getenv("AA"))
            job.choice[AXIS_aa] = CHOICE_aa_box;
        const Ir *ir = compile_ir(&session, t->document.graph,
                                  t->document.graph->materials[material].node, &job);
        if (ir) {
            check_values(t, material, slot, level, ir);
            check_text(t, material, slot, &session, ir);
        } else {
            fault(t, material, slot, "-O%d: no IR", level);
        }
        arena_free(&arena);
    }
}

static void check_material(Test *t, int material, Choice derivatives)
{
    ReferenceContext context = {.noise = REFERENCE_LATTICE};
    t->oracle = oracle_open(t->document.graph, &context);
    t->derivatives = derivatives;
    oracle_derivatives(t->oracle, derivatives);
    t->bent = oracle_displaced(t->document.graph->materials[material].node) && !getenv("AA");
    for (int front = 0; front < 2; front++) {
        t->hulls[front] = calloc((size_t)t->count, sizeof **t->hulls);
        assert_non_null(t->hulls[front]);
        const PointSet points = {t->points, t->count, front, &reach_double, t->bent};
        points_hulls(t->oracle, t->document.graph->materials[material].node, &points,
                     t->hulls[front]);
    }
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        check_slot(t, material, (Slot)slot);
    oracle_close(t->oracle);
    for (int front = 0; front < 2; front++)
        free(t->hulls[front]);
}

static void ir_means_what_the_oracle_says(void **state)
{
    (void)state;
    static Point points[SAMPLES];
    Test test = {.points = points, .count = sample_points(points)};
    DocumentList list = documents_tried(SOURCE_FOLDER);
    const char *only = getenv("VALUE_ONLY");
    assert_true(list.count > 100);
    for (int i = 0; i < list.count; i++) {
        if (only && !strstr(list.paths[i], only))
            continue;
        bool good = document_open(&test.document, list.paths[i]);
        if (!good && !document_is_library(&test.document))
            fail_msg("%s: %s", list.paths[i], document_fault(&test.document));
        for (int material = 0; good && material < test.document.graph->material_count; material++) {
            check_material(&test, material, CHOICE_derivatives_auto);
            if (has_slopes(&test, material, CHOICE_derivatives_auto))
                check_material(&test, material, CHOICE_derivatives_finite);
            if (has_slopes_within(&test, material))
                check_material(&test, material, CHOICE_derivatives_analytic);
        }
        document_close(&test.document);
    }
    documents_free(&list);
    print_message("%d points on either side; worst difference within the bound of %.0e: %.1e\n",
                  test.count, bound, test.worst);
    assert_int_equal(test.faults, 0);
}

/* At an item's value that item holds, the last one of several with the same: points beside it do
 * not tell. */
static void a_blend_at_an_items_value_is_that_item(void **state)
{
    (void)state;
    static const struct {
        double at, value;
    } cases[] = {{-1, 0.2},    {0, 0.2},      {0.125, 0.6}, {0.25, 0.125},
                 {0.5, 0.375}, {0.75, 0.625}, {2, 0.625}};
    Document d;
    if (!document_open_text(
            &d, "{ material: Phong, emissive: { map: Blend, blend: [{ value: 0, input: 0.2 }, { "
                "value: 0.25, input: 1 },\n"
                "  { value: 0.25, input: 0.125 }, { value: 0.75, input: 0.625 }] } }\n"))
        fail_msg("%s", document_fault(&d));
    for (int level = 0; level <= 2; level += 2) {
        Arena arena = {0};
        Session session = {
            .options = &d.options, .arena = &arena, .optimize = level, .check = true};
        Job job;
        choice_job(&(MatcOptions){.pass = "value"}, &job);
        job.slot = SLOT_emissive;
        const Ir *ir = compile_ir(&session, d.graph, d.graph->materials[0].node, &job);
        ReferenceContext context = {.noise = ir->noise};
        for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
            double inputs[INPUT_COUNT][4] = {{0}}, result[MAX_OUTPUTS][4];
            inputs[INPUT_X][0] = cases[i].at;
            ir_eval(ir, &context, (const double(*)[4])inputs, result);
            if (!(fabs(result[0][0] - cases[i].value) <= bound))
                fail_msg("-O%d at %g: %.17g instead of %g", level, cases[i].at, result[0][0],
                         cases[i].value);
        }
        arena_free(&arena);
    }
    document_close(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_blend_at_an_items_value_is_that_item),
        cmocka_unit_test(ir_means_what_the_oracle_says),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
