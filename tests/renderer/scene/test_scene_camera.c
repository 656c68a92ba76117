/* Camera, motion and origin of scenes against numbers written down by hand from
 * docs/reference/language.md and scene.def: each kind, with each key at its default and away
 * from it.
 *
 *   camera: { camera: Perspective, angle: 90 }   half is tan 45 degrees: 1 */
#include "tests/scene_values.h"

/* -- Camera and motion ------------------------------------------------------------------------- */

static const struct {
    const char *keys;
    SceneCamera camera;
} cameras[] = {
    /* From (0, -5, 2) to the origin: back is (0, -5, 2) / sqrt 29, and half is tan 20 degrees. */
    {"",
     {.kind = SCENE_Perspective,
      .position = {0, -5, 2},
      .upright = {0, 0, 1},
      .right = {1, 0, 0},
      .up = {0, .37139067635410373, .92847669088525934},
      .back = {0, -.92847669088525934, .37139067635410373},
      .half = .36397023426620236,
      .near = .01}},
    {"camera: { camera: Perspective, position: [1, 2, 3], target: [1, 2, 8], up: [0, 5, 0], angle: "
     "90, near: .25 }\n",
     {.kind = SCENE_Perspective,
      .position = {1, 2, 3},
      .target = {1, 2, 8},
      .upright = {0, 5, 0},
      .right = {-1, 0, 0},
      .up = {0, 1, 0},
      .back = {0, 0, -1},
      .half = 1,
      .near = .25}},
    {"camera: { camera: Perspective, position: [4, 0, 4], target: [1, 0, 0], angle: 120 }\n",
     {.kind = SCENE_Perspective,
      .position = {4, 0, 4},
      .target = {1, 0, 0},
      .upright = {0, 0, 1},
      .right = {0, 1, 0},
      .up = {-.8, 0, .6},
      .back = {.6, 0, .8},
      .half = 1.7320508075688773,
      .near = .01}},
    {"camera: { camera: Orthographic }\n",
     {.kind = SCENE_Orthographic,
      .position = {0, -5, 2},
      .upright = {0, 0, 1},
      .right = {1, 0, 0},
      .up = {0, .37139067635410373, .92847669088525934},
      .back = {0, -.92847669088525934, .37139067635410373},
      .half = 2,
      .depth = 100}},
    {"camera: { camera: Orthographic, position: [-7, 1, 2], target: [3, 1, 2], up: [0, 1, 0], "
     "size: 5, depth: 30 }\n",
     {.kind = SCENE_Orthographic,
      .position = {-7, 1, 2},
      .target = {3, 1, 2},
      .upright = {0, 1, 0},
      .right = {0, 0, 1},
      .up = {0, 1, 0},
      .back = {-1, 0, 0},
      .half = 2.5,
      .depth = 30}},
};

static void check_camera(const SceneCamera *is, const SceneCamera *should_be, const char *text)
{
    CHECK(kind);
    CHECK_LIST(position);
    CHECK_LIST(target);
    CHECK_LIST(upright);
    CHECK_LIST(right);
    CHECK_LIST(up);
    CHECK_LIST(back);
    CHECK(half);
    CHECK(near);
    CHECK(depth);
}

static void each_camera(void **state)
{
    (void)state;
    bool met[SCENE_KIND_COUNT] = {false};
    for (int i = 0; i < COUNT(cameras); i++) {
        char text[512];
        MatcDocument *document;
        snprintf(text, sizeof text, LIT_SPHERE "%s", cameras[i].keys);
        Scene *scene = read_fine(text, &document);
        check_camera(&scene->camera, &cameras[i].camera, text);
        met[cameras[i].camera.kind] = true;
        forget(scene, document);
    }
    all_kinds_met(SCENE_SORT_camera, met);
}

#define KEYS_MAX 3

static const struct {
    const char *keys;
    SceneMotion motion;
    SceneKey path[KEYS_MAX];
} motions[] = {
    {"", {.frames = 0}, {{.time = 0}}},
    {"motion: { motion: Turntable }\n",
     {.kind = SCENE_Turntable, .frames = 36, .axis = {0, 0, 1}, .angle = 2 * PI},
     {{.time = 0}}},
    {"motion: { motion: Turntable, frames: 7, axis: [0, 3, 4], degrees: -90 }\n",
     {.kind = SCENE_Turntable, .frames = 7, .axis = {0, .6, .8}, .angle = -PI / 2},
     {{.time = 0}}},
    {"motion: { motion: Path, keys: [{ time: -1 }, {}] }\n",
     {.kind = SCENE_Path, .frames = 36, .key_count = 2},
     {{-1, {0, -5, 2}, {0, 0, 0}}, {0, {0, -5, 2}, {0, 0, 0}}}},
    {"motion: { motion: Path, frames: 5, keys: [{ time: .5, position: [1, -2, 3], target: "
     "[0, 4, 0] }, { time: 2.5, position: [6, -7, 8] }, { time: 3, target: [1, 2, 3] }] }\n",
     {.kind = SCENE_Path, .frames = 5, .key_count = 3},
     {{.5, {1, -2, 3}, {0, 4, 0}}, {2.5, {6, -7, 8}, {0, 0, 0}}, {3, {0, -5, 2}, {1, 2, 3}}}},
};

