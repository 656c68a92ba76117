/* From a document to a picture: compiles a material by libmatc and draws it. */
#ifndef MATC_VIEW_PICTURE_H
#define MATC_VIEW_PICTURE_H
#include "compiler/matc.h"
#include "runtime/view/param.h"
#include "runtime/view/view.h"

typedef struct {
    MatcOptions compile; /* of target glsl330; the pass is gbuffer or sky */
    ViewOptions view;
    const Param *params; /* for uniforms, instead of the document's defaults */
    int param_count;     /* at most PARAM_LIMIT */
} PictureOptions;

typedef struct {
    unsigned char *rgb; /* 3 bytes a pixel; the caller's */
    char *diagnostics;  /* of the program, from malloc; "" when there are none */
    char error[8192];   /* what else went wrong, or "" */
} Picture;

/* Draws a material into picture->rgb. False: see the diagnostics, then the error, which stays empty when they tell it. */
bool picture_draw(MatcDocument *document, int material, const PictureOptions *options, Picture *picture);
#endif
