/* Reads application-specific attributes such as `_WETNESS`. Files are untrusted: every index,
 * count and length is checked against the available data. */
#include "runtime/mesh_import/model_attributes.h"
#include "compiler/base/root.h"
#include "compiler/read/gltf_file.h"
#include "runtime/gl/message.h"
#include "runtime/mesh_import/model.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Component types of glTF 2.0, section 3.6.2.2. */
typedef enum {
    BYTE = 5120,
    UNSIGNED_BYTE,
    SHORT,
    UNSIGNED_SHORT,
    UNSIGNED_INT = 5125,
    FLOAT
} Component;
enum { COMPONENTS = 4, MAX_STRIDE = 252, PLACE = 96 };

typedef struct {
    GltfPlace place;
    const Tree *root;
    ModelAttributes *made;
    size_t vertices; /* number of vertices of all primitives with such attributes */
    char *error;
    size_t capacity;
    char where[PLACE]; /* path of the primitive for messages, such as "meshes/0/primitives/1" */
} Reader;

/* A validated accessor. */
typedef struct {
    const unsigned char *at; /* NULL: all values are 0 */
    size_t stride;
    int components;
    Component component;
    bool normalized;
    /* Sparse substitution of some vertices' values (section 3.6.2.3). NULL: none. */
    const Tree *sparse;
} Accessor;

static bool fail(const Reader *r, const char *name, const char *why)
{
    return message_fail(r->error, r->capacity, "%s/attributes/%.*s: %s", r->where, SHAPE_NAME, name,
                        why);
}

static bool is_text(const Tree *tree, const char *text)
{
    return tree && tree->kind == TREE_scalar && !strcmp(tree->text, text);
}

static int components_of(const Tree *type)
{
    static const char *const types[COMPONENTS] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    int i = 0;
    while (i < COMPONENTS && !is_text(type, types[i]))
        i++;
    return i < COMPONENTS ? i + 1 : 0;
}

static size_t bytes_of(size_t component)
{
    return component == BYTE || component == UNSIGNED_BYTE     ? 1
           : component == SHORT || component == UNSIGNED_SHORT ? 2
           : component == UNSIGNED_INT || component == FLOAT   ? 4
                                                               : 0;
}

/* Locates the accessor's values in its bufferView. Returns NULL, or an error message. */
static const char *find_bytes(const Reader *r, const Tree *accessor, size_t count, Accessor *made)
{
    GltfBytes bytes;
    const char *why;
    const Tree *index = gltf_file_value(accessor, "bufferView");
    const size_t size = bytes_of(made->component) * (size_t)made->components;
    if (!index)
        return NULL;
    if (!gltf_file_view(&r->place, index, &bytes, &why))
        return why;
    const Tree *view = gltf_file_item(r->root, "bufferViews", gltf_file_whole(index, SIZE_MAX));
    const size_t offset = gltf_file_whole(gltf_file_value(accessor, "byteOffset"), 0);
    made->stride = gltf_file_whole(gltf_file_value(view, "byteStride"), size);
    if (made->stride < size || made->stride > MAX_STRIDE)
        return "its bufferView's byteStride is less than a value, or more than 252";
    if (offset > bytes.size || (count - 1) * made->stride + size > bytes.size - offset)
        return "its accessor exceeds its bufferView";
    made->at = (const unsigned char *)bytes.at + offset;
    return NULL;
}

static const char *find_accessor(const Reader *r, const Tree *index, size_t count, Accessor *made)
{
    const Tree *accessor = gltf_file_item(r->root, "accessors", gltf_file_whole(index, SIZE_MAX));
    const size_t component = gltf_file_whole(gltf_file_value(accessor, "componentType"), 0);
    if (!accessor)
        return "its accessor is not there";
    *made = (Accessor){.components = components_of(gltf_file_value(accessor, "type")),
                       .component = (Component)component,
                       .sparse = gltf_file_value(accessor, "sparse")};
    made->normalized = is_text(gltf_file_value(accessor, "normalized"), "true");
    if (!made->components)
        return "its accessor's type is not SCALAR, VEC2, VEC3 or VEC4";
    /* unsigned ints are not allowed for attributes */
    if (!bytes_of(component) || component == UNSIGNED_INT)
        return "its accessor's componentType is not byte, short or float (5120 to 5123, 5126)";
    if (gltf_file_whole(gltf_file_value(accessor, "count"), 0) != count)
        return "its accessor has another count than that of POSITION";
    return find_bytes(r, accessor, count, made);
}

/* Reads one component, little endian. A normalized signed integer is clamped to -1, so the two
 * least values both give -1. */
