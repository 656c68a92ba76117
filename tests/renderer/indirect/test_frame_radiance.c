/* Light of surfaces outside the picture: no leaks through walls; surfaces behind the camera, and
 * infinite planes, send the light that rays in double find; after a change the light equals that
 * of a new renderer. */
/* ctest: unsanitized seconds=40 */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/open_ray.h"
#include "tests/frame_reference/shadow_ray.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = 64, PIXELS = EDGE * EDGE, TEXT = 4096, COMPONENTS = 4 };
#define IMAGE "image: { width: 64, height: 64 }\n"

/* Maximum of red, green and blue. */
static double brightest(const float *rgba)
{
    double most = 0;
    for (int i = 0; i < COMPONENTS * PIXELS; i++)
        if (i % COMPONENTS < 3) {
            assert_true(isfinite(rgba[i]));
            most = fmax(most, rgba[i]);
        }
    return most;
}

static double mean_of(const float *rgba, int component)
{
    double sum = 0;
    for (int i = component; i < COMPONENTS * PIXELS; i += COMPONENTS)
        sum += rgba[i] / PIXELS;
    return sum;
}

static double brightest_of(GlContext *gl, const char *text, double *mean)
{
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(text, &options, &document);
    float *rgba = frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
    const double most = brightest(rgba);
    *mean = mean_of(rgba, 1);
    free(rgba);
    frame_forget(scene, document);
    return most;
}

/* -- walls */

/* Six slabs that intersect in their corners, around a cube of edge 2; two lights outside, and a
 * distant box, so that a voxel of 64 is 0.068 wide. */
static void put_room(double wall, const char *shadows, const char *rotation, char text[TEXT])
{
    int length = snprintf(
        text, TEXT,
        IMAGE
        "voxels: { size: 64 }\nindirect: { rays: 24, radius: 8, bounces: 2 }\nlights:\n"
        "- { light: Point, position: [2.3, -1.9, 2.2], intensity: 60, shadows: %s }\n"
        "- { light: Directional, direction: [1, .4, -.7], intensity: 5, shadows: %s }\n"
        "materials:\n  m: { material: Phong, diffuse: .8, specular: 0 }\nobjects:\n"
        "- { object: Box, material: m, size: [.2, .2, .2], transform: { translation: [3, 3, 3] "
        "} }\n- object: Group\n  material: m\n  transform: { rotation: [%s] }\n  objects:\n",
        shadows, shadows, rotation);
    for (int i = 0; i < 6; i++) {
        double size[3], at[3] = {0};
        for (int k = 0; k < 3; k++)
            size[k] = k == i / 2 ? wall : 2 + 2 * wall;
        at[i / 2] = (i % 2 ? 1 : -1) * (1 + wall / 2);
        length += snprintf(text + length, (size_t)(TEXT - length),
                           "  - { object: Box, size: [%.9g, %.9g, %.9g], transform: { translation: "
                           "[%.9g, %.9g, %.9g] } }\n",
                           size[0], size[1], size[2], at[0], at[1], at[2]);
    }
}

/* Light is below the value that sRGB rounds to 1 of 255. Maps light the rim of a wall's inner face
 * where it ends within the next wall, two of their texels or less below what is outside: in the
 * room whose walls are 1.5 voxels thick a ray from within meets a voxel that has such a node. Of 52
 * rooms with walls of 0.03 to 0.3 it is the only one in which anything is seen. */
static void nothing_shines_through_walls(void **state)
{
    (void)state;
    static const char camera[] =
        "camera: { camera: Perspective, position: [%s], target: [0, .5, 0], angle: 80 }\n";
    static const char *const rotations[] = {"0, 0, 0", ".4, .7, .3"};
    static const struct {
        double wall;
        const char *shadows;
        double most; /* max light, in units of the value that sRGB rounds to 1 */
    } cases[] = {{.02, "exact", 0}, {.06, "exact", 0}, {.09, "exact", 0},
                 {.12, "exact", 0}, {.07, "map", 1},   {.12, "map", 1.5}};
    double mean, black = 1.5 / 255 / 12.92;
    GlContext *gl = frame_context();
    for (size_t i = 0; i < 2 * sizeof cases / sizeof *cases; i++) {
        char room[TEXT], text[2 * TEXT];
        put_room(cases[i / 2].wall, cases[i / 2].shadows, rotations[i % 2], room);
        int length = snprintf(text, sizeof text, camera, "0, -.8, .1");
        snprintf(text + length, sizeof text - (size_t)length, "%s", room);
        const double within = brightest_of(gl, text, &mean);
        print_message("walls of %.2f, shadows %s: %.2g of black\n", cases[i / 2].wall,
                      cases[i / 2].shadows, within / black);
        assert_true(within <= cases[i / 2].most * black);
        length = snprintf(text, sizeof text, camera, "4, -4, 3");
        snprintf(text + length, sizeof text - (size_t)length, "%s", room);
        if (i == 0)
            assert_true(brightest_of(gl, text, &mean) > .5);
    }
    gl_close(gl);
}

