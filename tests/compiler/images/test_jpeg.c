/* JPEG files written byte by byte here, by ITU-T T.81 and without a library, so that their
 * texels are known: blocks with only a DC coefficient, whose texels are 128 + DC / 8 with a
 * quantization table of ones. Then broken files and files that demand too much memory. */
#include "tests/test.h"
#include "tests/picture.h"

enum { BASELINE = 0xC0, EXTENDED = 0xC1, PROGRESSIVE = 0xC2, LOSSLESS = 0xC3, ARITHMETIC = 0xC9 };

typedef struct {
    PictureFile made;
    unsigned bits, bit_count; /* of the scan, that do not make a byte yet */
} File;

static void put_byte(File *file, int byte)
{
    picture_put(&file->made, &(uint8_t){(uint8_t)byte}, 1);
}

static void put_two(File *file, int number)
{
    put_byte(file, number >> 8 & 255);
    put_byte(file, number & 255);
}

static void put_segment(File *file, int marker, const char *bytes, size_t size)
{
    put_byte(file, 0xFF);
    put_byte(file, marker);
    put_two(file, (int)size + 2);
    for (size_t i = 0; i < size; i++)
        put_byte(file, (uint8_t)bytes[i]);
}

/* A byte of ones has a zero behind it. */
static void put_bits(File *file, unsigned bits, unsigned count)
{
    while (count--) {
        file->bits = file->bits << 1 | (bits >> count & 1);
        if (++file->bit_count < 8)
            continue;
        put_byte(file, (int)(file->bits & 255));
        if ((file->bits & 255) == 255)
            put_byte(file, 0);
        file->bit_count = 0;
    }
}

static void end_scan(File *file)
{
    while (file->bit_count)
        put_bits(file, 1, 1);
}

/* A DC coefficient that is `more` than the one before it, of -255 to 255 and not below 128 in size:
 * category 8, of code 0; then the end of the block, of code 0. */
static void put_block(File *file, int more)
{
    put_bits(file, 0, 1);
    put_bits(file, (unsigned)(more < 0 ? more + 255 : more), 8);
    put_bits(file, 0, 1);
}

typedef struct {
    int frame, width, height, components, precision;
} Header;

/* All up to the scan's header: tables of ones and of one code each. */
static void put_tables(File *file, const Header *header)
{
    static const char one_code[16] = {1};
    char ones[65], codes[18];
    memset(ones, 1, sizeof ones);
    ones[0] = 0;
    *file = (File){.bits = 0};
    put_two(file, 0xFFD8);
    put_segment(file, 0xDB, ones, sizeof ones);
    memcpy(codes + 1, one_code, sizeof one_code);
    codes[0] = 0x00, codes[17] = 8; /* DC: category 8 */
    put_segment(file, 0xC4, codes, sizeof codes);
    codes[0] = 0x10, codes[17] = 0; /* AC: end of block */
    put_segment(file, 0xC4, codes, sizeof codes);
    put_two(file, 0xFF00 | header->frame);
    put_two(file, 8 + 3 * header->components);
    put_byte(file, header->precision);
    put_two(file, header->height);
    put_two(file, header->width);
    put_byte(file, header->components);
    for (int i = 0; i < header->components; i++) {
        put_byte(file, i + 1);
        put_byte(file, 0x11);
        put_byte(file, 0);
    }
}

/* The band from `low` to `high`, from bit `from` (0: from the beginning) down to bit `to`. */
static void begin_scan(File *file, int components, const int band[4])
{
    put_two(file, 0xFFDA);
    put_two(file, 6 + 2 * components);
    put_byte(file, components);
    for (int i = 0; i < components; i++) {
        put_byte(file, i + 1);
        put_byte(file, 0);
    }
    put_byte(file, band[0]);
    put_byte(file, band[1]);
    put_byte(file, band[2] << 4 | band[3]);
}

static const int whole_band[4] = {0, 63, 0, 0};

static void put_header(File *file, const Header *header)
{
    put_tables(file, header);
    begin_scan(file, header->components, whole_band);
}

static void put_end(File *file)
{
    end_scan(file);
    put_two(file, 0xFFD9);
}

static const uint8_t *texel_at(MatcDocument *document, int column, int row)
{
    const Image *image = picture_of(document);
    assert_true(image->bits == 8 && image->opaque && image->texels);
    return image_bytes(image) + 4 * (row * image->width + column);
}

