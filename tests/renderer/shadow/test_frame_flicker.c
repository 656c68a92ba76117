/* Steps of a moving light: with exact shadows no pixel flickers that does not flicker by rays;
 * with shadow maps some do. The flicker measure is checked by hand. */
#include "tests/test.h"
#include "tests/frame/flicker.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/shadow_judge.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDE = 72, HIGH = 54, PIXELS = WIDE * HIGH, STEPS = 32 };

#define SCENE                                                                                      \
    "image: { width: 72, height: 54 }\nshadowMaps: { size: 64 }\n"                                 \
    "camera: { camera: Perspective, position: [1.5, -7, 4], target: [0, 0, .5], angle: 36 }\n"     \
    "materials: { m: { material: Phong, diffuse: .5 } }\n"                                         \
    "lights: [{ light: %s, shadows: %s }]\nobjects:\n"                                             \
    "- { object: Parallelogram, u: [8, 0, 0], v: [0, 8, 0], material: m, transform: { "            \
    "translation: [-4, -4, 0] } }\n"                                                               \
    "- { object: Sphere, radius: .8, detail: 24, material: m, transform: { translation: [-.6, "    \
    "-.4, .8] } }\n"                                                                               \
    "- { object: Box, material: m, transform: { translation: [1, .5, .5], rotation: [0, 0, .3] } " \
    "}\n"                                                                                          \
    "- { object: Cone, radius: .3, height: 1.4, detail: 24, material: m, transform: { "            \
    "translation: [.6, -1.4, 0] } "                                                                \
    "}\n"

/* By hand: a pixel with one true turn turns three times, or once but a step later, or not at
 * all; or is invisible for a while. */
static void by_hand(void **state)
{
    (void)state;
    static const float should[4][4] = {{1, 1, 1, 1}, {1, 1, 1, 1}, {0, 0, 0, -1}, {0, 0, 0, 1}};
    static const float is[4][4] = {{1, 1, 1, 1}, {0, .6f, 1, 1}, {1, .5f, 1, -1}, {0, 0, 1, 1}};
    Flicker truth, made;
    assert_true(flicker_open(4, &truth) && flicker_open(4, &made));
    for (int step = 0; step < 4; step++) {
        flicker_add(&truth, should[step]);
        flicker_add(&made, is[step]);
    }
    assert_int_equal(flicker_turns(&truth), 3);
    assert_int_equal(flicker_turns(&made), 4);
    assert_int_equal(flicker_count(&made, &truth), 1);
    assert_int_equal(flicker_count(&truth, &made), 0);
    flicker_close(&truth);
    flicker_close(&made);
}

/* A scene, and what draws it; without shadows it is the same. */
typedef struct {
    MatcDocument *document;
    Scene *scene;
    Renderer *renderer;
} Drawn;

static Drawn open_drawn(GlContext *gl, const char *light, const char *method,
                        const RendererOptions *how)
{
    Drawn drawn;
    char text[2048];
    snprintf(text, sizeof text, SCENE, light, method);
    drawn.scene = frame_scene(text, how->compile, &drawn.document);
    drawn.renderer = renderer_open(gl, how);
    assert_true(drawn.renderer && renderer_set_scene(drawn.renderer, drawn.scene));
    return drawn;
}

static void close_drawn(Drawn *drawn)
{
    renderer_close(drawn->renderer);
    frame_forget(drawn->scene, drawn->document);
}

/* Around the z axis by a degree, and up. */
static void move(SceneLight *light)
{
    const double c = cos(PI / 180), s = sin(PI / 180);
    double *const both[2] = {light->position, light->direction};
    for (int i = 0; i < 2; i++) {
        const double x = both[i][0], y = both[i][1];
        both[i][0] = c * x - s * y;
        both[i][1] = s * x + c * y;
    }
    light->position[2] += .01;
}

static void step(Drawn *drawn, float *rgba)
{
    move(&drawn->scene->lights[0]);
    assert_true(renderer_changed(drawn->renderer, RENDERER_LIGHTS) &&
                renderer_frame(drawn->renderer) && renderer_read(drawn->renderer, rgba));
}

/* Shares by rays; ties take the drawn value. */
static void trace(const Scene *scene, const float *with, const float *without, float shares[PIXELS])
{
    Tracer tracer = reference_open(scene);
    const ShadowJudge judge = shadow_judge(&tracer);
    for (int i = 0; i < PIXELS; i++) {
        const bool lit = with[4 * i] > .5f * without[4 * i];
        const double at[2] = {i % WIDE + .5, i / WIDE + .5};
        const bool seen = without[4 * i] > 1e-7f;
        shares[i] =
            !seen ? -1
                  : lit != (shadow_verdict(&judge, &scene->lights[0], at, lit) == SHADOW_wrong);
    }
    reference_close(&tracer);
}

typedef struct {
    Flicker exact, map, truth;
} Flickers;

static void walk(Drawn drawn[3], Flickers *made)
{
    static float pictures[3][4 * PIXELS], shares[PIXELS];
    for (int i = 0; i < STEPS; i++) {
        for (int k = 0; k < 3; k++)
            step(&drawn[k], pictures[k]);
        flicker_add_pictures(&made->exact, pictures[0], pictures[2]);
        flicker_add_pictures(&made->map, pictures[1], pictures[2]);
        trace(drawn[0].scene, pictures[0], pictures[2], shares);
        flicker_add(&made->truth, shares);
    }
}

static void by_a_light(GlContext *gl, const char *light)
{
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "light"},
                          bare = {.compile = &options, .view = "light", .no_shadows = true};
    Drawn drawn[3] = {open_drawn(gl, light, "exact", &how), open_drawn(gl, light, "map", &how),
                      open_drawn(gl, light, "map", &bare)};
    Flickers made;
    assert_true(flicker_open(PIXELS, &made.exact) && flicker_open(PIXELS, &made.map) &&
                flicker_open(PIXELS, &made.truth));
    walk(drawn, &made);
    print_message("%.11s: %ld turns, flickers: %ld exact, %ld by a map\n", light,
                  flicker_turns(&made.truth), flicker_count(&made.exact, &made.truth),
                  flicker_count(&made.map, &made.truth));
    assert_true(flicker_turns(&made.truth) > 100);
    assert_int_equal(flicker_count(&made.exact, &made.truth), 0);
    assert_int_equal(flicker_count(&made.truth, &made.exact), 0);
    assert_true(flicker_count(&made.map, &made.truth) > 5);
    for (int i = 0; i < 3; i++)
        close_drawn(&drawn[i]);
    flicker_close(&made.exact);
    flicker_close(&made.map);
    flicker_close(&made.truth);
}

static void steps(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    by_a_light(gl, "Directional, direction: [1, 1, -1]");
    by_a_light(gl, "Point, position: [-3, -2, 3]");
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(by_hand), cmocka_unit_test(steps)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
