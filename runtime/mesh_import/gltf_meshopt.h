/* Buffer views of glTF files, decompressed where EXT_meshopt_compression or
 * KHR_meshopt_compression says so. */
#ifndef MATC_SCENE_GLTF_MESHOPT_H
#define MATC_SCENE_GLTF_MESHOPT_H
#include "runtime/mesh_import/gltf_mesh.h"

/* Returns the bytes of the buffer view with the number `index`, which are decompressed once.
 * Returns false and *why on failure. */
bool gltf_meshopt_view(GltfMesh *mesh, const Tree *index, GltfBytes *bytes, const char **why);
#endif
