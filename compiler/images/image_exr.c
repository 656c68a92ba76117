/* Reads OpenEXR files by the C core of the OpenEXR library: half and float channels, scan lines
 * and tiles, the first part, mipmap level 0. The image covers the display window; texels of the
 * data window outside it are dropped, and missing texels are transparent black.
 *
 *     display window 0 to 3, data window 2 to 5: the image's columns are 0, 0, and the first
 *         two columns of the file
 *
 * Colors are linear and unbounded. A texel that is infinite or NaN would spread to its neighbors
 * when filtered and is therefore an error. Only the common lossless compressions are supported. */
#include "compiler/images/image_file.h"
#include <OpenEXR/openexr.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    COMPONENTS = 4,
    /* max bytes of a header: the library takes quadratic time for long headers */
    MAX_HEADER = 1 << 18,
    /* Max bytes of one allocation of the library: a block of lines, a tile, or a table of them. */
    MAX_ALLOCATION = 256 << 20,
    /* Min bytes of a block of lines or a tile: its table entry and its header. */
    MIN_CHUNK = 16,
    MAX_DEFLATED = 1032, /* max expansion ratio of deflate */
    MAX_RUN = 64,        /* max ratio of run-length encoding: 128 bytes from 2 */
};

static const char too_strange[] = "it has none of the channels R, G, B, A and Y",
                  subsampled[] = "its channels are subsampled",
                  whole[] = "its channels are integers; save halves or floats",
                  deep[] = "deep images are not supported; save it flat",
                  lossy[] = "its compression is not supported; use none, RLE, ZIPS, ZIP or PIZ",
                  not_finite[] = "a pixel is infinite or NaN",
                  no_part[] = "the file contains no image";

typedef struct {
    ImageFile *file;
    exr_context_t exr;
    exr_attr_box2i_t data, display;
    const exr_attr_chlist_t *channels;
    /* Index of the red, green, blue and alpha channel in the file; NONE: missing. */
    int component[COMPONENTS];
    bool header_read; /* the header has been read, and texels are being read */
    const char *why;  /* reason of the first fault */
} ExrReader;

enum { NONE = -1 };

/* A chunk of the file: a block of lines or a tile, whose first texel is at (x, y). */
typedef struct {
    exr_chunk_info_t info;
    int x, y;
} Chunk;

static ExrReader *reader_of(exr_const_context_t exr)
{
    void *user = NULL;
    return exr && exr_get_user_data(exr, &user) == EXR_ERR_SUCCESS ? user : NULL;
}

static bool fail(ExrReader *d, const char *why)
{
    if (!d->why)
        d->why = why;
    return false;
}

/* Keeps the first message, which is the most specific. */
static void on_error(exr_const_context_t exr, exr_result_t code, const char *message)
{
    ExrReader *d = reader_of(exr);
    if (!d || d->why)
        return;
    if (code == EXR_ERR_READ_IO)
        fail(d, image_file_cut);
    else if (code == EXR_ERR_OUT_OF_MEMORY)
        fail(d, image_file_too_large);
    else
        fail(d, arena_string(d->file->session->arena, message, strlen(message)));
}

/* Converts the library's result to success or a fault. */
static bool done(ExrReader *d, exr_result_t code)
{
    return code == EXR_ERR_SUCCESS ||
           fail(d, code == EXR_ERR_OUT_OF_MEMORY ? image_file_too_large
                                                 : exr_get_default_error_message(code));
}

static void *on_allocate(size_t size) { return size > MAX_ALLOCATION ? NULL : calloc(1, size); }

static int64_t on_size(exr_const_context_t exr, void *user)
{
    const ExrReader *d = user;
    (void)exr;
    return d->file->end - d->file->at;
}

static int64_t on_read(exr_const_context_t exr, void *user, void *to, uint64_t size,
                       uint64_t offset, exr_stream_error_func_ptr_t say)
{
    ExrReader *d = user;
    const uint64_t all = (uint64_t)(d->file->end - d->file->at);
    (void)exr, (void)say;
    if (!d->header_read && offset > MAX_HEADER) {
        fail(d, "its header is too long");
        return -1;
    }
    const uint64_t left = offset < all ? all - offset : 0, count = size < left ? size : left;
    memcpy(to, d->file->at + (offset < all ? offset : 0), count);
    return (int64_t)count;
}

