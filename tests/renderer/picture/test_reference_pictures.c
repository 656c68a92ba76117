/* Frames against pictures of the same documents by Cycles and POV-Ray:
 * tests/reference/README.md. Compares the light of each pixel, except along edges and in the
 * background, by the mask in the picture's alpha. Then frames with inserted faults, each of
 * which must fail. */
/* ctest: unsanitized seconds=19 */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/reference_picture.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FOLDER SOURCE_FOLDER "/tests/reference/"

enum { FLOATS, INTEGER, DEFAULT, LAYOUTS, MAX_TEXT_BYTES = 1 << 16 };
static const char *const layouts[LAYOUTS] = {"floats", "integer", "default"};

/* How close frames have to be: half of the pixels, and 99.9 %. */
typedef struct {
    double middle[LAYOUTS], most[LAYOUTS];
} Bounds;

#define STEP (1 / 255.)
/* Cycles computes in floats. POV-Ray's files have 16 bits, and a reference is made of sixteen of
 * them (light_picture of by_povray.py), a sum of what is within 1e-6. The layout `integer` has
 * diffuse colors within 7.6e-6. llvmpipe decodes sRGB by a polynomial, within 9e-4. What is round
 * is round for POV-Ray, and has 192 corners for us: highlights are off most. Panes let through what
 * ten bits of `integer` do not hold: half a step of these is 4.9e-4. Half shadows of 25 maps are
 * approximate: 9e-4. */
static const Bounds cycles = {{2e-6, 6e-6, STEP}, {1e-4, 1e-4, STEP}},
                    cycles_srgb = {{2e-6, 8e-6, STEP}, {1e-3, 1e-3, STEP}},
                    cycles_lamp = {{1e-6, 1e-6, STEP}, {1e-5, 2e-5, STEP}},
                    cycles_sky = {{2e-6, 2e-6, STEP}, {1e-5, 1e-5, STEP}},
                    cycles_soft = {{1e-6, 1e-6, STEP}, {2e-3, 2e-3, STEP}},
                    povray = {{2e-6, 8e-6, STEP}, {2e-5, 1e-4, STEP}},
                    povray_round = {{2e-6, 8e-6, STEP}, {5e-4, 5e-4, STEP}},
                    povray_panes = {{2e-6, 3e-6, STEP}, {1e-5, 5e-4, STEP}};

typedef struct {
    const char *scene;
    const Bounds *bounds;
    bool shadows;
} PictureCase;

static const PictureCase cases[] = {
    {"cycles/matt", &cycles, false},         {"cycles/painted", &cycles_srgb, false},
    {"cycles/lamp", &cycles_lamp, false},    {"cycles/sky", &cycles_sky, false},
    {"cycles/cornell", &cycles_lamp, false}, {"povray/glossy", &povray_round, false},
    {"povray/lights", &povray, false},       {"povray/flat", &povray, false},
    {"povray/panes", &povray_panes, false},  {"cycles/matt", &cycles, true},
    {"povray/glossy", &povray_round, true},  {"povray/lights", &povray, true},
    {"povray/flat", &povray, true},          {"cycles/cornell", &cycles_soft, true},
};
enum { CASES = sizeof cases / sizeof *cases };

static char *read_text(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        fail_msg("%s is not there", path);
    char *text = calloc(1, MAX_TEXT_BYTES);
    *size = fread(text, 1, MAX_TEXT_BYTES - 1, file);
    fclose(file);
    return text;
}

static const char *picture_name(const PictureCase *pair, char name[64])
{
    snprintf(name, 64, "%s%s", pair->scene, pair->shadows ? "_shadows" : "");
    return name;
}

static ReferencePicture read_picture(const PictureCase *pair)
{
    char name[64];
    ReferencePicture picture;
    if (!reference_picture_read(picture_name(pair, name), &picture))
        fail_msg("%s", matc_diagnostics(picture.document, MATC_TEXT));
    return picture;
}

/* -- frames */

static const char floats[] =
    "layout: floats\ntargets: [RGBA32UI, RGBA32UI, RGBA32UI, RGBA32UI, RGBA32UI, "
    "RGBA32UI]\nfields:\n"
    "- { slot: normal, encoding: full }\n- { slot: shininess, encoding: full }\n"
    "- { slot: diffuse, encoding: full }\n- { slot: specular, encoding: full }\n"
    "- { slot: ambient, encoding: full }\n- { slot: emissive, encoding: full }\n"
    "- { slot: diffuseTransparency, encoding: full }\n- { slot: transparency, encoding: full }\n";

