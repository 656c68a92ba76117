/* Lights, suns and objects of scenes against numbers written down by hand from
 * docs/reference/language.md, scene.def and semantics.md: each kind, with each key at its
 * default and away from it. The renderer's reference uses the parsed scene, so no picture would
 * show a factor that the reader omits.
 *
 *   light: Hemisphere, ground: [.5, .25, .125], intensity: 4   ground is (2, 1, .5)
 *   light: Spot, innerAngle: 60, outerAngle: 90   the cosines are 1/2 and 0 */
#include "tests/scene_values.h"

#define QUARTER   "1.5707963267948966" /* radians */
#define ROOT_HALF .70710678118654752

/* -- Lights ------------------------------------------------------------------------------------ */

#define DOWN .direction = {0, 0, -1}
#define NO   .shadows = KEYWORD_Shadows_none
#define MAP  .shadows = KEYWORD_Shadows_map

static const struct {
    const char *keys;
    SceneLight light;
} lights[] = {
    {"light: Point", {.kind = SCENE_Point, DOWN, .light = {1, 1, 1}, MAP}},
    {"light: Point, position: [1, -2, 3], color: [.5, .25, 2], intensity: 8, shadows: silhouette",
     {.kind = SCENE_Point,
      .position = {1, -2, 3},
      DOWN,
      .light = {4, 2, 16},
      .shadows = KEYWORD_Shadows_silhouette}},
    {"light: Point, intensity: 0, shadows: exact",
     {.kind = SCENE_Point, DOWN, .shadows = KEYWORD_Shadows_exact}},
    {"light: Spot",
     {.kind = SCENE_Spot,
      DOWN,
      .light = {1, 1, 1},
      .inner_cosine = .93969262078590838,
      .outer_cosine = .86602540378443865,
      MAP}},
    {"light: Spot, position: [4, 5, -6], direction: [0, 3, -4], innerAngle: 60, outerAngle: 90, "
     "color: [1, .5, .25], intensity: 12, shadows: hybrid",
     {.kind = SCENE_Spot,
      .position = {4, 5, -6},
      .direction = {0, .6, -.8},
      .light = {12, 6, 3},
      .inner_cosine = .5,
      .outer_cosine = 0,
      .shadows = KEYWORD_Shadows_hybrid}},
    {"light: Spot, innerAngle: 45, outerAngle: 180, shadows: false",
     {.kind = SCENE_Spot,
      DOWN,
      .light = {1, 1, 1},
      .inner_cosine = ROOT_HALF,
      .outer_cosine = -1,
      NO}},
    {"light: Directional", {.kind = SCENE_Directional, DOWN, .light = {1, 1, 1}, MAP}},
    {"light: Directional, direction: [2, -2, -1], color: [.1, .2, .4], intensity: 10, shadows: "
     "none",
     {.kind = SCENE_Directional, .direction = {2. / 3, -2. / 3, -1. / 3}, .light = {1, 2, 4}, NO}},
    {"light: Area",
     {.kind = SCENE_Area,
      .position = {0, 0, 1},
      DOWN,
      .light = {1, 1, 1},
      .edges = {{0, 1, 0}, {1, 0, 0}},
      MAP}},
    {"light: Area, position: [-1, 2, 5], u: [2, 0, 1], v: [0, 3, -1], bothSides: true, "
     "color: [1, 2, 3], intensity: .5, shadows: none",
     {.kind = SCENE_Area,
      .position = {-1, 2, 5},
      DOWN,
      .light = {.5, 1, 1.5},
      .edges = {{2, 0, 1}, {0, 3, -1}},
      .both_sides = true,
      NO}},
    {"light: Ambient", {.kind = SCENE_Ambient, DOWN, .light = {1, 1, 1}, NO}},
    {"light: Ambient, color: [.5, .25, 1], intensity: 2",
     {.kind = SCENE_Ambient, DOWN, .light = {1, .5, 2}, NO}},
    {"light: Hemisphere",
     {.kind = SCENE_Hemisphere, DOWN, .light = {1, 1, 1}, .ground = {.3, .3, .3}, NO}},
    {"light: Hemisphere, color: [1, 2, 3], ground: [.5, .25, .125], intensity: 4",
     {.kind = SCENE_Hemisphere, DOWN, .light = {4, 8, 12}, .ground = {2, 1, .5}, NO}},
};

