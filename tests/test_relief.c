/* Slopes of displacements under each --derivatives, by closed forms: what the oracle says of the normal at a point, which the programs are
 * held to by test_value and test_stress. Steps of programs, in floats far from the origin. And where a displacement has no slope, that is
 * said. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "compiler/base/output.h"
#include "compiler/matc.h"
#include "runtime/gl/png_write.h"
#include "tests/stress/spread.h"
#include "tests/value/documents.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define STEP(x) "{ map: Gradient, direction: [" x "] }"
#define CHECKER "{ map: Checker }"
#define SCALED  "{ map: Checker, input: { map: UVTransform, scaleU: 8 } }"
#define TURNED  "{ map: Checker, input: { map: UVTransform, angle: 1.5707963267948966 } }"
#define RAMP(in)                                                                                                       \
    "{ map: Blend, blend: [{ value: 0, input: 0 }, { value: 1, input: " STEP("0, 3, 0") " }], input: " in " }"

typedef struct {
    const char *derivatives, *displacement, *point;
    double by_u, by_v;
} Row;

/* The normal of the point is z, its tangents x and y, and so are those of the local position. A checker rises by 1 over 0.05. */
static const Row rows[] = {
    {"auto", STEP("3, -2, 0"), "x=1 y=1", 3, -2},
    {"analytic", STEP("3, -2, 0"), "x=1 y=1", 3, -2},
    {"finite", STEP("3, -2, 0"), "x=1 y=2", -1, -1}, /* its value */
    {"auto", "{ map: Gradient, waveForm: Sqr }", "x=1.5", 3, 0},
    /* 0 to 3 y along x: 3 x y */
    {"auto", RAMP(STEP("1, 0, 0")), "x=0.5 y=2", 6, 1.5},
    {"analytic", RAMP(STEP("1, 0, 0")), "x=0.5 y=2", 6, 1.5},
    {"auto", CHECKER, "u=0.46 v=0.2", 20, 0},
    {"auto", CHECKER, "u=0.44 v=0.2", 0, 0},
    {"auto", CHECKER, "u=0.96 v=0.46", -20, -20},
    {"finite", CHECKER, "u=0.96 v=0.46", -20, -20},
    {"analytic", CHECKER, "u=0.46 v=0.2", 0, 0},
    /* u' = 8 u: as steep as it is narrow; GroIMP leaves the slope by u' */
    {"auto", SCALED, "u=0.06 v=0.2", 160, 0},
    {"auto", SCALED, "u=0.05 v=0.2", 0, 0},
    {"finite", SCALED, "u=0.06 v=0.2", 20, 0},
    /* u' = v, v' = -u: along v, from 1 to 0 */
    {"auto", TURNED, "u=0.2 v=0.46", 0, -20},
    /* the colours' own slopes, and the step between them: 3 y and 1 at y = 2 */
    {"auto", "{ map: Checker, color1: " STEP("0, 3, 0") " }", "u=0.46 v=0.2 y=2", 120, 0},
    {"auto", "{ map: Checker, color1: " STEP("0, 3, 0") " }", "u=0.7 v=0.2 y=2", 0, 3},
    {"auto", "{ map: Checker, color1: " STEP("0, 3, 0") " }", "u=0.96 v=0.2 y=2", -120, 3},
    /* along a checker: between the Blends along 0 and 1; 1 is beyond the last item */
    {"auto", RAMP(CHECKER), "u=0.46 v=0.2 y=2", 120, 0},
    {"auto", RAMP(CHECKER), "u=0.96 v=0.2 y=2", -120, 3},
    {"auto", RAMP("{ map: UVTransform, input: " CHECKER " }"), "u=0.96 v=0.2 y=2", -120, 3},
    {"auto", RAMP("{ map: Checker, color1: " CHECKER ", color2: 0, input: { map: UVTransform, scaleU: 0.5 } }"),
     "u=0.46 v=0.2 y=2", 0, 0},
    /* halfway between a checker and 3 x, the weight rising by x: 1/2 (20 + 3) + (3 x - c), over 1 */
    {"auto", "{ map: Blend, blend: [{ value: 0, input: " CHECKER " }, { value: 1, input: " STEP("3, 0, 0") " }] }",
     "u=0.46 v=0.2 x=0.5", 13, 0},
    /* unit cubes, a step of a tenth of them */
    {"auto", "{ map: VolumeChecker }", "x=0.95 y=0.2", 10, 0},
    {"auto", "{ map: VolumeChecker }", "x=0.85 y=0.95", 0, 10},
    {"finite", "{ map: VolumeChecker }", "x=0.95 y=0.2", 0, 0},
    /* from c = 4 frac x - 2 the one step leaves at 1.992 and stays at -1.988: from -1 to 1 over .005; its square is 1 in both */
    {"auto", "{ map: Mandel, iterations: 1 }", "x=-0.002 y=0.5", 400, 0},
    {"auto", "{ map: Mandel, iterations: 1, waveForm: Sqr }", "x=-0.002 y=0.5", 0, 0},
    {"finite", "{ map: Mandel, iterations: 1 }", "x=-0.002 y=0.5", -1, -1},
    /* the mean of a checker at three points of u, 0.04 apart: two of them are less than a step before the edge */
    {"auto", "{ map: Smooth3D, sx: 0.08, sy: 0, sz: 0, input: " CHECKER " }", "u=0.43 v=0.2", 20.0 / 3, 0},
    {"finite", "0.5", "u=0.3", 0, 0},
};

