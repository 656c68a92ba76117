/* The tables of grammar/: their rows are consistent, and every parameter of every kind is tried
 * at its default, at both ends of its range, outside the range, and with a value of another
 * type. A new row adds its own cases. */
/* ctest: quick */
#include "tests/test.h"
#include "grammar/foreign_table.h"
#include "grammar/key_table.h"
#include "grammar/layout_tables.h"
#include "compiler/matc.h"
#include "grammar/scene_tables.h"
#include "grammar/unit_table.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { LONGEST_DOCUMENT = 512 };

static bool is_sentence(const char *doc)
{
    size_t size = doc ? strlen(doc) : 0;
    return size > 3 && doc[size - 1] == '.';
}

static void rows_are_documented(void **state)
{
    (void)state;
    for (int i = 0; i < KIND_COUNT; i++)
        assert_true(is_sentence(kind_table[i].doc));
    for (int i = 0; i < PARAM_COUNT; i++)
        assert_true(is_sentence(param_table[i].doc));
    for (int i = 0; i < WAVE_COUNT; i++)
        assert_true(is_sentence(wave_table[i].doc));
    for (int i = 0; i < WORD_COUNT; i++)
        assert_true(is_sentence(keyword_table[i].doc));
    for (int i = 0; i < SLOT_COUNT; i++)
        assert_true(is_sentence(slot_table[i].doc));
    for (int i = 0; i < ENCODING_COUNT; i++)
        assert_true(is_sentence(encoding_table[i].doc));
    for (int i = 0; i < LAYOUT_COUNT; i++)
        for (int number = 0; number < layout_table[i].case_count; number++)
            assert_true(is_sentence(layout_table[i].cases[number].doc));
}

/* A PARAM line under another kind than it names would compile silently. */
static void parameters_stand_under_their_kind(void **state)
{
    (void)state;
    int next = 0;
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        assert_int_equal(kind_table[kind].first, next);
        for (int i = 0; i < kind_table[kind].count; i++)
            assert_int_equal(param_table[next++].kind, kind);
    }
    assert_int_equal(next, PARAM_COUNT);
}

static void defaults_are_in_range(void **state)
{
    (void)state;
    for (int i = 0; i < PARAM_COUNT; i++)
        for (int component = 0; component < param_table[i].components; component++)
            assert_true(param_table[i].init[component] >= param_table[i].low &&
                        param_table[i].init[component] <= param_table[i].high);
}

/* Checks the rows of scene.def. */
static void scenes_are_sound(void **state)
{
    (void)state;
    int next = 0;
    for (int sort = 0; sort < SCENE_SORT_COUNT; sort++)
        assert_true(is_sentence(scene_sort_table[sort].doc));
    for (int kind = 0; kind < SCENE_KIND_COUNT; kind++) {
        assert_true(is_sentence(scene_kind_table[kind].doc));
        assert_int_equal(scene_kind_table[kind].first, next);
        for (int i = 0; i < scene_kind_table[kind].count; i++, next++) {
            const ParamRow *param = &scene_param_table[next].param;
            assert_int_equal(scene_param_table[next].kind, kind);
            assert_true(is_sentence(param->doc));
            for (int component = 0; component < param->components; component++)
                assert_true(param->init[component] >= param->low &&
                            param->init[component] <= param->high);
        }
    }
    assert_int_equal(next, SCENE_PARAM_COUNT);
}

static void maps_have_their_files(void **state)
{
    (void)state;
    char path[256];
    assert_int_equal(chdir(SOURCE_FOLDER), 0);
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        if (kind_table[kind].lowering == LOWERING_MATERIAL)
            continue;
        snprintf(path, sizeof path, "examples/%s.yaml", kind_table[kind].function);
        assert_int_equal(access(path, R_OK), 0);
        snprintf(path, sizeof path, "compiler/library/maps/%s.glsl", kind_table[kind].function);
        assert_int_equal(access(path, R_OK) == 0, kind_table[kind].lowering == LOWERING_VOLUME);
    }
}

/* Temporaries with one are not looked for among them: emit_name.c. */
static void no_function_has_an_underscore(void **state)
{
    (void)state;
    for (int i = 0; i < FUNCTION_COUNT; i++)
        assert_false(function_row(i)->name && strchr(function_row(i)->name, '_'));
}

