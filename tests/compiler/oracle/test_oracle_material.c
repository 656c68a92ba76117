/* The oracle against closed forms: check values of the noise maps, and the rules of the
 * materials. */
/* ctest: quick */
#include "tests/oracle_fixture.h"

/* the check values of semantics.md have six digits after the point */
static const double PRINTED = 2e-6;

static Surface check_point(void) { return at_xyz(.25, .5, .75); }

static void expect_near(const Builder *b, const Node *map, int channel, double want)
{
    Surface s = check_point();
    close_to(value_at(b, map, channel, &s), want, PRINTED);
}

static void test_turbulence(void **state)
{
    (void)state;
    Builder b = {0};
    Node *map = build_node(&b, KIND_Turbulence);
    build_set3(map, P_Turbulence_amount, 1, .5, 2);
    expect_near(&b, map, X, .25 + 8.515307);
    expect_near(&b, map, Y, .5 + 8.641798 / 2);
    close_to(value_at(&b, map, Z, &(Surface){.root[X] = .25, .root[Y] = .5, .root[Z] = .75}),
             .75 - 2 * 2.514515, 4e-6);
    build_set(map, P_Turbulence_octaves, -3);
    expect_near(&b, map, X, .25 + .151588);
    build_set(map, P_Turbulence_octaves, 10);
    Surface s = check_point();
    double ten = value_at(&b, map, X, &s);
    build_set(map, P_Turbulence_octaves, 100);
    expect(&b, map, X, &s, ten);
    build_free(&b);
}

/* Displaces the triple that is asked for: (u, v, w) as (x, y, z) of the same numbers. */
static void test_turbulence_uv(void **state)
{
    (void)state;
    Builder b = {0};
    const Node *map = build_node(&b, KIND_Turbulence);
    Surface uv = at_uv(.3, .6), xyz = at_xyz(.3, .6, 0);
    for (int component = 0; component < 3; component++)
        expect(&b, map, U + component, &uv, value_at(&b, map, X + component, &xyz));
    build_free(&b);
}

static void test_volume_turbulence(void **state)
{
    (void)state;
    Builder b = {0};
    Node *map = build_node(&b, KIND_VolumeTurbulence);
    expect_near(&b, map, R, 2.173850);
    build_set(map, P_VolumeTurbulence_noiseRatio, .5);
    expect_near(&b, map, DPXDU, .529139);
    build_set(map, P_VolumeTurbulence_octaves, 0);
    expect_near(&b, map, X, .303176);
    build_set(map, P_VolumeTurbulence_size, 2);
    Surface s = check_point();
    double second = value_at(&b, map, R, &s);
    build_set(map, P_VolumeTurbulence_size, 1);
    build_set(map, P_VolumeTurbulence_octaves, 2);
    build_set(map, P_VolumeTurbulence_noiseRatio, -4); /* strong octaves: divided by 4 */
    expect_near(&b, map, R, .303176 / 4 - second);
    build_free(&b);
}

static void test_volume_functions(void **state)
{
    (void)state;
    Builder b = {0};
    Node *wood = build_node(&b, KIND_Wood), *leopard = build_node(&b, KIND_Leopard);
    Node *mandel = build_node(&b, KIND_Mandel), *julia = build_node(&b, KIND_Julia);
    expect_near(&b, build_node(&b, KIND_Granite), G, .411586);
    Surface s = at_xyz(3, -4, 9), half = at_xyz(.5, .5, 0), corner = at_xyz(.01, .01, 0),
            ones = at_xyz(1.5, 1.5, 1.5), tip = at_xyz(0, .5, 0), one = at_xyz(.75, .5, 0);
    expect(&b, wood, R, &s, 5);
    expect(&b, wood, A, &s, 1);
    expect(&b, leopard, R, &ones, sin(1.5) * sin(1.5));
    expect(&b, mandel, R, &half, 1);    /* c = 0 stays at 0 */
    expect(&b, mandel, R, &corner, -1); /* escapes at once */
    expect(&b, mandel, R, &tip, 1);     /* c = -2: z is -2, 2, 2, ..., and 2 has not escaped */
    expect(&b, mandel, R, &one, -.8);   /* c = 1: z is 1, 2, 5: one step of ten */
    build_set(julia, P_Julia_cx, -2);
    build_set(julia, P_Julia_cy, 0);
    expect(&b, julia, R, &half, 1);
    build_set(julia, P_Julia_cx, 0);
    expect(&b, julia, R, &half, 1);
    build_set(julia, P_Julia_cx, 1); /* 0, 1, 2, 5: two steps of ten do not escape */
    expect(&b, julia, R, &half, -.6);
    build_free(&b);
}

