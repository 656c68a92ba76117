/* The ray-traced reference of indirect light against closed forms: walls, balls, a lamp's form
 * factor, two bounces between planes; weights by distance. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/open_ray.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdio.h>

#define HEAD                                                                                       \
    "image: { width: 16, height: 16 }\ncamera: { camera: Perspective, position: [0, 0, 5], "       \
    "target: [0, 0, 0], up: "                                                                      \
    "[0, 1, 0] }\nmaterials: { m: { material: Phong, diffuse: .5, specular: 0 }, e: { material: "  \
    "Phong, diffuse: 0, "                                                                          \
    "specular: 0, "                                                                                \
    "emissive: [.8, .4, .2] } }\nobjects:\n"
#define FLOOR "- { object: Plane, material: m }\n"

/* Result for a ray from above to the origin. */
static Open open_at_origin(const char *objects, OpenRays rays, bool light)
{
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    char text[2048];
    snprintf(text, sizeof text, HEAD "%s", objects);
    Scene *scene = frame_scene(text, &options, &document);
    Tracer tracer = reference_open(scene);
    const Ray ray = {{0, 0, .001}, {0, 0, -1}};
    const Hit hit = reference_hit(&tracer, &ray, 0);
    assert_true(hit.object >= 0 && fabs(hit.world[2]) < 1e-9);
    const Open open = open_ray(&tracer, &hit, &rays, light ? &options : NULL);
    reference_close(&tracer);
    frame_forget(scene, document);
    return open;
}

static void nothing_and_all(void **state)
{
    (void)state;
    const Open free = open_at_origin(FLOOR, (OpenRays){.across = 16, .radius = INFINITY}, false);
    assert_true(fabs(free.open - 1) < 1e-9 && free.way[2] > .999);
    const Open shut = open_at_origin(FLOOR "- { object: Sphere, radius: 2, material: m }\n",
                                     (OpenRays){.across = 16, .radius = INFINITY}, false);
    assert_true(shut.open < 1e-9);
}

/* A ball leaves 1 - sin^2 of half its angular size, cosine-weighted; for uniform directions 1
 * minus its solid angle over 2 pi. */
static void a_ball(void **state)
{
    (void)state;
    static const struct {
        double at[3], radius;
    } balls[] = {{{0, 0, 2}, 1}, {{1, 0, 2}, .7}, {{1, 2, 1.5}, 1}};
    for (int i = 0; i < 3; i++) {
        char objects[512];
        const double *p = balls[i].at, r = balls[i].radius,
                     d = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        snprintf(objects, sizeof objects,
                 FLOOR "- { object: Sphere, radius: %g, detail: 200, material: m, transform: { "
                       "translation: [%g, %g, %g] } }\n",
                 r, p[0], p[1], p[2]);
        const double cosine =
            open_at_origin(objects, (OpenRays){.across = 64, .radius = INFINITY}, false).open;
        const double even =
            open_at_origin(objects, (OpenRays){.across = 64, .radius = INFINITY, .uniform = true},
                           false)
                .open;
        assert_true(fabs(cosine - (1 - r * r / d / d * p[2] / d)) < 3e-3);
        assert_true(fabs(even - sqrt(1 - r * r / d / d)) < 3e-3);
    }
}

/* An infinite wall of height h at x = 1 leaves 1/2 (1 + 1 / sqrt(1 + h^2)) of the cosine. With a
 * radius and weights: numerical integrals over the directions that hit it. */
