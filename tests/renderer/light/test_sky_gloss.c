/* Principled surfaces lit by an environment map: integrals in double that sample the map's
 * radiance and GGX's visible normals (frame_reference/sky_reference.h), checked against other
 * sums, are the reference of the drawn picture; sums over evenly spread directions that of
 * anisotropic surfaces; white under white. The map is a studio by formulas: two windows, 60 and
 * 12 times as bright as its walls. */
/* ctest: seconds=36 */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/reference_picture.h"
#include "tests/frame_reference/sky_reference.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 96, PIXELS = SIDE * SIDE };
#define VIEW                                                                                       \
    "image: { width: 96, height: 96 }\ncamera: { camera: Perspective, position: [0, -40, 0], "     \
    "target: [0, 0, 0], "                                                                          \
    "angle: 3 }\n"

static double texel(const ReferencePicture *picture, int x, int y, int component)
{
    const int column = (x % picture->width + picture->width) % picture->width,
              row = (y % picture->height + picture->height) % picture->height;
    return (double)picture->rgba[4 * (row * picture->width + column) + component];
}

/* semantics.md 5.3 says where a direction is on the sky; texels have their colors in their
 * middles. */
static void picture_light(const void *sky, const double way[3], double rgb[3])
{
    const ReferencePicture *picture = sky;
    const double x = (atan2(way[1], -way[0]) / (2 * PI) + .5) * picture->width - .5,
                 y = acos(-way[2]) / PI * picture->height - .5;
    const int i = (int)floor(x), j = (int)floor(y);
    for (int k = 0; k < 3; k++)
        rgb[k] = (i + 1 - x) * ((j + 1 - y) * texel(picture, i, j, k) +
                                (y - j) * texel(picture, i, j + 1, k)) +
                 (x - i) * ((j + 1 - y) * texel(picture, i + 1, j, k) +
                            (y - j) * texel(picture, i + 1, j + 1, k));
}

static void white_light(const void *sky, const double way[3], double rgb[3])
{
    (void)sky, (void)way;
    rgb[0] = rgb[1] = rgb[2] = 1;
}

/* A sum over evenly spread directions, without importance sampling. */
static void sum_evenly(const SkyReference *reference, const SkyReferenceSurface *surface,
                       const double eye[3], double rgb[3])
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

/* White metal sends all of white light; a picture's light is that of a sum over even directions,
 * and half as many directions give the same. */
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
        double ways[2][3] = {
            {0, 0, 1},
            {sqrt(1 - cosine * cosine) * cos(i), sqrt(1 - cosine * cosine) * sin(i), cosine}};
        SkyReferenceSurface metal = {
            .base = {1, 1, 1}, .metalness = 1, .roughness = .1 + .4 * (i / 4), .reflectance = .04};
        SkyReferenceSurface mixed = {.base = {.9, .5, .1},
                                     .metalness = .5,
                                     .roughness = .4 + .3 * (i / 4),
                                     .reflectance = .04};
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
    print_message("white from all around: within %.4f; a picture, against even directions: within "
                  "%.4f, by half as many: %.4f\n",
                  worst[0], worst[1], worst[2]);
    assert_true(worst[0] < .01 && worst[1] < .01 && worst[2] < .01);
    reference_picture_free(&picture);
}

/* The normal that the pixel has, and the direction to the eye; false: not on the ball, or at its
 * rim. */
