/* --coordinates=long: chains of scales, offsets and rotations that affine.c composes have the
 * values of the oracle, which applies them step by step. In double, so that every offset and
 * every digit of a factor counts. test_stress and the accuracy page cover floats. */
#include "tests/test.h"
#include "tests/stress/pixel.h"
#include "tests/value/documents.h"
#include "tests/value/evaluate.h"
#include "tests/value/points.h"
#include <stdlib.h>

enum { STEP = 4, SAMPLES = POINT_COUNT / STEP };
static const double bound = 1e-9;

#define SHADED(map)    "material: Phong\ndiffuse: " map "\n"
#define CUBES(input)   SHADED("{map: VolumeChecker, color1: 0.9, color2: 0.2, input: " input "}")
#define SQUARES(input) SHADED("{map: Checker, color1: 0.9, color2: 0.2, input: " input "}")
#define CLOUD(input)                                                                               \
    SHADED("{map: VolumeTurbulence, octaves: 3, noiseRatio: 0.5, input: " input "}")

/* One that grows with every kind of step: where an offset, a sign or a column is lost, squares are
 * in other places. */
static const char *const documents[] = {
    SQUARES("{map: UVTransform, offsetU: 0.3, offsetV: -0.7, scaleU: 5.3, scaleV: 2.9}"),
    SQUARES("{map: UVTransform, offsetU: 0.3, scaleU: 1.7, input: {map: UVTransform, offsetV: 1.1, "
            "offsetU: 0.2, "
            "scaleV: 3.3}}"),
    SQUARES("{map: UVTransform, angle: 0.7, shear: 0.4, offsetU: 0.3, offsetV: 0.1, scaleU: 3.1, "
            "scaleV: -2.3}"),
    CUBES("{map: XYZTransform, transform: {translation: [0.3, 1.7, -0.9]}}"),
    CUBES("{map: XYZTransform, transform: {translation: [0.3, 1.7, -0.9], rotation: [0.3, 0.5, "
          "-0.2], scale: [1.3, "
          "0.7, 2.1]}}"),
    CUBES("{map: XYZTransform, transform: {scale: -1}, input: {map: XYZTransform, transform: "
          "{translation: [0.3, 0.1, "
          "0.7]}}}"),
    CUBES("{map: XYZTransform, transform: {scale: 3.3}, input: {map: XYZTransform, transform: "
          "{translation: [0.3, 0.1, "
          "0.7]}}}"),
    CUBES("{map: XYZTransform, transform: {translation: [0.2, 0.4, 0.6]}, input: {map: "
          "XYZTransform, transform: {matrix: "
          "[1.1, 0.2, -0.3, 0.7, 0.4, 0.9, 0.1, -0.2, -0.5, 0.3, 1.2, 0.4, 0, 0, 0, 1]}}}"),
    CLOUD("{map: XYZTransform, transform: {translation: [0.3, 1.7, -0.9], rotation: [0.3, 0.5, "
          "-0.2], scale: [1.3, "
          "0.7, 2.1]}}"),
    CLOUD("{map: XYZTransform, transform: {translation: [0.3, 1.7, -0.9]}, input: {map: "
          "XYZTransform, useGlobal: true, "
          "transform: {scale: 0.7}}}"),
    SHADED("{map: Granite, input: {map: XYZTransform, transform: {translation: [0.3, 1.7, -0.9], "
           "scale: [1.3, 0.7, "
           "2.1]}}}"),
    SHADED("{map: Leopard, input: {map: Turbulence, octaves: 2, noiseRatio: 0.5, input: {map: "
           "XYZTransform, transform: "
           "{translation: [0.3, 1.7, -0.9], scale: [1.3, 0.7, 2.1]}}}}"),
};

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

static bool calls(const Ir *ir, int function)
{
    for (Ref ref = 1; ref < ir->count; ref++)
        if (ir_is(ir, ref, OP_call) && (int)ir_at(ir, ref)->payload == function)
            return true;
    return false;
}

static const Ir *compile_long(Document *d, Session *session)
{
    Job job;
    choice_job(&(MatcOptions){.pass = "value", .coordinates = "long"}, &job);
    job.slot = SLOT_diffuse;
    const Ir *ir = compile_ir(session, d->graph, d->graph->materials[0].node, &job);
    assert_non_null(ir);
    assert_true(!session->optimize ||
                /* cosines of angles are no numbers before they are folded */
                calls(ir, FN_affineFraction));
    return ir;
}

/* The greatest difference to the oracle that its neighborhood does not explain. */
static double worst_of(Document *d, int level, const Point *points, const Hull *hulls, int count)
{
    Arena arena = {0};
    Session session = {.options = &d->options, .arena = &arena, .optimize = level, .check = true};
    const Ir *ir = compile_long(d, &session);
    ReferenceContext context = {.noise = ir->noise};
    double worst = 0;
    for (int i = 0; i < count; i++) {
        double inputs[INPUT_COUNT][4], result[MAX_OUTPUTS][4];
        evaluate_inputs(&points[i], true, inputs);
        ir_eval(ir, &context, (const double(*)[4])inputs, result);
        for (int component = 0; component < 3; component++)
            worst =
                fmax(worst, hull_miss(&hulls[i], SLOT_diffuse, component, result[0][component]));
    }
    arena_free(&arena);
    return worst;
}

