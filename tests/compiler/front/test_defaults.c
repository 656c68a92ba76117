/* Defaults of documents: every parameter, the presets, the named colors, and the rows of
 * --precision, each written down here from semantics.md and the published palettes, not from the
 * tables. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/document.h"
#include "compiler/resolve/resolve.h"
#include "compiler/pipeline.h"
#include <stdio.h>
#include <string.h>

enum { NONE = -1 }; /* components of a parameter without a default: a map, a wave, a picture */

typedef struct {
    const char *kind, *param;
    int components;
    double value[3];
} Default;

static const Default defaults[] = {
#include "tests/defaults.def"
};

/* Parameters of every volume map: those below VOLUME_PARAMS, and three maps that are OWN. */
static const Default volume_defaults[] = {
    {NULL, "input", NONE, {0}},
    {NULL, "waveForm", NONE, {0}},
    {NULL, "frequency", 1, {1}},
    {NULL, "phase", 1, {0}},
};

typedef struct {
    MatcDocument *document;
    const Node *node; /* the map or material that was asked for */
} Lone;

/* A document in which a map or material stands with its kind alone. */
static Lone read_lone(const char *kind, bool material)
{
    char text[128];
    MatcOptions options;
    matc_options_init(&options);
    snprintf(text, sizeof text,
             material ? "material: %s\n" : "material: Phong\ndiffuse: { map: %s }\n", kind);
    Lone lone = {matc_read("a.yaml", text, strlen(text), &options), NULL};
    assert_non_null(lone.document->graph);
    lone.node = lone.document->graph->materials[0].node;
    if (!material)
        lone.node = node_param(lone.node, P_Phong_diffuse)->node;
    return lone;
}

/* Checks a number, a map that is one, or an absent value. */
static void check_value(const char *kind, const Default *row, const Value *value)
{
    if (value->kind == VALUE_node)
        value = &value->node->params[0];
    const int components = value->kind == VALUE_number ? type_table[value->type].components : NONE;
    if (value->kind != VALUE_none && components != row->components)
        fail_msg("%s.%s has %d lanes, not %d", kind, row->param, components, row->components);
    if (value->kind == VALUE_none && row->components != NONE)
        fail_msg("%s.%s has no default", kind, row->param);
    for (int i = 0; i < row->components; i++)
        if (value->number[i] != row->value[i])
            fail_msg("%s.%s is %g, not %g", kind, row->param, value->number[i], row->value[i]);
}

static const Default *find_default(const KindRow *kind, const char *param)
{
    bool volume = kind->lowering == LOWERING_VOLUME || kind == &kind_table[KIND_Gradient] ||
                  kind == &kind_table[KIND_VolumeTurbulence] || kind == &kind_table[KIND_Cells];
    for (size_t i = 0; i < sizeof defaults / sizeof *defaults; i++)
        if (!strcmp(defaults[i].kind, kind->name) && !strcmp(defaults[i].param, param))
            return &defaults[i];
    for (size_t k = 0; volume && k < sizeof volume_defaults / sizeof *volume_defaults; k++)
        if (!strcmp(volume_defaults[k].param, param))
            return &volume_defaults[k];
    return NULL;
}

/* Whether semantics.md has the kind: its parameters are all written down here, also where that is
 * none but those of all volume maps. A volume map that was added since means what its own row
 * says. */
static bool is_written(const KindRow *kind)
{
    static const char *const without_own[] = {"Granite", "Leopard", "Wood"};
    for (size_t i = 0; i < sizeof defaults / sizeof *defaults; i++)
        if (!strcmp(defaults[i].kind, kind->name))
            return true;
    for (size_t i = 0; i < sizeof without_own / sizeof *without_own; i++)
        if (!strcmp(without_own[i], kind->name))
            return true;
    return kind->lowering != LOWERING_VOLUME;
}

/* Checks every parameter of every kind; one without a row here fails. */
static void test_every_default(void **state)
{
    (void)state;
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        /* always given; test_translation.c */
        if (kind == KIND_Constant || resolve_is_foreign((Kind)kind))
            continue;
        const KindRow *row = &kind_table[kind];
        Lone lone = read_lone(row->name, row->lowering == LOWERING_MATERIAL);
        assert_int_equal(lone.node->kind, kind);
        for (int i = 0; i < row->count; i++) {
            const char *param = param_table[row->first + i].name;
            const Default *expected = find_default(row, param);
            if (!expected && !is_written(row))
                continue;
            if (!expected)
                fail_msg("%s.%s is not written down here", row->name, param);
            check_value(row->name, expected, &lone.node->params[i]);
        }
        matc_document_free(lone.document);
    }
}

