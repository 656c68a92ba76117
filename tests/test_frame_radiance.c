/* Light of what the picture does not show: nothing of it gets through walls, what is behind the camera sends what rays in double say, and what changes is as if it were made
 * anew. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/frame/frame_draw.h"
#include "tests/frame/open_ray.h"
#include "tests/frame/shadow_ray.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = 64, PIXELS = EDGE * EDGE, TEXT = 4096, LANES = 4 };
#define IMAGE "image: { width: 64, height: 64 }\n"

/* Of red, green, blue. */
static double brightest(const float *rgba)
{
    double most = 0;
    for (int i = 0; i < LANES * PIXELS; i++)
        if (i % LANES < 3) {
            assert_true(isfinite(rgba[i]));
            most = fmax(most, rgba[i]);
        }
    return most;
}

static double brightest_of(GlContext *gl, const char *text)
{
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(text, &options, &document);
    float *rgba = frame_floats(gl, scene, &(RenderOptions){.compile = &options, .view = "light"});
    const double most = brightest(rgba);
    free(rgba);
    frame_forget(scene, document);
    return most;
}

/* -- walls */

/* Six slabs that cross in their corners, around a cube of edge 2; two lights outside, and a box far off, so that a voxel of 64 is 0.068 wide. */
static void put_room(double wall, const char *shadows, const char *rotation, char text[TEXT])
{
    int length = snprintf(text, TEXT,
                          IMAGE "voxels: { size: 64 }\nindirect: { rays: 24, radius: 8, bounces: 2 }\nlights:\n"
                                "- { light: Point, position: [2.3, -1.9, 2.2], intensity: 60, shadows: %s }\n"
                                "- { light: Directional, direction: [1, .4, -.7], intensity: 5, shadows: %s }\n"
                                "materials:\n  m: { material: Phong, diffuse: .8, specular: 0 }\nobjects:\n"
                                "- { object: Box, material: m, size: [.2, .2, .2], transform: { translation: [3, 3, 3] "
                                "} }\n- object: Group\n  material: m\n  transform: { rotation: [%s] }\n  objects:\n",
                          shadows, shadows, rotation);
    for (int i = 0; i < 6; i++) {
        double size[3], at[3] = {0};
        for (int k = 0; k < 3; k++)
            size[k] = k == i / 2 ? wall : 2 + 2 * wall;
        at[i / 2] = (i % 2 ? 1 : -1) * (1 + wall / 2);
        length +=
            snprintf(text + length, (size_t)(TEXT - length),
                     "  - { object: Box, size: [%.9g, %.9g, %.9g], transform: { translation: [%.9g, %.9g, %.9g] } }\n",
                     size[0], size[1], size[2], at[0], at[1], at[2]);
    }
}

/* What sRGB rounds to 1 of 255 at most. Maps have leaks of their own where walls are thinner than their texels and voxels. */
static void nothing_shines_through_walls(void **state)
{
    (void)state;
    static const char camera[] = "camera: { camera: Perspective, position: [%s], target: [0, .5, 0], angle: 80 }\n";
    static const char *const rotations[] = {"0, 0, 0", ".4, .7, .3"};
    static const struct {
        double wall;
        const char *shadows;
    } cases[] = {{.02, "exact"}, {.06, "exact"}, {.09, "exact"}, {.12, "exact"}, {.07, "map"}, {.12, "map"}};
    const double black = 1.5 / 255 / 12.92;
    GlContext *gl = frame_context();
    for (size_t i = 0; i < 2 * sizeof cases / sizeof *cases; i++) {
        char room[TEXT], text[2 * TEXT];
        put_room(cases[i / 2].wall, cases[i / 2].shadows, rotations[i % 2], room);
        int length = snprintf(text, sizeof text, camera, "0, -.8, .1");
        snprintf(text + length, sizeof text - (size_t)length, "%s", room);
        const double within = brightest_of(gl, text);
        print_message("walls of %.2f, shadows %s: %.2g of black\n", cases[i / 2].wall, cases[i / 2].shadows,
                      within / black);
        assert_true(within <= black);
        length = snprintf(text, sizeof text, camera, "4, -4, 3");
        snprintf(text + length, sizeof text - (size_t)length, "%s", room);
        if (i == 0)
            assert_true(brightest_of(gl, text) > .5);
    }
    gl_close(gl);
}

/* -- behind the camera */

