/* The C references of the library functions: check values of the semantics, closed forms, round
 * trips, behavior at the edges. */
/* ctest: alone */
#include "tests/test.h"
#include "compiler/ir/ir.h"
#include "compiler/library/carpenter.h"
#include "compiler/library/references.h"
#include "compiler/library/sky.h"
#include "tests/near.h"
#include <string.h>

REFERENCE(carpenterRelief);
REFERENCE(decodeSpheremap);
REFERENCE(encodeSpheremap);
REFERENCE(eyeFromWorld);
REFERENCE(imageBilinear);
REFERENCE(imageNearest);
REFERENCE(julia);
REFERENCE(leopard);
REFERENCE(mandel);
REFERENCE(packPair);
REFERENCE(phongExponent);
REFERENCE(safeNormalize);
REFERENCE(skyRadiance);
REFERENCE(unpackPair);
REFERENCE(waveCosh);
REFERENCE(waveExpm1);
REFERENCE(waveSinh);
REFERENCE(waveTanh);
REFERENCE(wood);

static void volumes(void **state)
{
    (void)state;
    double result;
    near(value_of(reference_wood, 3, -4, 7), 5, 1e-15);
    near(value_of(reference_wood, 3e200, 4e200, 0), 5e200, 1e186);
    near(value_of(reference_leopard, M_PI / 2, M_PI / 2, M_PI / 2), 1, 1e-15);
    near(value_of(reference_leopard, M_PI / 2, -M_PI / 2, 0), 0, 1e-15);
    /* c = 0 stays for ever; c = -2 is the set's tip; c = 2 - 2i leaves at once. */
    reference_mandel(&groimp, (const double[]){.5, .5, 0, 10}, &result);
    near(result, 1, 0);
    reference_mandel(&groimp, (const double[]){0, .5, 0, 10}, &result);
    near(result, 1, 0);
    reference_mandel(&groimp, (const double[]){-3, .5, 0, 10}, &result);
    near(result, 1, 0);
    reference_mandel(&groimp, (const double[]){-.001, 0, 0, 10}, &result);
    near(result, -1, 0);
    /* c = 1: 1, 2, 5: one step within the circle. */
    reference_mandel(&groimp, (const double[]){.75, .5, 0, 10}, &result);
    near(result, -.8, 1e-15);
    /* c = 0: a circle of radius 1. From 0.5 for ever; from 1.2: 1.44, 2.07: one step. */
    reference_julia(&groimp, (const double[]){.625, .5, 0, 10, 0, 0}, &result);
    near(result, 1, 0);
    reference_julia(&groimp, (const double[]){.8, .5, 0, 10, 0, 0}, &result);
    near(result, -.8, 1e-15);
}

static void waves(void **state)
{
    (void)state;
    for (int i = 0; i < SAMPLES; i++) {
        double v = 80 * sample(), e = exp(v);
        near(value_of(reference_waveCosh, v, 0, 0), (e + 1 / e) / 2, 1e-14 * (e + 1 / e));
        near(value_of(reference_waveSinh, v, 0, 0), (e - 1 / e) / 2, 1e-14 * (e + 1 / e));
        near(value_of(reference_waveTanh, v, 0, 0), (e - 1 / e) / (e + 1 / e), 1e-14);
        near(value_of(reference_waveExpm1, v, 0, 0), e - 1, 1e-14 * (e + 1));
    }
    near(value_of(reference_waveSinh, 1e-20, 0, 0), 1e-20, 1e-35);
    near(value_of(reference_waveTanh, 1e-20, 0, 0), 1e-20, 1e-35);
    near(value_of(reference_waveExpm1, -1e-20, 0, 0), -1e-20, 1e-35);
    for (double v = -1e30; v <= 1e30; v += 1e30) {
        inside(value_of(reference_waveCosh, v, 0, 0), 1, 3.4e38);
        inside(value_of(reference_waveSinh, v, 0, 0), -3.4e38, 3.4e38);
        inside(value_of(reference_waveTanh, v, 0, 0), -1, 1);
        inside(value_of(reference_waveExpm1, v, 0, 0), -1, 3.4e38);
    }
}