/* The light of a scene's frame, from malloc; as large as the picture. */
static float *draw(GlContext *gl, const PictureCase *pair, const ReferencePicture *picture,
                   const MatcOptions *options)
{
    char path[512];
    size_t size;
    Scene *scene = NULL;
    snprintf(path, sizeof path, "%s%s.yaml", FOLDER, pair->scene);
    char *text = read_text(path, &size);
    MatcDocument *document = scene_read(path, text, size, options, &scene);
    if (!scene)
        fail_msg("%s", matc_diagnostics(document, MATC_TEXT));
    assert_int_equal(scene->width, picture->width);
    assert_int_equal(scene->height, picture->height);
    float *rgba = frame_floats(
        gl, scene,
        &(RendererOptions){.compile = options, .view = "light", .no_shadows = !pair->shadows});
    frame_forget(scene, document);
    free(text);
    return rgba;
}

/* -- the sky: Cycles has Preetham's table to four digits, where the paper and matc have five */

typedef struct {
    double perez[3][5][2]; /* of Y, x, y: A to E, each by turbidity and 1 */
    /* of x, y: by turbidity squared, turbidity, 1; by the cube of the sun's angle to 1 */
    double zenith[2][3][4];
} SkyTable;

static const SkyTable five = {{{{.17872, -1.46303},
                                {-.35540, .42749},
                                {-.02266, 5.32505},
                                {.12064, -2.57705},
                                {-.06696, .37027}},
                               {{-.01925, -.25922},
                                {-.06651, .00081},
                                {-.00041, .21247},
                                {-.06409, -.89887},
                                {-.00325, .04517}},
                               {{-.01669, -.26078},
                                {-.09495, .00921},
                                {-.00792, .21023},
                                {-.04405, -1.65369},
                                {-.01092, .05291}}},
                              {{{.00165, -.00374, .00208, 0},
                                {-.02902, .06377, -.03202, .00394},
                                {.11693, -.21196, .06052, .25885}},
                               {{.00275, -.00610, .00316, 0},
                                {-.04212, .08970, -.04153, .00515},
                                {.15346, -.26756, .06669, .26688}}}};
static const SkyTable four = {
    {{{.1787, -1.4630}, {-.3554, .4275}, {-.0227, 5.3251}, {.1206, -2.5771}, {-.0670, .3703}},
     {{-.0193, -.2592}, {-.0665, .0008}, {-.0004, .2125}, {-.0641, -.8989}, {-.0033, .0452}},
     {{-.0167, -.2608}, {-.0950, .0092}, {-.0079, .2102}, {-.0441, -1.6537}, {-.0109, .0529}}},
    {{{.00166, -.00375, .00209, 0},
      {-.02903, .06377, -.03202, .00394},
      {.11693, -.21196, .06052, .25886}},
     {{.00275, -.00610, .00317, 0},
      {-.04214, .08970, -.04153, .00516},
      {.15346, -.26756, .06670, .26688}}}};
#define TURBIDITY 3 /* of cycles/sky.yaml, as the sun and the camera below */

static double perez(const double rows[5][2], double up, double angle)
{
    double c[5];
    for (int i = 0; i < 5; i++)
        c[i] = rows[i][0] * TURBIDITY + rows[i][1];
    return (1 + c[0] * exp(c[1] / up)) *
           (1 + c[2] * exp(c[3] * angle) + c[4] * cos(angle) * cos(angle));
}

