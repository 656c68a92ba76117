/* Slopes of displacements under each --derivatives, by closed forms: the oracle's normal at a
 * point, which test_value and test_stress compare with the programs. A displacement without a
 * slope is reported. */
#include "tests/test.h"
#include "compiler/matc.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STEP(x) "{ map: Gradient, direction: [" x "] }"
#define CHECKER "{ map: Checker }"
#define SCALED  "{ map: Checker, input: { map: UVTransform, scaleU: 8 } }"
#define TURNED  "{ map: Checker, input: { map: UVTransform, angle: 1.5707963267948966 } }"
#define RAMP(in)                                                                                   \
    "{ map: Blend, blend: [{ value: 0, input: 0 }, { value: 1, input: " STEP(                      \
        "0, 3, 0") " }], input: " in " }"

typedef struct {
    const char *derivatives, *displacement, *point;
    double by_u, by_v;
} Row;

/* The normal of the point is z, its tangents x and y, and so are those of the local position. A
 * checker rises by 1 over 0.05. */
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
    /* the colors' own slopes, and the step between them: 3 y and 1 at y = 2 */
    {"auto", "{ map: Checker, color1: " STEP("0, 3, 0") " }", "u=0.46 v=0.2 y=2", 120, 0},
    {"auto", "{ map: Checker, color1: " STEP("0, 3, 0") " }", "u=0.7 v=0.2 y=2", 0, 3},
    {"auto", "{ map: Checker, color1: " STEP("0, 3, 0") " }", "u=0.96 v=0.2 y=2", -120, 3},
    /* along a checker: between the Blends along 0 and 1; 1 is beyond the last item */
    {"auto", RAMP(CHECKER), "u=0.46 v=0.2 y=2", 120, 0},
    {"auto", RAMP(CHECKER), "u=0.96 v=0.2 y=2", -120, 3},
    {"auto", RAMP("{ map: UVTransform, input: " CHECKER " }"), "u=0.96 v=0.2 y=2", -120, 3},
    {"auto",
     RAMP("{ map: Checker, color1: " CHECKER
          ", color2: 0, input: { map: UVTransform, scaleU: 0.5 } }"),
     "u=0.46 v=0.2 y=2", 0, 0},
    /* halfway between a checker and 3 x, the weight rising by x: 1/2 (20 + 3) + (3 x - c), over
     * 1 */
    {"auto",
     "{ map: Blend, blend: [{ value: 0, input: " CHECKER
     " }, { value: 1, input: " STEP("3, 0, 0") " }] }",
     "u=0.46 v=0.2 x=0.5", 13, 0},
    /* unit cubes, a step of a tenth of them */
    {"auto", "{ map: VolumeChecker }", "x=0.95 y=0.2", 10, 0},
    {"auto", "{ map: VolumeChecker }", "x=0.85 y=0.95", 0, 10},
    {"finite", "{ map: VolumeChecker }", "x=0.95 y=0.2", 0, 0},
    /* from c = 4 frac x - 2 the one step leaves at 1.992 and stays at -1.988: from -1 to 1 over
     * .005; its square is 1 in both */
    {"auto", "{ map: Mandel, iterations: 1 }", "x=-0.002 y=0.5", 400, 0},
    {"auto", "{ map: Mandel, iterations: 1, waveForm: Sqr }", "x=-0.002 y=0.5", 0, 0},
    {"finite", "{ map: Mandel, iterations: 1 }", "x=-0.002 y=0.5", -1, -1},
    /* the mean of a checker at three points of u, 0.04 apart: two of them are less than a step
     * before the edge */
    {"auto", "{ map: Smooth3D, sx: 0.08, sy: 0, sz: 0, input: " CHECKER " }", "u=0.43 v=0.2",
     20.0 / 3, 0},
    {"finite", "0.5", "u=0.3", 0, 0},
};

static MatcDocument *open(const char *displacement, const MatcOptions *options)
{
    char text[2000];
    snprintf(text, sizeof text, "material: Phong\ninput: { map: BumpMap, displacement: %s }\n",
             displacement);
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
        assert_int_equal(sscanf(strstr(text, "normal"), "normal %lf %lf %lf", &n[0], &n[1], &n[2]),
                         3);
        const double by_u = -n[0] / n[2] / 0.02, by_v = -n[1] / n[2] / 0.02, bound = 1e-4;
        if (fabs(by_u - row->by_u) > bound || fabs(by_v - row->by_v) > bound)
            fail_msg("%s, %s at %s: %.9g %.9g, should be %g %g", row->derivatives,
                     row->displacement, row->point, by_u, by_v, row->by_u, row->by_v);
        free(text);
        matc_document_free(document);
    }
}

/* Whichever way the tangents turn, as mirrored texture coordinates make them, the normal stays on
 * its side and leans away from what rises. With heights a and b per unit of u and v, Tu = (s, 0, 0)
 * and Tv = (0, t, 0) the surface rises by a / s along x and b / t along y. */
