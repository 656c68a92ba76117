/* Scenes far from the world's origin, under OSMesa: examples moved by 1e6 and by the earth's
 * radius have unchanged pictures, and rotated with their cameras nearly so; cameras that travel
 * far; materials that read the world position. */
/* ctest: unsanitized seconds=130 */
#include "tests/test.h"
#include "runtime/renderer/matc_render.h"
#include "runtime/scene/scene_origin.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/frame_example.h"
#include "tests/frame/frame_moved.h"
#include "tests/value/share.h"
#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    WIDTH = 96,
    TURNED_WIDTH = 192, /* a share of the pixels: silhouettes are fewer */
    NAME = 64,
    SCENES = 64
};

typedef struct {
    int pixels, off; /* by more than a step of 8 bits */
    double most;
} Difference;

static MatcOptions options_of(void)
{
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    return options;
}

/* In parts of 255. */
static Difference compare(const float *a, const float *b, int pixels)
{
    Difference d = {.pixels = pixels};
    for (int i = 0; i < pixels; i++) {
        double most = 0;
        for (int component = 0; component < 3; component++)
            most =
                fmax(most, 255 * fabs((double)a[4 * i + component] - (double)b[4 * i + component]));
        d.off += most > 1.001;
        d.most = fmax(d.most, most);
    }
    return d;
}

/* A line of the world's axes or grid stays where it is, and so does the end of an arrow along which
 * a directional light shines: the tools of the example `tools` are left out. No example reads the
 * position in the world. */
static float *draw_text(Renderer *renderer, GlContext *gl, const char *name, const char *text,
                        int *pixels)
{
    const MatcOptions options = options_of();
    MatcDocument *document;
    Scene *scene = frame_example_of(name, text, &(FrameExample){WIDTH, &options}, &document);
    scene->tools.grid = scene->tools.axes = scene->tools.lights = false;
    float *rgba = frame_floats_by(gl, renderer, scene);
    *pixels = scene->width * scene->height;
    frame_forget(scene, document);
    return rgba;
}

static Renderer *open_renderer(GlContext *gl, const MatcOptions *options)
{
    Renderer *renderer =
        renderer_open(gl, &(RendererOptions){.compile = options, .edges = RENDERER_EDGES_coverage});
    if (!renderer)
        fail_msg("%s", gl->error);
    return renderer;
}

/* Their names; how many. */
static int list_examples(char names[SCENES][NAME])
{
    DIR *folder = opendir("examples/scenes");
    int count = 0;
    assert_non_null(folder);
    for (struct dirent *entry; (entry = readdir(folder));) {
        char *dot = strrchr(entry->d_name, '.');
        if (!dot || strcmp(dot, ".yaml") != 0)
            continue;
        assert_true(count < SCENES);
        snprintf(names[count++], NAME, "%.*s", (int)(dot - entry->d_name), entry->d_name);
    }
    closedir(folder);
    return count;
}

enum { SHARES = 8 /* tests/value/share.h: of the examples, under CI */ };

/* -- moved */

static void assert_moved(GlContext *gl, const char *name)
{
    static const FrameMove moves[] = {{.translation = {1e6, 0, 0}},
                                      {.translation = {6378137, -6378137, 6378137}}};
    const MatcOptions options = options_of();
    Renderer *renderer = open_renderer(gl, &options);
    int pixels;
    char *text = frame_example_text(name);
    float *here = draw_text(renderer, gl, name, text, &pixels);
    for (size_t i = 0; i < sizeof moves / sizeof *moves; i++) {
        char *moved = frame_moved(text, &moves[i]);
        float *there = draw_text(renderer, gl, name, moved, &pixels);
        const Difference d = compare(here, there, pixels);
        if (d.off)
            fail_msg("%s, moved by %g: %d of %d pixels are off, at most by %.1f of 255", name,
                     moves[i].translation[0], d.off, d.pixels, d.most);
        free(there);
        free(moved);
    }
    free(here);
    free(text);
    renderer_close(renderer);
}

static void examples_are_moved(void **state)
{
    (void)state;
    static char names[SCENES][NAME];
    const int count = list_examples(names);
    GlContext *gl = frame_context();
    assert_true(count > 30);
    for (int i = 0; i < count; i++)
        if (share_takes(i, SHARES))
            assert_moved(gl, names[i]);
    gl_close(gl);
}

#define PAIR                                                                                       \
    "image: { width: 96, height: 64 }\n"                                                           \
    "camera: { camera: Perspective, position: [%.17g, -6, 2], target: [%.17g, 0, .5], angle: 30 "  \
    "}\n"                                                                                          \
    "lights: [{ light: Directional, direction: [.5, .6, -1] }, { light: Point, position: [%.17g, " \
    "-3, 4] }]\n"                                                                                  \
    "objects:\n- { object: Sphere, transform: { translation: [%.17g, 0, 0] }, material: %s }\n"    \
    "- { object: Box, transform: { translation: [%.17g, 0, 1] }, material: %s }\n"

