/* Defaults, ranges, units and presets of scenes, each written down in scene_defaults.def. A key
 * of scene.def that has no row there fails, as does a row that scene.def lacks. */
/* ctest: quick */
#include "grammar/scene_tables.h"
#include "tests/test.h"
#include <math.h>
#include <string.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

typedef enum { A_NUMBER, A_TRUTH, A_CHOICE, A_VECTOR, A_NOTHING } Sort;

typedef struct {
    Sort sort;
    const char *kind, *key;
    double init[3], least, greatest;
    const char *unit;
} Default;

typedef struct {
    const char *kind, *key, *word, *name;
    double value;
} Preset;

#define V(x, y, z)                                                                                 \
    {                                                                                              \
        x, y, z                                                                                    \
    }
#define PRESET(kind, key, word, name, value)
#define NUMBER(kind, key, init, least, greatest, unit)                                             \
    {A_NUMBER, #kind, #key, {init}, least, greatest, unit},
#define VECTOR(kind, key, init, least, greatest, unit)                                             \
    {A_VECTOR, #kind, #key, init, least, greatest, unit},
#define TRUTH(kind, key, init) {A_TRUTH, #kind, #key, {init}, -INFINITY, INFINITY, ""},
#define CHOICE(kind, key, list, word)                                                              \
    {A_CHOICE, #kind, #key, {KEYWORD_##list##_##word}, -INFINITY, INFINITY, ""},
#define NOTHING(kind, key) {A_NOTHING, #kind, #key, {0}, -INFINITY, INFINITY, ""},
static const Default defaults[] = {
#include "tests/scene_defaults.def"
};

#define NUMBER(kind, key, init, least, greatest, unit)
#define VECTOR(kind, key, init, least, greatest, unit)
#define TRUTH(kind, key, init)
#define CHOICE(kind, key, list, word)
#define NOTHING(kind, key)
#define PRESET(kind, key, word, name, value) {#kind, #key, #word, #name, value},
static const Preset presets[] = {
#include "tests/scene_defaults.def"
};

static bool is_part(const SceneParamRow *row)
{
    return row->value == SCENE_VALUE_one || row->value == SCENE_VALUE_list;
}

static Sort sort_of(const SceneParamRow *row)
{
    if (row->param.components != 1)
        return row->param.components ? A_VECTOR : A_NOTHING;
    switch (row->param.type) {
    case PARAM_Bool:
        return A_TRUTH;
    case PARAM_Float:
    case PARAM_Int:
        return A_NUMBER;
    default:
        return A_CHOICE;
    }
}

static const Default *find_default(const char *kind, const char *key)
{
    const Default *found = NULL;
    for (int i = 0; i < COUNT(defaults); i++)
        if (!strcmp(defaults[i].kind, kind) && !strcmp(defaults[i].key, key)) {
            if (found)
                fail_msg("%s.%s has two rows", kind, key);
            found = &defaults[i];
        }
    return found;
}

static void each_key(void **state)
{
    (void)state;
    int keys = 0;
    for (int i = 0; i < SCENE_PARAM_COUNT; i++) {
        const SceneParamRow *row = &scene_param_table[i];
        const char *kind = scene_kind_table[row->kind].name, *key = row->param.name;
        const Default *expected = find_default(kind, key);
        if (is_part(row))
            continue;
        keys++;
        if (!expected)
            fail_msg("%s.%s is not written down in scene_defaults.def", kind, key);
        if (expected->sort != sort_of(row))
            fail_msg("%s.%s is of another type", kind, key);
        for (int k = 0; k < row->param.components; k++)
            if (row->param.init[k] != expected->init[k])
                fail_msg("%s.%s is %g by default, not %g", kind, key, row->param.init[k],
                         expected->init[k]);
        if (row->param.low != expected->least || row->param.high != expected->greatest)
            fail_msg("%s.%s is from %g to %g, not from %g to %g", kind, key, row->param.low,
                     row->param.high, expected->least, expected->greatest);
        assert_string_equal(row->unit, expected->unit);
    }
    assert_int_equal(keys, COUNT(defaults));
}

static bool is_preset(const ScenePresetRow *row, const Preset *preset)
{
    const SceneParamRow *key = &scene_param_table[row->key];
    return !strcmp(scene_kind_table[key->kind].name, preset->kind) &&
           !strcmp(key->param.name, preset->key) &&
           !strcmp(keyword_table[row->word].name, preset->word) &&
           keyword_table[row->word].list == key->param.type &&
           !strcmp(scene_param_table[row->param].param.name, preset->name) &&
           row->value == preset->value;
}

static void each_preset(void **state)
{
    (void)state;
    assert_int_equal(scene_preset_count, COUNT(presets));
    for (int i = 0; i < COUNT(presets); i++) {
        bool found = false;
        for (int k = 0; k < scene_preset_count; k++)
            found |= is_preset(&scene_preset_table[k], &presets[i]);
        if (!found)
            fail_msg("%s.%s by %s: %s is another", presets[i].kind, presets[i].name, presets[i].key,
                     presets[i].word);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_key),
        cmocka_unit_test(each_preset),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
