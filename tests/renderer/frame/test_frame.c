/* Frames against a reference in double (frame/reference_light.h), with every pipeline variant;
 * the depth of planes; tone mapping; scenes that cannot be drawn. */
/* ctest: seconds=30 */
#include "tests/test.h"
#include "tests/frame/frame_compare.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* -- against the reference */

typedef struct {
    const char *name, *text;
} PictureCase;

#define CAMERA                                                                                     \
    "image: { width: 480, height: 320 }\ncamera: { camera: Perspective, position: [.5, -6, 2.5], " \
    "target: [0, 0, .5], "                                                                         \
    "angle: 40 }\n"
#define POINT                                                                                      \
    "lights: [{ light: Point, position: [1, -4, 4], color: [1, .8, .6], intensity: 12 }]\n"
#define MATT "{ material: Phong, diffuse: [.8, .6, .4] }"
/* Colors that the layout stores exactly, here and in all pictures: it has 16 bits for a diffuse
 * component, 10 for others. */
#define GLOSSY                                                                                     \
    "{ material: Phong, diffuse: [.2, .4, .6], specular: [0.3333333333333333, "                    \
    "0.6666666666666666, 1] }"
#define SHARP                                                                                      \
    "{ material: Phong, diffuse: [.2, .4, .6], specular: [0.3333333333333333, "                    \
    "0.6666666666666666, 1], shininess: .8 }"

