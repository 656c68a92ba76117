/* PNG files: written by libpng's simple interface, read by its full one, which leaves the numbers alone. */
#include "runtime/gl/png_write.h"
#include "runtime/gl/message.h"
#include <errno.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAME_LIMIT = 4096, NAME_TRIES = 1000 };

/* Opens a new file beside `path`; its name is left in `name`. */
static FILE *open_new(const char *path, char name[NAME_LIMIT], char *error, size_t room)
{
    for (int i = 0; i < NAME_TRIES; i++) {
        int length = snprintf(name, NAME_LIMIT, "%s.%d.tmp", path, i);
        if (length < 0 || length >= NAME_LIMIT)
            return message_fail(error, room, "the path is too long"), NULL;
        FILE *file = fopen(name, "wbx"); /* x: never another writer's */
        if (file)
            return file;
        if (errno != EEXIST)
            break;
    }
    return message_fail(error, room, "%s: %s", path, strerror(errno)), NULL;
}

static bool write_file(FILE *file, const PngPicture *picture, char *error, size_t room)
{
    png_image image = {.version = PNG_IMAGE_VERSION};
    image.width = (png_uint_32)picture->width;
    image.height = (png_uint_32)picture->height;
    image.format = picture->lanes == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    png_int_32 upwards = -picture->width * picture->lanes; /* a negative stride starts at the last row */
    if (!png_image_write_to_stdio(&image, file, 0, picture->bytes, upwards, NULL))
        return message_fail(error, room, "%s", image.message);
    return true;
}

static bool check_picture(const PngPicture *picture, char *error, size_t room)
{
    if (picture->width < 1 || picture->width > PNG_SIZE_LIMIT || picture->height < 1 ||
        picture->height > PNG_SIZE_LIMIT)
        return message_fail(error, room, "a picture is 1 to %d pixels wide and high", PNG_SIZE_LIMIT);
    if (picture->lanes != 3 && picture->lanes != 4)
        return message_fail(error, room, "a picture has 3 or 4 lanes");
    return true;
}

bool png_write(const char *path, const PngPicture *picture, char *error, size_t room)
{
    char name[NAME_LIMIT];
    if (!check_picture(picture, error, room))
        return false;
    FILE *file = open_new(path, name, error, room);
    if (!file)
        return false;
    bool written = write_file(file, picture, error, room);
    bool closed = fclose(file) == 0; /* a full disk is noticed here */
    if (written && closed && rename(name, path) == 0)
        return true;
    if (written)
        message_fail(error, room, "%s: %s", path, strerror(errno));
    remove(name);
    return false;
}

/* All that a reading needs. It outlives the longjmp of libpng's errors, so nothing of it is lost. */
typedef struct {
    FILE *file;
    png_structp png;
    png_infop info;
    png_bytep *rows;
    PngPicture picture;
    char message[256];
} Reader;

static void on_error(png_structp png, png_const_charp message)
{
    Reader *reader = png_get_error_ptr(png);
    snprintf(reader->message, sizeof reader->message, "%s", message);
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp message)
{
    (void)png, (void)message; /* what libpng warns of, it has dealt with */
}

static void convert_to_rgba(Reader *reader)
{
    png_set_expand(reader->png); /* palette, fewer bits, tRNS */
    png_set_scale_16(reader->png);
    png_set_gray_to_rgb(reader->png);
    png_set_add_alpha(reader->png, 0xFF, PNG_FILLER_AFTER);
    png_set_interlace_handling(reader->png);
    png_read_update_info(reader->png, reader->info);
}

static void allocate(Reader *reader)
{
    PngPicture *picture = &reader->picture;
    picture->width = (int)png_get_image_width(reader->png, reader->info);
    picture->height = (int)png_get_image_height(reader->png, reader->info);
    picture->lanes = 4;
    size_t stride = (size_t)picture->width * 4;
    if (png_get_rowbytes(reader->png, reader->info) != stride)
        png_error(reader->png, "unknown kind of pixels");
    picture->bytes = malloc(stride * (size_t)picture->height);
    reader->rows = malloc(sizeof *reader->rows * (size_t)picture->height);
    if (!picture->bytes || !reader->rows)
        png_error(reader->png, "out of memory");
    for (int i = 0; i < picture->height; i++)
        reader->rows[i] = picture->bytes + stride * (size_t)(picture->height - 1 - i);
}

/* No variables here: setjmp may lose them. */
static bool read_pixels(Reader *reader)
{
    if (setjmp(png_jmpbuf(reader->png)))
        return false;
    png_init_io(reader->png, reader->file);
    png_set_user_limits(reader->png, PNG_SIZE_LIMIT, PNG_SIZE_LIMIT);
    png_read_info(reader->png, reader->info);
    convert_to_rgba(reader);
    allocate(reader);
    png_read_image(reader->png, reader->rows);
    return true;
}

static bool session_read_file(Reader *reader)
{
    reader->png = png_create_read_struct(PNG_LIBPNG_VER_STRING, reader, on_error, on_warning);
    if (reader->png)
        reader->info = png_create_info_struct(reader->png);
    if (!reader->info)
        snprintf(reader->message, sizeof reader->message, "out of memory");
    bool done = reader->info && read_pixels(reader);
    png_destroy_read_struct(&reader->png, &reader->info, NULL);
    free(reader->rows);
    if (done)
        return true;
    free(reader->picture.bytes);
    return false;
}

bool png_read(const char *path, PngPicture *picture, char *error, size_t room)
{
    Reader reader = {0};
    *picture = (PngPicture){0};
    reader.file = fopen(path, "rb");
    if (!reader.file)
        return message_fail(error, room, "%s: %s", path, strerror(errno));
    bool done = session_read_file(&reader);
    fclose(reader.file);
    if (!done)
        return message_fail(error, room, "%s: %s", path, reader.message);
    *picture = reader.picture;
    return true;
}
