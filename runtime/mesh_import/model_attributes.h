/* Application-specific attributes of glTF meshes: `"attributes": { "POSITION": 0, "_WETNESS": 1
 * }` is attribute("wetness", float) in a formula. Assimp ignores such attributes. They are read
 * here and assigned to assimp's vertices by vertex numbers (model_number.c). */
#ifndef MATC_SCENE_MODEL_ATTRIBUTES_H
#define MATC_SCENE_MODEL_ATTRIBUTES_H
#include "compiler/base/arena.h"
#include "runtime/mesh_import/model.h"
#include <stddef.h>

/* Max sets of texture coordinates in assimp, including the set that holds vertex numbers. */
enum { MODEL_COORDINATES = 8 };

/* Attributes of a glTF primitive. */
typedef struct {
    size_t vertex_count;
    /* indexed by name, then by vertex; NULL: the primitive lacks the attribute */
    float (*values[SHAPE_NAMED])[4];
} ModelPrimitive;

typedef struct {
    ShapeNames names;
    ModelPrimitive *primitives; /* primitives of all meshes, in file order */
    size_t count, capacity;
} ModelAttributes;

/* Reads the attributes of a .gltf or .glb file; other files have none. Components missing from
 * an accessor are 0, 0, 0, 1. Integers keep their value, or are normalized as in glTF 2.0,
 * section 3.6.2.2 (a byte of 255 is 1). All data is allocated in the arena. Returns false with
 * the reason in `error`. */
bool model_attributes_read(Arena *arena, const ModelSource *source, ModelAttributes *made,
                           char *error, size_t capacity);
#endif
