/* Limits of scenes: the last accepted value and the first refused one. scene.h, scene_area.h and
 * scene_origin.c define the limits; docs/reference/stability.md lists those that an author may
 * meet. */
#include "runtime/scene_reader/scene_read.h"
#include "tests/test.h"
#include "runtime/scene/scene_area.h"
#include "runtime/scene/scene_origin.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Reads a scene. If it returns NULL, *document has the diagnostics. */
static Scene *read(const char *text, MatcDocument **document)
{
    MatcOptions options;
    Scene *scene = NULL;
    matc_options_init(&options);
    *document = scene_read("scene.yaml", text, strlen(text), &options, &scene);
    return scene;
}

/* `fine` is accepted, `beyond` is refused with a message that contains these words. */
static void assert_border(const char *fine, const char *beyond, const char *words)
{
    MatcDocument *document;
    Scene *scene = read(fine, &document);
    if (!scene)
        fail_msg("%s", matc_diagnostics(document, MATC_TEXT));
    scene_free(scene);
    matc_document_free(document);
    scene = read(beyond, &document);
    if (scene || !strstr(matc_diagnostics(document, MATC_TEXT), words))
        fail_msg("not '%s': %s", words, matc_diagnostics(document, MATC_TEXT));
    scene_free(scene);
    matc_document_free(document);
}

/* Appends a line `count` times. */
static char *repeat(char *to, const char *line, int count)
{
    for (int i = 0; i < count; i++)
        to += sprintf(to, "%s", line);
    return to;
}

static void planes(void **state)
{
    (void)state;
    static char texts[2][1 << 16];
    for (int i = 0; i < 2; i++) {
        char *to = texts[i] + sprintf(texts[i], "lights: [{ light: Ambient }]\nobjects:\n");
        repeat(to, "- { object: Plane, material: { material: Phong } }\n", 256 + i);
    }
    assert_border(texts[0], texts[1], "more than 256 planes");
}

/* 2^20 groups: 1,023 groups, each with 1,023 empty groups by an alias, which makes 1,024 with
 * itself, and 1,024 more. One further group is refused. */
static void objects_and_groups(void **state)
{
    (void)state;
    static char texts[2][1 << 18];
    for (int i = 0; i < 2; i++) {
        char *to = texts[i] + sprintf(texts[i], "lights: [{ light: Ambient }]\nobjects:\n"
                                                "- object: Group\n  objects: &many\n");
        to = repeat(to, "  - { object: Group, objects: [] }\n", 1023);
        to = repeat(to, "- { object: Group, objects: *many }\n", 1022);
        repeat(to, "- { object: Group, objects: [] }\n", 1024 + i);
    }
    assert_border(texts[0], texts[1], "more than 1048576 objects and groups");
}

/* A sphere of n steps counts as n * n triangles, so 64 spheres of 1,024 steps reach the limit. */
static void triangles(void **state)
{
    (void)state;
    static char texts[2][1 << 16];
    for (int i = 0; i < 2; i++) {
        char *to = texts[i] + sprintf(texts[i], "lights: [{ light: Ambient }]\nobjects:\n");
        for (int k = 0; k < 64; k++)
            to += sprintf(to,
                          "- { object: Sphere, radius: %d, detail: 1024, "
                          "material: { material: Phong } }\n",
                          k + 1);
        repeat(to, "- { object: Parallelogram, material: { material: Phong } }\n", i);
    }
    assert_border(texts[0], texts[1], "more than 67108864 triangles in distinct meshes");
}

/* An Area is clipped at 10,000 times the distance from camera to target, 5 here, to each side of
 * the camera's projection on the light's plane. */
static void edges_of_an_area(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        char text[512];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 "camera: { camera: Perspective, position: [0, -3, 4], target: [0, 0, 0] }\n"
                 "lights: [{ light: Area, position: [-50000, -50003, 0], u: [%d, 0, 0], v: [0, "
                 "100000, 0] }]\n",
                 100000 + i);
        Scene *scene = read(text, &document);
        if (!scene)
            fail_msg("%s", matc_diagnostics(document, MATC_TEXT));
        assert_true(scene_area_cuts(scene) == (i == 1));
        scene_free(scene);
        matc_document_free(document);
    }
}

/* A scene keeps the world's origin if the camera lies within 16 times the distance from camera to
 * target, 5 here, of it. The origin then stays until the camera has moved 1,024 times that
 * distance. */
static void origins_near_cameras(void **state)
{
    (void)state;
    static const double places[2] = {80, 80.1}, travels[2] = {5120, 5121};
    for (int i = 0; i < 2; i++) {
        char text[512];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 "camera: { camera: Perspective, position: [%g, 0, 0], target: [%g, 5, 0] }\n"
                 "lights: [{ light: Ambient }]\n"
                 "objects: [{ object: Box, material: { material: Phong } }]\n",
                 places[i], places[i]);
        Scene *scene = read(text, &document);
        if (!scene)
            fail_msg("%s", matc_diagnostics(document, MATC_TEXT));
        assert_true(scene_origin_used(scene) == (i == 1));
        SceneCamera camera = scene->camera;
        camera.position[0] = camera.target[0] = travels[i];
        assert_true(scene_origin_follow(scene, &camera) == (i == 1));
        scene_free(scene);
        matc_document_free(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes), cmocka_unit_test(objects_and_groups), cmocka_unit_test(triangles),
        cmocka_unit_test(edges_of_an_area), cmocka_unit_test(origins_near_cameras)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
