/* True displacement: the program for it and its slopes, in double, against the oracle; the bound
 * that matc proves, against closed forms and many points; normals on curved bases, against
 * closed forms. test_equiv and test_value also compare normals of displaced surfaces, by the
 * examples. */
/* ctest: seconds=11 */
#include "tests/test.h"
#include "compiler/choice.h"
#include "tests/draw/curved.h"
#include "tests/value/documents.h"
#include "tests/value/evaluate.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* beyond, the oracle's differences are too wide beside what maps do, as in test_equiv */
static const float far = 100;
/* of a distance from an axis, beside which differences are wide */
static const float tip = 1e-6f;
static const double value_bound = 1e-12, slope_bound = 1e-6;

/* Low-discrepancy numbers in [-2, 2): five components, by powers of the root of x^6 = x + 1. */
static double spread(int index, int component)
{
    return 4 * fmod((index + 1) * pow(1.1347241384015194, -(component + 1)), 1) - 2;
}

/* A material and what matc says about it. */
typedef struct {
    const char *text; /* YAML */
    double bound;     /* the closed form; 0: none is known */
    double reach;     /* of the bound, how much points come to at least */
} Row;

#define NOISE "{ map: VolumeTurbulence, octaves: 3, noiseRatio: 0.5, size: 3 }"
#define BLEND(a, b)                                                                                \
    "{ map: Blend, blend: [{ value: -1, input: " a " }, { value: 1, input: " b                     \
    " }], input: " NOISE " }"
static const Row rows[] = {
    {"material: Phong\ndisplacement: 0.25\n", 0.25, 1},
    {"material: RGBA\ndisplacement: -2\ndisplacementScale: 0.5\n", 1, 1},
    /* 1 + 1/2 + 1/4 octaves, each at most 1 */
    {"material: Phong\ndisplacement: " NOISE "\ndisplacementScale: 0.2\n", 0.35, 0.4},
    {"material: Phong\ndisplacement: { map: Gradient, direction: [1, 2, 0], waveForm: Sin "
     "}\ndisplacementScale: -3\n",
     3, 0.99},
    {"material: Phong\ndisplacement: { map: Leopard, frequency: 2 }\ndisplacementScale: 0.5\n", 1,
     0.8},
    {"material: Phong\ndisplacement: { map: Checker, color1: 0.125, color2: -0.25 }\n", 0.25, 1},
    {"material: Phong\ndisplacement: { map: Wood, waveForm: Sin01 }\ndisplacementScale: 0.1\n", 0.1,
     0.99},
    {"material: Phong\ndisplacement: " BLEND("0.1", "-0.3") "\n", 0.3, 0.7},
    /* cut at its bound */
    {"material: Phong\ndisplacement: { map: Wood }\ndisplacementBound: 0.5\n", 0.5, 1},
    {"material: Phong\ndisplacement: " NOISE "\ndisplacementBound: 0.05\n", 0.05, 1},
    /* 3 + 4 and 1 + 2 + 2: of a frame that is not at right angles all may lead one way */
    {"material: Phong\ndisplacementVector: [3, 4, 0]\ndisplacementScale: 0.1\n", 0.7, 0.7},
    {"material: Phong\ndisplacementVector: [1, 2, 0]\ndisplacement: 2\n", 5, 0.6},
    {"material: Phong\ndisplacementVector: " BLEND("[0.3, 0, 0.1]",
                                                   "[-0.1, 0.2, 0]") "\ndisplacementBound: 0.2\n",
     0.2, 0.7},
    {"material: Phong\ndisplacementVector: " BLEND("[0.3, 0, 0.1]", "[-0.1, 0.2, 0]") "\n", 0, 0.4},
    /* the front's, and what a switch says itself */
    {"material: SideSwitch\nfrontShader: { material: RGBA, displacement: 0.5 }\nbackShader: { "
     "material: RGBA, displacement: 3 }\n",
     0.5, 1},
    {"material: SideSwitch\nfrontShader: { material: RGBA, displacement: 0.5 }\ndisplacement: "
     "0.75\n",
     0.75, 1},
    {"material: AlgorithmSwitch\nguiShader: { material: Phong, displacement: " NOISE " }\n", 1.75,
     0.4},
};
enum { ROWS = sizeof rows / sizeof *rows };

