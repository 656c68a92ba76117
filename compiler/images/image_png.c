/* Reads PNG files by libpng. Images with 16 bits per component keep them; fewer bits are
 * expanded to a byte. */
#include "compiler/images/image_file.h"
#include "compiler/base/memory.h"
#include <png.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

/* State of decoding. It lives outside the function that calls setjmp, so longjmp of libpng's
 * errors preserves it. */
typedef struct {
    ImageFile *file;
    png_structp png;
    png_infop info;
    png_bytep *rows; /* pointers to the rows, in the order of the file */
    png_bytep first; /* the first row, if it was decoded before the others were allocated */
    const char *why; /* message of the first fault */
} PngReader;

enum { MAX_DEFLATED = 1032 }; /* max expansion ratio of deflate */

static void on_error(png_structp png, png_const_charp message)
{
    PngReader *d = png_get_error_ptr(png);
    d->why = arena_string(d->file->session->arena, message, strlen(message));
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp message)
{
    (void)png, (void)message; /* libpng has already handled what it warns about */
}

static void on_read(png_structp png, png_bytep to, size_t size)
{
    PngReader *d = png_get_io_ptr(png);
    if ((size_t)(d->file->end - d->file->at) < size)
        png_error(png, image_file_cut);
    memcpy(to, d->file->at, size);
    d->file->at += size;
}

static bool is_little_endian(void)
{
    const uint16_t one = 1;
    return *(const uint8_t *)&one == 1;
}

/* Converts rows of any PNG format to RGBA: palettes, 1 to 16 bits, a transparent color. */
static void convert_to_rgba(PngReader *d)
{
    png_set_expand(d->png);
    if (is_little_endian())
        png_set_swap(d->png); /* PNG stores words in big-endian order */
    png_set_gray_to_rgb(d->png);
    png_set_add_alpha(d->png, 0xFFFF, PNG_FILLER_AFTER);
    png_set_interlace_handling(d->png);
    png_read_update_info(d->png, d->info);
}

/* Rejects a file that is too short for its header before allocating memory: the data must be
 * able to hold all rows. */
static void check_size(PngReader *d, size_t row_bytes)
{
    if (row_bytes * (size_t)d->file->image->height / MAX_DEFLATED >
        (size_t)(d->file->end - d->file->at))
        png_error(d->png, image_file_cut);
}

static void allocate(PngReader *d)
{
    Image *image = d->file->image;
    const size_t height = (size_t)image->height, stride = image_file_size(image) / height;
    const char *why = image_file_allocate(d->file);
    if (why)
        png_error(d->png, why);
    if (png_get_rowbytes(d->png, d->info) != stride)
        png_error(d->png, "unknown kind of pixels");
    uint8_t *texels = image->texels;
    d->rows = arena_alloc(&d->file->memory, height * sizeof *d->rows);
    for (size_t row = 0; row < height; row++)
        d->rows[row] = texels + stride * (height - 1 - row);
}

static void read_header(PngReader *d)
{
    /* Ancillary chunks are not read; in particular no color profile is inflated. */
    png_set_keep_unknown_chunks(d->png, PNG_HANDLE_CHUNK_NEVER, NULL, -1);
    png_read_info(d->png, d->info);
    Image *image = d->file->image;
    const png_uint_32 width = png_get_image_width(d->png, d->info),
                      height = png_get_image_height(d->png, d->info);
    const char *why = image_file_check_side(width, height);
    if (why)
        png_error(d->png, why);
    *image = (Image){
        .path = image->path, .index = image->index, .width = (int)width, .height = (int)height};
    image->bits = png_get_bit_depth(d->png, d->info) == 16 ? 16 : 8;
    image->opaque = !(png_get_color_type(d->png, d->info) & PNG_COLOR_MASK_ALPHA) &&
                    !png_get_valid(d->png, d->info, PNG_INFO_tRNS);
}

/* Decodes the first row separately. An interlaced image has no such row: each pass writes to all
 * rows. */
static void read_first_row(PngReader *d)
{
    if (png_get_interlace_type(d->png, d->info) != PNG_INTERLACE_NONE)
        return;
    d->first = arena_alloc(&d->file->memory, png_get_rowbytes(d->png, d->info));
    png_read_row(d->png, d->first, NULL);
}

static void read_rows(PngReader *d)
{
    if (!d->first) {
        png_read_image(d->png, d->rows);
        return;
    }
    memcpy(d->rows[0], d->first, png_get_rowbytes(d->png, d->info));
    png_read_rows(d->png, d->rows + 1, NULL, (png_uint_32)d->file->image->height - 1);
}

/* No local variables: longjmp could clobber them. */
static void read_picture(PngReader *d)
{
    if (setjmp(png_jmpbuf(d->png)))
        return;
    read_header(d);
    if (!d->file->session->options->pixels)
        return;
    check_size(d, png_get_rowbytes(d->png, d->info));
    convert_to_rgba(d);
    read_first_row(d);
    allocate(d);
    read_rows(d);
}

const char *image_png(ImageFile *file)
{
    PngReader reader = {.file = file}, *d = &reader;
    d->png = png_create_read_struct(PNG_LIBPNG_VER_STRING, d, on_error, on_warning);
    d->info = d->png ? png_create_info_struct(d->png) : NULL;
    if (!d->info)
        memory_exhausted();
    png_set_read_fn(d->png, d, on_read);
    read_picture(d);
    png_destroy_read_struct(&d->png, &d->info, NULL);
    return d->why;
}