static MatcDocument *open(const char *displacement, const MatcOptions *options)
{
    char text[2000];
    snprintf(text, sizeof text, "material: Phong\ninput: { map: BumpMap, displacement: %s }\n", displacement);
    return matc_read("relief.yaml", text, strlen(text), options);
}

static void slopes_are_those_of_closed_forms(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const Row *row = &rows[i];
        MatcOptions options;
        const char *fault;
        double n[3];
        matc_options_init(&options);
        options.derivatives = row->derivatives;
        MatcDocument *document = open(row->displacement, &options);
        char *text = matc_eval(document, 0, row->point, &options, &fault);
        assert_non_null(text);
        assert_int_equal(sscanf(strstr(text, "normal"), "normal %lf %lf %lf", &n[0], &n[1], &n[2]), 3);
        const double by_u = -n[0] / n[2] / 0.02, by_v = -n[1] / n[2] / 0.02, bound = 1e-4;
        if (fabs(by_u - row->by_u) > bound || fabs(by_v - row->by_v) > bound)
            fail_msg("%s, %s at %s: %.9g %.9g, should be %g %g", row->derivatives, row->displacement, row->point, by_u,
                     by_v, row->by_u, row->by_v);
        free(text);
        matc_document_free(document);
    }
}

/* How a program is made. */
typedef struct {
    const char *derivatives, *aa;
    int optimize;
} Making;

/* The normal of a program in floats. */
static void float_normal(Document *d, const Making *making, const Point *point, double n[3])
{
    static ReferenceTexture textures[EVALUATE_TEXTURES];
    MatcOptions options = d->options;
    Job job;
    double inputs[INPUT_COUNT][4];
    Evaluation e;
    options.pass = "value";
    options.slot = "normal";
    options.aa = making->aa;
    options.derivatives = making->derivatives;
    assert_null(choice_job(&options, &job));
    Session session = {.options = &options, .arena = &d->arena, .optimize = making->optimize};
    const Ir *ir = compile_ir(&session, d->graph, d->graph->materials[0].node, &job);
    assert_true(ir && evaluate_textures(&d->arena, ir, textures));
    evaluate_inputs(point, true, inputs);
    evaluate_float(ir, &(ReferenceContext){ir->noise, textures}, (const double(*)[4])inputs, &e);
    memcpy(n, e.value[0], 3 * sizeof *n);
}

/* At 0, its normal z and its tangents x and y. */
static Point flat_point(void)
{
    Point p = {{{0}}};
    p.input[INPUT_N][2] = p.input[INPUT_DU][0] = p.input[INPUT_DV][1] = 1;
    p.input[INPUT_XU][0] = p.input[INPUT_XV][1] = 1;
    return p;
}

static char folder[] = "/tmp/matc-relief-XXXXXX", picture[64];

/* Five texels either way: steps that no float has. */
static int make_picture(void **state)
{
    (void)state;
    enum { SIDE = 5, LANES = 3 };
    uint8_t bytes[SIDE * SIDE * LANES], *file;
    size_t size;
    const char *why;
    if (!mkdtemp(folder))
        return 1;
    snprintf(picture, sizeof picture, "%s/picture.png", folder);
    for (int i = 0; i < SIDE * SIDE * LANES; i++)
        bytes[i] = (uint8_t)(i / LANES * (i / LANES) * 89 + 40);
    file = png_write(&(PngPicture){SIDE, SIDE, LANES, bytes}, &size, &why);
    if (file)
        why = output_write(picture, file, size);
    free(file);
    return why != NULL;
}

static int remove_picture(void **state)
{
    (void)state;
    return remove(picture) || rmdir(folder);
}

