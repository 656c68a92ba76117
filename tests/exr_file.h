/* OpenEXR files of known texels, above 1 and below 0 too. Uncompressed files are written byte by
 * byte, by the specification and without a library; compressed and tiled files by OpenEXR's own
 * writer. */
#ifndef TESTS_EXR_FILE_H
#define TESTS_EXR_FILE_H
#include "tests/picture.h"
#include <OpenEXR/openexr.h>
#include <math.h>

enum { UINT = 0, HALF = 1, FLOAT = 2, MAX_CHANNELS = 5, UNCOMPRESSED = 0, B44 = 6, MAX_SIDE = 48 };

/* Windows are (min x, min y, max x, max y), y down. `channels` has one letter per channel in
 * ascending order, and `types` a type for each; the last channel has a sample in every
 * `sampling`-th column and line; 0: in all. */
typedef struct {
    int data[4], display[4];
    const char *channels;
    int types[MAX_CHANNELS];
    int compression, sampling, tile;
} ExrHeader;

/* A channel's value at a pixel of the file: a multiple of 1/8 in (-256, 256), so that a half
 * float holds it exactly. */
static inline double exr_number(char channel, int x, int y)
{
    return (channel == 'A'   ? 4
            : channel == 'G' ? -100
                             : 16) +
           (channel % 8) / 8. + 2 * x + (y % 16) * 4 - (y > 16) * .5;
}

static inline void exr_put_int(PictureFile *file, int64_t number, int bytes)
{
    for (int i = 0; i < bytes; i++)
        picture_put(file, &(uint8_t){(uint8_t)(number >> 8 * i)}, 1);
}

/* Converts an exactly representable number to a half float: sign, exponent above -15, ten bits
 * of mantissa. */
static inline uint16_t exr_half(double number)
{
    int exponent;
    const double share = frexp(fabs(number), &exponent);
    if (isnan(number) || isinf(number))
        return isnan(number) ? 0x7E00 : 0x7C00;
    const int bits = number == 0 ? 0 : (exponent + 14) << 10 | ((int)(share * 2048) & 1023);
    return (uint16_t)(bits | (number < 0 ? 0x8000 : 0));
}

static inline void exr_put_sample(PictureFile *file, int type, double number)
{
    const float single = (float)number;
    int32_t bits;
    memcpy(&bits, &single, sizeof bits);
    if (type == HALF)
        exr_put_int(file, exr_half(number), 2);
    else
        exr_put_int(file, type == UINT ? (int)number : bits, 4);
}

static inline void exr_put_attribute(PictureFile *file, const char *name, const char *type,
                                     int size)
{
    picture_put(file, name, strlen(name) + 1);
    picture_put(file, type, strlen(type) + 1);
    exr_put_int(file, size, 4);
}

static inline void exr_put_window(PictureFile *file, const char *name, const int window[4])
{
    exr_put_attribute(file, name, "box2i", 16);
    for (int i = 0; i < 4; i++)
        exr_put_int(file, window[i], 4);
}

static inline int step_of(const ExrHeader *h, int channel)
{
    return h->channels[channel + 1] || !h->sampling ? 1 : h->sampling;
}

static inline void exr_put_channels(PictureFile *file, const ExrHeader *h)
{
    const int count = (int)strlen(h->channels);
    exr_put_attribute(file, "channels", "chlist", 18 * count + 1);
    for (int i = 0; i < count; i++) {
        picture_put(file, &h->channels[i], 1);
        exr_put_int(file, 0, 1);
        exr_put_int(file, h->types[i], 4);
        exr_put_int(file, 0, 4); /* not perceptually linear; reserved bytes */
        exr_put_int(file, step_of(h, i), 4);
        exr_put_int(file, step_of(h, i), 4);
    }
    exr_put_int(file, 0, 1);
}

