/* Number of a light's shadow maps, distance of the nearest shadow caster, surfaces that must not
 * shadow themselves: limits that scene.def and shadow_views.c name. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 16, TEXT = 1024 };
#define PICTURE "image: { width: 16, height: 16 }\nshadowMaps: { size: 64 }\n"

/* A spot has one map below 120 degrees, and six like a point from there on. A directional light has
 * one for each cascade. */
static void lights_have_their_maps(void **state)
{
    (void)state;
    static const struct {
        const char *light;
        int maps;
    } rows[] = {{"light: Spot, innerAngle: 10, outerAngle: 59.9", 1},
                {"light: Spot, innerAngle: 10, outerAngle: 60.1", 6},
                {"light: Point", 6},
                {"light: Directional", 3},
                {"light: Directional, shadows: none", 0}};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[TEXT];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 PICTURE
                 "lights: [{ %s%s }]\nobjects: [{ object: Box, material: { material: Phong } }]\n",
                 rows[i].light, strstr(rows[i].light, "Direct") ? "" : ", position: [0, 0, 4]");
        Scene *scene = frame_scene(text, &options, &document);
        scene->shadow_cascades = 3;
        Renderer *renderer =
            renderer_open(gl, &(RendererOptions){.compile = &options, .view = "light"});
        free(frame_floats_by(gl, renderer, scene));
        if (renderer_map_count(renderer) != rows[i].maps)
            fail_msg("%s: %d maps", rows[i].light, renderer_map_count(renderer));
        renderer_close(renderer);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* A lid below a lamp shadows the floor if the floor's farthest corner is about a thousand times as
 * far away as the lid. A lid at a tenth of that distance is nearer than the maps' near plane. */
static void near_objects_cast_shadows(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (int i = 0; i < 2; i++) {
        const double below = i ? .007 : .07;
        char text[TEXT];
        MatcDocument *document;
        snprintf(
            text, sizeof text,
            PICTURE
            "camera: { camera: Perspective, position: [0, -20, 5], target: [0, 0, 0], angle: 4 }\n"
            "lights: [{ light: Point, position: [0, 0, 10], intensity: 100 }]\nobjects:\n"
            "- { object: Box, size: [100, 100, 1], material: { material: Phong, diffuse: 1 }, "
            "transform: { translation: [0, 0, -.5] } }\n"
            "- { object: Parallelogram, u: [%g, 0, 0], v: [0, %g, 0], material: { material: "
            "Phong }, transform: { translation: [%g, %g, %g] } }\n",
            below, below, -below / 2, -below / 2, 10 - below);
        Scene *scene = frame_scene(text, &options, &document);
        float *light =
            frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
        const float middle = light[4 * (SIDE / 2 * SIDE + SIDE / 2)];
        assert_true(i ? middle > .9f : middle == 0);
        free(light);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* A leaf, lit from behind by a lamp at distance 3, must not shadow itself. Its diffuse transmission
 * is 9 (intensity) x 0.8 cos / 9 (distance squared). */
static void leaves_do_not_shade_themselves(void **state)
{
    (void)state;
    static const char text[] = PICTURE
        "camera: { camera: Perspective, position: [0, -10, 0], target: [0, 0, 0], angle: 2 }\n"
        "lights: [{ light: Point, position: [0, 3, 0], intensity: 9 }]\n"
        "objects: [{ object: Parallelogram, u: [4, 0, 0], v: [0, 0, 4], transform: { translation: "
        "[-2, 0, -2] }, material: { material: Phong, diffuse: 0, diffuseTransparency: .8 } }]\n";
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    GlContext *gl = frame_context();
    Scene *scene = frame_scene(text, &options, &document);
    float *light =
        frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
    for (int i = 0; i < SIDE * SIDE; i++)
        assert_true(light[4 * i] > .78f && light[4 * i] < .81f);
    free(light);
    gl_close(gl);
    frame_forget(scene, document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(lights_have_their_maps),
                                       cmocka_unit_test(near_objects_cast_shadows),
                                       cmocka_unit_test(leaves_do_not_shade_themselves)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