/* Returns the size of a window in texels. */
static double width_of(const exr_attr_box2i_t *box) { return (double)box->max.x - box->min.x + 1; }
static double height_of(const exr_attr_box2i_t *box) { return (double)box->max.y - box->min.y + 1; }

static const exr_attr_chlist_entry_t *channel(const ExrReader *d, int component)
{
    return d->component[component] == NONE ? NULL : &d->channels->entries[d->component[component]];
}

static int find_channel(const ExrReader *d, const char *name)
{
    for (int i = 0; i < d->channels->num_channels; i++)
        if (!strcmp(d->channels->entries[i].name.str, name))
            return i;
    return NONE;
}

/* Selects the channels R, G and B, or Y for all three, and A. */
static bool choose_channels(ExrReader *d)
{
    static const char *const names[COMPONENTS] = {"R", "G", "B", "A"};
    for (int component = 0; component < COMPONENTS; component++)
        d->component[component] = find_channel(d, names[component]);
    if (d->component[0] == NONE && d->component[1] == NONE && d->component[2] == NONE)
        d->component[0] = d->component[1] = d->component[2] = find_channel(d, "Y");
    if (d->component[0] == NONE && d->component[1] == NONE && d->component[2] == NONE)
        return fail(d, too_strange);
    for (int component = 0; component < COMPONENTS; component++) {
        const exr_attr_chlist_entry_t *entry = channel(d, component);
        if (entry && (entry->x_sampling != 1 || entry->y_sampling != 1))
            return fail(d, subsampled);
        if (entry && entry->pixel_type != EXR_PIXEL_HALF && entry->pixel_type != EXR_PIXEL_FLOAT)
            return fail(d, whole);
    }
    return true;
}

static bool is_readable(ExrReader *d, exr_compression_t compression, exr_storage_t storage)
{
    if (storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED)
        return fail(d, deep);
    return compression <= EXR_COMPRESSION_PIZ || fail(d, lossy);
}

/* Reads the header of the first part. */
static bool read_part(ExrReader *d)
{
    int parts = 0;
    exr_storage_t storage = EXR_STORAGE_DEEP_SCANLINE;
    exr_compression_t compression = EXR_COMPRESSION_LAST_TYPE;
    if (!done(d, exr_get_count(d->exr, &parts)) || parts < 1)
        return fail(d, no_part);
    if (!done(d, exr_get_storage(d->exr, 0, &storage)) ||
        !done(d, exr_get_compression(d->exr, 0, &compression)))
        return false;
    if (!is_readable(d, compression, storage))
        return false;
    return done(d, exr_get_data_window(d->exr, 0, &d->data)) &&
           done(d, exr_get_display_window(d->exr, 0, &d->display)) &&
           done(d, exr_get_channels(d->exr, 0, &d->channels)) && choose_channels(d);
}

static bool covers(const exr_attr_box2i_t *a, const exr_attr_box2i_t *b)
{
    return a->min.x <= b->min.x && a->min.y <= b->min.y && a->max.x >= b->max.x &&
           a->max.y >= b->max.y;
}

/* Opens an image within the size limit. */
static bool start_read(ExrReader *d)
{
    const exr_context_initializer_t calls = {
        .size = sizeof calls,
        .error_handler_fn = on_error,
        .alloc_fn = on_allocate,
        .free_fn = free,
        .user_data = d,
        .read_fn = on_read,
        .size_fn = on_size,
        .max_image_width = LIMIT_IMAGE_SIDE,
        .max_image_height = LIMIT_IMAGE_SIDE,
        .max_tile_width = LIMIT_IMAGE_SIDE,
        .max_tile_height = LIMIT_IMAGE_SIDE,
        .zip_level = -2,
        .dwa_quality = -1,
        .flags = EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION,
    };
    return done(d, exr_start_read(&d->exr, "picture", &calls));
}

static bool read_header(ExrReader *d)
{
    Image *image = d->file->image;
    if (!start_read(d) || !read_part(d))
        return false;
    const char *why = image_file_check_side(width_of(&d->display), height_of(&d->display));
    if (why)
        return fail(d, why);
    bool halves = true;
    for (int component = 0; component < COMPONENTS; component++)
        halves &= !channel(d, component) || channel(d, component)->pixel_type == EXR_PIXEL_HALF;
    *image = (Image){.path = image->path,
                     .index = image->index,
                     .width = (int)width_of(&d->display),
                     .height = (int)height_of(&d->display),
                     .bits = 32,
                     .halves = halves,
                     .opaque = !channel(d, 3) && covers(&d->data, &d->display)};
    return true;
}

