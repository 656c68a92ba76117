/* Bent normals, the mean unoccluded directions, against Embree's rays; and the light of a half
 * sky, against the same rays: estimated by ambient occlusion times the irradiance along the
 * normal and along the bent normal, and as rendered, by the rays that miss, and with
 * `directional: false`. */
/* ctest: seconds=10 */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/open_ray.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    EDGE = 96,
    APART = 5,
    ACROSS = 48,
    PLACES = EDGE * EDGE / (APART * APART),
    TEXT = 2048,
    SKIES = 2
};
static const double radius = 10, pi = 3.14159265358979323846;

static const char body[] =
    "image: { width: 96, height: 96 }\ncamera: { camera: Perspective, position: [.3, -4, 2.6], "
    "target: [.1, 0, .3], "
    "angle: 40 }\nmaterials: { m: { material: Phong, diffuse: .7, specular: 0 } }\nobjects:\n"
    "- { object: Box, material: m, size: [3, 3, .2], transform: { translation: [0, 0, -.1] } }\n"
    "- { object: Box, material: m, size: [3, .2, 2], transform: { translation: [0, 1, 1] } }\n"
    "- { object: Sphere, radius: .4, detail: 48, material: m, transform: { translation: [-.5, 0, "
    ".4] } }\n"
    "- { object: Box, material: m, size: [.5, .5, .9], transform: { translation: [.5, -.2, .45], "
    "rotation: [0, 0, .4] "
    "} }\n";

/* A half sky of light 1, and none from the other half: directions to the centers of the bright
 * halves. */
static const double skies[SKIES][3] = {{0, 0, 1}, {0, -.8, .6}};

typedef struct {
    int pixel;
    double normal[3], open, way[3], light[SKIES]; /* of rays */
} Place;

typedef struct {
    Place places[PLACES];
    int count;
} Truth;

/* Cosine-weighted stratified rays: one in the middle of each cell of the unit square. */
static void look_around(const Tracer *tracer, const Hit *hit, Place *place)
{
    const double *n = hit->normal;
    double u[3], v[3], from[3];
    const double aside[3] = {fabs(n[0]) < .6, fabs(n[0]) >= .6, 0};
    reference_cross(n, aside, u);
    reference_normalize(u);
    reference_cross(n, u, v);
    for (int k = 0; k < 3; k++)
        from[k] = hit->world[k] + 1e-4 * hit->microfacet[k];
    for (int i = 0; i < ACROSS * ACROSS; i++) {
        const double s = (i % ACROSS + .5) / ACROSS, turn = 2 * pi * (i / ACROSS + .5) / ACROSS;
        double way[3];
        for (int k = 0; k < 3; k++)
            way[k] = sqrt(s) * (cos(turn) * u[k] + sin(turn) * v[k]) + sqrt(1 - s) * n[k];
        if (reference_is_blocked(tracer, from, way, radius))
            continue;
        place->open += 1. / (ACROSS * ACROSS);
        for (int k = 0; k < 3; k++)
            place->way[k] += way[k];
        for (int sky = 0; sky < SKIES; sky++)
            place->light[sky] += (reference_dot(way, skies[sky]) > 0) / (double)(ACROSS * ACROSS);
    }
}

static void find_truth(const Scene *scene, Truth *truth)
{
    Tracer tracer = reference_open(scene);
    for (int p = 0; p < EDGE * EDGE; p++) {
        const int x = p % EDGE, y = p / EDGE;
        if (x % APART != APART / 2 || y % APART != APART / 2 || truth->count == PLACES)
            continue;
        const Ray ray = reference_ray(scene, x + .5, y + .5);
        const Hit hit = reference_hit(&tracer, &ray, 0);
        if (!isfinite(hit.distance) || reference_is_edge(&tracer, x, y, &hit, 1))
            continue;
        Place *place = &truth->places[truth->count++];
        *place = (Place){.pixel = p};
        for (int k = 0; k < 3; k++)
            place->normal[k] = hit.normal[k];
        look_around(&tracer, &hit, place);
        reference_normalize(place->way);
    }
    reference_close(&tracer);
}