static const PictureCase pictures[] = {
    {"sphere", CAMERA POINT "objects: [{ object: Sphere, material: " SHARP " }]\n"},
    {"box", CAMERA POINT "objects: [{ object: Box, size: [2, 1, 1.5], material: " GLOSSY
                         ", transform: { rotation: [.3, .2, .7] } }]\n"},
    {"round", CAMERA POINT "objects: [{ object: Cylinder, material: " MATT
                           ", transform: { translation: [-.8, 0, 0] } }, "
                           "{ object: Cone, material: " GLOSSY
                           ", transform: { translation: [.8, 0, 0], scale: [1, 2, 1.5] } }]\n"},
    {"plane", CAMERA POINT "objects: [{ object: Plane, material: " MATT
                           " }]\nsky: { material: RGBA, r: .1, g: .2, b: .5 }\n"},
    {"tilted", CAMERA POINT "objects: [{ object: Plane, material: " GLOSSY
                            ", transform: { rotation: [.2, .1, 0], translation: [0, 0, -.5], "
                            "scale: 2 } }, { object: Sphere, material: " MATT " }]\n"},
    {"far", "image: { width: 480, height: 320 }\ncamera: { camera: Perspective, position: [0, 0, "
            "1000], target: [1000, 0, "
            "900], "
            "near: .001 }\n"
            "objects: [{ object: Plane, material: " MATT
            " }]\nlights: [{ light: Directional, direction: [1, 1, -1] }]\n"},
    {"mirrored", CAMERA POINT "objects: [{ object: Cone, material: " GLOSSY
                              ", transform: { scale: [-3, 2, 2], shear: [.5, 0, 0] } }]\n"},
    {"from behind", CAMERA POINT "objects: [{ object: Parallelogram, u: [0, 2, 0], v: [2, 0, 0], "
                                 "transform: { translation: [-1, -1, 0] }, "
                                 "material: { material: Phong, diffuse: .2, diffuseTransparency: "
                                 "[1, 0.3333333333333333, 0] } }]\n"},
    {"behind it", CAMERA "lights: [{ light: Point, position: [0, 0, -2], intensity: 5 }]\nobjects: "
                         "[{ object: Parallelogram, u: [2, 0, 0], "
                         "v: [0, 2, 0], transform: { translation: [-1, -1, 0] }, material: { "
                         "material: Phong, diffuse: .3, "
                         "diffuseTransparency: [1, 0.3333333333333333, 0] } }]\n"},
    {"lights",
     CAMERA "lights:\n- { light: Spot, position: [0, -1, 4], direction: [0, .2, -1], innerAngle: "
            "10, outerAngle: 25, "
            "intensity: 20 }\n"
            "- { light: Directional, direction: [1, 2, -2], color: [.1, .2, .3] }\n- { light: "
            "Ambient, color: [.3, .2, .1] }\n"
            "- { light: Ambient, intensity: .1 }\n- { light: Point, position: [3, -3, 1], color: "
            "[.5, 0, 0], intensity: 3 }\n"
            "objects: [{ object: Plane, material: { material: Phong, diffuse: .6, ambient: "
            "[0.6666666666666666, "
            "0.3333333333333333, 1], "
            "emissive: [0, .0625, 0] } }, "
            "{ object: Box, material: " GLOSSY ", transform: { translation: [0, 0, .5] } }]\n"},
    {"area",
     CAMERA "lights:\n- { light: Area, position: [-2, 1, .5], u: [1, 2, 0], v: [.5, 0, 1.5], "
            "color: [3, 2, 1], "
            "bothSides: true, shadows: none }\n"
            "- { light: Area, position: [.2, -1, 3], u: [0, 1, .2], v: [1, 0, 0], intensity: 4, "
            "shadows: none }\n"
            "- { light: Area, position: [1, 0, .05], u: [-.5, 0, 0], v: [0, .5, 0], intensity: 9, "
            "shadows: none }\n"
            "objects: [{ object: Plane, material: " MATT " }, { object: Sphere, material: " GLOSSY
            ", transform: { translation: [0, 0, .5] } }, { object: Parallelogram, u: [0, 2, 0], v: "
            "[2, 0, 1], "
            "transform: { translation: [.5, -1, .1] }, material: { material: Phong, diffuse: .3, "
            "diffuseTransparency: [1, 0.3333333333333333, 0] } }]\n"},
    {"hemisphere", CAMERA
     "lights:\n- { light: Hemisphere, color: [.5, .7, 1], ground: [.4, .2, .1], intensity: .9 }\n"
     "- { light: Hemisphere, color: [.1, .1, 0] }\n- { light: Point, position: [1, -4, 4], "
     "intensity: 3 }\n"
     "objects: [{ object: Sphere, material: " SHARP
     " }, { object: Plane, material: { material: Phong, diffuse: [.2, .4, .6], ambient: "
     "[0.6666666666666666, 0.3333333333333333, 1], diffuseTransparency: [1, 0.3333333333333333, 0] "
     "} }]\n"},
    {"orthographic", "image: { width: 320, height: 480 }\ncamera: { camera: Orthographic, "
                     "position: [.5, -6, 2.5], size: "
                     "3, depth: 20 }\n" POINT "objects: [{ object: Box, material: " GLOSSY
                     ", transform: { rotation: [.3, .2, .7] } }, { object: Sphere, radius: .5, "
                     "material: " MATT ", transform: { translation: [0, 0, 1] } }]\n"},
    {"parallels to a plane",
     "image: { width: 320, height: 240 }\ncamera: { camera: Orthographic, position: [.5, -9, "
     "5], size: 6, depth: 40 }\n" POINT "objects: [{ object: Plane, material: " GLOSSY
     ", transform: { rotation: [.2, .1, .3], translation: [0, 0, -.5], scale: 2 } }, "
     "{ object: Sphere, material: " MATT " }]\nsky: { material: RGBA, r: .1, g: .2, b: .5 }\n"},
    {"a plane edge-on, and from below",
     "image: { width: 320, height: 240 }\ncamera: { camera: Orthographic, position: [0, -5, 0], "
     "size: 3, depth: 20 "
     "}\n" POINT "objects: [{ object: Plane, material: " GLOSSY
     " }, { object: Plane, material: " MATT
     ", transform: { rotation: [-1.4, 0, 0], translation: [0, 3, 0] } }]\n"},
    {"a checker along parallels", "image: { width: 320, height: 240 }\ncamera: { camera: "
                                  "Orthographic, position: [.5, -9, 9], size: 6, depth: 40 "
                                  "}\n" POINT "objects: [{ object: Plane, material: { material: "
                                  "Phong, diffuse: { map: Checker, color1: .8, color2: "
                                  ".4 } } }]\n"},
    {"maps", CAMERA POINT "objects: [{ object: Parallelogram, u: [4, 0, 0], v: [0, 4, 0], "
                          "transform: { translation: [-2, -2, 0] }, "
                          "material: "
                          "{ material: Phong, diffuse: { map: Checker, color1: .8, color2: .4, "
                          "input: { map: UVTransform, scaleU: 3 } } } "
                          "}, "
                          "{ object: Box, size: [2, 2, 2], material: { material: Phong, diffuse: { "
                          "map: Blend, input: { map: Wood }, "
                          "blend: [{ value: 0, input: .2 }, { value: 2, input: [.9, .6, .3] }] } "
                          "}, transform: { rotation: [0, 0, .7] } "
                          "}]\n"},
};

