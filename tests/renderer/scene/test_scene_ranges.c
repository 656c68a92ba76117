/* Ranges of vectors: every vector of scene.def has a range, is accepted at both bounds in each
 * component, and is an error with its place one step outside. Transforms have no row of their
 * own; their range is that of a float. */
#include "tests/scene_text.h"
#include <float.h>
#include <stdlib.h>

/* Documents that hold one vector of each sort; %s are the kind and the key with its value. The
 * second line has the vector. */
static const struct {
    SceneSort sort;
    const char *text;
} documents[] = {
    {SCENE_SORT_camera, RED "camera: { camera: %s, %s }\n"},
    {SCENE_SORT_motion, RED "motion: { motion: %s, frames: 2, %s }\n"},
    {SCENE_SORT_key,
     RED "motion: { motion: Path, frames: 2, keys: [{ time: 0, %2$s }, { time: 1 }] } # %1$s\n"},
    {SCENE_SORT_object, RED "objects: [{ object: %s, material: red, %s }]\n"},
    {SCENE_SORT_light, RED "lights: [{ light: %s, %s }]\nsky: red\n"},
};

static const char *document_of(SceneSort sort)
{
    for (size_t i = 0; i < sizeof documents / sizeof *documents; i++)
        if (documents[i].sort == sort)
            return documents[i].text;
    fail_msg("a vector of %s, of which no test has a document", scene_sort_table[sort].name);
    return NULL;
}

static void put_text(const SceneParamRow *row, int component, double value, char text[512])
{
    char vector[160], texts[3][40];
    for (int i = 0; i < 3; i++)
        snprintf(texts[i], sizeof texts[i], "%.17g", i == component ? value : row->param.init[i]);
    snprintf(vector, sizeof vector, "%s: [%s, %s, %s]", row->param.name, texts[0], texts[1],
             texts[2]);
    snprintf(text, 512, document_of(scene_kind_table[row->kind].sort),
             scene_kind_table[row->kind].name, vector);
}

/* True if a value is refused for its range; other refusals, as for a view along `up`, do not
 * count. */
static bool is_out_of_range(const SceneParamRow *row, int component, double value)
{
    char text[512], fault[96], *reported;
    MatcDocument *document;
    put_text(row, component, value, text);
    Scene *scene = read_text(text, &document);
    snprintf(fault, sizeof fault, ": error: %s is ", row->param.name);
    reported = strstr(matc_diagnostics(document, MATC_TEXT), fault);
    const bool out = reported && strstr(reported, "it must be from");
    if (out)
        assert_int_equal(strncmp(matc_diagnostics(document, MATC_TEXT), "scene.yaml:2:", 13), 0);
    assert_true(!out || !scene);
    forget(scene, document);
    return out;
}

static void vectors_have_borders(void **state)
{
    (void)state;
    int vectors = 0;
    for (int i = 0; i < SCENE_PARAM_COUNT; i++) {
        const SceneParamRow *row = &scene_param_table[i];
        if (row->value != SCENE_VALUE_plain || row->param.type != PARAM_Vec3)
            continue;
        vectors++;
        if (!isfinite(row->param.low) || !isfinite(row->param.high))
            fail_msg("%s.%s has no range", scene_kind_table[row->kind].name, row->param.name);
        for (int component = 0; component < 3; component++)
            if (is_out_of_range(row, component, row->param.low) ||
                is_out_of_range(row, component, row->param.high) ||
                !is_out_of_range(row, component, nextafter(row->param.low, -INFINITY)) ||
                !is_out_of_range(row, component, nextafter(row->param.high, INFINITY)))
                fail_msg("%s.%s, component %d", scene_kind_table[row->kind].name, row->param.name,
                         component);
    }
    assert_true(vectors > 25);
}

/* The words, once. */
static void words(void **state)
{
    (void)state;
    assert_fault(RED "lights: [{ light: Area, u: [1e10, 0, 0] }]\n",
                 "2:28: error: u is 1e+10; it must be from -1e+09 to 1e+09");
    assert_fault(RED "camera: { camera: Perspective, position: [0, -2e9, 0] }\n",
                 "2:42: error: position is -2e+09; it must be from -1e+09 to 1e+09");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(vectors_have_borders),
                                       cmocka_unit_test(words)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
