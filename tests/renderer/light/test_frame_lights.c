/* Many lights: of every kind in any order, more than a uniform block holds, against the
 * reference in double; and grouped far lights against the sum of all. */
/* ctest: unsanitized */
#include "tests/test.h"
#include "runtime/frame_graph/frame.h"
#include "tests/frame/frame_compare.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/frame_lamps.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint32_t state_of_lights;

/* From 0 to 1. */
static double chance(void)
{
    state_of_lights = state_of_lights * 1664525u + 1013904223u;
    return (state_of_lights >> 8) / 16777216.;
}

enum { TEXT = 1 << 20 };

#define APPEND(...) size += (size_t)snprintf(text + size, TEXT - size, __VA_ARGS__)

/* Behind the `size` characters that are there: a light above a plane, so that it shades nothing
 * from it. Returns the new size. */
static size_t put_light(char *text, size_t size, const char *kind, int count)
{
    const bool directional = !strcmp(kind, "Directional"), area = !strcmp(kind, "Area"),
               spot = !strcmp(kind, "Spot");
    const double x = 6 * chance() - 3, y = 6 * chance() - 3, z = .3 + 2 * chance();
    const double red = chance(), green = chance(), blue = chance();
    APPEND("- { light: %s, color: [%.3f, %.3f, %.3f], intensity: %.5f", kind, red, green, blue,
           (directional ? 2. : 8.) / count);
    if (!directional)
        APPEND(", position: [%.4f, %.4f, %.4f]", x, y, z);
    if (spot || directional)
        APPEND(", direction: [%.4f, %.4f, -1]", x / 6, y / 6);
    if (spot)
        APPEND(", innerAngle: 25, outerAngle: 55");
    if (area)
        APPEND(", u: [0, .4, 0], v: [.3, 0, .1]");
    else if (z < 1)
        APPEND(", shadows: false");
    APPEND(" }\n");
    return size;
}

/* `kinds` are taken in turns. From malloc. */
static char *text_of(const char *const *kinds, int kind_count, int count)
{
    char *text = malloc(TEXT);
    assert_non_null(text);
    state_of_lights = 1;
    size_t size = 0;
    APPEND("image: { width: 96, height: 64 }\ncamera: { camera: Perspective, position: [.5, -6, "
           "2.5], target: [0, 0, 0] "
           "}\nobjects: [{ object: Plane, material: { material: Phong, diffuse: [.6, .5, .4], "
           "specular: .25, "
           "shininess: .5 } }]\nlights:\n");
    for (int i = 0; i < count; i++)
        size = put_light(text, size, kinds[i % kind_count], count);
    assert_true(size < TEXT);
    return text;
}

static const char *const every[] = {"Spot",  "Point", "Area", "Directional",
                                    "Point", "Point", "Spot"};
static const char *const without_areas[] = {"Spot",  "Point", "Directional",
                                            "Point", "Point", "Spot"};
static const char *const spots[] = {"Spot"};

/* Every light counts, whether its numbers are in the uniform block or, above its capacity, in a
 * texture; in fragment and compute programs. */
static void every_light_counts(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        const char *const *kinds;
        int kind_count, count;
        bool fragment;
    } cases[] = {{"of every kind", every, 7, 21, false},
                 {"in fragments", without_areas, 6, 21, true},
                 {"more than a block", spots, 1, 1100, false},
                 {"that in fragments", spots, 1, 1100, true}};
    static Spread spread;
    MatcLayout *layout;
    const MatcOptions options = frame_float_options(&layout);
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcDocument *document;
        char *text = text_of(cases[i].kinds, cases[i].kind_count, cases[i].count);
        Scene *scene = frame_scene(text, &options, &document);
        float *rgba =
            frame_floats(gl, scene,
                         &(RendererOptions){
                             .compile = &options, .view = "light", .fragment = cases[i].fragment});
        compare(scene, &options, rgba, &spread);
        assert_true(is_close(cases[i].name, 2e-6, &spread));
        free(rgba);
        free(text);
        frame_forget(scene, document);
    }
    gl_close(gl);
    matc_layout_free(layout);
}

