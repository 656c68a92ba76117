/* Colors of documents: results of `colors:`, srgb() and linear() for bytes and names, against
 * published values of IEC 61966-2-1, and which file's `colors:` applies to included files. */
#include "tests/test.h"
#include "compiler/document.h"
#include "compiler/graph/graph.h"
#include "compiler/matc.h"
#include "runtime/gl/png_write.h"
#include "compiler/library/srgb.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The transfer function at bytes, as tables of it are printed, to six digits; 10 and 11 are the
 * ends of its two pieces. */
static const struct {
    int byte;
    double linear;
} published[] = {
    {0, 0},         {1, .000303527}, {10, .00303527}, {11, .00334654}, {12, .00367651},
    {64, .0512695}, {127, .212231},  {128, .215861},  {170, .401978},  {188, .502886},
    {200, .577580}, {254, .991102},  {255, 1},
};

static void the_function_is_the_standards(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof published / sizeof *published; i++)
        assert_true(fabs(srgb_decode(published[i].byte / 255.) - published[i].linear) <=
                    6e-6 * published[i].linear);
    /* the two pieces meet at 0.04045, as near as the standard's rounded constants let them: 1e-8 of
     * 0.0031308 */
    double line = srgb_decode(.04045), power = srgb_decode(nextafter(.04045, 1));
    assert_true(fabs(line - .0031308) < 5e-8 && power > line - 2e-8 && power - line < 2e-8);
    for (double encoded = 0; encoded < 1; encoded += 1. / 1024)
        assert_true(srgb_decode(encoded) < srgb_decode(encoded + 1. / 1024));
}

/* The files that the documents of a test include. */
static const char *const palettes[][2] = {
    {"plain.yaml", "defs: { grey: '#808080' }"},
    {"linear.yaml", "colors: linear\ndefs: { grey: '#808080' }"},
    {"srgb.yaml", "colors: srgb\ndefs: { grey: '#808080', other: 'linear(gray)' }"},
    {"both.yaml", "include: srgb.yaml\ndefs: { own: gray }"},
    {"picture.yaml", "defs: { tone: { map: ImageMap, image: gray.png } }"},
    {"srgbPicture.yaml", "colors: srgb\ndefs: { tone: { map: ImageMap, image: gray.png } }"},
};

/* A texel of 128, 128, 128. */
static char *gray_picture(size_t *size)
{
    const char *why;
    return (char *)png_write(&(PngPicture){1, 1, 3, (uint8_t[]){128, 128, 128}}, size, &why);
}

static char *read_palette(void *user, const char *path, size_t *size, const char **why)
{
    (void)user;
    if (!strcmp(path, "gray.png"))
        return gray_picture(size);
    for (size_t i = 0; i < sizeof palettes / sizeof *palettes; i++)
        if (!strcmp(path, palettes[i][0])) {
            *size = strlen(palettes[i][1]);
            return strdup(palettes[i][1]);
        }
    *why = "no such file";
    return NULL;
}

/* The components that a slot has, as --eval gives them. */
static void evaluate(const char *text, const char *slot, double *components, int count)
{
    MatcOptions options;
    matc_options_init(&options);
    options.read_file = read_palette;
    options.pixels = true;
    MatcDocument *document = matc_read("color.yaml", text, strlen(text), &options);
    if (!matc_material_count(document))
        fail_msg("%s\n%s", text, matc_diagnostics(document, MATC_TEXT));
    const char *fault;
    char *values = matc_eval(document, 0, "u=0.3", &options, &fault), line[64];
    assert_non_null(values);
    snprintf(line, sizeof line, "\n%s ", slot);
    char *at = strstr(values, line);
    assert_non_null(at);
    at += strlen(line);
    for (int i = 0; i < count; i++)
        components[i] = strtod(at, &at);
    free(values);
    matc_document_free(document);
}

enum { LINEAR_128 = 1, SRGB_128, SRGB_ORANGE };
static const double wanted[][3] = {
    [LINEAR_128] = {128 / 255., 128 / 255., 128 / 255.},
    [SRGB_128] = {.215861, .215861, .215861},
    [SRGB_ORANGE] = {1, .577580, 0},
};

