/* Counts values that a program computes once, in a branch, or not at all. */
#include "tests/test.h"
#include "tests/compile_text.h"

static int count(const char *text, const char *word)
{
    int n = 0;
    for (const char *at = text; (at = strstr(at, word)); at += strlen(word))
        n++;
    return n;
}

static void equal_subtrees_are_computed_once(void **state)
{
    (void)state;
    MatcOptions options = quick();
    char *text = compile_text(checker_text, MATC_FRAGMENT, &options);
    assert_int_equal(count(text, "granite(localPosition)"), 1);
    free(text);
}

static void a_filter_is_one_function(void **state)
{
    (void)state;
    MatcOptions options = quick();
    char *one = compile_text("material: Phong\ndiffuse: { map: Smooth3D, input: { map: Wood } }\n",
                             MATC_FRAGMENT, &options);
    assert_int_equal(count(one, "smooth3DInput0("), 1 + 27); /* the definition and the calls */
    assert_int_equal(count(one, "wood(p)"), 1);
    char *two = compile_text("material: Phong\ndiffuse: { map: Smooth3D, input: { map: Smooth3D, "
                             "input: { map: Wood } } }\n",
                             MATC_FRAGMENT, &options);
    assert_int_equal(count(two, "wood(p)"), 1);
    assert_int_equal(count(two, "smooth3DInput0("), 1 + 27);
    assert_int_equal(count(two, "smooth3DInput1"),
                     /* itself costly: it and its sum, a loop, each defined and called once */
                     2 + 2);
    free(one);
    free(two);
}

/* A subtree that cannot matter leaves no trace. */
static void dead_parts_are_pruned(void **state)
{
    (void)state;
    static const char *const documents[] = {
        "material: Phong\ndiffuse: { map: Blend, input: 5, blend: [{ input: { map: Granite } }, { "
        "value: 1 }] }\n",
        "material: Phong\ndiffuse: { map: Checker, color1: 0.5, color2: 0.5, input: { map: "
        "Turbulence } }\n",
        "material: Phong\nambient: { map: Granite }\n", /* thesis has no ambient */
        "material: SideSwitch\nfrontShader: { material: RGBA }\nbackShader: { material: RGBA }\n"};
    MatcOptions options = quick();
    options.layout = "thesis";
    for (size_t i = 0; i < sizeof documents / sizeof *documents; i++) {
        char *text = compile_text(documents[i], MATC_FRAGMENT, &options);
        assert_null(strstr(text, "granite"));
        assert_null(strstr(text, "urbulence"));
        assert_null(strstr(text, "uv"));
        free(text);
    }
}

static void costly_arms_are_branches(void **state)
{
    (void)state;
    MatcOptions options = quick();
    char *text = compile_text(
        "material: Phong\ndiffuse: { map: Checker, color1: { map: Granite }, color2: 0.5 }\n",
        MATC_FRAGMENT, &options);
    const char *branch = strstr(text, "if ("), *call = strstr(text, "= granite(localPosition)");
    assert_non_null(branch);
    assert_non_null(call);
    assert_true(branch < call);
    free(text);
    text = compile_text("material: Phong\ndiffuse: { map: Checker, color1: 0.1, color2: 0.5 }\n",
                        MATC_FRAGMENT, &options);
    assert_null(strstr(text, "if ("));
    free(text);
}

/* A costly slot of one side of a Mix is in a branch; what the mask alone decides of is not computed
 * for the other side. */