/* -- behind the camera */

/* A visible white wall; behind the eye a two-sided sheet, a mirrored box with a pattern, a ball,
 * and their occluders. */
static const char behind[] =
    IMAGE "camera: { camera: Perspective, position: [0, -.5, 1], target: [0, 2, 1], angle: 50 "
          "}\nindirect: { rays: 96, "
          "radius: 9, filterSize: 4 }\nlights:\n- { light: Spot, position: [.5, .5, 3], direction: "
          "[-.1, -.8, -.6], "
          "intensity: 20, innerAngle: 50, outerAngle: 65, shadows: exact }\n- { light: Area, "
          "position: [-2, 0, 3], u: "
          "[.5, 0, 0], v: [0, .5, 0], intensity: 60, shadows: none }\nobjects:\n"
          "- { object: Box, size: [4, .2, 4], material: { material: Phong, diffuse: .9, specular: "
          "0 }, transform: { "
          "translation: [0, 2, 1] } }\n"
          "- { object: Parallelogram, u: [3, 0, 0], v: [0, .8, 2.2], material: { material: "
          "SideSwitch, frontShader: { "
          "material: Phong, diffuse: [.9, .1, .1], specular: 0 }, backShader: { material: Phong, "
          "diffuse: [.1, .1, .9], "
          "specular: 0 } }, transform: { translation: [-1.5, -2.4, 0] } }\n"
          "- { object: Box, size: [1, 1, .3], material: { material: Phong, specular: 0, diffuse: { "
          "map: Checker, "
          "color1: [.1, .9, .2], color2: .2, input: { map: UVTransform, scaleU: 2, scaleV: 2 } } "
          "}, transform: { "
          "translation: [1, -.6, .1], scale: [-1, 1, 1], rotation: [.2, .1, .3] } }\n"
          "- { object: Sphere, radius: .4, material: { material: Phong, diffuse: .8, specular: 0, "
          "emissive: [0, 0, .2] "
          "}, transform: { translation: [-.8, -1.1, .9] } }\n";

static void shares_of(const Tracer *tracer, const SceneLight *light, const Hit *hit,
                      double shares[3])
{
    const bool lit = light->shadows == KEYWORD_Shadows_none ||
                     shadow_is_lit(tracer, light, hit->world, hit->microfacet);
    shares[0] = shares[1] = shares[2] = lit;
}

typedef struct {
    /* of the truth, of the picture; root of the mean square of the difference */
    double mean, is, square;
    int count;
} Off;

/* Error at pixels of object 0, 5 apart, against `rays.across` squared rays: ambient occlusion,
 * or light. */
static Off off_by(GlContext *gl, const char *text, bool light, OpenRays rays)
{
    enum { APART = 5 };
    const MatcOptions options = frame_exact_options();
    Off off = {.count = 0};
    MatcDocument *document;
    Scene *scene = frame_scene(text, &options, &document);
    Tracer tracer = reference_open(scene);
    tracer.shares = shares_of;
    float *rgba = frame_floats(
        gl, scene, &(RendererOptions){.compile = &options, .view = light ? "indirect" : "ao"});
    for (int y = APART / 2; y < EDGE; y += APART)
        for (int x = APART / 2; x < EDGE; x += APART) {
            const Ray ray = reference_ray(scene, x + .5, y + .5);
            const Hit hit = reference_hit(&tracer, &ray, 0);
            if (hit.object != 0)
                continue;
            rays.state = (uint64_t)(y * EDGE + x);
            const Open open = open_ray(&tracer, &hit, &rays, light ? &options : NULL);
            for (int k = 0; k < (light ? 3 : 1); k++, off.count++) {
                const double is = rgba[COMPONENTS * (y * EDGE + x) + k],
                             truth = light ? open.light[k] : open.open;
                off.mean += truth;
                off.is += is;
                off.square += (is - truth) * (is - truth);
            }
        }
    off.mean /= off.count;
    off.is /= off.count;
    off.square = sqrt(off.square / off.count);
    print_message("%s: mean %.3g of %.3g, root of the mean square %.3g, of %d numbers\n",
                  light ? "light" : "openness", off.is, off.mean, off.square, off.count);
    reference_close(&tracer);
    free(rgba);
    frame_forget(scene, document);
    return off;
}