static void check_light(const SceneLight *is, const SceneLight *should_be, const char *text)
{
    CHECK(kind);
    CHECK_LIST(position);
    CHECK_LIST(direction);
    CHECK_LIST(light);
    CHECK_LIST(ground);
    CHECK(inner_cosine);
    CHECK(outer_cosine);
    CHECK_LIST(edges);
    CHECK(both_sides);
    CHECK(shadows);
}

static void each_light(void **state)
{
    (void)state;
    bool met[SCENE_KIND_COUNT] = {[SCENE_Sky] = true}; /* suns_of_skies */
    for (int i = 0; i < COUNT(lights); i++) {
        char text[512];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 RED "objects: [{ object: Sphere, material: red }]\n"
                     "lights: [{ light: Ambient }, { %s }]\n",
                 lights[i].keys);
        Scene *scene = read_fine(text, &document);
        assert_int_equal(scene->light_count, 2);
        check_light(&scene->lights[1], &lights[i].light, text);
        same_list(scene->sky_light, (const double[3]){0}, 3, "sky_light", text);
        met[lights[i].light.kind] = true;
        forget(scene, document);
    }
    all_kinds_met(SCENE_SORT_light, met);
}

/* Every kind of light in scene.def has its row in light_kinds.def, and the GLSL that it needs: only
 * points and parallel light share a formula. */
static void each_light_has_a_row(void **state)
{
    (void)state;
    for (int kind = 0; kind < SCENE_KIND_COUNT; kind++) {
        if (scene_kind_table[kind].sort != SCENE_SORT_light)
            continue;
        const LightKind *row = light_kind_table[light_kind_number((SceneKind)kind)];
        assert_int_equal(row->kind, kind);
        assert_string_equal(light_kind_name(row), scene_kind_table[kind].name);
        assert_true(row->glsl || row->from < LIGHT_FROM_extent);
    }
}

/* -- Sky and sun ------------------------------------------------------------------------------- */

#define NO_SUN                                                                                     \
    0, {0}, { 0 }
#define FROM_SUN                                                                                   \
    1, { -3. / 13, -4. / 13, -12. / 13 }
#define SUN "material: SunSkyLight, sun: [3, 4, 12]"

/* A white surface that faces the sun sends back (2.0567, 1.6258, 1.2533) at turbidity 6 and
 * (3.0220, 2.6081, 2.3030) at turbidity 2: integrals of Preetham's tables over the CIE's
 * observer, as test_sky.c has them, times 10 over the irradiance of sky and sun. Each component
 * meets that of the light. */
