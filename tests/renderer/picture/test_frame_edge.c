/* Edges blended by coverage, against 8 x 8 of Embree's rays through each pixel, with the
 * objects' flat colors; lines of the picture by closed forms; hidden edges; tiles. */
/* ctest: seconds=10 */
#include "tests/test.h"
#include "runtime/gpu_scene/edge_list.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/reference_ray.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 240, HEIGHT = 160, SAMPLES = 8 };

#define CAMERA                                                                                     \
    "image: { width: 240, height: 160 }\ncamera: { camera: Perspective, position: [.5, -6, 2.5], " \
    "target: [0, 0, .5], "                                                                         \
    "angle: 40 }\n"
#define GLOWS(rgb) "material: { material: Phong, emissive: " rgb " }"

/* IEC 61966-2-1 */
static double encoded(double c)
{
    return c <= .0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - .055;
}

/* -- against samples */

typedef struct {
    const char *name, *text;
    double colors[5][3]; /* of each object, the sky's last; linear, mapped */
    double most;         /* RMSE bound of pixels with edges: 1.03 to 1.1 times the measured */
    int spoiled;         /* maximum of other pixels: one or two more than measured */
} EdgeCase;

static const EdgeCase cases[] = {
    {"solids",
     CAMERA "objects:\n- { object: Sphere, " GLOWS(
         "[1, 1, 1]") " }\n"
                      "- { object: Box, " GLOWS(
                          "[.125, .5, .875]") ", transform: { translation: [1.9, 0, 0], rotation: "
                                              "[.3, .4, .5] } }\n"
                                              "- { object: Parallelogram, u: [2, 0, 0], v: [0, .5, "
                                              "2], " GLOWS(
                                                  "[.875, .5, .125]") ", transform: { translation: "
                                                                      "[-2.5, 0, 0], "
                                                                      "rotation: [.3, .4, .5] } }\n"
                                                                      "sky: { material: RGBA, r: "
                                                                      "0, g: 0, b: 0 }\n",
     {{1, 1, 1}, {.125, .5, .875}, {.875, .5, .125}, {0}},
     .0125,
     2},
    {"horizon, what stands on a plane, a cone's tip",
     CAMERA "objects:\n- { object: Plane, " GLOWS(
         "[.25, .5, .125]") " }\n"
                            "- { object: Cylinder, " GLOWS(
                                "[.75, 0, 0]") ", transform: { translation: [-1, 0, 0] } }\n"
                                               "- { object: Cone, " GLOWS(
                                                   "[1, 1, .25]") ", transform: { translation: [1, "
                                                                  ".3, 0], scale: [1, "
                                                                  "1, 2] } }\n"
                                                                  "sky: { material: RGBA, r: .25, "
                                                                  "g: .5, b: 1 }\n",
     {{.25, .5, .125}, {.75, 0, 0}, {1, 1, .25}, {.25, .5, 1}},
     .02,
     3},
    /* blended before it is mapped, nearly all of the edge would be white */
    {"a lamp: 64 times what is white",
     CAMERA "objects: [{ object: Sphere, " GLOWS(
         "[64, 64, 64]") " }]\nsky: { material: RGBA, r: .125, g: .125, b: .125 }\n",
     {{1, 1, 1}, {.125, .125, .125}},
     .0085,
     1},
    {"orthographic, mirrored",
     "image: { width: 240, height: 160 }\ncamera: { camera: Orthographic, position: [.5, -6, 2.5], "
     "size: 3, depth: 20 "
     "}\n"
     "objects:\n- { object: Box, " GLOWS(
         "[.5, .25, 0]") ", transform: { rotation: [.3, .2, .7], scale: [-1, 1, 1] } }\n"
                         "- { object: Sphere, radius: .5, " GLOWS(
                             "[0, 1, 1]") ", transform: { translation: [1.5, 0, 0], scale: [1, -1, "
                                          "1.2] } }\n",
     {{.5, .25, 0}, {0, 1, 1}, {0}},
     .0165,
     3},
    {"arches: outlines that a volume hides itself, beside those that it shows",
     "image: { width: 240, height: 160 }\ncamera: { camera: Perspective, position: [-.6, -6.2, "
     "1.1], target: [-1, 0, "
     ".7], "
     "angle: 20 }\ndisplacement: { triangles: 60000 }\ndefs: { rough: '= fbm(3 * p, 5)' }\n"
     "objects:\n- { object: Parallelogram, u: [7, 0, 0], v: [0, 5, 0], transform: { translation: "
     "[-3.5, -2.5, 0] }, "
     "material: { material: Phong, emissive: [.875, .5, .125], displacementBound: 3, "
     "displacementVolume: '= "
     "wall = .32 + .06 * rough - abs(y - 3.4 - .1 * sin(2 * x)); across = x % 1.75 - .875; gate = "
     ".36 - across^2 + .05 "
     "* rough; "
     "top = wall > 0 ? .95 + .12 * rough + .3 * sqrt(wall) : -1; "
     "[-.3, .05 * rough, gate > 0 ? 1.3 * sqrt(gate) : -.2, top]' } }\n"
     "sky: { material: RGBA, r: 0, g: 0, b: .25 }\n",
     {{.875, .5, .125}, {0, 0, .25}},
     .0435,
     57},
};