static void phong_exponents(void **state)
{
    (void)state;
    static const double rows[][2] = {{.1, 1.204}, {.25, 2.419}, {.5, 6.952}, {.75, 30.989}};
    double last = 0;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        near(value_of(reference_phongExponent, rows[i][0], 0, 0), rows[i][1], 5e-4);
    near(value_of(reference_phongExponent, .9, 0, 0), 199, .05);
    near(value_of(reference_phongExponent, .3727, 0, 0), 4, 1e-3);
    near(value_of(reference_phongExponent, 0, 0, 0), 0, 0);
    near(value_of(reference_phongExponent, -5, 0, 0), 0, 0);
    near(value_of(reference_phongExponent, 1, 0, 0), 65504, 0);
    for (int i = 0; i <= 1000; i++) {
        double exponent = value_of(reference_phongExponent, i / 1000., 0, 0);
        inside(exponent, last, 65504);
        last = exponent;
    }
}

/* The value of a half float next to a number of its normal range, ties to even. */
static double through_half(double v)
{
    int exponent;
    double mantissa = frexp(v, &exponent);
    return ldexp(nearbyint(ldexp(mantissa, 11)), exponent - 11);
}

static void pairs_survive_a_half(void **state)
{
    (void)state;
    double last = 0;
    for (int x = 0; x < 128; x++)
        for (int y = 0; y < 128; y++) {
            const double pair[2] = {(x + .5) / 127.5, (y + .5) / 127.5};
            double packed, unpacked[2];
            reference_packPair(NULL, pair, &packed);
            inside(packed, 1, 65504);
            if (packed <= last)
                fail_msg("codes are not ascending at %d %d", x, y);
            near(through_half(packed), packed, 0);
            reference_unpackPair(NULL, &packed, unpacked);
            near(unpacked[0], x / 127.5, 1e-15);
            near(unpacked[1], y / 127.5, 1e-15);
            last = packed;
        }
    near(value_of(reference_packPair, 1, 1, 0), 65504, 0);
    near(value_of(reference_packPair, 0, 0, 0), 1, 0);
    near(value_of(reference_packPair, 1e30, -1e30, 0), value_of(reference_packPair, 1, 0, 0), 0);
}

static void unit_vectors(void **state)
{
    (void)state;
    for (int i = -30; i <= 30; i += 10) {
        double scale = pow(10, i), result[3];
        const double v[3] = {2 * scale, -3 * scale, 6 * scale};
        reference_safeNormalize(NULL, v, result);
        near(result[0], 2 / 7., 1e-15);
        near(result[1], -3 / 7., 1e-15);
        near(result[2], 6 / 7., 1e-15);
    }
    double result[3];
    reference_safeNormalize(NULL, (const double[]){0, 0, 0}, result);
    near(result[2], 1, 0);
    reference_eyeFromWorld(NULL, (const double[]){1, 2, 3}, result);
    near(result[1], 2, 0);
}

static void spheremap_round_trip(void **state)
{
    (void)state;
    for (int i = 0; i < SAMPLES; i++) {
        /* Every second sample next to the singularity at -z. */
        double v[3] = {sample(), sample(), sample()}, n[3], e[2], back[3],
               small = i % 2 ? 1 : pow(10, -16 * fabs(sample()));
        v[0] *= small;
        v[1] *= small;
        if (i % 2 == 0)
            v[2] = -1;
        reference_safeNormalize(NULL, v, n);
        reference_encodeSpheremap(NULL, n, e);
        reference_decodeSpheremap(NULL, e, back);
        for (int component = 0; component < 2; component++)
            inside(e[component], 0, 1);
        near(back[0] * back[0] + back[1] * back[1] + back[2] * back[2], 1, 1e-14);
        for (int component = 0; component < 3; component++)
            near(back[component], n[component], 1e-7);
        if (n[2] > -.999)
            near(e[0], n[0] / sqrt(8 * n[2] + 8) + .5, 1e-12);
    }
    double e[2], back[3];
    reference_encodeSpheremap(NULL, (const double[]){0, 0, -1}, e);
    reference_decodeSpheremap(NULL, e, back);
    near(back[2], -1, 0);
    reference_decodeSpheremap(NULL, (const double[]){1, 1}, back);
    near(back[2], -1, 0);
}

