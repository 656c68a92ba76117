/* A scene drawn by every method of shadows, of indirect light, or of displacement, side by side
 * with their names. */
#ifndef MATC_VIEW_COMPARE_H
#define MATC_VIEW_COMPARE_H
#include "runtime/view/scene_picture.h"
#include "runtime/view/sheet.h"

/* Adds a picture for each word of the list: of "shadows", and for each variant of such a technique,
 * of all lights that cast some; of "indirect", or of "displacement", which the scene has again
 * afterwards as it was: a mesh has at most a triangle for 8 pixels of a picture there, and a shadow
 * map's edge at most the power of two that is no less than a picture's. The sheet's cells become as
 * large as they are. The options' progress is told how many are drawn, of how many. False:
 * gl->error says why. */
bool compare_methods(GlContext *gl, Scene *scene, const char *list,
                     const ScenePictureOptions *options, Sheet *sheet);
#endif
