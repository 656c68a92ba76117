/* Pictures that documents name: PNG, decoded to RGBA with the bottom row first. */
#include "resolve.h"
#include <png.h>
#include <stdlib.h>
#include <string.h>

static const char *decode(Compile *c, const char *file, size_t size, Image *image)
{
    png_image png = {.version = PNG_IMAGE_VERSION};
    if (!png_image_begin_read_from_memory(&png, file, size))
        return arena_string(c->arena, png.message, strlen(png.message));
    const char *why = NULL;
    image->opaque = !(png.format & PNG_FORMAT_FLAG_ALPHA);
    png.format = PNG_FORMAT_RGBA;
    png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB; /* 16-bit files keep their numbers: no gamma conversion */
    image->width = (int)png.width;
    image->height = (int)png.height;
    if (png.width > LIMIT_IMAGE_SIDE || png.height > LIMIT_IMAGE_SIDE) {
        why = "it is too large";
    } else if (c->options->pixels) {
        uint8_t *bytes = arena_alloc(c->arena, PNG_IMAGE_SIZE(png));
        /* a negative stride stores the rows bottom up */
        if (png_image_finish_read(&png, NULL, bytes, -(png_int_32)PNG_IMAGE_ROW_STRIDE(png), NULL))
            image->bytes = bytes;
        else
            why = arena_string(c->arena, png.message, strlen(png.message));
    }
    png_image_free(&png);
    return why;
}

const Image *image_load(Resolver *r, const char *path, Span span)
{
    Compile *c = r->c;
    const char *full = path_beside(c, c->sources[span.file].name, path), *why = "";
    int found = names_find(&r->image_paths, full);
    if (found >= 0)
        return r->images[found];
    size_t size;
    depend_on(c, full);
    char *file = read_file(c, full, &size, &why);
    if (!file)
        return diag_add(c, span, DIAG_no_image, path, why);
    Image *image = ARENA_NEW(c->arena, Image);
    image->path = full;
    image->index = (int)r->image_count;
    why = decode(c, file, size, image);
    free(file);
    if (why)
        return diag_add(c, span, DIAG_no_image, path, why);
    const Image *kept = image;
    ARENA_PUSH(c->arena, r->images, r->image_count, r->image_room, kept);
    names_add(c->arena, &r->image_paths, full);
    return image;
}
