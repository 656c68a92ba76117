/* OpenEXR files. Those without compression are written here byte by byte, by the specification of their layout and with nothing of a
 * library's; those with one, and tiles, by OpenEXR's own writer. Texels are known, above 1 and below 0 too. Then broken and hostile ones. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/picture.h"
#include <OpenEXR/openexr.h>
#include <math.h>

enum { UINT = 0, HALF = 1, FLOAT = 2, MOST_CHANNELS = 5, UNCOMPRESSED = 0, B44 = 6, MOST_SIDE = 48 };

/* Windows as (least x, least y, greatest x, greatest y), y downwards. A type of `types` for each letter of `channels`, which ascend; the
 * last one has a sample in every `sampling` columns of every `sampling` lines, 0: in all. */
typedef struct {
    int data[4], display[4];
    const char *channels;
    int types[MOST_CHANNELS];
    int compression, sampling, tile;
} Header;

/* A channel's number at a place of the file: a multiple of 1/8 below 256 either way, so that a half holds it. */
static double number_at(char channel, int x, int y)
{
    return (channel == 'A'   ? 4
            : channel == 'G' ? -100
                             : 16) +
           (channel % 8) / 8. + 2 * x + (y % 16) * 4 - (y > 16) * .5;
}

static void put_int(PictureFile *file, int64_t number, int bytes)
{
    for (int i = 0; i < bytes; i++)
        picture_put(file, &(uint8_t){(uint8_t)(number >> 8 * i)}, 1);
}

/* Of a number that has one: sign, exponent over -15, ten bits of what is above the power of two. */
static uint16_t half_of(double number)
{
    int exponent;
    const double share = frexp(fabs(number), &exponent);
    if (isnan(number) || isinf(number))
        return isnan(number) ? 0x7E00 : 0x7C00;
    const int bits = number == 0 ? 0 : (exponent + 14) << 10 | ((int)(share * 2048) & 1023);
    return (uint16_t)(bits | (number < 0 ? 0x8000 : 0));
}

static void put_sample(PictureFile *file, int type, double number)
{
    const float single = (float)number;
    int32_t bits;
    memcpy(&bits, &single, sizeof bits);
    if (type == HALF)
        put_int(file, half_of(number), 2);
    else
        put_int(file, type == UINT ? (int)number : bits, 4);
}

static void put_attribute(PictureFile *file, const char *name, const char *type, int size)
{
    picture_put(file, name, strlen(name) + 1);
    picture_put(file, type, strlen(type) + 1);
    put_int(file, size, 4);
}

static void put_window(PictureFile *file, const char *name, const int window[4])
{
    put_attribute(file, name, "box2i", 16);
    for (int i = 0; i < 4; i++)
        put_int(file, window[i], 4);
}

static int step_of(const Header *h, int channel) { return h->channels[channel + 1] || !h->sampling ? 1 : h->sampling; }

static void put_channels(PictureFile *file, const Header *h)
{
    const int count = (int)strlen(h->channels);
    put_attribute(file, "channels", "chlist", 18 * count + 1);
    for (int i = 0; i < count; i++) {
        picture_put(file, &h->channels[i], 1);
        put_int(file, 0, 1);
        put_int(file, h->types[i], 4);
        put_int(file, 0, 4); /* not linear to the eye; reserved */
        put_int(file, step_of(h, i), 4);
        put_int(file, step_of(h, i), 4);
    }
    put_int(file, 0, 1);
}

static void put_header(PictureFile *file, const Header *h)
{
    file->size = 0;
    put_int(file, 20000630, 4);
    put_int(file, 2, 4); /* the version; lines, one part */
    put_channels(file, h);
    put_attribute(file, "compression", "compression", 1);
    put_int(file, h->compression, 1);
    put_window(file, "dataWindow", h->data);
    put_window(file, "displayWindow", h->display);
    put_attribute(file, "lineOrder", "lineOrder", 1);
    put_int(file, 0, 1);
    put_attribute(file, "pixelAspectRatio", "float", 4);
    put_int(file, 0x3F800000, 4);
    put_attribute(file, "screenWindowCenter", "v2f", 8);
    put_int(file, 0, 8);
    put_attribute(file, "screenWindowWidth", "float", 4);
    put_int(file, 0x3F800000, 4);
    put_int(file, 0, 1);
}

