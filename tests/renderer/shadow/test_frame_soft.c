/* Soft shadows of area lights, against Embree's rays to all of a light. The error is a share of
 * the unshadowed light, which is the reference's, in double. `build/tests/test_frame_soft SEED
 * SIZE` takes other rays and other pixels, and maps of that size; only size 512 has bounds. */
/* ctest: unsanitized seconds=28 */
#include "tests/test.h"
#include "tests/frame/frame_change.h"
#include "tests/frame_reference/glass_ray.h"
#include "tests/frame_reference/reference_light.h"
#include "tests/frame_reference/soft_ray.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 96, HEIGHT = 72, STEP = 11, RAYS = 32, TEXT = 6144 };

enum { MAPS = 512 };
static uint64_t seed = 1;
static int map_size = MAPS;

#define CAMERA                                                                                     \
    "image: { width: 96, height: 72 }\n"                                                           \
    "camera: { camera: Perspective, position: [1.5, -7, 4], target: [0, 0, .5], angle: 42 }\n"
#define GROUND                                                                                     \
    "- { object: Parallelogram, u: [8, 0, 0], v: [0, 8, 0], material: m, transform: { "            \
    "translation: [-4, -4, 0] } }\n"
#define PLANE "- { object: Plane, material: m }\n"
#define BOX                                                                                        \
    "- { object: Box, material: m, transform: { translation: [0, 0, .5], rotation: [0, 0, .3] } "  \
    "}\n"
#define BALL                                                                                       \
    "- { object: Sphere, radius: .5, material: m, transform: { translation: [0, 0, 1.3] } }\n"
#define TWO                                                                                        \
    "- { object: Sphere, radius: .4, material: m, transform: { translation: [-.3, 0, 1.6] } }\n"   \
    "- { object: Box, size: [.5, 1.5, .1], material: m, transform: { translation: [.2, 0, .6] } "  \
    "}\n"
#define RODS                                                                                       \
    "- { object: Cylinder, radius: .03, height: 1.5, material: m, transform: { translation: "      \
    "[-.5, 0, 0] } }\n"                                                                            \
    "- { object: Box, size: [2, .04, .04], material: m, transform: { translation: [0, -.4, .8] } " \
    "}\n"                                                                                          \
    "- { object: Box, size: [.04, 2, .04], material: m, transform: { translation: [.6, 0, .3] } "  \
    "}\n"
#define SHEET                                                                                      \
    "- { object: Parallelogram, u: [1.5, 0, 0], v: [0, 0, 1], material: m, transform: { "          \
    "translation: [-.7, -.2, 0] } "                                                                \
    "}\n"
#define ROOF                                                                                       \
    "- { object: Plane, material: m, transform: { translation: [0, -1, 4], rotation: [0, 1.4, 0] " \
    "} }\n"
#define PANES                                                                                      \
    "- { object: Parallelogram, u: [2, 0, 0], v: [0, 1.5, 0], material: clear, transform: { "      \
    "translation: [-1, -1, 1] "                                                                    \
    "} "                                                                                           \
    "}\n"                                                                                          \
    "- { object: Parallelogram, u: [1, 0, 0], v: [0, 1, 0], material: dim, transform: { "          \
    "translation: [-.7, -.7, .6] "                                                                 \
    "} "                                                                                           \
    "}\n"
#define CUT                                                                                        \
    "- { object: Parallelogram, u: [2, 0, 0], v: [0, 2, 0], material: coarse, transform: { "       \
    "translation: [-1, -1, "                                                                       \
    ".8] } }\n"

#define SMALL                                                                                      \
    "{ light: Area, position: [-.15, -1.15, 4], u: [0, .3, 0], v: [.3, 0, 0], intensity: 9 }"
#define MIDDLE "{ light: Area, position: [-.5, -1.5, 4], u: [0, 1, 0], v: [1, 0, 0], intensity: 9 }"

#define LARGE "{ light: Area, position: [-1.5, -1.5, 3], u: [0, 3, 0], v: [3, 0, 0], intensity: 9 }"
#define CLOSE                                                                                      \
    "{ light: Area, position: [-1.5, -1.5, 2.1], u: [0, 3, 0], v: [3, 0, 0], intensity: 9 }"
#define WALL "{ light: Area, position: [-2.5, -1, 0], u: [0, 2, 0], v: [0, .3, 2], intensity: 9 }"
#define FENCE                                                                                      \
    "{ light: Area, position: [-1.2, -1.5, -.5], u: [0, 3, 0], v: [.5, 0, 2], intensity: 9, "      \
    "bothSides: true }"

