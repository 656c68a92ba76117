/* The oracle against closed forms worked out by hand from reference/semantics.md: delegation and
 * the maps. */
/* ctest: quick */
#include "tests/oracle_fixture.h"

static void test_surface(void **state)
{
    (void)state;
    static const char *const settable[] = {"px",    "py",    "pz",    "nx",    "ny",    "nz",
                                           "dpxdu", "dpydu", "dpzdu", "dpxdv", "dpydv", "dpzdv",
                                           "u",     "v",     "x",     "y",     "z",     "ior"};
    static const char *const rejected[] = {"w", "r", "g", "b", "a", "", "U", "uv", "N"};
    Surface s;
    oracle_surface_default(&s);
    assert_true(s.front);
    assert_true(s.root[NZ] == 1 && s.root[DPXDU] == 1 && s.root[DPYDV] == 1 && s.root[IOR] == 1 &&
                s.root[U] == 0);
    for (size_t i = 0; i < sizeof settable / sizeof *settable; i++)
        assert_true(oracle_surface_set(&s, settable[i], 2));
    for (size_t i = 0; i < sizeof rejected / sizeof *rejected; i++)
        assert_false(oracle_surface_set(&s, rejected[i], 2));
    assert_true(s.root[U] == 2 && s.root[DPZDV] == 2 && s.root[W] == 0 && s.root[A] == 0);
}

/* Precondition of oracle_query_input. */
static void test_input_is_first(void **state)
{
    (void)state;
    for (int i = 0; i < PARAM_COUNT; i++)
        if (strcmp(param_table[i].name, "input") == 0)
            assert_int_equal(i, kind_table[param_table[i].kind].first);
}

static void expect_constant(const Builder *b, const Node *map, const double rgba[4])
{
    Surface s = distinct();
    for (int channel = 0; channel < CHANNEL_ID_COUNT; channel++) {
        const double own = channel >= DPXDU && channel <= DPZDV ? 0 : rgba[channel % 4];
        expect(b, map, channel, &s, group_is_draws((Group)(channel / 4)) ? s.root[channel] : own);
    }
}

static void test_constants(void **state)
{
    (void)state;
    Builder b = {0};
    expect_constant(&b, build_constant(&b, build_components(1, 7, 0, 0, 0)),
                    (double[]){7, 7, 7, 1});
    expect_constant(&b, build_constant(&b, build_components(2, 2, 3, 0, 0)),
                    (double[]){2, 3, 0, 1});
    expect_constant(&b, build_constant(&b, build_components(3, 2, 3, 4, 0)),
                    (double[]){2, 3, 4, 1});
    expect_constant(&b, build_constant(&b, build_components(4, 2, 3, 4, 5)),
                    (double[]){2, 3, 4, 5});
    Node *color = build_node(&b, KIND_RGBColor), *gray = build_node(&b, KIND_Graytone);
    build_set(color, P_RGBColor_g, -3);
    expect_constant(&b, color, (double[]){.5, -3, .5, 1});
    expect_constant(&b, gray, (double[]){.5, .5, .5, 1});
    build_free(&b);
}

static void test_uniform_is_its_default(void **state)
{
    (void)state;
    Builder b = {0};
    Uniform uniform = {.name = "tint", .type = TYPE_vec3, .initial = {1, 2, 3}};
    Value value = {.kind = VALUE_uniform, .type = TYPE_vec3, .uniform = &uniform};
    expect_constant(&b, build_constant(&b, value), (double[]){1, 2, 3, 1});
    build_free(&b);
}

/* Whatever a map does not define is the surface's, in every group and in the components without a
 * name. */
static void expect_forwarded(const Builder *b, const Node *map, unsigned defined)
{
    Surface s = distinct();
    expect(b, NULL, W, &s, s.root[W]);
    for (int channel = 0; channel < CHANNEL_ID_COUNT; channel++)
        if (group_is_draws((Group)(channel / 4)) || !(defined >> channel & 1))
            expect(b, map, channel, &s, s.root[channel]);
}

