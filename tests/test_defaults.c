/* What a document means where it says nothing: every parameter's default, the presets, the named colours, and the rows of --precision,
 * each written down here from semantics.md and the published palettes, and not from the tables. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "compiler/document.h"
#include "compiler/front/resolve.h"
#include "compiler/pipeline.h"
#include <stdio.h>
#include <string.h>

enum { NONE = -1 }; /* lanes of a parameter without a default: a map, a wave, a picture */

typedef struct {
    const char *kind, *param;
    int lanes;
    double value[3];
} Default;

static const Default defaults[] = {
    {"RGBColor", "r", 1, {.5}},
    {"RGBColor", "g", 1, {.5}},
    {"RGBColor", "b", 1, {.5}},
    {"Graytone", "value", 1, {.5}},
    {"Checker", "input", NONE, {0}},
    {"Checker", "color1", 1, {1}},
    {"Checker", "color2", 1, {0}},
    {"ImageMap", "input", NONE, {0}},
    {"ImageMap", "image", NONE, {0}},
    {"ImageMap", "bilinearFiltering", 1, {1}},
    {"ImageMap", "colorspace", 1, {WORD_ColorSpace_linear}},
    {"ImageMap", "channel", NONE, {0}},
    {"ImageMap", "address", 1, {WORD_Address_repeat}},
    {"Carpenter", "input", NONE, {0}},
    {"Carpenter", "color", 1, {.5}},
    {"Carpenter", "noise", 1, {1}},
    {"Carpenter", "roughness", 1, {1}},
    {"Carpenter", "seed", 1, {0}},
    {"Carpenter", "width", 1, {256}},
    {"Carpenter", "height", 1, {256}},
    {"Ramp", "input", NONE, {0}},
    {"Ramp", "a", 1, {0}},
    {"Ramp", "b", 1, {1}},
    {"Ramp", "along", 1, {WORD_Axis_u}},
    {"CornerRamp", "input", NONE, {0}},
    {"CornerRamp", "bottomLeft", 1, {0}},
    {"CornerRamp", "bottomRight", 1, {0}},
    {"CornerRamp", "topLeft", 1, {1}},
    {"CornerRamp", "topRight", 1, {1}},
    {"Gradient", "direction", 3, {1, 0, 0}},
    {"Mandel", "iterations", 1, {10}},
    {"Julia", "iterations", 1, {10}},
    {"Julia", "cx", 1, {.6}},
    {"Julia", "cy", 1, {.6}},
    {"VolumeTurbulence", "size", 1, {1}},
    {"VolumeTurbulence", "octaves", 1, {5}},
    {"VolumeTurbulence", "noiseRatio", 1, {1}},
    {"VolumeTurbulence", "frequencyRatio", 1, {2}},
    {"VolumeChecker", "input", NONE, {0}},
    {"VolumeChecker", "color1", 1, {1}},
    {"VolumeChecker", "color2", 1, {0}},
    {"Triplanar", "input", NONE, {0}},
    {"Triplanar", "x", NONE, {0}},
    {"Triplanar", "y", NONE, {0}},
    {"Triplanar", "z", NONE, {0}},
    {"Triplanar", "sharpness", 1, {4}},
    {"Cells", "value", 1, {WORD_CellsValue_F1}},
    {"Cells", "distance", 1, {WORD_Distance_euclidean}},
    {"Cells", "dimensions", 1, {3}},
    {"Cells", "jitter", 1, {1}},
    {"Mix", "a", 1, {0}},
    {"Mix", "b", 1, {1}},
    {"Mix", "amount", 1, {0.5}},
    {"Add", "a", 1, {0}},
    {"Add", "b", 1, {0}},
    {"Multiply", "a", 1, {1}},
    {"Multiply", "b", 1, {1}},
    {"Remap", "input", NONE, {0}},
    {"Remap", "low", 1, {0}},
    {"Remap", "high", 1, {1}},
    {"Remap", "toLow", 1, {0}},
    {"Remap", "toHigh", 1, {1}},
    {"Contrast", "input", NONE, {0}},
    {"Contrast", "amount", 1, {1}},
    {"Contrast", "pivot", 1, {0.5}},
    {"Clamp", "input", NONE, {0}},
    {"Clamp", "low", 1, {0}},
    {"Clamp", "high", 1, {1}},
    {"Power", "input", NONE, {0}},
    {"Power", "exponent", 1, {1}},
    {"HSV", "input", NONE, {0}},
    {"HSV", "hue", 1, {0}},
    {"HSV", "saturation", 1, {1}},
    {"HSV", "value", 1, {1}},
    {"Switch", "which", 1, {0}},
    {"Switch", "maps", NONE, {0}},
    {"Combine", "r", 1, {0}},
    {"Combine", "g", 1, {0}},
    {"Combine", "b", 1, {0}},
    {"Separate", "input", NONE, {0}},
    {"Separate", "channel", 1, {WORD_Channel_r}},
    {"NormalMap", "input", NONE, {0}},
    {"NormalMap", "normal", NONE, {0}},
    {"NormalMap", "scale", 1, {1}},
    {"NormalMap", "flipY", 1, {0}},
    {"NormalMap", "twoChannel", 1, {0}},
    {"CellCentre", "input", NONE, {0}},
    {"CellCentre", "distance", 1, {WORD_Distance_euclidean}},
    {"CellCentre", "jitter", 1, {1}},
    {"Blend", "input", NONE, {0}},
    {"Blend", "blend", NONE, {0}},
    {"UVTransform", "input", NONE, {0}},
    {"UVTransform", "offsetU", 1, {0}},
    {"UVTransform", "offsetV", 1, {0}},
    {"UVTransform", "scaleU", 1, {1}},
    {"UVTransform", "scaleV", 1, {1}},
    {"UVTransform", "angle", 1, {0}},
    {"UVTransform", "shear", 1, {0}},
    {"XYZTransform", "input", NONE, {0}},
    {"XYZTransform", "transform", NONE, {0}},
    {"XYZTransform", "useGlobal", 1, {0}},
    {"Turbulence", "input", NONE, {0}},
    {"Turbulence", "amount", 3, {.2, .2, .2}},
    {"Turbulence", "octaves", 1, {5}},
    {"Turbulence", "noiseRatio", 1, {2}},
    {"Turbulence", "frequencyRatio", 1, {2}},
    {"BumpMap", "input", NONE, {0}},
    {"BumpMap", "displacement", NONE, {0}},
    {"BumpMap", "strength", 1, {1}},
    {"WaveMap", "input", NONE, {0}},
    {"WaveMap", "amplitude", 1, {1}},
    {"WaveMap", "uCount", 1, {10}},
    {"WaveMap", "vCount", 1, {10}},
    {"WaveMap", "boxTop", 1, {0}},
    {"Smooth3D", "input", NONE, {0}},
    {"Smooth3D", "sx", 1, {1}},
    {"Smooth3D", "sy", 1, {1}},
    {"Smooth3D", "sz", 1, {1}},
    {"Laplace3D", "input", NONE, {0}},
    {"Laplace3D", "sx", 1, {1}},
    {"Laplace3D", "sy", 1, {1}},
    {"Laplace3D", "sz", 1, {1}},
    {"Phong", "input", NONE, {0}},
    {"Phong", "diffuse", 3, {.5, .5, .5}},
    {"Phong", "specular", 1, {0}},
    {"Phong", "shininess", NONE, {0}},
    {"Phong", "transparency", 1, {0}},
    {"Phong", "transparencyShininess", NONE, {0}},
    {"Phong", "interpolatedTransparency", 1, {1}},
    {"Phong", "diffuseTransparency", 1, {0}},
    {"Phong", "ambient", 1, {0}},
    {"Phong", "emissive", 1, {0}},
    {"Phong", "displacement", NONE, {0}},
    {"Phong", "displacementVector", NONE, {0}},
    {"Phong", "displacementScale", 1, {1}},
    {"Phong", "displacementBound", NONE, {0}},
    {"Expression", "input", NONE, {0}},
    {"Expression", "is", NONE, {0}},
    {"Expression", "with", NONE, {0}},
    {"Principled", "input", NONE, {0}}, {"Principled", "baseWeight", 1, {1}},
    {"Principled", "baseColor", 3, {.8, .8, .8}}, {"Principled", "diffuseRoughness", 1, {0}},
    {"Principled", "metalness", 1, {0}}, {"Principled", "specular", 1, {1}},
    {"Principled", "specularColor", 3, {1, 1, 1}}, {"Principled", "roughness", 1, {.3}},
    {"Principled", "ior", 1, {1.5}}, {"Principled", "anisotropy", 1, {0}}, {"Principled", "transmission", 1, {0}},
    {"Principled", "transmissionColor", 3, {1, 1, 1}}, {"Principled", "transmissionDepth", 1, {0}},
    {"Principled", "transmissionScatter", 3, {0, 0, 0}}, {"Principled", "transmissionScatterAnisotropy", 1, {0}},
    {"Principled", "dispersion", 1, {0}}, {"Principled", "abbe", 1, {20}}, {"Principled", "subsurface", 1, {0}},
    {"Principled", "subsurfaceColor", 3, {.8, .8, .8}}, {"Principled", "subsurfaceRadius", 1, {1}},
    {"Principled", "subsurfaceRadiusScale", 3, {1, .5, .25}}, {"Principled", "subsurfaceAnisotropy", 1, {0}},
    {"Principled", "fuzz", 1, {0}}, {"Principled", "fuzzColor", 3, {1, 1, 1}},
    {"Principled", "fuzzRoughness", 1, {.5}}, {"Principled", "coat", 1, {0}},
    {"Principled", "coatColor", 3, {1, 1, 1}}, {"Principled", "coatRoughness", 1, {0}},
    {"Principled", "coatAnisotropy", 1, {0}}, {"Principled", "coatIor", 1, {1.6}},
    {"Principled", "coatDarkening", 1, {1}}, {"Principled", "film", 1, {0}}, {"Principled", "filmThickness", 1, {.5}},
    {"Principled", "filmIor", 1, {1.4}}, {"Principled", "emission", 1, {0}},
    {"Principled", "emissionColor", 3, {1, 1, 1}}, {"Principled", "opacity", 1, {1}},
    {"Principled", "thinWalled", 1, {0}}, {"Principled", "tangent", NONE, {0}},
    {"Principled", "coatNormal", NONE, {0}}, {"Principled", "coatTangent", NONE, {0}},
    {"Principled", "displacement", NONE, {0}}, {"Principled", "displacementVector", NONE, {0}},
    {"Principled", "displacementScale", 1, {1}}, {"Principled", "displacementBound", NONE, {0}},
    {"RGBA", "r", 1, {.5}}, {"RGBA", "g", 1, {.5}}, {"RGBA", "b", 1, {.5}}, {"RGBA", "a", 1, {1}},
    {"RGBA", "displacement", NONE, {0}}, {"RGBA", "displacementVector", NONE, {0}},
    {"RGBA", "displacementScale", 1, {1}}, {"RGBA", "displacementBound", NONE, {0}}, {"MixMaterial", "mask", 1, {.5}},
    {"MixMaterial", "a", NONE, {0}}, {"MixMaterial", "b", NONE, {0}}, {"MixMaterial", "displacement", NONE, {0}},
    {"MixMaterial", "displacementVector", NONE, {0}}, {"MixMaterial", "displacementScale", 1, {1}},
    {"MixMaterial", "displacementBound", NONE, {0}}, {"SideSwitch", "frontShader", NONE, {0}},
    {"SideSwitch", "backShader", NONE, {0}}, {"SideSwitch", "displacement", NONE, {0}},
    {"SideSwitch", "displacementVector", NONE, {0}}, {"SideSwitch", "displacementScale", 1, {1}},
    {"SideSwitch", "displacementBound", NONE, {0}}, {"AlgorithmSwitch", "guiShader", NONE, {0}},
    {"AlgorithmSwitch", "raytracerShader", NONE, {0}}, {"AlgorithmSwitch", "radiationShader", NONE, {0}},
    {"AlgorithmSwitch", "displacement", NONE, {0}}, {"AlgorithmSwitch", "displacementVector", NONE, {0}},
    {"AlgorithmSwitch", "displacementScale", 1, {1}}, {"AlgorithmSwitch", "displacementBound", NONE, {0}},
    {"SunSkyLight", "sun", 3, {0, 1, .4}},
    {"SunSkyLight", "turbidity", 1, {6}},
    {"SunSkyLight", "radianceFactor", 1, {1}},
    {"SunSkyLight", "disableLight", 1, {0}},
    {"SunSkyLight", "disableSun", 1, {0}},
    {"SunSkyLight", "displacement", NONE, {0}},
    {"SunSkyLight", "displacementVector", NONE, {0}},
    {"SunSkyLight", "displacementScale", 1, {1}},
    {"SunSkyLight", "displacementBound", NONE, {0}},
};

