/* PNG files in memory. Row 0 of a picture is its bottom row, as in GL. */
#ifndef MATC_GL_PNG_WRITE_H
#define MATC_GL_PNG_WRITE_H
#include <stddef.h>
#include <stdint.h>

enum { PNG_SIZE_LIMIT = 16384 }; /* max width and height of a picture */

typedef struct {
    int width, height;
    /* 3: RGB, 4: RGBA (straight alpha); a byte per component, rows without padding */
    int components;
    uint8_t *bytes;
} PngPicture;

/* Returns the picture as a PNG file, from malloc. NULL if its size or number of components is
 * invalid, with the reason in *why. */
uint8_t *png_write(const PngPicture *picture, size_t *size, const char **why);
#endif