/* Linear sRGB along a direction of length 1, up to a factor. */
static void sky_of(const SkyTable *table, const double way[3], double rgb[3])
{
    static const double matrix[3][3] = {{3.2404542, -1.5371385, -.4985314},
                                        {-.9692660, 1.8760108, .0415560},
                                        {.0556434, -.2040259, 1.0572252}};
    const double length = sqrt(.5 * .5 + 1 + .9 * .9), sun = acos(.9 / length);
    const double angle = acos((.5 * way[0] + way[1] + .9 * way[2]) / length);
    double value[3];
    for (int i = 0; i < 3; i++) {
        value[i] = perez(table->perez[i], way[2], angle) / perez(table->perez[i], 1, sun);
        double zenith = 0;
        for (int k = 0; i && k < 12; k++)
            zenith += table->zenith[i - 1][k / 4][k % 4] * pow(TURBIDITY, 2 - k / 4) *
                      pow(sun, 3 - k % 4);
        value[i] *= i ? zenith : 1;
    }
    const double xyz[3] = {value[1] / value[2] * value[0], value[0],
                           (1 - value[1] - value[2]) / value[2] * value[0]};
    for (int component = 0; component < 3; component++)
        rgb[component] = matrix[component][0] * xyz[0] + matrix[component][1] * xyz[1] +
                         matrix[component][2] * xyz[2];
}

/* Direction of a pixel of cycles/sky.yaml; its camera looks towards (0.2, 1, 0.62) from the origin.
 * */
static void look(const ReferencePicture *picture, int pixel, double way[3])
{
    const double half = tan(29 * acos(-1) / 180), ahead = sqrt(.2 * .2 + 1 + .62 * .62),
                 flat = sqrt(.2 * .2 + 1);
    const double forward[3] = {.2 / ahead, 1 / ahead, .62 / ahead},
                 right[3] = {1 / flat, -.2 / flat, 0};
    const double up[3] = {right[1] * forward[2], -right[0] * forward[2],
                          right[0] * forward[1] - right[1] * forward[0]};
    const double x = (2 * (pixel % picture->width) + 1 - picture->width) * half / picture->height;
    const double y = (2 * (pixel / picture->width) + 1 - picture->height) * half / picture->height;
    double length = 0;
    for (int i = 0; i < 3; i++) {
        way[i] = forward[i] + x * right[i] + y * up[i];
        length += way[i] * way[i];
    }
    for (int i = 0; i < 3; i++)
        way[i] /= sqrt(length);
}

/* Ours times what the one table says over what the other does; then up to a factor: test_sky.c has
 * our scale. */
static void put_four_digits(const ReferencePicture *picture, float *rgba)
{
    double ours = 0, theirs = 0, way[3], by_four[3], by_five[3];
    for (int i = 0; i < 4 * picture->width * picture->height; i++) {
        look(picture, i / 4, way);
        sky_of(&four, way, by_four);
        sky_of(&five, way, by_five);
        rgba[i] *= i % 4 < 3 ? (float)(by_four[i % 4] / by_five[i % 4]) : 1.f;
        ours += i % 4 < 3 ? rgba[i] : 0;
        theirs += i % 4 < 3 ? picture->rgba[i] : 0;
    }
    for (int i = 0; i < 4 * picture->width * picture->height; i++)
        rgba[i] *= (float)(theirs / ours);
}

static float *draw_by(GlContext *gl, const PictureCase *pair, const ReferencePicture *picture,
                      int layout)
{
    MatcOptions options = frame_exact_options();
    options.layout = layout == INTEGER ? "integer" : NULL;
    MatcLayout *read = matc_layout_read("floats.yaml", floats, sizeof floats - 1, &options);
    assert_true(matc_layout_ok(read));
    if (layout == FLOATS)
        options.custom = read;
    float *rgba = draw(gl, pair, picture, &options);
    matc_layout_free(read);
    if (pair->bounds == &cycles_sky)
        put_four_digits(picture, rgba);
    return rgba;
}

/* -- both */

typedef struct {
    int count;           /* of pixels that are compared */
    double middle, most; /* half of them, and 99.9 %, are within */
} Differences;

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The greatest of three components. */
static double difference(const float *a, const float *b)
{
    double greatest = 0;
    for (int component = 0; component < 3; component++)
        greatest = isnan(a[component]) ? INFINITY
                                       : fmax(greatest, fabs((double)a[component] - b[component]));
    return greatest;
}

static Differences compare(const ReferencePicture *picture, const float *rgba)
{
    const int pixels = picture->width * picture->height;
    double *found = malloc((size_t)pixels * sizeof *found);
    Differences result = {0};
    for (int i = 0; i < pixels; i++)
        if (picture->rgba[4 * i + 3] > .5f)
            found[result.count++] = difference(rgba + 4 * i, picture->rgba + 4 * i);
    qsort(found, (size_t)result.count, sizeof *found, ascending);
    assert_true(result.count > pixels / 4); /* nothing compared would prove nothing */
    result.middle = found[result.count / 2];
    result.most = found[(int)(result.count * .999)];
    free(found);
    return result;
}