/* The same at places and at so many turns from there; %s is the picture. */
static void steps_are_as_wide_far_out(const char *form, const Making *making, float turns)
{
    static const float places[][2] = {
        {1.375f, 1.484375f}, {-2.125f, -1.0078125f}, {3.4765625f, 2.9921875f}, {-.375f, .734375f}};
    char text[1000], displacement[500];
    Document d;
    snprintf(displacement, sizeof displacement, form, picture);
    snprintf(text, sizeof text, "material: Phong\ninput: { map: BumpMap, strength: 0.01, displacement: %s }\n",
             displacement);
    assert_true(document_open_text(&d, text));
    for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
        double near[3], far[3];
        for (int out = 0; out < 2; out++) {
            Point p = flat_point();
            for (int lane = 0; lane < 2; lane++)
                p.input[INPUT_U][lane] = p.input[INPUT_X][lane] =
                    places[k][lane] + (out ? copysignf(turns, places[k][lane]) : 0);
            float_normal(&d, making, &p, out ? far : near);
        }
        if (fabs(far[0] - near[0]) > 1e-6 || fabs(far[1] - near[1]) > 1e-6)
            fail_msg("--derivatives=%s, --aa=%s, %s at %g %g: %g %g %g, and %g turns out %g %g %g", making->derivatives,
                     making->aa, displacement, places[k][0], places[k][1], near[0], near[1], near[2], turns, far[0],
                     far[1], far[2]);
    }
    document_close(&d);
}

/* All maps that jump or are pictures repeat. Floats lie 1/2000 apart 4096 turns out, and 1/128 65536 turns out: a step of .005, or the fifth that
 * a texel is wide here, would be one tenth off, or lost. */
static void steps_are_as_wide_far_from_the_origin(void **state)
{
    (void)state;
    static const Making makings[] = {{"auto", "none", 2}, {"finite", "none", 2}};
    static const char *const displacements[] = {CHECKER,
                                                "{ map: VolumeChecker }",
                                                "{ map: Carpenter, noise: 0.2 }",
                                                "{ map: Mandel, iterations: 9 }",
                                                "{ map: Julia, iterations: 9 }",
                                                "{ map: ImageMap, image: %s }",
                                                "{ map: ImageMap, image: %s, address: mirror }"};
    for (size_t i = 0; i < sizeof displacements / sizeof *displacements; i++)
        for (int k = 0; k < 4; k++)
            steps_are_as_wide_far_out(displacements[i], &makings[k % 2], k < 2 ? 4096 : 65536);
}

/* The red of a document's diffuse, by the oracle. */
static double red_at(MatcDocument *document, const MatcOptions *options, double u, double v)
{
    char point[80];
    const char *fault;
    double red;
    snprintf(point, sizeof point, "u=%.17g v=%.17g", u, v);
    char *text = matc_eval(document, 0, point, options, &fault);
    assert_non_null(text);
    assert_int_equal(sscanf(strstr(text, "diffuse"), "diffuse %lf", &red), 1);
    free(text);
    return red;
}

/* A program's slope along u at a place is the map's rise over a step. */
static void rises_as_the_map(const char *map, double step, float u)
{
    static const Making making = {"auto", "none", 2};
    const float v = .30078125f;
    char text[400];
    double n[3];
    MatcOptions options;
    Document d;
    Point p = flat_point();
    matc_options_init(&options);
    options.pixels = true;
    snprintf(text, sizeof text, "material: Phong\ndiffuse: %s\n", map);
    MatcDocument *plain = matc_read("plain.yaml", text, strlen(text), &options);
    const double rise = red_at(plain, &options, u + step, v) - red_at(plain, &options, u, v);
    snprintf(text, sizeof text, "material: Phong\ninput: { map: BumpMap, strength: 0.01, displacement: %s }\n", map);
    assert_true(document_open_text(&d, text));
    p.input[INPUT_U][0] = u;
    p.input[INPUT_U][1] = v;
    float_normal(&d, &making, &p, n);
    if (fabs(-n[0] / n[2] - 0.02 * 0.01 * rise / step) > 1e-6)
        fail_msg("%s at %.9g: %g %g %g, should rise by %g over %g", map, (double)u, n[0], n[1], n[2], rise, step);
    document_close(&d);
    matc_document_free(plain);
}

/* A Carpenter is another one on either side of 0, and the same turn after turn. A step of .005 along u crosses 0 from -.002, and from nowhere
 * else: from -1.002 it crosses a whole number on one side, from -.007 none. A mirrored picture is the same after two turns. */