static const struct {
    const char *text;
    int want;
} documents[] = {
    /* what the document says, and where it says nothing */
    {"material: Phong\nemissive: '#808080'", LINEAR_128},
    {"colors: linear\nmaterial: Phong\nemissive: '#808080'", LINEAR_128},
    {"colors:\nmaterial: Phong\nemissive: '#808080'", LINEAR_128},
    {"colors: srgb\nmaterial: Phong\nemissive: '#808080'", SRGB_128},
    {"material: Phong\nemissive: gray\ncolors: srgb", SRGB_128},
    {"colors: srgb\nmaterial: Phong\nemissive: orange", SRGB_ORANGE},
    {"colors: srgb\nmaterials: { one: { material: Phong, emissive: '#808080ff' } }", SRGB_128},
    /* numbers are numbers */
    {"colors: srgb\nmaterial: Phong\nemissive: [0.50196078431372548, 0.50196078431372548, "
     "0.50196078431372548]",
     LINEAR_128},
    {"colors: srgb\nmaterial: Phong\nemissive: 0.50196078431372548", LINEAR_128},
    /* one color */
    {"material: Phong\nemissive: 'srgb(#808080)'", SRGB_128},
    {"material: Phong\nemissive: srgb(gray)", SRGB_128},
    {"material: Phong\nemissive: srgb(orange)", SRGB_ORANGE},
    {"colors: linear\nmaterial: Phong\nemissive: srgb(#808080)", SRGB_128},
    {"colors: srgb\nmaterial: Phong\nemissive: srgb(#808080)", SRGB_128},
    {"colors: srgb\nmaterial: Phong\nemissive: 'linear(#808080)'", LINEAR_128},
    {"material: Phong\nemissive: linear(gray)", LINEAR_128},
    /* wherever a color may stand */
    {"colors: srgb\nmaterial: Phong\nemissive: { param: glow, default: '#808080' }", SRGB_128},
    {"colors: srgb\nmaterial: Phong\nemissive: { map: Checker, color1: gray, color2: '#808080' }",
     SRGB_128},
    {"colors: srgb\nmaterial: Phong\nemissive: { map: Blend, blend: [{ input: gray }] }", SRGB_128},
    {"colors: srgb\nmaterial: Phong\nemissive: { ref: g }\ndefs: { g: gray }", SRGB_128},
    {"colors: srgb\nmaterial: Phong\nspecular: &g gray\nemissive: *g", SRGB_128},
    /* every file for itself */
    {"include: plain.yaml\ncolors: srgb\nmaterial: Phong\nemissive: { ref: grey }", LINEAR_128},
    {"include: linear.yaml\ncolors: srgb\nmaterial: Phong\nemissive: { ref: grey }", LINEAR_128},
    {"include: srgb.yaml\nmaterial: Phong\nemissive: { ref: grey }", SRGB_128},
    {"include: srgb.yaml\nmaterial: Phong\nspecular: { ref: grey }\nemissive: gray", LINEAR_128},
    {"include: srgb.yaml\ncolors: linear\nmaterial: Phong\nemissive: { ref: grey }", SRGB_128},
    {"include: srgb.yaml\ncolors: srgb\nmaterial: Phong\nemissive: { ref: other }", LINEAR_128},
    {"include: both.yaml\nmaterial: Phong\nemissive: { ref: grey }", SRGB_128},
    {"include: both.yaml\nmaterial: Phong\nemissive: { ref: own }", LINEAR_128},
    {"include: [plain.yaml, srgb.yaml]\nmaterial: Phong\nemissive: { ref: grey }", LINEAR_128},
};

static void every_file_says_what_its_colours_are(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof documents / sizeof *documents; i++) {
        double got[3];
        evaluate(documents[i].text, "emissive", got, 3);
        for (int component = 0; component < 3; component++)
            if (fabs(got[component] - wanted[documents[i].want][component]) > 1e-6)
                fail_msg("%s\nlane %d: %.9g, want %.9g", documents[i].text, component,
                         got[component], wanted[documents[i].want][component]);
    }
}

