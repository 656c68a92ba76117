/* The oracle against closed forms: coordinate transformers, normal modifiers, filters, and
 * textures. */
/* ctest: quick */
#include "tests/oracle_fixture.h"
#include "tests/value/documents.h"
#include <stdio.h>

static void test_uv_transform(void **state)
{
    (void)state;
    Builder b = {0};
    Node *map = build_node(&b, KIND_UVTransform);
    build_set(map, P_UVTransform_offsetU, 1);
    build_set(map, P_UVTransform_offsetV, 2);
    build_set(map, P_UVTransform_scaleU, 2);
    build_set(map, P_UVTransform_scaleV, 4);
    build_set(map, P_UVTransform_shear, .5);
    build_set(map, P_UVTransform_angle, M_PI / 2);
    Surface s = at_uv(3, 5); /* less the offset (2, 3); turned (3, -2) */
    expect(&b, map, U, &s, 2 * 3 - .5 * 4 * -2);
    expect(&b, map, V, &s, 4 * -2);
    expect(&b, map, DPXDU, &s, 0); /* the matrix is (2 2; -4 0), its inverse (0 -1/4; 1/2 1/4) */
    expect(&b, map, DPYDU, &s, .5);
    expect(&b, map, DPXDV, &s, -.25);
    expect(&b, map, DPYDV, &s, .25);
    build_set(map, P_UVTransform_scaleU, 0);
    expect(&b, map, U, &s, 4);
    for (int component = 0; component < 3; component++)
        expect(&b, map, DPXDU + component, &s, 0);
    build_free(&b);
}

/* A transformed texture coordinate reaches a map through `input`, twice. */
static void test_uv_transform_chain(void **state)
{
    (void)state;
    Builder b = {0};
    Node *outer = build_node(&b, KIND_UVTransform), *inner = build_node(&b, KIND_UVTransform);
    Node *checker = build_node(&b, KIND_Checker);
    build_set(outer, P_UVTransform_scaleU, 3);
    build_set(inner, P_UVTransform_offsetU, 2);
    build_link(outer, P_UVTransform_input, inner);
    build_link(checker, P_Checker_input, outer);
    Surface s = at_uv(2.2, 0);
    expect(&b, outer, U, &s, .6);
    expect(&b, outer, DPXDU, &s, 1. / 3);
    expect(&b, checker, R, &s, 1);
    build_free(&b);
}

static void expect_moved(const Transform *transform, bool global, const double p[3],
                         const double want[3])
{
    Builder b = {0};
    Node *map = build_node(&b, KIND_XYZTransform);
    build_set(map, P_XYZTransform_useGlobal, global);
    if (transform)
        *build_param(map, P_XYZTransform_transform) =
            (Value){.kind = VALUE_transform, .transform = transform};
    Surface s = at_xyz(p[0], p[1], p[2]);
    s.root[PX] = 7;
    for (int i = 0; i < 3; i++)
        expect(&b, map, X + i, &s, want[i]);
    expect(&b, map, NZ, &s, 1);
    expect(&b, map, PX, &s, 7);
    build_free(&b);
}

static void test_xyz_transform(void **state)
{
    (void)state;
    const double p[3] = {1, 2, 4};
    Transform scale = {.kind = TRANSFORM_scale, .scale = build_number(3)};
    Transform move = {.kind = TRANSFORM_translation,
                      .translation = build_components(3, 10, 20, 30, 0)};
    Transform matrix = {.kind = TRANSFORM_matrix,
                        .matrix = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 0, 1}};
    expect_moved(NULL, false, p, p);
    expect_moved(NULL, true, p, (double[]){7, 0, 0});
    expect_moved(&scale, false, p, (double[]){3, 6, 12});
    expect_moved(&scale, true, p, (double[]){21, 0, 0});
    expect_moved(&move, false, p, (double[]){11, 22, 34});
    expect_moved(&matrix, false, p, (double[]){21, 53, 85});
}

static Transform components(double rx, double ry, double rz)
{
    return (Transform){.kind = TRANSFORM_components,
                       .scale = build_components(3, 1, 1, 1, 0),
                       .translation = build_components(3, 0, 0, 0, 0),
                       .rotation = build_components(3, rx, ry, rz, 0),
                       .shear = build_components(3, 0, 0, 0, 0)};
}

