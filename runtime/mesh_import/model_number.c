/* Encodes a glTF file's material indices in the material names. Assimp renumbers materials and
 * reports only their names, which may be missing or ambiguous. Assimp therefore reads a copy of
 * the file with indices as names:
 *
 *     "materials": [{ "name": "Bark" }, {}]              becomes
 *     "materials": [{ "name": "0" }, { "name": "1" }] */
#include "runtime/mesh_import/model_number.h"
#include "compiler/base/memory.h"
#include "compiler/base/names.h"
#include "compiler/base/text.h"
#include "compiler/read/gltf_chunks.h"
#include "runtime/mesh_import/model_attributes.h"
#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- vertices */

/* Assimp welds, copies and drops vertices without reporting their origin. Each primitive with
 * attributes unknown to assimp therefore gets an additional set of texture coordinates, the only
 * set with three components: (vertex, 0, primitive + 1). Assimp treats a set whose third
 * components are all 0 as two-dimensional, so primitives count from 1.
 *
 *     "attributes": { "POSITION": 0, "TEXCOORD_0": 1, "_WETNESS": 2 }     becomes
 *     "attributes": { "POSITION": 0, "TEXCOORD_0": 1, "_WETNESS": 2, "TEXCOORD_1": 3 } */

enum { FLOAT_COMPONENT = 5126 };
static const char data[] = "data:application/octet-stream;base64,";

/* Vertex numbers of all primitives, as one buffer, and the indices of the new glTF objects. */
typedef struct {
    const cJSON **accessors; /* accessors of the original file */
    int accessor_count;
    cJSON *list; /* array of accessors; new ones are appended */
    int view, added;
    float (*numbers)[3];
    size_t count, capacity;
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
    if (n->count + vertices > n->capacity) {
        n->capacity = 2 * n->capacity + vertices;
        n->numbers = realloc(n->numbers, n->capacity * sizeof *n->numbers);
        if (!n->numbers)
            memory_exhausted();
    }
    for (size_t i = 0; i < vertices; i++) {
        float *number = n->numbers[n->count++];
        number[0] = (float)i, number[1] = 0, number[2] = (float)primitive + 1;
    }
}

/* Adds an accessor of vertex numbers, and its entry among the attributes. An invalid primitive
 * stays unchanged. */
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

/* Encodes the numbers as a base64 data URI (RFC 4648), from malloc. A row of 12 bytes gives
 * exactly 16 characters, so padding is unnecessary. */
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

static bool model_number_vertices(cJSON *json)
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

/* Returns the first buffer with the same file and byte length, which may be the buffer itself. */
static int first_alike(Arena *arena, Names *files, const cJSON *buffer, int number)
{
    const cJSON *uri = cJSON_GetObjectItemCaseSensitive(buffer, "uri"),
                *size = cJSON_GetObjectItemCaseSensitive(buffer, "byteLength");
    Text key = text_new(arena);
    if (cJSON_IsString(uri) && cJSON_IsNumber(size)) {
        text_plain(&key, size->valuedouble);
        text_format(&key, " %s", uri->valuestring);
    } else
        text_format(&key, "%d", number);
    return names_add(arena, files, key.at);
}

/* Redirects all views of buffers that share a file to the first of these buffers. Assimp loads a
 * buffer only when a view refers to the buffer, so duplicates are not loaded.
 *     "buffers": [{ "uri": "a.bin" }, { "uri": "a.bin" }], "bufferViews": [{ "buffer": 1 }]
 *         becomes
 *         "bufferViews": [{ "buffer": 0 }] */
static bool join_buffers(cJSON *json)
{
    Arena arena = {0};
    Names files = {0};
    const cJSON *buffers = cJSON_GetObjectItemCaseSensitive(json, "buffers"), *buffer;
    int *first = arena_alloc(&arena, ((size_t)cJSON_GetArraySize(buffers) + 1) * sizeof *first),
        *of_file = arena_alloc(&arena, ((size_t)cJSON_GetArraySize(buffers) + 1) * sizeof *of_file),
        count = 0;
    bool joined = false;
    cJSON_ArrayForEach(buffer, buffers)
    {
        const size_t files_before = files.count;
        const int file = first_alike(&arena, &files, buffer, count);
        if (files.count > files_before)
            of_file[file] = count;
        first[count++] = of_file[file];
    }
    cJSON *view;
    cJSON_ArrayForEach(view, cJSON_GetObjectItemCaseSensitive(json, "bufferViews"))
    {
        cJSON *number = cJSON_GetObjectItemCaseSensitive(view, "buffer");
        if (!cJSON_IsNumber(number) || !(number->valuedouble >= 0 && number->valuedouble < count) ||
            first[(int)number->valuedouble] == (int)number->valuedouble)
            continue;
        cJSON_SetNumberValue(number, first[(int)number->valuedouble]);
        joined = true;
    }
    arena_free(&arena);
    return joined;
}

char *model_number_text(const char *text, size_t size)
{
    char number[16], *made = NULL;
    int count = 0;
    cJSON *json = cJSON_ParseWithLength(text, size), *material;
    cJSON_ArrayForEach(material, cJSON_GetObjectItemCaseSensitive(json, "materials"))
    {
        snprintf(number, sizeof number, "%d", count++);
        if (!cJSON_IsObject(material))
            continue;
        cJSON_DeleteItemFromObjectCaseSensitive(material, "name");
        cJSON_AddStringToObject(material, "name", number);
    }
    const bool vertices = model_number_vertices(json), joined = join_buffers(json);
    if (count || vertices || joined)
        made = cJSON_PrintUnformatted(json);
    cJSON_Delete(json);
    return made;
}

static void put_word(char *to, size_t word)
{
    for (int i = 0; i < 4; i++)
        to[i] = (char)(word >> 8 * i & 0xFF);
}

char *model_number_binary(const char *bytes, size_t size, size_t *made)
{
    enum { HEAD = 20, ROUND = 4 };
    Arena arena = {0};
    GltfChunks chunks;
    char *text = gltf_chunks_of(&arena, bytes, size, &chunks)
                     ? NULL
                     : model_number_text(chunks.text, chunks.size);
    arena_free(&arena);
    if (!text)
        return NULL;
    const char *rest = chunks.text + chunks.size;
    const size_t length = strlen(text), whole = (length + ROUND - 1) / ROUND * ROUND,
                 left = size - (size_t)(rest - bytes);
    char *glb = malloc(HEAD + whole + left);
    if (!glb)
        memory_exhausted();
    *made = HEAD + whole + left;
    memcpy(glb, bytes, HEAD);
    put_word(glb + 8, *made);
    put_word(glb + 12, whole);
    memset(glb + HEAD, ' ', whole);
    memcpy(glb + HEAD, text, length);
    memcpy(glb + HEAD + whole, rest, left);
    free(text);
    return glb;
}

int model_material_number(const char *name)
{
    char *end;
    const long number = strtol(name, &end, 10);
    return end > name && !*end && number >= 0 && number < MODEL_NO_MATERIAL ? (int)number
                                                                            : MODEL_NO_MATERIAL;
}
