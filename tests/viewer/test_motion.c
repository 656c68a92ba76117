/* Cameras of animation frames by closed forms, refused motions, the frames that an option
 * selects, and the names of their files. */
#include "runtime/scene_reader/scene_read.h"
#include "tests/test.h"
#include "runtime/viewer/frames.h"
#include <math.h>
#include <string.h>

static Scene *read_text(const char *text, MatcDocument **document)
{
    Scene *scene = NULL;
    MatcOptions options;
    matc_options_init(&options);
    *document = scene_read("scene.yaml", text, strlen(text), &options, &scene);
    return scene;
}

static void forget(Scene *scene, MatcDocument *document)
{
    scene_free(scene);
    matc_document_free(document);
}

static void is_vector(const double v[3], double x, double y, double z)
{
    const double expected[3] = {x, y, z};
    for (int i = 0; i < 3; i++)
        if (fabs(v[i] - expected[i]) > 1e-12)
            fail_msg("%g %g %g instead of %g %g %g", v[0], v[1], v[2], x, y, z);
}

/* A quarter of a turn each, then eighths; the last frame is no copy of the first. */
static void turntables_turn(void **state)
{
    (void)state;
    MatcDocument *document;
    Scene *scene =
        read_text("camera: { camera: Perspective, position: [2, 0, 1], target: [1, 0, 0] }\n"
                  "motion: { motion: Turntable, frames: 4, axis: [0, 0, 7] }\n",
                  &document);
    assert_non_null(scene);
    assert_int_equal(scene->motion.frames, 4);
    static const double at[4][2] = {{2, 0}, {1, 1}, {0, 0}, {1, -1}};
    SceneCamera camera;
    for (int i = 0; i < 4; i++) {
        assert_true(scene_motion_camera(scene, i, 4, &camera));
        is_vector(camera.position, at[i][0], at[i][1], 1);
        is_vector(camera.back, (at[i][0] - 1) * sqrt(.5), at[i][1] * sqrt(.5), sqrt(.5));
        is_vector(camera.right, -camera.back[1] * sqrt(2), camera.back[0] * sqrt(2), 0);
        assert_true(camera.half == scene->camera.half && camera.near == scene->camera.near);
    }
    assert_true(scene_motion_camera(scene, 1, 8, &camera));
    is_vector(camera.position, 1 + sqrt(.5), sqrt(.5), 1);
    forget(scene, document);
}

/* The up direction rotates, too: around its view direction, the camera rolls. */
static void turntables_roll(void **state)
{
    (void)state;
    MatcDocument *document;
    Scene *scene =
        read_text("camera: { camera: Orthographic, position: [0, -5, 0], target: [0, 0, 0] }\n"
                  "motion: { motion: Turntable, frames: 1, axis: [0, 1, 0], degrees: 180 }\n",
                  &document);
    SceneCamera camera;
    assert_non_null(scene);
    assert_true(scene_motion_camera(scene, 1, 2, &camera));
    is_vector(camera.position, 0, -5, 0);
    is_vector(camera.up, 1, 0, 0); /* z, turned from z to x */
    forget(scene, document);
}

/* The page's example: x is 0, 1, 4 at the times 0, 1, 2, and 3/8 at 1/2; two keys are joined by a
 * line, and the first and last frames are keys. */
static void paths_go_through_their_keys(void **state)
{
    (void)state;
    MatcDocument *document;
    Scene *scene = read_text("motion: { motion: Path, frames: 5, keys: [{ time: 0, position: [0, "
                             "-5, 0], target: [0, 5, 0] }, "
                             "{ time: 1, position: [1, -5, 0], target: [0, 5, 1] }, { time: 2, "
                             "position: [4, -5, 0], target: [0, "
                             "5, 2] }] }\n",
                             &document);
    assert_non_null(scene);
    /* at 3/2, with slopes 2 and 3: (1 + 4) / 2 + (2 - 3) / 8 */
    static const double x[5] = {0, .375, 1, 2.375, 4};
    SceneCamera camera;
    for (int i = 0; i < 5; i++) {
        assert_true(scene_motion_camera(scene, i, 5, &camera));
        is_vector(camera.position, x[i], -5, 0);
        is_vector(camera.target, 0, 5, i * .5);
    }
    assert_true(scene_motion_camera(scene, 0, 1, &camera));
    is_vector(camera.position, 0, -5, 0);
    forget(scene, document);
    scene = read_text("motion: { motion: Path, keys: [{ time: 3, position: [0, -2, 0] }, { time: "
                      "5, position: [4, -2, 8] }] }\n",
                      &document);
    assert_non_null(scene);
    assert_true(scene_motion_camera(scene, 1, 5, &camera));
    is_vector(camera.position, 1, -2, 2);
    forget(scene, document);
}