static void put_pair(char *text, size_t capacity, double x, const char *material)
{
    snprintf(text, capacity, PAIR, x, x, x - 2, x, material, x + 1.5, material);
}

static float *draw_pair(GlContext *gl, double x, const char *material)
{
    char text[4096];
    const MatcOptions options = options_of();
    MatcDocument *document;
    put_pair(text, sizeof text, x, material);
    Scene *scene = frame_scene(text, &options, &document);
    float *rgba = frame_floats(gl, scene, &(RendererOptions){.compile = &options});
    frame_forget(scene, document);
    return rgba;
}

enum { PAIR_PIXELS = 96 * 64 };

/* Each object moved by itself, up to where numbers of scenes end. */
static void distances(void **state)
{
    (void)state;
    static const double places[] = {1e3, 1e4, -1e6, 6378137.37, 1e8, 999999997};
    GlContext *gl = frame_context();
    float *here = draw_pair(gl, 0, "{ material: Phong, diffuse: .5 }");
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        float *there = draw_pair(gl, places[i], "{ material: Phong, diffuse: .5 }");
        const Difference d = compare(here, there, PAIR_PIXELS);
        print_message("%.10g: %d pixels off\n", places[i], d.off);
        assert_int_equal(d.off, 0);
        free(there);
    }
    free(here);
    gl_close(gl);
}

/* -- turned */

/* Parts of a scene that do not turn with the objects: a sky that is no plain color, light that
 * knows up from down, and what is sampled along the world's axes or a light's: voxels and shadow
 * maps. */
static bool may_turn(Scene *scene)
{
    bool may = scene->sky_light[0] + scene->sky_light[1] + scene->sky_light[2] <= 0 &&
               !scene_indirect_is(scene);
    for (int i = 0; i < scene->light_count; i++) {
        may = may && scene->lights[i].kind != SCENE_Hemisphere;
        scene->lights[i].shadows = KEYWORD_Shadows_none;
    }
    scene->tools.grid = scene->tools.axes = scene->tools.lights = false;
    return may;
}

static float *draw_turned(GlContext *gl, const char *name, const char *text, int *pixels)
{
    const MatcOptions options = options_of();
    MatcDocument *document;
    float *rgba = NULL;
    Scene *scene = frame_example_of(name, text, &(FrameExample){TURNED_WIDTH, &options}, &document);
    *pixels = scene->width * scene->height;
    if (may_turn(scene))
        rgba = frame_floats(
            gl, scene, &(RendererOptions){.compile = &options, .edges = RENDERER_EDGES_coverage});
    frame_forget(scene, document);
    return rgba;
}

static bool assert_turned(GlContext *gl, const char *name)
{
    static const FrameMove move = {.rotation = {.3, -.2, .7}, .translation = {6378137, 0, 0}};
    static const double share = .995;
    int pixels;
    char *text = frame_example_text(name), *moved = frame_moved(text, &move);
    float *here = draw_turned(gl, name, text, &pixels);
    float *there = here ? draw_turned(gl, name, moved, &pixels) : NULL;
    if (here) {
        const Difference d = compare(here, there, pixels);
        print_message("%s: %d of %d pixels off, at most by %.1f\n", name, d.off, pixels, d.most);
        if (d.off > (1 - share) * pixels)
            fail_msg("%s, turned: %d of %d pixels are off", name, d.off, pixels);
    }
    const bool drawn = here != NULL;
    free(here);
    free(there);
    free(text);
    free(moved);
    return drawn;
}

static void examples_are_turned(void **state)
{
    (void)state;
    static char names[SCENES][NAME];
    const int count = list_examples(names);
    GlContext *gl = frame_context();
    int drawn = 0;
    for (int i = 0; i < count; i++)
        if (share_takes(i, SHARES))
            drawn += assert_turned(gl, names[i]);
    assert_true(drawn >= 4 || getenv("TESTS_SHARE")); /* of all of them */
    gl_close(gl);
}

/* -- cameras that go far */