static const struct {
    const char *sky, *lights;
    double sky_light[3];
    int count;
    double direction[3], light[3];
} suns[] = {
    {"material: RGBA, b: .5",
     ", { light: Sky, color: [1, .5, .25], intensity: 4 }",
     {4, 2, 1},
     NO_SUN},
    {SUN, "", {0}, NO_SUN},
    {SUN, ", { light: Sky }", {1, 1, 1}, FROM_SUN, {2.0567, 1.6258, 1.2533}},
    {SUN, ", { light: Sky, color: [1, 0, 0], intensity: 2 }", {2, 0, 0}, FROM_SUN, {4.1133, 0, 0}},
    {SUN, ", { light: Sky, color: [.5, 2, 4] }", {.5, 2, 4}, FROM_SUN, {1.0283, 3.2517, 5.0132}},
    {SUN,
     ", { light: Sky }, { light: Sky, color: [0, 1, 3] }",
     {1, 2, 4},
     FROM_SUN,
     {2.0567, 3.2517, 5.0132}},
    {SUN ", turbidity: 2", ", { light: Sky }", {1, 1, 1}, FROM_SUN, {3.0220, 2.6081, 2.3030}},
    {SUN ", radianceFactor: 3", ", { light: Sky }", {1, 1, 1}, FROM_SUN, {6.1700, 4.8775, 3.7599}},
    {SUN ", disableSun: true", ", { light: Sky }", {1, 1, 1}, NO_SUN},
    {SUN ", disableLight: true", ", { light: Sky }", {0, 0, 0}, NO_SUN},
    {SUN, ", { light: Sky, intensity: 0 }", {0, 0, 0}, NO_SUN},
    {"material: SunSkyLight, sun: [3, 4, -12]", ", { light: Sky }", {1, 1, 1}, NO_SUN},
    {"material: SunSkyLight, sun: [3, 4, -.001]", ", { light: Sky }", {1, 1, 1}, NO_SUN},
    {"material: SunSkyLight, sun: [3, 4, 0]", ", { light: Sky }", {1, 1, 1}, NO_SUN},
};

static void suns_of_skies(void **state)
{
    (void)state;
    for (int i = 0; i < COUNT(suns); i++) {
        char text[512];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 RED "objects: [{ object: Sphere, material: red }]\n"
                     "sky: { %s }\nlights: [{ light: Ambient }%s]\n",
                 suns[i].sky, suns[i].lights);
        Scene *scene = read_fine(text, &document);
        assert_int_equal(scene->sky, 1);
        same_list(scene->sky_light, suns[i].sky_light, 3, "sky_light", text);
        same(scene->light_count, 1 + suns[i].count, "light_count", text);
        for (int k = 0; k < 3 && suns[i].count; k++) {
            const SceneLight *sun = &scene->lights[1];
            const double light = suns[i].light[k];
            same(sun->direction[k], suns[i].direction[k], "direction", text);
            if (!(fabs(sun->light[k] - light) <= .01 * light))
                fail_msg("light[%d] is %g, not %g:\n%s", k, sun->light[k], light, text);
            assert_true(sun->kind == SCENE_Directional && sun->shadows == KEYWORD_Shadows_map);
        }
        forget(scene, document);
    }
}

/* -- Objects ----------------------------------------------------------------------------------- */

#define TWO                                                                                        \
    "materials: { red: { material: RGBA, r: 1 }, blue: { material: RGBA, b: 1 } }\n"               \
    "lights: [{ light: Ambient }]\n"
#define IDENTITY 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1

