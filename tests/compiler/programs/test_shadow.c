/* The passes shadow and depth, drawn with matc's own vertex program: transparent fragments are
 * discarded, and no other slot is evaluated. */
#include "tests/test.h"
#include "tests/rig_state.h"
#include <string.h>

/* Whether each of 8 times 8 squares is more than half transparent. */
static void find_holes(const Scene *scene, bool holes[8][8])
{
    for (int i = 0; i < 64; i++) {
        Surface s;
        oracle_surface_default(&s);
        surface_set3(&s, GROUP_U, (double[3]){(i % 8 + 0.5) / 8, (i / 8 + 0.5) / 8, 0});
        SlotValues values = values_at(scene, &s);
        const double *t = values.component[SLOT_transparency];
        holes[i / 8][i % 8] = (t[0] + t[1] + t[2]) / 3 > 0.5;
    }
}

/* A tilted plane. The pass `depth`, and `shadow` of what is opaque, read nothing and discard
 * nothing. */
static void compare_shadow(Rig *rig, const char *text, const char *pass, bool lets_light)
{
    bool holes[8][8] = {0};
    Scene scene = open_scene(rig, text, &(SceneOptions){.pass = pass});
    const char *fragment = matc_output(scene.program, MATC_FRAGMENT, NULL);
    Space space = space_flat();
    space.world_from_local.m[2] = 0.3f;
    draw_scene(rig, &scene, &space, &rig->plane, &rig->depth);
    if (lets_light)
        find_holes(&scene, holes);
    else if (strstr(fragment, "discard") || strstr(fragment, "\nin ") ||
             !strstr(matc_output(scene.program, MATC_REFLECT, NULL), "\"inputs\": []"))
        fail_msg("%s does too much:\n%s", pass, fragment);
    for (int i = 0; i < PIXELS; i++) {
        bool hole = holes[i / SIDE * 8 / SIDE][i % SIDE * 8 / SIDE];
        double depth = hole ? rig_cleared_depth : 0.5 + 0.15 * middle(i % SIDE);
        if (!(fabs(rig->z[i] - depth) < 1e-6))
            fail_msg("%s, pixel %d, %d: depth %.9g, not %.9g", pass, i % SIDE, i / SIDE, rig->z[i],
                     depth);
    }
    scene_close(&scene);
}

static void only_what_is_transparent_is_discarded(void **state)
{
#define SQUARES(one, other)                                                                        \
    "{ map: Checker, color1: " one ", color2: " other                                              \
    ", input: { map: UVTransform, scaleU: 4, scaleV: 4 } }"
    static const struct {
        bool lets_light;
        const char *text;
    } cases[] = {
        {true, "{ material: Phong, transparency: " SQUARES("1", "0") " }"},
        {true, "{ material: Phong, transparency: " SQUARES("[1, 1, 0]", "[1, 0.4, 0]") " }"},
        {true, "{ material: Phong, diffuse: " SQUARES("\"#ffffff60\"",
                                                      "\"#ffffffa0\"") ", transparency: 0 }"},
        {true, "{ material: Phong, transparency: 0.6 }"},
        {true, "{ material: Phong, transparency: 0.5001 }"},
        {false, "{ material: Phong, transparency: 0.5 }"}, /* not more than half */
        {false, "{ material: Phong, diffuse: " SQUARES("1", "0") " }"},
        {false, "{ material: Phong, transparency: [0.4, 0.6, 0.3] }"},
        {false, "{ material: RGBA, r: 1 }"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        compare_shadow(*state, cases[i].text, "shadow", cases[i].lets_light);
        compare_shadow(*state, cases[i].text, "depth", false);
    }
}

/* Half of a checker lets light through, 0.7 of it, and half does not, 0.1. On a map whose texels
 * cover many of its squares each, half of all texels have to be held, whatever the default of --aa:
 * the mean, 0.4, would hold all. */
static void holes_finer_than_a_texel_keep_their_share(void **state)
{
    Scene scene =
        open_scene(RIG,
                   "{ material: Phong, transparency: { map: Checker, color1: 0.1, color2: 0.7, "
                   "input: { map: UVTransform, scaleU: 1013.3, scaleV: 987.1 } } }",
                   &(SceneOptions){.pass = "shadow", .aa = "auto"});
    Space space = space_flat();
    int held = 0;
    draw_scene(RIG, &scene, &space, &RIG->plane, &RIG->depth);
    for (int i = 0; i < PIXELS; i++)
        held += RIG->z[i] != rig_cleared_depth;
    scene_close(&scene);
    print_message("%d of %d texels held\n", held, PIXELS);
    assert_true(held > 0.4 * PIXELS && held < 0.6 * PIXELS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_what_is_transparent_is_discarded),
        cmocka_unit_test(holes_finer_than_a_texel_keep_their_share),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
