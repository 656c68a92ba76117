/* Bisection by compute stages, under OSMesa: its triangles against CPU bisection by the same
 * error bound, in double; the set is independent of the camera's path; shared edges are equal
 * bit for bit, from 64 cameras; buffers that are too small; pictures against those of fine
 * meshes, and shadows of casters outside the view. */
/* ctest: unsanitized seconds=17 */
#include "tests/frame/bisection_body.h"
#include "tests/frame_reference/bisection_reference.h"
#include "tests/frame/frame_compare.h"
#include "tests/frame/frame_draw.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = BISECTION_BODY_EDGE, PIXELS = EDGE * EDGE };

/* Rounding decides triangles at the edge of the criterion: a few of thousands. */
static void triangles_are_those_of_the_processor(void **state)
{
    static const struct {
        int body, triangles;
        double distance, pixels;
        double lamp[3];     /* a point; of no length: far away */
        double edges[2][3]; /* of an Area whose corner that is */
    } rows[] = {{0, 9000, 3, 1.5, {0}, {{0}}},
                {0, 9000, 2.2, 2, {0}, {{0}}},
                {1, 9000, 1.5, .6, {0}, {{0}}},
                {1, 4000, 6, .2, {0}, {{0}}},
                {0, 9000, 3, 2, {2.5, 2, 1.7}, {{0}}},
                {1, 9000, 1.5, .8, {-1, 1.5, 1}, {{0}}},
                {0, 9000, 3, 2, {2.5, 2, 1.7}, {{-1, .3, 0}, {.2, .7, .5}}},
                {1, 9000, 1.5, .8, {-2.2, 1.5, 1}, {{0, -2, .5}, {.3, 0, -1}}}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char how[80];
        int counts[2];
        snprintf(how, sizeof how, "pixels: %g, triangles: %d", rows[i].pixels, rows[i].triangles);
        BisectionBody b = bisection_body_begin(*state, how, bisection_bodies[rows[i].body]);
        bisection_body_look(&b.scene->camera, 1, 8, rows[i].distance);
        if (vec3_dot(rows[i].lamp, rows[i].lamp) > 0) {
            SceneLight *lamp = &b.scene->lights[0];
            lamp->kind =
                vec3_dot(rows[i].edges[0], rows[i].edges[0]) > 0 ? SCENE_Area : SCENE_Point;
            memcpy(lamp->position, rows[i].lamp, sizeof rows[i].lamp);
            memcpy(lamp->edges, rows[i].edges, sizeof rows[i].edges);
        }
        uint64_t *found = bisection_body_leaves(&b, &counts[0]),
                 *wanted = bisection_reference(
                     &(BisectionReference){b.scene, &b.options, b.mesh.body != SHAPE_BODY_none},
                     &counts[1]);
        bisection_body_sort(wanted, counts[1]);
        const int apart = bisection_body_others(found, counts[0], wanted, counts[1]);
        print_message("%zu: %d triangles, %d by the processor; %d in one of both alone\n", i,
                      counts[0], counts[1], apart);
        assert_true(counts[0] > 200 && apart <= 2 + counts[0] / 100);
        assert_true(displaced_bisection_cost(&b.displaced).pixels == rows[i].pixels);
        free(found);
        free(wanted);
        bisection_body_end(&b);
    }
}

/* Checks that the leaves cover each base exactly once. */
static void assert_whole(const uint64_t *leaves, int count, int bases)
{
    double area = 0;
    for (int i = 0; i < count; i++)
        area += ldexp(1, __builtin_clz((uint32_t)leaves[i]) - 31);
    assert_true(area == bases);
}

/* From near to far and back, around, and with too small buffers: the result equals that of a
 * mesh without history. */
static void the_way_does_not_matter(void **state)
{
    static const double distances[] = {8, 1.4, 30, 1.1, 2, 1.2, 1.25, 1.3};
    for (int body = 0; body < BISECTION_BODIES; body += 2) {
        BisectionBody b = bisection_body_begin(
            *state, body == 2 ? "pixels: 0.5, triangles: 1500" : "pixels: 2, triangles: 4000",
            bisection_bodies[body]);
        SceneCamera views[8];
        uint64_t *leaves[8];
        int counts[8], splits = 0, merges = 0, fewer = 0;
        for (int i = 0; i < 8; i++) {
            bisection_body_look(&b.scene->camera, i < 5 ? i : 4, 8, distances[i]);
            views[i] = b.scene->camera;
            leaves[i] = bisection_body_leaves(&b, &counts[i]);
            const DisplacedBisectionCost cost = displaced_bisection_cost(&b.displaced);
            splits += cost.splits;
            merges += cost.merges;
            fewer += cost.pixels > b.displaced.patches->pixels;
            assert_int_equal(cost.leaves, counts[i]);
            /* few places are free */
            assert_true(b.mesh.index_count / 3 <= counts[i] + counts[i] / 32);
            if (3 * counts[i] >= b.displaced.patches->triangles)
                assert_true(cost.kept <= 8 * (size_t)counts[i]);
            assert_whole(leaves[i], counts[i], b.displaced.patches->count);
            assert_true(counts[i] <= b.displaced.patches->triangles);
        }
        print_message("body %d: %d edges bisected, %d merged; %d views with more triangles than "
                      "there may be\n",
                      body, splits, merges, fewer);
        assert_true(splits > 100 && merges > 100);
        for (int i = 0; i < 8; i++) {
            int count;
            bisection_body_fresh(&b);
            b.scene->camera = views[i];
            uint64_t *fresh = bisection_body_leaves(&b, &count);
            assert_int_equal(bisection_body_others(fresh, count, leaves[i], counts[i]), 0);
            free(fresh);
            free(leaves[i]);
        }
        bisection_body_end(&b);
    }
}