static void what_is_behind_the_camera_sends(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    const Off off = off_by(gl, behind, true, (OpenRays){.across = 32, .radius = 9, .bounces = 1});
    assert_true(off.count > 100 && off.mean > .01);
    assert_true(fabs(off.is / off.mean - 1) < .05 && off.square < .1 * off.mean);
    gl_close(gl);
}

/* -- infinite planes */

/* A wall on a ground and next to another wall, with its whole neighborhood visible. */
static const char grounded[] = IMAGE
    "camera: { camera: Perspective, position: [1.2, -6, 2.5], target: [-.3, 0, %s }\nlights:\n- { "
    "light: Point, position: [0, -2, 2.5], intensity: 10, shadows: exact }\nindirect: { rays: 64, "
    "radius: 2, "
    "method: %s }\nobjects:\n"
    "- { object: Box, size: [3, .5, 2], material: { material: Phong, diffuse: .8, specular: 0 }, "
    "transform: { "
    "translation: [0, 0, 1] } }\n"
    "- { object: Plane, material: { material: Phong, diffuse: [.8, .3, .1], specular: 0 } }\n"
    "- { object: Plane, material: { material: Phong, diffuse: [.1, .3, .8], specular: 0 }, "
    "transform: { "
    "translation: [-2.2, 0, 0], rotation: [0, 1.5, 0] } }\n";

static void rays_meet_infinite_planes(void **state)
{
    (void)state;
    static const char *const methods[] = {"voxels", "hybrid"};
    GlContext *gl = frame_context();
    for (int i = 0; i < 2; i++) {
        char text[TEXT];
        snprintf(text, sizeof text, grounded, ".9], angle: 60", methods[i]);
        const Off open = off_by(gl, text, false, (OpenRays){.across = 32, .radius = 2});
        const Off light =
            off_by(gl, text, true, (OpenRays){.across = 32, .radius = 2, .bounces = 1});
        assert_true(open.count > 10 && open.mean < .9 && open.square < .015);
        assert_true(light.mean > .02 && fabs(light.is / light.mean - 1) < .03 &&
                    light.square < .06 * light.mean);
    }
    gl_close(gl);
}

/* A picture of the wall's upper half alone: rays hit the planes, but the light that these send
 * is unknown. */
static void planes_beside_the_picture_are_black(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    char text[TEXT];
    snprintf(text, sizeof text, grounded, "1.5], angle: 12", "voxels");
    const Off open = off_by(gl, text, false, (OpenRays){.across = 32, .radius = 2});
    const Off light = off_by(gl, text, true, (OpenRays){.across = 32, .radius = 2, .bounces = 1});
    print_message("beside the picture: openness %.3f of %.3f, light of planes %.4f of %.4f\n",
                  open.is, open.mean, light.is, light.mean);
    assert_true(open.count > 10 && open.square < .015 && light.mean > .02 &&
                light.is < .1 * light.mean);
    gl_close(gl);
}

/* -- what is thinner than voxels */

/* A fence of bars, wires and a pole over a ground of edge 3, whose voxels of 128 are 0.024 wide:
 * bars of 1.7 voxels, wires of 0.4. As voxels they are wider, and occlude and send more: the
 * error is 0.05 of ambient occlusion, and a fifth of the little light that they send. With 256
 * voxels ambient occlusion is off by 0.04. */
