/* Nodes of a glTF file: which meshes its scene shows, and where. */
#ifndef MATC_SCENE_GLTF_NODES_H
#define MATC_SCENE_GLTF_NODES_H
#include "runtime/mesh_import/gltf_mesh.h"

/* A transform's upper three rows: the last column is the translation. */
typedef struct {
    double m[3][4];
} GltfTransform;

typedef struct {
    size_t count; /* number of the file's nodes */
    /* Indexed by node. */
    GltfTransform *world;
    size_t *parents; /* SIZE_MAX: none */
    bool *reached;   /* the world transform is known: the node is not part of a cycle */
    /* Visible nodes of the scene that have meshes, in the order of a depth-first walk. */
    size_t *shown, shown_count;
} GltfNodes;

/* Reads all nodes. Returns false with the reason in the mesh's error. */
bool gltf_nodes_read(GltfMesh *mesh, GltfNodes *made);
/* Lists the world transforms of a node's instances (EXT_mesh_gpu_instancing); a node without the
 * extension has one. Returns NULL with the reason in the mesh's error. */
const GltfTransform *gltf_nodes_instances(GltfMesh *mesh, const GltfNodes *nodes, size_t node,
                                          size_t *count);

GltfTransform gltf_transform_product(const GltfTransform *a, const GltfTransform *b);
#endif
