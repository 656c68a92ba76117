#include "runtime/mesh_import/gltf_accessor.h"
#include "runtime/gl/message.h"
#include "runtime/mesh_import/gltf_meshopt.h"
#include <math.h>
#include <string.h>

enum { MAX_STRIDE = 252 };

static const char too_many[] = "its accessors have more numbers than are read";

bool gltf_fail(const GltfMesh *mesh, const char *part, const char *why)
{
    return message_fail(mesh->error, mesh->capacity, "%s%s: %s", mesh->where, part, why);
}

static bool is_text(const Tree *tree, const char *text)
{
    return tree && tree->kind == TREE_scalar && !strcmp(tree->text, text);
}

static int components_of(const Tree *type)
{
    static const struct {
        const char *name;
        int components;
    } types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", GLTF_MATRIX}};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (is_text(type, types[i].name))
            return types[i].components;
    return 0;
}

static size_t bytes_of(size_t component)
{
    return component == GLTF_BYTE || component == GLTF_UNSIGNED_BYTE     ? 1
           : component == GLTF_SHORT || component == GLTF_UNSIGNED_SHORT ? 2
           : component == GLTF_UNSIGNED_INT || component == GLTF_FLOAT   ? 4
                                                                         : 0;
}

static size_t row_bytes(const GltfAccessor *a)
{
    return bytes_of(a->component) * (size_t)a->components;
}

/* Locates the accessor's values in its bufferView. Returns NULL, or an error message. */
static const char *find_bytes(GltfMesh *mesh, const Tree *accessor, GltfAccessor *made)
{
    GltfBytes bytes;
    const char *why;
    const Tree *index = gltf_file_value(accessor, "bufferView");
    const size_t size = row_bytes(made);
    if (!index)
        return NULL;
    if (!gltf_meshopt_view(mesh, index, &bytes, &why))
        return why;
    const Tree *view = gltf_file_item(mesh->root, "bufferViews", gltf_file_whole(index, SIZE_MAX));
    const size_t offset = gltf_file_whole(gltf_file_value(accessor, "byteOffset"), 0);
    made->stride = gltf_file_whole(gltf_file_value(view, "byteStride"), size);
    if (made->stride < size || (made->stride > MAX_STRIDE && made->stride != size))
        return "its bufferView's byteStride is less than a value, or more than 252";
    if (offset > bytes.size || size > bytes.size - offset ||
        made->count - 1 > (bytes.size - offset - size) / made->stride)
        return "its accessor exceeds its bufferView";
    made->at = (const unsigned char *)bytes.at + offset;
    return NULL;
}

/* Returns `size` tightly packed bytes of a sparse accessor's indices or values; NULL with the
 * reason in *why. */
static const unsigned char *sparse_bytes(GltfMesh *mesh, const Tree *part, size_t size,
                                         const char **why)
{
    GltfBytes bytes;
    const size_t offset = gltf_file_whole(gltf_file_value(part, "byteOffset"), 0);
    if (!gltf_meshopt_view(mesh, gltf_file_value(part, "bufferView"), &bytes, why))
        return NULL;
    *why = "its sparse values exceed their bufferView";
    return offset > bytes.size || size > bytes.size - offset
               ? NULL
               : (const unsigned char *)bytes.at + offset;
}

static const char *find_sparse(GltfMesh *mesh, const Tree *sparse, GltfAccessor *made)
{
    const Tree *indices = gltf_file_value(sparse, "indices");
    const size_t component = gltf_file_whole(gltf_file_value(indices, "componentType"), 0);
    const char *why = NULL;
    made->sparse_count = gltf_file_whole(gltf_file_value(sparse, "count"), 0);
    made->sparse_wide = bytes_of(component);
    if (!made->sparse_count || made->sparse_count > made->count)
        return "its accessor has more sparse values than vertices, or none";
    if (component != GLTF_UNSIGNED_BYTE && component != GLTF_UNSIGNED_SHORT &&
        component != GLTF_UNSIGNED_INT)
        return "its sparse indices' componentType is not 5121, 5123 or 5125";
    made->sparse_indices =
        sparse_bytes(mesh, indices, made->sparse_count * made->sparse_wide, &why);
    if (made->sparse_indices)
        made->sparse_values = sparse_bytes(mesh, gltf_file_value(sparse, "values"),
                                           made->sparse_count * row_bytes(made), &why);
    return made->sparse_values ? NULL : why;
}

const char *gltf_accessor_open(GltfMesh *mesh, const Tree *index, GltfAccessor *made)
{
    const Tree *accessor =
        gltf_file_item(mesh->root, "accessors", gltf_file_whole(index, SIZE_MAX));
    const Tree *sparse = gltf_file_value(accessor, "sparse");
    const size_t component = gltf_file_whole(gltf_file_value(accessor, "componentType"), 0);
    *made = (GltfAccessor){.components = components_of(gltf_file_value(accessor, "type")),
                           .component = (GltfComponent)component,
                           .count = gltf_file_whole(gltf_file_value(accessor, "count"), 0)};
    made->normalized = is_text(gltf_file_value(accessor, "normalized"), "true");
    if (!accessor)
        return "its accessor is not there";
    if (!made->components || (made->components == GLTF_MATRIX && component != GLTF_FLOAT))
        return "its accessor's type is not SCALAR, VEC2, VEC3, VEC4 or MAT4 of floats";
    if (!bytes_of(component))
        return "its accessor's componentType is not 5120 to 5123, 5125 or 5126";
    if (!made->count || made->count == SIZE_MAX)
        return "its accessor's count is not a positive number";
    if (gltf_file_whole(gltf_file_value(accessor, "byteOffset"), 0) == SIZE_MAX)
        return "its accessor's byteOffset is not a positive number or 0";
    const char *why = find_bytes(mesh, accessor, made);
    return why || !sparse ? why : find_sparse(mesh, sparse, made);
}

