/* Reads JPEG files by libjpeg-turbo: grayscale, YCbCr or RGB, baseline and progressive. Warnings
 * of the library, for instance about a truncated scan, are errors here, since half an image is
 * useless. */
#include "compiler/images/image_file.h"
#include <setjmp.h>
#include <stdio.h>
#include <string.h>
#include <jpeglib.h>

#include <jerror.h>

enum {
    /* Max scans of a progressive file, each of which covers the whole image; encoders write
     * about ten. */
    MAX_SCANS = 128,
    BLOCK = 8,          /* texels along a block's edge */
    MIN_BLOCK_BITS = 1, /* min bits of a block in a file: a code of one bit */
};

/* Lives outside the function that calls setjmp, so longjmp of libjpeg's errors preserves it. */
typedef struct {
    struct jpeg_decompress_struct jpeg;
    struct jpeg_error_mgr errors;
    struct jpeg_source_mgr source;
    struct jpeg_progress_mgr progress;
    ImageFile *file;
    jmp_buf back;
    const char *why;
} JpegReader;

static JpegReader *reader_of(j_common_ptr jpeg) { return jpeg->client_data; }

static void fail(JpegReader *d, const char *why)
{
    d->why = why;
    longjmp(d->back, 1);
}

static void on_error(j_common_ptr jpeg)
{
    char message[JMSG_LENGTH_MAX];
    jpeg->err->format_message(jpeg, message);
    JpegReader *d = reader_of(jpeg);
    fail(d, arena_string(d->file->session->arena, message, strlen(message)));
}

/* Negative levels are corrupt data. Stray bytes between segments are common and harmless. */
static void on_message(j_common_ptr jpeg, int level)
{
    if (level < 0 && jpeg->err->msg_code != JWRN_EXTRANEOUS_DATA)
        on_error(jpeg);
}

static void on_begin(j_decompress_ptr jpeg) { (void)jpeg; }

/* The whole file is in memory: a request for more data means that the file is truncated. */
static boolean on_more(j_decompress_ptr jpeg)
{
    fail(reader_of((j_common_ptr)jpeg), image_file_cut);
    return FALSE;
}

static void on_skip(j_decompress_ptr jpeg, long count)
{
    if (count > 0 && (size_t)count > jpeg->src->bytes_in_buffer)
        on_more(jpeg);
    if (count <= 0)
        return;
    jpeg->src->next_input_byte += count;
    jpeg->src->bytes_in_buffer -= (size_t)count;
}

static void on_progress(j_common_ptr jpeg)
{
    if (((j_decompress_ptr)jpeg)->input_scan_number > MAX_SCANS)
        fail(reader_of(jpeg), "it has too many scans");
}

static void set_up(JpegReader *d)
{
    struct jpeg_decompress_struct *jpeg = &d->jpeg;
    jpeg->err = jpeg_std_error(&d->errors);
    d->errors.error_exit = on_error;
    d->errors.emit_message = on_message;
    jpeg->client_data = d;
}

static void set_source(JpegReader *d)
{
    d->source = (struct jpeg_source_mgr){.next_input_byte = (const JOCTET *)d->file->at,
                                         .bytes_in_buffer = (size_t)(d->file->end - d->file->at),
                                         .init_source = on_begin,
                                         .fill_input_buffer = on_more,
                                         .skip_input_data = on_skip,
                                         .resync_to_restart = jpeg_resync_to_restart,
                                         .term_source = on_begin};
    d->progress.progress_monitor = on_progress;
    d->jpeg.src = &d->source;
    d->jpeg.progress = &d->progress;
}

static void check_kind(JpegReader *d)
{
    const struct jpeg_decompress_struct *jpeg = &d->jpeg;
    if (jpeg->jpeg_color_space == JCS_CMYK || jpeg->jpeg_color_space == JCS_YCCK)
        fail(d, "CMYK is not supported; save it as RGB");
    if (jpeg->jpeg_color_space != JCS_GRAYSCALE && jpeg->jpeg_color_space != JCS_YCbCr &&
        jpeg->jpeg_color_space != JCS_RGB)
        fail(d, "it is neither grayscale nor RGB");
    if (jpeg->arith_code)
        fail(d, "arithmetic coding is not supported; save it with Huffman coding");
}

static void read_header(JpegReader *d)
{
    Image *image = d->file->image;
    jpeg_read_header(&d->jpeg, TRUE);
    const char *why = image_file_check_side(d->jpeg.image_width, d->jpeg.image_height);
    if (why)
        fail(d, why);
    check_kind(d);
    *image = (Image){.path = image->path,
                     .index = image->index,
                     .width = (int)d->jpeg.image_width,
                     .height = (int)d->jpeg.image_height,
                     .bits = 8,
                     .opaque = true};
}

/* Rejects a file that is too short for its header before allocating memory: the data must be
 * able to hold all blocks of the finest component. */
static void check_size(JpegReader *d)
{
    const size_t wide = ((size_t)d->file->image->width + BLOCK - 1) / BLOCK;
    const size_t high = ((size_t)d->file->image->height + BLOCK - 1) / BLOCK;
    if (wide * high * MIN_BLOCK_BITS / 8 > d->source.bytes_in_buffer)
        fail(d, image_file_cut);
    /* limits the memory of a progressive file's coefficients */
    d->jpeg.mem->max_memory_to_use = (long)LIMIT_PIXELS_MIB << 20;
}

/* Decodes the first row before allocating memory for all rows. */
static void read_rows(JpegReader *d)
{
    const size_t stride = (size_t)d->file->image->width * 4,
                 height = (size_t)d->file->image->height;
    JSAMPROW first = arena_alloc(&d->file->memory, stride);
    d->jpeg.out_color_space = JCS_EXT_RGBA; /* sets alpha to 255 */
    /* the integer DCT gives the same pixels on every machine */
    d->jpeg.dct_method = JDCT_ISLOW;
    jpeg_start_decompress(&d->jpeg);
    jpeg_read_scanlines(&d->jpeg, &first, 1);
    const char *why = image_file_allocate(d->file);
    if (why)
        fail(d, why);
    memcpy((JSAMPROW)d->file->image->texels + stride * (height - 1), first, stride);
    while (d->jpeg.output_scanline < d->jpeg.output_height) {
        JSAMPROW row =
            (JSAMPROW)d->file->image->texels + stride * (height - 1 - d->jpeg.output_scanline);
        jpeg_read_scanlines(&d->jpeg, &row, 1);
    }
    jpeg_finish_decompress(&d->jpeg);
}

/* No local variables: longjmp could clobber them. */
static void read_picture(JpegReader *d)
{
    if (setjmp(d->back))
        return;
    jpeg_create_decompress(&d->jpeg);
    set_source(d);
    read_header(d);
    if (!d->file->session->options->pixels)
        return;
    check_size(d);
    read_rows(d);
}

const char *image_jpeg(ImageFile *file)
{
    JpegReader reader = {.file = file};
    set_up(&reader);
    read_picture(&reader);
    jpeg_destroy_decompress(&reader.jpeg);
    return reader.why;
}