/* Hash table entries are distinguished from those of 255 evaluations ago. */
static void old_looks_are_forgotten(void **state)
{
    BisectionBody b =
        bisection_body_begin(*state, "pixels: 12, triangles: 1500", bisection_bodies[2]);
    int count = 0, fresh_count = 0;
    for (int view = 0; view < 260; view++) {
        bisection_body_look(&b.scene->camera, view % 7, 8, view % 2 ? 1.6 : 5);
        free(bisection_body_leaves(&b, &count));
    }
    uint64_t *leaves = bisection_body_leaves(&b, &count);
    bisection_body_fresh(&b);
    uint64_t *fresh = bisection_body_leaves(&b, &fresh_count);
    assert_true(count > 12 && !bisection_body_others(fresh, fresh_count, leaves, count));
    free(fresh), free(leaves);
    bisection_body_end(&b);
}

/* 64 cameras, near and far, one after the other on the same mesh, of bisection_bodies with hard
 * edges, seams and poles. */
static void each_side_has_another(void **state)
{
    static const double distances[] = {1.1, 1.7, 2.2, 20};
    long triangles = 0;
    for (int body = 1; body < BISECTION_BODIES; body++) {
        BisectionBody b =
            bisection_body_begin(*state, "pixels: 3, triangles: 2000", bisection_bodies[body]);
        for (int view = 0; view < 16; view++) {
            Shape shape;
            int count;
            bisection_body_look(&b.scene->camera, view, 16, distances[view % 4]);
            free(bisection_body_leaves(&b, &count));
            assert_true(displaced_read(&b.displaced, &b.mesh, &shape));
            assert_int_equal(shape.index_count, 3 * count);
            if (shape_body(&shape) == SHAPE_BODY_none)
                fail_msg("body %d, view %d: open edges", body, view);
            triangles += count;
            shape_free(&shape);
        }
        bisection_body_end(&b);
    }
    print_message("%ld triangles\n", triangles);
    assert_true(triangles > 20000);
}

/* Number of pixels that differ by more than a fiftieth. */
static int differing(const float *a, const float *b)
{
    int count = 0;
    for (int i = 0; i < PIXELS; i++)
        count += fabsf(a[4 * i] - b[4 * i]) > .02f;
    return count;
}

/* By the whole renderer, with exact shadows, which read the triangles; the camera moves away,
 * and back. */
static void pictures_are_those_of_meshes(void **state)
{
    const MatcOptions options = frame_exact_options();
    const BisectionBodies *with = *state;
    char text[4000];
    float *light[4];
    static const char *const how[] = {"method: mesh, level: 48",
                                      "method: bisection, pixels: 0.15, triangles: 60000",
                                      "method: mesh, level: 2", "method: mesh, level: 32"};
    for (int k = 0; k < 4; k++) {
        MatcDocument *document;
        snprintf(text, sizeof text,
                 "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [1, "
                 "-3, 2], angle: 40 }\n%s"
                 "displacement: { %s }\nlights: [{ light: Directional, direction: [1, 0.6, -1], "
                 "shadows: exact "
                 "}]\nobjects:\n%s",
                 EDGE, EDGE, bisection_body_materials, how[k], bisection_bodies[2]);
        Scene *scene = frame_scene(text, &options, &document);
        const RendererOptions draw = {.compile = &options, .view = "light"};
        Renderer *renderer = renderer_open(with->gl, &draw);
        light[k] = malloc(4 * PIXELS * sizeof *light[k]);
        assert_true(renderer && renderer_set_scene(renderer, scene) && renderer_frame(renderer));
        if (k == 1) {
            const SceneCamera camera = scene->camera;
            bisection_body_look(&scene->camera, 3, 8, 1.5);
            assert_true(renderer_changed(renderer, RENDERER_CAMERA) && renderer_frame(renderer));
            scene->camera = camera;
            assert_true(renderer_changed(renderer, RENDERER_CAMERA) && renderer_frame(renderer));
        }
        assert_true(renderer_read(renderer, light[k]));
        renderer_close(renderer);
        frame_forget(scene, document);
    }
    const int off = differing(light[0], light[1]), coarse = differing(light[0], light[2]),
              other = differing(light[0], light[3]);
    print_message("%d of %d pixels differ; %d of a fine mesh, %d of a coarse one\n", off, PIXELS,
                  other, coarse);
    assert_true(off < 2 * other && coarse > 3 * off);
    for (int k = 0; k < 4; k++)
        free(light[k]);
}

