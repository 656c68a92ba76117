/* OpenEXR files that are read: channels, windows, compressions and tiles; their numbers stay
 * unchanged. */
#include "tests/test.h"
#include "tests/exr_file.h"

/* Channels of every kind, and those that a picture has nothing to do with. */
static void channels_are_components(void **state)
{
    (void)state;
    static const struct {
        ExrHeader header;
        bool opaque, halves;
    } rows[] = {
        {{SMALL, "BGR", {HALF, HALF, HALF}, 0, 0, 0}, true, true},
        {{SMALL, "BGR", {FLOAT, FLOAT, FLOAT}, 0, 0, 0}, true, false},
        {{SMALL, "ABGR", {HALF, HALF, HALF, HALF}, 0, 0, 0}, false, true},
        {{SMALL, "ABGR", {FLOAT, HALF, HALF, HALF}, 0, 0, 0}, false, false},
        {{SMALL, "Y", {HALF}, 0, 0, 0}, true, true},
        {{SMALL, "AY", {HALF, FLOAT}, 0, 0, 0}, false, false},
        {{SMALL, "BGRYZ", {HALF, HALF, HALF, FLOAT, UINT}, 0, 0, 0}, true, true},
        {{SMALL, "R", {HALF}, 0, 0, 0}, true, true},
        {{WINDOW(4, 4), WINDOW(4, 4), "BGRZ", {HALF, HALF, HALF, FLOAT}, 0, 2, 0}, true, true},
        {{WINDOW(1, 1), WINDOW(1, 1), "BGR", {HALF, HALF, HALF}, 0, 0, 0}, true, true},
    };
    static PictureFile file;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        exr_put_file(&file, &rows[i].header);
        exr_check(&file, &rows[i].header, rows[i].opaque);
        /* a program needs the header alone */
        MatcDocument *document = picture_read(&file, picture_alone, false);
        assert_true(picture_of(document)->halves == rows[i].halves &&
                    !picture_of(document)->texels);
        matc_document_free(document);
    }
}

/* The picture is the display window: what the file has outside of it is left out, what it lacks is
 * transparent. */
static void windows_differ(void **state)
{
    (void)state;
    static const struct {
        ExrHeader header;
        bool opaque;
    } rows[] = {
        {{{2, 1, 5, 4}, {2, 1, 5, 4}, "BGR", {HALF, HALF, HALF}, 0, 0, 0}, true},
        {{{2, 1, 5, 4}, {0, 0, 3, 2}, "BGR", {HALF, HALF, HALF}, 0, 0, 0}, false},
        {{{-3, -2, 5, 4}, {0, 0, 2, 3}, "BGR", {HALF, HALF, HALF}, 0, 0, 0}, true},
        {{{1, 1, 2, 2}, {0, 0, 4, 4}, "ABGR", {HALF, HALF, HALF, HALF}, 0, 0, 0}, false},
        {{{7, 7, 8, 8}, {0, 0, 4, 4}, "Y", {HALF}, 0, 0, 0}, false},
    };
    static PictureFile file;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        exr_put_file(&file, &rows[i].header);
        exr_check(&file, &rows[i].header, rows[i].opaque);
    }
}

/* Blocks of one, 16 and 32 lines, the last one cut; whole tiles and cut ones. */
static void compressions_lose_nothing(void **state)
{
    (void)state;
    static const ExrHeader headers[] = {
        {WINDOW(37, 41), WINDOW(37, 41), "ABGR", {HALF, HALF, HALF, HALF}, 0, 0, 0},
        {WINDOW(37, 41), WINDOW(37, 41), "ABGR", {HALF, HALF, HALF, HALF}, 0, 0, 16},
        {{-3, 2, 33, 42}, {0, 0, 39, 39}, "BGRZ", {FLOAT, FLOAT, FLOAT, FLOAT}, 0, 0, 0},
        {{-3, 2, 33, 42}, {0, 0, 39, 39}, "Y", {FLOAT}, 0, 0, 40},
        {WINDOW(1, 1), WINDOW(1, 1), "BGR", {HALF, HALF, HALF}, 0, 0, 16},
    };
    static PictureFile file;
    for (size_t i = 0; i < sizeof headers / sizeof *headers; i++)
        for (int k = 0; k < EXR_COMPRESSIONS; k++) {
            ExrHeader h = headers[i];
            h.compression = exr_compressions[k];
            exr_write_file(&file, &h);
            exr_check(&file, &h, i == 4);
        }
}

static double emissive(PictureFile *file, const char *text)
{
    const char *fault;
    MatcOptions options;
    double red = NAN;
    matc_options_init(&options);
    MatcDocument *document = picture_read(file, text, true);
    if (!document->graph)
        fail_msg("%s", matc_diagnostics(document, MATC_TEXT));
    char *values = matc_eval(document, 0, "u=0 v=0", &options, &fault);
    assert_non_null(values);
    sscanf(strstr(values, "emissive "), "emissive %lf", &red);
    free(values);
    matc_document_free(document);
    return red;
}

/* They are linear whatever the document's colors are, and above 1 where they are above 1. */
static void values_are_linear(void **state)
{
    (void)state;
    static const ExrHeader h = {SMALL, "BGR", {HALF, HALF, HALF}, 0, 0, 0};
    static PictureFile file;
    exr_put_file(&file, &h);
    const double want = exr_number('R', 0, 1);
    assert_true(want > 1);
    assert_true(emissive(&file, "material: Phong\nemissive: { map: ImageMap, image: a }\n") ==
                want);
    assert_true(
        emissive(&file, "colors: srgb\nmaterial: Phong\nemissive: { map: ImageMap, image: a }\n") ==
        want);
    picture_refused(&file,
                    "material: Phong\nemissive: { map: ImageMap, image: a, colorspace: srgb }\n",
                    false, "a float image is always linear, never srgb");
}

/* Halves stay halves; floats are those where the target's samplers filter them. */
static void textures_hold_floats(void **state)
{
    (void)state;
    static const struct {
        const char *target, *half, *single;
    } rows[] = {{"glsl110", "RGBA16F", "RGBA32F"},
                {"glsl330", "RGBA16F", "RGBA32F"},
                {"essl300", "RGBA16F", "RGBA16F"}};
    static PictureFile file;
    for (size_t i = 0; i < 2 * sizeof rows / sizeof *rows; i++) {
        const int type = i % 2 ? FLOAT : HALF;
        const ExrHeader h = {SMALL, "BGR", {type, type, type}, 0, 0, 0};
        exr_put_file(&file, &h);
        MatcOptions options;
        matc_options_init(&options);
        options.target = rows[i / 2].target;
        MatcDocument *document = picture_read(&file, picture_alone, true);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        const MatcTexture *texture = matc_texture(program, 0);
        assert_string_equal(texture->format, i % 2 ? rows[i / 2].single : rows[i / 2].half);
        assert_true(texture->floats && texture->floats[0] == (float)exr_number('R', 0, 1));
        matc_program_free(program);
        matc_document_free(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(channels_are_components),   cmocka_unit_test(windows_differ),
        cmocka_unit_test(compressions_lose_nothing), cmocka_unit_test(values_are_linear),
        cmocka_unit_test(textures_hold_floats),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
