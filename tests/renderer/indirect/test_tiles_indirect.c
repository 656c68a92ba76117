/* Indirect light in tiles with a guard band as wide as its filters, against the same picture
 * drawn at once; methods that cannot be tiled. */
/* ctest: seconds=10 */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 128, HEIGHT = 96, PIXELS = WIDTH * HEIGHT, FEW = 4, TEXT = 2048 };

/* Oblique to the axes: no edge passes through pixel centers, where rounding decides. */
#define CAMERA                                                                                     \
    "camera: { camera: Perspective, position: [.13, -6, 1.21], target: [.02, 0, 1], angle: 30 }\n"
static const char body[] =
    "image: { width: 128, height: 96 }\nlights: [{ light: Point, position: [.1, -.4, 1.7], "
    "intensity: 1, shadows: none "
    "}]\nmaterials: { m: { material: Phong, diffuse: .7, specular: 0 } }\nobjects:\n"
    "- { object: Box, size: [2.2, 2.2, .1], material: m, transform: { translation: [0, 0, -.05] } "
    "}\n"
    "- { object: Box, size: [2.2, .1, 2.2], material: m, transform: { translation: [0, 1.05, 1] } "
    "}\n"
    "- { object: Box, size: [.1, 2.2, 2.2], material: m, transform: { translation: [-1.05, 0, 1] } "
    "}\n"
    "- { object: Box, size: [.6, .6, 1.2], material: m, transform: { translation: [-.35, .3, .6], "
    "rotation: [0, 0, .3] "
    "} }\n"
    "- { object: Sphere, radius: .35, material: m, transform: { translation: [.4, -.4, .35] } }\n";

/* Pixels that differ: seen by more than half a step of 8 bits. */
static int apart(const float *a, const float *b, double *most)
{
    int count = 0;
    *most = 0;
    for (int i = 0; i < PIXELS; i++) {
        double greatest = 0;
        for (int k = 0; k < 3; k++)
            greatest = fmax(greatest, fabs((double)a[4 * i + k] - (double)b[4 * i + k]));
        *most = fmax(*most, greatest);
        count += greatest > .5 / 255;
    }
    return count;
}

static Scene *make_scene(const char *keys, const char *camera, const MatcOptions *options,
                         MatcDocument **document)
{
    char text[TEXT];
    snprintf(text, sizeof text, "voxels: { size: 64 }\nindirect: { %s }\n%s%s", keys, camera, body);
    return frame_scene(text, options, document);
}

/* The rasterizer accumulates from a tile's corner: depth differs in its last bits
 * (test_tiles.c), so that a ray may hit another voxel: at FEW pixels. */
static void tiles_are_as_the_whole(void **state)
{
    (void)state;
    static const struct {
        const char *keys, *view;
        int samples;
    } cases[] = {{"method: voxels, radius: 1, filterSize: 6", "ao", 1},
                 {"method: voxels", "light", 1},
                 {"method: hybrid", "indirect", 1},
                 {"method: hybrid, resolution: quarter", "ao", 1},
                 {"method: hybrid, resolution: half, filter: atrous", "ao", 2},
                 {"method: march, radius: .2, rotation: random, steps: 12", "ao", 1},
                 {"method: screen, radius: .2, rotation: blue", "indirect", 1},
                 {"method: march, march: voxels, radius: .3, filter: atrous", "indirect", 1}};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcDocument *document;
        double most;
        Scene *scene = make_scene(cases[i].keys, CAMERA, &options, &document);
        RendererOptions renderer = {
            .compile = &options, .view = cases[i].view, .samples = cases[i].samples, .deep = true};
        float *whole = frame_floats(gl, scene, &renderer);
        memcpy(renderer.tile, (int[]){50, 38}, sizeof renderer.tile);
        Renderer *tiled = renderer_open(gl, &renderer);
        assert_true(tiled && renderer_set_scene(tiled, scene) && renderer_tile_width(tiled) <= 50 &&
                    renderer_tile_height(tiled) <= 38);
        renderer_close(tiled);
        float *parts = frame_tiles(gl, scene, &renderer);
        const int count = apart(whole, parts, &most);
        print_message("%s, %s: %d pixels of tiles differ, by %.3f at most\n", cases[i].keys,
                      cases[i].view, count, most);
        assert_true(count <= FEW);
        free(parts);
        free(whole);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* Methods with long rays, or accumulation over frames, draw the whole picture; an approaching
 * camera rebuilds the tiles. */
static void what_looks_far_is_whole(void **state)
{
    (void)state;
    static const struct {
        const char *keys, *camera;
        bool whole;
    } cases[] = {
        {"method: voxels", CAMERA, false},
        {"method: voxels",
         "camera: { camera: Perspective, position: [0, -.9, 1], target: [0, 0, 1] }\n", false},
        {"method: hybrid", CAMERA, false},
        {"method: hybrid",
         "camera: { camera: Perspective, position: [0, -.9, 1], target: [0, 0, 1] }\n", true},
        {"method: march, radius: 3", CAMERA, true},
        {"method: voxels, samples: 2", CAMERA, true},
        {"method: march, radius: .1, bounces: 2", CAMERA, true},
        {"method: voxels, moving: half", CAMERA, true}};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcDocument *document;
        Scene *scene = make_scene(cases[i].keys, cases[i].camera, &options, &document);
        Renderer *renderer = renderer_open(
            gl, &(RendererOptions){.compile = &options, .view = "light", .tile = {50, 38}});
        assert_true(renderer && renderer_set_scene(renderer, scene));
        assert_int_equal(renderer_tile_height(renderer) == HEIGHT, cases[i].whole);
        if (!strcmp(cases[i].keys, "method: hybrid") && !cases[i].whole) {
            scene->camera.position[1] = -.9;
            assert_true(renderer_changed(renderer, RENDERER_CAMERA));
            assert_int_equal(renderer_tile_height(renderer), HEIGHT);
        }
        renderer_close(renderer);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(tiles_are_as_the_whole),
                                       cmocka_unit_test(what_looks_far_is_whole)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
