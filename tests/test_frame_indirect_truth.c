/* Openness and indirect light by every method against many rays in double; how far each is off is printed, and bounded. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/frame/frame_draw.h"
#include "tests/frame/open_ray.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = 256, APART = 8, TEXT = 4096 };

/* Walls as thick as a voxel of 64, and two boxes: the Cornell box. The lamp has no shadows, neither here nor there. */
static const char box[] =
    "image: { width: 256, height: 256 }\ncamera: { camera: Perspective, position: [0, -4.25, 1], target: [0, 0, 1], "
    "angle: 39 }\nlights: [{ light: Point, position: [.1, -.4, 1.5], intensity: 1, shadows: none }]\nmaterials:\n"
    "  white: { material: Phong, diffuse: .75, specular: 0 }\n  red: { material: Phong, diffuse: [.63, .06, .05], "
    "specular: 0 }\n"
    "  green: { material: Phong, diffuse: [.15, .48, .09], specular: 0 }\nobjects:\n"
    "- { object: Box, size: [2.2, 2.2, .1], material: white, transform: { translation: [0, 0, -.05] } }\n"
    "- { object: Box, size: [2.2, 2.2, .1], material: white, transform: { translation: [0, 0, 2.05] } }\n"
    "- { object: Box, size: [2.2, .1, 2.2], material: white, transform: { translation: [0, 1.05, 1] } }\n"
    "- { object: Box, size: [.1, 2.2, 2.2], material: red, transform: { translation: [-1.05, 0, 1] } }\n"
    "- { object: Box, size: [.1, 2.2, 2.2], material: green, transform: { translation: [1.05, 0, 1] } }\n"
    "- { object: Box, size: [.6, .6, 1.2], material: white, transform: { translation: [-.35, .3, .6], rotation: [0, 0, "
    ".3] } }\n"
    "- { object: Box, size: [.6, .6, .6], material: white, transform: { translation: [.37, -.35, .3], rotation: [0, 0, "
    "-.3] } }\n";

typedef struct {
    int pixel;
    Open open;
} Place;

typedef struct {
    Place places[EDGE * EDGE / (APART * APART)];
    int count;
    double light; /* mean over places and lanes */
} Truth;

/* Of places in rows and columns, not at edges of objects: a pixel's middle may be on either side there. */
/* Of one bounce, or where `across` is negative of two. */
static void find_truth(const Scene *scene, int across, double radius, const MatcOptions *options, Truth *truth)
{
    Tracer tracer = reference_open(scene);
    truth->count = 0;
    truth->light = 0;
    for (int y = APART / 2; y < EDGE; y += APART)
        for (int x = APART / 2; x < EDGE; x += APART) {
            const Ray ray = reference_ray(scene, x + .5, y + .5);
            const Hit hit = reference_hit(&tracer, &ray, 0);
            OpenRays rays = {.across = abs(across),
                             .radius = radius,
                             .bounces = across < 0 ? 2 : 1,
                             .state = (uint64_t)(y * EDGE + x)};
            if (!isfinite(hit.distance) || reference_is_edge(&tracer, x, y, &hit, 1))
                continue;
            Place *place = &truth->places[truth->count++];
            *place = (Place){y * EDGE + x, open_ray(&tracer, &hit, &rays, options)};
            for (int k = 0; k < 3; k++)
                truth->light += place->open.light[k] / 3;
        }
    truth->light /= truth->count;
    reference_close(&tracer);
}

/* Of the mean of light. */
static double mean_off(const Truth *truth, const float *rgba)
{
    double mean = 0;
    for (int i = 0; i < 3 * truth->count; i++)
        mean += rgba[4 * truth->places[i / 3].pixel + i % 3] / (3. * truth->count);
    return mean / truth->light - 1;
}