static double size_of(const double v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

static double apart_of(const double a[4], const double b[3])
{
    return size_of((double[3]){a[0] - b[0], a[1] - b[1], a[2] - b[2]}) / fmax(1, size_of(b));
}

/* The fourth height of a volume. */
static double apart_in_last(const double a[4], const double b[4], const Node *material)
{
    const Node *displaced = oracle_displaced(material);
    return displaced && graph_displaces_volume(displaced) ? fabs(a[3] - b[3]) / fmax(1, fabs(b[3]))
                                                          : 0;
}

/* The IR of the pass displacement, at one level. */
static void check_material(Document *d, int material, int optimize, double worst[2])
{
    static Point points[POINT_COUNT];
    static ReferenceTexture textures[EVALUATE_TEXTURES];
    MatcOptions options = d->options;
    Arena arena = {0};
    Job job;
    const Node *node = d->graph->materials[material].node;
    options.pass = "displacement";
    options.aa = "none";
    assert_null(choice_job(&options, &job));
    Session session = {.options = &options, .arena = &arena, .optimize = optimize, .check = true};
    const Ir *ir = compile_ir(&session, d->graph, node, &job);
    assert_true(ir && evaluate_textures(&arena, ir, textures));
    const ReferenceContext context = {ir->noise, textures};
    Oracle *oracle = oracle_open(d->graph, &context);
    points_make(points);
    oracle_judge_slopes(oracle, true);
    for (int i = 0; i < POINT_COUNT; i++) {
        double inputs[INPUT_COUNT][4], result[MAX_OUTPUTS][4];
        Surface surface;
        OracleDisplacement want;
        const float *x = points[i].input[INPUT_X];
        if (point_is_extreme(&points[i]) || point_is_far(&points[i], far) ||
            hypotf(x[0], x[1]) < tip)
            continue;
        point_surface(&points[i], true, &surface);
        evaluate_inputs(&points[i], true, inputs);
        ir_eval(ir, &context, (const double(*)[4])inputs, result);
        assert_true(oracle_displacement(oracle, node, &surface, &want));
        const bool rough = oracle_slopes_rough(oracle);
        const double value = fmax(apart_of(result[0], want.by),
                                  apart_in_last(result[0], want.by, node)),
                     slope =
                         fmax(fmax(apart_of(result[1], want.by_u), apart_of(result[2], want.by_v)),
                              fmax(apart_in_last(result[1], want.by_u, node),
                                   apart_in_last(result[2], want.by_v, node)));
        worst[0] = fmax(worst[0], value);
        if (value > value_bound)
            fail_msg("%s, -O%d, point %d: %.17g %.17g %.17g, not %.17g %.17g %.17g",
                     document_name(d), optimize, i, result[0][0], result[0][1], result[0][2],
                     want.by[0], want.by[1], want.by[2]);
        if (slope > slope_bound && !rough) {
            oracle_slope_span(oracle, 0, 1); /* at a crease either side will do */
            oracle_displacement(oracle, node, &surface, &want);
            double ahead = fmax(apart_of(result[1], want.by_u), apart_of(result[2], want.by_v));
            oracle_slope_span(oracle, -1, 0);
            oracle_displacement(oracle, node, &surface, &want);
            double behind = fmax(apart_of(result[1], want.by_u), apart_of(result[2], want.by_v));
            oracle_slope_span(oracle, -1, 1);
            oracle_slopes_rough(oracle);
            if (fmin(ahead, behind) > slope_bound)
                fail_msg("%s, -O%d, point %d (%g %g %g): slopes %.9g %.9g, not %.9g %.9g",
                         document_name(d), optimize, i, x[0], x[1], x[2], result[1][2],
                         result[2][2], want.by_u[2], want.by_v[2]);
        } else if (!rough) {
            worst[1] = fmax(worst[1], slope);
        }
    }
    oracle_close(oracle);
    arena_free(&arena);
}

static void values_and_slopes_are_the_oracles(void **state)
{
    (void)state;
    DocumentList list = documents_list(SOURCE_FOLDER);
    double worst[2] = {0, 0};
    int materials = 0;
    for (int i = 0; i < list.count; i++) {
        Document d;
        if (!strstr(list.paths[i], "isplacement"))
            continue;
        if (!document_open(&d, list.paths[i]))
            fail_msg("%s", document_fault(&d));
        for (int k = 0; k < d.graph->material_count; k++, materials++)
            for (int optimize = 0; optimize <= 2; optimize += 2)
                check_material(&d, k, optimize, worst);
        document_close(&d);
    }
    documents_free(&list);
    assert_true(materials >= 8);
    for (int i = 0; i < ROWS; i++) {
        Document d;
        if (!document_open_text(&d, rows[i].text))
            fail_msg("%s: %s", rows[i].text, document_fault(&d));
        for (int optimize = 0; optimize <= 2; optimize += 2)
            check_material(&d, 0, optimize, worst);
        document_close(&d);
    }
    print_message("%d materials of examples and %d here: values within %.1e, slopes within %.1e\n",
                  materials, ROWS, worst[0], worst[1]);
}

/* No point of many moves farther than matc says, and some move nearly as far. */
static void no_point_moves_beyond_its_bound(void **state)
{
    (void)state;
    enum { COUNT = 20000 };
    for (int i = 0; i < ROWS; i++) {
        Document d;
        double most = 0;
        assert_true(document_open_text(&d, rows[i].text));
        MatcProgram *program = matc_compile(d.document, 0, MATC_VERTEX, &d.options);
        const double bound = matc_displacement_bound(program);
        const ReferenceContext context = {.noise = REFERENCE_LATTICE};
        Oracle *oracle = oracle_open(d.graph, &context);
        oracle_derivatives(oracle, CHOICE_derivatives_finite);
        for (int k = 0; k < COUNT; k++) {
            Surface surface;
            OracleDisplacement move;
            oracle_surface_default(&surface);
            for (int component = 0; component < 3; component++) {
                surface.root[channel_id(GROUP_X, component)] = 3 * spread(k, component);
                surface.root[channel_id(GROUP_U, component)] =
                    component < 2 ? 2 * spread(k, 3 + component) : 0;
            }
            assert_true(oracle_displacement(oracle, d.graph->materials[0].node, &surface, &move));
            most = fmax(most, size_of(move.by));
        }
        if (most > bound || most < rows[i].reach * bound * (1 - 2e-5) ||
            (rows[i].bound > 0 && fabs(bound - rows[i].bound) > 3e-5 * bound))
            fail_msg("%s: %g at most by intervals, not %g; %g over %d points", rows[i].text, bound,
                     rows[i].bound, most, COUNT);
        oracle_close(oracle);
        matc_program_free(program);
        document_close(&d);
    }
}

static void what_has_no_bound_is_reported(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        bool known, moves;
    } cases[] = {
        {"material: Phong\n", true, false},
        {"material: Phong\ndisplacement: 0\n", true, false},
        {"material: Phong\ndisplacement: { map: Granite }\ndisplacementScale: 0\n", true, false},
        {"material: Phong\ndisplacement: { map: Granite }\n", true, true},
        {"material: Phong\ndisplacement: { map: Wood }\n", false, true},
        {"material: Phong\ndisplacement: { map: Granite }\ndisplacementScale: { param: size, "
         "default: 1 }\n",
         false, true},
        {"material: Phong\ndisplacement: { map: Granite }\ndisplacementScale: { param: size, "
         "default: 1 }\ndisplacementBound: 2\n",
         true, true},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Document d;
        assert_true(document_open_text(&d, cases[i].text));
        MatcProgram *program = matc_compile(d.document, 0, MATC_VERTEX, &d.options);
        const double bound = matc_displacement_bound(program);
        const bool reported =
            strstr(matc_program_diagnostics(program, MATC_TEXT), "unbounded_displacement") != NULL;
        const bool moves =
            strstr(matc_output(program, MATC_VERTEX, NULL), "matc_displacement") != NULL;
        if (!isfinite(bound) == cases[i].known || reported == cases[i].known ||
            moves != cases[i].moves || (bound > 0) != cases[i].moves)
            fail_msg("%s: bound %g, warned %d, moves %d", cases[i].text, bound, reported, moves);
        matc_program_free(program);
        document_close(&d);
    }
}

