/* Slopes of displacements as programs compute them in floats: finite difference steps far from
 * the origin, and points exactly on the borders of a map. The reference is the same place near
 * the origin, or the oracle. */
#include "tests/test.h"
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

#define CHECKER "{ map: Checker }"

/* How a program is made. */
typedef struct {
    const char *derivatives, *aa;
    int optimize;
    const char *target; /* NULL: the default */
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
    options.target = making->target;
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
    enum { SIDE = 5, COMPONENTS = 3 };
    uint8_t bytes[SIDE * SIDE * COMPONENTS], *file;
    size_t size;
    const char *why;
    if (!mkdtemp(folder))
        return 1;
    snprintf(picture, sizeof picture, "%s/picture.png", folder);
    for (int i = 0; i < SIDE * SIDE * COMPONENTS; i++)
        bytes[i] = (uint8_t)(i / COMPONENTS * (i / COMPONENTS) * 89 + 40);
    file = png_write(&(PngPicture){SIDE, SIDE, COMPONENTS, bytes}, &size, &why);
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

/* Compares steps at places with those so many turns away; %s is the picture. */
static void steps_are_as_wide_far_out(const char *form, const Making *making, float turns)
{
    static const float places[][2] = {
        {1.375f, 1.484375f}, {-2.125f, -1.0078125f}, {3.4765625f, 2.9921875f}, {-.375f, .734375f}};
    char text[1000], displacement[500];
    Document d;
    snprintf(displacement, sizeof displacement, form, picture);
    snprintf(text, sizeof text,
             "material: Phong\ninput: { map: BumpMap, strength: 0.01, displacement: %s }\n",
             displacement);
    assert_true(document_open_text(&d, text));
    for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
        double near[3], far[3];
        for (int out = 0; out < 2; out++) {
            Point p = flat_point();
            for (int component = 0; component < 2; component++)
                p.input[INPUT_U][component] = p.input[INPUT_X][component] =
                    places[k][component] + (out ? copysignf(turns, places[k][component]) : 0);
            float_normal(&d, making, &p, out ? far : near);
        }
        if (fabs(far[0] - near[0]) > 1e-6 || fabs(far[1] - near[1]) > 1e-6)
            fail_msg("--derivatives=%s, --aa=%s, %s at %g %g: %g %g %g, and %g turns out %g %g %g",
                     making->derivatives, making->aa, displacement, places[k][0], places[k][1],
                     near[0], near[1], near[2], turns, far[0], far[1], far[2]);
    }
    document_close(&d);
}

/* All maps that jump or are pictures repeat. Floats lie 1/2000 apart 4096 turns out, and 1/128
 * 65536 turns out: a step of .005, or the fifth that a texel is wide here, would be one tenth off,
 * or lost. */
static void steps_are_as_wide_far_from_the_origin(void **state)
{
    (void)state;
    static const Making makings[] = {{"auto", "none", 2, NULL}, {"finite", "none", 2, NULL}};
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

/* GLSL 1.10 fetches no texels beside mipmaps, so the step of a picture that the sampler averages
 * stays beside its coordinate, whose last bits it takes: W |u| 2^-24 of the steepest slope for W
 * texels, as docs/reference/stability.md says. Other targets lose nothing. */
static void steps_of_the_sampler_are_as_wide_as_floats_tell(void **state)
{
    (void)state;
    enum { SIDE = 5 };
    static const struct {
        const char *target, *address;
        double lost; /* of that bound */
    } cases[] = {{"glsl110", "repeat", 1}, {"glsl330", "repeat", 0}, {"essl300", "mirror", 0}};
    static const float turns[] = {16, 1024, 65536};
    for (int i = 0; i < 9; i++) {
        const Making making = {"auto", "auto", 2, cases[i / 3].target};
        const double scale = 0.02 * 0.01, steepest = SIDE; /* from 0 to 1 over a texel */
        const double bound =
            cases[i / 3].lost * SIDE * turns[i % 3] * 0x1p-24 * steepest * scale + 1e-9;
        char text[400];
        double n[2][3];
        Document d;
        snprintf(text, sizeof text,
                 "material: Phong\ninput: { map: BumpMap, strength: 0.01, displacement: { map: "
                 "ImageMap, image: %s, "
                 "address: %s } }\n",
                 picture, cases[i / 3].address);
        assert_true(document_open_text(&d, text));
        for (int out = 0; out < 2; out++) {
            Point p = flat_point();
            p.input[INPUT_U][0] = 1.375f + (out ? turns[i % 3] : 0);
            p.input[INPUT_U][1] = 1.484375f + (out ? turns[i % 3] : 0);
            float_normal(&d, &making, &p, n[out]);
        }
        for (int component = 0; component < 2; component++)
            if (fabs(n[1][component] - n[0][component]) > bound)
                fail_msg("--target=%s, address: %s, %g turns out: off by %g, stated %g",
                         cases[i / 3].target, cases[i / 3].address, (double)turns[i % 3],
                         fabs(n[1][component] - n[0][component]), bound);
        document_close(&d);
    }
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
    static const Making making = {"auto", "none", 2, NULL};
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
    snprintf(text, sizeof text,
             "material: Phong\ninput: { map: BumpMap, strength: 0.01, displacement: %s }\n", map);
    assert_true(document_open_text(&d, text));
    p.input[INPUT_U][0] = u;
    p.input[INPUT_U][1] = v;
    float_normal(&d, &making, &p, n);
    if (fabs(-n[0] / n[2] - 0.02 * 0.01 * rise / step) > 1e-6)
        fail_msg("%s at %.9g: %g %g %g, should rise by %g over %g", map, (double)u, n[0], n[1],
                 n[2], rise, step);
    document_close(&d);
    matc_document_free(plain);
}

/* A Carpenter is another one on either side of 0, and the same turn after turn. A step of .005
 * along u crosses 0 from -.002, and from nowhere else: from -1.002 it crosses a whole number on one
 * side, from -.007 none. A mirrored picture is the same after two turns. */
static void steps_end_where_the_map_is_another(void **state)
{
    (void)state;
    static const float places[] = {
        -.001953125f, -1.001953125f,    -2.001953125f, -7.001953125f, -4096.001953125f,
        -.0078125f,   -4096.376953125f, .373046875f,   1.998046875f,  4098.998046875f};
    static const char *const addresses[] = {"repeat", "mirror"};
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        rises_as_the_map("{ map: Carpenter, noise: 0.2 }", .005, places[i]);
        for (int k = 0; k < 2; k++) {
            char map[200];
            snprintf(map, sizeof map, "{ map: ImageMap, image: %s, address: %s }", picture,
                     addresses[k]);
            rises_as_the_map(map, .2, places[i]);
        }
    }
}

