/* Draws scenes to pictures: rendered tile by tile and written row by row. Frames of a motion
 * share one scene whose camera moves; data that does not depend on the camera is computed once. */
#ifndef MATC_VIEWER_SCENE_PICTURE_H
#define MATC_VIEWER_SCENE_PICTURE_H
#include "runtime/renderer/renderer.h"
#include "runtime/viewer/picture_file.h"
#include "runtime/viewer/slot.h"

typedef struct {
    RendererOptions renderer;
    const SlotLook *look; /* mapping of a slot view to colors; NULL: chosen from the view's name */
    bool stats, graph;    /* report render statistics; report the frame graph instead of drawing */
    /* PNG stores the displayed picture. OpenEXR stores its linear radiance before exposure
     * and tone mapping. */
    PictureFormat format;
    int bits; /* bits per component; 0: 8 for PNG, 16 for OpenEXR pictures, 32 for OpenEXR data */
    void (*progress)(void *user, int done, int rows); /* reports progress; NULL: no reports */
    void *user;
} ScenePictureOptions;

typedef struct {
    char *words;        /* requested statistics or graph, from malloc; NULL: none */
    const char *faulty; /* the path if the file could not be written, else NULL */
} ScenePicture;

typedef struct ScenePictures ScenePictures;

/* Opens a renderer for scenes. Data that the options point to must outlive the result. Returns
 * NULL with the reason in gl->error. */
ScenePictures *scene_pictures_open(GlContext *gl, const ScenePictureOptions *options);
/* Sets the scene that later calls draw. The scene must live until the next scene is set or the
 * pictures are closed. Returns false with the reason in gl->error. */
bool scene_pictures_show(ScenePictures *pictures, const Scene *scene);
/* Returns the compiler warnings of the scene's programs, from malloc. */
char *scene_pictures_diagnostics(const ScenePictures *pictures);
/* Sets a uniform of the scene's first material. Returns false with the reason in gl->error. */
bool scene_pictures_param(ScenePictures *pictures, const char *uniform, const float *components,
                          int count);
/* Updates the renderer after the camera of `seen` moved. `seen` is the drawn copy of `scene` and
 * shares its objects and lights. After a large movement both get a new origin. Returns false
 * with the reason in gl->error. */
bool scene_pictures_turn(ScenePictures *pictures, Scene *scene, Scene *seen);
/* Draws the scene into a file. Returns false with the reason in gl->error; then no file is
 * written. */
bool scene_pictures_draw(ScenePictures *pictures, const char *path, ScenePicture *picture);
/* Draws the scene into `rgb`: three bytes per pixel, bottom row first. Returns false with the
 * reason in gl->error. */
bool scene_pictures_pixels(ScenePictures *pictures, unsigned char *rgb);
/* Closes the pictures; NULL is allowed. */
void scene_pictures_close(ScenePictures *pictures);
#endif