static void is_texel(MatcDocument *document, int column, int row, const int rgb[3])
{
    const uint8_t *texel = texel_at(document, column, row);
    for (int component = 0; component < 3; component++)
        assert_int_equal(texel[component], rgb[component]);
    assert_int_equal(texel[3], 255);
}

/* Two blocks beside each other and two below: 128 + 200 / 8, 128; 128 - 240 / 8, 128 - 80 / 8. The
 * bottom row comes first. */
static void grey_blocks(void **state)
{
    (void)state;
    File file;
    put_header(&file, &(Header){BASELINE, 13, 16, 1, 8});
    put_block(&file, 200);
    put_block(&file, -200);
    put_block(&file, -240);
    put_block(&file, 160);
    put_end(&file);
    MatcDocument *document = picture_read(&file.made, picture_alone, true);
    is_texel(document, 0, 15, (int[]){153, 153, 153});
    is_texel(document, 7, 8, (int[]){153, 153, 153});
    is_texel(document, 12, 15, (int[]){128, 128, 128});
    is_texel(document, 0, 0, (int[]){98, 98, 98});
    is_texel(document, 8, 0, (int[]){118, 118, 118});
    assert_int_equal(document->graph->images[0]->width, 13);
    assert_int_equal(document->graph->images[0]->height, 16);
    matc_document_free(document);
    /* a program needs no more than the size */
    document = picture_read(&file.made, picture_alone, false);
    assert_true(document->graph && document->graph->images[0]->width == 13 &&
                !document->graph->images[0]->texels);
    matc_document_free(document);
}

/* Y 153, Cb 148, Cr 98 by JFIF: R = Y + 1.402 (Cr - 128), G = Y - 0.344136 (Cb - 128) - 0.714136
 * (Cr - 128), B = Y + 1.772 (Cb - 128). */
static void put_color(File *file)
{
    put_header(file, &(Header){BASELINE, 8, 8, 3, 8});
    put_block(file, 200);
    put_block(file, 160);
    put_block(file, -240);
    put_end(file);
}

static void colors(void **state)
{
    (void)state;
    File file;
    put_color(&file);
    MatcDocument *document = picture_read(&file.made, picture_alone, true);
    is_texel(document, 3, 3, (int[]){111, 168, 188});
    matc_document_free(document);
}

/* A block's mean, as the first scan, which is open. */
static void put_progressive(File *file)
{
    put_tables(file, &(Header){PROGRESSIVE, 8, 8, 1, 8});
    begin_scan(file, 1, (int[]){0, 0, 0, 0});
    put_bits(file, 0, 1);
    put_bits(file, 200, 8);
}

/* A progressive file may stop after its first scan. */
static void progressive(void **state)
{
    (void)state;
    File file;
    put_progressive(&file);
    put_end(&file);
    MatcDocument *document = picture_read(&file.made, picture_alone, true);
    is_texel(document, 5, 2, (int[]){153, 153, 153});
    matc_document_free(document);
}

static void kinds_that_are_refused(void **state)
{
    (void)state;
    static const struct {
        Header header;
        const char *why;
    } rows[] = {
        {{BASELINE, 8, 8, 4, 8}, "CMYK is not supported; save it as RGB"},
        {{BASELINE, 8, 8, 2, 8}, "it is neither grayscale nor RGB"},
        {{BASELINE, 8, 8, 5, 8}, ""},
        {{BASELINE, 8, 8, 0, 8}, ""},
        {{BASELINE, 8, 8, 255, 8}, ""},
        {{ARITHMETIC, 8, 8, 1, 8}, "arithmetic coding is not supported"},
        {{EXTENDED, 8, 8, 1, 12}, ""},
        {{LOSSLESS, 8, 8, 1, 8}, ""},
        {{BASELINE, 0, 8, 1, 8}, ""},
        {{BASELINE, 8, 0, 1, 8}, ""},
        {{BASELINE, LIMIT_IMAGE_SIDE + 1, 1, 1, 8}, "the image is too large"},
        {{BASELINE, 65535, 65535, 3, 8}, ""},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int pixels = 0; pixels < 2; pixels++) {
            File file;
            put_header(&file, &rows[i].header);
            for (int block = 0; block < 8; block++)
                put_block(&file, 200);
            put_end(&file);
            picture_refused(&file.made, picture_alone, pixels, rows[i].why);
        }
}