static void test_delegation(void **state)
{
    (void)state;
    Builder b = {0};
    const unsigned uv = 3u << U, uvw = 7u << U, xyz = 7u << X,
                   frame = 7u << NX | 7u << DPXDU | 7u << DPXDV;
    Node *bump = build_node(&b, KIND_BumpMap), *flat = build_node(&b, KIND_BumpMap);
    build_link(bump, P_BumpMap_displacement, build_gradient(&b, 1, 0, 0));
    expect_forwarded(&b, build_node(&b, KIND_UVTransform), uv | 7u << DPXDU | 7u << DPXDV);
    expect_forwarded(&b, build_node(&b, KIND_XYZTransform), 0);
    expect_forwarded(&b, build_node(&b, KIND_Turbulence), uvw | xyz);
    expect_forwarded(&b, build_node(&b, KIND_WaveMap), frame);
    expect_forwarded(&b, build_node(&b, KIND_Blend), 0);
    expect_forwarded(&b, bump, frame);
    expect_forwarded(&b, flat, 0);
    build_free(&b);
}

static Node *build_checker(Builder *b)
{
    Node *checker = build_node(b, KIND_Checker),
         *red = build_constant(b, build_components(4, 1, .5, .25, .125));
    build_link(checker, P_Checker_color1, red);
    return checker;
}

static void test_checker(void **state)
{
    (void)state;
    Builder b = {0};
    const Node *checker = build_checker(&b);
    const struct {
        double u, v, red;
    } cells[] = {{0, 0, 0},    {.49, .49, 0}, {.5, 0, 1},       {0, .5, 1},
                 {.5, .5, 0},  {1.2, .1, 0},  {-.1, .1, 1},     {-.1, -.1, 0},
                 {-.5, .1, 1}, {-.51, .1, 0}, {1e6 + .6, .1, 1}};
    for (size_t i = 0; i < sizeof cells / sizeof *cells; i++) {
        Surface s = at_uv(cells[i].u, cells[i].v);
        expect(&b, checker, R, &s, cells[i].red);
        expect(&b, checker, X, &s, cells[i].red); /* the color is asked for the same channel */
        expect(&b, checker, A, &s, cells[i].red == 1 ? .125 : 1);
    }
    build_free(&b);
}

static void test_checker_derivative(void **state)
{
    (void)state;
    Builder b = {0};
    Node *checker = build_checker(&b);
    Surface edge_u = at_uv(.46, .1), edge_v = at_uv(.1, .96), inside = at_uv(.44, .1);
    expect(&b, checker, DPXDU, &edge_u, 1 / .05);
    expect(&b, checker, DPYDU, &edge_u, .5 / .05);
    expect(&b, checker, DPXDV, &edge_u, 0);
    expect(&b, checker, DPZDV, &edge_v, -.25 / .05);
    expect(&b, checker, DPZDU, &inside, 0);
    /* reads the surface: its own derivative channel, its red 0 */
    build_link(checker, P_Checker_color2, NULL);
    expect(&b, checker, DPXDU, &inside, 1);
    expect(&b, checker, DPXDU, &edge_u, 1 / .05);
    build_free(&b);
}

static void test_volume_checker(void **state)
{
    (void)state;
    Builder b = {0};
    const Node *checker = build_node(&b, KIND_VolumeChecker);
    const double odd[][3] = {
        {1.5, .5, .5}, {-.5, .5, .5}, {-.5, -.5, -.5}, {.5, 1, 2}, {1e6 + 1, 0, 0}};
    const double even[][3] = {{0, 0, 0}, {1.5, 1.5, .5}, {-.5, -.5, .5}, {-1, .5, 3.5}};
    for (size_t i = 0; i < sizeof odd / sizeof *odd; i++) {
        Surface s = at_xyz(odd[i][0], odd[i][1], odd[i][2]);
        expect(&b, checker, G, &s, 1);
    }
    for (size_t i = 0; i < sizeof even / sizeof *even; i++) {
        Surface s = at_xyz(even[i][0], even[i][1], even[i][2]);
        expect(&b, checker, G, &s, 0);
        expect(&b, checker, A, &s, 1);
    }
    build_free(&b);
}

