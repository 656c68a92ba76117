/* Transparent fragments and layers are counted a second time after the scene changes: a list
 * sized for a few would lose fragments. */
/* ctest: seconds=25 */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    WIDTH = 32,
    HEIGHT = 24,
    FAR_FRAGMENTS = 400,
    CAPACITY = 4 * (4 + WIDTH * HEIGHT + 6 * FAR_FRAGMENTS)
};

/* Two distant boxes of glass with some hundred fragments; from nearby each fills the picture. */
static const char far_away[] =
    "image: { width: 32, height: 24 }\ncamera: { camera: Perspective, position: [0, -40, 0], "
    "angle: 20 }\n"
    "lights: [{ light: Ambient }]\nsky: { material: RGBA, g: .5 }\nobjects:\n"
    "- { object: Box, material: { material: Phong, ambient: [.5, .1, .1], transparency: .5 } }\n"
    "- { object: Box, material: { material: Phong, ambient: [.1, .1, .5], transparency: [.5, .9, "
    ".3] }, transform: { "
    "translation: [.2, 4, 0] } }\n";

typedef enum { MOVE_objects, MOVE_camera } Move;

static bool move(Renderer *renderer, Scene *scene, Move what)
{
    if (what == MOVE_camera) {
        scene->camera.position[1] = -3;
        return renderer_changed(renderer, RENDERER_CAMERA);
    }
    for (int i = 0; i < 2; i++)
        scene->objects[i].world_from_local.m[13] -= 37;
    return renderer_changed_objects(renderer, 0, 2);
}

/* The picture after a move, from malloc; another one was drawn before. */
static float *draw_moved(GlContext *gl, Scene *scene, const RendererOptions *options, Move what)
{
    float *rgba = calloc((size_t)WIDTH * HEIGHT, 4 * sizeof *rgba);
    Renderer *renderer = renderer_open(gl, options);
    assert_true(rgba && renderer && renderer_set_scene(renderer, scene) &&
                renderer_frame(renderer));
    assert_true(move(renderer, scene, what) && renderer_frame(renderer) &&
                renderer_read(renderer, rgba));
    renderer_close(renderer);
    return rgba;
}

/* Equals a new renderer's picture, bit for bit: with lists, with peeling, and when lists become
 * too long. */
static void more_are_counted(void **state)
{
    (void)state;
    static const RendererOptions ways[] = {{.transparency = "lists"},
                                           {.transparency = "peeling"},
                                           {.transparency = NULL, .list_bytes = CAPACITY}};
    const MatcOptions compile = frame_exact_options();
    for (int i = 0; i < 6; i++) {
        MatcDocument *document;
        Scene *scene = frame_scene(far_away, &compile, &document);
        GlContext *gl = frame_context();
        RendererOptions options = ways[i / 2];
        options.compile = &compile;
        options.view = "light";
        float *moved = draw_moved(gl, scene, &options, (Move)(i % 2));
        float *new = frame_floats(gl, scene, &options);
        assert_memory_equal(moved, new, (size_t)WIDTH * HEIGHT * 4 * sizeof *new);
        /* there is glass before the sky */
        assert_true(new[4 * (HEIGHT / 2 * WIDTH + WIDTH / 2)] > .1f);
        free(moved);
        free(new);
        gl_close(gl);
        frame_forget(scene, document);
    }
}

/* Whether a pass runs, by the graph. */
static bool runs(const Renderer *renderer, const char *line)
{
    char *graph = frame_graph(renderer);
    const bool found = strstr(graph, line) != NULL;
    free(graph);
    return found;
}

/* Switches from lists to peeling; or, if lists are required, an error. */
static void lists_that_are_too_long(void **state)
{
    (void)state;
    const MatcOptions compile = frame_exact_options();
    for (int insists = 0; insists < 2; insists++) {
        MatcDocument *document;
        Scene *scene = frame_scene(far_away, &compile, &document);
        GlContext *gl = frame_context();
        const RendererOptions options = {
            .compile = &compile, .list_bytes = CAPACITY, .transparency = insists ? "lists" : NULL};
        Renderer *renderer = renderer_open(gl, &options);
        assert_true(renderer && renderer_set_scene(renderer, scene) && renderer_frame(renderer));
        assert_false(runs(renderer, "lists depth lists not run"));
        assert_true(move(renderer, scene, MOVE_objects));
        assert_int_equal(renderer_frame(renderer), !insists);
        if (insists)
            assert_non_null(strstr(gl->error, "transparent fragments take"));
        else
            assert_true(runs(renderer, "lists depth lists not run: nothing to do"));
        renderer_close(renderer);
        gl_close(gl);
        frame_forget(scene, document);
    }
}

/* A pane edge-on to the light has no fragment in its map of 16 x 16; once it is turned it has some
 * 25, of 16 bytes beside 32 and 1024 of heads. */