/* A line, with all of its first channel, then of its second. */
static void put_line(PictureFile *file, const Header *h, int y)
{
    for (int i = 0; h->channels[i]; i++)
        for (int x = h->data[0]; x <= h->data[2]; x++)
            if (x % step_of(h, i) == 0 && y % step_of(h, i) == 0)
                put_sample(file, h->types[i], number_at(h->channels[i], x, y));
}

/* Where each line is, then the lines. */
static void put_file(PictureFile *file, const Header *h)
{
    static PictureFile lines;
    const int high = h->data[3] - h->data[1] + 1;
    lines.size = 0;
    put_header(file, h);
    const size_t first = file->size + (size_t)high * 8;
    for (int y = h->data[1]; y <= h->data[3]; y++) {
        static PictureFile line;
        line.size = 0;
        put_line(&line, h, y);
        put_int(file, (int64_t)(first + lines.size), 8);
        put_int(&lines, y, 4);
        put_int(&lines, (int64_t)line.size, 4);
        picture_put(&lines, line.bytes, line.size);
    }
    picture_put(file, lines.bytes, lines.size);
}

/* What a texel of the picture is, by the names of channels. */
static float wanted_at(const Header *h, int lane, int x, int y)
{
    const bool is_grey = strchr(h->channels, 'Y') && !strpbrk(h->channels, "RGB");
    const char channel = is_grey && lane < 3 ? 'Y' : "RGBA"[lane];
    if (x < h->data[0] || x > h->data[2] || y < h->data[1] || y > h->data[3])
        return 0;
    return strchr(h->channels, channel) ? (float)number_at(channel, x, y) : (float)(lane == 3);
}

static void check(PictureFile *file, const Header *h, bool opaque)
{
    static float texels[MOST_SIDE * MOST_SIDE * 4];
    const int wide = h->display[2] - h->display[0] + 1, high = h->display[3] - h->display[1] + 1;
    for (int i = 0; i < wide * high * 4; i++)
        texels[i] = wanted_at(h, i % 4, h->display[0] + i / 4 % wide, h->display[3] - i / 4 / wide);
    picture_check(file, &(PictureWanted){wide, high, 32, opaque, texels});
}

#define WINDOW(x, y)                                                                                                   \
    {                                                                                                                  \
        0, 0, (x)-1, (y)-1                                                                                             \
    }
#define SMALL WINDOW(3, 2), WINDOW(3, 2)

/* Channels of every kind, and those that a picture has nothing to do with. */
static void channels_are_lanes(void **state)
{
    (void)state;
    static const struct {
        Header header;
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
        put_file(&file, &rows[i].header);
        check(&file, &rows[i].header, rows[i].opaque);
        MatcDocument *document = picture_read(&file, picture_alone, false); /* a program needs the header alone */
        assert_true(picture_of(document)->halves == rows[i].halves && !picture_of(document)->texels);
        matc_document_free(document);
    }
}

/* The picture is the display window: what the file has outside of it is left out, what it lacks is transparent. */
static void windows_differ(void **state)
{
    (void)state;
    static const struct {
        Header header;
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
        put_file(&file, &rows[i].header);
        check(&file, &rows[i].header, rows[i].opaque);
    }
}

static int64_t write_to(exr_const_context_t exr, void *user, const void *bytes, uint64_t size, uint64_t offset,
                        exr_stream_error_func_ptr_t say)
{
    PictureFile *file = user;
    (void)exr, (void)say;
    assert_true(offset + size <= PICTURE_ROOM);
    memcpy(file->bytes + offset, bytes, size);
    if (offset + size > file->size)
        file->size = offset + size;
    return (int64_t)size;
}

