/* Exact shadows: no pixel is wrong by Embree's rays, and by all triangles in double where those are asked again. `build/tests/test_frame_exact
 * 10000000` draws as many pixels at least, and `... 10000000 egl` on a GPU. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/frame/frame_calls.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/shadow_judge.h"
#include "tests/frame/shadow_pair.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SETS = 3 /* of objects */ };
static int wide = 72, high = 54; /* pixels of a picture */
static GlKind kind;

#define HEAD                                                                                                           \
    "camera: { camera: Perspective, position: [1.5, -7, 4], target: [0, 0, .5], angle: 42 }\n"                         \
    "materials: { m: { material: Phong, diffuse: .5 } }\n"
#define THINGS                                                                                                         \
    "- { object: Sphere, radius: .8, detail: 48, material: m, transform: { translation: [-.6, -.4, .8] } }\n"          \
    "- { object: Box, material: m, transform: { translation: [1, .5, .5], rotation: [0, 0, .3] } }\n"                  \
    "- { object: Box, size: [.5, .5, .5], material: m, transform: { translation: [1.1, .5, 1.25] } }\n"                \
    "- { object: Cylinder, radius: .3, height: .8, material: m, transform: { translation: [.6, -1.4, 0] } }\n"         \
    "- { object: Cone, radius: .3, height: .6, material: m, transform: { translation: [.6, -1.4, .8] } }\n"            \
    "- { object: Parallelogram, u: [0, 1.6, 0], v: [.4, 0, 1], material: m, transform: { translation: [-2.2, -.6, 0] " \
    "} }\n"
/* Bodies that cross, needles, sheets a hair apart, copies in one place. */
#define NASTY                                                                                                          \
    "- { object: Sphere, radius: .7, detail: 48, material: m, transform: { translation: [-.9, -.4, .5] } }\n"          \
    "- { object: Sphere, radius: .7, detail: 9, material: m, transform: { translation: [-.3, -.2, .6] } }\n"           \
    "- { object: Box, material: m, transform: { translation: [1, .5, .3], rotation: [.3, .2, .3] } }\n"                \
    "- { object: Box, material: m, transform: { translation: [1, .5, .3], rotation: [.3, .2, .3] } }\n"                \
    "- { object: Parallelogram, u: [3, 0, 0], v: [0, .0001, .3], material: m, transform: { translation: [-1, -1.5, "   \
    ".2] "                                                                                                             \
    "} }\n"                                                                                                            \
    "- { object: Parallelogram, u: [3, 0, 1], v: [0, .00001, 0], material: m, transform: { translation: [-1, -1.7, "   \
    ".2] "                                                                                                             \
    "} }\n"                                                                                                            \
    "- { object: Parallelogram, u: [2, 0, 0], v: [0, 2, 0], material: m, transform: { translation: [-1, .5, .0005] } " \
    "}\n"                                                                                                              \
    "- { object: Box, size: [.000001, 1, 1], material: m, transform: { translation: [0, .9, .5] } }\n"                 \
    "- { object: Cone, radius: .001, height: 2, material: m, transform: { translation: [.4, -.8, 0] } }\n"
#define GROUND                                                                                                         \
    "objects:\n- { object: Parallelogram, u: [8, 0, 0], v: [0, 8, 0], material: m, transform: { translation: [-4, "    \
    "-4, 0] } }\n"
#define PLANE "objects:\n- { object: Plane, material: m }\n"

typedef struct {
    int counts[SHADOW_VERDICTS], dark;
} Count;

static void put_wrong(const char *name, int pixel, bool lit)
{
    print_message("%s: pixel %d, %d is %s\n", name, pixel % wide, pixel / wide, lit ? "lit" : "dark");
}

/* Judges a picture of one light. */
static void compare(const ShadowPair *pair, const char *name, const Scene *scene, Count *count)
{
    float *with = shadow_pair_draw(pair, 0, scene), *without = shadow_pair_draw(pair, 1, scene);
    Tracer tracer = reference_open(scene);
    const ShadowJudge judge = shadow_judge(&tracer);
    for (int i = 0; i < wide * high; i++) {
        if (without[4 * i] <= 1e-7f)
            continue;
        const bool lit = with[4 * i] > 0.5f * without[4 * i];
        const double at[2] = {i % wide + .5, i / wide + .5};
        const ShadowVerdict verdict = shadow_verdict(&judge, &scene->lights[0], at, lit);
        count->counts[verdict]++;
        count->dark += !lit;
        if (verdict == SHADOW_wrong)
            put_wrong(name, i, lit);
    }
    reference_close(&tracer);
    free(with);
    free(without);
}

/* -- scenes */

typedef struct {
    const char *kind; /* and further params */
    bool placed, directed;
    double distance; /* from the origin */
} Lamp;