static void pictures(void **state)
{
    (void)state;
    static const uint8_t bytes[2 * 2 * 4] = {0,  51, 102, 255, 255, 51, 102, 255,
                                             51, 51, 102, 255, 102, 51, 102, 255};
    static const float floats[4] = {0, 1, .25F, .5F};
    const ReferenceTexture textures[] = {
        {.width = 2, .height = 2, .components = 4, .bytes = bytes},
        {.width = 2, .height = 2, .components = 1, .floats = floats}};
    const ReferenceContext context = {.textures = textures};
    /* u, v, nearest, bilinear: red of texels (0,0) (1,0) (0,1) (1,1) is 0 1 .2 .4 */
    static const double rows[][4] = {
        {0, 0, 0, 0},      {.5, 0, 1, 1},     {.25, 0, 0, .5},    {.75, 0, 1, .5},
        {.25, .25, 0, .4}, {0, .5, .2, .2},   {-.25, 0, 1, .5},   {-1.75, 0, 0, .5},
        {7, -3, 0, 0},     {-1e-30, 0, 1, 0}, {.5, -.25, .4, .7}, {1e30, 0, 0, 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const double args[] = {0, rows[i][0], rows[i][1], 2, 2};
        double texel[4];
        reference_imageNearest(&context, args, texel);
        near(texel[0], rows[i][2], 1e-15);
        near(texel[1], .2, 1e-15);
        reference_imageBilinear(&context, args, texel);
        near(texel[0], rows[i][3], 1e-15);
        near(texel[3], 1, 1e-15);
    }
    /* A relief: as a picture from 0 on, extrapolated below: at u = -1/4 the weight is -1/2 from
     * texel 0 on, 0 - (1 - 0) / 2. */
    static const double relief[][3] = {{0, 0, 0},       {.25, 0, .5},    {.75, 0, .5},
                                       {-.25, 0, -.5},  {-.5, 0, 1},     {-.75, 0, 1.5},
                                       {-7.25, 9, -.5}, {0, -.25, -.125}};
    for (size_t i = 0; i < sizeof relief / sizeof *relief; i++) {
        const double args[] = {1, relief[i][0], relief[i][1], 2, 2};
        double value;
        reference_carpenterRelief(&context, args, &value);
        near(value, relief[i][2], 1e-15);
    }
}

static void reliefs(void **state)
{
    (void)state;
    static float texels[2048 * 2048], other[256 * 256];
    static const int sizes[][2] = {{1, 1},     {1, 2048},  {2048, 1},    {3, 7},      {255, 257},
                                   {256, 256}, {640, 480}, {2047, 1000}, {2048, 2048}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (int roughness = -16; roughness <= 16; roughness += 8) {
            int width = sizes[i][0], height = sizes[i][1];
            if (width * height > 1000000 && roughness)
                continue;
            carpenter_bake(&(CarpenterRelief){.5, 1e6, roughness, 3, width, height}, texels);
            for (int at = 0; at < width * height; at++)
                inside((double)texels[at], -1.1e30, 1.1e30);
        }
    carpenter_bake(&(CarpenterRelief){.5, 1, 1, 0, 256, 256}, texels);
    near((double)texels[0], .5, 0);
    /* the torus closes: neighbors are near each other across the seam */
    for (int y = 0; y < 256; y++)
        near((double)texels[256 * y], (double)texels[256 * y + 255], .2);
    carpenter_bake(&(CarpenterRelief){.5, 1, 1, 0, 256, 256}, other);
    assert_memory_equal(texels, other, sizeof other);
    carpenter_bake(&(CarpenterRelief){.5, 1, 1, 1, 256, 256}, other);
    assert_memory_not_equal(texels, other, sizeof other);
    carpenter_bake(&(CarpenterRelief){.25, 0, 1, 0, 3, 5}, other); /* no noise: flat */
    for (int at = 0; at < 15; at++)
        near((double)other[at], .25, 0);
    /* The first draws of java.util.Random(0) as floats are .7309678 and .8314411: center, then the
     * middle of the lower edge. */
    carpenter_bake(&(CarpenterRelief){.5, 1, 1, 0, 2, 2}, other);
    near((double)other[3], .5 + .4619356, 1e-6);
    near((double)other[1], (.5 + .9619356) / 2 + .6628822, 1e-6);
}

static void sky_value(const double rows[7][3], const double direction[3], double rgb[3])
{
    double args[24];
    memcpy(args, direction, 3 * sizeof *args);
    memcpy(args + 3, rows[6], 3 * sizeof *args);
    memcpy(args + 6, rows, 18 * sizeof *args);
    reference_skyRadiance(NULL, args, rgb);
}

static void sky_is_finite(void **state)
{
    (void)state;
    double rows[7][3], rgb[3];
    for (double turbidity = 0; turbidity <= 64;
         turbidity = turbidity < 12 ? turbidity + .5 : turbidity + 13)
        for (int degrees = 0; degrees <= 180; degrees += 5) {
            const double sun[3] = {sin(degrees * M_PI / 180), 0, cos(degrees * M_PI / 180)};
            sky_coefficients(sun, turbidity, 1, rows);
            for (int i = 0; i < 60; i++) {
                const double direction[3] = {sample(), sample(),
                                             i % 3 ? fabs(sample()) : 1e-3 * sample()};
                sky_value((const double(*)[3])rows, direction, rgb);
                for (int component = 0; component < 3; component++)
                    inside(rgb[component], 0, direction[2] < 0 ? 0 : 1e5);
            }
        }
    sky_coefficients((const double[]){0, 0, 0}, 6, 1, rows);
    near(rows[6][2], 1, 0);
}

/* The zenith of a material's sky is Y_z of the model times the scale; the sky is bluer than it is
 * red, and brighter at the sun. */
static void sky_is_a_sky(void **state)
{
    (void)state;
    double rows[7][3], twice[7][3], up[3], toward[3], away[3];
    sky_coefficients((const double[]){0, 1, 1}, 3, 1, rows);
    sky_coefficients((const double[]){0, 1, 1}, 3, 2, twice);
    near(twice[0][0], 2 * rows[0][0], 1e-12);
    sky_value((const double(*)[3])rows, (const double[]){0, 0, 5}, up);
    sky_value((const double(*)[3])rows, (const double[]){0, 1, 1}, toward);
    sky_value((const double(*)[3])rows, (const double[]){0, -1, 1}, away);
    assert_true(up[2] > up[0]);
    assert_true(toward[1] > up[1]);
    assert_true(toward[1] > away[1]);
}

/* Text of the IR may give a function any number as a count of bits, octaves or steps: what comes
 * out is a number, at once, and a word has 32 bits. */
static void any_number_may_be_a_count(void **state)
{
    (void)state;
    static const double counts[] = {670, -5, 0, 31, 64, 2e9, -2e9, 1e300, -1e300};
    static const uint8_t texel[4] = {51, 102, 153, 255};
    const ReferenceTexture texture = {.width = 1, .height = 1, .components = 4, .bytes = texel};
    const ReferenceContext context = {REFERENCE_LATTICE, &texture};
    for (int function = 0; function < FUNCTION_COUNT; function++) {
        const char *letters = function_row(function)->name ? function_arguments(function) : "";
        for (size_t i = 0; strchr(letters, 'i') && i < sizeof counts / sizeof *counts; i++) {
            double args[64], result[4] = {0};
            int used = 0;
            for (const char *letter = letters; *letter; letter++)
                for (int component = 0;
                     component < (*letter >= '2' && *letter <= '4' ? *letter - '0' : 1);
                     component++)
                    args[used++] = *letter == 'i' ? counts[i] : *letter == 's' ? 0 : 1;
            reference_of(function)(&context, args, result);
            bool word = function_row(function)->result == TYPE_uint;
            for (int component = 0; component < 4; component++)
                if (!isfinite(result[component]) ||
                    (word && !(result[component] >= 0 && result[component] < 4294967296.)))
                    fail_msg("%s of a count of %g: %g", function_row(function)->name, counts[i],
                             result[component]);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(volumes),
        cmocka_unit_test(waves),
        cmocka_unit_test(phong_exponents),
        cmocka_unit_test(pairs_survive_a_half),
        cmocka_unit_test(unit_vectors),
        cmocka_unit_test(spheremap_round_trip),
        cmocka_unit_test(pictures),
        cmocka_unit_test(reliefs),
        cmocka_unit_test(sky_is_finite),
        cmocka_unit_test(sky_is_a_sky),
        cmocka_unit_test(any_number_may_be_a_count),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
