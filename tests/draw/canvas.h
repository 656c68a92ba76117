/* Draws expressions of matc's library functions over a square, for example a decoding function
 * for every code. */
#ifndef MATC_VALUE_CANVAS_H
#define MATC_VALUE_CANVAS_H
#include "grammar/tables.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/screen.h"
#include "runtime/gl/texture.h"

typedef struct {
    GlContext *gl;
    Screen screen;
    int side;
    Framebuffer floats, halves, words; /* one target of four components each */
    char error[4096];
} Canvas;

/* A drawing: `expression`, a vec4 or, for a target of words, a uvec4, of
 *     uint index    the pixel's number, counted from `first`
 *     vec4 t        the texel of `source` at the pixel; uvec4 w if `source` has words */
typedef struct {
    /* names of library functions, separated by spaces; dependencies are added */
    const char *functions;
    const char *expression;
    unsigned first;
    const Framebuffer *source; /* its target is read; or NULL */
    GLuint texture;            /* float texture that is read if there is no source; or 0 */
} Drawing;

/* The GLSL 3.30 of library functions and their dependencies, dependencies first, with the first
 * choice of every axis except that of `choice`, which may be NULL. Returns false for an unknown
 * function. */
bool canvas_library(const char *functions, const Choice *choice, char *library, size_t capacity);

/* Returns false with a message in `error`. Close it in any case. */
bool canvas_open(Canvas *canvas, int side);
void canvas_close(Canvas *canvas);
bool canvas_draw(Canvas *canvas, const Drawing *drawing, const Framebuffer *target);
/* Seconds of the fastest of `repeats` draws; below 0: see error. */
double canvas_time(Canvas *canvas, const Drawing *drawing, const Framebuffer *target, int repeats);
#endif
