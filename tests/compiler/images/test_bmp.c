/* BMP files written byte by byte here, so that their texels are known: every depth, palettes and
 * masks, bottom-up and top-down rows. Then truncated files and inconsistent headers. Pictures of
 * unsupported formats are refused with the format's name. */
#include "tests/test.h"
#include "tests/picture.h"

enum { CORE = 12, INFO = 40, MASKED = 56, LATEST = 124, FILE_HEADER = 14, LONGEST = 64 };

typedef struct {
    /* colors: entries of the palette that are written */
    int header, width, height, bits, compression, colors;
    const uint32_t *masks;         /* of red, green, blue and alpha */
    const uint8_t *palette, *rows; /* entries as the file has them */
    size_t row_bytes;
} Bmp;

static void put_number(PictureFile *file, uint32_t number, int size)
{
    for (int i = 0; i < size; i++)
        picture_put(file, &(uint8_t){(uint8_t)(number >> 8 * i)}, 1);
}

static void write_bmp(PictureFile *file, const Bmp *bmp)
{
    const int entry = bmp->header == CORE ? 3 : 4, side = bmp->header == CORE ? 2 : 4;
    const int outside = bmp->masks && bmp->header == INFO ? bmp->compression == 6 ? 16 : 12 : 0;
    const size_t before = (size_t)(FILE_HEADER + bmp->header + outside + entry * bmp->colors);
    file->size = 0;
    picture_put(file, "BM", 2);
    put_number(file, (uint32_t)(before + bmp->row_bytes), 4);
    put_number(file, 0, 4);
    put_number(file, (uint32_t)before, 4);
    put_number(file, (uint32_t)bmp->header, 4);
    put_number(file, (uint32_t)bmp->width, side);
    put_number(file, (uint32_t)bmp->height, side);
    put_number(file, 1, 2);
    put_number(file, (uint32_t)bmp->bits, 2);
    if (bmp->header != CORE) {
        put_number(file, (uint32_t)bmp->compression, 4);
        for (int i = 0; i < 3; i++)
            put_number(file, 0, 4);
        put_number(file, (uint32_t)bmp->colors, 4);
        put_number(file, 0, 4);
        for (int i = 0; bmp->masks && i < (bmp->header == INFO && bmp->compression != 6 ? 3 : 4);
             i++)
            put_number(file, bmp->masks[i], 4);
        while (file->size < (size_t)(FILE_HEADER + bmp->header))
            put_number(file, 0, 1);
    }
    picture_put(file, bmp->palette, (size_t)(entry * bmp->colors));
    picture_put(file, bmp->rows, bmp->row_bytes);
}

static PictureFile files[2];

static void check(const Bmp *bmp, bool opaque, const uint8_t *texels)
{
    write_bmp(files, bmp);
    const int height = bmp->height < 0 ? -bmp->height : bmp->height;
    picture_check(files, &(PictureWanted){bmp->width, height, 8, opaque, texels});
}

/* Two texels a row, two rows: red, green below; blue, white above. */
static const uint8_t four[16] = {255, 0, 0,   255, 0,   255, 0,   255,
                                 0,   0, 255, 255, 255, 255, 255, 255};
static const uint8_t palette[16] = {0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0, 0, 255, 255, 255, 0};
static const uint8_t short_palette[12] = {0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255};

static void palettes(void **state)
{
    (void)state;
    static const uint8_t eight[] = {0, 1, 9, 9, 2, 3, 9, 9},
                         nibbles[] = {0x01, 9, 9, 9, 0x23, 9, 9, 9};
    static const uint8_t one[] = {0x40, 0, 0, 0, 0x80, 0, 0, 0};
    static const uint8_t two_colors[] = {255, 0,   0, 255, 0,   255, 0, 255,
                                         0,   255, 0, 255, 255, 0,   0, 255};
    check(&(Bmp){INFO, 2, 2, 8, 0, 4, NULL, palette, eight, 8}, true, four);
    check(&(Bmp){LATEST, 2, 2, 8, 0, 4, NULL, palette, eight, 8}, true, four);
    check(&(Bmp){INFO, 2, 2, 4, 0, 4, NULL, palette, nibbles, 8}, true, four);
    check(&(Bmp){INFO, 2, 2, 1, 0, 2, NULL, palette, one, 8}, true, two_colors);
    uint8_t whole[3 * 16] = {0}; /* a core header has all colors */
    memcpy(whole, short_palette, sizeof short_palette);
    check(&(Bmp){CORE, 2, 2, 4, 0, 16, NULL, whole, nibbles, 8}, true, four);
}