/* Rejects files that are too short for their header before allocating memory. The data must be
 * long enough for the chunks that the header declares, and all channels together, used or not,
 * must fit the limit of image memory. */
static bool check_size(ExrReader *d)
{
    static const double most[] = {[EXR_COMPRESSION_NONE] = 1,
                                  [EXR_COMPRESSION_RLE] = MAX_RUN,
                                  [EXR_COMPRESSION_ZIPS] = MAX_DEFLATED,
                                  [EXR_COMPRESSION_ZIP] = MAX_DEFLATED,
                                  [EXR_COMPRESSION_PIZ] = INFINITY};
    const double bytes = (double)(d->file->end - d->file->at);
    exr_compression_t compression;
    int32_t chunks;
    double unpacked = 0;
    if (!done(d, exr_get_chunk_count(d->exr, 0, &chunks)) ||
        !done(d, exr_get_compression(d->exr, 0, &compression)))
        return false;
    for (int i = 0; i < d->channels->num_channels; i++) {
        const exr_attr_chlist_entry_t *entry = &d->channels->entries[i];
        const double count =
            width_of(&d->data) / entry->x_sampling * (height_of(&d->data) / entry->y_sampling);
        unpacked += floor(count) * (entry->pixel_type == EXR_PIXEL_HALF ? 2 : 4);
    }
    if (unpacked > (double)LIMIT_PIXELS_MIB * (1 << 20))
        return fail(d, image_file_too_large);
    return ((double)chunks * MIN_CHUNK <= bytes && unpacked <= most[compression] * bytes) ||
           fail(d, image_file_cut);
}

/* Samples of a chunk: for each line all samples of the first channel, then of the second, ... */
typedef struct {
    const uint8_t *at, *end;
} Samples;

static uint32_t take(Samples *samples, int bytes)
{
    uint32_t word = 0;
    for (int i = 0; i < bytes; i++)
        word |= (uint32_t)*samples->at++ << 8 * i;
    return word;
}

static float half_from(uint32_t bits)
{
    const int exponent = bits >> 10 & 31, share = bits & 1023;
    const double size = exponent == 31 ? (share ? NAN : INFINITY)
                        : exponent     ? ldexp(1024 + share, exponent - 25)
                                       : ldexp(share, -24);
    return (float)(bits >> 15 ? -size : size);
}