/* -- far lights that are taken together */

static const double half_step = 1. / 510;

static const char halves[] = "light as halves";
static const FrameLamps far_cases[] = {
    {halves, FRAME_LAMPS_CAMERA "objects: [" FRAME_LAMPS_FLOOR("diffuse: [.6, .5, .4]") "]\n",
     "Point", 400, .3, 1.2, 5, 20, 1},
    {"over the greatest",
     FRAME_LAMPS_CAMERA
     "toneMapping: { toneMapping: Linear, exposure: 1 }\nobjects: [" FRAME_LAMPS_FLOOR(
         "diffuse: [.6, .5, .4]") "]\n",
     "Point", 400, .3, 1.2, 5, 20, 3},
    {"as film is exposed",
     FRAME_LAMPS_CAMERA "toneMapping: { toneMapping: Exponential }\nobjects: [" FRAME_LAMPS_FLOOR(
         "diffuse: [.6, .5, .4]") "]\n",
     "Point", 400, .3, 1.2, 5, 20, 1},
    {"a shoulder",
     FRAME_LAMPS_CAMERA "toneMapping: { toneMapping: Shoulder }\nobjects: [" FRAME_LAMPS_FLOOR(
         "diffuse: [.6, .5, .4]") "]\n",
     "Point", 400, .3, 1.2, 5, 20, 1},
    {"above a floor",
     FRAME_LAMPS_CAMERA "objects: [" FRAME_LAMPS_FLOOR("diffuse: [.6, .5, .4]") "]\n", "Point", 400,
     .3, 1.2, 5, 20, 1},
    {"a dark floor", FRAME_LAMPS_CAMERA "objects: [" FRAME_LAMPS_FLOOR("diffuse: .02") "]\n",
     "Point", 400, .3, 1.2, 5, 20, 1},
    {"just above it", FRAME_LAMPS_CAMERA "objects: [" FRAME_LAMPS_FLOOR("diffuse: .5") "]\n",
     "Point", 300, .004, .03, 5, 2, 1},
    {"below it", FRAME_LAMPS_CAMERA "objects: [" FRAME_LAMPS_FLOOR("diffuse: .5") "]\n", "Point",
     300, -1, .2, 5, 9, 1},
    {"seen at a grazing angle",
     "camera: { camera: Perspective, position: [0, -7, .2], target: [0, 0, 0] }\nobjects: "
     "[" FRAME_LAMPS_FLOOR("diffuse: .5") "]\n",
     "Point", 300, .3, 1, 5, 20, 1},
    {"gloss",
     FRAME_LAMPS_CAMERA
     "objects: [" FRAME_LAMPS_FLOOR("diffuse: .3, specular: .9, shininess: .95") "]\n",
     "Point", 300, .3, 1.2, 5, 9, 1},
    {"broad gloss",
     FRAME_LAMPS_CAMERA
     "objects: [" FRAME_LAMPS_FLOOR("diffuse: .1, specular: .5, shininess: .2") "]\n",
     "Point", 120, .3, 1.2, 5, 9, 1},
    {"gloss of few pixels",
     FRAME_LAMPS_ZOOM
     "objects: [" FRAME_LAMPS_FLOOR("diffuse: .3, specular: .7, shininess: .5") "]\n",
     "Point", 300, .6, 3, 6, 9, 1},
    {"sharper",
     FRAME_LAMPS_ZOOM
     "objects: [" FRAME_LAMPS_FLOOR("diffuse: .1, specular: .9, shininess: .8") "]\n",
     "Point", 300, 2, 6, 9, 30, 1},
    {"gloss of a ball",
     FRAME_LAMPS_ZOOM "objects: [{ object: Sphere, radius: 1, material: { material: Phong, "
                      "diffuse: .2, specular: .7, "
                      "shininess: .4 } }]\n",
     "Point", 300, 4, 9, 9, 60, 1},
    {"parallel rays on gloss",
     "camera: { camera: Orthographic, position: [.5, -6, 3], size: .5, depth: 40 }\nobjects: "
     "[" FRAME_LAMPS_FLOOR("diffuse: .2, specular: .7, shininess: .5") "]\n",
     "Point", 300, .6, 3, 6, 9, 1},
    {"shininess that varies",
     FRAME_LAMPS_ZOOM
     "objects: [" FRAME_LAMPS_FLOOR("diffuse: .3, specular: .7, shininess: { map: Checker, color1: "
                                    ".5, color2: .53, input: { map: UVTransform, "
                                    "scaleU: 300, scaleV: 300 } }") "]\n",
     "Point", 300, .6, 3, 6, 9, 1},
    {"gloss from infinitely far",
     "camera: { camera: Perspective, position: [.5, -6, 3], target: [0, 0, 0], angle: 12 "
     "}\nobjects: "
     "[" FRAME_LAMPS_FLOOR("diffuse: .1, specular: .9, shininess: .5") "]\n",
     "Directional", 100, 1, 2, 1, 1, 1},
    {"borders of cones", FRAME_LAMPS_CAMERA "objects: [" FRAME_LAMPS_FLOOR("diffuse: .5") "]\n",
     "Spot", 200, 3, 6, 4, 200, 1},
    {"spots among points",
     FRAME_LAMPS_CAMERA
     "objects: [" FRAME_LAMPS_FLOOR("diffuse: .5, specular: .2, shininess: .4") "]\n",
     FRAME_LAMPS_BOTH, 200, .5, 3, 5, 30, 1},
    {"from infinitely far",
     FRAME_LAMPS_CAMERA "objects: [" FRAME_LAMPS_FLOOR(
         "diffuse: .5") ", { object: Sphere, material: { material: Phong, diffuse: .7 } }]\n",
     "Directional", 100, 1, 2, 1, 1, 1},
    {"one is bright", FRAME_LAMPS_CAMERA "objects: [" FRAME_LAMPS_FLOOR("diffuse: .5") "]\n",
     "Point", 500, .3, 1.2, 5, 3, 3000},
    {"spheres before each other",
     FRAME_LAMPS_CAMERA "objects: [" FRAME_LAMPS_FLOOR(
         "diffuse: .5") ", { object: Scatter, count: 40, size: [6, 6, 1], seed: 3, objects: "
                        "[{ object: Sphere, radius: .2, material: { material: Phong, diffuse: [.9, "
                        ".4, .2] } }] }]\n",
     "Point", 300, .3, 3, 5, 20, 1},
    {"a checker of black and white",
     FRAME_LAMPS_CAMERA "objects: [" FRAME_LAMPS_FLOOR(
         "diffuse: { map: Checker, color1: 1, color2: 0, input: { map: UVTransform, scaleU: "
         "40, scaleV: 40 } }, specular: { map: Checker, color1: 0, color2: .2 }") "]\n",
     "Point", 300, .3, 1.2, 5, 20, 1},
    {"glass over it",
     FRAME_LAMPS_CAMERA "objects: [" FRAME_LAMPS_FLOOR(
         "diffuse: .5") ", { object: Box, size: [3, 3, .1], transform: { translation: [0, 0, .6] "
                        "}, "
                        "material: { material: RGBA, r: .9, g: .5, b: .2, a: .3 } }]\n",
     "Point", 300, .3, 1.2, 5, 20, 1},
    {"light from behind",
     FRAME_LAMPS_CAMERA
     "objects: [" FRAME_LAMPS_FLOOR("diffuse: .5, diffuseTransparency: [.5, .3, .1]") "]\n",
     "Point", 300, -1, 1, 5, 20, 1},
    {"parallel rays",
     "camera: { camera: Orthographic, position: [.5, -6, 3], size: 4, depth: 40 }\nobjects: "
     "[" FRAME_LAMPS_FLOOR("diffuse: .5") "]\n",
     "Point", 300, .3, 1.2, 5, 20, 1},
    {"a film, brighter",
     FRAME_LAMPS_CAMERA
     "toneMapping: { toneMapping: Filmic, exposure: 2 }\nobjects: [" FRAME_LAMPS_FLOOR(
         "diffuse: .5") "]\n",
     "Point", 400, .3, 1.2, 5, 3, 1},
    {"a film, darker",
     FRAME_LAMPS_CAMERA
     "toneMapping: { toneMapping: Filmic, exposure: -3 }\nobjects: [" FRAME_LAMPS_FLOOR(
         "diffuse: .5") "]\n",
     "Point", 400, .3, 1.2, 5, 60, 1},
};

