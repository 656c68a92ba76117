/* View-dependent bisection: a length in pixels by closed forms; and for a terrain, the distance
 * of its triangles from the material's surface in the picture, projected here by the camera's
 * own numbers. */
#include "runtime/tessellate/scene_displace.h"
#include "tests/test.h"
#include "tests/scene_whole.h"
#include "runtime/scene/scene_seen.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void lengths_have_pixels(void **state)
{
    (void)state;
    static const struct {
        const char *camera;
        double at[3], pixels;
    } rows[] = {
        {"{ camera: Perspective, position: [0, 0, 0], target: [0, 1, 0], angle: 90 }",
         {0, 10, 0},
         30},
        {"{ camera: Perspective, position: [0, 0, 0], target: [0, 1, 0], angle: 90 }",
         {3, 4, 0},
         60},
        {"{ camera: Perspective, position: [0, 0, 0], target: [0, 1, 0], angle: 90 }",
         {0, -10, 0},
         30. / 8},
        {"{ camera: Perspective, position: [0, 0, 0], target: [0, 1, 0], angle: 90 }",
         {0, 6, 8},
         30. / 8},
        {"{ camera: Perspective, position: [0, 0, 0], target: [0, 1, 0], angle: 90 }",
         {12, 5, 0},
         300. / 13 / 8},
        {"{ camera: Orthographic, position: [0, 0, 0], target: [0, 1, 0], size: 4 }",
         {1, 90, 0},
         150},
        {"{ camera: Orthographic, position: [0, 0, 0], target: [0, 1, 0], size: 4 }",
         {0, 1, 9},
         150. / 8},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[500];
        MatcDocument *document;
        SceneViewSet seen;
        snprintf(text, sizeof text, "image: { width: 900, height: 600 }\ncamera: %s\nobjects: []\n",
                 rows[i].camera);
        Scene *scene = read_scene(text, &document);
        scene_seen_find(scene, &seen);
        const double pixels = scene_seen_pixels(&seen, rows[i].at);
        if (fabs(pixels / rows[i].pixels - 1) > 1e-9)
            fail_msg("row %zu: %g pixels, not %g", i, pixels, rows[i].pixels);
        forget(scene, document);
    }
}

/* In a motion the frame in which the point is largest counts. */
static void the_nearest_frame_counts(void **state)
{
    (void)state;
    static const char text[] =
        "image: { width: 600, height: 600 }\ncamera: { camera: Perspective, position: [0, -10, 0], "
        "angle: 90 }\n"
        "motion: { motion: Path, frames: 5, keys: [{ time: 0, position: [0, -10, 0], target: [0, "
        "0, 0] }, "
        "{ time: 1, position: [0, -2, 0], target: [0, 0, 0] }] }\nobjects: []\n";
    MatcDocument *document;
    SceneViewSet seen;
    SceneCamera last;
    Scene *scene = read_scene(text, &document);
    scene_seen_find(scene, &seen);
    assert_int_equal(seen.count, 5);
    assert_true(scene_motion_camera(scene, 4, 5, &last));
    const double distance = sqrt(vec3_dot(last.position, last.position));
    assert_true(fabs(scene_seen_pixels(&seen, (double[]){0, 0, 0}) * distance / 300 - 1) < 1e-9);
    forget(scene, document);
}

/* Position of a point in the picture; false if outside. */
static bool project(const Scene *scene, const double at[3], double pixel[2])
{
    const SceneCamera *c = &scene->camera;
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = at[i] - c->position[i];
    const double depth = -vec3_dot(way, c->back),
                 unit = fmin(scene->width, scene->height) / 2 / (c->half * depth);
    pixel[0] = scene->width / 2. + vec3_dot(way, c->right) * unit;
    pixel[1] = scene->height / 2. + vec3_dot(way, c->up) * unit;
    return depth > 0 && pixel[0] >= 0 && pixel[1] >= 0 && pixel[0] <= scene->width &&
           pixel[1] <= scene->height;
}

typedef struct {
    double square;
    int count, over; /* visible points; those with more than twice the allowed error */
    int triangles[2];
} Found;

/* A point of each triangle, off its middle: where the triangle has it, and where the material
 * has. */
static void look(const Scene *scene, double pixels, Found *f)
{
    const MatcOptions by = options();
    const Shape *shape = &scene->meshes[scene->objects[0].mesh].shape;
    const double share[3] = {.51, .28, .21};
    for (int i = 0; i < shape->index_count; i += 3) {
        MatcPoint point = {.normal = {0, 0, 1}, .tangent_u = {60, 0, 0}, .tangent_v = {0, 60, 0}};
        double has[3] = {0}, pixel[2][2];
        for (int k = 0; k < 3; k++)
            for (int component = 0; component < 3; component++) {
                const uint32_t vertex = shape->indices[i + k];
                has[component] += share[k] * shape->vertices[vertex].position[component];
                point.position[component] += share[k] * shape->base[vertex][component];
            }
        memcpy(point.local, point.position, sizeof point.local);
        for (int component = 0; component < 2; component++) { /* the object's place */
            has[component] -= 30;
            point.position[component] -= 30;
        }
        f->triangles[has[1] < -6]++;
        assert_true(
            matc_move(scene->materials[0].document, scene->materials[0].index, &by, &point, 1));
        if (!project(scene, point.position, pixel[0]) || !project(scene, has, pixel[1]))
            continue;
        const double off = hypot(pixel[0][0] - pixel[1][0], pixel[0][1] - pixel[1][1]);
        f->square += off * off;
        f->count++;
        f->over += off > 2 * pixels;
    }
}

static void errors_are_below_pixels(void **state)
{
    (void)state;
    static const double pixels[] = {4, 1};
    for (int i = 0; i < 2; i++) {
        char text[1000];
        MatcDocument *document;
        Found f = {0};
        snprintf(text, sizeof text,
                 "image: { width: 300, height: 200 }\ncamera: { camera: Perspective, position: [0, "
                 "-6, 1.2], target: [0, 0, 0.3], angle: 50 }\n"
                 "displacement: { method: bisection, pixels: %g, triangles: 400000 }\n"
                 "materials: { m: { material: Phong, displacement: { map: VolumeTurbulence, size: "
                 "0.7, octaves: 5, noiseRatio: 0.45 } } }\n"
                 "objects:\n- { object: Parallelogram, u: [60, 0, 0], v: [0, 60, 0], material: m, "
                 "transform: { translation: [-30, -30, 0] } }\n",
                 pixels[i]);
        Scene *scene = read_scene(text, &document);
        assert_true(scene_displace_patches(scene)); /* as for a driver that cannot bisect */
        look(scene, pixels[i], &f);
        const double root = sqrt(f.square / f.count);
        print_message("%g pixels: %d triangles before the camera, %d behind, which is two fifths "
                      "of the square; off by %.2f, %d of %d by more than twice that\n",
                      pixels[i], f.triangles[0], f.triangles[1], root, f.over, f.count);
        assert_true(scene->meshes[scene->objects[0].mesh].shape.index_count / 3 < 400000);
        assert_true(root < pixels[i] && root > .2 * pixels[i] && f.over < .02 * f.count);
        assert_true(f.triangles[0] > 5 * f.triangles[1]);
        forget(scene, document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lengths_have_pixels),
        cmocka_unit_test(the_nearest_frame_counts),
        cmocka_unit_test(errors_are_below_pixels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