typedef enum { HEIGHTS, HEIGHTS_STAYING, VECTORS } Carried;
/* How far the oracle's normals are off the closed form over a body, in degrees, at most;
 * HEIGHTS_STAYING: normals of the base are said to stay as they are. */
static double off_normals(Oracle *oracle, const Node *material, CurvedBody body, double scale,
                          Carried by)
{
    enum { COUNT = 400 };
    double most = 0;
    for (int i = 0; i < COUNT; i++) {
        Surface surface;
        SlotValues values;
        double want[3];
        curved_surface(body, fmod(i * 0.61803398874989485, 1), (i + 0.5) / COUNT, &surface);
        if (by == HEIGHTS_STAYING)
            for (int component = 0; component < 3; component++)
                surface.normal_u[component] = surface.normal_v[component] = 0;
        if (by == VECTORS)
            curved_vector_normal(body, scale, &surface.root[channel_id(GROUP_P, 0)], want);
        else
            curved_normal(body, scale, &surface.root[channel_id(GROUP_P, 0)], by == HEIGHTS_STAYING,
                          want);
        assert_true(oracle_material(oracle, material, &surface, &values));
        most = fmax(most, curved_angle(values.component[SLOT_normal], want));
    }
    return most;
}

/* A ball and a torus that rise by up to a quarter of their radii. A ball that all moves by c along
 * the circles of latitude is a larger one that was turned: its normal is n + c Tu/|Tu|. */