static SlotValues slots_at(const Builder *b, const Node *material, const Surface *surface)
{
    SlotValues values;
    Oracle *oracle = oracle_open(&b->graph, &groimp);
    oracle_material(oracle, material, surface, &values);
    oracle_close(oracle);
    return values;
}

static void expect1(const SlotValues *values, Slot slot, double want)
{
    close_to(values->component[slot][0], want, 1e-12);
}

static void expect3(const SlotValues *values, Slot slot, double x, double y, double z)
{
    close_to(values->component[slot][0], x, 1e-12);
    close_to(values->component[slot][1], y, 1e-12);
    close_to(values->component[slot][2], z, 1e-12);
}

/* Slots that only a Phong can change. */
static void expect_plain(const SlotValues *v)
{
    expect1(v, SLOT_alpha, 1);
    expect3(v, SLOT_specular, 0, 0, 0);
    expect1(v, SLOT_shininess, 4);
    expect1(v, SLOT_transparencyShininess, 65504);
    expect1(v, SLOT_interpolatedTransparency, 1);
    expect3(v, SLOT_diffuseTransparency, 0, 0, 0);
    expect3(v, SLOT_ambient, 0, 0, 0);
    expect1(v, SLOT_ior, 1);
}

static void test_phong_defaults(void **state)
{
    (void)state;
    Builder b = {0};
    Surface s = at_uv(0, 0);
    SlotValues v = slots_at(&b, build_node(&b, KIND_Phong), &s);
    expect_plain(&v);
    expect3(&v, SLOT_normal, 0, 0, 1);
    expect3(&v, SLOT_diffuse, .5, .5, .5);
    expect3(&v, SLOT_transparency, 0, 0, 0);
    expect3(&v, SLOT_emissive, 0, 0, 0);
    build_free(&b);
}

static void test_phong_maps(void **state)
{
    (void)state;
    Builder b = {0};
    Node *phong = build_node(&b, KIND_Phong);
    build_link(phong, P_Phong_diffuse, build_constant(&b, build_components(4, 2, 3, 4, .25)));
    build_link(phong, P_Phong_transparency, build_constant(&b, build_components(3, 0, .5, 1, 0)));
    build_link(phong, P_Phong_shininess, build_constant(&b, build_components(3, .5, 1, 1, 0)));
    build_link(phong, P_Phong_transparencyShininess, build_constant(&b, build_number(1)));
    build_link(phong, P_Phong_emissive, build_gradient(&b, 1, 0, 0));
    build_set(phong, P_Phong_interpolatedTransparency, 0);
    Surface s = at_xyz(8, 0, 0);
    SlotValues v = slots_at(&b, phong, &s);
    expect3(&v, SLOT_diffuse, 2, 3, 4);
    expect1(&v, SLOT_alpha, .25);
    expect3(&v, SLOT_transparency, .75, .875, 1);
    expect1(&v, SLOT_shininess, -2 / log(.75));
    expect1(&v, SLOT_transparencyShininess, 65504);
    expect3(&v, SLOT_emissive, 8, 8, 8);
    expect1(&v, SLOT_interpolatedTransparency, 0);
    build_free(&b);
}

/* `input` gives the normal and the ratio of indices, and nothing to the other maps. */
static void test_phong_input(void **state)
{
    (void)state;
    Builder b = {0};
    Node *phong = build_node(&b, KIND_Phong);
    build_link(phong, P_Phong_input, build_constant(&b, build_components(3, 3, 0, 4, 0)));
    /* color and alpha of the surface: 0 */
    build_link(phong, P_Phong_diffuse, build_node(&b, KIND_UVTransform));
    Surface s = at_uv(0, 0);
    SlotValues v = slots_at(&b, phong, &s);
    expect3(&v, SLOT_normal, .6, 0, .8);
    expect1(&v, SLOT_ior, 3);
    expect3(&v, SLOT_diffuse, 0, 0, 0);
    expect1(&v, SLOT_alpha, 0);
    expect3(&v, SLOT_transparency, 1, 1, 1);
    s.front = false;
    v = slots_at(&b, phong, &s);
    expect3(&v, SLOT_normal, -.6, 0, -.8);
    build_free(&b);
}