/* A Blend along cos x, whose last item is at 1: in floats the cosine is 1 up to x = 2.4e-4, and the
 * Blend falls there by 9000 sin x. Ten items are searched, two are mixed, or walked. */
static void peaks_of_waves_at_the_last_item_have_slopes(void **state)
{
    (void)state;
    static const char *const blends[] = {
        "[{ value: 0, input: 0 }, { value: 1, input: 9000 }]",
        "[{ value: 0, input: 0 }, { value: 0.1, input: 900 }, { value: 0.2, input: 1800 }, { "
        "value: 0.3, input: 2700 },"
        " { value: 0.4, input: 3600 }, { value: 0.5, input: 4500 }, { value: 0.6, input: 5400 },"
        " { value: 0.7, input: 6300 }, { value: 0.8, input: 7200 }, { value: 1, input: 9000 }]"};
    static const char *const derivatives[] = {"auto", "analytic"};
    for (int i = 0; i < 8; i++) {
        char text[1000];
        Document d;
        snprintf(text, sizeof text,
                 "material: Phong\ninput: { map: BumpMap, displacement: { map: Blend, blend: %s, "
                 "input: { map: Gradient, "
                 "waveForm: Cos } } }\n",
                 blends[i / 4]);
        assert_true(document_open_text(&d, text));
        for (int k = -3; k <= 3; k++) {
            Point p = flat_point();
            double n[3];
            const float x = p.input[INPUT_X][0] = (float)k * 7e-5f;
            float_normal(&d, &(Making){derivatives[i % 2], "none", i & 2, NULL}, &p, n);
            if (fabs(n[0] / n[2] - 0.02 * 9000 * sin(x)) > 1e-6)
                fail_msg("%s, -O%d, %s at %g: %g %g %g", derivatives[i % 2], i & 2, blends[i / 4],
                         (double)x, n[0], n[1], n[2]);
        }
        document_close(&d);
    }
}

/* Slopes along u and v by the oracle. */
static void oracle_slopes(MatcDocument *document, const char *derivatives, double x,
                          double slope[2])
{
    MatcOptions options;
    char point[80];
    const char *fault;
    double n[3];
    matc_options_init(&options);
    options.derivatives = derivatives;
    snprintf(point, sizeof point, "x=%.17g y=0.3", x);
    char *text = matc_eval(document, 0, point, &options, &fault);
    assert_non_null(text);
    assert_int_equal(sscanf(strstr(text, "normal"), "normal %lf %lf %lf", &n[0], &n[1], &n[2]), 3);
    slope[0] = -n[0] / n[2] / 0.02;
    slope[1] = -n[1] / n[2] / 0.02;
    free(text);
}

/* Exactly at an item of a Blend the slope is that of the segment above it, which the item answers;
 * at the last item, that of the one below. What shows there on neither side has no part in it,
 * whatever the items cost. Widths of .3 and .7 have no exact reciprocals in floats. */