static void normals_lean_out_of_their_side(void **state)
{
    (void)state;
#define SLOPE "{ map: BumpMap, displacement: " STEP("3, -2, 0") " }"
#define UNDER(scale)                                                                               \
    "{ map: BumpMap, displacement: " STEP("3, -2, 0") ", input: { map: UVTransform, " scale " } }"
/* 0.02 cos(2 pi u) / 2 pi */
#define WAVES "{ map: WaveMap, amplitude: 0.0031830988618379067, uCount: 1, vCount: 1 }"
    static const struct {
        const char *input, *point;
        double by_x, by_y, side;
    } cases[] = {
        {SLOPE, "dpxdu=1 dpydv=1 nz=1", 3, -2, 1},
        {SLOPE, "dpxdu=-1 dpydv=1 nz=1", -3, -2, 1},
        {SLOPE, "dpxdu=1 dpydv=-4 nz=1", 3, 0.5, 1},
        {SLOPE, "dpxdu=-1 dpydv=-1 nz=1", -3, 2, 1},
        {SLOPE, "dpxdu=1 dpydv=1 nz=-1", 3, -2, -1},
        {SLOPE, "dpxdu=-1 dpydv=1 nz=-1", -3, -2, -1},
        {SLOPE, "dpxdu=-1 dpydv=1 nz=25", -3, -2, 1},
        {UNDER("scaleU: -2"), "dpxdu=1 dpydv=1 nz=1", 3, -2, 1},
        {UNDER("scaleV: -0.5"), "dpxdu=-1 dpydv=1 nz=1", -3, -2, 1},
        {WAVES, "u=0.25 v=0 dpxdu=1 dpydv=1 nz=1", -1, 0, 1},
        {WAVES, "u=0.25 v=0 dpxdu=-1 dpydv=1 nz=1", 1, 0, 1},
        {WAVES, "u=0.25 v=0 dpxdu=1 dpydv=-1 nz=1", -1, 0, 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char source[1000];
        MatcOptions options;
        const char *fault;
        double n[3];
        matc_options_init(&options);
        snprintf(source, sizeof source, "material: Phong\ninput: %s\n", cases[i].input);
        MatcDocument *document = matc_read("relief.yaml", source, strlen(source), &options);
        char *text = matc_eval(document, 0, cases[i].point, &options, &fault);
        assert_non_null(text);
        assert_int_equal(sscanf(strstr(text, "normal"), "normal %lf %lf %lf", &n[0], &n[1], &n[2]),
                         3);
        const double height = fabs(n[2]), by_x = -n[0] / height / 0.02,
                     by_y = -n[1] / height / 0.02;
        if (!(fabs(by_x - cases[i].by_x) < 1e-4 && fabs(by_y - cases[i].by_y) < 1e-4 &&
              n[2] * cases[i].side > 0))
            fail_msg("%s at %s: %g %g %g", cases[i].input, cases[i].point, n[0], n[1], n[2]);
        free(text);
        matc_document_free(document);
    }
}

static bool says_flat(const char *displacement, const char *derivatives, int optimize)
{
    MatcOptions options;
    matc_options_init(&options);
    options.derivatives = derivatives;
    options.optimize = optimize;
    /* a checker that is averaged has an edge as wide as the pixel, and with it a slope */
    options.aa = "none";
    MatcDocument *document = open(displacement, &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    assert_true(matc_ok(program));
    const char *reported = matc_program_diagnostics(program, MATC_TEXT);
    const char *place = *displacement == '{' ? "relief.yaml:2:45" : "relief.yaml:2:38";
    bool says = !strncmp(reported, place, strlen(place)) &&
                strstr(reported, "warning: the displacement has zero slope everywhere");
    if (!says && *reported)
        fail_msg("%s", reported);
    matc_program_free(program);
    matc_document_free(document);
    return says;
}

static void what_has_no_slope_is_reported(void **state)
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
        {"{ map: Checker, color1: 0.5, color2: 0.5 }", true, true, true},
        {"{ map: Checker, color1: 0.5, color2: 0.4 }", false, true, false},
        {"{ map: Checker, color1: { map: Leopard, frequency: 0 }, color2: 0 }", true, true, true},
        {"{ map: Checker, color1: { map: Leopard }, color2: 0 }", false, false, false},
        /* along u alone */
        {"{ map: Checker, input: { map: UVTransform, scaleV: 0 } }", false, true, false},
        {RAMP(STEP("1, 0, 0")), false, false, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int level = 0; level < 3; level += 2) {
            const struct {
                const char *derivatives;
                bool flat;
            } ways[] = {{"finite", cases[i].finite},
                        {"analytic", cases[i].analytic},
                        {NULL, cases[i].by_default}};
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
        cmocka_unit_test(normals_lean_out_of_their_side),
        cmocka_unit_test(what_has_no_slope_is_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