static Node *build_blend(Builder *b, int count, const double (*items)[2])
{
    Node *blend = build_node(b, KIND_Blend);
    Items *list = build_alloc(b, sizeof *list);
    Item *item = build_alloc(b, (size_t)count * sizeof *item + 1);
    for (int i = 0; i < count; i++) {
        const Node *map = items[i][1] < 0 ? NULL : build_constant(b, build_number(items[i][1]));
        item[i] = (Item){.value = build_number(items[i][0]), .input = map};
    }
    *list = (Items){count, item};
    *build_param(blend, P_Blend_blend) = (Value){.kind = VALUE_items, .items = list};
    return blend;
}

/* A blend's red at t; items are (value, gray), a negative gray is an item without map. */
static void expect_blend(int count, const double (*items)[2], double t, double want)
{
    Builder b = {0};
    Surface s = at_xyz(t, 0, 0);
    expect(&b, build_blend(&b, count, items), R, &s, want);
    build_free(&b);
}

static void test_blend(void **state)
{
    (void)state;
    const double ramp[][2] = {{-1, 10}, {0, 20}, {1, 60}},
                 step[][2] = {{0, 1}, {.5, 2}, {.5, 7}, {1, 9}};
    const double unsorted[][2] = {{0, 1}, {2, 3}, {1, 5}, {4, 6}}, hole[][2] = {{0, -1}, {1, 4}};
    expect_blend(0, NULL, 3, 0);
    expect_blend(1, ramp, -3, 10);
    expect_blend(3, ramp, -1.5, 10);
    expect_blend(3, ramp, -1, 10);
    expect_blend(3, ramp, -.75, 12.5);
    expect_blend(3, ramp, 0, 20);
    expect_blend(3, ramp, .5, 40);
    expect_blend(3, ramp, 1, 60);
    expect_blend(3, ramp, 8, 60);
    expect_blend(4, step, .25, 1.5);
    expect_blend(4, step, .5, 7);
    expect_blend(4, step, .75, 8);
    expect_blend(4, unsorted, 1.5, 2.5); /* between the first two; the 1 is never reached */
    expect_blend(4, unsorted, 3, 5 + (3. - 1) / 3);
    expect_blend(2, hole, .25, 1);
}

static void test_blend_input(void **state)
{
    (void)state;
    Builder b = {0};
    Node *blend = build_blend(&b, 2, (const double[][2]){{0, 0}, {1, 8}});
    build_link(blend, P_Blend_input, build_gradient(&b, 0, .5, 0));
    Surface s = at_xyz(9, .5, 9);
    expect(&b, blend, G, &s, 2);
    expect(&b, blend, A, &s, 1);
    expect(&b, blend, DPXDU, &s, 0);
    build_free(&b);
}

/* f = 3 x - 2, w = sqr, in every channel; a fourth component is 1. */
static void test_volume_channels(void **state)
{
    (void)state;
    Builder b = {0};
    Node *gradient = build_gradient(&b, 1, 0, 0);
    build_set(gradient, P_Gradient_frequency, 3);
    build_set(gradient, P_Gradient_phase, -2);
    *build_param(gradient, P_Gradient_waveForm) =
        (Value){.kind = VALUE_wave, .wave = build_wave(&b, WAVE_Sqr)};
    Surface s = at_xyz(4, 5, 6);
    for (int channel = 0; channel < CHANNEL_ID_COUNT; channel++)
        expect(&b, gradient, channel, &s,
               group_is_draws((Group)(channel / 4)) ? s.root[channel]
               : channel % 4 == 3                   ? 1
                                                    : 100);
    build_free(&b);
}