static void test_xyz_components(void **state)
{
    (void)state;
    const double quarter = M_PI / 2;
    Transform x = components(quarter, 0, 0), y = components(0, quarter, 0),
              z = components(0, 0, quarter);
    Transform yz = components(0, quarter, quarter), all = components(0, 0, quarter);
    expect_moved(&x, false, (double[]){1, 2, 3}, (double[]){1, -3, 2});
    expect_moved(&y, false, (double[]){1, 2, 3}, (double[]){3, 2, -1});
    expect_moved(&z, false, (double[]){1, 2, 3}, (double[]){-2, 1, 3});
    expect_moved(&yz, false, (double[]){1, 2, 3}, (double[]){-2, 3, -1}); /* about y first */
    all.translation = build_components(3, 1, 2, 3, 0);
    all.scale = build_components(3, 2, 3, 4, 0);
    all.shear = build_components(3, .5, .25, -1, 0);
    /* sheared (3, -2, 4), scaled (6, -6, 16), turned (6, 6, 16) */
    expect_moved(&all, false, (double[]){1, 2, 4}, (double[]){7, 8, 19});
}

/* A bump by the step of a checker: slope 20, and 0.02 strength of it along the normal, whatever the
 * normal's length. */
/* Within what differences over steps of 2^-26 err by. */
static void expect_slope(const Builder *b, const Node *map, int channel, const Surface *surface,
                         double want)
{
    close_to(value_at(b, map, channel, surface), want, 1e-6);
}

static void test_bump(void **state)
{
    (void)state;
    Builder b = {0};
    Node *bump = build_node(&b, KIND_BumpMap);
    build_link(bump, P_BumpMap_displacement, build_node(&b, KIND_Checker));
    build_set(bump, P_BumpMap_strength, 2);
    Surface s = at_uv(.46, .1);
    s.root[NZ] = 2;
    expect_slope(&b, bump, DPXDU, &s, 1);
    expect_slope(&b, bump, DPZDU, &s, .8);
    expect_slope(&b, bump, DPZDV, &s, 0);
    expect_slope(&b, bump, NX, &s, -.8);
    expect_slope(&b, bump, NY, &s, 0);
    expect_slope(&b, bump, NZ, &s, 1);
    s.root[NZ] = 0;
    expect_slope(&b, bump, NZ, &s, 1);
    build_link(bump, P_BumpMap_displacement, build_gradient(&b, 1, 0, 0));
    s = at_xyz(10, 0, 0);
    expect_slope(&b, bump, DPZDU, &s, .04);
    expect_slope(&b, bump, DPZDV, &s, 0);
    build_free(&b);
}

static void test_wave_map(void **state)
{
    (void)state;
    Builder b = {0};
    Node *map = build_node(&b, KIND_WaveMap);
    build_set(map, P_WaveMap_amplitude, .1);
    build_set(map, P_WaveMap_uCount, 1);
    build_set(map, P_WaveMap_vCount, 2);
    Surface u = at_uv(.25, 0), v = at_uv(0, .125), top = at_uv(5. / 16, 1. / 3),
            beside = at_uv(.1, .5);
    expect(&b, map, DPZDU, &u, -.2 * M_PI);
    expect(&b, map, NX, &u, .2 * M_PI);
    expect(&b, map, NZ, &u, 1);
    expect(&b, map, NY, &v, .4 * M_PI);
    build_set(map, P_WaveMap_boxTop, 1);
    expect(&b, map, NX, &top, .8 * M_PI);
    expect(&b, map, NX, &beside, 0);
    expect(&b, map, DPZDU, &beside, 0);
    build_free(&b);
}

static Node *build_square(Builder *b)
{
    Node *gradient = build_gradient(b, 1, 0, 0);
    *build_param(gradient, P_Gradient_waveForm) =
        (Value){.kind = VALUE_wave, .wave = build_wave(b, WAVE_Sqr)};
    return gradient;
}