/* A header speaks of much: nothing is allocated for what cannot be there. */
static void large(void **state)
{
    (void)state;
    File file;
    for (int frame = BASELINE; frame <= PROGRESSIVE; frame += PROGRESSIVE - BASELINE) {
        put_header(&file, &(Header){frame, LIMIT_IMAGE_SIDE, LIMIT_IMAGE_SIDE, 3, 8});
        put_block(&file, 200);
        put_end(&file);
        picture_refused(&file.made, picture_alone, true, "the file is truncated");
        MatcDocument *document = picture_read(&file.made, picture_alone, false);
        assert_non_null(document->graph);
        matc_document_free(document);
    }
}

/* Each coefficient alone, in three steps of its bits: 189 scans after the first, none of which says
 * anything. */
static void many_scans(void **state)
{
    (void)state;
    File file;
    put_progressive(&file);
    end_scan(&file);
    for (int bit = 2; bit >= 0; bit--)
        for (int k = 1; k < 64; k++) {
            begin_scan(&file, 1, (int[]){k, k, bit < 2 ? bit + 1 : 0, bit});
            put_bits(&file, 0, 1);
            end_scan(&file);
        }
    put_end(&file);
    picture_refused(&file.made, picture_alone, true, "it has too many scans");
}

/* Damage that libjpeg fills in with gray and only warns about: blocks missing before the end, a
 * code that is in no table, bands that do not go together. */
static void damaged_scans(void **state)
{
    (void)state;
    File file;
    /* four blocks, of which three are there */
    put_header(&file, &(Header){BASELINE, 16, 16, 1, 8});
    for (int block = 0; block < 3; block++)
        put_block(&file, 200);
    put_end(&file);
    picture_refused(&file.made, picture_alone, true, "premature end of data segment");
    put_header(&file, &(Header){BASELINE, 16, 16, 1, 8});
    put_block(&file, 200);
    for (int i = 0; i < 60; i++)
        put_bits(&file, 1, 1); /* the tables' only code is 0 */
    put_end(&file);
    picture_refused(&file.made, picture_alone, true, "bad Huffman code");
    put_tables(&file, &(Header){PROGRESSIVE, 8, 8, 1, 8});
    begin_scan(&file, 1, (int[]){1, 63, 0, 0}); /* before any mean */
    put_bits(&file, 0, 1);
    put_end(&file);
    picture_refused(&file.made, picture_alone, true, "progression");
}

/* Bytes between segments that belong to none are common, and change nothing. */
static void bytes_between_segments(void **state)
{
    (void)state;
    File file, padded;
    put_color(&file);
    padded = file;
    /* behind the first marker */
    memmove(padded.made.bytes + 2 + 3, padded.made.bytes + 2, file.made.size - 2);
    memset(padded.made.bytes + 2, 0x55, 3);
    padded.made.size += 3;
    MatcDocument *document = picture_read(&padded.made, picture_alone, true);
    is_texel(document, 3, 3, (int[]){111, 168, 188});
    matc_document_free(document);
}

/* Every length of a file that is cut off, and every byte another one: an error, or another picture,
 * in no memory. */
static void broken(void **state)
{
    (void)state;
    File file;
    put_color(&file);
    const size_t whole = file.made.size;
    /* the last two say that it ends */
    for (file.made.size = 0; file.made.size < whole - 2; file.made.size++)
        picture_refused(&file.made, picture_alone, true, "cannot read the image 'a'");
    file.made.size = whole;
    for (size_t i = 0; i < whole; i++)
        for (int bit = 0; bit < 8; bit++) {
            file.made.bytes[i] ^= (uint8_t)(1 << bit);
            matc_document_free(picture_read(&file.made, picture_alone, true));
            file.made.bytes[i] ^= (uint8_t)(1 << bit);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grey_blocks),
        cmocka_unit_test(colors),
        cmocka_unit_test(progressive),
        cmocka_unit_test(kinds_that_are_refused),
        cmocka_unit_test(large),
        cmocka_unit_test(many_scans),
        cmocka_unit_test(broken),
        cmocka_unit_test(damaged_scans),
        cmocka_unit_test(bytes_between_segments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
