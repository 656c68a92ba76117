/* Every row of translations.def against numbers from the models' specifications, listed in
 * translation_values.def: the parameters of the resulting Principled. Each document is read
 * twice: with constants, so that the translation's formulas fold to numbers, and with uniforms,
 * so that they become expressions. */
#include "tests/test.h"
#include "compiler/document.h"
#include "compiler/oracle/oracle_maps.h"
#include "grammar/translation_tables.h"
#include "tests/compile_text.h"
#include <math.h>

static const double NEAR = 1e-6; /* the table has seven decimals */
enum { MAX_TEXT = 1024 };

typedef enum { ALWAYS, WHERE, NORMAL } How;
typedef struct {
    Kind material;
    How how;
    int param; /* of Principled, in param_table */
    int components;
    double value[3];
    const char *text;
} Row;

#define V(x, y, z)                                                                                 \
    3, { x, y, z }
#define N1(x)                                                                                      \
    1, { x }
#define VALUE(material, how, param, value, text)                                                   \
    {KIND_##material, how, P_Principled_##param, value, text},
static const Row rows[] = {
#include "tests/translation_values.def"
};
enum { ROWS = sizeof rows / sizeof *rows };

static How how_of(const TranslationRow *row)
{
    return !row->formula ? NORMAL : row->where ? WHERE : ALWAYS;
}

static bool is_of(const Row *row, const TranslationRow *translation)
{
    return row->material == translation->from && row->param == translation->to &&
           row->how == how_of(translation);
}

static bool is_direction(int param)
{
    return param == P_Principled_input || param == P_Principled_coatNormal;
}

/* -- Values ------------------------------------------------------------------------------------ */

/* Evaluates a parameter of the Principled at a point whose tangents are x and y; a normal is
 * normalized. */
static void read_param(MatcDocument *document, int param, double value[3])
{
    static const ReferenceContext context = {.noise = REFERENCE_GROIMP};
    const Node *material = document->graph->materials[0].node;
    assert_int_equal(material->kind, KIND_Principled);
    Surface surface;
    oracle_surface_default(&surface);
    Oracle *oracle = oracle_open(document->graph, &context);
    Environment environment = environment_open(oracle, &surface, 0);
    for (int component = 0; component < 3; component++) {
        const int channel = channel_id(is_direction(param) ? GROUP_N : GROUP_R, component);
        value[component] = param_table[param].type == PARAM_Map
                               ? oracle_query_param(&environment, material, param, channel)
                               : oracle_number(material, param);
    }
    oracle_close(oracle);
    const double size = sqrt(value[0] * value[0] + value[1] * value[1] + value[2] * value[2]);
    for (int component = 0; is_direction(param) && component < 3; component++)
        value[component] /= size;
}

static void check_value(const Row *row, const char *text)
{
    const MatcOptions options = quick();
    MatcDocument *document = read_text(text, &options);
    if (!document->graph)
        fail_msg("%s%s", text, matc_diagnostics(document, MATC_TEXT));
    double value[3];
    read_param(document, row->param, value);
    matc_document_free(document);
    for (int component = 0; component < row->components; component++)
        if (!(fabs(value[component] - row->value[component]) <= NEAR))
            fail_msg("%s%s is %.7g, not %.7g, in component %d", text, param_table[row->param].name,
                     value[component], row->value[component], component);
}

static void numbers_become_numbers(void **state)
{
    (void)state;
    for (int i = 0; i < ROWS; i++) {
        char text[MAX_TEXT];
        snprintf(text, sizeof text, "material: %s\n%s", kind_table[rows[i].material].name,
                 rows[i].text);
        check_value(&rows[i], text);
    }
}

static const ParamRow *find_param(Kind kind, const char *name, size_t size)
{
    const ParamRow *param = &param_table[kind_table[kind].first];
    for (int i = 0; i < kind_table[kind].count; i++)
        if (strlen(param[i].name) == size && !strncmp(param[i].name, name, size))
            return &param[i];
    fail_msg("%.*s is no parameter of %s", (int)size, name, kind_table[kind].name);
    return NULL;
}

/* "key: .5" of a map becomes "key: { param: pkey, default: .5 }"; other lines stay. */
static void put_uniforms(char text[MAX_TEXT], const Row *row)
{
    int size = snprintf(text, MAX_TEXT, "material: %s\n", kind_table[row->material].name);
    for (const char *line = row->text, *end; *line; line = end + 1) {
        end = strchr(line, '\n');
        const char *value = strstr(line, ": ") + 2;
        const int key = (int)(value - 2 - line), rest = (int)(end - value);
        const bool is_map = find_param(row->material, line, (size_t)key)->type == PARAM_Map;
        size += is_map && strchr(".[0123456789", *value)
                    ? snprintf(text + size, (size_t)(MAX_TEXT - size),
                               "%.*s: { param: p%.*s, default: %.*s }\n", key, line, key, line,
                               rest, value)
                    : snprintf(text + size, (size_t)(MAX_TEXT - size), "%.*s\n", (int)(end - line),
                               line);
        assert_true(size < MAX_TEXT);
    }
}

static void uniforms_become_expressions(void **state)
{
    (void)state;
    for (int i = 0; i < ROWS; i++) {
        char text[MAX_TEXT];
        put_uniforms(text, &rows[i]);
        check_value(&rows[i], text);
    }
}

/* -- The table is whole ------------------------------------------------------------------------ */

/* The row's number is Principled's default: the row would pass without the translation. */
static bool is_default(const Row *row)
{
    const ParamRow *param = &param_table[row->param];
    bool same = row->components <= param->components;
    for (int component = 0; same && component < row->components; component++)
        same = row->value[component] == param->init[component];
    return same;
}

/* Each translation has a row whose number differs from the default. A TRANSLATED_WHERE may equal
 * the default, since its number differs from that of the TRANSLATION without the condition. */
static void every_translation_has_a_row(void **state)
{
    (void)state;
    for (int i = 0; i < translation_count; i++) {
        const TranslationRow *translation = &translation_table[i];
        int found = 0;
        for (int j = 0; j < ROWS; j++)
            found +=
                is_of(&rows[j], translation) && (!is_default(&rows[j]) || rows[j].how == WHERE);
        if (!found)
            fail_msg("translation_values.def lacks %s's %s, away from its default",
                     kind_table[translation->from].name, param_table[translation->to].name);
    }
    for (int j = 0; j < ROWS; j++) {
        bool found = false;
        for (int i = 0; i < translation_count; i++)
            found |= is_of(&rows[j], &translation_table[i]);
        if (!found)
            fail_msg("translations.def lacks %s's %s", kind_table[rows[j].material].name,
                     param_table[rows[j].param].name);
    }
}

static bool is_set(Kind material, const char *name)
{
    for (int i = 0; i < ROWS; i++)
        for (const char *at = rows[i].text; rows[i].material == material && *at; at++)
            if ((at == rows[i].text || at[-1] == '\n') && !strncmp(at, name, strlen(name)) &&
                at[strlen(name)] == ':')
                return true;
    return false;
}

static bool is_lost(int param)
{
    for (int i = 0; i < loss_count; i++)
        if (param_table[loss_table[i].param].kind == param_table[param].kind &&
            (loss_table[i].param == param ||
             strstr(loss_table[i].formula, param_table[param].name)))
            return true;
    return false;
}

/* Some row sets each parameter, or a LOSS lists it as not read. Parameters of displacement are
 * exempt: they are copied unchanged. */
static void every_parameter_is_set(void **state)
{
    (void)state;
    const int moves = kind_table[KIND_Principled].first + kind_table[KIND_Principled].count -
                      P_Principled_displacement;
    static const Kind materials[] = {KIND_glTF, KIND_StandardSurface, KIND_UsdPreview};
    for (size_t i = 0; i < sizeof materials / sizeof *materials; i++) {
        const KindRow *kind = &kind_table[materials[i]];
        for (int param = kind->first; param < kind->first + kind->count - moves; param++)
            if (!is_set(materials[i], param_table[param].name) && !is_lost(param))
                fail_msg("no row sets %s's %s", kind->name, param_table[param].name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_translation_has_a_row),
        cmocka_unit_test(every_parameter_is_set),
        cmocka_unit_test(numbers_become_numbers),
        cmocka_unit_test(uniforms_become_expressions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
