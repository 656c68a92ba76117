/* A glTF's vertices by numbers. Assimp joins, copies and leaves out vertices, and tells of none
 * which it was; so each primitive with attributes that assimp does not know has one more set of
 * texture coordinates, of three numbers, as none has else: (the vertex, 0, the primitive, from 1
 * on: where all of these are 0, assimp takes them for two numbers).
 *     "attributes": { "POSITION": 0, "TEXCOORD_0": 1, "_WETNESS": 2 }     becomes     { "POSITION":
 * 0, "TEXCOORD_0": 1, "_WETNESS": 2, "TEXCOORD_1": 3 } */
#include "runtime/mesh_import/model_attributes.h"
#include "compiler/base/memory.h"
#include "runtime/mesh_import/model_number.h"
#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FLOAT_COMPONENT = 5126 };
static const char data[] = "data:application/octet-stream;base64,";

/* The numbers of all primitives, as a buffer, and what has places in the file's lists. */
typedef struct {
    const cJSON **accessors; /* of the file */
    int accessor_count;
    cJSON *list; /* of them; new ones are put behind */
    int view, added;
    float (*numbers)[3];
    size_t count, room;
} Numbers;

static bool has_own(const cJSON *attributes)
{
    const cJSON *item;
    cJSON_ArrayForEach(item, attributes) if (item->string && item->string[0] == '_' &&
                                             item->string[1]) return true;
    return false;
}

static void put_numbers(Numbers *n, size_t vertices, int primitive)
{
    if (n->count + vertices > n->room) {
        n->room = 2 * n->room + vertices;
        n->numbers = realloc(n->numbers, n->room * sizeof *n->numbers);
        if (!n->numbers)
            memory_exhausted();
    }
    for (size_t i = 0; i < vertices; i++) {
        float *number = n->numbers[n->count++];
        number[0] = (float)i, number[1] = 0, number[2] = (float)primitive + 1;
    }
}

/* A primitive's accessor, and its name among the attributes. What is broken stays as it is. */
static void number_primitive(Numbers *n, cJSON *attributes, int primitive)
{
    char name[16];
    int sets = 0;
    const cJSON *index = cJSON_GetObjectItemCaseSensitive(attributes, "POSITION");
    const double place = cJSON_IsNumber(index) ? index->valuedouble : -1;
    const cJSON *position =
        place >= 0 && place < n->accessor_count ? n->accessors[(int)place] : NULL;
    const cJSON *count = cJSON_GetObjectItemCaseSensitive(position, "count");
    do
        snprintf(name, sizeof name, "TEXCOORD_%d", sets);
    while (cJSON_GetObjectItemCaseSensitive(attributes, name) && ++sets < MODEL_COORDINATES);
    const size_t vertices =
        cJSON_IsNumber(count) && count->valuedouble >= 1 && count->valuedouble <= MODEL_VERTICES
            ? (size_t)count->valuedouble
            : 0;
    if (!vertices || sets == MODEL_COORDINATES || vertices > MODEL_VERTICES - n->count)
        return;
    cJSON *accessor = cJSON_CreateObject();
    cJSON_AddNumberToObject(accessor, "bufferView", n->view);
    cJSON_AddNumberToObject(accessor, "byteOffset", (double)(n->count * sizeof *n->numbers));
    cJSON_AddNumberToObject(accessor, "componentType", FLOAT_COMPONENT);
    cJSON_AddNumberToObject(accessor, "count", (double)vertices);
    cJSON_AddStringToObject(accessor, "type", "VEC3");
    put_numbers(n, vertices, primitive);
    cJSON_AddItemToArray(n->list, accessor);
    cJSON_AddNumberToObject(attributes, name, n->accessor_count + n->added++);
}

/* The numbers as base64 (RFC 4648), from malloc. A row has 12 bytes, which are 16 letters without a
 * rest. */
static char *make_uri(const Numbers *n)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char *from = (const unsigned char *)n->numbers;
    const size_t size = n->count * sizeof *n->numbers;
    char *uri = malloc(sizeof data + size / 3 * 4), *to = uri;
    if (!uri)
        memory_exhausted();
    memcpy(to, data, sizeof data);
    to += sizeof data - 1;
    for (size_t i = 0; i < size; i += 3, to += 4) {
        const unsigned bits = (unsigned)from[i] << 16 | (unsigned)from[i + 1] << 8 | from[i + 2];
        for (int k = 0; k < 4; k++)
            to[k] = digits[bits >> (18 - 6 * k) & 63];
    }
    *to = 0;
    return uri;
}

static void add_buffer(const Numbers *n, cJSON *views, cJSON *buffers)
{
    const double size = (double)(n->count * sizeof *n->numbers);
    cJSON *view = cJSON_CreateObject(), *buffer = cJSON_CreateObject();
    char *uri = make_uri(n);
    cJSON_AddNumberToObject(view, "buffer", cJSON_GetArraySize(buffers));
    cJSON_AddNumberToObject(view, "byteLength", size);
    cJSON_AddItemToArray(views, view);
    cJSON_AddStringToObject(buffer, "uri", uri);
    cJSON_AddNumberToObject(buffer, "byteLength", size);
    cJSON_AddItemToArray(buffers, buffer);
    free(uri);
}

static bool number_meshes(Numbers *n, const cJSON *meshes)
{
    const cJSON *mesh, *primitive, *accessor;
    int count = 0, number = 0;
    cJSON_ArrayForEach(accessor, n->list) n->accessors[count++] = accessor;
    n->accessor_count = count;
    cJSON_ArrayForEach(mesh, meshes)
        cJSON_ArrayForEach(primitive, cJSON_GetObjectItemCaseSensitive(mesh, "primitives"))
    {
        cJSON *attributes = cJSON_GetObjectItemCaseSensitive(primitive, "attributes");
        if (has_own(attributes))
            number_primitive(n, attributes, number);
        number++;
    }
    return n->count > 0;
}

bool model_number_vertices(cJSON *json)
{
    cJSON *views = cJSON_GetObjectItemCaseSensitive(json, "bufferViews"),
          *buffers = cJSON_GetObjectItemCaseSensitive(json, "buffers");
    Numbers n = {.list = cJSON_GetObjectItemCaseSensitive(json, "accessors")};
    if (!cJSON_IsArray(views) || !cJSON_IsArray(buffers) || !cJSON_IsArray(n.list))
        return false;
    n.view = cJSON_GetArraySize(views);
    n.accessors = calloc((size_t)cJSON_GetArraySize(n.list) + 1, sizeof *n.accessors);
    if (!n.accessors)
        memory_exhausted();
    const bool some = number_meshes(&n, cJSON_GetObjectItemCaseSensitive(json, "meshes"));
    if (some)
        add_buffer(&n, views, buffers);
    free(n.accessors);
    free(n.numbers);
    return some;
}
