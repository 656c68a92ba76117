/* Views as PNG files show them, under OSMesa: each has more than sixteen colors in five scenes,
 * depth and normals are the documented formulas, and OpenEXR files keep the renderer's numbers. */
/* ctest: unsanitized seconds=20 */
#include "tests/test.h"
#include "grammar/tables.h"
#include "runtime/viewer/scene_picture.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/frame_example.h"
#include <OpenEXR/openexr.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
    WIDTH = 96,
    FEWEST_COLORS = 17,
    VARIED = 64, /* different values of a slot that varies */
    ROWS = 16    /* of a block of OpenEXR */
};
static const double varied_span = 1.0 / 8;

static const char *const scenes[] = {"solids", "coats", "brushed", "roughness", "vase"};
enum { SCENES = sizeof scenes / sizeof *scenes };

static MatcOptions options_of(void)
{
    MatcOptions options;
    matc_options_init(&options);
    options.layout = "integer"; /* it stores every slot */
    options.pixels = true;
    return options;
}

static Scene *read_example(const char *name, const MatcOptions *options, MatcDocument **document)
{
    Scene *scene = frame_example(name, WIDTH, options, document);
    scene->indirect.method = KEYWORD_Indirect_march; /* so that there is ambient occlusion */
    return scene;
}

/* -- colors of the bytes */

static unsigned char *bytes_of(GlContext *gl, const Scene *scene, const MatcOptions *options,
                               const char *view)
{
    const ScenePictureOptions how = {.renderer = {.compile = options, .view = view}};
    unsigned char *rgb = malloc((size_t)scene->width * (size_t)scene->height * 3);
    ScenePictures *pictures = scene_pictures_open(gl, &how);
    if (!rgb || !pictures || !scene_pictures_show(pictures, scene) ||
        !scene_pictures_pixels(pictures, rgb))
        fail_msg("%s: %s", view, gl->error);
    scene_pictures_close(pictures);
    return rgb;
}

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int count_different(double *values, int count)
{
    int different = count > 0;
    qsort(values, (size_t)count, sizeof *values, by_value);
    for (int i = 1; i < count; i++)
        different += values[i] != values[i - 1];
    return different;
}

static int count_colors(const unsigned char *rgb, int pixels)
{
    double *colors = malloc((size_t)pixels * sizeof *colors);
    assert_non_null(colors);
    for (int i = 0; i < pixels; i++)
        colors[i] = rgb[3 * i] * 65536 + rgb[3 * i + 1] * 256 + rgb[3 * i + 2];
    const int count = count_different(colors, pixels);
    free(colors);
    return count;
}

static void assert_colorful(GlContext *gl, const char *name, const char *view)
{
    const MatcOptions options = options_of();
    MatcDocument *document;
    Scene *scene = read_example(name, &options, &document);
    unsigned char *rgb = bytes_of(gl, scene, &options, view);
    const int colors = count_colors(rgb, scene->width * scene->height);
    if (colors < FEWEST_COLORS)
        fail_msg("%s: the view %s has %d colors", name, view, colors);
    free(rgb);
    frame_forget(scene, document);
}

static void views_have_colors(void **state)
{
    (void)state;
    static const char *const views[] = {"depth", "normal", "positions", "light", "ao"};
    GlContext *gl = frame_context();
    for (int i = 0; i < SCENES; i++)
        for (size_t k = 0; k < sizeof views / sizeof *views; k++)
            assert_colorful(gl, scenes[i], views[k]);
    gl_close(gl);
}

/* Its first component has many values, far apart, where a surface is. */
static bool varies(const float *rgba, int pixels)
{
    double *values = malloc((size_t)pixels * sizeof *values);
    int count = 0;
    assert_non_null(values);
    for (int i = 0; i < pixels; i++)
        if (rgba[4 * i + 3] > 0)
            values[count++] = rgba[4 * i];
    const bool does =
        count_different(values, count) > VARIED && values[count - 1] - values[0] > varied_span;
    free(values);
    return does;
}

