/* Changed scenes against newly opened ones; the objects and buffers that each change creates and
 * writes. */
/* ctest: seconds=14 */
#include "tests/test.h"
#include "tests/frame/frame_calls.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/frame_random.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool same(const float *a, const float *b, const Scene *scene)
{
    return !memcmp(a, b, (size_t)scene->width * (size_t)scene->height * 4 * sizeof *a);
}

typedef struct {
    const MatcOptions options;
    GlContext *gl;
    MatcDocument *document;
    Scene *scene;
    Renderer *renderer;
} Changing;

static Changing open_changing(const char *text)
{
    Changing c = {.options = frame_exact_options(), .gl = frame_context()};
    c.scene = frame_scene(text, &c.options, &c.document);
    frame_count_calls(c.gl);
    c.renderer = renderer_open(c.gl, &(RendererOptions){.compile = &c.options, .view = "light"});
    assert_true(c.renderer && renderer_set_scene(c.renderer, c.scene) &&
                renderer_frame(c.renderer));
    frame_calls = (FrameCalls){0};
    return c;
}

static void close_changing(Changing *c)
{
    assert_true(gl_check(c->gl, "all changes"));
    renderer_close(c->renderer);
    gl_close(c->gl);
    frame_forget(c->scene, c->document);
}

static float *read_frame(const Changing *c)
{
    float *rgba = calloc((size_t)c->scene->width * (size_t)c->scene->height, 4 * sizeof *rgba);
    assert_non_null(rgba);
    assert_true(renderer_frame(c->renderer) && renderer_read(c->renderer, rgba));
    return rgba;
}

/* Checks that the change made no object and wrote at most `most` bytes, and that the picture
 * equals that of a new renderer. */
static void assert_as_new(const Changing *c, long most)
{
    assert_int_equal(frame_calls.made, 0);
    if (frame_calls.bytes > most)
        fail_msg("%ld bytes in %d calls", frame_calls.bytes, frame_calls.written);
    float *changed = read_frame(c);
    GlContext *gl = frame_context();
    float *new =
        frame_floats(gl, c->scene, &(RendererOptions){.compile = &c->options, .view = "light"});
    assert_true(same(changed, new, c->scene));
    gl_close(gl);
    assert_true(gl_use(c->gl));
    free(changed);
    free(new);
    frame_calls = (FrameCalls){0};
}

static void changes(void **unused)
{
    (void)unused;
    char *text = frame_random_text(7, 120, false);
    Changing c = open_changing(text);
    Scene *scene = c.scene;
    scene->objects[3].world_from_local.m[12] += .25;
    assert_true(renderer_changed_objects(c.renderer, 3, 1));
    assert_as_new(&c, 128 + 4 * 120); /* its row, and the list of visible objects */
    for (int i = 0; i < scene->object_count; i++)
        scene->objects[i].world_from_local.m[14] += .1 * i / scene->object_count;
    assert_true(renderer_changed_objects(c.renderer, 0, scene->object_count));
    assert_as_new(&c, (128 + 4) * 120);
    for (int i = 0; i < 3; i++)
        scene->objects[9].world_from_local.m[i] *= -1; /* its winding is flipped: another group */
    assert_true(renderer_changed_objects(c.renderer, 9, 1));
    assert_as_new(&c, (128 + 12) * 120);
    scene->camera.position[0] += 1;
    assert_true(renderer_changed(c.renderer, RENDERER_CAMERA));
    assert_as_new(&c, 112 + 4 * 120);
    scene->lights[0].light[1] *= .5;
    scene->lights[0].position[2] += 1;
    scene->lights[1].light[0] *= 2;
    assert_true(renderer_changed(c.renderer, RENDERER_LIGHTS));
    assert_as_new(&c, 0);
    assert_false(renderer_changed_objects(c.renderer, 100, 21));
    assert_string_equal(c.gl->error, "there are no objects 100 to 120");
    close_changing(&c);
    free(text);
}

/* An equal number of other objects becomes visible; then of several moves only the last is
 * visible. */
