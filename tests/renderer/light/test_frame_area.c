/* Area lights of any size, under OSMesa, against closed forms: an infinite plane of light, and
 * half of one. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { SIDE = 33, MIDDLE = 4 * (SIDE / 2 * SIDE + SIDE / 2) };

/* Radiance of a white diffuse surface at the origin: a parallelogram with the second edge
 * `tilt`. */
static double sent(GlContext *gl, const char *camera, const char *light, const char *tilt)
{
    char text[1024];
    MatcOptions options = frame_exact_options();
    MatcDocument *document;
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, %s, target: [0, 0, "
             "0], angle: 2 }\n"
             "lights: [{ light: Area, intensity: 1, bothSides: true, %s }]\n"
             "objects: [{ object: Parallelogram, u: [2, 0, 0], %s, material: { material: Phong, "
             "diffuse: 1 } }]\n",
             SIDE, SIDE, camera, light, tilt);
    Scene *scene = frame_scene(text, &options, &document);
    float *rgba = frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
    const double value = (double)rgba[MIDDLE];
    free(rgba);
    frame_forget(scene, document);
    return value;
}

#define FLAT "v: [0, 2, 0], transform: { translation: [-1, -1, 0] }"
static const char *const cameras[] = {"position: [0, -6, 2]", "position: [3, -5, 1]",
                                      "position: [-1, 2, 4]"};
enum { CAMERAS = sizeof cameras / sizeof *cameras };

/* A surface under an infinite plane of light receives (1 + n) / 2 of its light, n the cosine of
 * its tilt: 1 if horizontal, 0.8 at the cosine 0.6. */
static void planes_of_light(void **state)
{
    (void)state;
    static const char *const tilts[] = {
        FLAT, "v: [0, 1.2, 1.6], transform: { translation: [-1, -.6, -.8] }"};
    static const double edges[] = {1e5, 1e6, 1e7, 1e8, 1e9}, wanted[] = {1, .8};
    GlContext *gl = frame_context();
    for (int i = 0; i < 5 * CAMERAS * 2; i++) {
        char light[256];
        const double edge = edges[i % 5];
        snprintf(light, sizeof light,
                 "shadows: none, position: [%.9g, %.9g, 10], u: [%.9g, 0, 0], v: [0, %.9g, 0]",
                 -edge / 2, -edge / 2, edge, edge);
        const double value = sent(gl, cameras[i / 5 % CAMERAS], light, tilts[i / 5 / CAMERAS]);
        if (!(fabs(value - wanted[i / 5 / CAMERAS]) <= 2e-3))
            fail_msg("edges of %g, %s: %g, not %g", edge, cameras[i / 5 % CAMERAS], value,
                     wanted[i / 5 / CAMERAS]);
    }
    gl_close(gl);
}

/* A half plane of light from y = y0 on, at height 10, gives (1 - y0 / sqrt(y0^2 + 100)) / 2 to a
 * point that faces it. The other edges are as far away as possible, and one of them is oblique. */
static void half_planes_of_light(void **state)
{
    (void)state;
    static const double begins[] = {-30, -4, 0, .7, 5, 60};
    GlContext *gl = frame_context();
    for (int i = 0; i < 6 * CAMERAS; i++) {
        char light[256];
        const double y = begins[i % 6], wanted = (1 - y / sqrt(y * y + 100)) / 2;
        snprintf(light, sizeof light,
                 "shadows: none, position: [-5e8, %g, 10], u: [1e9, 0, 0], v: [3e8, 9e8, 0]", y);
        const double value = sent(gl, cameras[i / 6], light, FLAT);
        if (!(fabs(value - wanted) <= 3e-3))
            fail_msg("from y = %g, %s: %g, not %g", y, cameras[i / 6], value, wanted);
    }
    gl_close(gl);
}

/* Without occluders, shadow maps of the relevant part of the light leave all of its light. */
static void large_lights_may_cast(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    const double value =
        sent(gl, cameras[0], "position: [-5e8, -5e8, 10], u: [1e9, 0, 0], v: [0, 1e9, 0]", FLAT);
    assert_true(fabs(value - 1) <= 1e-2);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes_of_light),
        cmocka_unit_test(half_planes_of_light),
        cmocka_unit_test(large_lights_may_cast),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