/* Two identical pairs of objects, and the camera moves from one to the other. */
static void the_origin_follows(void **state)
{
    (void)state;
    static const double far = 6378137.37;
    char text[4096], more[1024];
    GlContext *gl = frame_context();
    const MatcOptions options = options_of();
    MatcDocument *document;
    put_pair(text, sizeof text, 0, "{ material: Phong, diffuse: .5 }");
    snprintf(more, sizeof more,
             "- { object: Sphere, transform: { translation: [%.17g, 0, 0] }, material: { material: "
             "Phong, diffuse: .5 } }\n"
             "- { object: Box, transform: { translation: [%.17g, 0, 1] }, material: { material: "
             "Phong, diffuse: .5 } }\n",
             far, far + 1.5);
    strcat(text, more);
    Scene *scene = frame_scene(text, &options, &document);
    assert_false(scene_origin_used(scene));
    scene->light_count = 1; /* the directional one */
    Renderer *renderer = open_renderer(gl, &options);
    float *here = frame_floats_by(gl, renderer, scene),
          *there = calloc(PAIR_PIXELS, 4 * sizeof *there);
    scene->camera.position[0] += 100;
    scene->camera.target[0] += 100;
    assert_false(scene_origin_follow(scene, &scene->camera)); /* near enough */
    scene->camera.position[0] += far - 100;
    scene->camera.target[0] += far - 100;
    assert_true(scene_origin_follow(scene, &scene->camera));
    assert_true(fabs(scene->camera.position[0]) < 10 && fabs(scene->origin[0] - far) < 10);
    if (!renderer_changed(renderer, RENDERER_CAMERA) || !renderer_frame(renderer) ||
        !renderer_read(renderer, there))
        fail_msg("%s", gl->error);
    const Difference d = compare(here, there, PAIR_PIXELS);
    print_message("after a way of %g: %d pixels off\n", far, d.off);
    assert_true(d.off == 0);
    free(here);
    free(there);
    renderer_close(renderer);
    frame_forget(scene, document);
    gl_close(gl);
}

/* A host passes and reads world positions. */
static void a_host_speaks_of_the_world(void **state)
{
    (void)state;
    char text[4096];
    MatcDocument *document;
    double matrix[16];
    put_pair(text, sizeof text, 6378137.25, "{ material: Phong, diffuse: .5 }");
    MatcScene *scene = matc_scene_read("scene.yaml", text, strlen(text), NULL, &document);
    assert_non_null(scene);
    matc_scene_matrix(scene, 1, matrix);
    assert_true(matrix[12] == 6378138.75 && matrix[13] == 0 && matrix[14] == 1);
    matc_scene_free(scene);
    matc_document_free(document);
}

/* -- the position in the world */

/* Draws the pair at 0, where a formula reads P.x + by, and at `by`, where it reads P.x: both are
 * the same value. */
static void assert_world(GlContext *gl, const char *format, double by)
{
    char texts[2][512], place[64];
    snprintf(place, sizeof place, "(P.x + %.17g)", by);
    snprintf(texts[0], sizeof texts[0], format, place);
    snprintf(texts[1], sizeof texts[1], format, "P.x");
    float *here = draw_pair(gl, 0, texts[0]), *there = draw_pair(gl, by, texts[1]);
    const Difference d = compare(here, there, PAIR_PIXELS);
    double least = 1, most = 0;
    for (int i = 0; i < PAIR_PIXELS; i++) {
        least = fmin(least, (double)there[4 * i]);
        most = fmax(most, (double)there[4 * i]);
    }
    print_message("%s at %g: %d pixels off\n", format, by, d.off);
    assert_true(d.off <= PAIR_PIXELS / 200);
    assert_true(most > .5 && least < .3); /* something is shown */
    free(here);
    free(there);
}

/* Emitted light, a viewer's direction beside it, the C reference of displaced meshes, and the
 * normals of these. At 4096 a float has steps of 1/2048. */
static void positions_are_the_worlds(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    assert_world(gl, "{ material: Phong, diffuse: 0, emissive: \"= %s > 4096.25 ? 1 : 0.1\" }",
                 4096);
    assert_world(
        gl, "{ material: Phong, diffuse: 0, emissive: \"= %s > 4096.25 ? abs(V.z) : facing\" }",
        4096);
    assert_world(gl,
                 "{ material: Phong, diffuse: .5, displacement: \"= 0.1 * sin(9 * (%s - 4096))\" }",
                 4096);
    gl_close(gl);
}

/* Moved scenes with an XYZTransform whose `useGlobal` reads the position in the world. */
static void global_maps_are_the_worlds(void **state)
{
    (void)state;
    static const double by = 4096; /* a multiple of the checker's period */
    static const char material[] =
        "{ material: Phong, diffuse: 0, emissive: { map: VolumeChecker, color1: 1, color2: .1, "
        "input: { map: XYZTransform, useGlobal: true } } }";
    GlContext *gl = frame_context();
    float *here = draw_pair(gl, 0, material), *there = draw_pair(gl, by, material);
    const Difference d = compare(here, there, PAIR_PIXELS);
    print_message("a checker of the world: %d pixels off\n", d.off);
    assert_true(d.off <= PAIR_PIXELS / 200);
    free(here);
    free(there);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distances),
        cmocka_unit_test(the_origin_follows),
        cmocka_unit_test(a_host_speaks_of_the_world),
        cmocka_unit_test(positions_are_the_worlds),
        cmocka_unit_test(global_maps_are_the_worlds),
        cmocka_unit_test(examples_are_turned),
        cmocka_unit_test(examples_are_moved),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