/* Wrinkles is a VolumeTurbulence of eleven octaves, each half as strong as the one before. */
static void test_presets(void **state)
{
    (void)state;
    static const Default wrinkles[] = {
        {NULL, "size", 1, {1}},        {NULL, "octaves", 1, {11}},
        {NULL, "noiseRatio", 1, {.5}}, {NULL, "frequencyRatio", 1, {2}},
        {NULL, "frequency", 1, {1}},   {NULL, "phase", 1, {0}},
    };
    Lone lone = read_lone("Wrinkles", false);
    assert_int_equal(lone.node->kind, KIND_VolumeTurbulence);
    const KindRow *row = &kind_table[KIND_VolumeTurbulence];
    for (size_t k = 0; k < sizeof wrinkles / sizeof *wrinkles; k++)
        for (int i = 0; i < row->count; i++)
            if (!strcmp(param_table[row->first + i].name, wrinkles[k].param))
                check_value("Wrinkles", &wrinkles[k], &lone.node->params[i]);
    matc_document_free(lone.document);
}

/* The constants of java.awt.Color, and the sixteen colors of EGA, by their bytes. */
static const struct {
    const char *name;
    uint32_t rgb;
} colors[] = {
    {"white", 0xFFFFFF},
    {"lightGray", 0xC0C0C0},
    {"gray", 0x808080},
    {"darkGray", 0x404040},
    {"black", 0x000000},
    {"red", 0xFF0000},
    {"pink", 0xFFAFAF},
    {"orange", 0xFFC800},
    {"yellow", 0xFFFF00},
    {"green", 0x00FF00},
    {"magenta", 0xFF00FF},
    {"cyan", 0x00FFFF},
    {"blue", 0x0000FF},
    {"egaBlack", 0x000000},
    {"egaBlue", 0x0000AA},
    {"egaGreen", 0x00AA00},
    {"egaCyan", 0x00AAAA},
    {"egaRed", 0xAA0000},
    {"egaMagenta", 0xAA00AA},
    {"egaBrown", 0xAA5500},
    {"egaLightGray", 0xAAAAAA},
    {"egaDarkGray", 0x555555},
    {"egaBrightBlue", 0x5555FF},
    {"egaBrightGreen", 0x55FF55},
    {"egaBrightCyan", 0x55FFFF},
    {"egaBrightRed", 0xFF5555},
    {"egaBrightMagenta", 0xFF55FF},
    {"egaBrightYellow", 0xFFFF55},
    {"egaWhite", 0xFFFFFF},
};

static void check_color(const char *text, double r, double g, double b)
{
    char document_text[64];
    MatcOptions options;
    matc_options_init(&options);
    snprintf(document_text, sizeof document_text, "material: Phong\ndiffuse: '%s'\n", text);
    MatcDocument *document = matc_read("a.yaml", document_text, strlen(document_text), &options);
    assert_non_null(document->graph);
    const Node *diffuse = node_param(document->graph->materials[0].node, P_Phong_diffuse)->node;
    const Value *value = &diffuse->params[0];
    if (value->number[0] != r / 255 || value->number[1] != g / 255 || value->number[2] != b / 255)
        fail_msg("%s is (%g, %g, %g) / 255", text, value->number[0] * 255, value->number[1] * 255,
                 value->number[2] * 255);
    matc_document_free(document);
}

static void test_colors(void **state)
{
    (void)state;
    assert_int_equal(color_count, sizeof colors / sizeof *colors);
    for (int i = 0; i < color_count; i++)
        check_color(colors[i].name, colors[i].rgb >> 16, colors[i].rgb >> 8 & 255,
                    colors[i].rgb & 255);
    check_color("#000", 0, 0, 0);
    check_color("#fff", 255, 255, 255);
    check_color("#08F", 0, 0x88, 0xFF);
    check_color("#01807f", 1, 128, 127);
    check_color("#0A0b0C80", 10, 11, 12);
}

/* Choices of `--precision` for each axis. */
static void test_precision(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        int noise, coordinates, powers, trigonometry;
    } rows[] = {
        {NULL, CHOICE_noise_lattice, CHOICE_coordinates_plain, CHOICE_powers_squaring,
         CHOICE_trigonometry_native},
        {"fast", CHOICE_noise_lattice, CHOICE_coordinates_plain, CHOICE_powers_squaring,
         CHOICE_trigonometry_native},
        {"balanced", CHOICE_noise_lattice, CHOICE_coordinates_long, CHOICE_powers_squaring,
         CHOICE_trigonometry_bounded},
        {"exact", CHOICE_noise_groimp, CHOICE_coordinates_long, CHOICE_powers_compensated,
         CHOICE_trigonometry_bounded},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        Job job;
        MatcOptions options;
        matc_options_init(&options);
        options.precision = rows[i].name;
        assert_null(choice_job(&options, &job));
        assert_int_equal(job.choice[AXIS_noise], rows[i].noise);
        assert_int_equal(job.choice[AXIS_coordinates], rows[i].coordinates);
        assert_int_equal(job.choice[AXIS_powers], rows[i].powers);
        assert_int_equal(job.choice[AXIS_trigonometry], rows[i].trigonometry);
        assert_int_equal(job.choice[AXIS_aa], CHOICE_aa_auto);
        assert_int_equal(job.choice[AXIS_derivatives], CHOICE_derivatives_auto);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_default),
        cmocka_unit_test(test_presets),
        cmocka_unit_test(test_colors),
        cmocka_unit_test(test_precision),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