static void check_motion(const SceneMotion *is, const SceneMotion *should_be, const SceneKey *keys,
                         const char *text)
{
    CHECK(frames);
    CHECK_LIST(axis);
    CHECK(angle);
    CHECK(key_count);
    if (should_be->frames)
        CHECK(kind);
    for (int i = 0; i < should_be->key_count; i++) {
        same(is->keys[i].time, keys[i].time, "time", text);
        same_list(is->keys[i].position, keys[i].position, 3, "position", text);
        same_list(is->keys[i].target, keys[i].target, 3, "target", text);
    }
}

static void each_motion(void **state)
{
    (void)state;
    bool met[SCENE_KIND_COUNT] = {false};
    for (int i = 0; i < COUNT(motions); i++) {
        char text[512];
        MatcDocument *document;
        snprintf(text, sizeof text, LIT_SPHERE "%s", motions[i].keys);
        Scene *scene = read_fine(text, &document);
        check_motion(&scene->motion, &motions[i].motion, motions[i].path, text);
        met[motions[i].motion.kind] = true;
        forget(scene, document);
    }
    all_kinds_met(SCENE_SORT_motion, met);
}

/* -- Origin ------------------------------------------------------------------------------------ */

/* The example of scene_origin.h. All positions are relative to the plane's; edges and directions
 * stay. The time is that of the options. */
static void far_from_the_origin(void **state)
{
    (void)state;
    static const char text[] =
        RED "camera: { camera: Perspective, position: [6378137, -6, 2], target: [6378137, 0, 0] }\n"
            "motion: { motion: Path, frames: 2, keys: [{ position: [6378139, -6, 2], target: "
            "[6378137, 0, 0] }, "
            "{ time: 1, position: [6378130, -6, 3], target: [6378137, 1, 0] }] }\n"
            "objects:\n"
            "- { object: Plane, material: red, transform: { translation: [6378137, 0, 0] } }\n"
            "- { object: Box, material: red, transform: { translation: [6378138.5, 0, 0], scale: 2 "
            "} }\n"
            "lights:\n"
            "- { light: Point, position: [6378133, 1, 2] }\n"
            "- { light: Area, position: [6378137, 0, 8], u: [0, 2, 0], v: [3, 0, 0] }\n"
            "- { light: Directional, direction: [0, 1, 0] }\n";
    static const double camera[] = {0, -6, 2}, target[] = {0, 0, 0}, origin[] = {6378137, 0, 0};
    static const double keys[2][6] = {{2, -6, 2, 0, 0, 0}, {-7, -6, 3, 0, 1, 0}};
    static const double box[] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 1.5, 0, 0, 1};
    static const double roots[2][3] = {{0, 0, 0}, {1.5, 0, 0}};
    static const double positions[2][3] = {{-4, 1, 2}, {0, 0, 8}};
    static const double edges[] = {0, 2, 0, 3, 0, 0}, direction[] = {0, 1, 0};
    Scene *scene;
    MatcOptions options;
    matc_options_init(&options);
    options.time = 2.5;
    MatcDocument *document = scene_read("scene.yaml", text, strlen(text), &options, &scene);
    assert_non_null(scene);
    same(scene->time, 2.5, "time", text);
    same_list(scene->origin, origin, 3, "origin", text);
    same_list(scene->camera.position, camera, 3, "position", text);
    same_list(scene->camera.target, target, 3, "target", text);
    same_list(scene->objects[1].world_from_local.m, box, 16, "world_from_local", text);
    same_list(scene->lights[1].edges[0], edges, 6, "edges", text);
    same_list(scene->lights[2].direction, direction, 3, "direction", text);
    assert_int_equal(scene->root_count, 2);
    for (int i = 0; i < 2; i++) {
        same_list(scene->motion.keys[i].position, keys[i], 3, "key's position", text);
        same_list(scene->motion.keys[i].target, keys[i] + 3, 3, "key's target", text);
        same_list(scene->lights[i].position, positions[i], 3, "light's position", text);
        same_list(scene->roots[i].at, roots[i], 3, "root", text);
        assert_true(scene->roots[i].plane == (i == 0));
    }
    forget(scene, document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_camera),
        cmocka_unit_test(each_motion),
        cmocka_unit_test(far_from_the_origin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
