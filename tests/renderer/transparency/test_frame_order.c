/* Transparent objects whose fragments go to lists are drawn far to near, for any camera; the
 * picture does not depend on the order. */
#include "tests/test.h"
#include "runtime/frame_graph/frame.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PANES = 21, LAYERS = 96, SIDE = 24, COMPONENTS = SIDE * SIDE * 4 };

/* Stacked panes in arbitrary order, three pairs of them at equal heights, seen from above; a box
 * among them. */
static int height_of(int pane) { return pane * 8 % PANES / 2 * 2 - pane * 8 % PANES / 16; }

static void write_scene(char *text, size_t capacity)
{
    size_t size = (size_t)snprintf(
        text, capacity,
        "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [0, 0, 60], "
        "up: [0, 1, 0], angle: "
        "40 }\n"
        "lights: [{ light: Point, position: [5, 5, 80], intensity: 4000, shadows: false "
        "}]\nmaterials:\n"
        "  clear: { material: Phong, diffuse: [.1, .2, .3], transparency: [.9, .7, .8] }\n"
        "objects:\n- { object: Box, size: [9, 9, 9], material: clear, transform: { translation: "
        "[0, 0, 5] } }\n",
        SIDE, SIDE);
    for (int i = 0; i < PANES; i++)
        size += (size_t)snprintf(
            text + size, capacity - size,
            "- { object: Parallelogram, u: [20, 0, %d], v: [0, 20, 0], material: clear, "
            "transform: { translation: [-10, -10, %d] } }\n",
            i % 5 == 4 ? 9 : 0, height_of(i));
}

/* Heights of each group's objects: greater ones are nearer, or farther. */
static void assert_order(const Renderer *renderer, bool from_above)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    int drawn = 0;
    assert_true(gpu_scene->instances);
    for (int i = gpu_scene->opaque_count; i < gpu_scene->surface_count; i++) {
        double before = from_above ? -INFINITY : INFINITY;
        for (int k = 0; k < gpu_scene->surfaces[i].seen; k++, drawn++) {
            const int object =
                gpu_scene->places[gpu_scene->list[gpu_scene->surfaces[i].first_seen + k]].object;
            const SceneObject *o = &renderer->scene->objects[object];
            const double height = o->world_from_local.m[14] +
                                  (o->kind == SCENE_Parallelogram ? o->numbers[2] / 2 : 0);
            assert_true(from_above ? height >= before : height <= before);
            before = height;
        }
    }
    assert_int_equal(drawn, PANES + 1);
}

static float *read_frame(GlContext *gl, Renderer *renderer)
{
    float *rgba = calloc(COMPONENTS, sizeof *rgba);
    if (!renderer_frame(renderer) || !renderer_read(renderer, rgba))
        fail_msg("%s", gl->error);
    return rgba;
}

static void farthest_first(void **state)
{
    (void)state;
    static char text[1 << 14];
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    GlContext *gl = frame_context();
    write_scene(text, sizeof text);
    Scene *scene = frame_scene(text, &options, &document);
    Renderer *lists = renderer_open(
        gl, &(RendererOptions){.compile = &options, .view = "light", .transparency = "lists"});
    if (!lists || !renderer_set_scene(lists, scene))
        fail_msg("%s", gl->error);
    for (int below = 0; below < 2; below++) {
        scene->camera.position[2] = below ? -60 : 60;
        scene->camera.back[2] = below ? -1 : 1;
        scene->camera.right[0] = below ? -1 : 1;
        assert_true(renderer_changed(lists, RENDERER_CAMERA));
        float *rgba = read_frame(gl, lists);
        assert_order(lists, !below);
        float *peeled = frame_floats(
            gl, scene,
            &(RendererOptions){.compile = &options, .view = "light", .transparency = "peeling"});
        for (int i = 0; i < COMPONENTS; i++)
            assert_true(fabsf(rgba[i] - peeled[i]) <= 2e-6f * fmaxf(1, fabsf(peeled[i])));
        free(rgba);
        free(peeled);
    }
    renderer_close(lists);
    gl_close(gl);
    frame_forget(scene, document);
}

/* Panes of two sizes, in turns, are two groups: a pixel's list then has two sorted runs of half
 * the length, whose fragments alternate. */
