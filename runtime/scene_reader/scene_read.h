/* Reads documents that describe a scene. */
#ifndef MATC_SCENE_READ_H
#define MATC_SCENE_READ_H
#include "runtime/scene/scene.h"

/* Reads a document like matc_read(). *scene is the scene of a document with scene keys, or NULL
 * if it has errors, which are among the document's diagnostics. *scene is NULL for a document
 * with only materials. Free the scene before the document. */
MatcDocument *scene_read(const char *name, const char *text, size_t size,
                         const MatcOptions *options, Scene **scene);
/* Frees a scene. Does nothing for NULL. */
void scene_free(Scene *scene);
#endif
