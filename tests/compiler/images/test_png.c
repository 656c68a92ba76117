/* PNG files written byte by byte here, by the specification and without the product's code, so
 * that their texels are known: the texels that the reader returns, and the values that the
 * reference samples from them. */
/* ctest: quick */
#include "tests/test.h"
#include "tests/picture.h"
#include <math.h>

enum { GRAY = 0, RGB = 2, PALETTE = 3, GRAY_ALPHA = 4, RGBA = 6 };

typedef struct {
    int width, height, depth, kind;
    bool interlaced;
} Header;

static void put_number(PictureFile *file, uint32_t number)
{
    const uint8_t bytes[] = {(uint8_t)(number >> 24), (uint8_t)(number >> 16),
                             (uint8_t)(number >> 8), (uint8_t)number};
    picture_put(file, bytes, 4);
}

/* CRC-32 of the chunk's name and data, bit by bit. */
static uint32_t crc(const uint8_t *bytes, size_t size)
{
    uint32_t c = 0xFFFFFFFF;
    for (size_t i = 0; i < size; i++) {
        c ^= bytes[i];
        for (int bit = 0; bit < 8; bit++)
            c = c & 1 ? c >> 1 ^ 0xEDB88320 : c >> 1;
    }
    return ~c;
}

static void put_chunk(PictureFile *file, const char *name, const void *data, size_t size)
{
    put_number(file, (uint32_t)size);
    const size_t from = file->size;
    picture_put(file, name, 4);
    picture_put(file, data, size);
    put_number(file, crc(file->bytes + from, size + 4));
}

static void put_header(PictureFile *file, const Header *header)
{
    PictureFile data = {.size = 0};
    picture_put(file, "\x89PNG\r\n\x1a\n", 8);
    put_number(&data, (uint32_t)header->width);
    put_number(&data, (uint32_t)header->height);
    const uint8_t rest[] = {(uint8_t)header->depth, (uint8_t)header->kind, 0, 0,
                            header->interlaced};
    picture_put(&data, rest, 5);
    put_chunk(file, "IHDR", data.bytes, data.size);
}

/* The rows, each with the number of its filter in front, as deflate's stored block. */
static void put_rows(PictureFile *file, const void *rows, size_t size)
{
    PictureFile data = {.size = 0};
    const uint8_t *bytes = rows;
    const uint8_t head[] = {
        0x78, 0x01, 1, (uint8_t)size, (uint8_t)(size >> 8), (uint8_t)~size, (uint8_t)(~size >> 8)};
    uint32_t low = 1, high = 0;
    for (size_t i = 0; i < size; i++) {
        low = (low + bytes[i]) % 65521;
        high = (high + low) % 65521;
    }
    picture_put(&data, head, sizeof head);
    picture_put(&data, rows, size);
    put_number(&data, high << 16 | low);
    put_chunk(file, "IDAT", data.bytes, data.size);
    put_chunk(file, "IEND", NULL, 0);
}

static void check_texels(PictureFile *file, int width, int height, const char *texels, bool opaque)
{
    picture_check(file, &(PictureWanted){width, height, 8, opaque, texels});
}

static void check_words(PictureFile *file, int width, int height, const uint16_t *texels,
                        bool opaque)
{
    picture_check(file, &(PictureWanted){width, height, 16, opaque, texels});
}

#define ROWS(text)  text, sizeof(text) - 1
#define CHUNK(text) text, sizeof(text) - 1

/* All 16 bits are kept, the upper byte first in the file. */
static void test_16_bits(void **state)
{
    (void)state;
    PictureFile file = {.size = 0};
    put_header(&file, &(Header){2, 2, 16, RGB, false});
    put_rows(&file, ROWS("\0"
                         "\x00\xFF\x00\x80\x00\x81"
                         "\xFF\xFF\xFF\x00\xFE\xFF"
                         "\0"
                         "\x12\x34\x7F\xFF\x80\x80"
                         "\x80\x7F\x01\x00\xAB\xCD"));
    static const uint16_t colors[] = {0x1234, 0x7FFF, 0x8080, 0xFFFF, 0x807F, 0x0100,
                                      0xABCD, 0xFFFF, 0x00FF, 0x0080, 0x0081, 0xFFFF,
                                      0xFFFF, 0xFF00, 0xFEFF, 0xFFFF};
    check_words(&file, 2, 2, colors, true);

    file.size = 0;
    put_header(&file, &(Header){2, 1, 16, GRAY_ALPHA, false});
    put_rows(&file, ROWS("\0\x40\xC0\x01\x7F\xC0\x40\xFE\x80"));
    static const uint16_t greys[] = {0x40C0, 0x40C0, 0x40C0, 0x017F,
                                     0xC040, 0xC040, 0xC040, 0xFE80};
    check_words(&file, 2, 1, greys, false);
}