static void write_turns(char *text, size_t capacity)
{
    size_t size = (size_t)snprintf(
        text, capacity,
        "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [0, 0, 60], "
        "up: [0, 1, 0], angle: "
        "40 }\n"
        "lights: [{ light: Point, position: [5, 5, 80], intensity: 4000, shadows: false "
        "}]\nmaterials:\n"
        "  blue: { material: Phong, diffuse: [0, .2, .9], transparency: [.9, .93, .96] }\n"
        "  red: { material: Phong, diffuse: [.9, .1, 0], transparency: [.96, .93, .9] "
        "}\nobjects:\n",
        SIDE, SIDE);
    for (int i = 0; i < LAYERS; i++)
        size += (size_t)snprintf(
            text + size, capacity - size,
            "- { object: Parallelogram, u: [%d, 0, 0], v: [0, 40, 0], material: %s, "
            "transform: { translation: [-20, -20, %g] } }\n",
            40 + i % 2, i % 2 ? "red" : "blue", i * .25);
}

/* Lists that take every step of merging are put in the order that peeling finds. */
static void runs_in_turns(void **state)
{
    (void)state;
    static char text[1 << 15];
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    GlContext *gl = frame_context();
    write_turns(text, sizeof text);
    Scene *scene = frame_scene(text, &options, &document);
    float *pictures[2];
    for (int i = 0; i < 2; i++)
        pictures[i] = frame_floats(gl, scene,
                                   &(RendererOptions){.compile = &options,
                                                      .view = "light",
                                                      .transparency = i ? "peeling" : "lists"});
    for (int i = 0; i < COMPONENTS; i++)
        assert_true(fabsf(pictures[0][i] - pictures[1][i]) <=
                    4e-6f * fmaxf(1, fabsf(pictures[1][i])));
    free(pictures[0]);
    free(pictures[1]);
    gl_close(gl);
    frame_forget(scene, document);
}

/* Slanted panes whose centers lie in the opposite order of their fragments in a pixel. Each pane is
 * a run of its own, and all runs have to be sorted. The camera looks along y; pane i crosses the
 * line of sight at y = i / 10, and its center lies beside it at y = -i / 10. Every third pane
 * glows, which gives the sum a closed form. */
static void every_layer_is_a_run(void **state)
{
    (void)state;
    enum { RUNS = 48 };
    static char text[1 << 16];
    static const double passes[3] = {.9, .8, .95};
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    GlContext *gl = frame_context();
    char *to =
        text +
        sprintf(text,
                "image: { width: %d, height: %d }\ncamera: { camera: Orthographic, "
                "position: [0, -40, 0], target: [0, 0, 0], size: .2, depth: 100 }\nobjects:\n",
                SIDE, SIDE);
    for (int i = 0; i < RUNS; i++)
        to += sprintf(
            to,
            "- { object: Parallelogram, u: [30, 30, 0], v: [0, 0, 2], transform: { translation: "
            "[%g, %g, -1] }, material: { material: Phong, diffuse: 0, emissive: %d, "
            "transparency: [%g, %g, %g] } }\n",
            -15 - .2 * i, -15 - .1 * i, i % 3 == 0, passes[i % 3], passes[(i + 1) % 3],
            passes[(i + 2) % 3]);
    Scene *scene = frame_scene(text, &options, &document);
    float *lit = frame_floats(
        gl, scene,
        &(RendererOptions){.compile = &options, .view = "light", .transparency = "lists"});
    double left[3] = {1, 1, 1}, sum[3] = {0};
    for (int i = 0; i < RUNS; i++)
        for (int component = 0; component < 3; component++) {
            sum[component] += i % 3 == 0 ? left[component] : 0;
            left[component] *= passes[(i + component) % 3];
        }
    for (int i = 0; i < COMPONENTS; i++)
        if (i % 4 < 3)
            assert_true(fabs((double)lit[i] - sum[i % 4]) < .002 * sum[i % 4]);
    free(lit);
    gl_close(gl);
    frame_forget(scene, document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(farthest_first),
                                       cmocka_unit_test(runs_in_turns),
                                       cmocka_unit_test(every_layer_is_a_run)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
