/* A scene drawn by every method of shadows, side by side with their names. */
#ifndef MATC_VIEW_COMPARE_H
#define MATC_VIEW_COMPARE_H
#include "runtime/view/scene_picture.h"
#include "runtime/view/sheet.h"

/* Adds a picture for each word of the list Shadows, and of hybrid ones for each volume, of all lights that cast some; the sheet's cells become as large as
 * they are. False: gl->error says why. */
bool compare_shadows(GlContext *gl, const Scene *scene, const ScenePictureOptions *options, Sheet *sheet);
#endif
