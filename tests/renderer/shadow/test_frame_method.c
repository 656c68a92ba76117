/* A shadow technique that is defined in this file alone: its row and GLSL take part in all
 * shared code. Expected values are shares of the light without shadows. */
#include "tests/test.h"
#include "runtime/renderer/passes.h"
#include "runtime/shadow/shadow_method.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdlib.h>

enum { WIDTH = 48, HEIGHT = 32 };

/* Two lights of one technique above a box on the ground: the first is red, the second green. */
#define LIGHT(direction, color)                                                                    \
    "- { light: Directional, direction: " direction ", color: " color ", shadows: exact }\n"
static const char document_text[] =
    "image: { width: 48, height: 32 }\n"
    "camera: { camera: Perspective, position: [1, -6, 4], target: [0, 0, 0], angle: 40 }\n"
    "shadowMaps: { size: 64 }\n"
    "lights:\n" LIGHT("[1, 1, -2]", "[1, 0, 0]") LIGHT(
        "[-1, 1, -2]",
        "[0, 1, 0]") "objects:\n"
                     "- { object: Box, size: [9, 9, 1], transform: { translation: [0, 0, -1] },\n"
                     "    material: { material: Phong, diffuse: .8 } }\n"
                     "- { object: Box, material: { material: Phong, diffuse: .5 } }\n";

/* -- techniques */

static void share_of_lights(const Renderer *renderer, bool nearest, ShadowMethodText *made)
{
    (void)renderer, (void)nearest;
    made->texts[0] = "vec3 testLight(int number, ivec2 views, vec3 point, vec3 side, float size, "
                     "ivec2 pixel)\n{\n    return vec3(0.25 + 0.5 * float(number));\n}\n";
    made->calls[SHADOW_CALL_light] = "testLight";
}

static void share_of_views(const Renderer *renderer, bool nearest, ShadowMethodText *made)
{
    (void)renderer, (void)nearest;
    made->texts[0] = "SHARE testShare(int first, int count, vec3 point, vec3 normal, float size)\n"
                     "{\n    return SHARE(first == 0 ? 0.125 : 0.5);\n}\n";
    made->calls[SHADOW_CALL_view] = "testShare";
}

/* `even`: casters whose transparency does not vary have no maps, so that the light's share is all.
 */
static const ShadowMethod by_lights = {
    .word = KEYWORD_Shadows_exact, .even = true, .text = share_of_lights};
static const ShadowMethod by_views = {
    .word = KEYWORD_Shadows_exact, .views = true, .single = true, .text = share_of_views};

/* -- pictures */

/* Draws the scene's light with a replacement for the technique of its keyword; NULL: the
 * original one. From malloc. */
static float *light_of(GlContext *gl, const Scene *scene, const ShadowMethod *method)
{
    const MatcOptions options = frame_exact_options();
    const ShadowMethod *rows[SHADOW_METHODS_MAX] = {NULL};
    for (int i = 0; shadow_methods[i]; i++)
        rows[i] = method && method->word == shadow_methods[i]->word ? method : shadow_methods[i];
    Renderer *renderer = renderer_open(
        gl, &(RendererOptions){
                .compile = &options, .view = "light", .deep = true, .no_shadows = method == NULL});
    assert_non_null(renderer);
    renderer->shadows->methods.rows = rows;
    float *light = frame_floats_by(gl, renderer, scene);
    renderer_close(renderer);
    return light;
}

static void compare(const ShadowMethod *method, const double shares[2])
{
    MatcDocument *document;
    GlContext *gl = frame_context();
    const MatcOptions options = frame_exact_options();
    Scene *scene = frame_scene(document_text, &options, &document);
    float *with = light_of(gl, scene, method), *without = light_of(gl, scene, NULL);
    int lit[2] = {0};
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        for (int component = 0; component < 2; component++) {
            assert_true(fabs(with[4 * i + component] -
                             shares[component] * without[4 * i + component]) < 1e-6);
            lit[component] += without[4 * i + component] > 0.1;
        }
    assert_true(lit[0] > WIDTH * HEIGHT / 4 && lit[1] > WIDTH * HEIGHT / 4);
    free(with);
    free(without);
    frame_forget(scene, document);
    gl_close(gl);
}

static void a_technique_answers_for_lights(void **state)
{
    (void)state;
    compare(&by_lights, (const double[2]){.25, .75});
}

static void a_technique_answers_for_views(void **state)
{
    (void)state;
    compare(&by_views, (const double[2]){.125, .5});
}

/* A name of the list Shadows selects its row, and every row has one. */
static void rows_have_words(void **state)
{
    const SceneLight light = {.kind = SCENE_Point, .shadows = KEYWORD_Shadows_exact},
                     dark = {.kind = SCENE_Point, .shadows = KEYWORD_Shadows_none};
    const ShadowMethod *const rows[] = {shadow_methods[0], &by_lights, NULL};
    (void)state;
    assert_ptr_equal(shadow_method_of(rows, &light), &by_lights);
    assert_null(shadow_method_of(rows, &dark));
    assert_string_equal(keyword_table[shadow_methods[0]->word].name, "map");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_technique_answers_for_lights),
        cmocka_unit_test(a_technique_answers_for_views),
        cmocka_unit_test(rows_have_words),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