static inline void exr_put_header(PictureFile *file, const ExrHeader *h)
{
    file->size = 0;
    exr_put_int(file, 20000630, 4);
    exr_put_int(file, 2, 4); /* version 2; scan lines, single part */
    exr_put_channels(file, h);
    exr_put_attribute(file, "compression", "compression", 1);
    exr_put_int(file, h->compression, 1);
    exr_put_window(file, "dataWindow", h->data);
    exr_put_window(file, "displayWindow", h->display);
    exr_put_attribute(file, "lineOrder", "lineOrder", 1);
    exr_put_int(file, 0, 1);
    exr_put_attribute(file, "pixelAspectRatio", "float", 4);
    exr_put_int(file, 0x3F800000, 4);
    exr_put_attribute(file, "screenWindowCenter", "v2f", 8);
    exr_put_int(file, 0, 8);
    exr_put_attribute(file, "screenWindowWidth", "float", 4);
    exr_put_int(file, 0x3F800000, 4);
    exr_put_int(file, 0, 1);
}

/* Writes a scan line: all samples of its first channel, then of its second. */
static inline void exr_put_line(PictureFile *file, const ExrHeader *h, int y)
{
    for (int i = 0; h->channels[i]; i++)
        for (int x = h->data[0]; x <= h->data[2]; x++)
            if (x % step_of(h, i) == 0 && y % step_of(h, i) == 0)
                exr_put_sample(file, h->types[i], exr_number(h->channels[i], x, y));
}

/* Writes the table of line offsets, then the lines. */
static inline void exr_put_file(PictureFile *file, const ExrHeader *h)
{
    static PictureFile lines;
    const int high = h->data[3] - h->data[1] + 1;
    lines.size = 0;
    exr_put_header(file, h);
    const size_t first = file->size + (size_t)high * 8;
    for (int y = h->data[1]; y <= h->data[3]; y++) {
        static PictureFile line;
        line.size = 0;
        exr_put_line(&line, h, y);
        exr_put_int(file, (int64_t)(first + lines.size), 8);
        exr_put_int(&lines, y, 4);
        exr_put_int(&lines, (int64_t)line.size, 4);
        picture_put(&lines, line.bytes, line.size);
    }
    picture_put(file, lines.bytes, lines.size);
}

/* Expected component of the picture's texel, by the channels' names. */
static inline float exr_wanted(const ExrHeader *h, int component, int x, int y)
{
    const bool is_grey = strchr(h->channels, 'Y') && !strpbrk(h->channels, "RGB");
    const char channel = is_grey && component < 3 ? 'Y' : "RGBA"[component];
    if (x < h->data[0] || x > h->data[2] || y < h->data[1] || y > h->data[3])
        return 0;
    return strchr(h->channels, channel) ? (float)exr_number(channel, x, y)
                                        : (float)(component == 3);
}

static inline void exr_check(PictureFile *file, const ExrHeader *h, bool opaque)
{
    static float texels[MAX_SIDE * MAX_SIDE * 4];
    const int wide = h->display[2] - h->display[0] + 1, high = h->display[3] - h->display[1] + 1;
    for (int i = 0; i < wide * high * 4; i++)
        texels[i] =
            exr_wanted(h, i % 4, h->display[0] + i / 4 % wide, h->display[3] - i / 4 / wide);
    picture_check(file, &(PictureWanted){wide, high, 32, opaque, texels});
}

#define WINDOW(x, y)                                                                               \
    {                                                                                              \
        0, 0, (x)-1, (y)-1                                                                         \
    }
#define SMALL WINDOW(3, 2), WINDOW(3, 2)

static inline int64_t write_to(exr_const_context_t exr, void *user, const void *bytes,
                               uint64_t size, uint64_t offset, exr_stream_error_func_ptr_t say)
{
    PictureFile *file = user;
    (void)exr, (void)say;
    assert_true(offset + size <= PICTURE_CAPACITY);
    memcpy(file->bytes + offset, bytes, size);
    if (offset + size > file->size)
        file->size = offset + size;
    return (int64_t)size;
}