/* A white wall is seen; behind the eye are a sheet whose sides differ, a mirrored box with a pattern, a ball, and what shades them. */
static const char behind[] = IMAGE
    "camera: { camera: Perspective, position: [0, -.5, 1], target: [0, 2, 1], angle: 50 }\nindirect: { rays: 96, "
    "radius: 9, filterSize: 4 }\nlights:\n- { light: Spot, position: [.5, .5, 3], direction: [-.1, -.8, -.6], "
    "intensity: 20, innerAngle: 50, outerAngle: 65, shadows: exact }\n- { light: Area, position: [-2, 0, 3], u: "
    "[.5, 0, 0], v: [0, .5, 0], intensity: 60, shadows: none }\nobjects:\n"
    "- { object: Box, size: [4, .2, 4], material: { material: Phong, diffuse: .9, specular: 0 }, transform: { "
    "translation: [0, 2, 1] } }\n"
    "- { object: Parallelogram, u: [3, 0, 0], v: [0, .8, 2.2], material: { material: SideSwitch, frontShader: { "
    "material: Phong, diffuse: [.9, .1, .1], specular: 0 }, backShader: { material: Phong, diffuse: [.1, .1, .9], "
    "specular: 0 } }, transform: { translation: [-1.5, -2.4, 0] } }\n"
    "- { object: Box, size: [1, 1, .3], material: { material: Phong, specular: 0, diffuse: { map: Checker, "
    "color1: [.1, .9, .2], color2: .2, input: { map: UVTransform, scaleU: 2, scaleV: 2 } } }, transform: { "
    "translation: [1, -.6, .1], scale: [-1, 1, 1], rotation: [.2, .1, .3] } }\n"
    "- { object: Sphere, radius: .4, material: { material: Phong, diffuse: .8, specular: 0, emissive: [0, 0, .2] "
    "}, transform: { translation: [-.8, -1.1, .9] } }\n";

static void shares_of(const Tracer *tracer, const SceneLight *light, const Hit *hit, double shares[3])
{
    const bool lit = light->shadows == WORD_Shadows_none || shadow_is_lit(tracer, light, hit->world, hit->facet);
    shares[0] = shares[1] = shares[2] = lit;
}

static void what_is_behind_the_camera_sends(void **state)
{
    (void)state;
    enum { APART = 8, ACROSS = 32 };
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    MatcDocument *document;
    Scene *scene = frame_scene(behind, &options, &document);
    Tracer tracer = reference_open(scene);
    tracer.shares = shares_of;
    float *rgba = frame_floats(gl, scene, &(RenderOptions){.compile = &options, .view = "indirect"});
    double mean = 0, is = 0, square = 0;
    int count = 0;
    for (int y = APART / 2; y < EDGE; y += APART)
        for (int x = APART / 2; x < EDGE; x += APART) {
            const Ray ray = reference_ray(scene, x + .5, y + .5);
            const Hit hit = reference_hit(&tracer, &ray, 0);
            OpenRays rays = {.across = ACROSS, .radius = 9, .bounces = 1, .state = (uint64_t)(y * EDGE + x)};
            if (hit.object != 0)
                continue;
            const Open open = open_ray(&tracer, &hit, &rays, &options);
            for (int k = 0; k < 3; k++, count++) {
                const double off = (double)rgba[LANES * (y * EDGE + x) + k] - open.light[k];
                mean += open.light[k];
                is += rgba[LANES * (y * EDGE + x) + k];
                square += off * off;
            }
        }
    print_message("of a mean of %.3g: %.3f off in the mean, %.3f its root of the mean square, of %d numbers\n",
                  mean / count, is / mean - 1, sqrt(square / count) / (mean / count), count);
    assert_true(count > 100 && mean / count > .01);
    assert_true(fabs(is / mean - 1) < .05 && sqrt(square / count) / (mean / count) < .1);
    reference_close(&tracer);
    free(rgba);
    frame_forget(scene, document);
    gl_close(gl);
}

/* -- changes */

static void assert_as_new(GlContext *gl, Render *render, const Scene *scene, const RenderOptions *options)
{
    float *as_new = frame_floats(gl, scene, options), *rgba = malloc(sizeof *rgba * LANES * PIXELS);
    assert_true(render_frame(render) && render_read(render, rgba));
    assert_memory_equal(as_new, rgba, sizeof *rgba * LANES * PIXELS);
    free(rgba);
    free(as_new);
}

static void what_changes_is_as_new(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    const RenderOptions how = {.compile = &options, .view = "indirect"};
    GlContext *gl = frame_context();
    MatcDocument *document;
    Scene *scene = frame_scene(behind, &options, &document);
    Render *render = render_open(gl, &how);
    assert_non_null(render);
    assert_true(render_scene(render, scene));
    assert_as_new(gl, render, scene, &how);
    scene->objects[2].world_from_local.m[13] += .3;
    assert_true(render_changed_objects(render, 2, 1));
    assert_as_new(gl, render, scene, &how);
    scene->lights[0].position[0] -= .7;
    assert_true(render_changed(render, RENDER_LIGHTS));
    assert_as_new(gl, render, scene, &how);
    render_close(render);
    frame_forget(scene, document);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_shines_through_walls),
        cmocka_unit_test(what_is_behind_the_camera_sends),
        cmocka_unit_test(what_changes_is_as_new),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