/* The mean of a pixel's samples, as sRGB; returns true if they differ. */
static bool reference(const EdgeCase *c, const Tracer *tracer, const int at[2], double mean[3])
{
    const Scene *scene = tracer->scene;
    double sum[3] = {0};
    int first = -2;
    bool edge = false;
    for (int i = 0; i < SAMPLES * SAMPLES; i++) {
        const Ray ray = reference_ray(scene, at[0] + (i % SAMPLES + .5) / SAMPLES,
                                      at[1] + (i / SAMPLES + .5) / SAMPLES);
        const int object = reference_hit(tracer, &ray, 0).object;
        edge |= first > -2 && object != first;
        first = object;
        for (int component = 0; component < 3; component++)
            sum[component] += c->colors[object < 0 ? scene->object_count : object][component];
    }
    for (int component = 0; component < 3; component++)
        mean[component] = encoded(sum[component] / (SAMPLES * SAMPLES));
    return edge;
}

typedef struct {
    double sum[2]; /* of squares: without blending, and with */
    int count;     /* of pixels that edges run through */
    int spoiled;   /* pixels without an edge into which another color is blended */
} EdgeSum;

static void compare(const EdgeCase *c, const Tracer *tracer, float *const pictures[2],
                    EdgeSum *band)
{
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double mean[3];
        const bool edge = reference(c, tracer, (const int[]){i % WIDTH, i / WIDTH}, mean);
        band->count += edge;
        bool apart = false;
        for (int k = 0; k < 2; k++)
            for (int component = 0; component < 3; component++) {
                const double off = pictures[k][4 * i + component] - mean[component];
                band->sum[k] += edge ? off * off / 3 : 0;
                apart |= k == 1 && fabs(off) > .1;
            }
        band->spoiled += apart && !edge;
    }
}

