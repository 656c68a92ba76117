/* Pictures as the viewer writes them: libpng's reader gives back what was written, bytes are
 * sRGB. */
#include "tests/test.h"
#include "runtime/gl/png_write.h"
#include "runtime/viewer/slot.h"
#include <math.h>
#include <png.h>
#include <stdlib.h>

/* By libpng's own reader, from the top row down. */
static void check_png(const PngPicture *picture, const uint8_t *file, size_t size)
{
    enum { COMPONENTS = 4 };
    png_image image = {.version = PNG_IMAGE_VERSION};
    assert_true(png_image_begin_read_from_memory(&image, file, size));
    assert_int_equal(image.width, picture->width);
    assert_int_equal(image.height, picture->height);
    image.format = PNG_FORMAT_RGBA;
    uint8_t *pixels = malloc(PNG_IMAGE_SIZE(image));
    assert_true(png_image_finish_read(&image, NULL, pixels, 0, NULL));
    for (int i = 0; i < picture->width * picture->height; i++) {
        int row = picture->height - 1 - i / picture->width, column = i % picture->width;
        const uint8_t *wanted =
            picture->bytes + (row * picture->width + column) * picture->components;
        for (int k = 0; k < COMPONENTS; k++)
            assert_int_equal(pixels[COMPONENTS * i + k], k < picture->components ? wanted[k] : 255);
    }
    free(pixels);
}

static void png_comes_back(void **state)
{
    (void)state;
    enum { W = 7, H = 3 };
    for (int components = 3; components <= 4; components++) {
        uint8_t bytes[W * H * 4];
        PngPicture picture = {W, H, components, bytes};
        for (int i = 0; i < W * H * components; i++)
            bytes[i] = (uint8_t)(i * 37 + components);
        size_t size;
        const char *why;
        uint8_t *file = png_write(&picture, &size, &why);
        assert_non_null(file);
        check_png(&picture, file, size);
        free(file);
    }
}

static void no_picture_is_refused(void **state)
{
    (void)state;
    const PngPicture wrong[] = {
        {0, 1, 3, (uint8_t[3]){0}}, {1, PNG_SIZE_LIMIT + 1, 3, NULL}, {1, 1, 2, (uint8_t[2]){0}}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        size_t size;
        const char *why = NULL;
        assert_null(png_write(&wrong[i], &size, &why));
        assert_non_null(why);
    }
}

static void encoding_is_srgb(void **state)
{
    (void)state;
    assert_true(slot_encoded(0) == 0 && slot_encoded(-1) == 0 && slot_encoded(NAN) == 0);
    assert_true(slot_encoded(1) == 1 && slot_encoded(INFINITY) == 1);
    assert_true(fabs(slot_encoded(0.2158605) - 128 / 255.) < 1e-7 &&
                fabs(slot_encoded(.002) - .02584) < 1e-7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(png_comes_back),
        cmocka_unit_test(no_picture_is_refused),
        cmocka_unit_test(encoding_is_srgb),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