/* One block of lines or one tile, with its first texel at (x, y). */
static void write_chunk(exr_context_t exr, const Header *h, const exr_chunk_info_t *info, const int at[2])
{
    static float floats[MOST_CHANNELS][MOST_SIDE * MOST_SIDE];
    static uint16_t halves[MOST_CHANNELS][MOST_SIDE * MOST_SIDE];
    exr_encode_pipeline_t pipe = EXR_ENCODE_PIPELINE_INITIALIZER;
    assert_int_equal(exr_encoding_initialize(exr, 0, info, &pipe), 0);
    for (int i = 0; i < pipe.channel_count; i++) {
        exr_coding_channel_info_t *channel = &pipe.channels[i];
        for (int k = 0; k < info->width * info->height; k++) {
            const double number = number_at(h->channels[i], at[0] + k % info->width, at[1] + k / info->width);
            floats[i][k] = (float)number;
            halves[i][k] = half_of(number);
        }
        const int size = h->types[i] == HALF ? 2 : 4;
        channel->user_pixel_stride = size;
        channel->user_line_stride = size * info->width;
        channel->encode_from_ptr = size == 2 ? (const uint8_t *)halves[i] : (const uint8_t *)floats[i];
    }
    assert_int_equal(exr_encoding_choose_default_routines(exr, 0, &pipe), 0);
    assert_int_equal(exr_encoding_run(exr, 0, &pipe), 0);
    exr_encoding_destroy(exr, &pipe);
}

static void write_lines(exr_context_t exr, const Header *h)
{
    int32_t step;
    assert_int_equal(exr_get_scanlines_per_chunk(exr, 0, &step), 0);
    for (int y = h->data[1]; y <= h->data[3]; y += step) {
        exr_chunk_info_t info;
        assert_int_equal(exr_write_scanline_chunk_info(exr, 0, y, &info), 0);
        write_chunk(exr, h, &info, (int[]){h->data[0], y});
    }
}

static void write_tiles(exr_context_t exr, const Header *h)
{
    for (int y = h->data[1], j = 0; y <= h->data[3]; y += h->tile, j++)
        for (int x = h->data[0], i = 0; x <= h->data[2]; x += h->tile, i++) {
            exr_chunk_info_t info;
            assert_int_equal(exr_write_tile_chunk_info(exr, 0, i, j, 0, 0, &info), 0);
            write_chunk(exr, h, &info, (int[]){x, y});
        }
}

static exr_attr_box2i_t window_of(const int at[4])
{
    return (exr_attr_box2i_t){.min = {.x = at[0], .y = at[1]}, .max = {.x = at[2], .y = at[3]}};
}

static void write_file(PictureFile *file, const Header *h)
{
    exr_context_t exr;
    int part;
    exr_context_initializer_t init = EXR_DEFAULT_CONTEXT_INITIALIZER;
    init.user_data = file;
    init.write_fn = write_to;
    file->size = 0;
    const exr_attr_box2i_t data = window_of(h->data), display = window_of(h->display);
    const exr_attr_v2f_t middle = {.x = 0, .y = 0};
    assert_int_equal(exr_start_write(&exr, "a", EXR_WRITE_FILE_DIRECTLY, &init), 0);
    assert_int_equal(exr_add_part(exr, "a", h->tile ? EXR_STORAGE_TILED : EXR_STORAGE_SCANLINE, &part), 0);
    assert_int_equal(exr_initialize_required_attr(exr, part, &display, &data, 1, &middle, 1, EXR_LINEORDER_INCREASING_Y,
                                                  (exr_compression_t)h->compression),
                     0);
    for (int i = 0; h->channels[i]; i++)
        assert_int_equal(exr_add_channel(exr, part, (char[]){h->channels[i], 0}, (exr_pixel_type_t)h->types[i],
                                         EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1),
                         0);
    if (h->tile)
        assert_int_equal(exr_set_tile_descriptor(exr, part, (uint32_t)h->tile, (uint32_t)h->tile, EXR_TILE_ONE_LEVEL,
                                                 EXR_TILE_ROUND_DOWN),
                         0);
    assert_int_equal(exr_write_header(exr), 0);
    if (h->tile)
        write_tiles(exr, h);
    else
        write_lines(exr, h);
    assert_int_equal(exr_finish(&exr), 0);
}

static const int compressions[] = {EXR_COMPRESSION_NONE, EXR_COMPRESSION_RLE, EXR_COMPRESSION_ZIPS, EXR_COMPRESSION_ZIP,
                                   EXR_COMPRESSION_PIZ};