/* The shares of #rrggbbaa and the numbers of other slots are no light. */
static void alpha_is_not_converted(void **state)
{
    (void)state;
    double alpha;
    evaluate("colors: srgb\nmaterial: Phong\ndiffuse: '#80808080'", "alpha", &alpha, 1);
    assert_true(fabs(alpha - 128 / 255.) < 1e-12);
    evaluate("material: Phong\ndiffuse: srgb(#80808080)", "alpha", &alpha, 1);
    assert_true(fabs(alpha - 128 / 255.) < 1e-12);
}

#define P "{ map: ImageMap, image: gray.png }"
#define MIX(a, t)                                                                                  \
    "{ map: Blend, blend: [{ value: 0, input: 0 }, { value: 1, input: " a " }], input: " t " }"
#define OVER(map) "{ map: " map ", input: " P " }"

/* Values that a picture of 128 gives: LINEAR, or SRGB once decoded, products of those, and the
 * exponents that they make. */
static const double LINEAR = 128 / 255., SRGB = .215861, SHARP = 7.01567, BLUNT = 2.09603;

static void a_picture_is_srgb_where_it_feeds_a_colour(void **state)
{
    (void)state;
    const struct {
        const char *text, *slot;
        double want;
    } rows[] = {
        {"material: Phong\nemissive: " P, "emissive", LINEAR},
        {"colors: srgb\nmaterial: Phong\nemissive: " P, "emissive", SRGB},
        {"colors: srgb\nmaterial: Phong\nspecular: " P, "specular", SRGB},
        {"colors: srgb\nmaterial: SideSwitch\nfrontShader: { material: Phong, emissive: " P " }",
         "emissive", SRGB},
        /* a number */
        {"material: Phong\nshininess: " P, "shininess", SHARP},
        {"colors: srgb\nmaterial: Phong\nshininess: " P, "shininess", SHARP},
        {"colors: srgb\nmaterial: Phong\nemissive: " MIX("1", P), "emissive", LINEAR},
        {"colors: srgb\nmaterial: Phong\nemissive: " OVER("Gradient"), "emissive", LINEAR},
        /* what passes a color on */
        {"colors: srgb\nmaterial: Phong\nemissive: " OVER("UVTransform"), "emissive", SRGB},
        {"colors: srgb\nmaterial: Phong\nemissive: " OVER("XYZTransform"), "emissive", SRGB},
        {"colors: srgb\nmaterial: Phong\nemissive: " OVER("Turbulence"), "emissive", SRGB},
        {"colors: srgb\nmaterial: Phong\nemissive: " OVER("BumpMap"), "emissive", SRGB},
        {"colors: srgb\nmaterial: Phong\nemissive: " OVER("WaveMap"), "emissive", SRGB},
        {"colors: srgb\nmaterial: Phong\nemissive: " OVER("Smooth3D"), "emissive", SRGB},
        {"colors: srgb\nmaterial: Phong\nemissive: " OVER("Laplace3D"), "emissive", 0},
        {"colors: srgb\nmaterial: Phong\nemissive: " OVER("Blend"), "emissive", SRGB},
        {"colors: srgb\nmaterial: Phong\nemissive: { map: Checker, color1: " P ", color2: " P " }",
         "emissive", SRGB},
        {"colors: srgb\nmaterial: Phong\nemissive: { map: VolumeChecker, color1: " P ", color2: " P
         " }",
         "emissive", SRGB},
        /* both: two maps are two, one is one */
        {"colors: srgb\nmaterial: Phong\nemissive: " MIX(P, P), "emissive", LINEAR * SRGB},
        {"colors: srgb\nmaterial: Phong\nspecular: &p " P "\nemissive: " MIX("*p", "*p"),
         "emissive", SRGB * SRGB},
        /* what the map says goes first */
        {"colors: srgb\nmaterial: Phong\nemissive: { map: ImageMap, image: gray.png, colorspace: "
         "linear }",
         "emissive", LINEAR},
        {"material: Phong\nemissive: { map: ImageMap, image: gray.png, colorspace: srgb }",
         "emissive", SRGB},
        {"material: Phong\nshininess: { map: ImageMap, image: gray.png, colorspace: srgb }",
         "shininess", BLUNT},
        /* every file for itself */
        {"include: picture.yaml\ncolors: srgb\nmaterial: Phong\nemissive: { ref: tone }",
         "emissive", LINEAR},
        {"include: srgbPicture.yaml\nmaterial: Phong\nemissive: { ref: tone }", "emissive", SRGB},
        {"include: srgbPicture.yaml\nmaterial: Phong\nshininess: { ref: tone }", "shininess",
         SHARP},
        /* one component; alpha is never decoded */
        {"colors: srgb\nmaterial: Phong\nemissive: { map: ImageMap, image: gray.png, channel: b }",
         "emissive", SRGB},
        {"colors: srgb\nmaterial: Phong\nemissive: { map: ImageMap, image: gray.png, channel: a }",
         "emissive", 1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double got;
        evaluate(rows[i].text, rows[i].slot, &got, 1);
        if (fabs(got - rows[i].want) > 2e-4 * fmax(rows[i].want, .01))
            fail_msg("%s\n%.9g, want %.9g", rows[i].text, got, rows[i].want);
    }
}

/* Whether the publisher of a surface model calls its parameter a color; Phong's are those of
 * GroIMP, which has no numbers but exponents. */
static bool is_a_colour(Kind material, const char *param)
{
    static const char *const others[] = {"emissiveFactor", "emissiveTexture", "transmissionScatter",
                                         "transmission_scatter"};
    static const char *const phongs[] = {
        "diffuse", "specular", "transparency", "diffuseTransparency", "ambient", "emissive"};
    /* how much the coat does */
    bool colour = strstr(param, "olor") != NULL && strcmp(param, "coat_affect_color");
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        colour |= !strcmp(param, others[i]);
    for (size_t i = 0; material == KIND_Phong && i < sizeof phongs / sizeof *phongs; i++)
        colour |= !strcmp(param, phongs[i]);
    return colour;
}

/* Pictures below a node that are decoded as sRGB, and those that are not. */
static void count_pictures(const Node *node, int counts[2])
{
    if (node && node->kind == KIND_ImageMap)
        counts[node_param(node, P_ImageMap_colorspace)->number[0] == KEYWORD_ColorSpace_srgb]++;
    for (int i = 0; node && i < kind_table[node->kind].count; i++) {
        const Value *value = &node->params[i];
        if (value->kind == VALUE_node)
            count_pictures(value->node, counts);
        for (int k = 0; value->kind == VALUE_items && k < value->items->count; k++)
            count_pictures(value->items->item[k].input, counts);
    }
}

/* glTF's and UsdPreview's occlusion (3), StandardSurface's transmission_extra_roughness and
 * coat_rotation: nothing reads them. */
enum { UNREAD = 5 };

static void pictures_of_param(const ParamRow *param, int counts[2])
{
    char text[512], factor[64];
    MatcOptions options;
    matc_options_init(&options);
    options.read_file = read_palette;
    snprintf(text, sizeof text, "colors: srgb\nmaterial: %s\n%s: " P "\n",
             kind_table[param->kind].name, param->name);
    for (int i = 0; i < kind_table[param->kind].count; i++) { /* 0 times a texture is no texture */
        const ParamRow *other = &param_table[kind_table[param->kind].first + i];
        snprintf(factor, sizeof factor, "%.*s", (int)(strlen(param->name) - strlen("Texture")),
                 param->name);
        if (other != param && strstr(param->name, "Texture") &&
            !strncmp(other->name, factor, strlen(factor)) && strstr(other->name, "Factor"))
            snprintf(text + strlen(text), sizeof text - strlen(text), "%s: 1\n", other->name);
    }
    MatcDocument *document = matc_read("color.yaml", text, strlen(text), &options);
    if (!document->graph)
        fail_msg("%s%s", text, matc_diagnostics(document, MATC_TEXT));
    count_pictures(document->graph->materials[0].node, counts);
    matc_document_free(document);
}

/* Every parameter of every surface model, also of those that become a Principled by formulas in
 * which colors and numbers meet. */
static void colours_alone_have_srgb_pictures(void **state)
{
    (void)state;
    int faults = 0, unread = 0;
    for (int i = 0; i < PARAM_COUNT; i++) {
        const ParamRow *param = &param_table[i];
        int counts[2] = {0};
        if (kind_table[param->kind].lowering != LOWERING_MATERIAL || param->type != PARAM_Map)
            continue;
        pictures_of_param(param, counts);
        const bool colour = is_a_colour(param->kind, param->name);
        unread += !counts[0] && !counts[1];
        if (counts[!colour]) {
            print_error("%s.%s: %d linear, %d sRGB\n", kind_table[param->kind].name, param->name,
                        counts[0], counts[1]);
            faults++;
        }
    }
    assert_int_equal(faults, 0);
    assert_int_equal(unread, UNREAD);
}

/* The texture of a program, by target: the sampler decodes if it can; otherwise texels are decoded
 * to 16 bits. */
static void targets_have_their_textures(void **state)
{
    (void)state;
    static const char text[] = "colors: srgb\nmaterial: Phong\nemissive: " P;
    static const struct {
        const char *target, *format;
    } rows[] = {{"glsl110", "RGBA16"},
                {"glsl330", "SRGB8_ALPHA8"},
                {"glsl450", "SRGB8_ALPHA8"},
                {"essl300", "SRGB8_ALPHA8"},
                {"spirv", "SRGB8_ALPHA8"}};
    MatcOptions options;
    matc_options_init(&options);
    options.read_file = read_palette;
    options.pixels = true;
    MatcDocument *document = matc_read("color.yaml", text, sizeof text - 1, &options);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        options.target = rows[i].target;
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        assert_true(matc_ok(program));
        assert_int_equal(matc_texture_count(program), 1);
        const MatcTexture *texture = matc_texture(program, 0);
        assert_string_equal(texture->format, rows[i].format);
        assert_true(texture->bytes
                        ? !strcmp(rows[i].format, "SRGB8_ALPHA8") && texture->bytes[0] == 128
                        : texture->words[0] == 14146 && texture->words[3] == 65535);
        matc_program_free(program);
    }
    matc_document_free(document);
}

