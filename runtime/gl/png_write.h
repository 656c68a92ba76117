/* PNG files from and to memory. Row 0 is the bottom row, as in GL, both ways. */
#ifndef MATC_GL_PNG_WRITE_H
#define MATC_GL_PNG_WRITE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { PNG_SIZE_LIMIT = 16384 }; /* greatest width and height, read or written */

typedef struct {
    int width, height;
    int lanes; /* 3: RGB, 4: RGBA (straight alpha); a byte each, rows not padded */
    uint8_t *bytes;
} PngPicture;

/* Writes under a temporary name beside `path` and renames: nobody ever sees half a file. */
bool png_write(const char *path, const PngPicture *picture, char *error, size_t room);

/* Reads any PNG into RGBA, 8 bits: palettes, grey and 16 bits are converted, the numbers of the file are kept as they are
 * (no gamma). free() the bytes. False: see `error`; the picture is empty. */
bool png_read(const char *path, PngPicture *picture, char *error, size_t room);
#endif