/* Draws by keys of `indirect:`, and lights. */
static float *drawn_by(GlContext *gl, Renderer *renderer, const char *texts[2], Truth *truth,
                       SceneCamera *camera)
{
    const MatcOptions options = frame_exact_options();
    char text[TEXT];
    MatcDocument *document;
    snprintf(text, sizeof text, "indirect: { radius: %g, bounces: 0, %s }\n%s%s", radius, texts[0],
             texts[1], body);
    Scene *scene = frame_scene(text, &options, &document);
    if (!truth->count)
        find_truth(scene, truth);
    *camera = scene->camera;
    float *rgba = frame_floats_by(gl, renderer, scene);
    frame_forget(scene, document);
    return rgba;
}

static Renderer *opened(GlContext *gl, const MatcOptions *options, const char *view)
{
    return renderer_open(gl, &(RendererOptions){.compile = options, .view = view, .deep = true});
}

static void to_world(const SceneCamera *camera, const float *eye, double way[3])
{
    for (int k = 0; k < 3; k++)
        way[k] = eye[0] * camera->right[k] + eye[1] * camera->up[k] + eye[2] * camera->back[k];
    reference_normalize(way);
}

/* Light of a half sky relative to an even one, for light from a cap with the cosine-weighted
 * share `open`, as if the sky's border crossed the cap linearly. For an unoccluded point this is
 * the hemisphere's formula. */
static double share_of_cap(double cosine, double open)
{
    return .5 + .5 * fmax(-1, fmin(1, cosine / sqrt(fmax(open, 1e-6))));
}

static void bent_normals_are_those_of_rays(void **state)
{
    static const struct {
        const char *keys;
        double degrees, light; /* bounds: mean angle; light of half skies by caps */
    } cases[] = {{"method: hybrid, rays: 64", 1.5, .025},
                 {"method: voxels, rays: 64", 1.5, .025},
                 {"method: screen, rays: 64, steps: 16", 20, .09}};
    Truth *truth = *state;
    GlContext *gl = frame_context();
    const MatcOptions options = frame_exact_options();
    Renderer *renders[2] = {opened(gl, &options, "ao"), opened(gl, &options, "bent")};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        SceneCamera camera;
        float *open =
            drawn_by(gl, renders[0], (const char *[2]){cases[i].keys, ""}, truth, &camera);
        float *bent =
            drawn_by(gl, renders[1], (const char *[2]){cases[i].keys, ""}, truth, &camera);
        double angle = 0, by[3] = {0};
        for (int p = 0; p < truth->count; p++) {
            const Place *place = &truth->places[p];
            const double share = open[4 * place->pixel];
            double way[3];
            to_world(&camera, bent + 4 * place->pixel, way);
            angle += acos(fmin(reference_dot(way, place->way), 1)) * 180 / pi / truth->count;
            for (int sky = 0; sky < SKIES; sky++) {
                const double along = reference_dot(place->normal, skies[sky]),
                             cosine = reference_dot(way, skies[sky]);
                const double found[3] = {share * (.5 + .5 * along), share * (.5 + .5 * cosine),
                                         share * share_of_cap(cosine, share)};
                for (int k = 0; k < 3; k++)
                    by[k] += (found[k] - place->light[sky]) * (found[k] - place->light[sky]) /
                             (SKIES * truth->count);
            }
        }
        print_message("%s: %.1f degrees off in the mean, of %d places; light of half a sky along "
                      "normals %.4f off, along bent "
                      "ones %.4f, of a cap around these %.4f\n",
                      cases[i].keys, angle, truth->count, sqrt(by[0]), sqrt(by[1]), sqrt(by[2]));
        assert_true(truth->count > 200 && angle < cases[i].degrees && sqrt(by[2]) < cases[i].light);
        free(open);
        free(bent);
    }
    renderer_close(renders[0]);
    renderer_close(renders[1]);
    gl_close(gl);
}

/* A half sky, as cells of a checker so large that only the border through the origin is visible. */
static void put_sky(const double way[3], char text[TEXT])
{
    snprintf(text, TEXT,
             "lights: [{ light: Sky }]\nsky: { material: Phong, diffuse: 0, emissive: { map: "
             "VolumeChecker, color1: 0, "
             "color2: 1, input: { map: XYZTransform, transform: { matrix: [%g, %g, %g, 0, 0, 0, 0, "
             ".5, 0, 0, 0, .5, 0, "
             "0, 0, 1] } } } }\n",
             .5 * way[0], .5 * way[1], .5 * way[2]);
}