/* The greatest component of so many pixels. */
static double greatest_of(const float *rgba, int pixels)
{
    double greatest = 1e-12;
    for (int i = 0; i < 4 * pixels; i++)
        greatest = fmax(greatest, i % 4 < 3 ? rgba[i] : 0);
    return greatest;
}

/* Error of a component, in half steps of a half float. */
static double half_off(double all, double bounded)
{
    int exponent;
    frexp(fmax(all, 6.2e-5), &exponent);
    return fabs(bounded - all) / (.5 * ldexp(1, exponent - 11));
}

/* A pixel's displayed component; `whole` is the picture's greatest, which the tone mapping
 * Linear scales to 1. */
static double shown(const Scene *scene, const float *pixel, int component, double whole)
{
    const double greatest =
        scene->tone == SCENE_Linear ? whole : scene->exposure * greatest_of(pixel, 1);
    return frame_lamps_encoded(
        frame_lamps_mapped(scene->tone, scene->exposure * pixel[component], greatest));
}

/* The most that a pixel is off, in half steps; *apart: how many components are. */
static double most_off(const Scene *scene, bool linear, float *const pictures[2], int *apart)
{
    const float *all = pictures[0], *bounded = pictures[1];
    const int pixels = scene->width * scene->height;
    const double whole[] = {greatest_of(all, pixels), greatest_of(bounded, pixels)};
    double most = 0;
    *apart = 0;
    for (int i = 0; i < 4 * pixels; i++) {
        const int first = i / 4 * 4, component = i % 4;
        assert_true(isfinite(bounded[i]));
        *apart += bounded[i] != all[i];
        most = fmax(most, linear ? half_off(all[i], bounded[i])
                                 : fabs(shown(scene, bounded + first, component, whole[1]) -
                                        shown(scene, all + first, component, whole[0])) /
                                       half_step);
    }
    return most;
}