static uint32_t whole_at(const unsigned char *at, size_t bytes)
{
    uint32_t value = 0;
    for (size_t i = 0; i < bytes; i++)
        value |= (uint32_t)at[i] << 8 * i;
    return value;
}

/* Reads one component, little endian. A normalized signed integer is clamped to -1, so the two
 * least values both give -1. */
static float number_at(const GltfAccessor *a, const unsigned char *at)
{
    const unsigned word = bytes_of(a->component) == 2 ? at[0] | (unsigned)at[1] << 8 : 0;
    float value;
    switch (a->component) {
    case GLTF_BYTE:
        value = (float)(at[0] ^ 0x80) - 0x80;
        return a->normalized ? fmaxf(value / INT8_MAX, -1) : value;
    case GLTF_UNSIGNED_BYTE:
        return a->normalized ? (float)at[0] / UINT8_MAX : at[0];
    case GLTF_SHORT:
        value = (float)(word ^ 0x8000) - 0x8000;
        return a->normalized ? fmaxf(value / INT16_MAX, -1) : value;
    case GLTF_UNSIGNED_SHORT:
        return a->normalized ? (float)word / UINT16_MAX : (float)word;
    case GLTF_UNSIGNED_INT:
        return (float)whole_at(at, 4);
    default:
        memcpy(&value, at, sizeof value);
        return value;
    }
}

static void put_row(const GltfAccessor *a, const unsigned char *at, int wide, float *to)
{
    const size_t size = bytes_of(a->component);
    const int given = at ? a->components < wide ? a->components : wide : 0;
    if (a->component == GLTF_FLOAT && given)
        memcpy(to, at, (size_t)given * sizeof *to);
    else
        for (int k = 0; k < given; k++)
            to[k] = number_at(a, at + (size_t)k * size);
    for (int k = given; k < wide; k++)
        to[k] = k == 3 && a->components < 4 ? 1 : 0;
}

/* Overwrites the rows that are listed in a sparse accessor. */
static const char *put_sparse(const GltfAccessor *a, GltfRows rows, int wide, float *to)
{
    for (size_t i = 0; i < a->sparse_count; i++) {
        const uint32_t row = whole_at(a->sparse_indices + i * a->sparse_wide, a->sparse_wide);
        if (row >= a->count)
            return "its sparse indices exceed its vertices";
        const size_t slot = rows.slots ? rows.slots[row] : row + (size_t)1;
        if (slot && slot <= rows.count)
            put_row(a, a->sparse_values + i * row_bytes(a), wide, to + (slot - 1) * (size_t)wide);
    }
    return NULL;
}

const char *gltf_accessor_numbers(GltfMesh *mesh, const GltfAccessor *a, GltfRows rows, int wide,
                                  float *to)
{
    const size_t values = (rows.count + a->sparse_count) * (size_t)wide;
    if (values > MODEL_VALUES - mesh->values)
        return too_many;
    mesh->values += values;
    for (size_t i = 0; i < rows.count; i++) {
        const size_t row = rows.rows ? rows.rows[i] : i;
        put_row(a, a->at ? a->at + row * a->stride : NULL, wide, to + i * (size_t)wide);
    }
    return put_sparse(a, rows, wide, to);
}

/* Overwrites the indices that are listed in a sparse accessor. */
static const char *put_sparse_indices(const GltfAccessor *a, uint32_t *to)
{
    for (size_t i = 0; i < a->sparse_count; i++) {
        const uint32_t row = whole_at(a->sparse_indices + i * a->sparse_wide, a->sparse_wide);
        if (row >= a->count)
            return "its sparse indices exceed its vertices";
        to[row] = whole_at(a->sparse_values + i * row_bytes(a), row_bytes(a));
    }
    return NULL;
}

uint32_t *gltf_accessor_indices(GltfMesh *mesh, const Tree *index, size_t *count, const char **why)
{
    GltfAccessor a;
    if ((*why = gltf_accessor_open(mesh, index, &a)))
        return NULL;
    *why = "its accessor is not a SCALAR of unsigned bytes, shorts or ints";
    if (a.components != 1 ||
        (a.component != GLTF_UNSIGNED_BYTE && a.component != GLTF_UNSIGNED_SHORT &&
         a.component != GLTF_UNSIGNED_INT))
        return NULL;
    *why = too_many;
    if (a.count > MODEL_INDICES || a.count + a.sparse_count > MODEL_VALUES - mesh->values)
        return NULL;
    mesh->values += a.count + a.sparse_count;
    uint32_t *made = arena_alloc(mesh->scratch, a.count * sizeof *made);
    const size_t size = row_bytes(&a);
    for (size_t i = 0; i < a.count; i++)
        made[i] = a.at ? whole_at(a.at + i * a.stride, size) : 0;
    *why = put_sparse_indices(&a, made);
    *count = a.count;
    return *why ? NULL : made;
}
