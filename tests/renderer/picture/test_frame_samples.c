/* Supersampling: a picture is the mean of a larger one. Light is averaged as displayed radiance;
 * light, depth and slots of views are averaged plainly, and samples without a surface have no
 * weight in a slot. In tiles, with edges, in compute and in fragment programs. */
/* ctest: seconds=19 */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 42, HEIGHT = 30, PIXELS = WIDTH * HEIGHT };

static const char text[] =
    "image: { width: 42, height: 30 }\ncamera: { camera: Perspective, position: [.5, -5, 2] }\n"
    "toneMapping: { toneMapping: Shoulder }\nlights: [{ light: Point, position: [1, -4, 4], "
    "intensity: 30 }]\n"
    "objects: [{ object: Sphere, material: { material: Phong, diffuse: { map: Checker, color1: .9, "
    "color2: .2, "
    "input: { map: UVTransform, scaleU: 8, scaleV: 8 } } } },\n"
    "  { object: Box, size: [3, .1, .2], material: { material: Phong, diffuse: [.3, .1, .9], "
    "transparency: .5 }, "
    "transform: { translation: [0, -1.5, .4] } }]\n";

/* IEC 61966-2-1. */
static double decoded(double c) { return c <= .04045 ? c / 12.92 : pow((c + .055) / 1.055, 2.4); }
static double encoded(double c)
{
    return c <= .0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - .055;
}

/* From tiles, each read by itself, from malloc. */
static float *draw(GlContext *gl, const Scene *scene, const RendererOptions *options)
{
    Renderer *renderer = renderer_open(gl, options);
    if (!renderer || !renderer_set_scene(renderer, scene))
        fail_msg("%s", gl->error);
    const int width = renderer_width(renderer), height = renderer_height(renderer);
    const int tile[2] = {renderer_tile_width(renderer), renderer_tile_height(renderer)};
    float *all = calloc((size_t)width * (size_t)height, 4 * sizeof *all);
    float *part = calloc((size_t)tile[0] * (size_t)tile[1], 4 * sizeof *part);
    assert_true(all && part);
    for (int y = 0; y < height; y += tile[1])
        for (int x = 0; x < width; x += tile[0]) {
            renderer_set_tile(renderer, x, y);
            assert_true(renderer_frame(renderer) && renderer_read(renderer, part));
            for (int row = 0; row < tile[1] && y + row < height; row++)
                memcpy(all + 4 * ((y + row) * width + x), part + 4 * row * tile[0],
                       4 * sizeof *all * (size_t)(x + tile[0] > width ? width - x : tile[0]));
        }
    free(part);
    renderer_close(renderer);
    return all;
}

/* The n x n texels of a large picture that are a pixel's; of a slot, those of a surface. */
static double mean(const float *large, int n, int pixel, int component, const char *view)
{
    const bool shown = !view,
               slot = view && strcmp(view, "light") && strcmp(view, "depth") && component < 3;
    double sum = 0, count = 0;
    for (int i = 0; i < n * n; i++) {
        const int x = pixel % WIDTH * n + i % n, y = pixel / WIDTH * n + i / n;
        const float *at = large + 4 * (y * WIDTH * n + x);
        const double share = slot ? at[3] : 1;
        sum += share * (shown && component < 3 ? decoded(at[component]) : at[component]);
        count += share;
    }
    sum /= count > 0 ? count : 1;
    return shown && component < 3 ? encoded(sum) : sum;
}

static void pixels_are_means(void **state)
{
    (void)state;
    static const struct {
        const char *view;
        int samples, tile;
        RendererEdges edges;
        bool fragment;
        const char *layout; /* of compact's codes, those of nothing mean something, too */
    } cases[] = {
        {NULL, 2, 0, RENDERER_EDGES_none, false, "integer"},
        {NULL, 3, 12, RENDERER_EDGES_coverage, false, "integer"},
        {NULL, 4, 16, RENDERER_EDGES_none, true, "integer"},
        {"light", 2, 10, RENDERER_EDGES_none, false, "integer"},
        {"diffuse", 3, 0, RENDERER_EDGES_none, false, "integer"},
        {"depth", 2, 0, RENDERER_EDGES_none, false, "integer"},
        {"normal", 2, 0, RENDERER_EDGES_none, false, "compact"},
    };
    MatcDocument *document;
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    Scene *scene = frame_scene(text, &options, &document);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const int n = cases[i].samples;
        MatcOptions compile = options;
        compile.layout = cases[i].layout;
        RendererOptions how = {.compile = &compile,
                               .view = cases[i].view,
                               .edges = cases[i].edges,
                               .deep = true,
                               .fragment = cases[i].fragment,
                               .width = n * WIDTH,
                               .height = n * HEIGHT};
        float *large = draw(gl, scene, &how);
        how.width = how.height = 0;
        how.samples = n;
        how.tile[0] = how.tile[1] = cases[i].tile;
        float *small = draw(gl, scene, &how);
        double most = 0, light = 0;
        for (int k = 0; k < 4 * PIXELS; k++) {
            most = fmax(most, fabs(small[k] - mean(large, n, k / 4, k % 4, cases[i].view)));
            light += small[k];
        }
        print_message("%s, %d x %d: %g\n", cases[i].view ? cases[i].view : "final", n, n, most);
        assert_true(light > PIXELS / 8 && most < 1e-4);
        free(large);
        free(small);
    }
    frame_forget(scene, document);
    gl_close(gl);
}

static void too_many(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    assert_null(renderer_open(gl, &(RendererOptions){.compile = &options, .samples = 9}));
    assert_string_equal(gl->error, "samples are 1 to 8, not 9");
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(pixels_are_means),
                                       cmocka_unit_test(too_many)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
