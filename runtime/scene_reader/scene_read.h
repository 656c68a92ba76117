/* Reads a document with keys of a scene. */
#ifndef MATC_SCENE_READ_H
#define MATC_SCENE_READ_H
#include "runtime/scene/scene.h"

/* Reads a document as matc_read does. If it has keys of a scene, *scene is the scene, or NULL where
 * there are faults; they are among the document's diagnostics. *scene is NULL for a document of
 * materials alone. The scene goes before the document. */
MatcDocument *scene_read(const char *name, const char *text, size_t size,
                         const MatcOptions *options, Scene **scene);
/* NULL is nothing. */
void scene_free(Scene *scene);
#endif