static void mixed_sides_are_branches(void **state)
{
    (void)state;
    MatcOptions options = quick();
#define MIX(mask)                                                                                  \
    "material: Mix\nmask: " mask                                                                   \
    "\na: { material: Phong, diffuse: { map: Granite } }\nb: { material: RGBA, r: 1 }\n"
    char *text = compile_text(MIX("{ map: Checker }"), MATC_FRAGMENT, &options);
    const char *branch = strstr(text, "if ("), *call = strstr(text, "= granite(localPosition)");
    assert_true(branch && call && branch < call);
    free(text);
    text = compile_text(MIX("1"), MATC_FRAGMENT, &options);
    assert_null(strstr(text, "granite"));
    free(text);
    text = compile_text(MIX("{ map: Clamp, input: { map: Granite }, low: 2, high: 3 }"),
                        MATC_FRAGMENT, &options);
    assert_null(strstr(text, "granite"));
    free(text);
}

/* 2^40 ways lead to the innermost material, and each slot of every material is made once. */
static void mixes_of_mixes_are_asked_once(void **state)
{
    (void)state;
    enum { LEVELS = 40, CAPACITY = 16384 };
    MatcOptions options = quick();
    char document[CAPACITY];
    size_t size = (size_t)snprintf(
        document, sizeof document,
        "defs:\n  k0: { material: RGBA }\n  j0: { material: Phong, shininess: 0.7 }\n");
    for (int i = 0; i < LEVELS; i++)
        size += (size_t)snprintf(
            document + size, sizeof document - size,
            "  k%d: { material: Mix, a: { ref: k%d }, b: { ref: j%d } }\n"
            "  j%d: { material: Mix, mask: { map: Wood }, a: { ref: k%d }, b: { ref: j%d } }\n",
            i + 1, i, i, i + 1, i, i);
    snprintf(document + size, sizeof document - size,
             "material: Mix\na: { ref: k%d }\nb: { ref: j%d }\n", LEVELS, LEVELS);
    char *text = compile_text(document, MATC_FRAGMENT, &options);
    assert_int_equal(count(text, "wood(localPosition)"), 1);
    free(text);
}

static void inputs_are_minimal(void **state)
{
    (void)state;
    MatcOptions options = quick();
    options.pass = "shadow";
    char *text =
        compile_text("material: Phong\ndiffuse: { map: Granite }\n", MATC_FRAGMENT, &options);
    assert_null(strstr(text, "in vec"));
    assert_null(strstr(text, "discard"));
    free(text);
    text =
        compile_text("material: Phong\ntransparency: { map: Checker }\n", MATC_FRAGMENT, &options);
    assert_non_null(strstr(text, "discard"));
    assert_int_equal(count(text, "\nin "), 1);
    free(text);
}

/* How much of what a coat has counts, by how much of a coat there is: a Mix has that once,
 * whichever of the coat's slots asks first, and it has the Mix's name. */
static void a_mix_names_its_weights(void **state)
{
    (void)state;
    MatcOptions options = quick();
    options.layout = "integer";
    char *text =
        compile_text("material: MixMaterial\nmask: { map: VolumeTurbulence }\n"
                     "a: { material: Principled, coat: 1, coatRoughness: .1, coatIor: 1.5 }\n"
                     "b: { material: Principled, coat: .2, coatRoughness: .3, coatIor: 1.7 }\n",
                     MATC_FRAGMENT, &options);
    assert_int_equal(count(text, "float MixMaterial = "), 1);
    assert_true(count(text, ", MixMaterial)") >= 2);
    assert_null(strstr(text, "coatRoughness_1"));
    assert_null(strstr(text, "coatReflectance_1"));
    free(text);
}

/* Half a pixel at -1 and half at 1 is half of each side, as at 0 and 1: the side of the half at 1
 * is not left out where the mean is 0. */
