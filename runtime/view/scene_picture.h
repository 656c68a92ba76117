/* From scenes to pictures: drawn by the renderer, tile by tile, and written row by row. Frames of a
 * motion are one scene whose camera moves: what does not depend on it is made once. */
#ifndef MATC_VIEW_SCENE_PICTURE_H
#define MATC_VIEW_SCENE_PICTURE_H
#include "runtime/render/render.h"
#include "runtime/view/picture_file.h"
#include "runtime/view/slot.h"

typedef struct {
    RenderOptions render;
    const SlotLook *look; /* the view is a slot, which is shown so; NULL: as the view says */
    bool stats, graph;    /* what ran, in words; of the graph alone: instead of a picture */
    PictureFormat
        /* PNG has the picture as it is shown, OpenEXR its linear light, before exposure and tone
         * mapping */
        format;
    int bits; /* of a lane; 0: 8, of OpenEXR 16, and 32 for what is no picture */
    void (*progress)(void *user, int done, int rows); /* or NULL */
    void *user;
} ScenePictureOptions;

typedef struct {
    char *words;        /* that were asked for, from malloc; or NULL */
    const char *faulty; /* the path, where it is the file that could not be written */
} ScenePicture;

typedef struct ScenePictures ScenePictures;

/* Opens; data that the options point to must live until the end. NULL: gl->error says why. */
ScenePictures *scene_pictures_open(GlContext *gl, const ScenePictureOptions *options);
/* The scene that is drawn from now on, and is there until the next one, or the end. False:
 * gl->error says why. */
bool scene_pictures_show(ScenePictures *pictures, const Scene *scene);
/* Warnings of its programs, from malloc. */
char *scene_pictures_diagnostics(const ScenePictures *pictures);
/* A uniform of the scene's first material. False: gl->error says why. */
bool scene_pictures_param(ScenePictures *pictures, const char *uniform, const float *lanes,
                          int count);
/* The camera of the scene that is drawn, `seen`, is another than before. `scene` is the scene that
 * `seen` was copied from, whose objects and lights it shares: where the camera has gone far, both
 * get another origin. False: gl->error says why. */
bool scene_pictures_turn(ScenePictures *pictures, Scene *scene, Scene *seen);
/* False: gl->error says why, and there is no file. */
bool scene_pictures_draw(ScenePictures *pictures, const char *path, ScenePicture *picture);
/* The picture as bytes: three a pixel, row 0 is the bottom row. */
bool scene_pictures_pixels(ScenePictures *pictures, unsigned char *rgb);
/* NULL is nothing. */
void scene_pictures_close(ScenePictures *pictures);
#endif
