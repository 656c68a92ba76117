/* A picture as a PNG or OpenEXR file, row by row: no more of it is in memory than some rows. It is
 * made in a temporary file without a name (in TMPDIR, else where tmpfile() puts it); its bytes come
 * to their place at the end, whole or not at all (output.h). */
#ifndef MATC_VIEW_PICTURE_FILE_H
#define MATC_VIEW_PICTURE_FILE_H
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef enum { PICTURE_FORMAT_png, PICTURE_FORMAT_exr } PictureFormat;

typedef struct {
    PictureFormat format;
    int width, height;
    int lanes;  /* 1, 3 or 4: grey, RGB, and with alpha; OpenEXR: Y, R G B, R G B A */
    int bits;   /* of a lane. PNG: 8 or 16, 0 to 1; OpenEXR: 16 or 32, a half or a float */
    bool color; /* the lanes are sRGB's; else numbers. A PNG says so */
} PictureSpec;

/* Format of a file by the ending of its name; a name without an ending leaves format unchanged.
 * False: an unknown ending. */
bool picture_file_ending(const char *path, PictureFormat *format);

typedef struct PictureFile PictureFile;

/* NULL: *why. */
PictureFile *picture_file_open(const PictureSpec *spec, const char **why);
/* The next row, from the top one on: `lanes` of every four floats. NULL, or why not. */
const char *picture_file_row(PictureFile *file, const float *rgba);
/* Writes what is whole by now to a path, as output_write does. NULL, or why not. */
const char *picture_file_finish(PictureFile *file, const char *path);
/* NULL is nothing. */
void picture_file_close(PictureFile *file);

/* The parts of a format: picture_png.c, picture_exr.c. `state` is theirs. */
typedef struct {
    void *(*open)(const PictureSpec *spec, FILE *out, const char **why);
    const char *(*row)(void *state, const float *rgba);
    const char *(*finish)(void *state);
    void (*close)(void *state);
} PictureWriter;
extern const PictureWriter picture_png, picture_exr;
#endif
