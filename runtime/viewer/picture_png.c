/* Writes PNG files of 8 or 16 bits per component through libpng, which reports errors by
 * longjmp. */
#include "runtime/viewer/picture_file.h"
#include "compiler/base/memory.h"
#include <math.h>
#include <png.h>
#include <setjmp.h>
#include <stdlib.h>

typedef struct {
    PictureSpec spec;
    png_structp png;
    png_infop info;
    png_bytep row;
    const char *why;
} PngWriter;

static void on_error(png_structp png, png_const_charp message)
{
    PngWriter *w = png_get_error_ptr(png);
    w->why = message; /* a static string of libpng */
    longjmp(png_jmpbuf(png), 1);
}

static void on_warning(png_structp png, png_const_charp message) { (void)png, (void)message; }

static void close_png(void *state)
{
    PngWriter *w = state;
    png_destroy_write_struct(&w->png, &w->info);
    free(w->row);
    free(w);
}

static bool write_head(PngWriter *w, FILE *out)
{
    static const int types[] = {
        [1] = PNG_COLOR_TYPE_GRAY, [3] = PNG_COLOR_TYPE_RGB, [4] = PNG_COLOR_TYPE_RGB_ALPHA};
    const PictureSpec *spec = &w->spec;
    if (setjmp(png_jmpbuf(w->png)))
        return false;
    png_init_io(w->png, out);
    png_set_IHDR(w->png, w->info, (png_uint_32)spec->width, (png_uint_32)spec->height, spec->bits,
                 types[spec->components], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (spec->color)
        png_set_sRGB_gAMA_and_cHRM(w->png, w->info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(w->png, w->info);
    return true;
}

static void *open_png(const PictureSpec *spec, FILE *out, const char **why)
{
    PngWriter *w = calloc(1, sizeof *w);
    if (!w)
        memory_exhausted();
    w->spec = *spec;
    w->row = calloc((size_t)spec->width, (size_t)(spec->components * spec->bits / 8));
    w->png = png_create_write_struct(PNG_LIBPNG_VER_STRING, w, on_error, on_warning);
    w->info = w->png ? png_create_info_struct(w->png) : NULL;
    if (!w->row || !w->info)
        memory_exhausted();
    if (write_head(w, out))
        return w;
    *why = w->why;
    close_png(w);
    return NULL;
}

/* Rounds a value in [0, 1] to an integer of 8 or 16 bits; NaN gives 0. */
static unsigned whole_of(float component, int bits)
{
    const double most = bits == 8 ? 255 : 65535;
    return component > 0 ? (unsigned)lrint(most * fmin(component, 1)) : 0;
}

static const char *row_png(void *state, const float *rgba)
{
    PngWriter *w = state;
    const int components = w->spec.components, bits = w->spec.bits;
    for (int i = 0; i < w->spec.width * components; i++) {
        const unsigned whole = whole_of(rgba[i / components * 4 + i % components], bits);
        if (bits == 8)
            w->row[i] = (png_byte)whole;
        else
            png_save_uint_16(w->row + 2 * (size_t)i, whole);
    }
    if (!setjmp(png_jmpbuf(w->png)))
        png_write_row(w->png, w->row);
    return w->why;
}

static const char *finish_png(void *state)
{
    PngWriter *w = state;
    if (!setjmp(png_jmpbuf(w->png)))
        png_write_end(w->png, w->info);
    return w->why;
}

const PictureWriter picture_png = {open_png, row_png, finish_png, close_png};