/* Whether a document compiles: a fault in it is one, an internal fault fails the test. */
static bool compiles(const char *text)
{
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    options.check = true;
    MatcDocument *document = matc_read("case.yaml", text, strlen(text), &options);
    bool fine = matc_material_count(document) > 0;
    for (options.optimize = 0; fine && options.optimize <= 2; options.optimize += 2) {
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        if (!matc_ok(program))
            fprintf(stderr, "%s%s", text, matc_program_diagnostics(program, MATC_TEXT));
        assert_true(matc_ok(program));
        matc_program_free(program);
    }
    matc_document_free(document);
    return fine;
}

static bool tries(const ParamRow *row, const char *value)
{
    char text[LONGEST_DOCUMENT];
    const char *kind = kind_table[row->kind].name;
    if (kind_table[row->kind].lowering == LOWERING_MATERIAL)
        snprintf(text, sizeof text, "material: %s\n%s: %s\n", kind, row->name, value);
    else
        snprintf(text, sizeof text, "material: Phong\ndiffuse: { map: %s, %s: %s }\n", kind,
                 row->name, value);
    return compiles(text);
}

static bool tries_number(const ParamRow *row, double value)
{
    char text[64];
    snprintf(text, sizeof text, row->type == PARAM_Vec3 ? "[%.17g, 0.5, 0.25]" : "%.17g", value);
    return tries(row, text);
}

static void try_numeric(const ParamRow *row)
{
    assert_true(tries_number(row, row->init[0]));
    bool bounded = isfinite(row->high);
    double low = bounded ? row->low : -1000, high = bounded ? row->high : 1000;
    assert_true(tries_number(row, low));
    assert_true(tries_number(row, high));
    if (bounded) {
        assert_false(tries_number(row, low - 1));
        assert_false(tries_number(row, high + 1));
    }
    if (row->type == PARAM_Int)
        assert_false(tries(row, "2.5"));
    assert_false(tries(row, "1e39"));
    assert_false(tries(row, ".nan"));
    assert_false(tries(row, "{ map: Wood }"));
}

/* Lists may have words of one name. */
static bool has_word(int list, const char *name)
{
    bool found = false;
    for (int i = 0; i < WORD_COUNT; i++)
        found |= (int)keyword_table[i].list == list && !strcmp(keyword_table[i].name, name);
    return found;
}

static void try_words(const ParamRow *row)
{
    for (int i = 0; i < WORD_COUNT; i++)
        assert_int_equal(tries(row, keyword_table[i].name),
                         has_word((int)row->type, keyword_table[i].name));
    assert_false(tries(row, "other"));
    assert_false(tries(row, "0"));
}

/* A number is within the row's range; what varies may be anything. */
static void try_map(const ParamRow *row)
{
    assert_true(tries(row, "0.5") && tries(row, "= u + .5") && tries(row, "{ map: Granite }") &&
                !tries(row, "true"));
    if (!isfinite(row->high))
        return;
    assert_true(tries_number(row, row->low) && tries_number(row, row->high));
    assert_false(tries_number(row, row->low - 1) || tries_number(row, row->high + 1));
    assert_false(tries(row, "[1, 1, 1e30]") || tries(row, "{ param: a, default: -1e30 }"));
}

static void every_parameter_is_tried(void **state)
{
    (void)state;
    for (int i = 0; i < PARAM_COUNT; i++) {
        const ParamRow *row = &param_table[i];
        bool numeric =
            row->type == PARAM_Float || row->type == PARAM_Int || row->type == PARAM_Vec3;
        if (numeric)
            try_numeric(row);
        else if (row->type == PARAM_Map)
            try_map(row);
        else if (row->type == PARAM_Material)
            assert_true(tries(row, "{ material: RGBA }") && !tries(row, "0.5"));
        else if (row->type == PARAM_Bool)
            assert_true(tries(row, "true") && tries(row, "false") && !tries(row, "2"));
        else if (row->type == PARAM_List)
            assert_true(tries(row, "[1, { map: Granite }]") && tries(row, "[]") &&
                        !tries(row, "[true]") && !tries(row, "1"));
        else
            assert_false(tries(row, "[1, 2]"));
        if (param_is_word(row))
            try_words(row);
        assert_true(tries(row, "null"));
    }
}

