/* Silhouette shadows of a scene that changes, beside other lights, with something of glass, and on drivers that cannot have them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/frame/frame_calls.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ON_PLANE "objects:\n- { object: Plane, material: m }\n"
#define THINGS                                                                                                         \
    "- { object: Sphere, radius: .8, material: m, transform: { translation: [-.6, -.4, .8] } }\n"                      \
    "- { object: Box, material: m, transform: { translation: [1, .5, .5], rotation: [0, 0, .3] } }\n"                  \
    "- { object: Box, size: [.5, .5, .5], material: m, transform: { translation: [1.1, .5, 1.25] } }\n"                \
    "- { object: Cylinder, radius: .3, height: .8, material: m, transform: { translation: [.6, -1.4, 0] } }\n"         \
    "- { object: Cone, radius: .3, height: .6, material: m, transform: { translation: [.6, -1.4, .8] } }\n"            \
    "- { object: Parallelogram, u: [0, 1.6, 0], v: [.4, 0, 1], material: m, transform: { translation: [-2.2, -.6, 0] " \
    "} }\n"
#define MIXED                                                                                                          \
    "image: { width: 64, height: 48 }\n"                                                                               \
    "camera: { camera: Perspective, position: [1.5, -7, 4], target: [0, 0, .5], angle: 42 }\nshadowMaps: { size: 64 "  \
    "}\n"                                                                                                              \
    "materials: { m: { material: Phong, diffuse: .5 }, g: { material: Phong, diffuse: 0, transparency: %s, "           \
    "interpolatedTransparency: false } }\n"                                                                            \
    "lights: [{ light: Directional, direction: [1, 1, -2], shadows: silhouette },\n"                                   \
    "  { light: Point, position: [1, -2, 4], intensity: 9, shadows: silhouette },\n"                                   \
    "  { light: Point, position: [-2, -2, 3], intensity: 4, shadows: map }]\n" ON_PLANE THINGS                         \
    "- { object: Parallelogram, u: [1, 0, 0], v: [0, 1, 0], material: g, transform: { translation: [-.4, -1.6, 1.3] "  \
    "} }\n"

static Scene *mixed_scene(const MatcOptions *options, const char *through, MatcDocument **document)
{
    char text[6144];
    snprintf(text, sizeof text, MIXED, through);
    return frame_scene(text, options, document);
}

static float *read_frame(Render *render)
{
    const size_t pixels = (size_t)render_tile_width(render) * (size_t)render_tile_height(render);
    float *rgba = calloc(pixels, 4 * sizeof *rgba);
    assert_true(rgba && render_frame(render) && render_read(render, rgba));
    return rgba;
}

/* The picture is the one that a new renderer draws. */
static void assert_as_new(GlContext *gl, const RenderOptions *how, Render *changed, const Scene *scene)
{
    Render *fresh = render_open(gl, how);
    assert_true(fresh && render_scene(fresh, scene));
    float *a = read_frame(changed), *b = read_frame(fresh);
    assert_memory_equal(a, b, (size_t)scene->width * (size_t)scene->height * 4 * sizeof *a);
    render_close(fresh);
    free(a);
    free(b);
}

/* After an object, lights and the camera moved; no further frame makes or writes anything. */
static void changes(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    const RenderOptions how = {.compile = &options, .view = "light"};
    MatcDocument *document;
    GlContext *gl = frame_context();
    Scene *scene = mixed_scene(&options, ".5", &document);
    Render *render = render_open(gl, &how);
    frame_count_calls(gl);
    assert_true(render && render_scene(render, scene));
    free(read_frame(render));
    frame_calls = (FrameCalls){0};
    free(read_frame(render));
    assert_true(frame_calls.made == 0 && frame_calls.written == 0);
    scene->objects[1].world_from_local.m[12] += 3.25; /* maps are fitted to it */
    assert_true(render_changed_objects(render, 1, 1));
    assert_as_new(gl, &how, render, scene);
    scene->lights[1].position[0] -= .5;
    assert_true(render_changed(render, RENDER_LIGHTS));
    assert_as_new(gl, &how, render, scene);
    scene->camera.position[2] += .25;
    assert_true(render_changed(render, RENDER_CAMERA));
    assert_as_new(gl, &how, render, scene);
    render_close(render);
    frame_forget(scene, document);
    gl_close(gl);
}

/* Other triangles are seen where something opaque has moved, and nothing is counted again. */
static void facets(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    const RenderOptions how = {.compile = &options, .view = "light", .opaque = true};
    MatcDocument *document;
    GlContext *gl = frame_context();
    Scene *scene = mixed_scene(&options, ".5", &document);
    Render *render = render_open(gl, &how);
    assert_true(render && render_scene(render, scene));
    free(read_frame(render));
    scene->objects[1].world_from_local.m[12] += .5;
    assert_true(render_changed_objects(render, 1, 1));
    assert_as_new(gl, &how, render, scene);
    render_close(render);
    frame_forget(scene, document);
    gl_close(gl);
}

/* What is transparent colours light by the maps: half of it; a quarter where the shadow is seen through the pane. */
static void glass(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    const RenderOptions how = {.compile = &options, .view = "light"};
    MatcDocument *documents[2];
    GlContext *gl = frame_context();
    float *pictures[2];
    Scene *scenes[2];
    int darker = 0, twice = 0, alike = 0;
    for (int i = 0; i < 2; i++) {
        scenes[i] = mixed_scene(&options, i ? ".5" : "1", &documents[i]);
        scenes[i]->light_count = 1;
        pictures[i] = frame_floats(gl, scenes[i], &how);
    }
    for (int i = 0; i < scenes[0]->width * scenes[0]->height; i++) {
        const float clear = pictures[0][4 * i], dim = pictures[1][4 * i];
        assert_true(dim <= clear * 1.001f && dim >= .25f * clear * .999f);
        darker += fabsf(dim - .5f * clear) < 1e-3f * clear;
        twice += fabsf(dim - .25f * clear) < 1e-3f * clear;
        alike += dim == clear && clear > .01f;
    }
    print_message("%d darker, %d twice, %d alike\n", darker, twice, alike);
    assert_true(darker > 25 && twice > 8 && alike > 1000);
    for (int i = 0; i < 2; i++) {
        free(pictures[i]);
        frame_forget(scenes[i], documents[i]);
    }
    gl_close(gl);
}

static void older_drivers(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    GlContext *gl = frame_context();
    Scene *scene = mixed_scene(&options, ".5", &document);
    gl->major = gl->minor = 3;
    Render *render = render_open(gl, &(RenderOptions){.compile = &options});
    assert_non_null(render);
    assert_false(render_scene(render, scene));
    assert_non_null(strstr(gl->error, "shadows: silhouette takes OpenGL 4.5, and the driver has 3.3"));
    render_close(render);
    frame_forget(scene, document);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(changes), cmocka_unit_test(facets), cmocka_unit_test(glass),
                                       cmocka_unit_test(older_drivers)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
