/* Pictures that documents name: PNG, decoded to RGBA with the bottom row first. The numbers are the file's: gamma, profiles and all
 * else that says how they are to be shown is passed over. */
#include "compiler/front/resolve.h"
#include <png.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

/* All that decoding needs. It outlives the longjmp of libpng's errors, so nothing of it is lost. */
typedef struct {
    Session *session;
    const char *at, *end; /* what is not read yet */
    size_t room;          /* bytes that pictures may still take */
    png_structp png;
    png_infop info;
    png_bytep *rows;
    Image *image;
    const char *why; /* the fault */
} Decoder;

enum { MOST_DEFLATED = 1032 }; /* bytes that deflate makes of one, at most */

static void on_error(png_structp png, png_const_charp message)
{
    Decoder *d = png_get_error_ptr(png);
    d->why = arena_string(d->session->arena, message, strlen(message));
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp message)
{
    (void)png, (void)message; /* what libpng warns of, it has dealt with */
}

static void on_read(png_structp png, png_bytep to, size_t size)
{
    Decoder *d = png_get_io_ptr(png);
    if ((size_t)(d->end - d->at) < size)
        png_error(png, "it ends too soon");
    memcpy(to, d->at, size);
    d->at += size;
}

/* Rows of 8-bit RGBA, whatever the file has: palettes, 1 to 16 bits, a colour that is transparent. */
static void convert_to_rgba(Decoder *d)
{
    png_set_expand(d->png);
    png_set_scale_16(d->png); /* rounded, by both bytes */
    png_set_gray_to_rgb(d->png);
    png_set_add_alpha(d->png, 0xFF, PNG_FILLER_AFTER);
    png_set_interlace_handling(d->png);
    png_read_update_info(d->png, d->info);
}

/* A header alone takes no memory: what follows must be able to hold the rows that it speaks of. */
static void check_size(Decoder *d, size_t row_bytes)
{
    const size_t height = (size_t)d->image->height, bytes = (size_t)d->image->width * 4 * height;
    if (row_bytes * height / MOST_DEFLATED > (size_t)(d->end - d->at))
        png_error(d->png, "it ends too soon");
    if (bytes > d->room)
        png_error(d->png, "the pictures of a document are too large together");
}

static void allocate(Decoder *d)
{
    const size_t stride = (size_t)d->image->width * 4, height = (size_t)d->image->height;
    if (png_get_rowbytes(d->png, d->info) != stride)
        png_error(d->png, "unknown kind of pixels");
    uint8_t *bytes = arena_alloc(d->session->arena, stride * height);
    d->rows = arena_alloc(d->session->arena, height * sizeof *d->rows);
    for (size_t row = 0; row < height; row++)
        d->rows[row] = bytes + stride * (height - 1 - row);
    d->image->bytes = bytes;
}

static void read_header(Decoder *d)
{
    /* of the chunks that are not needed for the pixels none is read: no profile is inflated */
    png_set_keep_unknown_chunks(d->png, PNG_HANDLE_CHUNK_NEVER, NULL, -1);
    png_read_info(d->png, d->info);
    d->image->width = (int)png_get_image_width(d->png, d->info);
    d->image->height = (int)png_get_image_height(d->png, d->info);
    d->image->opaque =
        !(png_get_color_type(d->png, d->info) & PNG_COLOR_MASK_ALPHA) && !png_get_valid(d->png, d->info, PNG_INFO_tRNS);
    if (d->image->width > LIMIT_IMAGE_SIDE || d->image->height > LIMIT_IMAGE_SIDE)
        png_error(d->png, "it is too large");
}

/* No variables here: setjmp may lose them. */
static void read_picture(Decoder *d)
{
    if (setjmp(png_jmpbuf(d->png)))
        return;
    read_header(d);
    if (!d->session->options->pixels)
        return;
    check_size(d, png_get_rowbytes(d->png, d->info));
    convert_to_rgba(d);
    allocate(d);
    png_read_image(d->png, d->rows);
}

static const char *decode(Decoder *d)
{
    d->png = png_create_read_struct(PNG_LIBPNG_VER_STRING, d, on_error, on_warning);
    d->info = d->png ? png_create_info_struct(d->png) : NULL;
    if (!d->info)
        abort(); /* out of memory */
    png_set_read_fn(d->png, d, on_read);
    read_picture(d);
    png_destroy_read_struct(&d->png, &d->info, NULL);
    return d->why;
}

/* Bytes that the document's pictures take, all decoded. */
static size_t bytes_of_all(const Resolver *r)
{
    size_t bytes = 0;
    for (size_t i = 0; i < r->image_count; i++)
        bytes += (size_t)r->images[i]->width * 4 * (size_t)r->images[i]->height;
    return bytes;
}

const Image *image_load(Resolver *r, const char *path, Span span)
{
    Session *session = r->session;
    const char *full = session_path_beside(session, session->sources[span.file].name, path), *why = "";
    int found = names_find(&r->image_paths, full);
    if (found >= 0)
        return r->images[found];
    size_t size;
    session_depend_on(session, full);
    char *file = session_read_file(session, full, &size, &why);
    if (!file)
        return diag_add(session, span, DIAG_no_image, path, why);
    Image *image = ARENA_NEW(session->arena, Image);
    image->path = full;
    image->index = (int)r->image_count;
    Decoder decoder = {.session = session, .at = file, .end = file + size, .image = image};
    decoder.room = ((size_t)LIMIT_PIXELS_MIB << 20) - bytes_of_all(r);
    why = decode(&decoder);
    free(file);
    if (why)
        return diag_add(session, span, DIAG_no_image, path, why);
    const Image *kept = image;
    ARENA_PUSH(session->arena, r->images, r->image_count, r->image_room, kept);
    names_add(session->arena, &r->image_paths, full);
    return image;
}
