/* Draws a scene with every method of shadows, indirect light or displacement, side by side with
 * labels. */
#ifndef MATC_VIEWER_COMPARE_H
#define MATC_VIEWER_COMPARE_H
#include "runtime/viewer/scene_picture.h"
#include "runtime/viewer/contact_sheet.h"

/* Adds a picture to the sheet for each method of a list:
 * "shadows": each method and each of its variants, applied to all lights that cast shadows.
 * "indirect": each method of indirect light.
 * "displacement": each method of displacement; the scene's own method is restored afterwards.
 * Meshes get at most one triangle per 8 pixels of a picture. Shadow maps get at most the least
 * power of two that is not below the picture's size.
 * The sheet's cells take the size of the options. options->progress reports the pictures drawn
 * so far and their total. Returns false with the reason in gl->error. */
bool compare_methods(GlContext *gl, Scene *scene, const char *list,
                     const ScenePictureOptions *options, ContactSheet *sheet);
#endif
