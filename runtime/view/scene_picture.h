/* From a scene to a picture in a file: drawn by the renderer, tile by tile, and written row by row. */
#ifndef MATC_VIEW_SCENE_PICTURE_H
#define MATC_VIEW_SCENE_PICTURE_H
#include "runtime/render/render.h"
#include "runtime/view/picture_file.h"

typedef struct {
    RenderOptions render;
    bool stats, graph; /* what ran, in words; of the graph alone: instead of a picture */
    const char *path;  /* of the file */
    PictureFormat
        format; /* PNG has the picture as it is shown, OpenEXR its linear light, before exposure and tone mapping */
    int bits;   /* of a lane; 0: 8, of OpenEXR 16, and 32 for what is no picture */
    void (*progress)(void *user, int done, int rows); /* or NULL */
    void *user;
} ScenePictureOptions;

typedef struct {
    char *words;        /* that were asked for, from malloc; or NULL */
    const char *faulty; /* the path, where it is the file that could not be written */
} ScenePicture;

/* False: gl->error says why, and there is no file. */
bool scene_picture_draw(GlContext *gl, const Scene *scene, const ScenePictureOptions *options, ScenePicture *picture);
#endif
