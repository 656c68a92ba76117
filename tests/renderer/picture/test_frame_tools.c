/* Tools: the pixels that a line covers, by its closed form; surfaces before it hide it, and a
 * line in a plane is whole; its color behind glass, before tone mapping and after; no pass runs
 * in a scene without tools. */
/* ctest: seconds=14 */
#include "tests/test.h"
#include "runtime/post/tool_lines.h"
#include "tests/frame/frame_calls.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 240, HEIGHT = 160 };

#define IMAGE       "image: { width: 240, height: 160 }\n"
#define NEAR_ENOUGH (1.01 / 255)

static double encode(double c)
{
    return c <= .0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - .055;
}

/* Color of a tool of that linear color behind a transmittance. */
static bool is_color(const float *pixel, const double color[3], const double through[3])
{
    for (int i = 0; i < 3; i++)
        if (fabs(pixel[i] - encode(color[i] * through[i])) > NEAR_ENOUGH)
            return false;
    return true;
}

static const double clear[3] = {1, 1, 1},
                    axes[3][3] = {{.7, .02, .02}, {.02, .7, .02}, {.02, .02, 1}},
                    grey[3] = {.214, .214, .214};

static float *draw(const char *text, const RendererOptions *how)
{
    MatcOptions options = frame_exact_options();
    MatcDocument *document;
    RendererOptions all = *how;
    all.compile = &options;
    Scene *scene = frame_scene(text, &options, &document);
    GlContext *gl = frame_context();
    float *rgba = frame_floats(gl, scene, &all);
    gl_close(gl);
    frame_forget(scene, document);
    return rgba;
}

/* -- which pixels */

/* Pixel position of a point for the camera at (3, -4, 2.5) that looks at the origin, 40 degrees
 * over 160 pixels. */
static void project(const double p[3], double at[2])
{
    const double eye[3] = {3, -4, 2.5}, length = sqrt(9 + 16 + 6.25);
    double back[3], right[3], up[3], q[3] = {0};
    for (int i = 0; i < 3; i++)
        back[i] = eye[i] / length;
    right[0] = -back[1] / hypot(back[0], back[1]), right[1] = back[0] / hypot(back[0], back[1]),
    right[2] = 0;
    for (int i = 0; i < 3; i++)
        up[i] = back[(i + 1) % 3] * right[(i + 2) % 3] - back[(i + 2) % 3] * right[(i + 1) % 3];
    for (int i = 0; i < 3; i++) {
        q[0] += right[i] * (p[i] - eye[i]);
        q[1] += up[i] * (p[i] - eye[i]);
        q[2] -= back[i] * (p[i] - eye[i]);
    }
    const double scale = HEIGHT / 2. / tan(20 * 3.14159265358979323846 / 180);
    at[0] = WIDTH / 2. + scale * q[0] / q[2];
    at[1] = HEIGHT / 2. + scale * q[1] / q[2];
}

/* A line covers, in each column (row, where it is steep) between its ends, the pixel that it
 * crosses in the middle of it, and no other. Where it passes between two by less than 1/16 pixel,
 * either. */
static void check_line(const float *rgba, const double color[3], const double a[2],
                       const double b[2])
{
    const int major = fabs(b[0] - a[0]) >= fabs(b[1] - a[1]) ? 0 : 1, rows = major ? WIDTH : HEIGHT;
    const double low = fmin(a[major], b[major]), high = fmax(a[major], b[major]);
    for (int column = (int)ceil(low) + 1; column + 2 < high; column++) {
        const double share = (column + .5 - a[major]) / (b[major] - a[major]);
        const double minor = a[!major] + share * (b[!major] - a[!major]),
                     off = minor - floor(minor);
        int count = 0;
        for (int row = 0; row < rows; row++) {
            const float *pixel = rgba + 4 * (major ? column * WIDTH + row : row * WIDTH + column);
            if (!is_color(pixel, color, clear))
                continue;
            count++;
            assert_true(row == (int)floor(minor) ||
                        (off < 1 / 16. && row == (int)floor(minor) - 1) ||
                        (off > 15 / 16. && row == (int)floor(minor) + 1));
        }
        assert_int_equal(count, 1);
    }
}

static void coverage(void **state)
{
    (void)state;
    float *rgba = draw(IMAGE "camera: { camera: Perspective, position: [3, -4, 2.5], angle: 40 }\n"
                             "tools: { axes: true, axesLength: 1.3 }\n",
                       &(RendererOptions){0});
    for (int i = 0; i < 3; i++) {
        double end[3] = {0}, at[2][2];
        end[i] = 1.3;
        project((double[]){0, 0, 0}, at[0]);
        project(end, at[1]);
        check_line(rgba, axes[i], at[0], at[1]);
    }
    free(rgba);
}