/* Scenes made to attack the bound: no component of any pixel exceeds its error bound. */
static void far_lights_are_within_the_bound(void **state)
{
    (void)state;
    MatcLayout *layout;
    const MatcOptions options = frame_float_options(&layout);
    GlContext *gl = frame_context();
    int faults = 0;
    for (size_t i = 0; i < sizeof far_cases / sizeof *far_cases; i++) {
        const FrameLamps *c = &far_cases[i];
        MatcDocument *document;
        char *text = frame_lamps_text(c, 128, 88);
        int apart;
        Scene *scene = frame_scene(text, &options, &document);
        const bool linear = !strcmp(c->name, halves);
        RendererOptions drawn = {
            .compile = &options, .view = "light", .lights = "all", .linear = linear};
        float *all = frame_floats(gl, scene, &drawn);
        drawn.lights = "bounded";
        float *bounded = frame_floats(gl, scene, &drawn);
        const double most = most_off(scene, linear, (float *const[]){all, bounded}, &apart);
        print_message("%-30s %4.2f of half a step, %d components differ\n", c->name, most, apart);
        faults += !(most <= 1) || apart == 0; /* where all were summed nothing would be proved */
        free(all);
        free(bounded);
        free(text);
        frame_forget(scene, document);
    }
    gl_close(gl);
    matc_layout_free(layout);
    assert_int_equal(faults, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_light_counts),
                                       cmocka_unit_test(far_lights_are_within_the_bound)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