static void colors(void **state)
{
    (void)state;
    static const uint8_t bytes[] = {0, 0, 255, 0, 255, 0, 9, 9, 255, 0, 0, 255, 255, 255, 9, 9};
    static const uint8_t turned[] = {255, 0, 0, 255, 255, 255, 9, 9, 0, 0, 255, 0, 255, 0, 9, 9};
    static const uint8_t words[] = {0, 0, 255, 9, 0, 255, 0, 9, 255, 0, 0, 9, 255, 255, 255, 9};
    static const uint8_t halves[] = {0, 0x7C, 0xE0, 0x03, 0x1F, 0, 0xFF, 0x7F};
    check(&(Bmp){INFO, 2, 2, 24, 0, 0, NULL, NULL, bytes, 16}, true, four);
    check(&(Bmp){CORE, 2, 2, 24, 0, 0, NULL, NULL, bytes, 16}, true, four);
    check(&(Bmp){INFO, 2, -2, 24, 0, 0, NULL, NULL, turned, 16}, true, four);
    check(&(Bmp){INFO, 2, 2, 32, 0, 0, NULL, NULL, words, 16}, true, four);
    check(&(Bmp){INFO, 2, 2, 16, 0, 0, NULL, NULL, halves, 8}, true, four);
}

/* Components in other orders, and of other sizes: a of n bits is a / (2^n - 1). */
static void masks(void **state)
{
    (void)state;
    static const uint32_t five_six[] = {0xF800, 0x7E0, 0x1F, 0},
                          rgba[] = {0xFF, 0xFF00, 0xFF0000, 0xFF000000};
    static const uint32_t four_each[] = {0xF00, 0xF0, 0xF, 0xF000},
                          ten[] = {0x3FF00000, 0xFFC00, 0x3FF, 0};
    static const uint8_t green[] = {0x20, 0x04, 0, 0}, plain[] = {10, 20, 30, 40},
                         nibbles[] = {0x48, 0xF2, 0, 0};
    static const uint8_t tens[] = {0xFF, 0x03, 0x00, 0x20}; /* blue 1023, red 512 */
    static const uint8_t wanted_green[] = {0, 134, 0, 255}, wanted_plain[] = {10, 20, 30, 40};
    static const uint8_t wanted_nibbles[] = {34, 68, 136, 255}, wanted_tens[] = {128, 0, 255, 255};
    check(&(Bmp){INFO, 1, 1, 16, 3, 0, five_six, NULL, green, 4}, true, wanted_green);
    check(&(Bmp){MASKED, 1, 1, 32, 3, 0, rgba, NULL, plain, 4}, false, wanted_plain);
    check(&(Bmp){LATEST, 1, 1, 32, 3, 0, rgba, NULL, plain, 4}, false, wanted_plain);
    check(&(Bmp){INFO, 1, 1, 16, 6, 0, four_each, NULL, nibbles, 4}, false, wanted_nibbles);
    check(&(Bmp){INFO, 1, 1, 32, 3, 0, ten, NULL, tens, 4}, true, wanted_tens);
}