/* -- what is before it */

/* From the front, 40 pixels a unit: the z axis to 1.5, and a box from z = 0.5 to 1 before it. So is
 * another behind it, from 0.2 to 0.4. */
static void hidden(void **state)
{
    (void)state;
    float *rgba = draw(IMAGE "materials: { white: { material: Phong, diffuse: 0, emissive: 1 } }\n"
                             "camera: { camera: Orthographic, position: [0, -9, 0], size: 4 }\n"
                             "tools: { axes: true, axesLength: 1.5 }\n"
                             "objects:\n- { object: Box, size: [1, 0.2, 0.5], material: white, "
                             "transform: { translation: [0, -0.3, "
                             "0.75] } }\n"
                             "- { object: Box, size: [1, 0.2, 0.2], material: white, transform: { "
                             "translation: [0, 0.3, 0.3] } }\n",
                       &(RendererOptions){.edges = RENDERER_EDGES_coverage});
    for (int y = HEIGHT / 2 + 1; y < HEIGHT / 2 + 59; y++) {
        const double z = (y + .5 - HEIGHT / 2.) / 40;
        const bool box = z > .5 && z < 1;
        bool seen = false;
        for (int x = WIDTH / 2 - 1; x <= WIDTH / 2; x++)
            seen |= is_color(rgba + 4 * (y * WIDTH + x), axes[2], clear);
        assert_int_equal(seen, !box);
    }
    free(rgba);
}

/* A grid on an infinite plane, at a grazing angle, equals the grid without the plane, pixel by
 * pixel; also far from the origin, and orthographically. */
static void on_the_ground(void **state)
{
    (void)state;
    static const char *const cameras[] = {
        "{ camera: Perspective, position: [0.3, -7, 0.6], target: [0, 0, 0.3], angle: 50 }",
        "{ camera: Perspective, position: [2000, -7000, 900], target: [2000, -6990, 899.5], angle: "
        "50 }",
        "{ camera: Orthographic, position: [9, -40, 15], size: 8, depth: 200 }"};
    for (int k = 0; k < 3; k++) {
        float *rgba[2];
        int lines = 0;
        for (int i = 0; i < 2; i++) {
            char text[1024];
            snprintf(text, sizeof text,
                     IMAGE "materials: { ground: { material: Phong, diffuse: 0, emissive: [1, 0, "
                           "0] } }\ncamera: %s\n"
                           "tools: { grid: true, gridCells: 30, gridStep: %d }\nobjects: [%s]\n",
                     cameras[k], k == 1 ? 400 : 1, i ? "{ object: Plane, material: ground }" : "");
            rgba[i] = draw(text, &(RendererOptions){.fragment = i});
        }
        for (int p = 0; p < WIDTH * HEIGHT; p++) {
            const bool line = is_color(rgba[0] + 4 * p, grey, clear);
            lines += line;
            assert_int_equal(is_color(rgba[1] + 4 * p, grey, clear), line);
        }
        assert_true(lines > 500);
        free(rgba[0]);
        free(rgba[1]);
    }
}

/* Unlit panes of two transmittances in front of the axes, and one behind, which has no effect: a
 * line's color is multiplied by the product, for any tone mapping, transparency method and
 * entry. */
static void behind_glass(void **state)
{
    (void)state;
    static const double through[3] = {.5 * .9, .25 * .6, .75 * .8};
    static const struct {
        const char *tone;
        RendererOptions how;
    } cases[] = {{"Clamp", {.transparency = "lists"}},
                 {"Filmic, exposure: 5", {.transparency = "lists", .fragment = true}},
                 {"Drago", {.transparency = "peeling"}},
                 {"Clamp", {.transparency = "peeling", .fragment = true}}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char text[2048];
        int seen = 0;
        snprintf(
            text, sizeof text,
            IMAGE
            "materials:\n  a: { material: Phong, diffuse: 0, transparency: [0.5, 0.25, 0.75] }\n"
            "  b: { material: Phong, diffuse: 0, transparency: [0.9, 0.6, 0.8] }\n"
            "camera: { camera: Orthographic, position: [0, -9, 0], size: 4 }\n"
            "tools: { axes: true, axesLength: 1.5 }\ntoneMapping: { toneMapping: %s }\n"
            "sky: { material: RGBA, r: 1, g: 1, b: 1 }\n"
            "defs: { pane: { object: Parallelogram, u: [20, 0, 0], v: [0, 0, 20] } }\nobjects:\n"
            "- { object: Instance, of: pane, material: b, transform: { translation: [-10, -0.2, "
            "-10] } }\n"
            "- { object: Instance, of: pane, material: a, transform: { translation: [-10, -0.1, "
            "-10] } }\n"
            "- { object: Instance, of: pane, material: a, transform: { translation: [-10, 0.1, "
            "-10] } }\n",
            cases[k].tone);
        float *rgba = draw(text, &cases[k].how);
        for (int y = HEIGHT / 2 + 2; y < HEIGHT / 2 + 58; y++)
            for (int x = WIDTH / 2 - 1; x <= WIDTH / 2; x++)
                seen += is_color(rgba + 4 * (y * WIDTH + x), axes[2], through);
        assert_int_equal(seen, 56);
        free(rgba);
    }
}

