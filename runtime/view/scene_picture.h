/* From a scene to a picture: drawn by the renderer. */
#ifndef MATC_VIEW_SCENE_PICTURE_H
#define MATC_VIEW_SCENE_PICTURE_H
#include "runtime/gl/png_write.h"
#include "runtime/render/render.h"

typedef struct {
    RenderOptions render;
    bool stats, graph; /* what ran, in words */
} ScenePictureOptions;

/* Draws the view into picture->bytes, from malloc: colours as they are shown, others as bytes of 255 times the lane. *words, from malloc or NULL,
 * is what was asked for in words; where only the graph is, there is no picture. False: see gl->error. */
bool scene_picture_draw(GlContext *gl, const Scene *scene, const ScenePictureOptions *options, PngPicture *picture,
                        char **words);
#endif
