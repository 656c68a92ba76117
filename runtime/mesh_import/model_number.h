/* Encodes the indices of a glTF file's materials and vertices in data that assimp preserves. */
#ifndef MATC_SCENE_MODEL_NUMBER_H
#define MATC_SCENE_MODEL_NUMBER_H
#include "runtime/mesh_import/model.h"

/* Rewrites the text of a .gltf file: material names become material indices, vertices with
 * application-specific attributes get vertex numbers, and buffers of the same file are merged.
 * Returns a string from malloc; NULL if nothing changes or the text is invalid. */
char *model_number_text(const char *text, size_t size);
/* Rewrites the bytes of a .glb file in the same way; *made is the new size. */
char *model_number_binary(const char *bytes, size_t size, size_t *made);
/* Parses a material name made by model_number_text; MODEL_NO_MATERIAL for any other name. */
int model_material_number(const char *name);
#endif