static float number_at(const Accessor *a, const unsigned char *at)
{
    const unsigned word =
        a->component == SHORT || a->component == UNSIGNED_SHORT ? at[0] | (unsigned)at[1] << 8 : 0;
    const float by = a->normalized ? 1 : 0;
    float value;
    switch (a->component) {
    case BYTE:
        value = (float)(at[0] ^ 0x80) - 0x80;
        return by ? fmaxf(value / INT8_MAX, -1) : value;
    case UNSIGNED_BYTE:
        return by ? (float)at[0] / UINT8_MAX : at[0];
    case SHORT:
        value = (float)(word ^ 0x8000) - 0x8000;
        return by ? fmaxf(value / INT16_MAX, -1) : value;
    case UNSIGNED_SHORT:
        return by ? (float)word / UINT16_MAX : (float)word;
    default:
        memcpy(&value, at, sizeof value);
        return value;
    }
}

static void put_numbers(const Accessor *a, size_t count, float (*to)[COMPONENTS])
{
    const size_t size = bytes_of(a->component);
    for (size_t i = 0; i < count; i++) {
        to[i][COMPONENTS - 1] = 1;
        for (int component = 0; component < a->components; component++)
            to[i][component] =
                a->at ? number_at(a, a->at + i * a->stride + (size_t)component * size) : 0;
    }
}

/* Returns `size` tightly packed bytes of a sparse accessor's indices or values; NULL with the
 * reason in *why. */
static const unsigned char *sparse_bytes(const Reader *r, const Tree *part, size_t size,
                                         const char **why)
{
    GltfBytes bytes;
    const size_t offset = gltf_file_whole(gltf_file_value(part, "byteOffset"), 0);
    if (!gltf_file_view(&r->place, gltf_file_value(part, "bufferView"), &bytes, why))
        return NULL;
    *why = "its sparse values exceed their bufferView";
    return offset > bytes.size || size > bytes.size - offset
               ? NULL
               : (const unsigned char *)bytes.at + offset;
}

/* Overwrites the values of the vertices listed in a sparse accessor. Returns NULL, or an error
 * message. */
static const char *put_sparse(const Reader *r, const Accessor *a, size_t vertices,
                              float (*to)[COMPONENTS])
{
    const Tree *indices = gltf_file_value(a->sparse, "indices");
    const size_t count = gltf_file_whole(gltf_file_value(a->sparse, "count"), 0);
    const size_t component = gltf_file_whole(gltf_file_value(indices, "componentType"), 0),
                 wide = bytes_of(component);
    const char *why = NULL;
    if (!count || count > vertices)
        return "its accessor has more sparse values than vertices, or none";
    if (component != UNSIGNED_BYTE && component != UNSIGNED_SHORT && component != UNSIGNED_INT)
        return "its sparse indices' componentType is not 5121, 5123 or 5125";
    const unsigned char *number = sparse_bytes(r, indices, count * wide, &why);
    Accessor values = *a;
    values.stride = bytes_of(a->component) * (size_t)a->components;
    values.at =
        number ? sparse_bytes(r, gltf_file_value(a->sparse, "values"), count * values.stride, &why)
               : NULL;
    if (!values.at)
        return why;
    for (size_t i = 0; i < count; i++, number += wide, values.at += values.stride) {
        uint32_t vertex = 0;
        for (size_t byte = 0; byte < wide; byte++)
            vertex |= (uint32_t)number[byte] << 8 * byte;
        if (vertex >= vertices)
            return "its sparse indices exceed its vertices";
        put_numbers(&values, 1, &to[vertex]);
    }
    return NULL;
}

/* Returns the index of an attribute's name, where "_WETNESS" is "wetness"; SHAPE_NAMED: no free
 * index. */
static int place_of(Reader *r, const char *key)
{
    char name[SHAPE_NAME] = "";
    for (size_t i = 0; i + 1 < SHAPE_NAME && key[i + 1]; i++)
        name[i] =
            (char)(key[i + 1] >= 'A' && key[i + 1] <= 'Z' ? key[i + 1] - 'A' + 'a' : key[i + 1]);
    int i = 0;
    while (i < SHAPE_NAMED && r->made->names[i][0] && strcmp(r->made->names[i], name) != 0)
        i++;
    if (i < SHAPE_NAMED)
        memcpy(r->made->names[i], name, sizeof name);
    return i;
}

static bool read_one(Reader *r, const Member *member, ModelPrimitive *primitive)
{
    Accessor accessor;
    const int place = place_of(r, member->key);
    if (place == SHAPE_NAMED)
        return true;
    if (primitive->values[place])
        return fail(r, member->key, "two names that differ in capitals alone");
    const char *why = find_accessor(r, member->value, primitive->vertex_count, &accessor);
    if (why)
        return fail(r, member->key, why);
    primitive->values[place] =
        arena_alloc(r->place.session->arena, primitive->vertex_count * sizeof(float[COMPONENTS]));
    put_numbers(&accessor, primitive->vertex_count, primitive->values[place]);
    why = accessor.sparse
              ? put_sparse(r, &accessor, primitive->vertex_count, primitive->values[place])
              : NULL;
    return !why || fail(r, member->key, why);
}

