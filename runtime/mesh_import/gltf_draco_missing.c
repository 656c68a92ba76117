/* Stands in for gltf_draco.cpp where the library is missing. */
#include "runtime/mesh_import/gltf_draco.h"
#ifndef MATC_DRACO
GltfDraco *gltf_draco_open(const char *bytes, size_t size, const char **why)
{
    (void)bytes, (void)size;
    *why = "it is compressed by KHR_draco_mesh_compression, and this matview was built without "
           "draco (Debian: libdraco-dev)";
    return NULL;
}

void gltf_draco_close(GltfDraco *draco) { (void)draco; }

size_t gltf_draco_points(const GltfDraco *draco) { return (void)draco, 0; }

size_t gltf_draco_indices(const GltfDraco *draco, uint32_t *to) { return (void)draco, (void)to, 0; }

bool gltf_draco_numbers(const GltfDraco *draco, uint32_t id, int components, bool normalized,
                        float *to)
{
    return (void)draco, (void)id, (void)components, (void)normalized, (void)to, false;
}
#endif