/* A picture of one row: gray of few bits is spread over all of 0 to 255. */
static void check_gray(int depth, int width, const char *row, size_t size, const char *texels)
{
    PictureFile file = {.size = 0};
    put_header(&file, &(Header){width, 1, depth, GRAY, false});
    put_rows(&file, row, size);
    check_texels(&file, width, 1, texels, true);
}

#define G(byte) byte byte byte "\xFF"

static void test_gray(void **state)
{
    (void)state;
    check_gray(1, 3, ROWS("\0\xA0"), G("\xFF") G("\x00") G("\xFF"));
    check_gray(2, 4, ROWS("\0\x1B"), G("\x00") G("\x55") G("\xAA") G("\xFF"));
    check_gray(4, 2, ROWS("\0\x7E"), G("\x77") G("\xEE"));
    check_gray(8, 2, ROWS("\0\x7E\x01"), G("\x7E") G("\x01"));
}

/* A palette with alpha for its first two colors, two bits a texel. */
static void test_palette(void **state)
{
    (void)state;
    PictureFile file = {.size = 0};
    put_header(&file, &(Header){4, 1, 2, PALETTE, false});
    put_chunk(&file, "PLTE", CHUNK("\x01\x02\x03\x11\x12\x13\x21\x22\x23\x31\x32\x33"));
    put_chunk(&file, "tRNS", CHUNK("\x00\x80"));
    put_rows(&file, ROWS("\0\xE4")); /* 3 2 1 0 */
    check_texels(&file, 4, 1, "\x31\x32\x33\xFF\x21\x22\x23\xFF\x11\x12\x13\x80\x01\x02\x03\x00",
                 false);
}

/* One color is transparent, and only if all of its 16 bits are the same. */
static void test_transparent_colour(void **state)
{
    (void)state;
    PictureFile file = {.size = 0};
    put_header(&file, &(Header){2, 1, 8, RGB, false});
    put_chunk(&file, "tRNS", CHUNK("\x00\x0A\x00\x0B\x00\x0C"));
    put_rows(&file, ROWS("\0\x0A\x0B\x0C\x0A\x0B\x0D"));
    check_texels(&file, 2, 1, "\x0A\x0B\x0C\x00\x0A\x0B\x0D\xFF", false);

    file.size = 0;
    put_header(&file, &(Header){2, 1, 16, GRAY, false});
    put_chunk(&file, "tRNS", CHUNK("\x12\x34"));
    put_rows(&file, ROWS("\0\x12\x34\x12\x35"));
    check_words(&file, 2, 1,
                (const uint16_t[]){0x1234, 0x1234, 0x1234, 0, 0x1235, 0x1235, 0x1235, 0xFFFF},
                false);
}

/* Chunks on how a picture is to be shown change no number; nor does a text, or a profile that
 * inflates to much. */
static void test_said_about_colours(void **state)
{
    (void)state;
    static const struct {
        const char *name, *data;
        size_t size;
    } reported[] = {
        {"gAMA", CHUNK("\x00\x01\x86\xA0")}, /* 1: linear */
        {"gAMA", CHUNK("\x00\x00\x27\x10")}, /* 0.1 */
        {"gAMA", CHUNK("\x00\x00\xB1\x8F")}, /* 0.45455 */
        {"gAMA", CHUNK("\x00\x00\x00\x00")},
        {"sRGB", CHUNK("\x00")},
        {"cHRM", CHUNK("\x00\x00\x7A\x26\x00\x00\x80\x84\x00\x00\xFA\x00\x00\x00\x80\xE8\x00\x00"
                       "\x75\x30\x00\x00\xEA\x60"
                       "\x00\x00\x3A\x98\x00\x00\x17\x70")},
        {"sBIT", CHUNK("\x05\x06\x05")},
        {"bKGD", CHUNK("\x00\xFF\x00\x00\x00\x00")},
        {"iCCP", CHUNK("none\0\0not deflated at all")},
        {"tEXt", CHUNK("Comment\0a picture")},
        {"zTXt", CHUNK("Comment\0\0broken")},
    };
    for (int depth = 8; depth <= 16; depth += 8)
        for (size_t i = 0; i < sizeof reported / sizeof *reported; i++) {
            PictureFile file = {.size = 0};
            put_header(&file, &(Header){1, 1, depth, RGB, false});
            put_chunk(&file, reported[i].name, reported[i].data, reported[i].size);
            if (depth == 8)
                put_rows(&file, ROWS("\0\x10\x80\xC0"));
            else
                put_rows(&file, ROWS("\0\x10\x10\x80\x80\xC0\xC0"));
            if (depth == 8)
                check_texels(&file, 1, 1, "\x10\x80\xC0\xFF", true);
            else
                check_words(&file, 1, 1, (const uint16_t[]){0x1010, 0x8080, 0xC0C0, 0xFFFF}, true);
        }
}