static const Lamp lamps[] = {
    {"Directional", false, true, 6},
    {"Spot, innerAngle: 30, outerAngle: 45", true, true, 6},
    {"Spot, innerAngle: 80, outerAngle: 100", true, true, 6},
    {"Point", true, false, 6},
    {"Point", true, false, 1.8}, /* among the objects */
};
enum { LAMPS = sizeof lamps / sizeof *lamps };

static Scene *scene_of(const MatcOptions *options, const Lamp *lamp, const double angle[2], const char *objects[2],
                       MatcDocument **document)
{
    char text[6144], place_text[128] = "", direction_text[128] = "";
    double at[3];
    shadow_place(angle, lamp->distance, at);
    if (lamp->placed)
        snprintf(place_text, sizeof place_text, ", position: [%g, %g, %g]", at[0], at[1], at[2]);
    if (lamp->directed)
        snprintf(direction_text, sizeof direction_text, ", direction: [%g, %g, %g]", -at[0], -at[1], -at[2]);
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\n" HEAD "lights: [{ light: %s%s%s, shadows: exact }]\n%s%s", wide, high,
             lamp->kind, place_text, direction_text, objects[0], objects[1]);
    return frame_scene(text, options, document);
}

static Count by_every_lamp(const char *name, const char *objects[2])
{
    ShadowPair pair;
    Count count = {.dark = 0};
    shadow_pair_open(kind, &pair);
    for (int i = 0; i < SHADOW_ANGLES; i++) {
        MatcDocument *document;
        Scene *scene = scene_of(&pair.options, &lamps[i % LAMPS], shadow_angles[i], objects, &document);
        compare(&pair, name, scene, &count);
        frame_forget(scene, document);
    }
    shadow_pair_close(&pair);
    print_message("%s: %d right, %d dark, %d ties, %d of what is seen, %d wrong\n", name, count.counts[SHADOW_right],
                  count.dark, count.counts[SHADOW_tie], count.counts[SHADOW_seen_tie], count.counts[SHADOW_wrong]);
    return count;
}

static void assert_exact(const Count *count)
{
    assert_int_equal(count->counts[SHADOW_wrong], 0);
    assert_true(count->dark > wide * high / 10);
    assert_true(count->counts[SHADOW_right] > 3 * wide * high);
    assert_true(count->counts[SHADOW_tie] + count->counts[SHADOW_seen_tie] <= count->counts[SHADOW_right] / 100);
}

static void on_a_mesh(void **state)
{
    (void)state;
    const Count count = by_every_lamp("things on a mesh", (const char *[2]){GROUND, THINGS});
    assert_exact(&count);
}

static void on_a_plane(void **state)
{
    (void)state;
    const Count count = by_every_lamp("things on a plane", (const char *[2]){PLANE, THINGS});
    assert_exact(&count);
}

static void nasty(void **state)
{
    (void)state;
    const Count count = by_every_lamp("nasty things", (const char *[2]){GROUND, NASTY});
    assert_exact(&count);
}

/* -- what else is in a scene */

/* Two lights by each method, something of glass, a plane. */
#define MIXED                                                                                                          \
    "image: { width: 64, height: 48 }\n"                                                                               \
    "camera: { camera: Perspective, position: [1.5, -7, 4], target: [0, 0, .5], angle: 42 }\n"                         \
    "materials: { m: { material: Phong, diffuse: .5 }, g: { material: Phong, diffuse: 0, transparency: %s, "           \
    "interpolatedTransparency: false } }\n"                                                                            \
    "lights: [{ light: Directional, direction: [1, 1, -2], shadows: exact },\n"                                        \
    "  { light: Point, position: [1, -2, 4], intensity: 9, shadows: exact },\n"                                        \
    "  { light: Point, position: [-2, -2, 3], intensity: 4, shadows: map },\n"                                         \
    "  { light: Point, position: [0, -2, 3], intensity: 2, shadows: none }]\n" PLANE THINGS                            \
    "- { object: Parallelogram, u: [1, 0, 0], v: [0, 1, 0], material: g, transform: { translation: [-.4, -1.6, 1.3] "  \
    "} }\n"

static Scene *mixed_scene(const MatcOptions *options, const char *through, MatcDocument **document)
{
    char text[6144];
    snprintf(text, sizeof text, MIXED, through);
    return frame_scene(text, options, document);
}

static float *read_frame(Render *render)
{
    const size_t pixels = (size_t)render_tile_width(render) * (size_t)render_tile_height(render);
    float *rgba = calloc(pixels, 4 * sizeof *rgba);
    assert_true(rgba && render_frame(render) && render_read(render, rgba));
    return rgba;
}

/* The picture is the one that a new renderer draws. */
static void assert_as_new(GlContext *gl, const RenderOptions *how, Render *changed, const Scene *scene)
{
    Render *fresh = render_open(gl, how);
    assert_true(fresh && render_scene(fresh, scene));
    float *a = read_frame(changed), *b = read_frame(fresh);
    assert_memory_equal(a, b, (size_t)scene->width * (size_t)scene->height * 4 * sizeof *a);
    render_close(fresh);
    free(a);
    free(b);
}