/* Root of the mean square, of openness or, over the mean, of light. */
static double off_by(const Truth *truth, const float *rgba, bool light)
{
    double sum = 0;
    for (int i = 0; i < truth->count; i++)
        for (int k = 0; k < 3; k++) {
            const float *is = rgba + 4 * truth->places[i].pixel;
            const Open *open = &truth->places[i].open;
            const double off = light ? ((double)is[k] - open->light[k]) / truth->light : (double)is[0] - open->open;
            sum += off * off / 3;
        }
    return sqrt(sum / truth->count);
}

static void methods_against_rays(void **state)
{
    (void)state;
    static const struct {
        const char *keys;
        double open, light; /* at most */
    } methods[] = {{"method: march, rays: 32, steps: 32", 0.09, 0.5},
                   {"method: march, march: voxels, rays: 32, steps: 32", 0.0095, 0.2},
                   {"method: screen, rays: 32, steps: 16", 0.075, 0.55},
                   {"method: voxels", 0.0145, 0.05},
                   {"method: hybrid", 0.0125, 0.05},
                   {"method: hybrid, rays: 16, sequence: hammersley", 0.0095, 0.07},
                   {"method: hybrid, rays: 64", 0.0082, 0.042},
                   {"method: hybrid, filter: atrous", 0.0135, 0.068},
                   {"method: hybrid, filter: atrous, filterSize: 8", 0.0145, 0.058},
                   {"method: hybrid, rays: 32, resolution: half", 0.018, 0.12},
                   {"method: hybrid, rays: 64, resolution: quarter", 0.038, 0.09}};
    static const double radii[2] = {.5, 4};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    Truth *truth = malloc(sizeof *truth);
    for (int light = 0; light < 2; light++)
        for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
            char text[TEXT];
            MatcDocument *document;
            snprintf(text, sizeof text, "indirect: { radius: %g, %s }\n%s", radii[light], methods[i].keys, box);
            Scene *scene = frame_scene(text, &options, &document);
            if (i == 0)
                find_truth(scene, light ? 24 : 32, radii[light], light ? &options : NULL, truth);
            float *rgba =
                frame_floats(gl, scene, &(RenderOptions){.compile = &options, .view = light ? "indirect" : "open"});
            const double off = off_by(truth, rgba, light);
            print_message("%-48s %s %.4f off, of %d places", methods[i].keys, light ? "light" : "openness", off,
                          truth->count);
            print_message(light ? "; its mean %.3f\n" : "\n", mean_off(truth, rgba));
            assert_true(!light || !strstr(methods[i].keys, "hybrid") || fabs(mean_off(truth, rgba)) < .03);
            assert_true(truth->count > 600 && off < (light ? methods[i].light : methods[i].open));
            free(rgba);
            frame_forget(scene, document);
        }
    free(truth);
    gl_close(gl);
}

/* A second bounce is no more off than the first. Rays of samples that are averaged are as good as so many at once. */
static void bounces_and_samples(void **state)
{
    (void)state;
    static const struct {
        const char *keys, *view;
        int across;
        double most;
    } cases[] = {{"bounces: 2", "indirect", -20, .07},
                 {"samples: 8, rotation: random, filter: none, rays: 8", "open", 32, .025}};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    Truth *truth = malloc(sizeof *truth);
    for (int i = 0; i < 2; i++) {
        char text[TEXT];
        MatcDocument *document;
        snprintf(text, sizeof text, "indirect: { radius: %g, %s }\n%s", i ? .5 : 4., cases[i].keys, box);
        Scene *scene = frame_scene(text, &options, &document);
        find_truth(scene, cases[i].across, i ? .5 : 4, i ? NULL : &options, truth);
        float *rgba = frame_floats(gl, scene, &(RenderOptions){.compile = &options, .view = cases[i].view});
        const double off = off_by(truth, rgba, !i);
        print_message("%-48s %.4f off\n", cases[i].keys, off);
        assert_true(off < cases[i].most);
        free(rgba);
        frame_forget(scene, document);
    }
    free(truth);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(methods_against_rays), cmocka_unit_test(bounces_and_samples)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