static void items_of_blends_have_slopes_of_a_side(void **state)
{
    (void)state;
    static const float at[] = {0, .3f, 1, 3};
    static const char *const inputs[] = {"{ value: 0, input: 3 }, { value: %.9g, input: 5 }, { "
                                         "value: 1, input: 6 }, { value: 3, input: 4 }",
                                         "{ value: 0, input: 3 }, { value: %.9g, input: 500 }, { "
                                         "value: 1, input: 6 }, { value: 3, input: 4 }",
                                         "{ value: 0, input: { map: VolumeTurbulence } }, { value: "
                                         "%.9g, input: { map: Leopard } }, { value: 1, input: "
                                         "{ map: Wood } }, { value: 3, input: { map: Granite } }",
                                         "{ value: 0, input: 3 }, { value: %.9g, input: { map: "
                                         "Smooth3D, input: { map: Leopard } } }, { value: 1, "
                                         "input: { map: Smooth3D, input: { map: Wood } } }, { "
                                         "value: 3, input: { map: VolumeTurbulence } }"};
    for (int i = 0; i < 16; i++) {
        const Making making = {i % 2 ? "analytic" : "auto", "none", i & 2, NULL};
        MatcOptions options;
        char items[400], text[600];
        Document d;
        matc_options_init(&options);
        snprintf(items, sizeof items, inputs[i / 4], (double)at[1]);
        snprintf(text, sizeof text,
                 "material: Phong\ninput: { map: BumpMap, displacement: { map: Blend, blend: [%s], "
                 "input: { map: "
                 "Gradient } } }\n",
                 items);
        assert_true(document_open_text(&d, text));
        MatcDocument *document = matc_read("blend.yaml", text, strlen(text), &options);
        for (int item = 0; item < 4; item++) {
            Point p = flat_point();
            double n[3], side[2];
            oracle_slopes(document, making.derivatives, at[item] + (item < 3 ? 1e-7 : -1e-7), side);
            p.input[INPUT_X][0] = at[item];
            p.input[INPUT_X][1] = 0.3f;
            float_normal(&d, &making, &p, n);
            for (int k = 0; k < 2; k++)
                if (fabs(-n[k] / n[2] / 0.02 - side[k]) > 1e-3)
                    fail_msg("-O%d --derivatives=%s, %s at item %d: %g, the side %g",
                             making.optimize, making.derivatives, items, item, -n[k] / n[2] / 0.02,
                             side[k]);
        }
        document_close(&d);
        matc_document_free(document);
    }
}

/* Two Blends that answer the same everywhere, of which one ends at 1, with the slope below, and one
 * goes on there, and is flat. Whichever comes first, their mean has the slope (5 - 3) / 2. */
static void blends_of_one_value_have_slopes_of_their_own(void **state)
{
    (void)state;
    static const char *const more[] = {"", ", { value: 2, input: 5 }"};
    for (int i = 0; i < 8; i++) {
        const Making making = {i & 1 ? "analytic" : "auto", "none", i & 2, NULL};
        char text[800];
        Document d;
        Point p = flat_point();
        double n[3];
        snprintf(text, sizeof text,
                 "material: Phong\n"
                 "input: { map: BumpMap, displacement: { map: Blend, input: 0.5, blend: [\n"
                 "  { value: 0, input: { map: Blend, blend: [{ value: 0, input: 3 }, { value: 1, "
                 "input: 5 }%s], input: "
                 "{ map: Gradient } } },\n"
                 "  { value: 1, input: { map: Blend, blend: [{ value: 0, input: 3 }, { value: 1, "
                 "input: 5 }%s], input: "
                 "{ map: Gradient } } }] } }\n",
                 more[i / 4], more[1 - i / 4]);
        assert_true(document_open_text(&d, text));
        p.input[INPUT_X][0] = 1;
        float_normal(&d, &making, &p, n);
        if (fabs(-n[0] / n[2] / 0.02 - 1) > 1e-4)
            fail_msg("-O%d --derivatives=%s: the slope %g is not 1 in\n%s", making.optimize,
                     making.derivatives, -n[0] / n[2] / 0.02, text);
        document_close(&d);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_are_as_wide_far_from_the_origin),
        cmocka_unit_test(steps_of_the_sampler_are_as_wide_as_floats_tell),
        cmocka_unit_test(steps_end_where_the_map_is_another),
        cmocka_unit_test(peaks_of_waves_at_the_last_item_have_slopes),
        cmocka_unit_test(items_of_blends_have_slopes_of_a_side),
        cmocka_unit_test(blends_of_one_value_have_slopes_of_their_own),
    };
    return cmocka_run_group_tests(tests, make_picture, remove_picture);
}