/* Blocks of one, 16 and 32 lines, the last one cut; whole tiles and cut ones. */
static void compressions_lose_nothing(void **state)
{
    (void)state;
    static const Header headers[] = {
        {WINDOW(37, 41), WINDOW(37, 41), "ABGR", {HALF, HALF, HALF, HALF}, 0, 0, 0},
        {WINDOW(37, 41), WINDOW(37, 41), "ABGR", {HALF, HALF, HALF, HALF}, 0, 0, 16},
        {{-3, 2, 33, 42}, {0, 0, 39, 39}, "BGRZ", {FLOAT, FLOAT, FLOAT, FLOAT}, 0, 0, 0},
        {{-3, 2, 33, 42}, {0, 0, 39, 39}, "Y", {FLOAT}, 0, 0, 40},
        {WINDOW(1, 1), WINDOW(1, 1), "BGR", {HALF, HALF, HALF}, 0, 0, 16},
    };
    static PictureFile file;
    for (size_t i = 0; i < sizeof headers / sizeof *headers; i++)
        for (size_t k = 0; k < sizeof compressions / sizeof *compressions; k++) {
            Header h = headers[i];
            h.compression = compressions[k];
            write_file(&file, &h);
            check(&file, &h, i == 4);
        }
}

static void kinds_that_are_refused(void **state)
{
    (void)state;
    static const struct {
        Header header;
        const char *why;
    } rows[] = {
        {{SMALL, "Z", {FLOAT}, 0, 0, 0}, "none of R, G, B, A and Y"},
        {{SMALL, "A", {FLOAT}, 0, 0, 0}, "none of R, G, B, A and Y"},
        {{SMALL, "BGR", {HALF, UINT, HALF}, 0, 0, 0}, "whole numbers"},
        {{WINDOW(4, 4), WINDOW(4, 4), "Y", {HALF}, 0, 2, 0}, "subsampled"},
        {{SMALL, "Y", {HALF}, B44, 0, 0}, "save it with one of these"},
        {{WINDOW(1, 1), WINDOW(LIMIT_IMAGE_SIDE + 1, 1), "Y", {HALF}, 0, 0, 0}, "it is too large"},
        {{WINDOW(1, 1), {0, 0, -1, 0}, "Y", {HALF}, 0, 0, 0}, ""},
        {{WINDOW(1, 1), {INT32_MIN, 0, INT32_MAX, 0}, "Y", {HALF}, 0, 0, 0}, ""},
    };
    static PictureFile file;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int pixels = 0; pixels < 2; pixels++) {
            put_file(&file, &rows[i].header);
            picture_refused(&file, picture_alone, pixels, rows[i].why);
        }
}

/* A number that is none or infinite would spread over its neighbours. */
static void numbers_are_finite(void **state)
{
    (void)state;
    static const Header header = {SMALL, "Y", {HALF}, 0, 0, 0};
    static const double numbers[] = {NAN, INFINITY, -INFINITY};
    static PictureFile file;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        put_file(&file, &header);
        file.size -= 2;
        put_sample(&file, HALF, numbers[i]);
        picture_refused(&file, picture_alone, true, "a texel is infinite or no number");
    }
}

/* Two lines of three halves, each as `size` bytes. */
static void put_short(PictureFile *file, int compression, const char *bytes, int size)
{
    put_header(file, &(Header){SMALL, "Y", {HALF}, compression, 0, 0});
    for (int row = 0; row < 2; row++)
        put_int(file, (int64_t)file->size + (2 - row) * 8 + row * (size + 8), 8);
    for (int row = 0; row < 2; row++) {
        put_int(file, row, 4);
        put_int(file, size, 4);
        picture_put(file, bytes, (size_t)size);
    }
}

/* What is packed has to make all of its lines: here two bytes, or five of six. */
static void blocks_are_whole(void **state)
{
    (void)state;
    static PictureFile file;
    put_short(&file, EXR_COMPRESSION_RLE, "\1\0", 2);
    picture_refused(&file, picture_alone, true, "");
    put_short(&file, EXR_COMPRESSION_RLE, "\4\200", 2);
    picture_refused(&file, picture_alone, true, "");
    put_short(&file, EXR_COMPRESSION_RLE, "\5\200", 2); /* 128 is no difference to the byte before: all are 0 */
    MatcDocument *document = picture_read(&file, picture_alone, true);
    assert_non_null(picture_of(document)->texels);
    matc_document_free(document);
    put_short(&file, UNCOMPRESSED, "\0\1\2\3\4", 5);
    picture_refused(&file, picture_alone, true, "");
    put_short(&file, EXR_COMPRESSION_ZIPS, "\170\234\3\0\0\0\0\1", 8);
    picture_refused(&file, picture_alone, true, "");
}