/* Root mean square error over all half skies, against rays. */
static double light_off(GlContext *gl, Renderer *renderer, const char *keys, Truth *truth,
                        bool hemisphere)
{
    const double diffuse = .7;
    double sum = 0;
    for (int sky = 0; sky < (hemisphere ? 1 : SKIES); sky++) {
        char lights[TEXT];
        SceneCamera camera;
        put_sky(skies[sky], lights);
        const char *texts[2] = {
            keys, hemisphere ? "lights: [{ light: Hemisphere, ground: [0, 0, 0] }]\n" : lights};
        float *light = drawn_by(gl, renderer, texts, truth, &camera);
        for (int p = 0; p < truth->count; p++) {
            const double off =
                light[4 * truth->places[p].pixel] / diffuse - truth->places[p].light[sky];
            sum += off * off / ((hemisphere ? 1 : SKIES) * truth->count);
        }
        free(light);
    }
    return sqrt(sum);
}

static void light_of_half_a_sky_comes_by_direction(void **state)
{
    static const struct {
        const char *keys;
        bool hemisphere;
        double least, most; /* off */
    } cases[] = {{"method: hybrid", false, 0, .015},
                 {"method: hybrid, directional: false", false, .06, .1},
                 {"method: hybrid, rays: 64", false, 0, .01},
                 {"method: hybrid, rays: 16, resolution: half, gain: 2", false, 0, .03},
                 {"method: screen, rays: 64, steps: 16", false, 0, .035},
                 {"method: screen, rays: 64, steps: 16, directional: false", false, .06, .1},
                 {"method: hybrid", true, 0, .015},
                 {"method: hybrid, directional: false", true, .06, .1}};
    Truth *truth = *state;
    GlContext *gl = frame_context();
    const MatcOptions options = frame_exact_options();
    Renderer *renderer = opened(gl, &options, "light");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double off = light_off(gl, renderer, cases[i].keys, truth, cases[i].hemisphere);
        print_message("%s, %s: %.4f\n", cases[i].keys, cases[i].hemisphere ? "Hemisphere" : "Sky",
                      off);
        assert_true(off >= cases[i].least && off < cases[i].most);
    }
    renderer_close(renderer);
    gl_close(gl);
}

/* A Hemisphere light that changes from uniform to two-colored equals one that was two-colored
 * from the start, and back. */
static void hemispheres_change(void **state)
{
    static const char *const lights[2] = {"lights: [{ light: Hemisphere, ground: [1, 1, 1] }]\n",
                                          "lights: [{ light: Hemisphere, ground: [0, 0, 0] }]\n"};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    Renderer *renderer = opened(gl, &options, "light");
    float *wanted[2];
    SceneCamera camera;
    char text[TEXT];
    MatcDocument *document;
    for (int i = 0; i < 2; i++)
        wanted[i] =
            drawn_by(gl, renderer, (const char *[2]){"method: voxels", lights[i]}, *state, &camera);
    snprintf(text, sizeof text, "indirect: { radius: %g, bounces: 0, method: voxels }\n%s%s",
             radius, lights[0], body);
    Scene *scene = frame_scene(text, &options, &document);
    free(frame_floats_by(gl, renderer, scene));
    for (int i = 1; i >= 0; i--) {
        float rgba[4 * EDGE * EDGE];
        for (int k = 0; k < 3; k++)
            scene->lights[0].ground[k] = i ? 0 : scene->lights[0].light[k];
        assert_true(renderer_changed(renderer, RENDERER_LIGHTS) && renderer_frame(renderer) &&
                    renderer_read(renderer, rgba));
        assert_memory_equal(rgba, wanted[i], sizeof rgba);
        free(wanted[i]);
    }
    renderer_close(renderer);
    frame_forget(scene, document);
    gl_close(gl);
}

int main(void)
{
    static Truth truth; /* found once */
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate(bent_normals_are_those_of_rays, &truth),
        cmocka_unit_test_prestate(light_of_half_a_sky_comes_by_direction, &truth),
        cmocka_unit_test_prestate(hemispheres_change, &truth)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