static void faults(void **state)
{
    (void)state;
    static const struct {
        const char *text, *reported;
    } cases[] = {
        {"motion: { motion: Turntabel }\n",
         "1:19: error: unknown motion 'Turntabel'; did you mean 'Turntable'?"},
        {"motion: { motion: Turntable, frames: 0 }\n", "1:38: error: frames"},
        {"motion: { motion: Turntable, axis: [0, 0, 0] }\n", "1:36: error: axis has no direction"},
        {"motion: { motion: Path }\n", "1:9: error: a path has two keys or more"},
        {"motion: { motion: Path, keys: [{ time: 1 }] }\n", "error: a path has two keys or more"},
        {"motion: { motion: Path, keys: [{ time: 1 }, { time: 1 }] }\n",
         "1:53: error: the times of keys rise"},
        {"motion: { motion: Path, keys: [{ time: 1, colour: 1 }, { time: 2 }] }\n",
         "1:43: error: Key has no parameter"},
        {"motion: { motion: Path, keys: [{ position: [0, -1, 0] }, { time: 1, position: [0, 1, 0] "
         "}], frames: 3 }\n",
         "1:9: error: the camera has no direction in some frame"},
        {"camera: { camera: Perspective, position: [0, -1, 0] }\nmotion: { motion: Turntable, "
         "axis: [1, 0, 0], frames: "
         "4 }\n",
         NULL}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcDocument *document;
        Scene *scene = read_text(cases[i].text, &document);
        const char *reported = matc_diagnostics(document, MATC_TEXT);
        if (cases[i].reported ? scene || !strstr(reported, cases[i].reported) : !scene)
            fail_msg("%s\n%s", cases[i].text, reported);
        forget(scene, document);
    }
}

static void frames_are_chosen(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int first, last, whole;
    } fine[] = {{"1", 0, 0, 1}, {"36", 0, 35, 36}, {"0-0", 0, 0, 0}, {"10-19", 10, 19, 0}};
    static const char *const wrong[] = {"",  "0",  "-1",  "1-", "5-4",    "1-2-3",
                                        "x", "1x", "1.5", " 1", "100001", "99999999999"};
    Frames frames;
    char reason[FRAMES_CAPACITY];
    for (size_t i = 0; i < sizeof fine / sizeof *fine; i++) {
        assert_null(frames_read(fine[i].text, &frames));
        assert_true(frames.given && frames.first == fine[i].first && frames.last == fine[i].last &&
                    frames.whole == fine[i].whole);
    }
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_non_null(frames_read(wrong[i], &frames));
    assert_null(frames_read_one("7", &frames));
    assert_true(frames.first == 7 && frames.last == 7);
    assert_non_null(frames_read_one("1-2", &frames));
    Scene still = {0}, moving = {.motion = {.frames = 8}};
    assert_null(frames_read("0-7", &frames));
    assert_non_null(frames_check(&still, &frames, reason));
    assert_null(frames_check(&moving, &frames, reason));
    assert_int_equal(frames.whole, 8);
    assert_null(frames_read("0-8", &frames));
    assert_string_equal(frames_check(&moving, &frames, reason),
                        "the motion has the frames 0 to 7, and no frame 8");
}

static void files_have_their_numbers(void **state)
{
    (void)state;
    static const struct {
        const char *pattern, *path;
    } cases[] = {{"out-%04d.png", "out-0007.png"},
                 {"%d", "7"},
                 {"a/%01d/b", "a/7/b"},
                 {"out.png", NULL},
                 {"%s", NULL},
                 {"%4d.png", NULL},
                 {"%d%d", NULL},
                 {"%", NULL},
                 {"%0d", NULL},
                 {"%04d-%n.png", NULL},
                 {"%010d", NULL},
                 {"twelve-bytes%d", NULL}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char path[13] = "";
        const bool done = frames_path(cases[i].pattern, 7, path, sizeof path);
        assert_int_equal(done, cases[i].path != NULL);
        if (done)
            assert_string_equal(path, cases[i].path);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(turntables_turn),
                                       cmocka_unit_test(turntables_roll),
                                       cmocka_unit_test(paths_go_through_their_keys),
                                       cmocka_unit_test(faults),
                                       cmocka_unit_test(frames_are_chosen),
                                       cmocka_unit_test(files_have_their_numbers)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