static bool ways_of(const float *normals, int pixel, double ways[2][3])
{
    const float *e = normals + 4 * pixel;
    const double half = tan(1.5 * PI / 180),
                 view[3] = {(2 * (pixel % SIDE) + 1. - SIDE) / SIDE * half, 1,
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

/* Compares pixels spread evenly. */
static void compare(const SkyReference *reference, const Case *of, const float *light,
                    const float *normals)
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
    print_message(
        "%-10s roughness %.2f: %.2f %% off in the mean, %.1f %% at most, of the greatest, %.3g\n",
        of->metalness > 0 ? "metal" : "plastic", of->roughness, 100 * sum / count / greatest,
        100 * most / greatest, greatest);
    assert_true(count > 30 && sum / count < of->mean * greatest && most < of->most * greatest);
}

static const char studio_sky[] = "{ material: Phong, diffuse: 0, emissive: { map: ImageMap, image: "
                                 "tests/reference/studio.exr, texels: centre } }";

/* Draws a ball of a Principled with these parameters under a sky: its light, and its normals
 * unless NULL. */
static void draw_ball(GlContext *gl, const char *material, const char *sky, float **light,
                      float **normals)
{
    char text[1024];
    MatcDocument *document;
    MatcOptions options = frame_exact_options();
    options.pixels = true;
    snprintf(text, sizeof text,
             VIEW "lights: [{ light: Sky }]\nobjects: [{ object: Sphere, material: { material: "
                  "Principled, %s } }]\n"
                  "sky: %s\n",
             material, sky);
    Scene *scene = frame_scene(text, &options, &document);
    *light = frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
    *normals = frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "normal"});
    frame_forget(scene, document);
}

/* Bounds are the measured errors plus a tenth to a half. The last case is a coat of index 1.5
 * over a black base. */
static void balls_are_those_of_the_reference(void **state)
{
    (void)state;
    static const Case cases[] = {
        {{.9, .7, .5}, 1, .1, .0006, .015}, {{.9, .7, .5}, 1, .2, .001, .01},
        {{.9, .7, .5}, 1, .4, .0025, .035}, {{.9, .7, .5}, 1, .7, .011, .04},
        {{.9, .7, .5}, 1, 1, .02, .09},     {{.5, .3, .1}, 0, .3, .006, .025},
        {{.5, .3, .1}, 0, .8, .004, .013},  {{0, 0, 0}, 0, .4, .005, .035}};
    static SkyReference studio;
    ReferencePicture picture;
    GlContext *gl = frame_context();
    assert_true(reference_picture_read("studio", &picture));
    sky_reference_open(&studio, picture_light, &picture);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const double *base = cases[i].base;
        char material[256];
        float *light, *normals;
        snprintf(material, sizeof material, "baseColor: [%g, %g, %g], metalness: %g, roughness: %g",
                 base[0], base[1], base[2], cases[i].metalness, cases[i].roughness);
        if (base[0] == 0)
            snprintf(material, sizeof material,
                     "baseColor: 0, specular: 0, roughness: 0.7, coat: 1, coatIor: 1.5, "
                     "coatRoughness: %g",
                     cases[i].roughness);
        draw_ball(gl, material, studio_sky, &light, &normals);
        compare(&studio, &cases[i], light, normals);
        free(light);
        free(normals);
    }
    reference_picture_free(&picture);
    gl_close(gl);
}

/* Single reflection of black microfacets of two widths, of index 1.5, times pi and the light's
 * cosine; the axes are the tangent, the bitangent and the normal. */
static double brushed_lobe(const double widths[2], const double eye[3], const double way[3])
{
    double half[3], masked = 1;
    for (int k = 0; k < 3; k++)
        half[k] = eye[k] + way[k];
    const double length = sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2]);
    const double facing = (half[0] * eye[0] + half[1] * eye[1] + half[2] * eye[2]) / length;
    const double *both[2] = {eye, way};
    for (int i = 0; i < 2; i++) {
        const double a = widths[0] * both[i][0], b = widths[1] * both[i][1];
        masked += (sqrt(1 + (a * a + b * b) / (both[i][2] * both[i][2])) - 1) / 2;
    }
    const double x = half[0] / widths[0], y = half[1] / widths[1],
                 wide = (x * x + y * y + half[2] * half[2]) / (length * length);
    return (.04 + .96 * pow(1 - facing, 5)) /
           (widths[0] * widths[1] * wide * wide * masked * 4 * eye[2]);
}