static void shadows_that_are_too_long(void **state)
{
    (void)state;
    static const char pane[] = "image: { width: 32, height: 24 }\ncamera: { camera: Perspective, "
                               "position: [0, -4, 3], angle: 40 }\n"
                               "shadowMaps: { size: 16 }\nlights: [{ light: Directional, "
                               "direction: [0, 0, -1] }]\nobjects:\n"
                               "- { object: Parallelogram, u: [2, 0, 0], v: [0, 2, 0], material: { "
                               "material: Phong, diffuse: 0, transparency: "
                               "[.5, .9, .3] }, transform: { rotation: [1.5707963267948966, 0, 0], "
                               "translation: [-1, 0, 1] } }\n"
                               "- { object: Parallelogram, u: [4, 0, 0], v: [0, 4, 0], material: { "
                               "material: Phong, diffuse: .5 }, "
                               "transform: { translation: [-2, -2, 0] } }\n";
    MatcLayout *layout;
    const MatcOptions compile = frame_float_options(&layout);
    MatcDocument *document;
    Scene *scene = frame_scene(pane, &compile, &document);
    GlContext *gl = frame_context();
    const RendererOptions options = {.compile = &compile,
                                     .view = "light",
                                     .transparency = "peeling",
                                     .list_bytes = 32 + 4 * 256 + 16 * 10};
    float *moved = calloc((size_t)WIDTH * HEIGHT, 4 * sizeof *moved);
    Renderer *renderer = renderer_open(gl, &options);
    assert_true(renderer && renderer_set_scene(renderer, scene) && renderer_frame(renderer));
    assert_false(runs(renderer, "parts"));
    static const double flat[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, -1, 1, 1};
    memcpy(scene->objects[0].world_from_local.m, flat, sizeof flat);
    assert_true(renderer_changed_objects(renderer, 0, 1) && renderer_frame(renderer) &&
                renderer_read(renderer, moved));
    assert_true(runs(renderer, "tiles, drawn again"));
    assert_true(renderer_frame(renderer)); /* and once more */
    float *whole =
        frame_floats(gl, scene, &(RendererOptions){.compile = &compile, .view = "light"});
    double most = 0, shade = 0;
    for (int i = 0; i < 4 * WIDTH * HEIGHT; i++) {
        most = fmax(most, fabs(moved[i] - whole[i]));
        shade = fmax(shade, i % 4 < 3 ? .5 - whole[i] : 0);
    }
    assert_true(most < 1e-6 && shade > .3);
    free(moved);
    free(whole);
    renderer_close(renderer);
    gl_close(gl);
    frame_forget(scene, document);
    matc_layout_free(layout);
}

/* A fully transparent pane has no fragment in a light's lists; a param turns it into dark glass,
 * which has, like a scene with that value. */
static void params_are_counted(void **state)
{
    (void)state;
    static const char pane[] =
        "image: { width: 32, height: 24 }\ncamera: { camera: Perspective, position: [0, -4, 3], "
        "angle: 40 }\n"
        "shadowMaps: { size: 64 }\nlights: [{ light: Directional, direction: [0, 0, -1] "
        "}]\nobjects:\n"
        "- { object: Parallelogram, u: [4, 0, 0], v: [0, 4, 0], material: { material: Phong, "
        "diffuse: .5 }, "
        "transform: { translation: [-2, -2, 0] } }\n"
        "- { object: Parallelogram, u: [1, 0, 0], v: [0, 1, 0], material: { material: Phong, "
        "diffuse: 0, transparency: "
        "{ param: clear, default: %s } }, transform: { translation: [-.5, -.5, 1] } }\n";
    static float changed[4 * WIDTH * HEIGHT];
    const MatcOptions compile = frame_exact_options();
    const RendererOptions options = {.compile = &compile, .view = "light"};
    GlContext *gl = frame_context();
    char text[sizeof pane + 4];
    MatcDocument *documents[2];
    Scene *scenes[2];
    for (int i = 0; i < 2; i++) {
        snprintf(text, sizeof text, pane, i ? ".25" : "1");
        scenes[i] = frame_scene(text, &compile, &documents[i]);
    }
    Renderer *renderer = renderer_open(gl, &options);
    assert_true(renderer && renderer_set_scene(renderer, scenes[0]) && renderer_frame(renderer));
    const int glass = scenes[0]->objects[1].material;
    assert_true(renderer_param(renderer, glass, "clear", &(float){.25f}, 1));
    assert_true(renderer_frame(renderer) && renderer_read(renderer, changed));
    float *new = frame_floats(gl, scenes[1], &options),
          *before = frame_floats(gl, scenes[0], &options);
    assert_memory_equal(changed, new, sizeof changed);
    assert_memory_not_equal(changed, before, sizeof changed);
    free(new);
    free(before);
    renderer_close(renderer);
    gl_close(gl);
    for (int i = 0; i < 2; i++)
        frame_forget(scenes[i], documents[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(more_are_counted), cmocka_unit_test(lists_that_are_too_long),
        cmocka_unit_test(shadows_that_are_too_long), cmocka_unit_test(params_are_counted)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
