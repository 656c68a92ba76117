/* Writes a picture to a PNG or OpenEXR file row by row, so that only a few rows are in memory.
 * The file is first an unnamed temporary file (in TMPDIR, else in tmpfile()'s folder). At the
 * end its bytes are written to their path as a whole or not at all (output.h). */
#ifndef MATC_VIEWER_PICTURE_FILE_H
#define MATC_VIEWER_PICTURE_FILE_H
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef enum { PICTURE_FORMAT_png, PICTURE_FORMAT_exr } PictureFormat;

typedef struct {
    PictureFormat format;
    int width, height;
    int components; /* 1, 3 or 4 components: gray, RGB, RGBA; OpenEXR channels: Y, R G B, R G B A */
    int bits;       /* bits per component. PNG: 8 or 16, unorm; OpenEXR: 16 (half) or 32 (float) */
    bool color;     /* sRGB colors, which a PNG declares; else plain numbers */
} PictureSpec;

/* Sets the format from a path's extension; a name without extension leaves *format unchanged.
 * Returns false for an unknown extension. */
bool picture_file_ending(const char *path, PictureFormat *format);

typedef struct PictureFile PictureFile;

/* Opens a picture. Returns NULL with the reason in *why. */
PictureFile *picture_file_open(const PictureSpec *spec, const char **why);
/* Writes the next row, top row first. `rgba` has four floats per pixel, of which the first
 * `components` are written. Returns NULL, or an error message. */
const char *picture_file_row(PictureFile *file, const float *rgba);
/* Writes the completed picture to a path with output_write. Returns NULL, or an error message. */
const char *picture_file_finish(PictureFile *file, const char *path);
/* Closes a picture; NULL is allowed. */
void picture_file_close(PictureFile *file);

/* Functions of a format's writer: picture_png.c, picture_exr.c. `state` belongs to the writer. */
typedef struct {
    void *(*open)(const PictureSpec *spec, FILE *out, const char **why);
    const char *(*row)(void *state, const float *rgba);
    const char *(*finish)(void *state);
    void (*close)(void *state);
} PictureWriter;
extern const PictureWriter picture_png, picture_exr;
#endif
