/* Random copies: the generator against published numbers, places by hand, coverage of each
 * range, refused values. */
#include "tests/test.h"
#include "runtime/tessellate/scene_scatter.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Values of SplitMix64 for these seeds, as its users publish them. */
static void published(void **state)
{
    (void)state;
    static const uint64_t from_0[] = {0xe220a8397b1dcdaf, 0x6e789e6aa1b965f4, 0x06c45d188009454f,
                                      0xf88bb8a8724c81ec};
    static const uint64_t from_1234567[] = {6457827717110365317u, 3203168211198807973u,
                                            9817491932198370423u, 4593380528125082431u,
                                            16408922859458223821u};
    uint64_t zero = 0, other = 1234567;
    for (size_t i = 0; i < 4; i++)
        assert_true(scene_scatter_next(&zero) == from_0[i]);
    for (size_t i = 0; i < 5; i++)
        assert_true(scene_scatter_next(&other) == from_1234567[i]);
}

#define RED "materials: { red: { material: RGBA, r: 1 } }\n"

/* The first copy is at the place that the first random numbers give, within its group; equal
 * seeds give equal copies, others differ. */
static void places(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(RED "objects:\n- { object: Group, transform: { translation: [5, 0, "
                                   "1] }, objects: [{ object: Scatter, count: 3, "
                                   "size: [2, 2, 0], least: 2, most: 3, objects: [{ object: Box, "
                                   "material: red, transform: { translation: "
                                   "[0, 0, 10] } }, { object: Sphere, material: red }] }] }\n",
                               &options, &document);
    assert_int_equal(scene->object_count, 6);
    const double *m = scene->objects[1].world_from_local.m;
    const double scale = 2 + 0.17386786595968284; /* the seventh number */
    assert_true(fabs(m[12] - (5 + 2 * 0.8833108082136426 - 1)) < 1e-12);
    assert_true(fabs(m[13] - (2 * 0.43152799704850997 - 1)) < 1e-12);
    assert_true(fabs(m[14] - 1) < 1e-12);
    assert_true(fabs(m[0] - scale) < 1e-12 && fabs(m[5] - scale) < 1e-12 &&
                fabs(m[10] - scale) < 1e-12);
    assert_true(fabs(scene->objects[0].world_from_local.m[14] - 1 - 10 * scale) < 1e-12);
    assert_int_equal(scene->objects[2].kind, SCENE_Box);
    assert_true(memcmp(&scene->objects[3].world_from_local, &scene->objects[1].world_from_local,
                       sizeof(SceneMatrix)) != 0);
    frame_forget(scene, document);
}

/* 4,096 copies: the least and the greatest of each number come close to the ends, the means to the
 * middle. */
static void whole_range(void **state)
{
    (void)state;
    enum { COUNT = 4096 };
    const SceneScatter scatter = {
        .size = {2, 4, 6}, .rotation = {0, 0, 1.5}, .least = 1, .most = 3};
    uint64_t seed = 5;
    double low[5], high[5], sum[5] = {0};
    for (int i = 0; i < COUNT; i++) {
        const SceneMatrix matrix = scene_scatter_matrix(&scatter, &seed);
        const double *m = matrix.m, scale = m[10];
        const double numbers[5] = {m[12] / 2, m[13] / 4, m[14] / 6, atan2(m[1], m[0]) / 3,
                                   (scale - 2) / 2};
        for (int k = 0; k < 5; k++) {
            low[k] = i && low[k] < numbers[k] ? low[k] : numbers[k];
            high[k] = i && high[k] > numbers[k] ? high[k] : numbers[k];
            sum[k] += numbers[k] / COUNT;
        }
    }
    for (int k = 0; k < 5; k++) {
        assert_true(low[k] >= -.5 && low[k] < -.495 && high[k] <= .5 && high[k] > .495);
        assert_true(fabs(sum[k]) < 5 * .2887 / 64); /* five standard deviations */
    }
}

static void assert_refused(const char *text, const char *reported)
{
    MatcOptions options;
    MatcDocument *document;
    Scene *scene = NULL;
    matc_options_init(&options);
    document = scene_read("scene.yaml", text, strlen(text), &options, &scene);
    assert_null(scene);
    const char *all = matc_diagnostics(document, MATC_TEXT);
    if (strncmp(all + strlen("scene.yaml:"), reported, strlen(reported)) != 0)
        fail_msg("%s", all);
    assert_int_equal(matc_error_count(document), 1);
    matc_document_free(document);
}

/* Once, however many copies have the fault; and copies of nothing end, too. */
static void refused(void **state)
{
    (void)state;
    assert_refused(
        RED "objects: [{ object: Scatter, least: 2, objects: [{ object: Box, material: red }] }]\n",
        "2:37: error: the least scale is greater than the most");
    assert_refused(
        RED
        "objects: [{ object: Scatter, count: -1, objects: [{ object: Box, material: red }] }]\n",
        "2:37: error: count is -1; it must be from 0 to 1048576");
    assert_refused(
        RED
        "objects: [{ object: Scatter, seed: 0.5, objects: [{ object: Box, material: red }] }]\n",
        "2:36: error: seed expects an integer, not the number 0.5");
    assert_refused(RED "objects: [{ object: Scatter, count: 1000, objects: [{ object: Box }] }]\n",
                   "2:53: error: Box requires 'material'");
    assert_refused(RED "objects: [{ object: Scatter, count: 1048576, objects: [{ object: Scatter, "
                       "count: 1048576, objects: [] }] }]\n",
                   "2:56: error: more than 1048576 objects and groups");
    assert_refused(RED "objects: [{ object: Scatter, count: 600000, objects: [{ object: Box, "
                       "material: red }] }]\n",
                   "2:55: error: more than 1048576 objects and groups");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(published), cmocka_unit_test(places),
                                       cmocka_unit_test(whole_range), cmocka_unit_test(refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