/* After objects, lights and the camera moved, and no further frame makes or writes anything. */
static void changes(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    const RenderOptions how = {.compile = &options, .view = "light"};
    MatcDocument *document;
    GlContext *gl = frame_context_of(kind);
    Scene *scene = mixed_scene(&options, ".5", &document);
    Render *render = render_open(gl, &how);
    frame_count_calls(gl);
    assert_true(render && render_scene(render, scene));
    free(read_frame(render));
    frame_calls = (FrameCalls){0};
    free(read_frame(render));
    assert_true(frame_calls.made == 0 && frame_calls.written == 0);
    scene->objects[1].world_from_local.m[12] += 3.25; /* it is now the farthest to that side */
    assert_true(render_changed_objects(render, 1, 1));
    assert_as_new(gl, &how, render, scene);
    scene->lights[1].position[0] -= .5;
    assert_true(render_changed(render, RENDER_LIGHTS));
    assert_as_new(gl, &how, render, scene);
    scene->camera.position[2] += .25;
    assert_true(render_changed(render, RENDER_CAMERA));
    assert_as_new(gl, &how, render, scene);
    render_close(render);
    frame_forget(scene, document);
    gl_close(gl);
}

/* What is transparent casts shadows by maps, beside what is opaque: half of the light; a quarter where the shadow is seen through the pane. */
static void glass(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    const RenderOptions how = {.compile = &options, .view = "light"};
    MatcDocument *documents[2];
    GlContext *gl = frame_context_of(kind);
    float *pictures[2];
    Scene *scenes[2];
    int darker = 0, twice = 0, alike = 0;
    for (int i = 0; i < 2; i++) {
        scenes[i] = mixed_scene(&options, i ? ".5" : "1", &documents[i]);
        scenes[i]->light_count = 1;
        pictures[i] = frame_floats(gl, scenes[i], &how);
    }
    for (int i = 0; i < scenes[0]->width * scenes[0]->height; i++) {
        const float clear = pictures[0][4 * i], dim = pictures[1][4 * i];
        assert_true(dim <= clear * 1.001f && dim >= .25f * clear * .999f);
        darker += fabsf(dim - .5f * clear) < 1e-3f * clear;
        twice += fabsf(dim - .25f * clear) < 1e-3f * clear;
        alike += dim == clear && clear > .01f;
    }
    assert_true(darker > 25 && twice > 8 && alike > 1000);
    for (int i = 0; i < 2; i++) {
        free(pictures[i]);
        frame_forget(scenes[i], documents[i]);
    }
    gl_close(gl);
}

/* OpenGL 4.3 draws each object by itself, which has to be told the number of its first triangle. */
static void no_instances(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    const RenderOptions how = {.compile = &options, .view = "light"};
    MatcDocument *document;
    GlContext *gl = frame_context_of(kind);
    Scene *scene = scene_of(&options, &lamps[0], shadow_angles[3], (const char *[2]){GROUND, THINGS}, &document);
    int others = 0, dark = 0;
    float *newest = frame_floats(gl, scene, &how);
    gl->minor = 3;
    float *older = frame_floats(gl, scene, &how);
    for (int i = 0; i < scene->width * scene->height; i++) {
        others += fabsf(newest[4 * i] - older[4 * i]) > 1e-3f;
        dark += older[4 * i] <= 0;
    }
    assert_true(others <= 2 && dark > 100);
    free(newest);
    free(older);
    frame_forget(scene, document);
    gl_close(gl);
}

static void older_drivers(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    GlContext *gl = frame_context_of(kind);
    Scene *scene = mixed_scene(&options, ".5", &document);
    gl->major = gl->minor = 3;
    Render *render = render_open(gl, &(RenderOptions){.compile = &options});
    assert_non_null(render);
    assert_false(render_scene(render, scene));
    assert_non_null(strstr(gl->error, "shadows: exact takes OpenGL 4.3, and the driver has 3.3"));
    render_close(render);
    frame_forget(scene, document);
    gl_close(gl);
}

int main(int count, char **arguments)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_a_mesh),     cmocka_unit_test(on_a_plane), cmocka_unit_test(nasty),
        cmocka_unit_test(changes),       cmocka_unit_test(glass),      cmocka_unit_test(no_instances),
        cmocka_unit_test(older_drivers),
    };
    if (count > 1 && atof(arguments[1]) > 0) {
        const double each = atof(arguments[1]) / (SETS * SHADOW_ANGLES);
        high = (int)ceil(sqrt(each * 3 / 4));
        wide = (high * 4 + 2) / 3;
    }
    kind = frame_kind(count, arguments);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
