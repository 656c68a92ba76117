/* Exact shadows: no pixel is wrong by Embree's rays, or, for pixels that disagree, by all
 * triangles in double. `build/tests/test_frame_exact 10000000` draws at least as many pixels,
 * and `... 10000000 egl` on a GPU. */
/* ctest: seconds=31 */
#include "tests/test.h"
#include "tests/frame/frame_change.h"
#include "tests/frame_reference/shadow_judge.h"
#include "tests/frame/shadow_pair.h"
#include "tests/frame/shadow_scene.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SETS = 3 /* of objects */ };
static int wide = 72, high = 54; /* pixels of a picture */
static GlKind kind;

/* Intersecting objects, needles, almost coincident sheets, coincident copies. */
#define NASTY                                                                                      \
    "- { object: Sphere, radius: .7, detail: 48, material: m, transform: { translation: [-.9, "    \
    "-.4, .5] } }\n"                                                                               \
    "- { object: Sphere, radius: .7, detail: 9, material: m, transform: { translation: [-.3, "     \
    "-.2, .6] } }\n"                                                                               \
    "- { object: Box, material: m, transform: { translation: [1, .5, .3], rotation: [.3, .2, .3] " \
    "} }\n"                                                                                        \
    "- { object: Box, material: m, transform: { translation: [1, .5, .3], rotation: [.3, .2, .3] " \
    "} }\n"                                                                                        \
    "- { object: Parallelogram, u: [3, 0, 0], v: [0, .0001, .3], material: m, transform: { "       \
    "translation: [-1, -1.5, "                                                                     \
    ".2] "                                                                                         \
    "} }\n"                                                                                        \
    "- { object: Parallelogram, u: [3, 0, 1], v: [0, .00001, 0], material: m, transform: { "       \
    "translation: [-1, -1.7, "                                                                     \
    ".2] "                                                                                         \
    "} }\n"                                                                                        \
    "- { object: Parallelogram, u: [2, 0, 0], v: [0, 2, 0], material: m, transform: { "            \
    "translation: [-1, .5, .0005] } "                                                              \
    "}\n"                                                                                          \
    "- { object: Box, size: [.000001, 1, 1], material: m, transform: { translation: [0, .9, .5] "  \
    "} }\n"                                                                                        \
    "- { object: Cone, radius: .001, height: 2, material: m, transform: { translation: [.4, -.8, " \
    "0] } }\n"
typedef struct {
    int counts[SHADOW_VERDICTS], dark;
} Count;

static void put_wrong(const char *name, int pixel, bool lit)
{
    print_message("%s: pixel %d, %d is %s\n", name, pixel % wide, pixel / wide,
                  lit ? "lit" : "dark");
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

static Scene *scene_of(const MatcOptions *options, int angle, const char *objects[2],
                       MatcDocument **document)
{
    char head[64];
    snprintf(head, sizeof head, "image: { width: %d, height: %d }\n", wide, high);
    const ShadowScene from = {head,
                              "exact",
                              &shadow_lamps[angle % SHADOW_LAMPS],
                              shadow_angles[angle],
                              {objects[0], objects[1]}};
    return shadow_scene(&from, options, document);
}

static Count by_every_lamp(const char *name, const char *objects[2])
{
    ShadowPair pair;
    Count count = {.dark = 0};
    shadow_pair_open(kind, &pair);
    for (int i = 0; i < SHADOW_ANGLES; i++) {
        MatcDocument *document;
        Scene *scene = scene_of(&pair.options, i, objects, &document);
        compare(&pair, name, scene, &count);
        frame_forget(scene, document);
    }
    shadow_pair_close(&pair);
    print_message("%s: %d right, %d dark, %d ties, %d of what is seen, %d wrong\n", name,
                  count.counts[SHADOW_right], count.dark, count.counts[SHADOW_tie],
                  count.counts[SHADOW_seen_tie], count.counts[SHADOW_wrong]);
    return count;
}

static void assert_exact(const Count *count)
{
    assert_int_equal(count->counts[SHADOW_wrong], 0);
    assert_true(count->dark > wide * high / 10);
    assert_true(count->counts[SHADOW_right] > 3 * wide * high);
    assert_true(count->counts[SHADOW_tie] + count->counts[SHADOW_seen_tie] <=
                count->counts[SHADOW_right] / 100);
}

static void on_a_mesh(void **state)
{
    (void)state;
    const Count count =
        by_every_lamp("objects on a mesh",
                      (const char *[2]){SHADOW_SCENE_GROUND, SHADOW_SCENE_OBJECTS("detail: 48, ")});
    assert_exact(&count);
}

static void on_a_plane(void **state)
{
    (void)state;
    const Count count =
        by_every_lamp("objects on a plane",
                      (const char *[2]){SHADOW_SCENE_PLANE, SHADOW_SCENE_OBJECTS("detail: 48, ")});
    assert_exact(&count);
}

static void nasty(void **state)
{
    (void)state;
    const Count count =
        by_every_lamp("degenerate objects", (const char *[2]){SHADOW_SCENE_GROUND, NASTY});
    assert_exact(&count);
}

/* -- what else is in a scene */

static const char mixed[] = SHADOW_SCENE_MIXED(
    "", "exact", ",\n  { light: Point, position: [0, -2, 3], intensity: 2, shadows: none }",
    "detail: 48, ");

static void changes(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    GlContext *gl = frame_context_of(kind);
    Scene *scene = shadow_scene_mixed(mixed, ".5", &options, &document);
    frame_change_moves(gl, &(RendererOptions){.compile = &options, .view = "light"}, scene,
                       /* the object is then the farthest to that side */
                       &(FrameMoves){3.25, 1, 0, -.5});
    frame_forget(scene, document);
    gl_close(gl);
}

/* Transparent objects cast shadows by maps, together with opaque ones. */
static void glass(void **state)
{
    (void)state;
    GlContext *gl = frame_context_of(kind);
    shadow_scene_assert_glass(gl, mixed);
    gl_close(gl);
}

/* OpenGL 4.3 draws each object separately, with the number of its first triangle as a uniform. */
static void no_instances(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "light"};
    MatcDocument *document;
    GlContext *gl = frame_context_of(kind);
    Scene *scene = scene_of(
        &options, 3, (const char *[2]){SHADOW_SCENE_GROUND, SHADOW_SCENE_OBJECTS("detail: 48, ")},
        &document);
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
    GlContext *gl = frame_context_of(kind);
    shadow_scene_assert_refused(gl, mixed,
                                "shadows: exact takes OpenGL 4.3, and the driver has 3.3");
    gl_close(gl);
}

int main(int count, char **arguments)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_a_mesh),     cmocka_unit_test(on_a_plane),
        cmocka_unit_test(nasty),         cmocka_unit_test(changes),
        cmocka_unit_test(glass),         cmocka_unit_test(no_instances),
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
