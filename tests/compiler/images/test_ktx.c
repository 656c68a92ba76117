/* Texture files: KTX 1 as specified by Khronos, byte by byte, with rows of every length. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/base/output.h"
#include <stdlib.h>
#include <string.h>

enum { HEADER_WORDS = 13, IDENTIFIER = 12, TEXELS = 64 + 4, HEIGHT = 3, WIDEST = 9 };

static uint32_t word(const char *file, int index)
{
    uint32_t value;
    memcpy(&value, file + IDENTIFIER + 4 * index, sizeof value);
    return value;
}

/* By the tables of the specification: type, its size, format, internal format, base format. */
static void check_header(const char *file, bool floats, bool rgba, int width)
{
    static const unsigned char identifier[IDENTIFIER] = {0xAB, 0x4B, 0x54, 0x58, 0x20, 0x31,
                                                         0x31, 0xBB, 0x0D, 0x0A, 0x1A, 0x0A};
    const uint32_t format = rgba ? 0x1908 : 0x1903, internal = floats ? (rgba ? 0x8814 : 0x822E)
                                                               : rgba ? 0x8058
                                                                      : 0x8229;
    const uint32_t wanted[HEADER_WORDS] = {0x04030201,
                                           floats ? 0x1406 : 0x1401,
                                           floats ? 4 : 1,
                                           format,
                                           internal,
                                           format,
                                           (uint32_t)width,
                                           HEIGHT,
                                           0,
                                           0,
                                           1,
                                           1,
                                           0};
    assert_memory_equal(file, identifier, IDENTIFIER);
    for (int i = 0; i < HEADER_WORDS; i++)
        assert_int_equal(word(file, i), wanted[i]);
}

static void check_texture(bool floats, int components, int width)
{
    static unsigned char texels[WIDEST * HEIGHT * 4 * sizeof(float)];
    for (size_t i = 0; i < sizeof texels; i++)
        texels[i] = (unsigned char)(i * 37 + 5);
    const MatcTexture texture = {.width = width,
                                 .height = HEIGHT,
                                 .components = components,
                                 .bytes = floats ? NULL : texels,
                                 .floats = floats ? (const float *)(const void *)texels : NULL};
    size_t size, row = (size_t)width * (size_t)components * (floats ? sizeof(float) : 1),
                 padded = row;
    while (padded % 4)
        padded++;
    char *file = output_ktx(&texture, &size);
    check_header(file, floats, components == 4, width);
    assert_int_equal(word(file, HEADER_WORDS), padded * HEIGHT);
    assert_int_equal(size, TEXELS + padded * HEIGHT);
    for (size_t y = 0; y < HEIGHT; y++) {
        assert_memory_equal(file + TEXELS + y * padded, texels + y * row, row);
        for (size_t i = row; i < padded; i++)
            assert_int_equal(file[TEXELS + y * padded + i], 0);
    }
    free(file);
}

static void files_are_as_specified(void **state)
{
    (void)state;
    for (int width = 1; width <= WIDEST; width++)
        for (int components = 1; components <= 4; components += 3) {
            check_texture(false, components, width);
            check_texture(true, components, width);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_are_as_specified),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