/* Of the parameters that every volume map has: those below VOLUME_PARAMS, and three maps that are OWN. */
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
    snprintf(text, sizeof text, material ? "material: %s\n" : "material: Phong\ndiffuse: { map: %s }\n", kind);
    Lone lone = {matc_read("a.yaml", text, strlen(text), &options), NULL};
    assert_non_null(lone.document->graph);
    lone.node = lone.document->graph->materials[0].node;
    if (!material)
        lone.node = node_param(lone.node, P_Phong_diffuse)->node;
    return lone;
}

/* Of a number, of a map that is one, or of none. */
static void check_value(const char *kind, const Default *row, const Value *value)
{
    if (value->kind == VALUE_node)
        value = &value->node->params[0];
    const int lanes = value->kind == VALUE_number ? type_table[value->type].lanes : NONE;
    if (value->kind != VALUE_none && lanes != row->lanes)
        fail_msg("%s.%s has %d lanes, not %d", kind, row->param, lanes, row->lanes);
    if (value->kind == VALUE_none && row->lanes != NONE)
        fail_msg("%s.%s has no default", kind, row->param);
    for (int i = 0; i < row->lanes; i++)
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

/* Whether semantics.md has the kind: its parameters are all written down here, also where that is none but those of all volume maps. A
 * volume map that was added since means what its own row says. */
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

/* Of every parameter of every kind; one without a row here fails. */
static void test_every_default(void **state)
{
    (void)state;
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        if (kind == KIND_Constant || resolve_is_foreign((Kind)kind)) /* always given; test_translation.c */
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
        {NULL, "size", 1, {1}},           {NULL, "octaves", 1, {11}},  {NULL, "noiseRatio", 1, {.5}},
        {NULL, "frequencyRatio", 1, {2}}, {NULL, "frequency", 1, {1}}, {NULL, "phase", 1, {0}},
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

/* The constants of java.awt.Color, and the sixteen colours of EGA, by their bytes. */
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
        check_color(colors[i].name, colors[i].rgb >> 16, colors[i].rgb >> 8 & 255, colors[i].rgb & 255);
    check_color("#000", 0, 0, 0);
    check_color("#fff", 255, 255, 255);
    check_color("#08F", 0, 0x88, 0xFF);
    check_color("#01807f", 1, 128, 127);
    check_color("#0A0b0C80", 10, 11, 12);
}

/* What `--precision` says of each axis. */
static void test_precision(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        int noise, coordinates, powers, trigonometry;
    } rows[] = {
        {NULL, CHOICE_noise_lattice, CHOICE_coordinates_plain, CHOICE_powers_squaring, CHOICE_trigonometry_native},
        {"fast", CHOICE_noise_lattice, CHOICE_coordinates_plain, CHOICE_powers_squaring, CHOICE_trigonometry_native},
        {"balanced", CHOICE_noise_lattice, CHOICE_coordinates_long, CHOICE_powers_squaring,
         CHOICE_trigonometry_bounded},
        {"exact", CHOICE_noise_groimp, CHOICE_coordinates_long, CHOICE_powers_compensated, CHOICE_trigonometry_bounded},
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