/* Adam7: of 3 x 3 texels, the passes have (0, 0); none; none; (2, 0); (0, 2), (2, 2); (1, 0), (1,
 * 2); and row 1. */
static void test_interlaced(void **state)
{
    (void)state;
    PictureFile file = {.size = 0};
    put_header(&file, &(Header){3, 3, 8, GRAY, true});
    put_rows(&file, ROWS("\0\x01"
                         "\0\x03"
                         "\0\x07\x09"
                         "\0\x02"
                         "\0\x08"
                         "\0\x04\x05\x06"));
    check_texels(&file, 3, 3,
                 G("\x07") G("\x08") G("\x09") G("\x04") G("\x05") G("\x06") G("\x01") G("\x02")
                     G("\x03"),
                 true);
}

/* Each of the five filters undone by hand: none, left, up, mean of both, Paeth. */
static void test_row_filters(void **state)
{
    (void)state;
    PictureFile file = {.size = 0};
    put_header(&file, &(Header){3, 5, 8, GRAY, false});
    put_rows(
        &file,
        ROWS("\0\x0A\x14\x1E" /* 10 20 30 */
             "\1\x05\x05\xFF" /* 5, 5 + 5, 10 - 1 */
             "\2\x01\x02\x03" /* 6 12 12 */
             "\3\x01\x01\x01" /* 1 + 3, 1 + (4 + 12) / 2, 1 + (9 + 12) / 2 */
             /* above 4 9 11: 5, then of 5, 9 with corner 4 is 9 nearest: 10, of 10, 11, 9: 11 */
             "\4\x01\x01\x01"));
    check_texels(&file, 3, 5,
                 G("\x05") G("\x0A") G("\x0C") G("\x04") G("\x09") G("\x0B") G("\x06") G("\x0C")
                     G("\x0C") G("\x05") G("\x0A") G("\x09") G("\x0A") G("\x14") G("\x1E"),
                 true);
}

static double red_at(const MatcDocument *document, double u, double v)
{
    char point[64];
    const char *fault;
    MatcOptions options;
    double red = NAN;
    matc_options_init(&options);
    snprintf(point, sizeof point, "u=%.17g v=%.17g", u, v);
    char *values = matc_eval(document, 0, point, &options, &fault);
    assert_non_null(values);
    sscanf(strstr(values, "diffuse "), "diffuse %lf", &red);
    free(values);
    return red;
}

/* Two columns and three rows, whose bytes are 10 20 / 30 40 / 50 60 from the top down. v = 0 is at
 * the bottom, u = 0 on the left; both repeat. Without centring, a texel's number is at the texel's
 * lower left corner. */
static void test_rows_from_below(void **state)
{
    (void)state;
    PictureFile file = {.size = 0};
    put_header(&file, &(Header){2, 3, 8, GRAY, false});
    put_rows(&file, ROWS("\0\x0A\x14\0\x1E\x28\0\x32\x3C"));
    MatcDocument *nearest = picture_read(&file, picture_alone, true);
    assert_non_null(nearest->graph);
    static const struct {
        double u, v, byte;
    } expected[] = {
        {0, 0, 50},        {0.49, 0.33, 50}, {0.5, 0, 60},     {0, 0.34, 30},
        {0.75, 0.5, 40},   {0, 0.67, 10},    {0.99, 0.99, 20}, {0, 1, 50},
        {-0.25, -0.1, 20}, {1.1, 1.5, 30},   {-3.9, -2.9, 50}, {0.6, -0.9, 60},
    };
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++)
        assert_true(fabs(red_at(nearest, expected[i].u, expected[i].v) - expected[i].byte / 255) <
                    1e-15);
    matc_document_free(nearest);

    MatcDocument *mixed =
        picture_read(&file, "material: Phong\ndiffuse: { map: ImageMap, image: a }\n", true);
    static const struct {
        double u, v, byte;
    } between[] = {
        {0, 0, 50},    {0.25, 0, 55},   {0, 1 / 6., 40},  {0.25, 1 / 6., 45},
        {0.75, 0, 55}, {0, 5 / 6., 30}, {0.125, 0, 52.5},
    };
    for (size_t i = 0; i < sizeof between / sizeof *between; i++)
        assert_true(fabs(red_at(mixed, between[i].u, between[i].v) - between[i].byte / 255) <
                    1e-14);
    matc_document_free(mixed);
}