static void others_in_view(void **unused)
{
    (void)unused;
    char text[1024];
    size_t size = (size_t)snprintf(
        text, sizeof text,
        "image: { width: 24, height: 16 }\ncamera: { camera: Perspective, position: [0, -5, "
        "0], angle: 20 }\nlights: [{ light: Ambient }]\nobjects:\n");
    for (int i = 0; i < 3; i++)
        size += (size_t)snprintf(
            text + size, sizeof text - size,
            "- { object: Box, transform: { translation: [%d, 0, 0] }, material: { material: "
            "Phong, ambient: [.5, %g, .1] } }\n",
            4 * i, .2 + .3 * i);
    Changing c = open_changing(text);
    for (int i = 1; i < 3; i++) {
        c.scene->camera.position[0] += 4;
        assert_true(renderer_changed(c.renderer, RENDERER_CAMERA));
        assert_as_new(&c, 112 + 4);
        float *rgba = read_frame(&c);
        assert_true(fabsf(rgba[4 * (8 * 24 + 12) + 1] - (.2f + .3f * (float)i)) < 1e-3f);
        free(rgba);
    }
    for (int i = 0; i < 3; i++)
        c.scene->objects[i].world_from_local.m[12] += .25;
    assert_true(renderer_changed_objects(c.renderer, 0, 3));
    assert_as_new(&c, (128 + 4) * 3);
    close_changing(&c);
}

/* Params belong to a material, though others share its program. */
static void params(void **unused)
{
    (void)unused;
    Changing c = open_changing("image: { width: 20, height: 10 }\ncamera: { camera: Orthographic, "
                               "position: [0, -5, 0], size: 1 }\n"
                               "lights: [{ light: Ambient }]\nobjects:\n"
                               "- { object: Box, material: { material: Phong, ambient: { param: "
                               "shine, default: .2 } }, transform: { "
                               "translation: [-.5, 0, 0] } }\n"
                               "- { object: Box, material: { material: Phong, ambient: { param: "
                               "shine, default: .2 } }, transform: { "
                               "translation: [.5, 0, 0] } }\n");
    const int second = c.scene->objects[1].material;
    assert_true(renderer_param(c.renderer, second, "shine", &(float){.8f}, 1));
    assert_int_equal(frame_calls.made, 0);
    float *rgba = read_frame(&c);
    /* 10 bits */
    assert_true(fabsf(rgba[4 * 105] - .2f) < 1e-3f && fabsf(rgba[4 * 115] - .8f) < 1e-3f);
    assert_false(renderer_param(c.renderer, second, "shin", &(float){.8f}, 1));
    assert_string_equal(c.gl->error,
                        "no program of the material has a param 'shin' of 1 components");
    assert_false(renderer_param(c.renderer, second, "shine", (float[3]){0}, 3));
    free(rgba);
    close_changing(&c);
}

/* The next scene reuses programs and meshes of the previous one; unused ones are freed. */
static void the_next_scene(void **unused)
{
    (void)unused;
    static const char text[] = "image: { width: 32, height: 32 }\nlights: [{ light: Point, "
                               "position: [3, -3, 3], intensity: 9 }]\nobjects:\n"
                               "- { object: Sphere, material: { material: Phong, diffuse: .5 } }\n"
                               "- { object: Box, material: { material: Phong, diffuse: { map: "
                               "Checker } }, transform: { translation: [%d, 0, "
                               "0] } }\n";
    char first[1024], next[1024];
    snprintf(first, sizeof first, text, 1);
    snprintf(next, sizeof next, text, -1);
    Changing c = open_changing(first);
    MatcDocument *document;
    Scene *scene = frame_scene(next, &c.options, &document);
    const int before = frame_calls.programs;
    frame_calls = (FrameCalls){0};
    assert_int_equal(before, 0);
    assert_true(renderer_set_scene(c.renderer, scene));
    assert_int_equal(frame_calls.programs, 0);
    frame_forget(c.scene, c.document);
    c.scene = scene;
    c.document = document;
    frame_calls = (FrameCalls){0};
    assert_as_new(&c, 0);
    close_changing(&c);
}

/* Cascades follow the camera: their maps are redrawn into the existing textures. */
static void cascades(void **state)
{
    (void)state;
    Changing c = open_changing(
        "image: { width: 64, height: 48 }\ncamera: { camera: Perspective, position: [1, -7, 3] "
        "}\nshadowMaps: { size: "
        "64, cascades: 3 }\nlights: [{ light: Directional, direction: [1, 2, -3] }]\nobjects:\n"
        "- { object: Parallelogram, u: [90, 0, 0], v: [0, 90, 0], material: { material: Phong, "
        "diffuse: .5 }, "
        "transform: { translation: [-45, -45, 0] } }\n"
        "- { object: Box, material: { material: Phong, diffuse: .5 }, transform: { translation: "
        "[0, 0, .5] } }\n");
    c.scene->camera.position[0] += 2;
    assert_true(renderer_changed(c.renderer, RENDERER_CAMERA));
    assert_as_new(&c, 112 + 4 * 2);
    close_changing(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(changes), cmocka_unit_test(others_in_view),
                                       cmocka_unit_test(params), cmocka_unit_test(cascades),
                                       cmocka_unit_test(the_next_scene)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