static Node *build_rgba(Builder *b, double red)
{
    Node *rgba = build_node(b, KIND_RGBA);
    build_set(rgba, P_RGBA_r, red);
    return rgba;
}

static void test_rgba(void **state)
{
    (void)state;
    Builder b = {0};
    Node *rgba = build_rgba(&b, 2);
    build_set(rgba, P_RGBA_a, .25);
    Surface s = at_uv(0, 0);
    s.root[NX] = 1;
    s.root[NZ] = 0;
    SlotValues v = slots_at(&b, rgba, &s);
    expect_plain(&v);
    expect3(&v, SLOT_normal, 1, 0, 0);
    expect3(&v, SLOT_diffuse, 2, .5, .5);
    expect3(&v, SLOT_transparency, .75, .75, .75);
    build_free(&b);
}

/* Red of a material's diffuse color, seen from one side. */
static double red_of(const Builder *b, const Node *material, bool front)
{
    Surface s = at_uv(0, 0);
    s.front = front;
    return slots_at(b, material, &s).component[SLOT_diffuse][0];
}

static void test_side_switch(void **state)
{
    (void)state;
    Builder b = {0};
    Node *sides = build_node(&b, KIND_SideSwitch), *outer = build_node(&b, KIND_SideSwitch);
    const double gray = 128. / 255;
    close_to(red_of(&b, sides, true), gray, 0);
    close_to(red_of(&b, sides, false), gray, 0);
    build_link(sides, P_SideSwitch_frontShader, build_rgba(&b, 2));
    close_to(red_of(&b, sides, true), 2, 0);
    close_to(red_of(&b, sides, false), 2, 0);
    build_link(sides, P_SideSwitch_backShader, build_rgba(&b, 3));
    close_to(red_of(&b, sides, false), 3, 0);
    build_link(outer, P_SideSwitch_backShader, sides);
    close_to(red_of(&b, outer, false), 3, 0);
    close_to(red_of(&b, outer, true), gray, 0); /* a missing front is not the back */
    build_free(&b);
}

/* From 0.25 of a: colors linearly, the normal by directions, exponents by (2 / (n + 2))^(1/4). */
static void test_mix(void **state)
{
    (void)state;
    Builder b = {0};
    Node *mix = build_node(&b, KIND_MixMaterial), *first = build_node(&b, KIND_Phong),
         *second = build_node(&b, KIND_Phong);
    Surface s = at_uv(0, 0);
    close_to(red_of(&b, mix, true), 128. / 255, 0);
    build_link(mix, P_MixMaterial_a, first);
    build_link(mix, P_MixMaterial_b, second);
    build_link(mix, P_MixMaterial_mask, build_constant(&b, build_components(3, .25, 9, 9, 0)));
    build_link(first, P_Phong_input, build_constant(&b, build_components(3, 3, 0, 0, 0)));
    build_link(second, P_Phong_input, build_constant(&b, build_components(3, 0, 0, 7, 0)));
    build_link(first, P_Phong_diffuse, build_constant(&b, build_components(4, 2, 3, 4, .5)));
    build_link(second, P_Phong_shininess, build_constant(&b, build_number(1)));
    SlotValues v = slots_at(&b, mix, &s);
    const double size = sqrt(.75 * .75 + .25 * .25);
    expect3(&v, SLOT_normal, .75 / size, 0, .25 / size);
    expect3(&v, SLOT_diffuse, 1.625, 2.375, 3.125);
    expect1(&v, SLOT_alpha, .625);
    expect3(&v, SLOT_transparency, .375, .375, .375);
    const double r = .75 * pow(2. / 6, .25) + .25 * pow(2. / 65506, .25);
    expect1(&v, SLOT_shininess, 2 / pow(r, 4) - 2);
    s.front = false;
    v = slots_at(&b, mix, &s);
    expect3(&v, SLOT_normal, -.75 / size, 0, -.25 / size);
    s.front = true;
    build_link(mix, P_MixMaterial_mask, build_constant(&b, build_number(-3)));
    v = slots_at(&b, mix, &s);
    expect3(&v, SLOT_diffuse, 2, 3, 4);
    expect1(&v, SLOT_shininess, 4);
    build_link(mix, P_MixMaterial_mask, build_constant(&b, build_number(3)));
    v = slots_at(&b, mix, &s);
    close_to(v.component[SLOT_shininess][0], 65504, 1e-9);
    build_free(&b);
}

