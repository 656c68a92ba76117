/* Exact shadows in cases that random scenes hardly reach: rays exactly through edges, geometry
 * behind a light, a camera that moves past opaque objects only, copies of which one is mirrored,
 * glass with two kinds of shadow at once. */
/* ctest: seconds=22 */
#include "tests/test.h"
#include "tests/frame/frame_change.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { EDGE = 64, PIXELS = EDGE * EDGE };

/* From above: a pixel is 1/32 wide, so that all that follows is exact in floats. */
#define HEAD                                                                                       \
    "image: { width: 64, height: 64 }\n"                                                           \
    "camera: { camera: Orthographic, position: [0, 0, 8], target: [0, 0, 0], up: [0, 1, 0], "      \
    "size: 2 }\n"                                                                                  \
    "materials: { m: { material: Phong, diffuse: .5 } }\n"
#define GROUND                                                                                     \
    "objects:\n- { object: Parallelogram, u: [8, 0, 0], v: [0, 8, 0], material: m, transform: { "  \
    "translation: [-4, "                                                                           \
    "-4, 0] } }\n"

static int count_dark(const char *text)
{
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "light"};
    MatcDocument *document;
    GlContext *gl = frame_context();
    Scene *scene = frame_scene(text, &options, &document);
    float *rgba = frame_floats(gl, scene, &how);
    int dark = 0;
    for (int i = 0; i < PIXELS; i++)
        dark += rgba[4 * i] <= 0;
    free(rgba);
    frame_forget(scene, document);
    gl_close(gl);
    return dark;
}

/* A square of two triangles, beside what is seen, and light over it at 45 degrees: rays of pixels
 * on a diagonal go through the edge that the triangles share, and are stopped, like all others. */
static void edges(void **state)
{
    (void)state;
    assert_int_equal(
        count_dark(
            HEAD "lights: [{ light: Directional, direction: [1, 0, -1], shadows: exact }]\n" GROUND
                 "- { object: Parallelogram, u: [2, 0, 0], v: [0, 2, 0], material: m, transform: { "
                 "translation: [-3, -1, 2] } }\n"),
        PIXELS);
}

/* A ceiling over a lamp. */
static void beyond(void **state)
{
    (void)state;
    assert_int_equal(
        count_dark(
            HEAD
            "lights: [{ light: Point, position: [2, 0, 3], intensity: 9, shadows: exact }]\n" GROUND
            "- { object: Parallelogram, u: [8, 0, 0], v: [0, 8, 0], material: m, transform: { "
            "translation: [1.5, "
            "-4, 4] } }\n"),
        0);
}

/* -- changes, where nothing is transparent */

#define MOVING                                                                                     \
    "image: { width: 64, height: 64 }\n"                                                           \
    "camera: { camera: Perspective, position: [1.5, -7, 4], target: [0, 0, .5], angle: 32 }\n"     \
    "materials: { m: { material: Phong, diffuse: .5 } }\n"                                         \
    "lights: [{ light: Point, position: [-3, -3, 4], intensity: 20, shadows: exact }]\n" GROUND    \
    "- { object: Cone, radius: .5, height: 1, material: m, transform: { translation: [-1, .5, 0] " \
    "} }\n"                                                                                        \
    "- { object: Cone, radius: .5, height: 1, material: m, transform: { translation: [.8, 0, 0] "  \
    "} }\n"                                                                                        \
    "- { object: Cone, radius: .5, height: 1, material: m, transform: { translation: [0, -1.2, "   \
    "0] } }\n"

static void changes(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "light"};
    MatcDocument *document;
    GlContext *gl = frame_context();
    Scene *scene = frame_scene(MOVING, &options, &document);
    Renderer *renderer = renderer_open(gl, &how);
    assert_true(renderer && renderer_set_scene(renderer, scene));
    free(frame_change_next(renderer));
    scene->camera.position[0] += .25;
    assert_true(renderer_changed(renderer, RENDERER_CAMERA));
    frame_change_assert(gl, &how, renderer, scene);
    scene->objects[1].world_from_local.m[13] += .25; /* within what there is: it alone is written */
    assert_true(renderer_changed_objects(renderer, 1, 1));
    frame_change_assert(gl, &how, renderer, scene);
    for (int i = 0; i < 4; i++) /* mirrored, it is drawn after its copies */
        scene->objects[1].world_from_local.m[i] *= -1;
    assert_true(renderer_changed_objects(renderer, 1, 1));
    frame_change_assert(gl, &how, renderer, scene);
    renderer_close(renderer);
    frame_forget(scene, document);
    gl_close(gl);
}

/* A pane that casts by its triangle in one light and by a map in the other, beside a cut-out, by
 * maps in both: light is the sum of each light's own. */
static void two_ways(void **state)
{
    (void)state;
    static const char text[] =
        "image: { width: 64, height: 64 }\nshadowMaps: { size: 256 }\n"
        "camera: { camera: Orthographic, position: [0, 0, 8], target: [0, 0, 0], up: [0, 1, 0], "
        "size: 4 }\n"
        "materials:\n  m: { material: Phong, diffuse: .5 }\n  glass: { material: Phong, diffuse: "
        "0, transparency: .5 "
        "}\n"
        "  net: { material: Phong, diffuse: .5, transparency: { map: Checker, color1: 1, color2: 0 "
        "} }\n"
        "lights:\n- { light: Directional, direction: [1, 0, -1], shadows: exact }\n"
        "- { light: Directional, direction: [0, 1, -1], shadows: map }\n" GROUND
        "- { object: Parallelogram, u: [1, 0, 0], v: [0, 1, 0], material: glass, transform: { "
        "translation: [-1.5, "
        "-1.5, "
        "1] } }\n"
        "- { object: Parallelogram, u: [1, 0, 0], v: [0, 1, 0], material: net, transform: { "
        "translation: [0, 0, 1] } "
        "}\n";
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "light", .deep = true};
    GlContext *gl = frame_context();
    float *pictures[3];
    int halves = 0;
    for (int i = 0; i < 3; i++) { /* both, the first, the second */
        MatcDocument *document;
        Scene *scene = frame_scene(text, &options, &document);
        scene->lights[0] = scene->lights[i == 2];
        scene->light_count = i ? 1 : 2;
        pictures[i] = frame_floats(gl, scene, &how);
        frame_forget(scene, document);
    }
    for (int i = 0; i < 4 * PIXELS; i++)
        assert_true(i % 4 == 3 || fabsf(pictures[0][i] - pictures[1][i] - pictures[2][i]) <= 1e-5f);
    for (int i = 0; i < PIXELS; i++)
        halves += fabsf(pictures[1][4 * i] / pictures[1][0] - .5f) < .01f;
    assert_true(halves > 100); /* the pane's shadow is there */
    for (int i = 0; i < 3; i++)
        free(pictures[i]);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(edges), cmocka_unit_test(beyond),
                                       cmocka_unit_test(changes), cmocka_unit_test(two_ways)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