/* Matrices by columns. XYZTransform of semantics.md: M = T Rz Ry Rx S H. */
static const struct {
    const char *keys;
    SceneObject object;
} objects[] = {
    {"object: Sphere",
     {.kind = SCENE_Sphere, .numbers = {1, 192}, .world_from_local = {{IDENTITY}}}},
    {"object: Sphere, radius: 2.5, detail: 12, transform: { translation: [1, -2, 3], scale: 2 }",
     {.kind = SCENE_Sphere,
      .numbers = {2.5, 12},
      .world_from_local = {{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 1, -2, 3, 1}}}},
    {"object: Box", {.kind = SCENE_Box, .numbers = {1, 1, 1}, .world_from_local = {{IDENTITY}}}},
    {"object: Box, size: [2, 3, 4], transform: { rotation: [0, 0, " QUARTER "], scale: [2, 3, 5] }",
     {.kind = SCENE_Box,
      .numbers = {2, 3, 4},
      .world_from_local = {{0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 5, 0, 0, 0, 0, 1}}}},
    {"object: Cylinder",
     {.kind = SCENE_Cylinder, .numbers = {.5, 1, 192}, .world_from_local = {{IDENTITY}}}},
    {"object: Cylinder, radius: 3, height: 7, detail: 5, transform: { rotation: [" QUARTER
     ", 0, " QUARTER "] }",
     {.kind = SCENE_Cylinder,
      .numbers = {3, 7, 5},
      .world_from_local = {{0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1}}}},
    {"object: Cone",
     {.kind = SCENE_Cone, .numbers = {.5, 1, 192}, .world_from_local = {{IDENTITY}}}},
    {"object: Cone, radius: 2, height: 6, detail: 9, transform: { rotation: [0, " QUARTER ", 0] }",
     {.kind = SCENE_Cone,
      .numbers = {2, 6, 9},
      .world_from_local = {{0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1}}}},
    {"object: Parallelogram",
     {.kind = SCENE_Parallelogram,
      .numbers = {1, 0, 0, 0, 1, 0},
      .world_from_local = {{IDENTITY}}}},
    {"object: Parallelogram, u: [1, 2, 3], v: [-4, 5, 6], transform: { shear: [.5, .25, .125], "
     "scale: [2, 4, 8] }",
     {.kind = SCENE_Parallelogram,
      .numbers = {1, 2, 3, -4, 5, 6},
      .world_from_local = {{2, 0, 0, 0, 1, 4, 0, 0, .5, .5, 8, 0, 0, 0, 0, 1}}}},
    {"object: Plane", {.kind = SCENE_Plane, .world_from_local = {{IDENTITY}}}},
    {"object: Plane, transform: { matrix: [0, 0, 1, 5, 1, 0, 0, 6, 0, 1, 0, 7, 0, 0, 0, 1] }",
     {.kind = SCENE_Plane, .world_from_local = {{0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 5, 6, 7, 1}}}},
};

static void check_object(const SceneObject *is, const SceneObject *should_be, const char *text)
{
    CHECK(kind);
    CHECK_LIST(numbers);
    CHECK(material);
    CHECK_LIST(world_from_local.m);
}

static void each_object(void **state)
{
    (void)state;
    /* objects_within_others has those that are no solids, test_scene.c has files. */
    bool met[SCENE_KIND_COUNT] = {
        [SCENE_Group] = true, [SCENE_Scatter] = true, [SCENE_Instance] = true, [SCENE_Mesh] = true};
    for (int i = 0; i < COUNT(objects); i++) {
        char text[512];
        MatcDocument *document;
        SceneObject expected = objects[i].object;
        expected.material = 1;
        snprintf(text, sizeof text,
                 TWO "objects: [{ object: Box, material: red }, { material: blue, %s }]\n",
                 objects[i].keys);
        Scene *scene = read_fine(text, &document);
        assert_true(scene->object_count == 2 && scene->material_count == 2 &&
                    scene->objects[0].material == 0);
        check_object(&scene->objects[1], &expected, text);
        met[expected.kind] = true;
        forget(scene, document);
    }
    all_kinds_met(SCENE_SORT_object, met);
}

/* A group, an instance of a definition and a copy of Scatter, each with its matrix applied after
 * the object's. The copy is at (0, 0, 0) because all its ranges are 0, and is scaled by 3. */