/* Compares all pictures with these options; half of the pixels within `median`. */
static void compare_all(const MatcOptions *options, double median)
{
    static Spread spread;
    GlContext *gl = frame_context();
    int faults = 0;
    for (size_t i = 0; i < sizeof pictures / sizeof *pictures; i++) {
        MatcDocument *document;
        Scene *scene = frame_scene(pictures[i].text, options, &document);
        float *rgba = frame_floats(
            gl, scene, &(RendererOptions){.compile = options, .view = "light", .no_shadows = true});
        compare(scene, options, rgba, &spread);
        faults += !is_close(pictures[i].name, median, &spread);
        free(rgba);
        frame_forget(scene, document);
    }
    gl_close(gl);
    assert_int_equal(faults, 0);
}

/* Normals are unquantized: half of the pixels are as accurate as in floats. */
static void against_the_reference(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    compare_all(&options, 4e-7);
}

/* Unquantized floats: the error of the passes themselves. */
static void in_floats(void **state)
{
    (void)state;
    MatcLayout *layout;
    const MatcOptions options = frame_float_options(&layout);
    compare_all(&options, 4e-7);
    matc_layout_free(layout);
}

/* Fragment and compute entries of full-screen passes agree, and so do both depth ranges of clip
 * space, except that one of them loses half of a float's bits. */
static void every_way(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(pictures[4].text, &options, &document);
    const size_t components = (size_t)scene->width * (size_t)scene->height * 4;
    GlContext *gl = frame_context();
    float *compute =
        frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
    float *fragment = frame_floats(
        gl, scene, &(RendererOptions){.compile = &options, .view = "light", .fragment = true});
    gl->ClipControl = NULL;
    float *old = frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
    size_t apart = 0;
    for (size_t i = 0; i < components; i++) {
        assert_true(fabsf(compute[i] - fragment[i]) <= 1e-6f * fabsf(compute[i]) + 1e-7f);
        /* depth is within 6e-8, of 0.0015 at a distance of 6.5 */
        apart += fabsf(compute[i] - old[i]) > 2e-3f;
    }
    assert_true(apart < components / 1000);
    free(compute);
    free(fragment);
    free(old);
    gl_close(gl);
    frame_forget(scene, document);
}

/* -- the depth of planes */

/* Depth is near / distance, for a plane 1 below the eye: within 4 ULP of the ray in double, up
 * to the horizon, with both depth ranges. */
static void planes_are_deep(void **state)
{
    (void)state;
    enum { SIZE = 256 };
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(
        "image: { width: 256, height: 256 }\ncamera: { camera: Perspective, position: [0, 0, 1], "
        "target: [0, 1, 1], "
        "angle: 90, near: .25 }\nobjects: [{ object: Plane, material: { material: Phong } }]\n",
        &options, &document);
    GlContext *gl = frame_context();
    for (int old = 0; old < 2; old++) {
        if (old)
            gl->ClipControl = NULL;
        float *rgba =
            frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "depth"});
        for (int i = 0; i < SIZE * SIZE; i++) {
            const double down =
                /* of the ray whose length along the view is 1 */
                -(2 * (i / SIZE) + 1 - SIZE) / (double)SIZE;
            const double expected = down > 0 ? .25 * down : 0;
            assert_true(fabs(rgba[4 * i] - expected) <= 4 * 6e-8 * expected);
        }
        free(rgba);
    }
    gl_close(gl);
    frame_forget(scene, document);
}