/* Measured errors, the worst of the seeds 1 to 6; the bound is twice that. */
typedef struct {
    const char *name, *light, *objects[2], *maps;
    double rms, most;
    bool glass;
} Case;

static const Case cases[] = {
    {"box, small", SMALL, {GROUND, BOX}, "", .0017, .031, false},
    {"box, middle", MIDDLE, {GROUND, BOX}, "", .0012, .020, false},
    {"box, large", LARGE, {GROUND, BOX}, "", .0018, .021, false},
    {"two, middle", MIDDLE, {GROUND, TWO}, "", .0072, .091, false},
    {"two, large", LARGE, {GROUND, TWO}, "", .0063, .057, false},
    {"a sheet upright", MIDDLE, {GROUND, SHEET}, "", .0019, .036, false},
    {"large and close", CLOSE, {GROUND, TWO}, "", .0166, .072, false},
    {"from the ground", WALL, {GROUND, BOX}, "", .0064, .056, false},
    {"through it", FENCE, {GROUND, BOX}, "", .0217, .125, false},
    {"81 points", CLOSE, {GROUND, TWO}, ", areaPoints: 9", .0054, .028, false},
    {"ball, small", SMALL, {GROUND, BALL}, "", .0027, .046, false},
    {"ball, middle", MIDDLE, {GROUND, BALL}, "", .0019, .022, false},
    {"ball, large", LARGE, {GROUND, BALL}, "", .0047, .039, false},
    {"rods, middle", MIDDLE, {GROUND, RODS}, "", .0099, .156, false},
    {"rods, large", LARGE, {GROUND, RODS}, "", .0171, .227, false},
    {"below a plane", MIDDLE, {ROOF, BOX}, "", .0040, .050, false},
    {"panes", MIDDLE, {GROUND, PANES}, "", .0043, .049, true},
    {"a cut-out", MIDDLE, {GROUND, CUT}, "", .0032, .042, true},
};
enum { CASES = sizeof cases / sizeof *cases };

/* A layout of the materials' slots only, so that programs are small. */
static MatcOptions lean_options(void)
{
    MatcOptions options = frame_exact_options();
    options.layout = NULL;
    return options;
}

typedef struct {
    double most, squares;
    int count, soft;
} Error;

static Scene *scene_of(const Case *c, const MatcOptions *options, MatcDocument **document)
{
    char text[TEXT];
    size_t size = (size_t)snprintf(text, TEXT,
                                   CAMERA "lights: [%s]\nshadowMaps: { size: %d%s }\nmaterials:\n",
                                   c->light, map_size, c->maps);
    for (int i = 0; i < GLASS_COUNT; i++)
        size += (size_t)snprintf(text + size, TEXT - size, "  %s\n", glass_text(i));
    snprintf(text + size, TEXT - size, "objects:\n%s%s", c->objects[0], c->objects[1]);
    return frame_scene(text, options, document);
}

/* Reference of a picture. */
typedef struct {
    const Case *row;
    const Tracer *tracer;
    const MatcOptions *options;
} Judge;

/* Transparent surfaces are compared only in their shadow. */
static void add_pixel(const Judge *judge, int pixel, const float *rgba, Error *error)
{
    const int x = pixel % WIDTH, y = pixel / WIDTH;
    const Sample full = reference_sample(judge->tracer, x, y, judge->options);
    const Ray ray = reference_ray(judge->tracer->scene, x + .5, y + .5);
    const Hit hit = reference_hit(judge->tracer, &ray, 0);
    const SoftRays rays = {RAYS, seed * 7919 + (uint64_t)pixel * 104729, judge->row->glass};
    double shares[3];
    if (full.edge || full.nothing || full.light[0] < 1e-3 || (judge->row->glass && hit.object > 0))
        return;
    soft_shares(judge->tracer, &judge->tracer->scene->lights[0], &hit, &rays, shares);
    for (int component = 0; component < 3; component++) {
        const double off = rgba[component] / full.light[component] - shares[component];
        error->most = fmax(error->most, fabs(off));
        error->squares += off * off / 3;
    }
    error->count++;
    error->soft += shares[0] > .01 && shares[0] < .99;
}

static Error compare_case(Renderer *renderer, const Case *c, const MatcOptions *options)
{
    MatcDocument *document;
    Error error = {0};
    Scene *scene = scene_of(c, options, &document);
    assert_true(renderer_set_scene(renderer, scene));
    float *rgba = frame_change_next(renderer);
    Tracer tracer = reference_open(scene);
    const Judge judge = {c, &tracer, options};
    for (int i = (int)(seed % STEP); i < WIDTH * HEIGHT; i += STEP)
        add_pixel(&judge, i, rgba + 4 * (size_t)i, &error);
    reference_close(&tracer);
    free(rgba);
    frame_forget(scene, document);
    return error;
}