/* A ball whose microfacets are wider around its axis, z: a sum over uniform directions. */
static double brushed_light(const ReferencePicture *picture, const double widths[2],
                            double ways[2][3])
{
    enum { HEIGHTS = 250, TURNS = 500 };
    const double *n = ways[0], flat = hypot(n[0], n[1]);
    const double axes[3][3] = {{-n[1] / flat, n[0] / flat, 0},
                               {-n[2] * n[0] / flat, -n[2] * n[1] / flat, flat},
                               {n[0], n[1], n[2]}};
    double eye[3], sum = 0;
    for (int k = 0; k < 3; k++)
        eye[k] = axes[k][0] * ways[1][0] + axes[k][1] * ways[1][1] + axes[k][2] * ways[1][2];
    for (int i = 0; i < HEIGHTS * TURNS; i++) {
        const double z = (i / TURNS + .5) / HEIGHTS, turn = 2 * PI * (i % TURNS + .5) / TURNS,
                     way[3] = {sqrt(1 - z * z) * cos(turn), sqrt(1 - z * z) * sin(turn), z};
        const double lobe = brushed_lobe(widths, eye, way);
        double world[3], light[3];
        if (lobe < 1e-6)
            continue;
        for (int k = 0; k < 3; k++)
            world[k] = axes[0][k] * way[0] + axes[1][k] * way[1] + axes[2][k] * way[2];
        picture_light(picture, world, light);
        sum += lobe * light[1] * 2 / (HEIGHTS * TURNS);
    }
    return sum;
}

/* Five times as wide along as across. */
static void brushed_balls_are_too(void **state)
{
    (void)state;
    enum { STEP = 163 };
    const double wide = .25 * sqrt(2 / 1.04), widths[2] = {wide, .2 * wide};
    ReferencePicture picture;
    GlContext *gl = frame_context();
    float *light, *normals;
    double most = 0, all = 0, greatest = 0, ways[2][3];
    int count = 0;
    assert_true(reference_picture_read("studio", &picture));
    draw_ball(gl, "baseColor: 0, roughness: 0.5, anisotropy: 0.8", studio_sky, &light, &normals);
    for (int pixel = STEP / 2; pixel < PIXELS; pixel += STEP) {
        if (!ways_of(normals, pixel, ways))
            continue;
        const double expected = brushed_light(&picture, widths, ways),
                     off = fabs((double)light[4 * pixel + 1] - expected);
        most = fmax(most, off);
        greatest = fmax(greatest, expected);
        all += off;
        count++;
    }
    print_message("brushed: %.2f %% off in the mean, %.1f %% at most, of the greatest, %.3g\n",
                  100 * all / count / greatest, 100 * most / greatest, greatest);
    assert_true(count > 30 && all / count < .01 * greatest && most < .06 * greatest);
    free(light);
    free(normals);
    reference_picture_free(&picture);
    gl_close(gl);
}

/* White furnace for all roughnesses, coats, fuzz and brushed metal. */
static void white_stays_white(void **state)
{
    (void)state;
    static const char *const more[] = {"metalness: 1",
                                       "ior: 1.5",
                                       "metalness: .5, anisotropy: .7",
                                       "coat: 1",
                                       "metalness: 1, coat: 1, coatRoughness: .4",
                                       "fuzz: .7, fuzzColor: 1"};
    static const double roughnesses[] = {0, .2, .5, .8, 1};
    GlContext *gl = frame_context();
    double worst = 0;
    int count = 0;
    for (int i = 0; i < 6 * 5; i++) {
        char material[256];
        double ways[2][3], here = 0;
        float *light, *normals;
        snprintf(material, sizeof material, "baseColor: 1, roughness: %g, %s", roughnesses[i % 5],
                 more[i / 5]);
        draw_ball(gl, material, "{ material: RGBA, r: 1, g: 1, b: 1 }", &light, &normals);
        for (int pixel = 0; pixel < PIXELS; pixel++)
            for (int k = 0; k < 3 && ways_of(normals, pixel, ways); k++, count++)
                here = fmax(here, fabs((double)light[4 * pixel + k] - 1));
        if (here > .01)
            print_message("%s: off by %.4f\n", material, here);
        worst = fmax(worst, here);
        free(light);
        free(normals);
    }
    print_message("white from all around: within %.1e\n", worst);
    assert_true(count > 30 * PIXELS && worst <= .01);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_reference_is_right),
                                       cmocka_unit_test(balls_are_those_of_the_reference),
                                       cmocka_unit_test(brushed_balls_are_too),
                                       cmocka_unit_test(white_stays_white)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
