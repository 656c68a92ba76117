/* A glTF's materials by numbers. */
#ifndef MATC_SCENE_MODEL_NUMBER_H
#define MATC_SCENE_MODEL_NUMBER_H
#include "runtime/scene/model.h"

/* The text of a .gltf file in which each material's name is its number; from malloc. NULL: it has no materials, or is broken. */
char *model_number_materials(const char *text, size_t size);
/* The same of the bytes of a .glb. */
char *model_number_binary(const char *bytes, size_t size, size_t *made);
/* The number that such a name is; MODEL_NO_MATERIAL: it is none. */
int model_material_number(const char *name);
#endif