/* Words where the target has textures of them, else halves; decoded if they are sRGB, as no texture
 * of 16 bits does it. */
static void pictures_of_16_bits_keep_them(void **state)
{
    (void)state;
    static const struct {
        const char *target, *format, *document;
    } rows[] = {
        {"glsl110", "RGBA16", "material: Phong\nemissive: { map: ImageMap, image: words.png }"},
        {"glsl330", "RGBA16", "material: Phong\nemissive: { map: ImageMap, image: words.png }"},
        {"essl300", "RGBA16F", "material: Phong\nemissive: { map: ImageMap, image: words.png }"},
        {"glsl330", "RGBA16",
         "colors: srgb\nmaterial: Phong\nemissive: { map: ImageMap, image: words.png }"},
        {"essl300", "RGBA16F",
         "colors: srgb\nmaterial: Phong\nemissive: { map: ImageMap, image: words.png }"},
    };
    /* red of the lower left texel, 0.15705; of sRGB 0.02126 */
    const int first = 10292, decoded = 1393;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        MatcOptions options;
        matc_options_init(&options);
        options.pixels = true;
        options.target = rows[i].target;
        MatcDocument *document = matc_read(SOURCE_FOLDER "/examples/a.yaml", rows[i].document,
                                           strlen(rows[i].document), &options);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        assert_true(matc_ok(program));
        const MatcTexture *texture = matc_texture(program, 0);
        const bool srgb = strstr(rows[i].document, "srgb");
        assert_string_equal(texture->format, rows[i].format);
        if (texture->words)
            assert_true(texture->words[0] == (srgb ? decoded : first));
        else
            assert_true(fabs(texture->floats[0] - (srgb ? 0.02126 : 0.15705)) < 1e-5);
        matc_program_free(program);
        matc_document_free(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_function_is_the_standards),
        cmocka_unit_test(every_file_says_what_its_colours_are),
        cmocka_unit_test(alpha_is_not_converted),
        cmocka_unit_test(a_picture_is_srgb_where_it_feeds_a_colour),
        cmocka_unit_test(colours_alone_have_srgb_pictures),
        cmocka_unit_test(targets_have_their_textures),
        cmocka_unit_test(pictures_of_16_bits_keep_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