static void edges_are_coverage(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        MatcDocument *document;
        Scene *scene = frame_scene(cases[k].text, &options, &document);
        float *pictures[2];
        EdgeSum band = {{0}, 0, 0};
        for (int edges = 0; edges < 2; edges++)
            pictures[edges] = frame_floats(
                gl, scene,
                &(RendererOptions){.compile = &options,
                                   .deep = true,
                                   .edges = edges ? RENDERER_EDGES_coverage : RENDERER_EDGES_none});
        Tracer tracer = reference_open(scene);
        compare(&cases[k], &tracer, pictures, &band);
        const double none = sqrt(band.sum[0] / band.count),
                     coverage = sqrt(band.sum[1] / band.count);
        print_message("%s: %d pixels, RMSE %.4f, blended %.4f; %d others spoiled\n", cases[k].name,
                      band.count, none, coverage, band.spoiled);
        assert_true(band.count > 200 && none > .1);
        assert_true(coverage <= cases[k].most && band.spoiled <= cases[k].spoiled);
        reference_close(&tracer);
        free(pictures[0]);
        free(pictures[1]);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* -- what is left alone */

/* A wall before all of a box and a sphere: a picture without an edge, and with a pattern that a
 * line through it would blur. */
static void hidden_lines_are_not_seen(void **state)
{
    (void)state;
    static const char text[] = CAMERA "lights: [{ light: Ambient }]\nobjects:\n- { object: Box, "
                                      "material: { material: Phong, ambient: .5 } }\n"
                                      "- { object: Sphere, material: { material: Phong, ambient: "
                                      ".25 }, transform: { translation: [1, 1, 0] } }\n"
                                      "- { object: Parallelogram, u: [20, 0, 0], v: [0, 0, 20], "
                                      "transform: { translation: [-10, -2, -10] }, "
                                      "material: { material: Phong, ambient: { map: Checker, "
                                      "input: { map: UVTransform, scaleU: 40, scaleV: 40 } } } "
                                      "}\n";
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(text, &options, &document);
    GlContext *gl = frame_context();
    float *none = frame_floats(gl, scene, &(RendererOptions){.compile = &options});
    float *coverage = frame_floats(
        gl, scene, &(RendererOptions){.compile = &options, .edges = RENDERER_EDGES_coverage});
    assert_memory_equal(none, coverage, (size_t)WIDTH * HEIGHT * 4 * sizeof *none);
    free(none);
    free(coverage);
    gl_close(gl);
    frame_forget(scene, document);
}

/* Tiles read outside of their border; light before tone mapping is blended, too, and its alpha. */
static void tiles_and_light(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(CAMERA "objects: [{ object: Sphere, " GLOWS("[8, 4, 2]") " }]\n",
                               &options, &document);
    GlContext *gl = frame_context();
    RendererOptions choice = {
        .compile = &options, .edges = RENDERER_EDGES_coverage, .linear = true};
    float *whole = frame_floats(gl, scene, &choice), *tile = calloc(64 * 64, 4 * sizeof *tile);
    choice.tile[0] = choice.tile[1] = 64;
    Renderer *renderer = renderer_open(gl, &choice);
    int apart = 0, between = 0;
    assert_true(renderer && renderer_set_scene(renderer, scene) && tile);
    assert_int_equal(renderer_tile_width(renderer), 64);
    for (int y = 0; y < HEIGHT; y += 64)
        for (int x = 0; x < WIDTH; x += 64) {
            renderer_set_tile(renderer, x, y);
            assert_true(renderer_frame(renderer) && renderer_read(renderer, tile));
            for (int i = 0; i < 64 * 64; i++) {
                const int at = (y + i / 64) * WIDTH + x + i % 64;
                if (y + i / 64 >= HEIGHT || x + i % 64 >= WIDTH)
                    continue;
                const float *seen = tile + 4 * i;
                apart += fabsf(seen[0] - whole[4 * at]) > .01f;
                between += seen[3] > 0 && seen[3] < 1;
                assert_true(fabsf(seen[0] - 8 * seen[3]) < 1e-5f &&
                            fabsf(seen[2] - 2 * seen[3]) < 1e-5f);
            }
        }
    assert_true(between > 100);
    assert_true(apart <= 3); /* one pixel in 100 of the edge */
    renderer_close(renderer);
    free(whole);
    free(tile);
    gl_close(gl);
    frame_forget(scene, document);
}

/* After the camera or an object has moved, edges are those of the new picture. */
static void edges_move(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(
        CAMERA "objects: [{ object: Box, " GLOWS("1") " }, { object: Sphere, " GLOWS(".5") " }]\n",
        &options, &document);
    const RendererOptions choice = {
        .compile = &options, .edges = RENDERER_EDGES_coverage, .linear = true};
    GlContext *gl = frame_context();
    Renderer *renderer = renderer_open(gl, &choice);
    float *seen = calloc((size_t)WIDTH * HEIGHT, 4 * sizeof *seen);
    assert_true(renderer && renderer_set_scene(renderer, scene) && seen);
    for (int change = 0; change < 2; change++) {
        scene->objects[1].world_from_local.m[12] = 1.5 * change;
        scene->camera.position[0] += .125;
        assert_true(renderer_changed(renderer, RENDERER_CAMERA) &&
                    renderer_changed_objects(renderer, 1, 1));
        float *expected = frame_floats(gl, scene, &choice);
        assert_true(renderer_frame(renderer) && renderer_read(renderer, seen));
        assert_memory_equal(expected, seen, (size_t)WIDTH * HEIGHT * 4 * sizeof *seen);
        free(expected);
    }
    free(seen);
    renderer_close(renderer);
    gl_close(gl);
    frame_forget(scene, document);
}

/* -- lines */

static void sum_lines(const char *text, int (*size)[2], EdgeList *list, double *length)
{
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(text, &options, &document);
    ViewSpace space;
    (*size)[0] = scene->width;
    (*size)[1] = scene->height;
    view_space_make(&scene->camera, *size, true, &space);
    assert_true(edge_list_make(scene, &space, *size, list));
    *length = 0;
    for (int i = 0; i < list->count; i++) {
        const EdgeEnd *line = list->lines[i];
        const double x = line[1].x - line[0].x, y = line[1].y - line[0].y;
        assert_true(fmax(fabs(x), fabs(y)) <= EDGE_LIST_PIECE + 1e-3);
        *length += sqrt(x * x + y * y);
    }
    frame_forget(scene, document);
}

/* 100 pixels a unit: a square that is faced, a box's creases, the part of a square that is in view
 * and what is a pixel beside it, and a horizon in the middle. */
static void lines_have_their_lengths(void **state)
{
    (void)state;
#define FACED                                                                                      \
    "image: { width: 400, height: 400 }\ncamera: { camera: Orthographic, position: [0, -5, 0], "   \
    "size: 4, depth: 20 }\n"
    static const struct {
        const char *text;
        double length, within;
    } rows[] = {
        {FACED "objects: [{ object: Parallelogram, u: [2, 0, 0], v: [0, 0, 1], " GLOWS("1") " }]\n",
         600, .01},
        /* front and back */
        {FACED "objects: [{ object: Box, size: [1, 1, 2], " GLOWS("1") " }]\n", 1200, .01},
        {FACED "objects: [{ object: Parallelogram, u: [9, 0, 0], v: [0, 0, 9], " GLOWS("1") " }]\n",
         402, .01},
        {"image: { width: 400, height: 300 }\ncamera: { camera: Perspective, position: [0, 0, 1], "
         "target: [0, 1, 1] }\n"
         "objects: [{ object: Plane, " GLOWS("1") " }]\n",
         402, .01}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        EdgeList list;
        int size[2];
        double length;
        sum_lines(rows[i].text, &size, &list, &length);
        if (fabs(length - rows[i].length) > rows[i].within)
            fail_msg("row %zu: %g", i, length);
        if (i == 3)
            assert_true(fabs(list.lines[0][0].y - 150) < 1e-3 && list.lines[0][0].depth == 0);
        edge_list_free(&list);
    }
}

/* A sphere's outline lies on its triangles: a little within the circle of 100 pixels. */
static void outlines_are_where_they_are_seen(void **state)
{
    (void)state;
    EdgeList list;
    int size[2];
    double length;
    sum_lines(FACED "objects: [{ object: Sphere, transform: { rotation: [.1, .2, .02] }, " GLOWS(
                  "1") " }]\n",
              &size, &list, &length);
    assert_true(length > 600);
    for (int i = 0; i < 2 * list.count; i++) {
        const EdgeEnd *end = &list.lines[i / 2][i % 2];
        const double radius = hypot(end->x - 200, end->y - 200);
        assert_true(radius > 99 && radius < 100.001);
        assert_true(fabs(end->depth - .75) < .02); /* 5 of 20 */
    }
    edge_list_free(&list);
}

/* Without compute, the reason is reported. */
static void reason(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene("objects: []\n", &options, &document);
    GlContext *gl = frame_context();
    for (int i = 0; i < 4; i++) {
        const RendererOptions how = {.compile = &options,
                                     .edges = i & 1 ? RENDERER_EDGES_coverage : RENDERER_EDGES_none,
                                     .fragment = i >> 1};
        Renderer *renderer = renderer_open(gl, &how);
        assert_true(renderer && renderer_set_scene(renderer, scene));
        char *graph = frame_graph(renderer);
        assert_int_equal(strstr(graph, "not run: it takes compute, which is off") != NULL, i == 3);
        free(graph);
        renderer_close(renderer);
    }
    const int major = gl->major, minor = gl->minor;
    gl->major = 3, gl->minor = 3;
    Renderer *renderer = renderer_open(
        gl, &(RendererOptions){.compile = &options, .edges = RENDERER_EDGES_coverage});
    assert_true(renderer && renderer_set_scene(renderer, scene));
    char *graph = frame_graph(renderer);
    assert_non_null(strstr(graph, "not run: it takes compute, which the driver lacks"));
    free(graph);
    renderer_close(renderer);
    gl->major = major, gl->minor = minor;
    gl_close(gl);
    frame_forget(scene, document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(edges_are_coverage),
                                       cmocka_unit_test(hidden_lines_are_not_seen),
                                       cmocka_unit_test(tiles_and_light),
                                       cmocka_unit_test(edges_move),
                                       cmocka_unit_test(lines_have_their_lengths),
                                       cmocka_unit_test(outlines_are_where_they_are_seen),
                                       cmocka_unit_test(reason)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
