/* Primitives of glTF meshes: the vertices that their triangles use, before morph targets, skins and
 * node transforms. */
#ifndef MATC_SCENE_GLTF_PRIMITIVE_H
#define MATC_SCENE_GLTF_PRIMITIVE_H
#include "runtime/mesh_import/gltf_accessor.h"
#include "runtime/mesh_import/gltf_draco.h"
#include "runtime/mesh_import/gltf_nodes.h"

/* Vertices have the order of their first use. All arrays are in the scratch arena; an attribute
 * that is missing is NULL. */
typedef struct {
    const Tree *tree, *attributes;
    GltfDraco *draco; /* decoded data; NULL: not compressed */
    int material;
    size_t row_count; /* rows of the accessor POSITION */
    GltfRows rows;    /* used rows, one for each vertex */
    uint32_t *indices;
    size_t index_count; /* three for each triangle; 0: only points or lines */
    float (*positions)[3], (*normals)[3], (*tangents)[4], (*uv)[2];
    float (*extra[SHAPE_EXTRAS])[4];
    GltfTransform *skin; /* by vertex; NULL: the node's transform counts */
} GltfPrimitive;

/* Lists the names of all application-specific attributes, and "uv2" and up for further sets of
 * texture coordinates, while there is space. */
void gltf_primitive_names(const GltfMesh *mesh, ShapeNames names);
/* Reads a primitive; close it in both cases. Returns false with the reason in the mesh's error. */
bool gltf_primitive_read(GltfMesh *mesh, const Tree *tree, GltfPrimitive *made);
void gltf_primitive_close(GltfMesh *mesh, GltfPrimitive *primitive);
/* Reads numbers of an attribute from a list of attributes, `wide` for each vertex, whose accessor
 * has `low` to `high` components. Returns NULL with the reason in the mesh's error. */
typedef struct {
    const Tree *attributes;
    const char *name;
    int low, high, wide;
} GltfAttribute;
float *gltf_primitive_attribute(GltfMesh *mesh, const GltfPrimitive *primitive,
                                const GltfAttribute *attribute);

/* Add the morph targets by their weights, and compute the vertices' transforms by a skin's joints.
 * gltf_pose.c */
bool gltf_pose_morph(GltfMesh *mesh, const Tree *weights, GltfPrimitive *primitive);
bool gltf_pose_skin(GltfMesh *mesh, const GltfNodes *nodes, const Tree *skin,
                    GltfPrimitive *primitive);
/* Appends the primitive's triangles to the mesh's parts, as a run. gltf_emit.c */
bool gltf_emit(GltfMesh *mesh, const GltfPrimitive *primitive, const GltfTransform *world);
#endif