/* A header speaks of much: nothing is allocated for what cannot be there. */
static void large(void **state)
{
    (void)state;
    static PictureFile file;
    for (size_t k = 0; k < sizeof compressions / sizeof *compressions; k++) {
        const Header h = {WINDOW(LIMIT_IMAGE_SIDE, LIMIT_IMAGE_SIDE),
                          WINDOW(LIMIT_IMAGE_SIDE, LIMIT_IMAGE_SIDE),
                          "Y",
                          {HALF},
                          compressions[k],
                          0,
                          0};
        put_header(&file, &h);
        picture_refused(&file, picture_alone, true, "it ends too soon"); /* and not that it needs too much memory */
        MatcDocument *document = picture_read(&file, picture_alone, false);
        assert_int_equal(picture_of(document)->width, LIMIT_IMAGE_SIDE);
        matc_document_free(document);
    }
}

/* Every length of a file that is cut off is an error; a byte that is another is one, or another picture. */
static void broken(void **state)
{
    (void)state;
    static PictureFile file;
    for (size_t k = 0; k < sizeof compressions / sizeof *compressions; k++) {
        const Header h = {WINDOW(5, 3),  WINDOW(5, 3), "ABGR", {HALF, HALF, HALF, HALF}, compressions[k], 0,
                          k % 2 ? 16 : 0};
        write_file(&file, &h);
        const size_t whole = file.size;
        for (file.size = 4; file.size < whole; file.size += 3)
            picture_refused(&file, picture_alone, true, "cannot read the picture 'a'");
        file.size = whole;
        for (size_t i = 4; i < whole; i++) {
            file.bytes[i] ^= 0x55;
            matc_document_free(picture_read(&file, picture_alone, true));
            file.bytes[i] ^= 0x55;
        }
        check(&file, &h, false);
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

/* They are linear whatever the document's colours are, and above 1 where they are above 1. */
static void values_are_linear(void **state)
{
    (void)state;
    static const Header h = {SMALL, "BGR", {HALF, HALF, HALF}, 0, 0, 0};
    static PictureFile file;
    put_file(&file, &h);
    const double want = number_at('R', 0, 1);
    assert_true(want > 1);
    assert_true(emissive(&file, "material: Phong\nemissive: { map: ImageMap, image: a }\n") == want);
    assert_true(emissive(&file, "colors: srgb\nmaterial: Phong\nemissive: { map: ImageMap, image: a }\n") == want);
    picture_refused(&file, "material: Phong\nemissive: { map: ImageMap, image: a, colorspace: srgb }\n", false,
                    "a picture of floats is linear, never srgb");
}

/* Halves stay halves; floats are those where the target's samplers filter them. */
static void textures_hold_floats(void **state)
{
    (void)state;
    static const struct {
        const char *target, *half, *single;
    } rows[] = {
        {"glsl110", "RGBA16F", "RGBA32F"}, {"glsl330", "RGBA16F", "RGBA32F"}, {"essl300", "RGBA16F", "RGBA16F"}};
    static PictureFile file;
    for (size_t i = 0; i < 2 * sizeof rows / sizeof *rows; i++) {
        const int type = i % 2 ? FLOAT : HALF;
        const Header h = {SMALL, "BGR", {type, type, type}, 0, 0, 0};
        put_file(&file, &h);
        MatcOptions options;
        matc_options_init(&options);
        options.target = rows[i / 2].target;
        MatcDocument *document = picture_read(&file, picture_alone, true);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        const MatcTexture *texture = matc_texture(program, 0);
        assert_string_equal(texture->format, i % 2 ? rows[i / 2].single : rows[i / 2].half);
        assert_true(texture->floats && texture->floats[0] == (float)number_at('R', 0, 1));
        matc_program_free(program);
        matc_document_free(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(channels_are_lanes),
        cmocka_unit_test(windows_differ),
        cmocka_unit_test(compressions_lose_nothing),
        cmocka_unit_test(kinds_that_are_refused),
        cmocka_unit_test(numbers_are_finite),
        cmocka_unit_test(blocks_are_whole),
        cmocka_unit_test(large),
        cmocka_unit_test(broken),
        cmocka_unit_test(values_are_linear),
        cmocka_unit_test(textures_hold_floats),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
