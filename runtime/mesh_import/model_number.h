/* A glTF's materials and vertices by numbers, which assimp keeps. */
#ifndef MATC_SCENE_MODEL_NUMBER_H
#define MATC_SCENE_MODEL_NUMBER_H
#include "runtime/mesh_import/model.h"

/* The text of a .gltf file in which each material's name is its number, vertices with attributes of
 * the author's have theirs, and buffers of one file are one; from malloc. NULL: it has none of
 * these, or is broken. */
char *model_number_text(const char *text, size_t size);
/* Numbers the bytes of a .glb. */
char *model_number_binary(const char *bytes, size_t size, size_t *made);
/* The number that such a name is; MODEL_NO_MATERIAL: it is none. */
int model_material_number(const char *name);
#endif