static bool is_close(const Differences *found, const Bounds *bounds, int layout)
{
    return found->middle <= bounds->middle[layout] && found->most <= bounds->most[layout];
}

static int compare_case(GlContext *gl, const PictureCase *pair)
{
    int faults = 0;
    char name[64];
    ReferencePicture picture = read_picture(pair);
    for (int layout = 0; layout < LAYOUTS; layout++) {
        float *rgba = draw_by(gl, pair, &picture, layout);
        const Differences found = compare(&picture, rgba);
        print_message("| %s | %s | %d | %.1e | %.1e |\n", picture_name(pair, name), layouts[layout],
                      found.count, found.middle, found.most);
        faults += !is_close(&found, pair->bounds, layout);
        free(rgba);
    }
    reference_picture_free(&picture);
    return faults;
}

static void against_other_renderers(void **state)
{
    (void)state;
    int faults = 0;
    GlContext *gl = frame_context();
    print_message("| picture | layout | pixels | median difference | 99.9 %% within |\n| --- | --- "
                  "| --- | --- | --- |\n");
    for (int i = 0; i < CASES; i++)
        faults += compare_case(gl, &cases[i]);
    gl_close(gl);
    assert_int_equal(faults, 0);
}

/* -- what must not pass */

enum { MIRRORED, UPSIDE_DOWN, MOVED, DOUBLED, ENCODED, SWAPPED, BRIGHTER, FAULTS };

/* The source pixel of a frame's pixel under a fault. */
static int source_of(const ReferencePicture *picture, int i, int fault)
{
    const int x = i % picture->width, y = i / picture->width;
    switch (fault) {
    case MIRRORED:
        return i - x + picture->width - 1 - x;
    case UPSIDE_DOWN:
        return (picture->height - 1 - y) * picture->width + x;
    case MOVED:
        return x ? i - 1 : i;
    default:
        return i;
    }
}

static float component_of(const float *rgba, int component, int fault)
{
    switch (fault) {
    case DOUBLED:
        return 2 * rgba[component];
    case ENCODED:
        return powf(fmaxf(rgba[component], 0), 1 / 2.2f);
    case SWAPPED:
        return rgba[2 - component];
    case BRIGHTER: /* by what a factor of pi that is rounded might be */
        return 1.02f * rgba[component];
    default:
        return rgba[component];
    }
}

static void faults_are_seen(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    for (int k = 0; k < CASES; k++) {
        ReferencePicture picture = read_picture(&cases[k]);
        const int pixels = picture.width * picture.height;
        float *rgba = draw_by(gl, &cases[k], &picture, FLOATS),
              *faulty = malloc((size_t)pixels * 4 * sizeof *faulty);
        for (int fault = 0; fault < FAULTS; fault++) {
            for (int i = 0; i < 4 * pixels; i++)
                faulty[i] = i % 4 == 3 ? 1
                                       : component_of(rgba + 4 * source_of(&picture, i / 4, fault),
                                                      i % 4, fault);
            const Differences found = compare(&picture, faulty);
            if (is_close(&found, cases[k].bounds, FLOATS))
                fail_msg("%s: fault %d is not seen: %g, %g", cases[k].scene, fault, found.middle,
                         found.most);
        }
        free(rgba);
        free(faulty);
        reference_picture_free(&picture);
    }
    gl_close(gl);
}

/* Nor does a frame without shadows. */
static void missing_shadows_are_seen(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    for (int k = 0; k < CASES; k++) {
        if (!cases[k].shadows)
            continue;
        ReferencePicture picture = read_picture(&cases[k]);
        const PictureCase bare = {cases[k].scene, cases[k].bounds, false};
        float *rgba = draw_by(gl, &bare, &picture, FLOATS);
        const Differences found = compare(&picture, rgba);
        assert_false(is_close(&found, bare.bounds, FLOATS));
        free(rgba);
        reference_picture_free(&picture);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(against_other_renderers),
                                       cmocka_unit_test(faults_are_seen),
                                       cmocka_unit_test(missing_shadows_are_seen)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