/* A plane casts no shadow on itself at any distance, with both depth ranges. One camera is a
 * thousand units from the world's origin, where floats are 6e-5 apart, with a near plane at 0.1. */
static void planes_are_lit(void **state)
{
    (void)state;
    static const char *const cameras[] = {
        "position: [0, 0, 1], target: [0, 1, 1], near: .25",
        "position: [1000, -800, 300], target: [3, 9, 220], near: .1"};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (int k = 0; k < 4; k++) {
        char text[1024];
        MatcDocument *document;
        float *lit[2];
        size_t seen = 0;
        if (k == 2)
            gl->ClipControl = NULL;
        for (int shadows = 0; shadows < 2; shadows++) {
            snprintf(text, sizeof text,
                     "image: { width: 64, height: 64 }\ncamera: { camera: Perspective, angle: 90, "
                     "%s }\nlights: [{ light: "
                     "Directional, direction: [.3, .4, -1], shadows: %s }]\nobjects: [{ object: "
                     "Plane, material: { "
                     "material: Phong } }]\n",
                     cameras[k % 2], shadows ? "true" : "false");
            Scene *scene = frame_scene(text, &options, &document);
            lit[shadows] =
                frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
            frame_forget(scene, document);
        }
        for (int i = 0; i < 4 * 64 * 64; i++) {
            seen += lit[0][i] > 0;
            assert_true(fabsf(lit[0][i] - lit[1][i]) <= 1e-6f);
        }
        assert_true(seen >= 4 * 64 * 32);
        free(lit[0]);
        free(lit[1]);
    }
    gl_close(gl);
}

/* -- tones and faults */

/* The middle of a plane that faces the eye: sRGB of a clamped or filmic value, by hand. */
static void tones(void **state)
{
    (void)state;
    static const struct {
        const char *mapping;
        double shown;
    } cases[] = {{"Clamp", 0.5371},
                 {"Clamp, exposure: 1", 0.7354},
                 {"Clamp, exposure: 3", 1},
                 {"Filmic", 0.6473},
                 {"Filmic, exposure: 10", 1}};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1024];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 "image: { width: 8, height: 8 }\ncamera: { camera: Perspective, position: [0, 0, "
                 "5], up: [0, 1, 0] }\n"
                 "lights: [{ light: Directional, intensity: .25 }]\nobjects: [{ object: Plane, "
                 "material: { material: "
                 "RGBA, r: 1, g: 1, b: 1 } }]\n"
                 "toneMapping: { toneMapping: %s }\n",
                 cases[i].mapping);
        Scene *scene = frame_scene(text, &options, &document);
        float *rgba = frame_floats(gl, scene, &(RendererOptions){.compile = &options});
        if (!(fabs(rgba[4 * 36] - cases[i].shown) < .0025))
            fail_msg("%s: %g", cases[i].mapping, rgba[4 * 36]);
        free(rgba);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* Scenes that cannot be drawn are errors, and leave nothing. An empty scene is none. */
static void faults(void **state)
{
    (void)state;
    static const struct {
        const char *text, *reported;
    } cases[] = {
        {"objects: [{ object: Box, material: { material: RGBA, a: .5 } }]\n", NULL},
        {"image: { width: 16384, height: 2 }\nlights: []\n", NULL},
        {"lights: []\n", NULL},
    };
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcDocument *document;
        Scene *scene = frame_scene(cases[i].text, &options, &document);
        Renderer *renderer = renderer_open(gl, &(RendererOptions){.compile = &options});
        const bool done = renderer_set_scene(renderer, scene) && renderer_frame(renderer);
        assert_int_equal(done, cases[i].reported == NULL);
        if (cases[i].reported)
            assert_string_equal(gl->error, cases[i].reported);
        renderer_close(renderer);
        assert_true(gl_check(gl, "all of it"));
        frame_forget(scene, document);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(against_the_reference),
        cmocka_unit_test(in_floats),
        cmocka_unit_test(every_way),
        cmocka_unit_test(planes_are_deep),
        cmocka_unit_test(planes_are_lit),
        cmocka_unit_test(tones),
        cmocka_unit_test(faults),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