static void long_coordinates_have_the_oracles_values(void **state)
{
    (void)state;
    static Point points[SAMPLES];
    static Hull hulls[SAMPLES];
    int count = sample_points(points);
    for (size_t i = 0; i < sizeof documents / sizeof *documents; i++) {
        Document d;
        ReferenceContext context = {.noise = REFERENCE_LATTICE};
        if (!document_open_text(&d, documents[i]))
            fail_msg("%s%s", documents[i], document_fault(&d));
        Oracle *oracle = oracle_open(d.graph, &context);
        points_hulls(oracle, d.graph->materials[0].node,
                     &(PointSet){points, count, true, &reach_double, false}, hulls);
        for (int level = 0; level <= 2; level += 2) {
            double worst = worst_of(&d, level, points, hulls, count);
            if (!(worst <= bound))
                fail_msg("%s-O%d: off by %.3g", documents[i], level, worst);
        }
        oracle_close(oracle);
        document_close(&d);
    }
}

/* Normals in the relief of each pattern: its slopes. */
#define RELIEF(map) "material: Phong\ninput: {map: BumpMap, strength: 3, displacement: " map "}\n"

#define SQUARE_RELIEF(input) RELIEF("{map: Checker, input: " input "}")
#define CUBE_RELIEF(input)   RELIEF("{map: VolumeChecker, input: " input "}")
static const char *const reliefs[] = {
    SQUARE_RELIEF("{map: UVTransform, offsetU: 0.3, offsetV: -0.7, scaleU: 5.3, scaleV: 2.9}"),
    SQUARE_RELIEF("{map: UVTransform, angle: 0.7, shear: 0.4, offsetU: 0.3, offsetV: 0.1, scaleU: "
                  "3.1, scaleV: -2.3}"),
    CUBE_RELIEF("{map: XYZTransform, transform: {translation: [0.3, 1.7, -0.9], rotation: [0.3, "
                "0.5, -0.2]}}"),
    RELIEF("{map: Granite, input: {map: XYZTransform, transform: {translation: [0.3, 1.7, -0.9], "
           "scale: 1.3}}}"),
    RELIEF("{map: VolumeTurbulence, octaves: 3, input: {map: XYZTransform, transform: {scale: "
           "[1.3, 0.7, 2.1]}}}"),
    RELIEF(
        "{map: Leopard, input: {map: XYZTransform, transform: {translation: [0.3, 1.7, -0.9]}}}"),
};
static const Pixel pixels[] = {{0, 0}, {.02, -.013}, {.3, .01}};

static Ir *compile_relief(Document *d, Session *session, const char *coordinates, const char *aa)
{
    Job job;
    const MatcOptions options = {
        .pass = "value", .coordinates = coordinates, .aa = aa, .derivatives = "analytic"};
    assert_null(choice_job(&options, &job));
    job.slot = SLOT_normal;
    Ir *ir = compile_ir(session, d->graph, d->graph->materials[0].node, &job);
    assert_non_null(ir);
    return ir;
}

static double apart(const Ir *plain, const Ir *exact, const Point *point, Pixel pixel)
{
    double inputs[INPUT_COUNT][4], a[MAX_OUTPUTS][4], b[MAX_OUTPUTS][4], most = 0;
    ReferenceContext context = {.noise = plain->noise};
    evaluate_inputs(point, true, inputs);
    pixel_inputs(pixel, inputs);
    ir_eval(plain, &context, (const double(*)[4])inputs, a);
    ir_eval(exact, &context, (const double(*)[4])inputs, b);
    for (int component = 0; component < 3; component++)
        most = fmax(most, fabs(a[0][component] - b[0][component]));
    return most;
}

static void check_relief(Document *d, const char *text, const char *aa, const Point *points,
                         int count)
{
    Arena arena = {0};
    Session session = {.options = &d->options, .arena = &arena, .optimize = 2, .check = true};
    const Ir *plain = compile_relief(d, &session, "plain", aa);
    const Ir *exact = compile_relief(d, &session, "long", aa);
    int missed = 0, compared = 0;
    for (size_t k = 0; k < sizeof pixels / sizeof *pixels; k++)
        for (int i = 0; i < count; i++, compared++)
            missed += !(apart(plain, exact, &points[i], pixels[k]) <= 1e-6);
    arena_free(&arena);
    if (100 * missed > compared) /* an edge of a square may lie between the two */
        fail_msg("%s--aa=%s: other slopes at %d of %d points", text, aa, missed, compared);
}

static void long_coordinates_have_the_slopes_of_plain_ones(void **state)
{
    static const char *const ways[] = {"none", "box", "aniso"};
    static Point points[SAMPLES];
    int count = sample_points(points);
    (void)state;
    for (size_t i = 0; i < sizeof reliefs / sizeof *reliefs; i++)
        for (int way = 0; way < 3; way++) {
            Document d;
            if (!document_open_text(&d, reliefs[i]))
                fail_msg("%s%s", reliefs[i], document_fault(&d));
            check_relief(&d, reliefs[i], ways[way], points, count);
            document_close(&d);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(long_coordinates_have_the_oracles_values),
        cmocka_unit_test(long_coordinates_have_the_slopes_of_plain_ones),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
