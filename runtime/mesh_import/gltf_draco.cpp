/* The library throws no exceptions of its own, but allocation does. */
#include "runtime/mesh_import/gltf_draco.h"
#include <draco/compression/decode.h>
#include <memory>

struct GltfDraco {
    std::unique_ptr<draco::Mesh> mesh;
};

extern "C" GltfDraco *gltf_draco_open(const char *bytes, size_t size, const char **why)
try {
    draco::DecoderBuffer buffer;
    buffer.Init(bytes, size);
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    *why = "its data compressed by KHR_draco_mesh_compression are damaged";
    return decoded.ok() ? new GltfDraco{std::move(decoded).value()} : nullptr;
} catch (const std::exception &) {
    *why = "its data compressed by KHR_draco_mesh_compression are damaged or too large";
    return nullptr;
}

extern "C" void gltf_draco_close(GltfDraco *draco) { delete draco; }

extern "C" size_t gltf_draco_points(const GltfDraco *draco) { return draco->mesh->num_points(); }

extern "C" size_t gltf_draco_indices(const GltfDraco *draco, uint32_t *to)
{
    const size_t faces = draco->mesh->num_faces();
    for (size_t i = 0; to && i < faces * 3; i++)
        to[i] = draco->mesh->face(draco::FaceIndex((uint32_t)(i / 3)))[i % 3].value();
    return faces * 3;
}

extern "C" bool gltf_draco_numbers(const GltfDraco *draco, uint32_t id, int components,
                                   bool normalized, float *to)
{
    const draco::PointAttribute *attribute = draco->mesh->GetAttributeByUniqueId(id);
    if (!attribute || attribute->num_components() != components)
        return false;
    const float size = attribute->data_type() == draco::DT_UINT8    ? 255.f
                       : attribute->data_type() == draco::DT_UINT16 ? 65535.f
                       : attribute->data_type() == draco::DT_INT8   ? 127.f
                       : attribute->data_type() == draco::DT_INT16  ? 32767.f
                                                                    : 1.f;
    const float by = attribute->normalized() == normalized ? 1.f : normalized ? 1 / size : size;
    for (uint32_t i = 0; i < draco->mesh->num_points(); i++) {
        float *row = to + (size_t)i * (size_t)components;
        const draco::AttributeValueIndex value = attribute->mapped_index(draco::PointIndex(i));
        if (value.value() >= attribute->size() ||
            !attribute->ConvertValue<float>(value, (int8_t)components, row))
            return false;
        for (int k = 0; k < components; k++)
            row[k] *= by;
    }
    return true;
}