static void faults(void **state)
{
    (void)state;
    static const uint8_t rows[LONGEST];
    static const uint32_t torn[] = {0xF0F, 0xF0, 0, 0};
    static const struct {
        Bmp bmp;
        const char *why;
    } cases[] = {
        {{INFO, 2, 2, 8, 1, 4, NULL, palette, rows, 8},
         "compressed BMP is not supported; save it without compression"},
        {{INFO, 2, 2, 4, 2, 4, NULL, palette, rows, 8}, "compressed BMP is not supported"},
        {{INFO, 2, 2, 0, 5, 0, NULL, NULL, rows, 8}, "compressed BMP is not supported"},
        {{INFO, 2, 2, 8, 3, 4, NULL, palette, rows, 8}, "compressed BMP is not supported"},
        {{INFO, 2, 2, 2, 0, 4, NULL, palette, rows, 8}, "unknown kind of BMP"},
        {{INFO, 2, 2, 64, 0, 0, NULL, NULL, rows, 32}, "unknown kind of BMP"},
        {{16, 2, 2, 24, 0, 0, NULL, NULL, rows, 16}, "unknown kind of BMP"},
        {{INFO, 0, 2, 24, 0, 0, NULL, NULL, rows, 16}, "the image has no pixels"},
        {{INFO, -2, 2, 24, 0, 0, NULL, NULL, rows, 16}, "the image has no pixels"},
        {{INFO, 2, INT32_MIN, 24, 0, 0, NULL, NULL, rows, 16}, "the image is too large"},
        {{INFO, 20000, 2, 24, 0, 0, NULL, NULL, rows, 16}, "the image is too large"},
        {{INFO, 16384, 16384, 24, 0, 0, NULL, NULL, rows, 16}, "the file is truncated"},
        {{INFO, 2, 2, 16, 3, 0, torn, NULL, rows, 8},
         "the bits of a color channel are not contiguous"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        write_bmp(files, &cases[i].bmp);
        picture_refused(files, picture_alone, true, cases[i].why);
        picture_refused(files, picture_alone, false, cases[i].why);
    }
    static const uint8_t beyond[] = {0, 1, 9, 9, 2, 4, 9, 9};
    write_bmp(files, &(Bmp){INFO, 2, 2, 8, 0, 4, NULL, palette, beyond, 8});
    picture_refused(files, picture_alone, true, "a pixel's palette index is out of range");
}

/* Every length up to the last is too short. */
static void cut_files(void **state)
{
    (void)state;
    static const uint8_t eight[] = {0, 1, 9, 9, 2, 3, 9, 9};
    static const uint32_t rgba[] = {0xFF, 0xFF00, 0xFF0000, 0xFF000000};
    static const Bmp kinds[] = {{INFO, 2, 2, 8, 0, 4, NULL, palette, eight, 8},
                                {CORE, 2, 2, 24, 0, 0, NULL, NULL, four, 16},
                                {INFO, 2, 1, 32, 6, 0, rgba, NULL, eight, 8}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        write_bmp(files, &kinds[i]);
        for (const size_t whole = files->size; files->size > 2;) {
            files->size--;
            picture_refused(files, picture_alone, true, "the file is truncated");
            assert_true(files->size < whole);
        }
    }
}

/* Any byte of a header is anything: a picture comes, or one error. */
static void any_header(void **state)
{
    (void)state;
    static const uint8_t rows[LONGEST];
    static const uint32_t rgba[] = {0xFF, 0xFF00, 0xFF0000, 0xFF000000};
    uint64_t random = 1;
    write_bmp(files, &(Bmp){MASKED, 2, 2, 32, 3, 0, rgba, NULL, rows, LONGEST});
    const PictureFile whole = *files;
    for (int round = 0; round < 4000; round++) {
        *files = whole;
        for (int k = 0; k < 1 + round % 3; k++) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            files->bytes[2 + (random >> 33) % (FILE_HEADER + MASKED - 2)] = (uint8_t)(random >> 56);
        }
        MatcDocument *document = picture_read(files, picture_alone, true);
        assert_true(document->graph || matc_error_count(document) == 1);
        matc_document_free(document);
    }
}

static void others_are_named(void **state)
{
    (void)state;
    static const struct {
        const char *begin, *why;
    } formats[] = {{"GIF89a..", "GIF is not supported; save it as PNG"},
                   {"RIFF....WEBPVP8 ", "WebP is not supported; save it as PNG"},
                   {"II*\x08", "TIFF is not supported; save it as PNG or OpenEXR"},
                   {"#?RADIANCE\n", "Radiance HDR is not supported; save it as OpenEXR"},
                   {"DDS |", "DDS is not supported; save it as PNG"},
                   {"8BPS", "PSD is not supported; save it as PNG"},
                   {"plain text", "the format is not PNG, JPEG, OpenEXR or BMP"}};
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        files->size = 0;
        picture_put(files, formats[i].begin, strlen(formats[i].begin));
        picture_refused(files, picture_alone, false, formats[i].why);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(palettes),        cmocka_unit_test(colors),
        cmocka_unit_test(masks),           cmocka_unit_test(faults),
        cmocka_unit_test(cut_files),       cmocka_unit_test(any_header),
        cmocka_unit_test(others_are_named)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
