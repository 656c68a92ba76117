/* Cascades of a directional light: their texels stay fixed in the world while the camera moves
 * and turns, and so do shadow boundaries in pictures. test_frame_cast.c checks the light in each
 * cascade. */
#include "runtime/tessellate/scene_solid.h"
#include "tests/test.h"
#include "runtime/renderer/passes.h"
#include "runtime/shadow/shadow_views.h"
#include "runtime/scene/scene_matrix.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CASCADES = 4, SIZE = 512 };

/* -- where maps lie */

static const int picture[2] = {160, 120};

/* The views of a scene of boxes. */
static ShadowViews views_of(const Scene *scene)
{
    GpuScenePlace places[2] = {{.object = 0, .mesh = 0}, {.object = 1, .mesh = 1}};
    CullBox boxes[2];
    for (int i = 0; i < 2; i++) {
        Shape shape;
        assert_true(scene_solid(&scene->objects[i], &shape));
        boxes[i] = cull_box(&shape);
        shape_free(&shape);
    }
    const GpuScene gpu_scene = {.places = places, .place_count = 2, .boxes = boxes};
    ShadowViews views;
    assert_true(shadow_views_make(shadow_methods, scene, &gpu_scene, picture, &views));
    assert_int_equal(views.count, CASCADES);
    return views;
}

/* Where a point lies on a map, in texels. */
static double texels_at(const ShadowView *view, int axis, const double point[3])
{
    const double *row = view->rows[axis];
    return (vec3_dot(row, point) + row[3]) * SIZE / 2;
}

static double width_of(const ShadowView *view, int axis)
{
    return 2 / sqrt(vec3_dot(view->rows[axis], view->rows[axis]));
}

/* The camera moves along its axes, and turns around the world's z. */
static void move(SceneCamera *camera, double along, double turn)
{
    double *axes[] = {camera->right, camera->up, camera->back};
    for (int i = 0; i < 3; i++)
        camera->position[i] +=
            along * (camera->right[i] + .3 * camera->up[i] - .7 * camera->back[i]);
    for (int k = 0; k < 3; k++) {
        const double x = axes[k][0], y = axes[k][1];
        axes[k][0] = cos(turn) * x - sin(turn) * y;
        axes[k][1] = sin(turn) * x + cos(turn) * y;
    }
}

/* Between consecutive frames no map moves by a fraction of a texel. Returns the number of maps
 * with another texel size. */
static int count_jumps(const ShadowViews *before, const ShadowViews *after)
{
    static const double points[3][3] = {{0, 0, 0}, {3, 20, 1}, {-40, 70, 0}};
    int jumps = 0;
    for (int i = 0; i < CASCADES; i++)
        for (int axis = 0; axis < 2; axis++) {
            const ShadowView *a = &before->views[i], *b = &after->views[i];
            const bool other =
                fabs(width_of(a, axis) - width_of(b, axis)) > 1e-9 * width_of(a, axis);
            jumps += other;
            for (int k = 0; !other && k < 3; k++) {
                const double shift = texels_at(b, axis, points[k]) - texels_at(a, axis, points[k]);
                assert_true(fabs(shift - round(shift)) < 1e-6);
            }
        }
    return jumps;
}

/* 400 frames, in which the camera walks ten units and turns by 29 degrees: of 3200 widths not one
 * in a hundred is another than in the frame before. */
static void texels_stand_still(void **state)
{
    (void)state;
    static const char text[] =
        "camera: { camera: Perspective, position: [1.5, -9, 3], target: [.3, 0, 1], angle: 42 }\n"
        "shadowMaps: { size: 512, cascades: 4 }\nlights: [{ light: Directional, direction: [.4, "
        ".5, -.8] }]\nobjects:\n"
        "- { object: Box, size: [200, 200, 1], material: { material: Phong }, transform: { "
        "translation: [0, 90, -.5] } "
        "}\n- { object: Box, size: [2, 2, 30], material: { material: Phong }, transform: { "
        "translation: [9, 60, 15] } "
        "}\n";
    MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(text, &options, &document);
    ShadowViews before = views_of(scene);
    int jumps = 0, moves = 0;
    for (int frame = 0; frame < 400; frame++) {
        move(&scene->camera, .02, .00125);
        ShadowViews after = views_of(scene);
        jumps += count_jumps(&before, &after);
        moves +=
            memcmp(before.views[0].rows, after.views[0].rows, sizeof before.views[0].rows) != 0;
        shadow_views_free(&before);
        before = after;
    }
    print_message("%d of %d widths are others, the first map has moved %d times\n", jumps, 400 * 8,
                  moves);
    assert_true(jumps < 32 && moves > 40);
    shadow_views_free(&before);
    frame_forget(scene, document);
}

/* -- pictures */

enum { WIDTH = 96, HEIGHT = 64, STEPS = 6 };

/* An orthographic camera moves by one pixel per frame, a tenth of a unit; texels of the first
 * map are .06. Each pixel must equal its neighbor of the previous frame, also at shadow
 * boundaries. */
static void shadows_stand_still(void **state)
{
    (void)state;
    static const char text[] =
        "image: { width: 96, height: 64 }\ncamera: { camera: Orthographic, position: [0, -20, 14], "
        "target: [0, 0, 0], "
        "size: 6.4, depth: 60 }\nshadowMaps: { size: 256, cascades: 3, filter: 0 }\n"
        "lights: [{ light: Directional, direction: [.4, .55, -.8] }]\nobjects:\n"
        "- { object: Box, size: [60, 60, 1], material: { material: Phong, diffuse: .8 }, "
        "transform: { translation: [0, "
        "20, -.5] } }\n"
        "- { object: Scatter, count: 60, seed: 3, size: [14, 12, 0], rotation: [.5, .5, 3], "
        "objects: [{ object: Box, "
        "size: [.6, .5, 2.5], material: { material: Phong, diffuse: .5 } }] }\n";
    MatcLayout *layout;
    const MatcOptions compile = frame_float_options(&layout);
    MatcDocument *document;
    Scene *scene = frame_scene(text, &compile, &document);
    SceneCamera *camera = &scene->camera;
    const double pixel = 2 * camera->half / HEIGHT;
    GlContext *gl = frame_context();
    float *before = NULL;
    int edges = 0, others = 0;
    for (int step = 0; step < STEPS; step++) {
        float *after =
            frame_floats(gl, scene, &(RendererOptions){.compile = &compile, .view = "light"});
        for (int i = 0; before && i < WIDTH * HEIGHT; i++)
            if (i % WIDTH + 1 < WIDTH) {
                edges += fabsf(before[4 * i + 4] - before[4 * i]) > .2f;
                others += fabsf(before[4 * i + 4] - after[4 * i]) > .01f;
            }
        free(before);
        before = after;
        for (int i = 0; i < 3; i++)
            camera->position[i] += pixel * camera->right[i];
    }
    print_message("%d pixels at ends of shadows and objects, %d are others when the camera moves\n",
                  edges, others);
    assert_true(edges > 1000 && others < edges / 100);
    free(before);
    gl_close(gl);
    frame_forget(scene, document);
    matc_layout_free(layout);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(texels_stand_still),
                                       cmocka_unit_test(shadows_stand_still)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
