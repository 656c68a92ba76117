/* Geometry of glTF 2.0 files: the state that the stages of the reader share. Files are untrusted:
 * every index, count and length is checked, and work is limited by the counts of model.h.
 *
 *     nodes of the scene -> primitives of their meshes -> accessors of attributes and indices
 *     -> morph targets, skin -> triangles in the axes of the scene */
#ifndef MATC_SCENE_GLTF_MESH_H
#define MATC_SCENE_GLTF_MESH_H
#include "compiler/read/gltf_file.h"
#include "runtime/mesh_import/model_reader.h"

enum { GLTF_MESH_PLACE = 96 };

/* Decompressed bytes of a buffer view. */
typedef struct {
    bool decoded;
    GltfBytes bytes;
} GltfMeshView;

typedef struct {
    GltfPlace place;
    const Tree *root;
    Arena *arena;   /* data of the whole file */
    Arena *scratch; /* data of the primitive that is being read */
    ModelParts *parts;
    int vertex_capacity, index_capacity, run_capacity;
    size_t values;       /* numbers read from accessors: at most MODEL_VALUES */
    GltfMeshView *views; /* indexed by buffer view; NULL: none is compressed */
    /* Per row of the primitive's accessors: 1 + index of the vertex made from it, or 0 if none is.
     * Reset to 0 after each primitive. */
    uint32_t *slots;
    size_t slot_count;
    char where[GLTF_MESH_PLACE]; /* for messages, such as "meshes/0/primitives/1" */
    char *error;
    size_t capacity;
} GltfMesh;

/* Reads the triangles of a .gltf or .glb file's scene. */
bool gltf_mesh_read(const ModelSource *source, ModelParts *parts, char *error, size_t capacity);
#endif
