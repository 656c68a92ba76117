/* Glass on an opaque surface: the touching faces are coplanar, and no pixel shows the glass as
 * nearer. Each picture is compared with that of a block that extends slightly below, whose face
 * is certainly hidden. */
/* ctest: unsanitized */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 160, HEIGHT = 120, PIXELS = WIDTH * HEIGHT };

/* The floor below the block; the camera; the block's rotation. */
static const struct {
    const char *name, *floor, *camera, *turn;
} cases[] = {
    {"a plane", "Plane", "position: [2.6, -4.2, 2.2], target: [0, 0, .5], angle: 30", "[0, 0, 0]"},
    {"a plane, turned", "Plane", "position: [2.6, -4.2, 2.2], target: [0, 0, .5], angle: 30",
     "[0, 0, 27]"},
    {"a plane, from above", "Plane", "position: [.3, -1.2, 6.2], target: [0, 0, .5], angle: 30",
     "[0, 0, 11]"},
    {"a plane, grazing", "Plane", "position: [1.1, -6, .9], target: [0, 0, .3], angle: 20",
     "[0, 0, 40]"},
    {"a plane, far away", "Plane", "position: [260, -420, 220], target: [0, 0, .5], angle: .3",
     "[0, 0, 27]"},
    {"a quadrangle",
     "Parallelogram, u: [9, 0, 0], v: [2, 9, 0], transform: { translation: [-5, -4.5, 0] }",
     "position: [2.6, -4.2, 2.2], target: [0, 0, .5], angle: 30", "[0, 0, 27]"},
    {"a block",
     "Box, size: [3.3, 3.7, 1], transform: { translation: [0, 0, -.5], rotation: [0, 0, 33] }",
     "position: [2.6, -4.2, 2.2], target: [0, 0, .5], angle: 30", "[0, 0, 8]"},
};
enum { CASES = sizeof cases / sizeof *cases };

/* The block's top stays where it is; `below` is how far it reaches into the floor. */
static float *draw(GlContext *gl, int number, double below, const char *way)
{
    char text[2048];
    MatcDocument *document;
    const MatcOptions options = frame_exact_options();
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, %s }\nlights: [{ "
             "light: Directional, "
             "direction: [-.4, .5, -.7], intensity: 2, shadows: false }, "
             "{ light: Ambient, intensity: .3 }]\nobjects:\n- { object: %s, material: { material: "
             "Phong, diffuse: [.8, "
             ".7, .5], ambient: 1 } }\n"
             "- { object: Box, size: [1, 1, %.9g], transform: { translation: [0, 0, %.9g], "
             "rotation: %s }, material: { "
             "material: Phong, diffuse: [.1, .4, .1], transparency: [.5, .6, .5] } }\n",
             WIDTH, HEIGHT, cases[number].camera, cases[number].floor, 1 + below, (1 - below) / 2,
             cases[number].turn);
    Scene *scene = frame_scene(text, &options, &document);
    float *rgba = frame_floats(
        gl, scene, &(RendererOptions){.compile = &options, .view = "light", .transparency = way});
    frame_forget(scene, document);
    return rgba;
}

static bool is_apart(const float *a, const float *b)
{
    for (int component = 0; component < 3; component++)
        if (fabsf(a[component] - b[component]) > .01F)
            return true;
    return false;
}

/* Number of pixels that differ among those that show the glass; the outline, which moves with
 * its lower side by a fraction of a pixel, is small. */
static void faces_on_the_floor_are_hidden(void **state)
{
    int faults = 0;
    for (int way = 0; way < 2; way++)
        for (int i = 0; i < CASES; i++) {
            const char *const ways[] = {"lists", "peeling"};
            float *on = draw(*state, i, 0, ways[way]), *into = draw(*state, i, 1e-3, ways[way]),
                  *none = draw(*state, i, -.999, ways[way]);
            int apart = 0, seen = 0;
            for (int pixel = 0; pixel < PIXELS; pixel++) {
                apart += is_apart(on + 4 * pixel, into + 4 * pixel);
                seen += is_apart(on + 4 * pixel, none + 4 * pixel);
            }
            print_message("%s on %s: %d of %d pixels\n", ways[way], cases[i].name, apart, seen);
            faults += apart > seen / 500 || seen < PIXELS / 50;
            free(on);
            free(into);
            free(none);
        }
    assert_int_equal(faults, 0);
}

int main(void)
{
    GlContext *gl = frame_context();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate(faces_on_the_floor_are_hidden, gl)};
    const int result = cmocka_run_group_tests(tests, NULL, NULL);
    gl_close(gl);
    return result;
}