/* -- lines of lights */

static void spot(void **state)
{
    (void)state;
    MatcOptions options = frame_exact_options();
    MatcDocument *document;
    ViewSpace space;
    ToolLines lines;
    Scene *scene = frame_scene("camera: { camera: Perspective, position: [0, -5, 0] }\ntools: { "
                               "lights: true, lightSize: 2 }\n"
                               "lights: [{ light: Ambient }, { light: Spot, position: [1, 2, 3], "
                               "direction: [1, 0, -1], outerAngle: 60 }]\n",
                               &options, &document);
    view_space_make(&scene->camera, (int[]){WIDTH, HEIGHT}, true, &space);
    assert_true(tool_lines_make(scene, &space, &lines));
    assert_int_equal(lines.count, 2 * (32 + 4));
    for (int i = 0; i < lines.count; i++) {
        const float *e = lines.vertices[i].point; /* right, up, back are x, z, -y */
        const double way[3] = {e[0] - 1, -5 - e[2] - 2, e[1] - 3};
        const double length = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
        assert_true(length < 1e-5 || fabs(length - 2) < 1e-5);
        assert_true(length < 1e-5 || fabs((way[0] - way[2]) / sqrt(2) / length - .5) < 1e-5);
    }
    tool_lines_free(&lines);
    frame_forget(scene, document);
}

/* -- what runs */

static void runs(void **state)
{
    (void)state;
    static const char *const texts[] = {IMAGE "objects: []\n", IMAGE "tools: { grid: true }\n"};
    MatcOptions options = frame_exact_options();
    for (int i = 0; i < 2; i++) {
        MatcDocument *document;
        Scene *scene = frame_scene(texts[i], &options, &document);
        GlContext *gl = frame_context();
        Renderer *renderer = renderer_open(gl, &(RendererOptions){.compile = &options});
        assert_true(renderer && renderer_set_scene(renderer, scene) && renderer_frame(renderer));
        char *graph = frame_graph(renderer);
        assert_int_equal(strstr(graph, "tools are asked for") != NULL, i);
        assert_int_equal(strstr(graph, "tools RGBA32F 16") != NULL, i);
        free(graph);
        frame_count_calls(gl);
        assert_true(renderer_frame(renderer));
        assert_int_equal(frame_calls.made + frame_calls.written, 0);
        renderer_close(renderer);
        gl_close(gl);
        frame_forget(scene, document);
    }
}

/* The camera moves: a frame is that of a new renderer. */
static void changed(void **state)
{
    (void)state;
    MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(IMAGE "tools: { grid: true, axes: true, lights: true }\nlights: [{ "
                                     "light: Point, position: [0, 1, 1] }]\n",
                               &options, &document);
    GlContext *gl = frame_context();
    const RendererOptions how = {.compile = &options};
    Renderer *renderer = renderer_open(gl, &how);
    float *moved = calloc(512 * 512, 4 * sizeof *moved);
    assert_true(renderer && moved && renderer_set_scene(renderer, scene) &&
                renderer_frame(renderer));
    scene->camera.position[0] = 1;
    scene->lights[0].position[2] = 2;
    assert_true(renderer_changed(renderer, RENDERER_CAMERA | RENDERER_LIGHTS) &&
                renderer_frame(renderer) && renderer_read(renderer, moved));
    renderer_close(renderer);
    float *whole = frame_floats(gl, scene, &how);
    assert_memory_equal(moved, whole, (size_t)WIDTH * HEIGHT * 4 * sizeof *whole);
    free(moved);
    free(whole);
    gl_close(gl);
    frame_forget(scene, document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coverage),     cmocka_unit_test(hidden), cmocka_unit_test(on_the_ground),
        cmocka_unit_test(behind_glass), cmocka_unit_test(spot),   cmocka_unit_test(runs),
        cmocka_unit_test(changed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
