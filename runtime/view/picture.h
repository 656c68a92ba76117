/* From a document to a picture: compiles a material by libmatc and draws it. */
#ifndef MATC_VIEW_PICTURE_H
#define MATC_VIEW_PICTURE_H
#include "compiler/matc.h"
#include "runtime/view/view.h"

typedef struct {
    MatcOptions compile; /* of target glsl330; the pass is gbuffer or sky */
    ViewOptions view;
} PictureOptions;

/* Draws a material into rgb, which has 3 bytes a pixel. False: see the program's diagnostics, then `error`, which stays
 * empty when they tell it. The diagnostics, from malloc, are "" when there are none. */
bool picture_draw(const MatcDocument *document, int material, const PictureOptions *options, unsigned char *rgb,
                  char **diagnostics, char *error, size_t room);
#endif