static void test_smooth(void **state)
{
    (void)state;
    Builder b = {0};
    Node *smooth = build_node(&b, KIND_Smooth3D), *outer = build_node(&b, KIND_Smooth3D);
    Surface s = at_xyz(3, 4, 5);
    s.root[PX] = 6;
    expect(&b, smooth, X, &s, 3);
    expect(&b, smooth, PX, &s, 6);
    expect(&b, smooth, NZ, &s, 1);
    expect(&b, smooth, A, &s, 1);
    build_link(smooth, P_Smooth3D_input, build_gradient(&b, 1, 2, 3));
    expect(&b, smooth, G, &s, 3 + 8 + 15);
    build_link(smooth, P_Smooth3D_input, build_square(&b));
    build_set(smooth, P_Smooth3D_sx, 2);
    expect(&b, smooth, R, &s, 9 + 4. / 6); /* the mean of x^2 at -s/2, 0, s/2 is s^2/6 more */
    build_link(outer, P_Smooth3D_input, smooth);
    expect(&b, outer, R, &s, 9 + 4. / 6 + 1. / 6);
    expect(&b, smooth, X, &s, 9 + 4. / 6);
    build_free(&b);
}

static void test_smooth_uv(void **state)
{
    (void)state;
    Builder b = {0};
    Node *smooth = build_node(&b, KIND_Smooth3D);
    build_link(smooth, P_Smooth3D_input, build_node(&b, KIND_Checker));
    build_set(smooth, P_Smooth3D_sx, .1);
    build_set(smooth, P_Smooth3D_sy, .1);
    Surface s = at_uv(.5, .5); /* two of three columns, and of three rows, lie beyond the edge */
    expect(&b, smooth, R, &s, 4. / 9);
    build_free(&b);
}

static void test_laplace(void **state)
{
    (void)state;
    Builder b = {0};
    Node *laplace = build_node(&b, KIND_Laplace3D);
    Surface s = at_xyz(3, 4, 5);
    expect(&b, laplace, X, &s, 0);
    expect(&b, laplace, NZ, &s, 0);
    expect(&b, laplace, A, &s, 1);
    build_link(laplace, P_Laplace3D_input, build_square(&b));
    build_set(laplace, P_Laplace3D_sx, 2);
    expect(&b, laplace, R, &s, -4. / 24);
    build_free(&b);
}

/* Two by two texels: bottom row (0, 51, 102, 255) (255, 0, 0, 0), top row (102, ...) (204, ...). */
static Node *build_image(Builder *b, Image *image, bool bilinear)
{
    static uint8_t bytes[] = {0, 51, 102, 255, 255, 0, 0, 0, 102, 0, 0, 0, 204, 0, 0, 0};
    Node *map = build_node(b, KIND_ImageMap);
    *image = (Image){.path = "", .width = 2, .height = 2, .bits = 8, .texels = bytes};
    *build_param(map, P_ImageMap_image) = (Value){.kind = VALUE_image, .image = image};
    build_set(map, P_ImageMap_bilinearFiltering, bilinear);
    return map;
}

static void test_image_nearest(void **state)
{
    (void)state;
    Builder b = {0};
    Image image;
    const Node *map = build_image(&b, &image, false);
    Surface low = at_uv(.25, .25), right = at_uv(-.25, 3.25), high = at_uv(.1, .75);
    expect(&b, map, R, &low, 0);
    expect(&b, map, G, &low, .2);
    expect(&b, map, Z, &low, .4);
    expect(&b, map, A, &low, 1);
    expect(&b, map, R, &right, 1);
    expect(&b, map, A, &right, 0);
    expect(&b, map, R, &high, .4);
    expect(&b, map, DPXDU, &low, 1 / .5);
    expect(&b, map, DPYDU, &low, -.2 / .5);
    expect(&b, map, DPXDV, &low, .4 / .5);
    image.width = 1;
    image.height = 4; /* the step is a texel of its own side */
    expect(&b, map, DPXDV, &low, (.4 - 1) / .25);
    expect(&b, map, DPXDU, &low, 0);
    build_free(&b);
}