static double wave_at(const Wave *wave, double v)
{
    Builder b = {0};
    Node *gradient = build_gradient(&b, 1, 0, 0);
    *build_param(gradient, P_Gradient_waveForm) = (Value){.kind = VALUE_wave, .wave = wave};
    Surface s = at_xyz(v, 0, 0);
    double value = value_at(&b, gradient, R, &s);
    build_free(&b);
    return value;
}

static void test_waves(void **state)
{
    (void)state;
    const struct {
        WaveKind kind;
        double v, want;
    } cases[] = {{WAVE_Id, -3, -3},      {WAVE_Abs, -3, 3},         {WAVE_Ceil, -1.5, -1},
                 {WAVE_Floor, -1.5, -2}, {WAVE_Pi, 2, 2 * M_PI},    {WAVE_Log10, 1000, 3},
                 {WAVE_Exp2, 3, 8},      {WAVE_Sin01, 2.25, 1},     {WAVE_Ramp, -.25, .5},
                 {WAVE_Cubic, .5, 0},    {WAVE_Cubic, 3, -1},       {WAVE_Triangle, .125, .5},
                 {WAVE_Triangle, .5, 0}, {WAVE_Triangle, -.25, -1}, {WAVE_Triangle, 1.625, -.5},
                 {WAVE_Scallop, 1.5, 1}, {WAVE_Scallop, 2, -1},     {WAVE_Sqrt, -1, 0},
                 {WAVE_Acos, 2, 0},      {WAVE_Expm1, 0, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        close_to(wave_at(&(Wave){.kind = cases[i].kind}, cases[i].v), cases[i].want, 1e-12);
}

static void test_chain(void **state)
{
    (void)state;
    Wave sqr = {.kind = WAVE_Sqr}, abs = {.kind = WAVE_Abs};
    Wave affine = {.kind = WAVE_Chain, .factor = build_number(-2), .shift = build_number(5)};
    Wave chain = {.kind = WAVE_Chain,
                  .first = &sqr,
                  .second = &abs,
                  .factor = build_number(2),
                  .shift = build_number(-20)};
    Wave nested = {.kind = WAVE_Chain,
                   .first = &chain,
                   .second = &affine,
                   .factor = build_number(1),
                   .shift = build_number(0)};
    close_to(wave_at(&affine, 3), -1, 0);
    close_to(wave_at(&chain, 3), 2, 0);
    close_to(wave_at(&nested, 3), 1, 0);
}

/* The memo must not carry values from point to point, nor from one channel to another. */
static void test_many_points(void **state)
{
    (void)state;
    Builder b = {0};
    Node *smooth = build_node(&b, KIND_Smooth3D), *gradient = build_gradient(&b, 1, 2, 3);
    build_link(smooth, P_Smooth3D_input, gradient);
    Oracle *oracle = oracle_open(&b.graph, &groimp);
    for (int i = 0; i < 100; i++) {
        Surface s = at_xyz(i, 2 * i, 0);
        close_to(oracle_channel(oracle, gradient, R, &s), 5 * i, 0);
        close_to(oracle_channel(oracle, smooth, R, &s), 5 * i, 1e-10);
        close_to(oracle_channel(oracle, NULL, Y, &s), 2 * i, 0);
    }
    oracle_close(oracle);
    build_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_surface),
        cmocka_unit_test(test_input_is_first),
        cmocka_unit_test(test_constants),
        cmocka_unit_test(test_uniform_is_its_default),
        cmocka_unit_test(test_delegation),
        cmocka_unit_test(test_checker),
        cmocka_unit_test(test_checker_derivative),
        cmocka_unit_test(test_volume_checker),
        cmocka_unit_test(test_blend),
        cmocka_unit_test(test_blend_input),
        cmocka_unit_test(test_volume_channels),
        cmocka_unit_test(test_waves),
        cmocka_unit_test(test_chain),
        cmocka_unit_test(test_many_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
