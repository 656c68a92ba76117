/* Pictures as PNG files, by libpng's simple interface. */
#include "runtime/gl/png_write.h"
#include <png.h>
#include <stdio.h>
#include <stdlib.h>

static const char *fault_of(const PngPicture *picture)
{
    if (picture->width < 1 || picture->width > PNG_SIZE_LIMIT || picture->height < 1 ||
        picture->height > PNG_SIZE_LIMIT)
        return "the image has no pixels, or too many";
    return picture->components == 3 || picture->components == 4 ? NULL
                                                                : "an image has 3 or 4 components";
}

uint8_t *png_write(const PngPicture *picture, size_t *size, const char **why)
{
    png_image image = {.version = PNG_IMAGE_VERSION};
    *why = fault_of(picture);
    if (*why)
        return NULL;
    image.width = (png_uint_32)picture->width;
    image.height = (png_uint_32)picture->height;
    image.format = picture->components == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    /* a negative stride starts at the last row */
    png_int_32 upwards = -picture->width * picture->components;
    png_alloc_size_t capacity = PNG_IMAGE_PNG_SIZE_MAX(image);
    uint8_t *file = malloc(capacity);
    if (!file ||
        !png_image_write_to_memory(&image, file, &capacity, 0, picture->bytes, upwards, NULL))
        abort(); /* out of memory: the size is libpng's bound */
    *size = capacity;
    return file;
}
