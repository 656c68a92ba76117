/* Principled surfaces in the light of a picture: integrals in double that draw directions where it is bright and where facets look (frame/sky_reference.h), against themselves by other sums, and what is drawn
 * against them. The picture is a studio by formulas: two windows, 60 and 12 times as bright as its walls. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/frame/frame_draw.h"
#include "tests/frame/reference_picture.h"
#include "tests/frame/sky_reference.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846
enum { SIDE = 96, PIXELS = SIDE * SIDE };
#define VIEW                                                                                                           \
    "image: { width: 96, height: 96 }\ncamera: { camera: Perspective, position: [0, -40, 0], target: [0, 0, 0], "      \
    "angle: 3 }\n"

static double texel(const ReferencePicture *picture, int x, int y, int lane)
{
    const int column = (x % picture->width + picture->width) % picture->width,
              row = (y % picture->height + picture->height) % picture->height;
    return (double)picture->rgba[4 * (row * picture->width + column) + lane];
}

/* semantics.md 5.3 says where a direction is on the sky; texels have their colours in their middles. */
static void picture_light(const void *sky, const double way[3], double rgb[3])
{
    const ReferencePicture *picture = sky;
    const double x = (atan2(way[1], -way[0]) / (2 * PI) + .5) * picture->width - .5,
                 y = acos(-way[2]) / PI * picture->height - .5;
    const int i = (int)floor(x), j = (int)floor(y);
    for (int k = 0; k < 3; k++)
        rgb[k] = (i + 1 - x) * ((j + 1 - y) * texel(picture, i, j, k) + (y - j) * texel(picture, i, j + 1, k)) +
                 (x - i) * ((j + 1 - y) * texel(picture, i + 1, j, k) + (y - j) * texel(picture, i + 1, j + 1, k));
}

static void white_light(const void *sky, const double way[3], double rgb[3])
{
    (void)sky, (void)way;
    rgb[0] = rgb[1] = rgb[2] = 1;
}

/* A sum over even directions, without any drawing by density. */
static void sum_evenly(const SkyReference *reference, const SkyReferenceSurface *surface, const double eye[3],
                       double rgb[3])
{
    enum { HEIGHTS = 600, TURNS = 1200 };
    memset(rgb, 0, 3 * sizeof *rgb);
    for (int i = 0; i < HEIGHTS * TURNS; i++) {
        const double z = (i / TURNS + .5) / HEIGHTS, turn = 2 * PI * (i % TURNS + .5) / TURNS,
                     way[3] = {sqrt(1 - z * z) * cos(turn), sqrt(1 - z * z) * sin(turn), z};
        double lobe[3], light[3];
        sky_reference_lobe(surface, eye, way, lobe);
        reference->light(reference->sky, way, light);
        for (int k = 0; k < 3; k++)
            rgb[k] += lobe[k] * light[k] * 2 / (HEIGHTS * TURNS);
    }
}

/* White metal sends all of white light; a picture's light is that of a sum over even directions, and half as many directions give the same. */
static void the_reference_is_right(void **state)
{
    (void)state;
    static SkyReference white, studio;
    ReferencePicture picture;
    assert_true(reference_picture_read("studio", &picture));
    sky_reference_open(&white, white_light, NULL);
    sky_reference_open(&studio, picture_light, &picture);
    double worst[3] = {0};
    for (int i = 0; i < 12; i++) {
        const double cosine = .2 + .25 * (i % 4);
        double ways[2][3] = {{0, 0, 1},
                             {sqrt(1 - cosine * cosine) * cos(i), sqrt(1 - cosine * cosine) * sin(i), cosine}};
        SkyReferenceSurface metal = {
            .base = {1, 1, 1}, .metalness = 1, .roughness = .1 + .4 * (i / 4), .reflectance = .04};
        SkyReferenceSurface mixed = {
            .base = {.9, .5, .1}, .metalness = .5, .roughness = .4 + .3 * (i / 4), .reflectance = .04};
        double all[3], drawn[3], half[3], even[3];
        sky_reference_surface(&metal);
        sky_reference_surface(&mixed);
        sky_reference_sent(&white, &metal, ways, 4000, all);
        sky_reference_sent(&studio, &mixed, ways, 20000, drawn);
        sky_reference_sent(&studio, &mixed, ways, 10000, half);
        sum_evenly(&studio, &mixed, ways[1], even);
        for (int k = 0; k < 3; k++) {
            worst[0] = fmax(worst[0], fabs(all[k] - 1));
            worst[1] = fmax(worst[1], fabs(drawn[k] / even[k] - 1));
            worst[2] = fmax(worst[2], fabs(drawn[k] / half[k] - 1));
        }
    }
    print_message(
        "white from all around: within %.4f; a picture, against even directions: within %.4f, by half as many: %.4f\n",
        worst[0], worst[1], worst[2]);
    assert_true(worst[0] < .01 && worst[1] < .01 && worst[2] < .01);
    reference_picture_free(&picture);
}

