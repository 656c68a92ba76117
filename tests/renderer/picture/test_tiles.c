/* Pictures in tiles against the same picture drawn whole: their rays bit for bit, rasterized
 * surfaces to the last bits; the memory that a tile may take. `build/tests/test_tiles FILE...
 * [egl]` prints the differences of these scenes. */
/* ctest: seconds=16 */
#include "tests/test.h"
#include "tests/frame/frame_calls.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 200, HEIGHT = 150 };

/* So many pixels whose greatest difference is above `least`. */
static int apart(const float *a, const float *b, double least)
{
    int count = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double greatest = 0;
        for (int component = 0; component < 3; component++)
            greatest = fmax(greatest, fabs((double)a[4 * i + component] - b[4 * i + component]));
        count += greatest > least;
    }
    return count;
}

static const int tiles[][2] = {{WIDTH, 34}, {66, HEIGHT}, {66, 34}, {14, 62}, {WIDTH + 100, 2}};

#define IMAGE "image: { width: 200, height: 150 }\n"
#define WALL                                                                                       \
    "lights: [{ light: Point, position: [.3, -1, .2], intensity: 2 }, { light: Directional, "      \
    "direction: [1, 2, -3] "                                                                       \
    "}]\n"                                                                                         \
    "objects: [{ object: Parallelogram, u: [30, 0, 0], v: [0, 0, 30], transform: { translation: "  \
    "[-15, 1, -15] }, "                                                                            \
    "material: { material: Phong, diffuse: .5, specular: .5, shininess: .8 } }]\n"

/* A wall that faces the eye has one depth and one normal, without rounding: its pixels differ
 * only in their rays, which equal the picture's, bit for bit. */
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
        RendererOptions renderer = {.compile = &options, .view = "light"};
        float *whole = frame_floats(gl, scene, &renderer);
        assert_true(fabs(whole[0] - whole[4 * (WIDTH - 1)]) > 1e-3); /* they do differ */
        for (size_t i = 0; i < sizeof tiles / sizeof *tiles; i++) {
            memcpy(renderer.tile, tiles[i], sizeof renderer.tile);
            float *parts = frame_tiles(gl, scene, &renderer);
            assert_memory_equal(whole, parts, (size_t)WIDTH * HEIGHT * 4 * sizeof *whole);
            free(parts);
        }
        free(whole);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* The rasterizer counts pixels from a tile's corner, and rounds interpolated values there. A
 * depth may differ by some ULP, and a pixel whose center is within 1/256 pixel of an edge may
 * fall to the other side: at most one in 400. A tile that is off by one pixel has more. */
static void seams_are_rounding(void **state)
{
    (void)state;
    static const char text[] = IMAGE
        "camera: { camera: Perspective, position: [.5, -6, 2.5], target: [0, 0, .5], near: .5 }\n"
        "lights: [{ light: Point, position: [1, -4, 4], intensity: 12 }, { light: Ambient, "
        "intensity: .2 }]\n"
        "objects:\n- { object: Plane, material: { material: Phong, diffuse: { map: Checker }, "
        "ambient: 1 } }\n"
        "- { object: Sphere, material: { material: Phong, diffuse: .3, ambient: .5 } }\n"
        "- { object: Box, material: { material: Phong, diffuse: .8, ambient: 1 }, transform: { "
        "translation: "
        "[1.5, 0, 0], rotation: "
        "[.3, .4, .5] } }\nsky: { material: RGBA, r: .1, g: .2, b: .5 }\n";
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(text, &options, &document);
    GlContext *gl = frame_context();
    for (int view = 0; view < 2; view++) {
        RendererOptions renderer = {.compile = &options, .view = view ? "light" : "depth"};
        float *whole = frame_floats(gl, scene, &renderer);
        for (size_t i = 0; i < sizeof tiles / sizeof *tiles; i++) {
            memcpy(renderer.tile, tiles[i], sizeof renderer.tile);
            float *parts = frame_tiles(gl, scene, &renderer);
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
    } cases[] = {{0, HEIGHT},
                 {1, RENDERER_TILE_MIN},
                 {200 * 32 * 51, 50},
                 {200 * 32 * 100 - 1, 98},
                 {200 * 32 * 100, 100}};
    MatcOptions options;
    matc_options_init(&options);
    options.layout = "compact"; /* 16 bytes a pixel; depth has 4, light 8, the picture 4 */
    options.pixels = true;
    MatcDocument *document;
    Scene *scene =
        frame_scene(IMAGE "objects: [{ object: Sphere, material: { material: Phong } }]\n",
                    &options, &document);
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Renderer *renderer =
            renderer_open(gl, &(RendererOptions){.compile = &options, .memory = cases[i].memory});
        assert_true(renderer && renderer_set_scene(renderer, scene));
        assert_int_equal(renderer_tile_width(renderer), WIDTH);
        assert_int_equal(renderer_tile_height(renderer), cases[i].rows);
        renderer_close(renderer);
    }
    gl_close(gl);
    frame_forget(scene, document);
}

/* A picture that is wider than the driver's framebuffers is in tiles of one width, as high as if
 * they were as wide as the picture. */