static void every_wave_is_known(void **state)
{
    (void)state;
    char text[LONGEST_DOCUMENT];
    for (int i = 0; i < WAVE_COUNT; i++) {
        snprintf(text, sizeof text, "material: Phong\ndiffuse: { map: Wood, waveForm: %s }\n",
                 wave_table[i].name);
        assert_true(compiles(text));
    }
}

static void every_alias_and_preset_is_known(void **state)
{
    (void)state;
    char text[LONGEST_DOCUMENT];
    for (int i = 0; i < alias_count + preset_count; i++) {
        const char *name =
            i < alias_count ? alias_table[i].alias : preset_table[i - alias_count].name;
        Kind kind = i < alias_count ? alias_table[i].kind : preset_table[i - alias_count].kind;
        bool material = kind_table[kind].lowering == LOWERING_MATERIAL;
        snprintf(text, sizeof text,
                 material ? "material: %s\n" : "material: Phong\ndiffuse: { map: %s }\n", name);
        assert_true(compiles(text));
    }
}

static bool is_kind(const char *name, size_t size, bool material)
{
    for (int kind = 0; kind < KIND_COUNT; kind++)
        if (strlen(kind_table[kind].name) == size && !strncmp(kind_table[kind].name, name, size))
            return (kind_table[kind].lowering == LOWERING_MATERIAL) == material;
    return false;
}

static bool is_param(Kind kind, const char *name, size_t size)
{
    for (int i = 0; i < kind_table[kind].count; i++) {
        const char *param = param_table[kind_table[kind].first + i].name;
        if (strlen(param) == size && !strncmp(param, name, size))
            return true;
    }
    return false;
}

/* A kind of scene.def, or a parameter of one. */
static bool is_of_scene(const char *name, size_t size, bool kind)
{
    for (int i = 0; kind && i < SCENE_KIND_COUNT; i++)
        if (strlen(scene_kind_table[i].name) == size &&
            !strncmp(scene_kind_table[i].name, name, size))
            return true;
    for (int i = 0; !kind && i < SCENE_PARAM_COUNT; i++)
        if (strlen(scene_param_table[i].param.name) == size &&
            !strncmp(scene_param_table[i].param.name, name, size))
            return true;
    return false;
}

static bool is_key(const char *name, size_t size)
{
    for (int i = 0; i < DOCUMENT_KEY_COUNT; i++)
        if (strlen(key_table[i].name) == size && !strncmp(key_table[i].name, name, size))
            return true;
    return false;
}

/* The message about another tool's name begins with a name of ours, except for these words. */
static void foreign_names_lead_to_ours(void **state)
{
    static const char *const others[] = {"a formula: '= ",
                                         "nothing: ",
                                         "a key of scenes, ",
                                         "a key of definitions: ",
                                         "bricks of the library: ",
                                         "the fourth number of diffuse",
                                         "material: of a material, ",
                                         "\"#"};
    (void)state;
    for (int i = 0; i < foreign_count; i++) {
        const ForeignRow *row = &foreign_table[i];
        const size_t size = strcspn(row->here, " ,:;");
        bool ours = row->group == FOREIGN_PARAM   ? is_param(row->kind, row->here, size)
                    : row->group == FOREIGN_SCENE ? is_of_scene(row->here, size, true)
                    : row->group == FOREIGN_PLACE ? is_of_scene(row->here, size, false)
                    : row->group == FOREIGN_TOP
                        ? is_of_scene(row->here, size, false) || is_key(row->here, size)
                    : row->group >= FOREIGN_FORMULA
                        ? true /* test_formula.c, test_foreign.c */
                        : is_kind(row->here, size, row->group == FOREIGN_MATERIAL);
        for (size_t k = 0; k < sizeof others / sizeof *others; k++)
            ours |= !strncmp(row->here, others[k], strlen(others[k]));
        if (!ours)
            fail_msg("'%s' leads to '%s', which is not here", row->name, row->here);
        /* no name stands twice */
        assert_string_equal(foreign_name(row->group, row->kind, row->name), row->here);
    }
}

