/* Frames of a motion drawn by one renderer, against each frame drawn by its own renderer: every
 * byte of their files. */
/* ctest: seconds=34 */
#include "tests/test.h"
#include "compiler/base/file.h"
#include "runtime/viewer/scene_picture.h"
#include "tests/frame/frame_calls.h"
#include "tests/frame/frame_draw.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define SOLIDS                                                                                     \
    "image: { width: 48, height: 32 }\ncamera: { camera: %s, position: [0, -6, 4], target: [0, "   \
    "0, .5] }\n"                                                                                   \
    "motion: { motion: Turntable, frames: 4 }\n"                                                   \
    "lights: [{ light: Point, position: [3, -2, 4], intensity: 12 }]\n"                            \
    "sky: { material: RGBA, r: .2, b: .4 }\n"                                                      \
    "objects:\n- { object: Plane, material: { material: Phong, diffuse: { map: Checker } } }\n"    \
    "- { object: Box, material: { material: Phong, diffuse: .5, specular: .3 }, transform: { "     \
    "translation: [-.8, 0, "                                                                       \
    ".5] } }\n"                                                                                    \
    "- { object: Sphere, radius: .5, material: { material: Phong, transparency: .6 }, transform: " \
    "{ translation: [.6, "                                                                         \
    ".4, 1] } }\n"

static char folder[] = "/tmp/matc_framesXXXXXX";

static char *bytes_of(const char *path, size_t *size)
{
    const char *why;
    char *bytes = file_read(path, size, &why);
    if (!bytes)
        fail_msg("%s: %s", path, why);
    return bytes;
}

static void assert_same_file(const char *a, const char *b)
{
    size_t size[2];
    char *bytes[2] = {bytes_of(a, &size[0]), bytes_of(b, &size[1])};
    assert_int_equal(size[0], size[1]);
    assert_memory_equal(bytes[0], bytes[1], size[0]);
    free(bytes[0]);
    free(bytes[1]);
}

/* Into FOLDER/one and FOLDER/own, which have to be alike; what is made on the driver's side for a
 * further frame. */
static int draw_both(GlContext *gl, Scene *scene, const ScenePictureOptions *options)
{
    char one[64], own[64];
    int made = 0;
    Scene seen = *scene, alone = *scene;
    ScenePicture picture;
    ScenePictures *pictures = NULL;
    snprintf(one, sizeof one, "%s/one", folder);
    snprintf(own, sizeof own, "%s/own", folder);
    for (int frame = 0; frame < scene->motion.frames; frame++) {
        assert_true(scene_motion_camera(scene, frame, scene->motion.frames, &seen.camera));
        frame_calls = (FrameCalls){0};
        if (pictures)
            assert_true(scene_pictures_turn(pictures, scene, &seen));
        else
            assert_true((pictures = scene_pictures_open(gl, options)) &&
                        scene_pictures_show(pictures, &seen));
        assert_true(scene_pictures_draw(pictures, one, &picture));
        made = frame_calls.made;
        alone.camera = seen.camera;
        ScenePictures *other = scene_pictures_open(gl, options);
        assert_true(other && scene_pictures_show(other, &alone) &&
                    scene_pictures_draw(other, own, &picture));
        scene_pictures_close(other);
        assert_same_file(one, own);
    }
    scene_pictures_close(pictures);
    return made;
}

static void frames_of_one_renderer(void **state)
{
    (void)state;
    static const char *const cameras[] = {"Perspective", "Orthographic"};
    GlContext *gl = frame_context();
    frame_count_calls(gl);
    assert_non_null(mkdtemp(folder));
    for (int i = 0; i < 2; i++) {
        char text[2048];
        MatcOptions compile;
        MatcDocument *document;
        matc_options_init(&compile);
        snprintf(text, sizeof text, SOLIDS, cameras[i]);
        Scene *scene = frame_scene(text, &compile, &document);
        ScenePictureOptions options = {
            .renderer = {.compile = &compile, .edges = RENDERER_EDGES_coverage}};
        /* the lines of edges, of another number */
        assert_int_equal(draw_both(gl, scene, &options), 1);
        options.renderer.tile[0] = options.renderer.tile[1] = 20;
        assert_int_equal(draw_both(gl, scene, &options), 1);
        options =
            (ScenePictureOptions){.renderer = {.compile = &compile, .transparency = "peeling"},
                                  .format = PICTURE_FORMAT_exr};
        assert_int_equal(draw_both(gl, scene, &options), 0);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

static int clean(void **state)
{
    (void)state;
    char command[64];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test_teardown(frames_of_one_renderer, clean)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