static void fences_and_wires_keep_off_a_voxel_more(void **state)
{
    (void)state;
    static const struct {
        int size;
        double open, light;
    } cases[] = {{128, .08, .25}, {256, .055, .25}};
    GlContext *gl = frame_context();
    for (int i = 0; i < 2; i++) {
        char text[TEXT];
        int length = snprintf(text, TEXT,
                              IMAGE "camera: { camera: Perspective, position: [0, -3, 3], target: "
                                    "[0, 0, 0], angle: 45 }\nvoxels: "
                                    "{ size: %d }\nlights:\n- { light: Point, position: [.3, -1, "
                                    "1.5], intensity: 5, shadows: "
                                    "exact }\nindirect: { rays: 64, radius: 1.5, method: voxels "
                                    "}\nmaterials: { m: { material: "
                                    "Phong, diffuse: [.9, .6, .3], specular: 0 } }\nobjects:\n- { "
                                    "object: Box, material: m, "
                                    "size: [3, 3, .2], transform: { translation: [0, 0, -.1] } }\n",
                              cases[i].size);
        for (int k = 0; k < 9; k++)
            length += snprintf(text + length, (size_t)(TEXT - length),
                               "- { object: Box, material: m, size: [.04, .04, .7], transform: { "
                               "translation: [%.3g, .2, "
                               ".35] } }\n- { object: Box, material: m, size: [2.6, .01, .01], "
                               "transform: { translation: "
                               "[0, -.3, %.3g], rotation: [.3, 0, .05] } }\n",
                               .3 * k - 1.2, .1 + .06 * k);
        const Off open = off_by(gl, text, false, (OpenRays){.across = 32, .radius = 1.5});
        const Off light =
            off_by(gl, text, true, (OpenRays){.across = 24, .radius = 1.5, .bounces = 1});
        assert_true(open.count > 50 && open.mean < .97 && open.square < cases[i].open);
        assert_true(light.mean > .002 && fabs(light.is / light.mean - 1) < cases[i].light);
    }
    gl_close(gl);
}

/* -- what is hostile */

/* An open shell; what is flat, or so small or far away that it is nothing of a voxel; a million
 * triangles in a voxel; a voxel that is larger than all that is seen: light is finite, what a lamp
 * reaches is not black, and in the mean the picture is two thirds to one and a half times as light
 * as without. */
static void hostile_scenes_are_lit(void **state)
{
    (void)state;
    static const char head[] =
        IMAGE "camera: { camera: Perspective, position: [1, -5, 2], target: [1, 0, 0], angle: 50 "
              "}\nvoxels: { size: 32 "
              "}\nindirect: { rays: 8, bounces: 2 }\nlights:\n- { light: Point, position: [2, -3, "
              "4], intensity: 30 "
              "}\n- { light: Hemisphere, color: 1, ground: .5 }\nmaterials: { m: { material: "
              "Phong, diffuse: .6 } "
              "}\nobjects:\n- { object: Box, material: m, transform: { translation: [2, 0, 0] } "
              "}\n- { object: Box, "
              "material: m, size: [20, 20, .2], transform: { translation: [0, 0, -1.1] } }\n";
    static const char *const scenes[] = {
        "- { object: Mesh, file: " SOURCE_FOLDER "/examples/scenes/shell.obj, material: m }\n",
        "- { object: Sphere, material: m, transform: { scale: [1, 1, 1e-9] } }\n",
        "- { object: Sphere, detail: 1000, material: m, transform: { scale: 1e-3 } }\n",
        "- { object: Sphere, material: m, transform: { translation: [1e9, 1e9, -1e9] } }\n",
        "- { object: Box, material: m, size: [1e9, 1e9, 1e9], transform: { translation: [2e9, 0, "
        "0] } }\n",
        "- { object: Sphere, material: m, transform: { scale: [-1, 1e-30, 1] } }\n"};
    GlContext *gl = frame_context();
    double mean, alone, most = brightest_of(gl, head, &alone);
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        char text[TEXT];
        snprintf(text, sizeof text, "%s%s", head, scenes[i]);
        most = brightest_of(gl, text, &mean);
        print_message("hostile scene %d: %.3g, mean %.3g of that without\n", (int)i, most,
                      mean / alone);
        assert_true(most > .5 && mean > alone / 1.5 && mean < alone * 1.5 && !gl->GetError());
    }
    gl_close(gl);
}

/* -- behind glass */

/* A pane in front of the eye transmits half and emits nothing: the picture is half of that
 * without it, including indirect and dimmed light. */