/* Returns whether an attribute is application-specific and short enough for a formula. */
static bool is_own(const Member *member)
{
    return member->key[0] == '_' && member->key[1] && member->size < SHAPE_NAME;
}

/* Starts a primitive: checks that a set of texture coordinates is free for vertex numbers, and
 * reads the vertex count. */
static bool begin(Reader *r, const Tree *attributes, const char *name, ModelPrimitive *primitive)
{
    static const char *const sets[MODEL_COORDINATES] = {"TEXCOORD_0", "TEXCOORD_1", "TEXCOORD_2",
                                                        "TEXCOORD_3", "TEXCOORD_4", "TEXCOORD_5",
                                                        "TEXCOORD_6", "TEXCOORD_7"};
    int count = 0;
    while (count < MODEL_COORDINATES && tree_find(attributes, sets[count]))
        count++;
    if (count == MODEL_COORDINATES)
        return fail(r, name, "all eight sets of texture coordinates are in use");
    const Tree *position = gltf_file_item(
        r->root, "accessors", gltf_file_whole(gltf_file_value(attributes, "POSITION"), SIZE_MAX));
    primitive->vertex_count = gltf_file_whole(gltf_file_value(position, "count"), 0);
    if (!primitive->vertex_count)
        return fail(r, name, "its primitive has no POSITION");
    if (primitive->vertex_count > MODEL_VERTICES ||
        (r->vertices += primitive->vertex_count) > MODEL_VERTICES)
        return fail(r, name, "more vertices than are drawn");
    return true;
}

static bool read_primitive(Reader *r, const Tree *attributes)
{
    ModelPrimitive primitive = {0};
    const uint32_t count = attributes && attributes->kind == TREE_object ? attributes->count : 0;
    for (uint32_t i = 0; i < count; i++) {
        const Member *member = &attributes->members[i];
        if (is_own(member) &&
            ((!primitive.vertex_count && !begin(r, attributes, member->key, &primitive)) ||
             !read_one(r, member, &primitive)))
            return false;
    }
    ARENA_PUSH(r->place.session->arena, r->made->primitives, r->made->count, r->made->capacity,
               primitive);
    return true;
}

static bool read_meshes(Reader *r)
{
    const Tree *mesh;
    for (size_t m = 0; (mesh = gltf_file_item(r->root, "meshes", m)); m++) {
        const Tree *primitive;
        for (size_t p = 0; (primitive = gltf_file_item(mesh, "primitives", p)); p++) {
            snprintf(r->where, sizeof r->where, "meshes/%zu/primitives/%zu", m, p);
            if (!read_primitive(r, gltf_file_value(primitive, "attributes")))
                return false;
        }
    }
    return true;
}

/* Reads a file of at most MODEL_FILE_MIB below the root folder `user`. */
static char *read_file(void *user, const char *path, size_t *size, const char **why)
{
    struct stat info;
    const int descriptor = root_open(user, path, why);
    FILE *file =
        descriptor >= 0 && !fstat(descriptor, &info) && info.st_size <= (off_t)MODEL_FILE_MIB << 20
            ? fdopen(descriptor, "rb")
            : NULL;
    char *text = file ? malloc((size_t)info.st_size + 1) : NULL;
    *why = "the file does not exist or is too large";
    if (text) {
        *size = fread(text, 1, (size_t)info.st_size, file);
        text[*size] = 0;
    }
    if (file)
        fclose(file);
    else if (descriptor >= 0)
        close(descriptor);
    return text;
}

/* Searches the raw bytes for `"_`, to avoid parsing long JSON texts without such attributes. */
static bool may_have(const ModelSource *source)
{
    size_t size = 0, at = 0;
    const char *why;
    char *text = read_file((void *)source->root, source->path, &size, &why);
    while (text && at + 1 < size && (text[at] != '"' || text[at + 1] != '_'))
        at++;
    free(text);
    return at + 1 < size;
}

bool model_attributes_read(Arena *arena, const ModelSource *source, ModelAttributes *made,
                           char *error, size_t capacity)
{
    GltfFiles files = {0};
    MatcOptions options;
    const char *path = source->path, *dot = strrchr(path, '.'), *why;
    *made = (ModelAttributes){0};
    if (!dot || (strcmp(dot, ".gltf") != 0 && strcmp(dot, ".glb") != 0) || !may_have(source))
        return true;
    matc_options_init(&options);
    options.read_file = read_file;
    options.user = (void *)source->root;
    Session session = session_open(&options, arena);
    Reader r = {
        .place = {&session, &files, path}, .made = made, .error = error, .capacity = capacity};
    r.root = gltf_file_root(&r.place, &why);
    if (!r.root)
        return message_fail(error, capacity, "%s",
                            session.diags.count ? session.diags.at[0].message : why);
    return read_meshes(&r);
}