static float float_from(uint32_t bits)
{
    float number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

/* Returns the texel at a position of the file; NULL if it is outside the image, or the image has
 * no texels yet. */
static float *texel_at(const ExrReader *d, int64_t x, int64_t y)
{
    const Image *image = d->file->image;
    const int64_t column = x - d->display.min.x, row = d->display.max.y - y;
    if (!image->texels || column < 0 || column >= image->width || row < 0 || row >= image->height)
        return NULL;
    return (float *)image->texels + (row * image->width + column) * COMPONENTS;
}

/* Stores a channel's samples of a line in every component that uses the channel. */
static bool put_line(ExrReader *d, int number, int width, const int at[2], Samples *samples)
{
    const exr_attr_chlist_entry_t *entry = &d->channels->entries[number];
    const int bytes = entry->pixel_type == EXR_PIXEL_HALF ? 2 : 4;
    if ((samples->end - samples->at) / bytes < width)
        return fail(d, image_file_cut);
    for (int i = 0; i < width; i++) {
        const uint32_t bits = take(samples, bytes);
        const float value = bytes == 2 ? half_from(bits) : float_from(bits);
        float *texel = texel_at(d, (int64_t)at[0] + i, at[1]);
        for (int component = 0; component < COMPONENTS; component++)
            if (d->component[component] == number && !isfinite(value))
                return fail(d, not_finite);
            else if (d->component[component] == number && texel)
                texel[component] = value;
    }
    return true;
}

/* Unpacks a chunk. Version 3.1.5 of the library cannot be used for this: it writes unwanted
 * channels to NULL, and treats the order A B G R as R G B A. */
static exr_result_t unpack(exr_decode_pipeline_t *decode)
{
    const Chunk *chunk = decode->decoding_user_data;
    ExrReader *d = reader_of(decode->context);
    Samples samples = {decode->unpacked_buffer,
                       (const uint8_t *)decode->unpacked_buffer + decode->chunk.unpacked_size};
    for (int row = 0; row < decode->chunk.height; row++)
        for (int i = 0; i < decode->channel_count; i++) {
            const exr_coding_channel_info_t *channel = &decode->channels[i];
            const int at[2] = {chunk->x, chunk->y + row};
            if (channel->y_samples > 1 && at[1] % channel->y_samples)
                continue;
            if (!put_line(d, i, channel->width, at, &samples))
                return EXR_ERR_CORRUPT_CHUNK;
        }
    return EXR_ERR_SUCCESS;
}

static bool decode_chunk(ExrReader *d, Chunk *chunk)
{
    exr_decode_pipeline_t decode = EXR_DECODE_PIPELINE_INITIALIZER;
    const uint64_t all = (uint64_t)(d->file->end - d->file->at);
    if (chunk->info.data_offset > all || chunk->info.packed_size > all - chunk->info.data_offset)
        return fail(d, image_file_cut);
    if (chunk->info.compression == EXR_COMPRESSION_NONE &&
        chunk->info.packed_size != chunk->info.unpacked_size)
        return fail(d, image_file_cut);
    bool fine = done(d, exr_decoding_initialize(d->exr, 0, &chunk->info, &decode));
    if (fine && decode.channel_count == d->channels->num_channels) {
        fine = done(d, exr_decoding_choose_default_routines(d->exr, 0, &decode));
        decode.decoding_user_data = chunk;
        decode.unpack_and_convert_fn = unpack;
        fine = fine && done(d, exr_decoding_run(d->exr, 0, &decode));
    }
    exr_decoding_destroy(d->exr, &decode);
    return fine;
}

/* Both functions decode at most `most` chunks, from the first on. */
static bool read_lines(ExrReader *d, int64_t most)
{
    int32_t high = 0;
    if (!done(d, exr_get_scanlines_per_chunk(d->exr, 0, &high)) || high < 1)
        return fail(d, image_file_cut);
    for (int64_t y = d->data.min.y; y <= d->data.max.y && most--; y += high) {
        Chunk chunk = {.x = d->data.min.x, .y = (int)y};
        if (!done(d, exr_read_scanline_chunk_info(d->exr, 0, (int)y, &chunk.info)) ||
            !decode_chunk(d, &chunk))
            return false;
    }
    return true;
}

static bool read_tiles(ExrReader *d, int64_t most)
{
    int32_t wide = 0, high = 0;
    if (!done(d, exr_get_tile_sizes(d->exr, 0, 0, 0, &wide, &high)) || wide < 1 || high < 1)
        return fail(d, image_file_cut);
    for (int64_t y = d->data.min.y, j = 0; y <= d->data.max.y; y += high, j++)
        for (int64_t x = d->data.min.x, i = 0; x <= d->data.max.x && most--; x += wide, i++) {
            Chunk chunk = {.x = (int)x, .y = (int)y};
            if (!done(d, exr_read_tile_chunk_info(d->exr, 0, (int)i, (int)j, 0, 0, &chunk.info)) ||
                !decode_chunk(d, &chunk))
                return false;
        }
    return true;
}

/* Initializes the texels to transparent black, or to opaque black inside the data window if the
 * file has no alpha. */
static void clear(ExrReader *d)
{
    Image *image = d->file->image;
    float *texels = memset(image->texels, 0, image_file_size(image));
    for (int64_t i = 0; !channel(d, 3) && i < (int64_t)image->width * image->height; i++) {
        const int64_t x = d->display.min.x + i % image->width,
                      y = d->display.max.y - i / image->width;
        if (x >= d->data.min.x && x <= d->data.max.x && y >= d->data.min.y && y <= d->data.max.y)
            texels[i * COMPONENTS + 3] = 1;
    }
}

static bool read_texels(ExrReader *d)
{
    exr_storage_t storage;
    if (!check_size(d) || !done(d, exr_get_storage(d->exr, 0, &storage)))
        return false;
    bool (*const read)(ExrReader *, int64_t) =
        storage == EXR_STORAGE_TILED ? read_tiles : read_lines;
    const char *why = read(d, 1) ? image_file_allocate(d->file) : d->why;
    if (why)
        return fail(d, why);
    clear(d);
    return read(d, INT64_MAX);
}

const char *image_exr(ImageFile *file)
{
    ExrReader reader = {.file = file}, *d = &reader;
    bool fine = read_header(d);
    d->header_read = true;
    if (fine && file->session->options->pixels)
        fine = read_texels(d);
    if (d->exr)
        exr_finish(&d->exr);
    return fine ? NULL : d->why;
}