static void tiles_share_the_width(void **state)
{
    (void)state;
    MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(
        IMAGE WALL "camera: { camera: Perspective, position: [0, -2, 0], target: [0, 0, 0] }\n",
        &options, &document);
    GlContext *gl = frame_context();
    RendererOptions asked = {.compile = &options, .view = "light", .no_shadows = true};
    float *whole = frame_floats(gl, scene, &asked);
    const int most = gl->max_texture_size;
    gl->max_texture_size = 190;
    Renderer *renderer = renderer_open(gl, &asked);
    assert_true(renderer && renderer_set_scene(renderer, scene));
    assert_int_equal(renderer_tile_width(renderer), WIDTH / 2);
    assert_int_equal(renderer_tile_height(renderer), HEIGHT);
    renderer_close(renderer);
    float *parts = frame_tiles(gl, scene, &asked);
    assert_memory_equal(whole, parts, (size_t)WIDTH * HEIGHT * 4 * sizeof *whole);
    gl->max_texture_size = most;
    free(parts);
    free(whole);
    gl_close(gl);
    frame_forget(scene, document);
}

/* Sixteen times as many pixels take no more texels. */
static void memory_does_not_grow(void **state)
{
    (void)state;
    enum { MEMORY = 1 << 20, SMALL = 512, LARGE = 2048 };
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    MatcDocument *document;
    Scene *scene = frame_scene(IMAGE WALL, &options, &document);
    GlContext *gl = frame_context();
    long texels[2];
    for (int k = 0; k < 2; k++) {
        const int edge = k ? LARGE : SMALL;
        frame_count_calls(gl);
        Renderer *renderer = renderer_open(
            gl, &(RendererOptions){
                    .compile = &options, .width = edge, .height = edge, .memory = MEMORY});
        assert_true(renderer && renderer_set_scene(renderer, scene) && renderer_frame(renderer));
        assert_true(renderer_tile_width(renderer) * renderer_tile_height(renderer) *
                        renderer_pixel_bytes(renderer) <=
                    MEMORY);
        texels[k] = frame_calls.texels;
        renderer_close(renderer);
        gl_close(gl); /* the counters stand in it */
        gl = frame_context();
    }
    assert_true(texels[0] > SMALL * RENDERER_TILE_MIN && texels[1] <= texels[0]);
    gl_close(gl);
    frame_forget(scene, document);
}

/* -- scenes of the gallery, 200 pixels wide, in tiles of 34 rows */

typedef struct {
    double depth;   /* the greatest difference of a pixel's depth, in parts of it */
    int pixels;     /* of the picture */
    int moved;      /* pixels whose 8 bits differ */
    int most_steps; /* of 8 bits, by which one does */
} Seams;

static void compare(const float *whole, const float *parts, bool depth, Seams *seams)
{
    for (int i = 0; i < seams->pixels; i++) {
        int most = 0;
        for (int component = 0; component < 3 && !depth; component++) {
            const int steps = abs((int)lrintf(whole[4 * i + component] * 255) -
                                  (int)lrintf(parts[4 * i + component] * 255));
            most = steps > most ? steps : most;
        }
        if (depth && whole[4 * i] != parts[4 * i])
            seams->depth = fmax(seams->depth, fabs(parts[4 * i] / (double)whole[4 * i] - 1));
        seams->moved += most > 0;
        seams->most_steps = most > seams->most_steps ? most : seams->most_steps;
    }
}

static Scene *read_file(const char *name, const MatcOptions *options, MatcDocument **document)
{
    enum { MOST = 1 << 20 };
    Scene *scene = NULL;
    char *text = malloc(MOST);
    FILE *file = fopen(name, "rb");
    assert_true(text && file);
    *document = scene_read(name, text, fread(text, 1, MOST, file), options, &scene);
    assert_true(scene);
    scene->height = scene->height * WIDTH / scene->width / 2 * 2;
    scene->width = WIDTH;
    fclose(file);
    free(text);
    return scene;
}

static Seams seams_of(GlContext *gl, const char *name)
{
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    MatcDocument *document;
    Scene *scene = read_file(name, &options, &document);
    Seams seams = {.pixels = scene->width * scene->height};
    for (int view = 0; view < 2; view++) {
        RendererOptions renderer = {.compile = &options, .view = view ? "final" : "depth"};
        float *whole = frame_floats(gl, scene, &renderer);
        memcpy(renderer.tile, tiles[0], sizeof renderer.tile);
        float *parts = frame_tiles(gl, scene, &renderer);
        compare(whole, parts, !view, &seams);
        free(parts);
        free(whole);
    }
    frame_forget(scene, document);
    return seams;
}

/* Solids of every kind under a sky, and glass in lists. */
static void seams_of_the_gallery(void **state)
{
    (void)state;
    static const char *const names[] = {"examples/scenes/solids.yaml",
                                        "examples/scenes/nested.yaml"};
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const Seams seams = seams_of(gl, names[i]);
        assert_true(seams.depth < 4e-6);
        assert_true(seams.moved <= seams.pixels / 2000 && seams.most_steps <= 1);
    }
    gl_close(gl);
}

static int print_seams(int count, char **arguments)
{
    const GlKind kind = frame_kind(count, arguments);
    GlContext *gl = frame_context_of(kind);
    printf("%-40s   depth  pixels that differ, by steps of 8 bits\n", "scene");
    for (int i = 1; i < count - (kind == GL_KIND_egl); i++) {
        const Seams seams = seams_of(gl, arguments[i]);
        printf("%-40s %7.1e  %4d of %d, %d\n", arguments[i], seams.depth, seams.moved, seams.pixels,
               seams.most_steps);
        fflush(stdout);
    }
    gl_close(gl);
    return 0;
}

int main(int count, char **arguments)
{
    if (count > 1)
        return print_seams(count, arguments);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_are_the_pictures), cmocka_unit_test(seams_are_rounding),
        cmocka_unit_test(seams_of_the_gallery),  cmocka_unit_test(tiles_fit_the_memory),
        cmocka_unit_test(tiles_share_the_width), cmocka_unit_test(memory_does_not_grow)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
