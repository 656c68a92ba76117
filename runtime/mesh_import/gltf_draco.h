/* Decodes KHR_draco_mesh_compression. */
#ifndef MATC_SCENE_GLTF_DRACO_H
#define MATC_SCENE_GLTF_DRACO_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
typedef struct GltfDraco GltfDraco;

/* Decodes a mesh. Returns NULL with the reason in *why. */
GltfDraco *gltf_draco_open(const char *bytes, size_t size, const char **why);
void gltf_draco_close(GltfDraco *draco); /* NULL is allowed */
size_t gltf_draco_points(const GltfDraco *draco);
/* Number of indices, three for each triangle; writes them unless `to` is NULL. */
size_t gltf_draco_indices(const GltfDraco *draco, uint32_t *to);
/* Writes `components` numbers of every point. Integers are normalized if `normalized` is set.
 * Returns false if there is no such attribute, or one of another number of components. */
bool gltf_draco_numbers(const GltfDraco *draco, uint32_t id, int components, bool normalized,
                        float *to);
#ifdef __cplusplus
}
#endif
#endif