/* Writes one block of lines or one tile whose first texel is (x, y). */
static inline void write_chunk(exr_context_t exr, const ExrHeader *h, const exr_chunk_info_t *info,
                               const int at[2])
{
    static float floats[MAX_CHANNELS][MAX_SIDE * MAX_SIDE];
    static uint16_t halves[MAX_CHANNELS][MAX_SIDE * MAX_SIDE];
    exr_encode_pipeline_t pipe = EXR_ENCODE_PIPELINE_INITIALIZER;
    assert_int_equal(exr_encoding_initialize(exr, 0, info, &pipe), 0);
    for (int i = 0; i < pipe.channel_count; i++) {
        exr_coding_channel_info_t *channel = &pipe.channels[i];
        for (int k = 0; k < info->width * info->height; k++) {
            const double number =
                exr_number(h->channels[i], at[0] + k % info->width, at[1] + k / info->width);
            floats[i][k] = (float)number;
            halves[i][k] = exr_half(number);
        }
        const int size = h->types[i] == HALF ? 2 : 4;
        channel->user_pixel_stride = size;
        channel->user_line_stride = size * info->width;
        channel->encode_from_ptr =
            size == 2 ? (const uint8_t *)halves[i] : (const uint8_t *)floats[i];
    }
    assert_int_equal(exr_encoding_choose_default_routines(exr, 0, &pipe), 0);
    assert_int_equal(exr_encoding_run(exr, 0, &pipe), 0);
    exr_encoding_destroy(exr, &pipe);
}

static inline void write_lines(exr_context_t exr, const ExrHeader *h)
{
    int32_t step;
    assert_int_equal(exr_get_scanlines_per_chunk(exr, 0, &step), 0);
    for (int y = h->data[1]; y <= h->data[3]; y += step) {
        exr_chunk_info_t info;
        assert_int_equal(exr_write_scanline_chunk_info(exr, 0, y, &info), 0);
        write_chunk(exr, h, &info, (int[]){h->data[0], y});
    }
}

static inline void write_tiles(exr_context_t exr, const ExrHeader *h)
{
    for (int y = h->data[1], j = 0; y <= h->data[3]; y += h->tile, j++)
        for (int x = h->data[0], i = 0; x <= h->data[2]; x += h->tile, i++) {
            exr_chunk_info_t info;
            assert_int_equal(exr_write_tile_chunk_info(exr, 0, i, j, 0, 0, &info), 0);
            write_chunk(exr, h, &info, (int[]){x, y});
        }
}

static inline exr_attr_box2i_t window_of(const int at[4])
{
    return (exr_attr_box2i_t){.min = {.x = at[0], .y = at[1]}, .max = {.x = at[2], .y = at[3]}};
}

static inline void exr_write_file(PictureFile *file, const ExrHeader *h)
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
    assert_int_equal(
        exr_add_part(exr, "a", h->tile ? EXR_STORAGE_TILED : EXR_STORAGE_SCANLINE, &part), 0);
    assert_int_equal(exr_initialize_required_attr(exr, part, &display, &data, 1, &middle, 1,
                                                  EXR_LINEORDER_INCREASING_Y,
                                                  (exr_compression_t)h->compression),
                     0);
    for (int i = 0; h->channels[i]; i++)
        assert_int_equal(exr_add_channel(exr, part, (char[]){h->channels[i], 0},
                                         (exr_pixel_type_t)h->types[i],
                                         EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1),
                         0);
    if (h->tile)
        assert_int_equal(exr_set_tile_descriptor(exr, part, (uint32_t)h->tile, (uint32_t)h->tile,
                                                 EXR_TILE_ONE_LEVEL, EXR_TILE_ROUND_DOWN),
                         0);
    assert_int_equal(exr_write_header(exr), 0);
    if (h->tile)
        write_tiles(exr, h);
    else
        write_lines(exr, h);
    assert_int_equal(exr_finish(&exr), 0);
}

static const int exr_compressions[] = {EXR_COMPRESSION_NONE, EXR_COMPRESSION_RLE,
                                       EXR_COMPRESSION_ZIPS, EXR_COMPRESSION_ZIP,
                                       EXR_COMPRESSION_PIZ};
enum { EXR_COMPRESSIONS = sizeof exr_compressions / sizeof *exr_compressions };
#endif