static void steps_end_where_the_map_is_another(void **state)
{
    (void)state;
    static const float places[] = {-.001953125f, -1.001953125f,    -2.001953125f, -7.001953125f, -4096.001953125f,
                                   -.0078125f,   -4096.376953125f, .373046875f,   1.998046875f,  4098.998046875f};
    static const char *const addresses[] = {"repeat", "mirror"};
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        rises_as_the_map("{ map: Carpenter, noise: 0.2 }", .005, places[i]);
        for (int k = 0; k < 2; k++) {
            char map[200];
            snprintf(map, sizeof map, "{ map: ImageMap, image: %s, address: %s }", picture, addresses[k]);
            rises_as_the_map(map, .2, places[i]);
        }
    }
}

/* A Blend along cos x, whose last item is at 1: in floats the cosine is 1 up to x = 2.4e-4, and the Blend falls there by 9000 sin x. Ten items
 * are searched, two are mixed, or walked. */
static void peaks_of_waves_at_the_last_item_have_slopes(void **state)
{
    (void)state;
    static const char *const blends[] = {
        "[{ value: 0, input: 0 }, { value: 1, input: 9000 }]",
        "[{ value: 0, input: 0 }, { value: 0.1, input: 900 }, { value: 0.2, input: 1800 }, { value: 0.3, input: 2700 },"
        " { value: 0.4, input: 3600 }, { value: 0.5, input: 4500 }, { value: 0.6, input: 5400 },"
        " { value: 0.7, input: 6300 }, { value: 0.8, input: 7200 }, { value: 1, input: 9000 }]"};
    static const char *const derivatives[] = {"auto", "analytic"};
    for (int i = 0; i < 8; i++) {
        char text[1000];
        Document d;
        snprintf(
            text, sizeof text,
            "material: Phong\ninput: { map: BumpMap, displacement: { map: Blend, blend: %s, input: { map: Gradient, "
            "waveForm: Cos } } }\n",
            blends[i / 4]);
        assert_true(document_open_text(&d, text));
        for (int k = -3; k <= 3; k++) {
            Point p = flat_point();
            double n[3];
            const float x = p.input[INPUT_X][0] = (float)k * 7e-5f;
            float_normal(&d, &(Making){derivatives[i % 2], "none", i & 2}, &p, n);
            if (fabs(n[0] / n[2] - 0.02 * 9000 * sin(x)) > 1e-6)
                fail_msg("%s, -O%d, %s at %g: %g %g %g", derivatives[i % 2], i & 2, blends[i / 4], (double)x, n[0],
                         n[1], n[2]);
        }
        document_close(&d);
    }
}

static bool says_flat(const char *displacement, const char *derivatives, int optimize)
{
    MatcOptions options;
    matc_options_init(&options);
    options.derivatives = derivatives;
    options.optimize = optimize;
    options.aa = "none"; /* a checker that is averaged has an edge as wide as the pixel, and with it a slope */
    MatcDocument *document = open(displacement, &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    assert_true(matc_ok(program));
    const char *said = matc_program_diagnostics(program, MATC_TEXT);
    const char *place = *displacement == '{' ? "relief.yaml:2:45" : "relief.yaml:2:38";
    bool says = !strncmp(said, place, strlen(place)) && strstr(said, "warning: this displacement rises nowhere");
    if (!says && *said)
        fail_msg("%s", said);
    matc_program_free(program);
    matc_document_free(document);
    return says;
}

static void what_has_no_slope_is_said(void **state)
{
    (void)state;
    static const struct {
        const char *displacement;
        bool finite, analytic, by_default;
    } cases[] = {
        {"0.5", true, true, true},
        {"{ map: ImageMap }", true, true, true},
        {"{ map: Granite, input: { map: Graytone } }", false, true, true},
        {CHECKER, false, true, false},
        {"{ map: Mandel }", false, true, false},
        {"{ map: Wood }", false, false, false},
        {RAMP(STEP("1, 0, 0")), false, false, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int level = 0; level < 3; level += 2) {
            const struct {
                const char *derivatives;
                bool flat;
            } ways[] = {{"finite", cases[i].finite}, {"analytic", cases[i].analytic}, {NULL, cases[i].by_default}};
            for (int k = 0; k < 3; k++)
                if (says_flat(cases[i].displacement, ways[k].derivatives, level) != ways[k].flat)
                    fail_msg("%s, %s, -O%d", cases[i].displacement,
                             ways[k].derivatives ? ways[k].derivatives : "default", level);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slopes_are_those_of_closed_forms),
        cmocka_unit_test(steps_are_as_wide_far_from_the_origin),
        cmocka_unit_test(steps_end_where_the_map_is_another),
        cmocka_unit_test(peaks_of_waves_at_the_last_item_have_slopes),
        cmocka_unit_test(what_has_no_slope_is_said),
    };
    return cmocka_run_group_tests(tests, make_picture, remove_picture);
}