static void slots_that_vary_have_colors(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    const MatcOptions options = options_of();
    int varied = 0;
    for (int i = 0; i < SCENES; i++) {
        MatcDocument *document;
        Scene *scene = read_example(scenes[i], &options, &document);
        for (int slot = 0; slot < SLOT_COUNT; slot++) {
            float *rgba = frame_floats(
                gl, scene, &(RendererOptions){.compile = &options, .view = slot_table[slot].name});
            if (varies(rgba, scene->width * scene->height)) {
                assert_colorful(gl, scenes[i], slot_table[slot].name);
                varied++;
            }
            free(rgba);
        }
        frame_forget(scene, document);
    }
    print_message("%d slots vary\n", varied);
    assert_true(varied >= 2 * SCENES);
    gl_close(gl);
}

/* -- depth */

#define GROUND                                                                                     \
    "image: { width: 32, height: 32 }\n"                                                           \
    "objects: [{ object: Plane, material: { material: Phong } }]\n"

/* Above a plane, looking straight down from 4: each point is 4 away along the view, and the target
 * is `far` away. The orthographic one has it at 4 of a depth of 100. */
static void depth_is_its_formula(void **state)
{
    (void)state;
    static const struct {
        const char *camera;
        double shown;
    } cases[] = {
        {"{ camera: Perspective, position: [0, 0, 4], target: [0, 0, 0], up: [0, 1, 0] }", .5},
        {"{ camera: Perspective, position: [0, 0, 4], target: [0, 0, -4], up: [0, 1, 0] }", .8},
        {"{ camera: Perspective, position: [0, 0, 4], target: [0, 0, 2], up: [0, 1, 0], near: 3 }",
         .2},
        {"{ camera: Orthographic, position: [0, 0, 4], target: [0, 0, 0], up: [0, 1, 0] }", .5},
        {"{ camera: Orthographic, position: [0, 0, 4], target: [0, 0, 2], up: [0, 1, 0], depth: 9 "
         "}",
         .2},
        /* the sky */
        {"{ camera: Perspective, position: [0, 0, 4], target: [0, 0, 8], up: [0, 1, 0] }", 0},
    };
    GlContext *gl = frame_context();
    const MatcOptions options = options_of();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[512];
        MatcDocument *document;
        snprintf(text, sizeof text, GROUND "camera: %s\n", cases[i].camera);
        Scene *scene = frame_scene(text, &options, &document);
        unsigned char *rgb = bytes_of(gl, scene, &options, "depth");
        for (int k = 0; k < 3 * scene->width * scene->height; k++)
            assert_true(fabs(rgb[k] - 255 * cases[i].shown) <= .51);
        free(rgb);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* A plane turned about x by the angle whose sine is 0.6: its normal is (0, -0.6, 0.8) to the camera
 * above, which was cut at 0 once. */
static void normals_below_zero_are_shown(void **state)
{
    (void)state;
    static const double shown[3] = {.5, .2, .9};
    GlContext *gl = frame_context();
    const MatcOptions options = options_of();
    MatcDocument *document;
    Scene *scene =
        frame_scene("image: { width: 8, height: 8 }\n"
                    "camera: { camera: Perspective, position: [0, 0, 4], up: [0, 1, 0] }\n"
                    "objects: [{ object: Plane, transform: { rotation: [0.6435011, 0, 0] }, "
                    "material: { material: Phong } }]\n",
                    &options, &document);
    unsigned char *rgb = bytes_of(gl, scene, &options, "normal");
    for (int k = 0; k < 3 * scene->width * scene->height; k++)
        assert_true(fabs(rgb[k] - 255 * shown[k % 3]) <= 1.01);
    free(rgb);
    frame_forget(scene, document);
    gl_close(gl);
}

/* -- OpenEXR */

static char path[] = "/tmp/matc_viewsXXXXXX";

/* Compares one block of rows with the renderer's floats, whose first row is the lowest. */
static void compare_block(exr_context_t exr, int top, const Scene *scene, const float *rgba)
{
    static float planes[4][ROWS * WIDTH];
    exr_chunk_info_t chunk;
    exr_decode_pipeline_t pipe = EXR_DECODE_PIPELINE_INITIALIZER;
    assert_int_equal(exr_read_scanline_chunk_info(exr, 0, top, &chunk), 0);
    assert_int_equal(exr_decoding_initialize(exr, 0, &chunk, &pipe), 0);
    for (int i = 0; i < pipe.channel_count; i++) {
        pipe.channels[i].user_data_type = EXR_PIXEL_FLOAT;
        pipe.channels[i].user_bytes_per_element = pipe.channels[i].user_pixel_stride =
            sizeof(float);
        pipe.channels[i].user_line_stride = WIDTH * sizeof(float);
        pipe.channels[i].decode_to_ptr = (uint8_t *)planes[i];
    }
    assert_int_equal(exr_decoding_choose_default_routines(exr, 0, &pipe), 0);
    assert_int_equal(exr_decoding_run(exr, 0, &pipe), 0);
    for (int i = 0; i < pipe.channel_count; i++) {
        static const char order[] = "RGBA";
        const char *place = strchr(order, *pipe.channels[i].channel_name);
        const int component = place ? (int)(place - order) : 0;
        for (int y = 0; y < chunk.height; y++)
            for (int x = 0; x < WIDTH; x++) {
                const int row = scene->height - 1 - top - y;
                assert_true(planes[i][y * WIDTH + x] == rgba[4 * (row * WIDTH + x) + component]);
            }
    }
    exr_decoding_destroy(exr, &pipe);
}

static void exr_is_raw(void **state)
{
    (void)state;
    static const char *const views[] = {"depth", "normal", "light", "ao", "diffuse"};
    GlContext *gl = frame_context();
    const MatcOptions options = options_of();
    const int file = mkstemp(path);
    assert_true(file >= 0);
    close(file);
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        MatcDocument *document;
        ScenePicture picture;
        exr_context_t exr;
        Scene *scene = read_example("solids", &options, &document);
        const ScenePictureOptions how = {.renderer = {.compile = &options, .view = views[i]},
                                         .format = PICTURE_FORMAT_exr,
                                         .bits = 32};
        RendererOptions same = how.renderer;
        same.linear = same.deep = true;
        float *rgba = frame_floats(gl, scene, &same);
        ScenePictures *pictures = scene_pictures_open(gl, &how);
        assert_true(pictures && scene_pictures_show(pictures, scene) &&
                    scene_pictures_draw(pictures, path, &picture));
        assert_int_equal(exr_start_read(&exr, path, NULL), 0);
        for (int top = 0; top < scene->height; top += ROWS)
            compare_block(exr, top, scene, rgba);
        exr_finish(&exr);
        scene_pictures_close(pictures);
        free(rgba);
        frame_forget(scene, document);
    }
    unlink(path);
    gl_close(gl);
}

static void old_names_of_views_are_aliases(void **state)
{
    (void)state;
    assert_string_equal(renderer_view_canonical("shown"), "final");
    assert_string_equal(renderer_view_canonical("open"), "ao");
    assert_string_equal(renderer_view_canonical("depth"), "depth");
    assert_null(renderer_view_canonical(NULL));
    const MatcOptions options = options_of();
    GlContext *gl = frame_context();
    static const char *const views[] = {"shown", "open"};
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        Renderer *renderer =
            renderer_open(gl, &(RendererOptions){.compile = &options, .view = views[i]});
        assert_non_null(renderer);
        renderer_close(renderer);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(old_names_of_views_are_aliases), cmocka_unit_test(views_have_colors),
        cmocka_unit_test(slots_that_vary_have_colors),    cmocka_unit_test(depth_is_its_formula),
        cmocka_unit_test(normals_below_zero_are_shown),   cmocka_unit_test(exr_is_raw),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