/* The camera sees a floor and only the shadow of a displaced mesh: the shadow equals that of a
 * fine mesh, though a triangle outside the view counts as eight times as far; also with a lamp
 * that comes near. */
static void shadows_are_those_of_meshes(void **state)
{
    const MatcOptions options = frame_exact_options();
    const BisectionBodies *with = *state;
    static const char *const how[] = {"method: mesh, level: 24",
                                      "method: bisection, pixels: 0.2, triangles: 30000",
                                      "method: bisection, pixels: 1.6, triangles: 30000"};
    float *light[6]; /* of three meshes, by a lamp that is far away and one that is near */
    for (int k = 0; k < 3; k++) {
        MatcDocument *document;
        char text[4000];
        snprintf(text, sizeof text,
                 "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [4, "
                 "-3, -1], target: [4, "
                 "0, -4], angle: 30 }\n%s  floor: { material: Phong, diffuse: 1 }\n"
                 "displacement: { %s }\nlights: [{ light: Point, position: [-40, 0, 40], "
                 "intensity: 50000, shadows: "
                 "exact }]\nobjects:\n%s- { object: Parallelogram, u: [20, 0, 0], v: [0, 20, 0], "
                 "material: floor, "
                 "transform: { translation: [-10, -10, -4] } }\n",
                 EDGE, EDGE, bisection_body_materials, how[k], bisection_bodies[1]);
        Scene *scene = frame_scene(text, &options, &document);
        Renderer *renderer =
            renderer_open(with->gl, &(RendererOptions){.compile = &options, .view = "light"});
        assert_true(renderer && renderer_set_scene(renderer, scene) && renderer_frame(renderer));
        for (int near = 0; near < 2; near++) {
            if (near) {
                scene->lights[0].position[0] = -4;
                scene->lights[0].position[2] = 4;
                assert_true(renderer_changed(renderer, RENDERER_LIGHTS) &&
                            renderer_frame(renderer));
            }
            light[3 * near + k] = malloc(4 * PIXELS * sizeof **light);
            assert_true(renderer_read(renderer, light[3 * near + k]));
        }
        renderer_close(renderer);
        frame_forget(scene, document);
    }
    for (int near = 0; near < 2; near++) {
        int dark = 0;
        for (int i = 0; i < PIXELS; i++)
            dark += light[3 * near][4 * i] < .02f;
        const int off = differing(light[3 * near], light[3 * near + 1]),
                  coarse = differing(light[3 * near], light[3 * near + 2]);
        print_message(
            "%d pixels of a shadow; %d differ, %d where triangles are an eighth as fine\n", dark,
            off, coarse);
        assert_true(dark > PIXELS / 16 && off < 10 && coarse > 2 * off);
    }
    for (int i = 0; i < 6; i++)
        free(light[i]);
}

/* A driver without the features uses bisection on the CPU. */
static void others_get_meshes(void **state)
{
    const MatcOptions options = frame_exact_options();
    const BisectionBodies *with = *state;
    MatcDocument *document;
    PFNGLDISPATCHCOMPUTEINDIRECTPROC had = with->gl->DispatchComputeIndirect;
    Scene *scene = bisection_body_scene("pixels: 1, triangles: 3000", bisection_bodies[2], &options,
                                        &document);
    with->gl->DispatchComputeIndirect = NULL;
    free(frame_floats(with->gl, scene, &(RendererOptions){.compile = &options, .view = "light"}));
    const SceneMesh *mesh = &scene->meshes[scene->objects[0].mesh];
    with->gl->DispatchComputeIndirect = had;
    assert_true(!mesh->patches && mesh->shape.index_count > 3 * 200 &&
                shape_body(&mesh->shape) != SHAPE_BODY_none);
    frame_forget(scene, document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(triangles_are_those_of_the_processor),
        cmocka_unit_test(the_way_does_not_matter),
        cmocka_unit_test(old_looks_are_forgotten),
        cmocka_unit_test(each_side_has_another),
        cmocka_unit_test(pictures_are_those_of_meshes),
        cmocka_unit_test(shadows_are_those_of_meshes),
        cmocka_unit_test(others_get_meshes),
    };
    return cmocka_run_group_tests(tests, bisection_bodies_open, bisection_bodies_close);
}