/* Every way in which a header can be wrong, and every length of a file that is cut off. */
static void test_broken(void **state)
{
    (void)state;
    static const Header headers[] = {
        {0, 1, 8, RGB, false},       {1, 0, 8, RGB, false},  {-1, 1, 8, RGB, false},
        {1, -1, 8, RGB, false},      {1, 1, 3, RGB, false},  {1, 1, 4, RGB, false},
        {1, 1, 16, PALETTE, false},  {1, 1, 8, 1, false},    {1, 1, 8, 7, false},
        {1 << 30, 1, 8, RGB, false}, {1, 1, 0, GRAY, false}, {1, 1, 32, RGB, false},
    };
    PictureFile file = {.size = 0};
    for (size_t i = 0; i < sizeof headers / sizeof *headers; i++) {
        file.size = 0;
        put_header(&file, &headers[i]);
        put_rows(&file, ROWS("\0\x10\x80\xC0"));
        picture_refused(&file, picture_alone, true, "cannot read the image 'a'");
        picture_refused(&file, picture_alone, false, "cannot read the image 'a'");
    }
    file.size = 0;
    put_header(&file, &(Header){LIMIT_IMAGE_SIDE + 1, 1, 8, GRAY, false});
    put_rows(&file, ROWS("\0"));
    picture_refused(&file, picture_alone, false, "the image is too large");
    file.size = 0;
    put_header(&file, &(Header){1, 1, 8, RGB, false});
    put_rows(&file, ROWS("\0\x10\x80\xC0"));
    const size_t whole = file.size - 12; /* IEND says nothing that is needed */
    for (file.size = 0; file.size < whole - 8; file.size++)
        picture_refused(&file, picture_alone, true, "cannot read the image 'a'");
    file.size = whole;
    check_texels(&file, 1, 1, "\x10\x80\xC0\xFF", true);
    /* a byte that is another: an error, or another picture, in no memory */
    for (size_t i = 0; i < whole - 8; i++) {
        file.bytes[i] ^= 0x55;
        matc_document_free(picture_read(&file, picture_alone, true));
        file.bytes[i] ^= 0x55;
    }
}

/* A large header over a short file: no memory is allocated for rows that cannot be there; rows that
 * can be there are counted. */
static void test_large(void **state)
{
    (void)state;
    PictureFile file = {.size = 0};
    put_header(&file, &(Header){LIMIT_IMAGE_SIDE, LIMIT_IMAGE_SIDE, 8, GRAY, false});
    put_rows(&file, ROWS("\0"));
    picture_refused(&file, picture_alone, true, "the file is truncated");
    /* a program needs no more than the size */
    MatcDocument *unread = picture_read(&file, picture_alone, false);
    assert_non_null(unread->graph);
    matc_document_free(unread);

    /* a texel, and all of LIMIT_PIXELS_MIB as far as the size of the file can tell */
    static PictureFile files[2];
    static const char two_pictures[] = "material: Phong\ndiffuse: { map: ImageMap, image: a }\n"
                                       "specular: { map: ImageMap, image: b }\n";
    static uint8_t data[40000];
    put_header(&files[0], &(Header){1, 1, 8, GRAY, false});
    put_rows(&files[0], ROWS("\0\x01"));
    put_header(&files[1], &(Header){LIMIT_IMAGE_SIDE, LIMIT_IMAGE_SIDE, 1, GRAY, false});
    put_rows(&files[1], data, sizeof data);
    picture_refused(files, two_pictures, true,
                    "'b': the images of the document are too large in total");
    unread = picture_read(files, two_pictures, false);
    assert_non_null(unread->graph);
    matc_document_free(unread);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_16_bits),
        cmocka_unit_test(test_gray),
        cmocka_unit_test(test_palette),
        cmocka_unit_test(test_transparent_colour),
        cmocka_unit_test(test_said_about_colours),
        cmocka_unit_test(test_interlaced),
        cmocka_unit_test(test_row_filters),
        cmocka_unit_test(test_rows_from_below),
        cmocka_unit_test(test_broken),
        cmocka_unit_test(test_large),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