static void objects_within_others(void **state)
{
    (void)state;
    static const char text[] =
        TWO "defs: { ball: { object: Sphere, radius: 4, transform: { translation: [1, 2, 3] } } }\n"
            "objects:\n"
            "- { object: Group, material: red, transform: { scale: 2 }, objects: [{ object: Box, "
            "transform: { "
            "translation: [1, 0, 0] } }, { object: Box, material: blue }] }\n"
            "- { object: Instance, of: ball, material: blue, transform: { scale: [1, 1, -2] } }\n"
            "- { object: Scatter, material: red, count: 1, size: 0, least: 3, most: 3, "
            "transform: { translation: [7, 8, 9] }, "
            "objects: [{ object: Sphere, radius: .5, detail: 8 }] }\n"
            "- { object: Scatter, material: red, count: 3, seed: 0, size: [2, 2, 0], "
            "objects: [{ object: Box }] }\n";
    static const SceneObject expected[] = {
        {.kind = SCENE_Box,
         .numbers = {1, 1, 1},
         .material = 0,
         .world_from_local = {{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 2, 0, 0, 1}}},
        {.kind = SCENE_Box,
         .numbers = {1, 1, 1},
         .material = 1,
         .world_from_local = {{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1}}},
        {.kind = SCENE_Sphere,
         .numbers = {4, 192},
         .material = 1,
         .world_from_local = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, 0, 1, 2, -6, 1}}},
        {.kind = SCENE_Sphere,
         .numbers = {.5, 8},
         .material = 0,
         .world_from_local = {{3, 0, 0, 0, 0, 3, 0, 0, 0, 0, 3, 0, 7, 8, 9, 1}}},
        /* SplitMix64 with seed 0 gives 0xE220A8397B1DCDAF and 0x6E789E6AA1B965F4: 0.88331... and
         * 0.43152... */
        {.kind = SCENE_Box,
         .numbers = {1, 1, 1},
         .material = 0,
         .world_from_local = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, .7666216164272852,
                               -.13694400590298006, 0, 1}}},
    };
    MatcDocument *document;
    Scene *scene = read_fine(text, &document);
    assert_int_equal(scene->object_count, COUNT(expected) + 2);
    for (int i = 0; i < COUNT(expected); i++)
        check_object(&scene->objects[i], &expected[i], text);
    forget(scene, document);
}

/* The sixth and the seventh number of SplitMix64 with seed 0 are .32733 and .17387, x and y: the
 * copy is rotated about z by 3 (2 x - 1), and scaled by 1 + 2 y. Nine copies stand on an area of 6
 * at a density of 1.5. */
static void copies(void **state)
{
    (void)state;
    static const char text[] =
        TWO "objects:\n"
            "- { object: Scatter, material: red, count: 1, size: 0, rotation: [0, 0, 3], least: 1, "
            "most: 3, objects: [{ object: Box }] }\n"
            "- { object: Scatter, material: blue, density: 1.5, objects: [{ object: Sphere }], "
            "on: { object: Parallelogram, u: [2, 0, 0], v: [0, 3, 0] } }\n";
    static const double scaled_cosine = .6868421689372693, scaled_sine = -1.159585890765223;
    static const double scale = 1.3477357319193657;
    const SceneObject expected = {
        .kind = SCENE_Box,
        .numbers = {1, 1, 1},
        .world_from_local = {{scaled_cosine, scaled_sine, 0, 0, -scaled_sine, scaled_cosine, 0, 0,
                              0, 0, scale, 0, 0, 0, 0, 1}}};
    MatcDocument *document;
    Scene *scene = read_fine(text, &document);
    assert_int_equal(scene->object_count, 1 + 9);
    check_object(&scene->objects[0], &expected, text);
    forget(scene, document);
}

/* An object's name follows those of its groups; unnamed objects have NULL. No object is hidden
 * initially. */
static void names(void **state)
{
    (void)state;
    static const char text[] = RED "lights: [{ light: Ambient }, { light: Point, name: bulb }]\n"
                                   "objects:\n"
                                   "- { object: Group, name: lamps, material: red, "
                                   "objects: [{ object: Sphere, name: bulb }] }\n"
                                   "- { object: Box, material: red }\n";
    MatcDocument *document;
    Scene *scene = read_fine(text, &document);
    assert_int_equal(scene->object_count, 2);
    assert_string_equal(scene->objects[0].name, "lamps/bulb");
    assert_null(scene->objects[1].name);
    assert_null(scene->lights[0].name);
    assert_string_equal(scene->lights[1].name, "bulb");
    for (int i = 0; i < 2; i++)
        assert_false(scene->objects[i].hidden || scene->objects[i].removed);
    forget(scene, document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_light),
        cmocka_unit_test(each_light_has_a_row),
        cmocka_unit_test(suns_of_skies),
        cmocka_unit_test(each_object),
        cmocka_unit_test(objects_within_others),
        cmocka_unit_test(copies),
        cmocka_unit_test(names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