static void normals_are_those_of_curved_surfaces(void **state)
{
    (void)state;
    const double most = 1e-5; /* degrees: differences tell slopes */
    Document d;
    for (CurvedBody body = 0; body < CURVED_COUNT; body++) {
        char text[300];
        const double scale = curved_radius[body] / 4;
        snprintf(text, sizeof text,
                 "material: Phong\ndisplacement: " CURVED_HEIGHT "\ndisplacementScale: %g\n",
                 scale);
        assert_true(document_open_text(&d, text));
        Oracle *oracle = oracle_open(d.graph, &(ReferenceContext){.noise = REFERENCE_LATTICE});
        for (Carried by = HEIGHTS; by < VECTORS; by++)
            assert_true(off_normals(oracle, d.graph->materials[0].node, body, scale, by) < most);
        oracle_close(oracle);
        document_close(&d);
        snprintf(text, sizeof text,
                 "material: Phong\ndisplacementVector: " CURVED_VECTOR "\ndisplacementScale: %g\n",
                 scale);
        assert_true(document_open_text(&d, text));
        oracle = oracle_open(d.graph, &(ReferenceContext){.noise = REFERENCE_LATTICE});
        assert_true(off_normals(oracle, d.graph->materials[0].node, body, scale, VECTORS) < most);
        oracle_close(oracle);
        document_close(&d);
    }
    assert_true(document_open_text(&d, "material: Phong\ndisplacementVector: [0.5, 0, 0]\n"));
    Oracle *oracle = oracle_open(d.graph, &(ReferenceContext){.noise = REFERENCE_LATTICE});
    for (int i = 0; i < 20; i++) {
        Surface surface;
        SlotValues values;
        double want[3];
        curved_surface(CURVED_ball, i / 20., 0.1 + i / 30., &surface);
        const double *n = &surface.root[channel_id(GROUP_N, 0)],
                     *tu = &surface.root[channel_id(GROUP_DU, 0)];
        for (int component = 0; component < 3; component++)
            want[component] = n[component] + 0.5 * tu[component] / size_of(tu);
        assert_true(oracle_material(oracle, d.graph->materials[0].node, &surface, &values));
        assert_true(curved_angle(values.component[SLOT_normal], want) < most);
    }
    oracle_close(oracle);
    document_close(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_and_slopes_are_the_oracles),
        cmocka_unit_test(normals_are_those_of_curved_surfaces),
        cmocka_unit_test(no_point_moves_beyond_its_bound),
        cmocka_unit_test(what_has_no_bound_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