static void test_image_bilinear(void **state)
{
    (void)state;
    Builder b = {0};
    Image image;
    const Node *map = build_image(&b, &image, true), *none = build_node(&b, KIND_ImageMap);
    Surface corner = at_uv(0, 0), half = at_uv(.25, 0), wrapped = at_uv(.75, 0),
            middle = at_uv(.25, .25);
    expect(&b, map, R, &corner, 0);
    expect(&b, map, R, &half, .5);
    expect(&b, map, R, &wrapped, .5);
    expect(&b, map, R, &middle, (0 + 1 + .4 + .8) / 4);
    expect(&b, none, G, &middle, .5);
    expect(&b, none, A, &middle, 1);
    expect(&b, none, DPXDU, &middle, 0);
    build_free(&b);
}

/* Along u the bottom row's red is 0 and 1, a texel 1/2 wide: by hand. */
static void test_image_address(void **state)
{
    (void)state;
    static const struct {
        Keyword address;
        double u, smooth, nearest, alpha; /* alpha: of the four */
    } rows[] = {
        {KEYWORD_Address_repeat, 1.25, .5, 0, .5},  {KEYWORD_Address_repeat, -.25, .5, 1, .5},
        {KEYWORD_Address_mirror, .75, 1, 1, 0},     {KEYWORD_Address_mirror, 1.25, .5, 1, .5},
        {KEYWORD_Address_mirror, 1.5, 0, 0, 1},     {KEYWORD_Address_mirror, 1.75, 0, 0, 1},
        {KEYWORD_Address_mirror, -.25, 0, 0, 1},    {KEYWORD_Address_mirror, -.75, .5, 1, .5},
        {KEYWORD_Address_mirror, -2.25, 0, 0, 1},   {KEYWORD_Address_mirror, -1e6 - .25, 0, 0, 1},
        {KEYWORD_Address_clamp, .75, 1, 1, 0},      {KEYWORD_Address_clamp, 7.3, 1, 1, 0},
        {KEYWORD_Address_clamp, -.25, 0, 0, 1},     {KEYWORD_Address_clamp, -1e30, 0, 0, 1},
        {KEYWORD_Address_border, .25, .5, 0, .5},   {KEYWORD_Address_border, .625, .75, 1, 0},
        {KEYWORD_Address_border, -.125, 0, 0, .75}, {KEYWORD_Address_border, .875, .25, 1, 0},
        {KEYWORD_Address_border, 1.125, 0, 0, 0},   {KEYWORD_Address_border, -.625, 0, 0, 0},
        {KEYWORD_Address_border, 1e30, 0, 0, 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        Builder b = {0};
        Image image;
        Node *smooth = build_image(&b, &image, true), *nearest = build_image(&b, &image, false);
        build_set(smooth, P_ImageMap_address, rows[i].address);
        build_set(nearest, P_ImageMap_address, rows[i].address);
        Surface s = at_uv(rows[i].u, 0);
        expect(&b, smooth, R, &s, rows[i].smooth);
        expect(&b, smooth, A, &s, rows[i].alpha);
        expect(&b, nearest, R, &s, rows[i].nearest);
        build_free(&b);
    }
}

/* A texel in the middle of its square, by hand: along u the bottom row's red is 0 at 1/4 and 1 at
 * 3/4, along v 0 and .4. */
static void test_image_centres(void **state)
{
    (void)state;
    static const struct {
        Keyword address;
        double u, v, value, nearest;
    } rows[] = {
        {KEYWORD_Address_repeat, .25, .75, .4, .4}, {KEYWORD_Address_repeat, .375, .25, .25, 0},
        {KEYWORD_Address_repeat, 0, .25, .5, 0},    {KEYWORD_Address_repeat, .25, .5, .2, .4},
        {KEYWORD_Address_mirror, 0, .25, 0, 0},     {KEYWORD_Address_mirror, 1.125, .25, 1, 1},
        {KEYWORD_Address_clamp, .125, .25, 0, 0},   {KEYWORD_Address_border, .875, .25, .75, 1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        Builder b = {0};
        Image image;
        Node *smooth = build_image(&b, &image, true), *nearest = build_image(&b, &image, false);
        build_set(smooth, P_ImageMap_address, rows[i].address);
        build_set(nearest, P_ImageMap_address, rows[i].address);
        build_set(smooth, P_ImageMap_texels, KEYWORD_Texels_centre);
        build_set(nearest, P_ImageMap_texels, KEYWORD_Texels_centre);
        const Surface s = at_uv(rows[i].u, rows[i].v);
        expect(&b, smooth, R, &s, rows[i].value);
        expect(&b, nearest, R, &s, rows[i].nearest);
        build_free(&b);
    }
}

static void test_carpenter(void **state)
{
    (void)state;
    Builder b = {0};
    Node *map = build_node(&b, KIND_Carpenter), *flat = build_node(&b, KIND_Carpenter);
    build_set(flat, P_Carpenter_noise, 0);
    build_set(map, P_Carpenter_width, 16);
    build_set(map, P_Carpenter_height, 16);
    Surface corner = at_uv(0, 0), s = at_uv(.3, .4), step = at_uv(.305, .4);
    expect(&b, map, R, &corner, .5);
    expect(&b, flat, G, &s, .5);
    expect(&b, flat, DPXDV, &s, 0);
    expect(&b, map, A, &s, 1);
    double here = value_at(&b, map, B, &s);
    expect(&b, map, DPYDU, &s, (value_at(&b, map, B, &step) - here) / .005);
    build_set(map, P_Carpenter_seed, 5);
    assert_true(fabs(value_at(&b, map, B, &s) - here) > 1e-6);
    build_free(&b);
}

/* A stair has no slope, and differences over its steps have its mean: they tell none. A smooth
 * height's do. */
static void test_rough_slopes(void **state)
{
    (void)state;
    static const struct {
        const char *height;
        double x;
        bool rough;
    } cases[] = {
        {"{ map: Gradient, direction: [1, 0, 0], waveForm: Sin }", 0.3, false},
        {"{ map: Gradient, direction: [1000000, 0, 0], waveForm: Sin }", 0.3, false},
        {"{ map: Gradient, direction: [1, 0, 0], waveForm: Ceil }", 0.3, false},
        {"{ map: Gradient, direction: [1, 0, 0], waveForm: Ceil }", 2, true},
        {"{ map: Gradient, direction: [1000000000, 0, 0], waveForm: Ceil }", 0.3, true},
        {"{ map: Gradient, direction: [10000000000000, 0, 0], waveForm: Ceil }", 0.3, true},
        {"{ map: Gradient, direction: [1, 0, 0], waveForm: Sin }", 1e8, true},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[512];
        Document d;
        Surface s;
        SlotValues values;
        snprintf(text, sizeof text, "material: Phong\ninput: { map: BumpMap, displacement: %s }\n",
                 cases[i].height);
        assert_true(document_open_text(&d, text));
        Oracle *oracle = oracle_open(d.graph, &(ReferenceContext){.noise = REFERENCE_LATTICE});
        oracle_derivatives(oracle, CHOICE_derivatives_analytic);
        oracle_judge_slopes(oracle, true);
        oracle_surface_default(&s);
        s.root[X] = cases[i].x;
        s.local_u[0] = 1;
        assert_true(oracle_material(oracle, d.graph->materials[0].node, &s, &values));
        if (oracle_slopes_rough(oracle) != cases[i].rough)
            fail_msg("%s at x = %g", cases[i].height, cases[i].x);
        assert_false(oracle_slopes_rough(oracle));
        oracle_close(oracle);
        document_close(&d);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_uv_transform),  cmocka_unit_test(test_uv_transform_chain),
        cmocka_unit_test(test_xyz_transform), cmocka_unit_test(test_xyz_components),
        cmocka_unit_test(test_bump),          cmocka_unit_test(test_wave_map),
        cmocka_unit_test(test_smooth),        cmocka_unit_test(test_smooth_uv),
        cmocka_unit_test(test_laplace),       cmocka_unit_test(test_image_nearest),
        cmocka_unit_test(test_image_address), cmocka_unit_test(test_image_bilinear),
        cmocka_unit_test(test_image_centres), cmocka_unit_test(test_carpenter),
        cmocka_unit_test(test_rough_slopes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
