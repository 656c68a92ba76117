/* A scene drawn by every method of shadows, or of indirect light, side by side with their names. */
#ifndef MATC_VIEW_COMPARE_H
#define MATC_VIEW_COMPARE_H
#include "runtime/view/scene_picture.h"
#include "runtime/view/sheet.h"

/* Adds a picture for each word of the list: of "shadows", and of hybrid ones for each volume, of all lights that cast some; or of "indirect". The sheet's
 * cells become as large as they are. False: gl->error says why. */
bool compare_methods(GlContext *gl, const Scene *scene, const char *list, const ScenePictureOptions *options,
                     Sheet *sheet);
#endif
