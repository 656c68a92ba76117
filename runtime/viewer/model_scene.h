/* The scene of a mesh file without a document: matview helmet.glb. */
#ifndef MATC_VIEWER_MODEL_SCENE_H
#define MATC_VIEWER_MODEL_SCENE_H
#include "compiler/base/text.h"
#include <stdbool.h>

/* Returns true if the name ends as a mesh file's: .obj, .ply, .gltf or .glb. */
bool model_scene_is(const char *path);
/* Writes a scene document with the mesh in its own size, a camera that looks at it from the front
 * right and above and fits its bounding sphere, and the lamps of the preview. A glTF's materials
 * are those of the file; other meshes are gray. The name of the file is relative to the document,
 * which is beside it. Returns false with the reason in *error. */
bool model_scene_write(const char *path, Text *document, char *error, size_t capacity);
#endif