static void as_embree(void **state)
{
    (void)state;
    const MatcOptions options = lean_options();
    GlContext *gl = frame_context();
    Renderer *renderer =
        renderer_open(gl, &(RendererOptions){.compile = &options, .view = "light"});
    assert_non_null(renderer);
    int faults = 0;
    for (int i = 0; i < CASES; i++) {
        const Case *c = &cases[i];
        const Error e = compare_case(renderer, c, &options);
        const double rms = sqrt(e.squares / e.count);
        print_message("%-16s %4d pixels, %4d soft, RMS %.4f, most %.3f\n", c->name, e.count, e.soft,
                      rms, e.most);
        assert_true(e.count > 200);
        faults += map_size == MAPS && (rms > 2 * c->rms || e.most > 2 * c->most);
    }
    renderer_close(renderer);
    gl_close(gl);
    assert_int_equal(faults, 0);
}

/* -- what else is asked of it */

/* Two renderers of a case: with shadows, and without. */
static void draw_both(GlContext *gl, const Case *c, float *pictures[2])
{
    const MatcOptions options = lean_options();
    MatcDocument *document;
    Scene *scene = scene_of(c, &options, &document);
    for (int i = 0; i < 2; i++)
        pictures[i] = frame_floats(
            gl, scene,
            &(RendererOptions){.compile = &options, .view = "light", .no_shadows = i > 0});
    frame_forget(scene, document);
}

/* Objects that cast no visible shadow leave every bit of the light; a convex body does not shade
 * itself, at any angle, nor does the floor below a plane's edge shade it; and behind a plane that
 * hides all of a light nothing is left. */
static void all_or_nothing(void **state)
{
    (void)state;
    static const Case alone = {"", MIDDLE, {BALL, ""}, "", 0, 0, false},
                      low = {"", WALL, {BALL, ""}, "", 0, 0, false},
                      hidden = {"",
                                MIDDLE,
                                {PLANE,
                                 "- { object: Box, size: [9, 9, .1], material: m, transform: { "
                                 "translation: [0, 0, 3.5] } }\n"},
                                "",
                                0,
                                0,
                                false};
    GlContext *gl = frame_context();
    float *pictures[2];
    const Case *const whole[] = {&alone, &low};
    for (int i = 0; i < 2; i++) {
        draw_both(gl, whole[i], pictures);
        assert_memory_equal(pictures[0], pictures[1], (size_t)WIDTH * HEIGHT * 4 * sizeof(float));
        free(pictures[0]);
        free(pictures[1]);
    }
    draw_both(gl, &hidden, pictures);
    int dark = 0;
    /* the lower third of the picture: the ground below the sheet */
    for (int i = 0; i < WIDTH * HEIGHT / 3; i++) {
        assert_true(pictures[0][4 * i] == 0);
        dark += pictures[1][4 * i] > 1e-3f;
    }
    assert_true(dark > 1000);
    free(pictures[0]);
    free(pictures[1]);
    gl_close(gl);
}

static void changes(void **state)
{
    (void)state;
    static const Case moved = {"", FENCE, {GROUND, TWO}, "", 0, 0, false};
    const MatcOptions options = lean_options();
    MatcDocument *document;
    GlContext *gl = frame_context();
    Scene *scene = scene_of(&moved, &options, &document);
    frame_change_moves(gl, &(RendererOptions){.compile = &options, .view = "light"}, scene,
                       &(FrameMoves){.25, 0, 2, .5});
    frame_forget(scene, document);
    gl_close(gl);
}

/* Area lights support only maps: another method for all lights does not change them, `none`
 * does. */
static void methods(void **state)
{
    (void)state;
    const MatcOptions options = lean_options();
    MatcDocument *document;
    Scene *scene = scene_of(&cases[0], &options, &document);
    scene_lights_shadow(scene, KEYWORD_Shadows_exact);
    assert_int_equal(scene->lights[0].shadows, KEYWORD_Shadows_map);
    scene_lights_shadow(scene, KEYWORD_Shadows_none);
    assert_int_equal(scene->lights[0].shadows, KEYWORD_Shadows_none);
    frame_forget(scene, document);
}

int main(int count, char **arguments)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(as_embree),
                                       cmocka_unit_test(all_or_nothing), cmocka_unit_test(changes),
                                       cmocka_unit_test(methods)};
    if (count > 1)
        seed = (uint64_t)atoi(arguments[1]);
    if (count > 2)
        map_size = atoi(arguments[2]);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