static void test_algorithm_switch(void **state)
{
    (void)state;
    Builder b = {0};
    Node *algorithm = build_node(&b, KIND_AlgorithmSwitch);
    close_to(red_of(&b, algorithm, true), 128. / 255, 0);
    build_link(algorithm, P_AlgorithmSwitch_radiationShader, build_rgba(&b, 2));
    close_to(red_of(&b, algorithm, true), 2, 0);
    build_link(algorithm, P_AlgorithmSwitch_raytracerShader, build_rgba(&b, 3));
    close_to(red_of(&b, algorithm, true), 3, 0);
    build_link(algorithm, P_AlgorithmSwitch_guiShader, build_rgba(&b, 4));
    close_to(red_of(&b, algorithm, true), 4, 0);
    build_free(&b);
}

static void test_sky(void **state)
{
    (void)state;
    Builder b = {0};
    Node *sky = build_node(&b, KIND_SunSkyLight);
    Surface up = at_xyz(1, 2, 3), far = at_xyz(10, 20, 30), down = at_xyz(1, 2, -.1);
    SlotValues v = slots_at(&b, sky, &up);
    expect_plain(&v);
    expect3(&v, SLOT_diffuse, 0, 0, 0);
    expect3(&v, SLOT_transparency, 0, 0, 0);
    const double *light = v.component[SLOT_emissive];
    assert_true(light[0] > 0 && light[1] > 0 && light[2] > 0);
    SlotValues w = slots_at(&b, sky, &far);
    expect3(&w, SLOT_emissive, light[0], light[1], light[2]);
    build_set(sky, P_SunSkyLight_radianceFactor, 2);
    w = slots_at(&b, sky, &up);
    expect3(&w, SLOT_emissive, 2 * light[0], 2 * light[1], 2 * light[2]);
    w = slots_at(&b, sky, &down);
    expect3(&w, SLOT_emissive, 0, 0, 0);
    build_free(&b);
}

/* An oracle remembers the sky that it was asked for last: others, by any one of their numbers, are
 * themselves, in whatever order. */
static void test_skies_in_turn(void **state)
{
    (void)state;
    enum { SKIES = 4, ASKED = 2 * SKIES };
    Builder b = {0};
    Node *skies[SKIES];
    for (int i = 0; i < SKIES; i++)
        skies[i] = build_node(&b, KIND_SunSkyLight);
    build_set(skies[1], P_SunSkyLight_radianceFactor, 2);
    build_set(skies[2], P_SunSkyLight_turbidity, 9);
    build_set3(skies[3], P_SunSkyLight_sun, 1, -2, .5);
    const Surface up = at_xyz(1, 2, 3);
    Oracle *oracle = oracle_open(&b.graph, &groimp);
    for (int i = 0; i < ASKED; i++) {
        const Node *sky = skies[i * 3 % SKIES];
        const SlotValues alone = slots_at(&b, sky, &up);
        SlotValues asked, other = slots_at(&b, skies[(i * 3 + 1) % SKIES], &up);
        oracle_material(oracle, sky, &up, &asked);
        assert_memory_equal(asked.component[SLOT_emissive], alone.component[SLOT_emissive],
                            3 * sizeof(double));
        assert_memory_not_equal(asked.component[SLOT_emissive], other.component[SLOT_emissive],
                                3 * sizeof(double));
    }
    oracle_close(oracle);
    build_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_turbulence),        cmocka_unit_test(test_turbulence_uv),
        cmocka_unit_test(test_volume_turbulence), cmocka_unit_test(test_volume_functions),
        cmocka_unit_test(test_phong_defaults),    cmocka_unit_test(test_phong_maps),
        cmocka_unit_test(test_phong_input),       cmocka_unit_test(test_rgba),
        cmocka_unit_test(test_side_switch),       cmocka_unit_test(test_mix),
        cmocka_unit_test(test_algorithm_switch),  cmocka_unit_test(test_sky),
        cmocka_unit_test(test_skies_in_turn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
