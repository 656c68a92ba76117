/* Planes with varying transparency as shadow casters: the calls of a second frame, changes,
 * allocated targets and refused scenes. test_frame_cast.c checks the light. */
/* ctest: seconds=10 */
#include "tests/test.h"
#include "tests/frame/frame_calls.h"
#include "tests/frame/frame_change.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 32, HEIGHT = 24, FLOATS = 4 * WIDTH * HEIGHT };

/* Two sheets over the ground, two lights above. */
static const char text[] =
    "image: { width: 32, height: 24 }\ncamera: { camera: Perspective, position: [0, -6, 2], "
    "target: [0, 0, .5], angle: "
    "50 }\n"
    "lights: [{ light: Directional, direction: [.3, .4, -1] }, { light: Point, position: [1, 2, "
    "5], intensity: 20, "
    "shadows: map }, { light: Spot, position: [-1, 2, 2], intensity: 5, shadows: none }]\n"
    "materials: { cells: { material: Phong, transparency: { map: Checker, color1: { param: clear, "
    "default: .8 }, "
    "color2: [.1, .2, .6] } }, waves: { material: Phong, transparency: { map: Checker, color1: "
    "[.9, .5, .7], "
    "color2: 1 } } }\n"
    "objects:\n- { object: Plane, material: { material: Phong, diffuse: .5 } }\n"
    "- { object: Plane, material: cells, transform: { translation: [0, 0, 4] } }\n"
    "- { object: Plane, material: waves, transform: { rotation: [.1, 0, .3], translation: [0, 0, "
    "3] } }\n";

typedef struct {
    MatcOptions compile;
    MatcDocument *document;
    Scene *scene;
    GlContext *gl;
    Renderer *renderer;
} Drawn;

static Drawn draw(const RendererOptions *options)
{
    Drawn d = {.compile = frame_exact_options()};
    RendererOptions choice = *options;
    choice.compile = &d.compile;
    choice.view = "light";
    d.scene = frame_scene(text, &d.compile, &d.document);
    d.gl = frame_context();
    frame_count_calls(d.gl);
    d.renderer = renderer_open(d.gl, &choice);
    assert_true(d.renderer && renderer_set_scene(d.renderer, d.scene) &&
                renderer_frame(d.renderer));
    return d;
}

static void forget(Drawn *d)
{
    renderer_close(d->renderer);
    gl_close(d->gl);
    frame_forget(d->scene, d->document);
}

static void a_second_frame_draws(void **state)
{
    (void)state;
    Drawn d = draw(&(RendererOptions){0});
    float *first = frame_change_next(d.renderer);
    frame_calls = (FrameCalls){0};
    float *second = frame_change_next(d.renderer);
    assert_int_equal(frame_calls.made + frame_calls.written, 0);
    assert_memory_equal(first, second, FLOATS * sizeof *first);
    free(first);
    free(second);
    forget(&d);
}

static bool move_camera(Drawn *d)
{
    d->scene->camera.position[0] += 1;
    return renderer_changed(d->renderer, RENDERER_CAMERA);
}

static bool move_light(Drawn *d)
{
    d->scene->lights[1].position[2] = 3.2; /* below the first sheet */
    return renderer_changed(d->renderer, RENDERER_LIGHTS);
}

static bool move_sheet(Drawn *d)
{
    d->scene->objects[1].world_from_local.m[12] += .5;
    return renderer_changed_objects(d->renderer, 1, 1);
}

/* A change gives the picture of a new renderer, bit for bit, and not the previous one. */
static void changes(void **state)
{
    (void)state;
    static bool (*const moves[])(Drawn *) = {move_camera, move_light, move_sheet};
    for (size_t i = 0; i < sizeof moves / sizeof *moves; i++) {
        Drawn d = draw(&(RendererOptions){0});
        float *before = frame_change_next(d.renderer);
        assert_true(moves[i](&d));
        float *moved = frame_change_next(d.renderer);
        float *new =
            frame_floats(d.gl, d.scene, &(RendererOptions){.compile = &d.compile, .view = "light"});
        assert_memory_equal(moved, new, FLOATS * sizeof *new);
        assert_memory_not_equal(before, new, FLOATS * sizeof *new);
        free(before);
        free(moved);
        free(new);
        forget(&d);
    }
}

/* A param of the material is one of its shadow's: light falls elsewhere, though the sheet is out of
 * view. */
static void params(void **state)
{
    (void)state;
    Drawn d = draw(&(RendererOptions){0});
    float *before = frame_change_next(d.renderer);
    assert_true(renderer_param(d.renderer, d.scene->objects[1].material, "clear", &(float){0}, 1));
    float *after = frame_change_next(d.renderer);
    int darker = 0;
    for (int i = 0; i < FLOATS; i++)
        darker += after[i] < before[i];
    assert_true(darker > FLOATS / 8);
    free(before);
    free(after);
    forget(&d);
}

/* Tiles give the picture, but for some ULP of depth: light of each pixel is asked at its own
 * place. */