/* The normal that the pixel has, and the direction to the eye; false: not on the ball, or at its rim. */
static bool ways_of(const float *normals, int pixel, double ways[2][3])
{
    const float *e = normals + 4 * pixel;
    const double half = tan(1.5 * PI / 180), view[3] = {(2 * (pixel % SIDE) + 1. - SIDE) / SIDE * half, 1,
                                                        (2 * (pixel / SIDE) + 1. - SIDE) / SIDE * half};
    const double far = sqrt(view[0] * view[0] + 1 + view[2] * view[2]),
                 length = sqrt((double)(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]));
    if (40 * sqrt(1 - 1 / (far * far)) > .97)
        return false;
    const double normal[3] = {e[0] / length, -e[2] / length, e[1] / length};
    for (int k = 0; k < 3; k++) {
        ways[0][k] = normal[k];
        ways[1][k] = -view[k] / far;
    }
    return true;
}

typedef struct {
    double base[3], metalness, roughness;
    double mean, most; /* off, over the greatest value on the ball */
} Case;

/* Of pixels spread evenly. */
static void compare(const SkyReference *reference, const Case *of, const float *light, const float *normals)
{
    enum { STEP = 163, SAMPLES = 4000 };
    SkyReferenceSurface surface = {.base = {of->base[0], of->base[1], of->base[2]},
                                   .metalness = of->metalness,
                                   .roughness = of->roughness,
                                   .reflectance = .04};
    double most = 0, sum = 0, greatest = 0;
    sky_reference_surface(&surface);
    int count = 0;
    for (int pixel = STEP / 2; pixel < PIXELS; pixel += STEP) {
        double ways[2][3], rgb[3];
        if (!ways_of(normals, pixel, ways))
            continue;
        sky_reference_sent(reference, &surface, ways, SAMPLES, rgb);
        for (int k = 0; k < 3; k++) {
            const double off = fabs((double)light[4 * pixel + k] - rgb[k]);
            most = fmax(most, off);
            sum += off / 3;
            greatest = fmax(greatest, rgb[k]);
        }
        count++;
    }
    print_message("%-10s roughness %.2f: %.2f %% off in the mean, %.1f %% at most, of the greatest, %.3g\n",
                  of->metalness > 0 ? "metal" : "plastic", of->roughness, 100 * sum / count / greatest,
                  100 * most / greatest, greatest);
    assert_true(count > 30 && sum / count < of->mean * greatest && most < of->most * greatest);
}

/* Bounds are what is seen and a tenth: a lobe of Phong stands in for GGX (surface_principled_light.glsl). */
static void balls_are_those_of_the_reference(void **state)
{
    (void)state;
    static const Case cases[] = {{{.9, .7, .5}, 1, .1, .001, .045}, {{.9, .7, .5}, 1, .2, .005, .15},
                                 {{.9, .7, .5}, 1, .4, .017, .24},  {{.9, .7, .5}, 1, .7, .11, .36},
                                 {{.9, .7, .5}, 1, 1, .16, .6},     {{.5, .3, .1}, 0, .3, .01, .08},
                                 {{.5, .3, .1}, 0, .8, .01, .032}};
    static SkyReference studio;
    ReferencePicture picture;
    GlContext *gl = frame_context();
    MatcOptions options = frame_exact_options();
    options.pixels = true;
    assert_true(reference_picture_read("studio", &picture));
    sky_reference_open(&studio, picture_light, &picture);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double *base = cases[i].base;
        char text[1024];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 VIEW "lights: [{ light: Sky }]\nobjects: [{ object: Sphere, material: { material: Principled, "
                      "baseColor: [%g, %g, %g], metalness: %g, roughness: %g } }]\n"
                      "sky: { material: Phong, diffuse: 0, emissive: { map: ImageMap, image: "
                      "tests/reference/studio.exr, texels: centre } }\n",
                 base[0], base[1], base[2], cases[i].metalness, cases[i].roughness);
        Scene *scene = frame_scene(text, &options, &document);
        float *light = frame_floats(gl, scene, &(RenderOptions){.compile = &options, .view = "light"}),
              *normals = frame_floats(gl, scene, &(RenderOptions){.compile = &options, .view = "normal"});
        compare(&studio, &cases[i], light, normals);
        free(light);
        free(normals);
        frame_forget(scene, document);
    }
    reference_picture_free(&picture);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_reference_is_right),
                                       cmocka_unit_test(balls_are_those_of_the_reference)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
