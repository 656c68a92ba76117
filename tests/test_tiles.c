/* Pictures in tiles against the same picture drawn whole: their rays bit for bit, rasterised surfaces to the last bits; what memory a tile
 * may take; pictures in files, of every format, however they were drawn. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 200, HEIGHT = 150 };

/* So many pixels whose greatest difference is above `least`. */
static int apart(const float *a, const float *b, double least)
{
    int count = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double greatest = 0;
        for (int lane = 0; lane < 3; lane++)
            greatest = fmax(greatest, fabs((double)a[4 * i + lane] - b[4 * i + lane]));
        count += greatest > least;
    }
    return count;
}

static const int tiles[][2] = {{WIDTH, 34}, {66, HEIGHT}, {66, 34}, {14, 62}, {WIDTH + 100, 2}};

#define IMAGE "image: { width: 200, height: 150 }\n"
#define WALL                                                                                                           \
    "lights: [{ light: Point, position: [.3, -1, .2], intensity: 2 }, { light: Directional, direction: [1, 2, -3] "    \
    "}]\n"                                                                                                             \
    "objects: [{ object: Parallelogram, u: [30, 0, 0], v: [0, 0, 30], transform: { translation: [-15, 1, -15] }, "     \
    "material: { material: Phong, diffuse: .5, specular: .5, shininess: .8 } }]\n"

/* A wall that faces the eye has one depth and one normal, which nothing rounds: what differs between its pixels are their rays alone, and these
 * are the picture's, bit for bit. */
static void rays_are_the_pictures(void **state)
{
    (void)state;
    static const char *const scenes[] = {
        IMAGE WALL "camera: { camera: Perspective, position: [0, -2, 0], target: [0, 0, 0] }\n",
        IMAGE WALL "camera: { camera: Orthographic, position: [0, -2, 0], target: [0, 0, 0] }\n"};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
        MatcDocument *document;
        Scene *scene = frame_scene(scenes[k], &options, &document);
        RenderOptions render = {.compile = &options, .view = "light"};
        float *whole = frame_floats(gl, scene, &render);
        assert_true(fabs(whole[0] - whole[4 * (WIDTH - 1)]) > 1e-3); /* they do differ */
        for (size_t i = 0; i < sizeof tiles / sizeof *tiles; i++) {
            memcpy(render.tile, tiles[i], sizeof render.tile);
            float *parts = frame_tiles(gl, scene, &render);
            assert_memory_equal(whole, parts, (size_t)WIDTH * HEIGHT * 4 * sizeof *whole);
            free(parts);
        }
        free(whole);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* The rasteriser counts pixels from a tile's corner, and rounds what it interpolates there. So a depth can be some ULP off, and a pixel whose
 * centre an edge meets within 1/256 pixel fall to its other side: at most one in 400. A tile that is moved by a pixel has them all. */
static void seams_are_rounding(void **state)
{
    (void)state;
    static const char text[] =
        IMAGE "camera: { camera: Perspective, position: [.5, -6, 2.5], target: [0, 0, .5], near: .5 }\n"
              "lights: [{ light: Point, position: [1, -4, 4], intensity: 12 }, { light: Ambient, intensity: .2 }]\n"
              "objects:\n- { object: Plane, material: { material: Phong, diffuse: { map: Checker }, ambient: 1 } }\n"
              "- { object: Sphere, material: { material: Phong, diffuse: .3, ambient: .5 } }\n"
              "- { object: Box, material: { material: Phong, diffuse: .8, ambient: 1 }, transform: { translation: "
              "[1.5, 0, 0], rotation: "
              "[.3, .4, .5] } }\nsky: { material: RGBA, r: .1, g: .2, b: .5 }\n";
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(text, &options, &document);
    GlContext *gl = frame_context();
    for (int view = 0; view < 2; view++) {
        RenderOptions render = {.compile = &options, .view = view ? "light" : "depth"};
        float *whole = frame_floats(gl, scene, &render);
        for (size_t i = 0; i < sizeof tiles / sizeof *tiles; i++) {
            memcpy(render.tile, tiles[i], sizeof render.tile);
            float *parts = frame_tiles(gl, scene, &render);
            assert_true(apart(whole, parts, view ? 1e-4 : 1e-6) <= WIDTH * HEIGHT / 400);
            free(parts);
        }
        free(whole);
    }
    gl_close(gl);
    frame_forget(scene, document);
}

/* Tiles have whole rows, as many as the memory holds, and an even number of them. */
static void tiles_fit_the_memory(void **state)
{
    (void)state;
    static const struct {
        size_t memory;
        int rows;
    } cases[] = {
        {0, HEIGHT}, {1, RENDER_TILE_LEAST}, {200 * 32 * 51, 50}, {200 * 32 * 100 - 1, 98}, {200 * 32 * 100, 100}};
    MatcOptions options;
    matc_options_init(&options);
    options.layout = "compact"; /* 16 bytes a pixel; depth has 4, light 8, the picture 4 */
    options.pixels = true;
    MatcDocument *document;
    Scene *scene =
        frame_scene(IMAGE "objects: [{ object: Sphere, material: { material: Phong } }]\n", &options, &document);
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Render *render = render_open(gl, &(RenderOptions){.compile = &options, .memory = cases[i].memory});
        assert_true(render && render_scene(render, scene));
        assert_int_equal(render_tile_width(render), WIDTH);
        assert_int_equal(render_tile_height(render), cases[i].rows);
        render_close(render);
    }
    gl_close(gl);
    frame_forget(scene, document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(rays_are_the_pictures), cmocka_unit_test(seams_are_rounding),
                                       cmocka_unit_test(tiles_fit_the_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