static void tiles(void **state)
{
    (void)state;
    Drawn whole = draw(&(RendererOptions){0});
    float *picture = frame_change_next(whole.renderer);
    forget(&whole);
    Drawn tiled = draw(&(RendererOptions){.tile = {16, 8}});
    for (int y = 0; y < HEIGHT; y += 8)
        for (int x = 0; x < WIDTH; x += 16) {
            renderer_set_tile(tiled.renderer, x, y);
            float *tile = frame_change_next(tiled.renderer);
            for (int row = 0; row < 8; row++)
                for (int i = 0; i < 4 * 16; i++)
                    assert_float_equal(tile[4 * 16 * row + i],
                                       picture[4 * (WIDTH * (y + row) + x) + i], 1e-5);
            free(tile);
        }
    free(picture);
    forget(&tiled);
}

static bool graph_has(const Renderer *renderer, const char *line)
{
    char *graph = frame_graph(renderer);
    const bool found = strstr(graph, line) != NULL;
    free(graph);
    return found;
}

/* Eight bytes per pixel for each of two lights. None without shadows, or on a driver without
 * images; then surfaces of varying transparency cast no shadows. */
static void capacity(void **state)
{
    (void)state;
    Drawn d = draw(&(RendererOptions){0});
    assert_true(graph_has(d.renderer, "sheets RG32UI 16: plane transmittance of 2 lights"));
    assert_true(graph_has(d.renderer, "lists depth lists not run: nothing to do")); /* peeled */
    assert_true(renderer_set_scene(d.renderer, d.scene));
    renderer_close(d.renderer);
    d.renderer =
        renderer_open(d.gl, &(RendererOptions){.compile = &d.compile, .transparency = "lists"});
    assert_false(renderer_set_scene(d.renderer, d.scene));
    assert_non_null(strstr(d.gl->error, "a plane with varying transparency casts shadows"));
    renderer_close(d.renderer);
    d.renderer = renderer_open(d.gl, &(RendererOptions){.compile = &d.compile, .no_shadows = true});
    assert_true(renderer_set_scene(d.renderer, d.scene) && renderer_frame(d.renderer));
    assert_false(graph_has(d.renderer, "sheets"));
    renderer_close(d.renderer);
    d.gl->major = d.gl->minor = 3;
    d.gl->ClipControl = NULL;
    d.renderer = renderer_open(d.gl, &(RendererOptions){.compile = &d.compile});
    assert_true(renderer_set_scene(d.renderer, d.scene) && renderer_frame(d.renderer));
    assert_false(graph_has(d.renderer, "sheets RG32UI"));
    forget(&d);
}

static const char side_text[] = "image: { width: 32, height: 24 }\ncamera: { camera: Perspective, "
                                "position: [0, -6, 2], target: [0, 0, .5], angle: "
                                "50 }\nlights: [{ light: %s }]\nobjects:\n- { object: Plane, "
                                "material: { material: Phong, diffuse: .5 } }\n"
                                "- { object: Plane, transform: { translation: [0, 0, %s], "
                                "rotation: [%s, 0, 0] }, material: { material: "
                                "SideSwitch,\n"
                                "    frontShader: { material: Phong, transparency: { map: Checker, "
                                "color1: .9, color2: .8 } },\n"
                                "    backShader: { material: Phong, transparency: .1 } } }\n";

static float *light_of(GlContext *gl, const char *light, const char *height, const char *turn)
{
    char scene_text[1024];
    MatcDocument *document;
    const MatcOptions options = frame_exact_options();
    snprintf(scene_text, sizeof scene_text, side_text, light, height, turn);
    Scene *scene = frame_scene(scene_text, &options, &document);
    float *rgba = frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
    frame_forget(scene, document);
    return rgba;
}

/* Transmittance is that of the side facing the light, even if the camera is on the other side; also
 * for a light with nothing before it, as the plane lies below the ground. */
static void sides(void **state)
{
    (void)state;
    static const char *const lights[] = {"Directional",
                                         "Point, position: [0, 0, 9], intensity: 40"};
    GlContext *gl = frame_context();
    for (int i = 0; i < 4; i++) {
        const bool back = i % 2;
        float *bare = light_of(gl, lights[i / 2], "-4", "0");
        float *lit = light_of(gl, lights[i / 2], "4", back ? "3.14159265" : "0");
        int seen = 0;
        for (int k = 0; k < FLOATS; k++) {
            const float share = lit[k] / (bare[k] > .01f ? bare[k] : 1);
            if (k % 4 == 3 || bare[k] <= .01f)
                continue;
            assert_true(back ? share > .0999f && share < .1001f : share > .799f && share < .901f);
            seen++;
        }
        assert_true(seen > FLOATS / 4);
        free(bare);
        free(lit);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_second_frame_draws),
                                       cmocka_unit_test(changes),
                                       cmocka_unit_test(params),
                                       cmocka_unit_test(tiles),
                                       cmocka_unit_test(sides),
                                       cmocka_unit_test(capacity)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
