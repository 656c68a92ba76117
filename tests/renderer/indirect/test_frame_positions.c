/* The view of the depth buffer as a mesh, seen from the side, against rays in double: its gray
 * pixels are surfaces that the picture's own camera also sees, from the same side. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/reference_ray.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 160, HEIGHT = 120, PIXELS = WIDTH * HEIGHT, TEXT = 2048 };

static const char body[] =
    "image: { width: 160, height: 120 }\nmaterials: { m: { material: Phong } }\nobjects:\n"
    "- { object: Box, material: m, size: [4, 4, .2], transform: { translation: [0, 0, -.1] } }\n"
    "- { object: Box, material: m, size: [1, .8, 1.2], transform: { translation: [-.5, .4, .6], "
    "rotation: [0, 0, .4] } }\n"
    "- { object: Box, material: m, size: [.6, .6, .7], transform: { translation: [.8, -.6, .35] } "
    "}\n";

/* The box around all objects: the lower one's sides, the taller one's top. */
static const double middle[3] = {0, 0, .5};

/* Rotates around the middle, by an angle around an axis of the camera. */
static void turn(const double axis[3], double angle, const double about[3], double v[3])
{
    double w[3], cross[3], dot = 0;
    for (int k = 0; k < 3; k++) {
        w[k] = v[k] - about[k];
        dot += axis[k] * w[k];
    }
    for (int k = 0; k < 3; k++)
        cross[k] = axis[(k + 1) % 3] * w[(k + 2) % 3] - axis[(k + 2) % 3] * w[(k + 1) % 3];
    for (int k = 0; k < 3; k++)
        v[k] =
            about[k] + cos(angle) * w[k] + sin(angle) * cross[k] + (1 - cos(angle)) * dot * axis[k];
}

static void go_around(SceneCamera *camera, bool up, double degrees)
{
    static const double none[3];
    double axis[3];
    const double angle = degrees * PI / 180;
    memcpy(axis, up ? camera->right : camera->up, sizeof axis);
    turn(axis, angle, middle, camera->position);
    turn(axis, angle, none, camera->right);
    turn(axis, angle, none, camera->up);
    turn(axis, angle, none, camera->back);
}

/* True if a point is in the picture and not hidden. */
static bool is_known(const Tracer *tracer, const SceneCamera *camera, const Hit *hit)
{
    double way[3], components[3] = {0}, from[3];
    const double *const axes[3] = {camera->right, camera->up, camera->back};
    for (int k = 0; k < 3; k++)
        way[k] = hit->world[k] - camera->position[k];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            components[i] += axes[i][k] * way[k];
    const bool flat = camera->kind == SCENE_Orthographic;
    const double scale = HEIGHT / (2 * camera->half * (flat ? 1 : -components[2]));
    const double x = components[0] * scale + WIDTH / 2., y = components[1] * scale + HEIGHT / 2.;
    for (int k = 0; k < 3; k++) {
        way[k] = flat ? -9 * camera->back[k] : way[k];
        from[k] = hit->world[k] - (flat ? way[k] : 0);
        from[k] = flat ? from[k] : camera->position[k];
    }
    return x > 0 && x < WIDTH && y > 0 && y < HEIGHT &&
           !reference_is_blocked(tracer, from, way, 1 - 1e-4);
}

/* True if the hit shows the side that faces the picture's camera. */
static bool is_turned(const SceneCamera *camera, const Hit *hit, const Ray *ray)
{
    const bool flat = camera->kind == SCENE_Orthographic;
    double sides[2] = {0};
    for (int k = 0; k < 3; k++) {
        sides[0] +=
            hit->microfacet[k] * (flat ? camera->back[k] : camera->position[k] - hit->world[k]);
        sides[1] -= hit->microfacet[k] * ray->way[k];
    }
    return sides[0] * sides[1] > 0;
}

/* True if a visible point is anywhere along the ray: surfaces before it show their backs, or are
 * unknown. */
static bool meets_known(const Tracer *tracer, const SceneCamera *camera, const Ray *ray)
{
    double behind = 0;
    for (int i = 0; i < 16; i++) {
        const Hit hit = reference_hit(tracer, ray, behind);
        if (!isfinite(hit.distance))
            return false;
        if (is_turned(camera, &hit, ray) && is_known(tracer, camera, &hit))
            return true;
        behind = hit.distance + 1e-6;
    }
    return false;
}

enum { NOTHING, KNOWN, BETWEEN };
static int shown(const float rgba[4])
{
    return rgba[3] == 0 ? NOTHING : rgba[2] > 1.5f * rgba[0] ? BETWEEN : KNOWN;
}

/* True if all neighbors within two pixels agree: the depth buffer's mesh ends at pixels'
 * centers. */
static bool is_within(const int *truth, int p)
{
    for (int k = 0; k < 25; k++)
        if (truth[p + (k / 5 - 2) * WIDTH + k % 5 - 2] != truth[p])
            return false;
    return true;
}

static void points_are_the_scenes(void **state)
{
    (void)state;
    static const struct {
        const char *camera, *view;
        bool up;
        double degrees;
    } cases[] = {{"Perspective, position: [0, -6, 2.5], target: [0, 0, .5], angle: 40", "positions",
                  false, 60},
                 {"Perspective, position: [0, -6, 2.5], target: [0, 0, .5], angle: 40",
                  "positions1", true, -60},
                 {"Perspective, position: [0, -6, 2.5], target: [0, 0, .5], angle: 40",
                  "positions2", false, -60},
                 {"Orthographic, position: [0, -6, 2.5], target: [0, 0, .5], size: 4", "positions",
                  false, 60}};
    static int truth[PIXELS];
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[TEXT];
        MatcDocument *document;
        snprintf(text, sizeof text, "camera: { camera: %s }\n%s", cases[i].camera, body);
        Scene *scene = frame_scene(text, &options, &document);
        float *rgba = frame_floats(
            gl, scene,
            &(RendererOptions){.compile = &options, .view = cases[i].view, .memory = 100000});
        const SceneCamera own = scene->camera;
        Tracer tracer = reference_open(scene);
        int counts[3] = {0}, wrong[2] = {0};
        go_around(&scene->camera, cases[i].up, cases[i].degrees);
        for (int p = 0; p < PIXELS; p++) {
            const Ray ray = reference_ray(scene, p % WIDTH + .5, p / WIDTH + .5);
            truth[p] = meets_known(&tracer, &own, &ray) ? KNOWN : NOTHING;
        }
        for (int p = 2 * WIDTH + 2; p < PIXELS - 2 * WIDTH - 2; p++) {
            const int is = shown(rgba + 4 * p);
            counts[is]++;
            wrong[0] += is_within(truth, p) && is == KNOWN && truth[p] != KNOWN;
            wrong[1] += is_within(truth, p) && is == NOTHING && truth[p] == KNOWN;
        }
        print_message(
            "%s: %d pixels of known points, of which %d are wrong; %d between, %d are missing\n",
            cases[i].view, counts[KNOWN], wrong[0], counts[BETWEEN], wrong[1]);
        assert_true(counts[KNOWN] > PIXELS / 12 && counts[BETWEEN] > 100);
        assert_true(wrong[0] <= counts[KNOWN] / 100 && wrong[1] <= counts[KNOWN] / 100);
        reference_close(&tracer);
        free(rgba);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(points_are_the_scenes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
