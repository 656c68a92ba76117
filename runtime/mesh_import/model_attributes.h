/* Attributes of a glTF's meshes that have names of the author's: `"attributes": { "POSITION": 0,
 * "_WETNESS": 1 }` is what a formula calls attribute("wetness", float). Assimp passes them over, so
 * they are read here, and go to its vertices by the number that each has:
 * model_number.c. */
#ifndef MATC_SCENE_MODEL_ATTRIBUTES_H
#define MATC_SCENE_MODEL_ATTRIBUTES_H
#include "compiler/base/arena.h"
#include "runtime/mesh_import/model.h"
#include <stddef.h>

/* Sets of texture coordinates that assimp holds, the numbers of vertices among them. */
enum { MODEL_COORDINATES = 8 };

/* Those of a primitive. */
typedef struct {
    size_t vertex_count;
    float (*values[SHAPE_NAMED])[4]; /* by name, by vertex; NULL: it has none of that name */
} ModelPrimitive;

typedef struct {
    ShapeNames names;
    ModelPrimitive *primitives; /* of all meshes, in the order of the file */
    size_t count, room;
} ModelAttributes;

/* Reads the attributes of a .gltf or .glb; other files have none. Components that an accessor lacks
 * are 0, 0, 0, 1; whole numbers are themselves, or, if `normalized`, as glTF 2.0 states in section
 * 3.6.2.2: a byte of 255 is 1. All lies in the arena. False: error says why. */
bool model_attributes_read(Arena *arena, const ModelSource *source, ModelAttributes *made,
                           char *error, size_t room);
#endif
