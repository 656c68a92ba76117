/* A picture of a material: on a preview shape (G-buffer pass, light pass, filter), or as the sky that it is. */
#ifndef MATC_VIEW_H
#define MATC_VIEW_H
#include "compiler/matc.h"
#include "runtime/gl/context.h"
#include "runtime/render/material.h"
#include "runtime/view/camera.h"

enum {
    VIEW_SIZE_LIMIT = 8192, /* greatest width and height, supersampling counted in */
    VIEW_SUPERSAMPLING_LIMIT = 8
};

typedef struct {
    ShapeKind shape;
    const Shape *mesh;           /* drawn instead of the shape; or NULL */
    const Viewpoint *camera;     /* NULL: where the shape looks best */
    const char *slot;            /* this slot of the G-buffer is shown, and no light; or NULL */
    const MaterialValue *values; /* of uniforms that the program has */
    int value_count;
    int width, height;       /* of the picture */
    int supersampling;       /* n: n x n samples a pixel; 0 is 4 */
    const char *screen_text; /* runtime/view/screen.glsl */
    const char *light_text;  /* runtime/view/light.glsl */
    const char *slot_text;   /* runtime/view/slot.glsl */
    bool sky;                /* the program is one of the pass sky: no shape, no light pass, no unpacking */
    double azimuth;          /* the sky's picture looks there: radians from the x axis */
    GlContext *gl;           /* a core context to draw with; NULL: one of OSMesa for this picture,
                                 after which the thread has no current context */
} ViewOptions;

/* Draws a program of pass gbuffer, with its vertex program and its unpacking, or of pass sky, compiled for GLSL 3.30. Into rgb:
 * 3 bytes a pixel, sRGB, row 0 is the bottom row. False: see `error`, rgb may be half done. */
bool view_render(const ViewOptions *options, MatcProgram *program, unsigned char *rgb, char *error, size_t room);
#endif