static void a_mask_is_taken_to_its_range_before_its_mean(void **state)
{
    (void)state;
    static const char document[] =
        "material: MixMaterial\nmask: { map: Checker, color1: %s, color2: %s }\n"
        "a: { material: Phong, diffuse: red, shininess: 0.2 }\n"
        "b: { material: Phong, diffuse: blue, shininess: { map: VolumeTurbulence, octaves: 5 } }\n";
    static const char *const masks[][2] = {{"-1", "1"}, {"-3", "2"}};
    MatcOptions options = quick();
    options.aa = "box";
    char *texts[2];
    for (int i = 0; i < 2; i++) {
        char whole[512];
        snprintf(whole, sizeof whole, document, masks[i][0], masks[i][1]);
        texts[i] = compile_text(whole, MATC_FRAGMENT, &options);
    }
    assert_string_equal(texts[0], texts[1]);
    assert_int_equal(count(texts[0], "MixMaterial = 1.0 - checker_2;"), 1);
    assert_int_equal(count(texts[0], "if (0.0 < MixMaterial)"), 1);
    free(texts[0]);
    free(texts[1]);
}

/* Cells that a slope needs give their value with it, though jitter is cut in one way for the one
 * and in another for the other. */
static void a_slope_of_cells_has_their_value(void **state)
{
    (void)state;
    static const char document[] = "material: Phong\ndiffuse: &c { map: Cells }\ninput: { map: "
                                   "BumpMap, displacement: *c, strength: 0.02 }\n";
    MatcOptions options = quick();
    char *text = compile_text(document, MATC_FRAGMENT, &options);
    assert_int_equal(count(text, "cells3(localPosition"), 0);
    assert_int_equal(count(text, "cells3Gradient(localPosition"), 1);
    free(text);
}

/* A value of one output only is computed in its assignment, with the comment of its map; a scalar
 * has no constructor. */
static void outputs_are_one_assignment(void **state)
{
    (void)state;
    MatcOptions options = quick();
    char *text = compile_text(checker_text, MATC_FRAGMENT, &options);
    assert_int_equal(count(text, "fragment0 = uvec4(octahedralBits("), 1);
    assert_int_equal(count(strstr(text, "void main"), "    uvec4 "), 0);
    free(text);
    text = compile_text(checker_text, MATC_UNPACK, &options);
    assert_int_equal(count(text, " = float(0.0);"), 0);
    assert_true(count(text, "surface.fuzz = 0.0;") > 0);
    free(text);
    options.pass = "value";
    text = compile_text("material: Phong\ndiffuse: { map: Granite, input: { map: XYZTransform, "
                        "transform: { scale: 3 } } }\n",
                        MATC_FRAGMENT, &options);
    assert_int_equal(count(text, "test.yaml:2 Granite"), 1);
    free(text);
}

/* Addressing that a sampler can do is left to it: a picture whose texels are centered is read at
 * the point. */
static void a_centred_picture_is_the_samplers(void **state)
{
    (void)state;
    MatcOptions options = quick();
    char *text = compile_text(
        "material: Phong\ndiffuse: { map: ImageMap, image: examples/tiles.png, texels: centre, "
        "input: { map: UVTransform, scaleU: 3 } }\n",
        MATC_FRAGMENT, &options);
    assert_int_equal(count(text, "imageCentred("), 2);
    assert_int_equal(count(text, "textureSize"), 0);
    free(text);
    text = compile_text("material: Phong\ndiffuse: { map: ImageMap, image: examples/tiles.png }\n",
                        MATC_FRAGMENT, &options);
    assert_int_equal(count(text, "imageCentred("), 0);
    assert_int_equal(count(text, "imageSampled("), 2);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_centred_picture_is_the_samplers),
        cmocka_unit_test(equal_subtrees_are_computed_once),
        cmocka_unit_test(a_filter_is_one_function),
        cmocka_unit_test(dead_parts_are_pruned),
        cmocka_unit_test(costly_arms_are_branches),
        cmocka_unit_test(mixed_sides_are_branches),
        cmocka_unit_test(mixes_of_mixes_are_asked_once),
        cmocka_unit_test(inputs_are_minimal),
        cmocka_unit_test(outputs_are_one_assignment),
        cmocka_unit_test(a_mix_names_its_weights),
        cmocka_unit_test(a_slope_of_cells_has_their_value),
        cmocka_unit_test(a_mask_is_taken_to_its_range_before_its_mean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