static void glass_halves_what_is_behind_it(void **state)
{
    (void)state;
    enum { MIDDLE = 8 };
    static const char pane[] =
        "- { object: Box, size: [9, .01, 9], material: { material: Phong, diffuse: 0, specular: 0, "
        "transparency: .70710678 }, transform: { translation: [0, -3, 0] } }\n";
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    float *rgba[2];
    double most = 0, lit = INFINITY;
    for (int i = 0; i < 2; i++) {
        char text[TEXT];
        MatcDocument *document;
        int length = snprintf(text, sizeof text, grounded, ".9], angle: 60", "hybrid");
        snprintf(text + length, sizeof text - (size_t)length, "%s", i ? pane : "");
        Scene *scene = frame_scene(text, &options, &document);
        rgba[i] = frame_floats(
            gl, scene, &(RendererOptions){.compile = &options, .view = "light", .deep = true});
        frame_forget(scene, document);
    }
    for (int i = 0; i < COMPONENTS * PIXELS; i++) {
        const int x = i / COMPONENTS % EDGE, y = i / COMPONENTS / EDGE;
        /* the wall */
        if (i % COMPONENTS < 3 && abs(x - EDGE / 2) < MIDDLE && abs(y - EDGE / 2) < MIDDLE) {
            most = fmax(most, fabs(rgba[1][i] / (.5 * rgba[0][i]) - 1));
            lit = fmin(lit, rgba[0][i]);
        }
    }
    print_message("behind glass: at most %.2g of half of it off, which is %.2g at least\n", most,
                  lit);
    assert_true(lit > .01 && most < 2e-3);
    free(rgba[0]);
    free(rgba[1]);
    gl_close(gl);
}

/* -- changes */

static void assert_as_new(GlContext *gl, Renderer *renderer, const Scene *scene,
                          const RendererOptions *options)
{
    float *as_new = frame_floats(gl, scene, options),
          *rgba = malloc(sizeof *rgba * COMPONENTS * PIXELS);
    assert_true(renderer_frame(renderer) && renderer_read(renderer, rgba));
    assert_memory_equal(as_new, rgba, sizeof *rgba * COMPONENTS * PIXELS);
    free(rgba);
    free(as_new);
}

/* Also with multiple bounces and changing emission: threads find nodes in a different order each
 * time, which must not influence the result. */
static void what_changes_is_as_new(void **state)
{
    (void)state;
    static const char key[] = "indirect: {";
    static const char reddens[] = "- { object: Box, size: [.6, .6, .6], material: { material: "
                                  "Phong, specular: 0, diffuse: \"= [.2 + .3 * time, "
                                  ".4, .3]\" }, transform: { translation: [.9, -1.3, 1.2] } }\n";
    char text[sizeof behind + TEXT];
    const char *at = strstr(behind, key) + strlen(key);
    snprintf(text, sizeof text, "%.*s bounces: 3,%s%s", (int)(at - behind), behind, at, reddens);
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "indirect"};
    GlContext *gl = frame_context();
    MatcDocument *document;
    Scene *scene = frame_scene(text, &options, &document);
    Renderer *renderer = renderer_open(gl, &how);
    assert_non_null(renderer);
    assert_true(renderer_set_scene(renderer, scene));
    assert_as_new(gl, renderer, scene, &how);
    scene->objects[2].world_from_local.m[13] += .3;
    assert_true(renderer_changed_objects(renderer, 2, 1));
    assert_as_new(gl, renderer, scene, &how);
    scene->lights[0].position[0] -= .7;
    assert_true(renderer_changed(renderer, RENDERER_LIGHTS));
    assert_as_new(gl, renderer, scene, &how);
    float *before = malloc(sizeof *before * COMPONENTS * PIXELS),
          *rgba = malloc(sizeof *rgba * COMPONENTS * PIXELS);
    assert_true(before && rgba && renderer_read(renderer, before));
    scene->time = 2;
    assert_true(renderer_changed(renderer, RENDERER_TIME));
    assert_as_new(gl, renderer, scene, &how);
    assert_true(renderer_read(renderer, rgba) && mean_of(rgba, 0) > 1.01 * mean_of(before, 0));
    /* blue goes on by the blue of what it meets */
    assert_true(fabs(mean_of(rgba, 2) / mean_of(before, 2) - 1) < .01);
    free(before);
    free(rgba);
    renderer_close(renderer);
    frame_forget(scene, document);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_shines_through_walls),
        cmocka_unit_test(what_is_behind_the_camera_sends),
        cmocka_unit_test(rays_meet_infinite_planes),
        cmocka_unit_test(planes_beside_the_picture_are_black),
        cmocka_unit_test(fences_and_wires_keep_off_a_voxel_more),
        cmocka_unit_test(hostile_scenes_are_lit),
        cmocka_unit_test(glass_halves_what_is_behind_it),
        cmocka_unit_test(what_changes_is_as_new),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
