#include "runtime/mesh_import/gltf_meshopt.h"
#include <string.h>

/* Returns the extension of a compressed view, and its name; NULL: not compressed. */
static const Tree *extension_of(const Tree *view)
{
    const Tree *extensions = gltf_file_value(view, "extensions");
    const Tree *found = gltf_file_value(extensions, "EXT_meshopt_compression");
    return found ? found : gltf_file_value(extensions, "KHR_meshopt_compression");
}

#ifndef MATC_MESHOPT
static const char *decode(GltfMesh *mesh, const Tree *extension, GltfBytes *made)
{
    (void)mesh, (void)extension, (void)made;
    return "it is compressed by EXT_meshopt_compression, and this matview was built without "
           "meshoptimizer (Debian: libmeshoptimizer-dev)";
}
#else
#include <meshoptimizer.h>

enum { MAX_VERTEX_BYTES = 256 };

typedef struct {
    const unsigned char *from;
    size_t size, count, stride;
} Stream;

static bool is_text(const Tree *tree, const char *text)
{
    return tree && tree->kind == TREE_scalar && !strcmp(tree->text, text);
}

/* Decodes a stream by the extension's `mode`. */
static const char *decode_mode(const Tree *mode, const Stream *s, void *to)
{
    int fault = 0;
    if (is_text(mode, "ATTRIBUTES")) {
        if (s->stride % 4 || s->stride > MAX_VERTEX_BYTES)
            return "its compressed byteStride is not a multiple of 4 up to 256";
        fault = meshopt_decodeVertexBuffer(to, s->count, s->stride, s->from, s->size);
    } else if (is_text(mode, "TRIANGLES") || is_text(mode, "INDICES")) {
        const bool list = is_text(mode, "TRIANGLES");
        if ((s->stride != 2 && s->stride != 4) || (list && s->count % 3))
            return "its compressed indices have no byteStride of 2 or 4, or are no triangles";
        fault = (list ? meshopt_decodeIndexBuffer
                      : meshopt_decodeIndexSequence)(to, s->count, s->stride, s->from, s->size);
    } else
        return "its compression has an unknown mode";
    return fault ? "its compressed data are damaged, or of a newer meshopt version" : NULL;
}

static const char *apply_filter(const Tree *filter, const Stream *s, void *to)
{
    if (!filter || is_text(filter, "NONE"))
        return NULL;
    if (is_text(filter, "OCTAHEDRAL") && (s->stride == 4 || s->stride == 8))
        return meshopt_decodeFilterOct(to, s->count, s->stride), NULL;
    if (is_text(filter, "QUATERNION") && s->stride == 8)
        return meshopt_decodeFilterQuat(to, s->count, s->stride), NULL;
    if (is_text(filter, "EXPONENTIAL") && s->stride % 4 == 0)
        return meshopt_decodeFilterExp(to, s->count, s->stride), NULL;
    return "its compression has an unknown filter, or one that does not fit its byteStride";
}

static const char *decode(GltfMesh *mesh, const Tree *extension, GltfBytes *made)
{
    GltfBytes buffer;
    const char *why;
    const size_t offset = gltf_file_whole(gltf_file_value(extension, "byteOffset"), 0),
                 length = gltf_file_whole(gltf_file_value(extension, "byteLength"), SIZE_MAX);
    Stream s = {.count = gltf_file_whole(gltf_file_value(extension, "count"), 0),
                .stride = gltf_file_whole(gltf_file_value(extension, "byteStride"), 0)};
    if (!gltf_file_buffer(&mesh->place,
                          gltf_file_whole(gltf_file_value(extension, "buffer"), SIZE_MAX), &buffer,
                          &why))
        return why;
    if (offset > buffer.size || length > buffer.size - offset)
        return "its compressed data exceed their buffer";
    if (!s.count || !s.stride || s.count > MODEL_VALUES ||
        s.stride > ((size_t)MODEL_FILE_MIB << 20) / s.count)
        return "its compressed data have no values, or more than are read";
    s.from = (const unsigned char *)buffer.at + offset;
    s.size = length;
    /* The decoder reads and writes whole words. */
    char *to = arena_zero(mesh->arena, s.count * s.stride + MAX_VERTEX_BYTES);
    why = decode_mode(gltf_file_value(extension, "mode"), &s, to);
    if (!why)
        why = apply_filter(gltf_file_value(extension, "filter"), &s, to);
    *made = (GltfBytes){to, s.count * s.stride};
    return why;
}
#endif

bool gltf_meshopt_view(GltfMesh *mesh, const Tree *index, GltfBytes *bytes, const char **why)
{
    const size_t number = gltf_file_whole(index, SIZE_MAX);
    const Tree *view = gltf_file_item(mesh->root, "bufferViews", number);
    const Tree *extension = extension_of(view);
    if (!extension)
        return gltf_file_view(&mesh->place, index, bytes, why);
    if (!mesh->views)
        mesh->views = ARENA_ARRAY(mesh->arena, GltfMeshView,
                                  gltf_file_value(mesh->root, "bufferViews")->count);
    GltfMeshView *made = &mesh->views[number];
    if (!made->decoded && (*why = decode(mesh, extension, &made->bytes)))
        return false;
    made->decoded = true;
    *bytes = made->bytes;
    return true;
}