static void a_wall(void **state)
{
    (void)state;
    static const double heights[] = {.5, 1, 3};
    for (int i = 0; i < 3; i++) {
        char objects[512];
        const double h = heights[i], radius = 2;
        snprintf(
            objects, sizeof objects,
            FLOOR
            "- { object: Parallelogram, material: m, u: [0, 2e4, 0], v: [0, 0, %g], transform: { "
            "translation: [1, -1e4, 0] } }\n",
            h);
        const double open =
            open_at_origin(objects, (OpenRays){.across = 64, .radius = INFINITY}, false).open;
        assert_true(fabs(open - (1 + 1 / sqrt(1 + h * h)) / 2) < 3e-3);
        for (int power = 0; power < 3; power++) {
            enum { STEPS = 1000 };
            double off = 0; /* of cosine / pi over z = sin a and the angle to the wall */
            for (int k = 0; k < STEPS * STEPS; k++) {
                const double turn = ((k % STEPS + .5) / STEPS - .5) * PI,
                             square = (k / STEPS + .5) / STEPS;
                const double r = sqrt(square), z = sqrt(1 - square), t = 1 / (r * cos(turn));
                if (t <= radius && t * z <= h)
                    off += (1 - (power ? pow(t / radius, power) : 0)) / STEPS / STEPS / 2;
            }
            const OpenRays rays = {.across = 64, .radius = radius, .power = power};
            assert_true(fabs(open_at_origin(objects, rays, false).open - (1 - off)) < 3e-3);
        }
    }
}

/* An emissive surface sends its light times its cosine-weighted share of the hemisphere. */
static void a_lamp(void **state)
{
    (void)state;
    static const double corners[4][3] = {
        {-.5, .2, 1}, {.5, .2, 1}, {.5, 1.2, 1.5}, {-.5, 1.2, 1.5}};
    /* Lambert's formula: for each side its angle times the height of the normal of its plane
     * through the point */
    double share = 0;
    for (int i = 0; i < 4; i++) {
        const double *a = corners[i], *b = corners[(i + 1) % 4];
        double normal[3];
        reference_cross(b, a, normal);
        const double sine = sqrt(reference_dot(normal, normal));
        share += atan2(sine, reference_dot(a, b)) * normal[2] / sine / (2 * PI);
    }
    share = fabs(share);
    const Open open = open_at_origin(
        FLOOR "- { object: Parallelogram, material: e, u: [1, 0, 0], v: [0, 1, .5], transform: "
              "{ translation: [-.5, .2, 1] } }\n",
        (OpenRays){.across = 64, .radius = INFINITY, .bounces = 1}, true);
    assert_true(fabs(open.open - (1 - share)) < 3e-3);
    static const double components[3] = {.8, .4, .2};
    for (int i = 0; i < 3; i++)
        assert_true(fabs(open.light[i] - components[i] * share) < 3e-3 * components[i] + 1e-9);
}

/* A floor of diffuse 0.5 below a ceiling of the same that emits 1: 1 comes from above, and each
 * two bounces add a quarter of that. */
static void bounces(void **state)
{
    (void)state;
    static const char text[] =
        "image: { width: 16, height: 16 }\ncamera: { camera: Perspective, position: [0, 0, .5], "
        "target: [0, 0, 0], up: [0, 1, 0] }\n"
        "materials: { m: { material: Phong, diffuse: .5, specular: 0 }, g: { material: Phong, "
        "diffuse: .5, specular: 0, emissive: 1 } }\n"
        "objects:\n- { object: Plane, material: m }\n- { object: Plane, material: g, transform: "
        "{ translation: [0, 0, 1] } }\n";
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(text, &options, &document);
    Tracer tracer = reference_open(scene);
    const Ray ray = {{0, 0, .5}, {0, 0, -1}};
    const Hit hit = reference_hit(&tracer, &ray, 0);
    static const double wanted[] = {1, 1, 1.25, 1.25};
    for (int n = 1; n <= 4; n++) {
        OpenRays rays = {.across = 8, .radius = INFINITY, .bounces = n};
        const Open open = open_ray(&tracer, &hit, &rays, &options);
        assert_true(fabs(open.light[0] - wanted[n - 1]) < 1e-6);
    }
    reference_close(&tracer);
    frame_forget(scene, document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_and_all), cmocka_unit_test(a_ball),  cmocka_unit_test(a_wall),
        cmocka_unit_test(a_lamp),          cmocka_unit_test(bounces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