/* A name that is ours, written in another way, is no foreign one. */
static void foreign_names_are_not_ours(void **state)
{
    (void)state;
    for (int i = 0; i < PARAM_COUNT; i++)
        assert_null(foreign_name(FOREIGN_PARAM, param_table[i].kind, param_table[i].name));
    for (int i = 0; i < color_count; i++)
        assert_null(foreign_name(FOREIGN_COLOR, KIND_COUNT, color_table[i].name));
    for (int i = 0; i < DOCUMENT_KEY_COUNT; i++)
        assert_null(foreign_name(FOREIGN_TOP, KIND_COUNT, key_table[i].name));
    for (int i = 0; i < KIND_COUNT + alias_count + preset_count; i++) {
        const int alias = i - KIND_COUNT, preset = alias - alias_count;
        const Kind kind = alias < 0    ? (Kind)i
                          : preset < 0 ? alias_table[alias].kind
                                       : preset_table[preset].kind;
        const char *name = alias < 0    ? kind_table[i].name
                           : preset < 0 ? alias_table[alias].alias
                                        : preset_table[preset].name;
        const bool material = kind_table[kind].lowering == LOWERING_MATERIAL;
        assert_null(foreign_name(material ? FOREIGN_MATERIAL : FOREIGN_MAP, KIND_COUNT, name));
    }
}

/* Defaults are usual, and what is unusual has two ends. */
static void units_hold_defaults(void **state)
{
    (void)state;
    int measured = 0;
    for (int i = 0; i < PARAM_COUNT; i++) {
        const UnitRow *unit = unit_of(i);
        measured += unit != NULL;
        if (!unit)
            continue;
        assert_true(isfinite(unit->low) == isfinite(unit->high) && unit->low < unit->high);
        assert_true(param_table[i].init[0] >= unit->low && param_table[i].init[0] <= unit->high);
        if (*unit->other)
            assert_true(unit->factor > 0 && unit->factor < 1);
    }
    assert_true(measured > 130);
    assert_true(unit_of(P_Principled_baseColor) == NULL);
    assert_string_equal(unit_of(P_Principled_filmThickness)->name, "micrometers");
    assert_true(fabs(unit_table[UNIT_radians].high - 2 * acos(-1)) < 1e-12);
}

/* The line of the table of docs/reference/semantics.md that begins so has the parameter. */
static bool tells(const char *page, const char *head, const char *param)
{
    char quoted[64];
    const char *line = strstr(page, head), *end = line ? strchr(line + 1, '\n') : NULL;
    snprintf(quoted, sizeof quoted, "`%s`", param);
    const char *found = line ? strstr(line, quoted) : NULL;
    return found && end && found < end;
}

/* Every parameter that is one number all over, and why; a volume map's own are the arguments of its
 * function, for which the table has one reason. */
static void plain_numbers_have_a_reason(void **state)
{
    (void)state;
    enum { LONGEST_PAGE = 1 << 20 };
    static char page[LONGEST_PAGE];
    FILE *file = fopen("docs/reference/semantics.md", "rb");
    assert_non_null(file);
    page[fread(page, 1, LONGEST_PAGE - 1, file)] = 0;
    fclose(file);
    int plain = 0;
    for (int i = 0; i < PARAM_COUNT; i++) {
        const ParamRow *row = &param_table[i];
        char head[64];
        snprintf(head, sizeof head, "\n| `%s` |", kind_table[row->kind].name);
        const bool wave = !strcmp(row->name, "frequency") || !strcmp(row->name, "phase");
        if (row->type != PARAM_Float)
            continue;
        plain++;
        if (section_of(row->kind) == SECTION_volume && !wave)
            continue;
        if (!tells(page, head, row->name) &&
            !tells(page, wave ? "\n| every volume map" : "\n| every material |", row->name))
            fail_msg("%s.%s is a number, and docs/reference/semantics.md does not say why",
                     kind_table[row->kind].name, row->name);
    }
    assert_true(plain > 50);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_are_documented),
        cmocka_unit_test(parameters_stand_under_their_kind),
        cmocka_unit_test(defaults_are_in_range),
        cmocka_unit_test(scenes_are_sound),
        cmocka_unit_test(maps_have_their_files),
        cmocka_unit_test(no_function_has_an_underscore),
        cmocka_unit_test(every_parameter_is_tried),
        cmocka_unit_test(every_wave_is_known),
        cmocka_unit_test(every_alias_and_preset_is_known),
        cmocka_unit_test(foreign_names_lead_to_ours),
        cmocka_unit_test(foreign_names_are_not_ours),
        cmocka_unit_test(units_hold_defaults),
        cmocka_unit_test(plain_numbers_have_a_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
