/* A glTF's materials by numbers. Assimp counts materials as it meets them, and tells of each its
 * name alone: names may be missing, or two the same. So it is given the file with the materials'
 * numbers for names.
 *     "materials": [{ "name": "Bark" }, {}]     becomes     "materials": [{ "name": "0" }, {
 * "name": "1" }] */
#include "runtime/mesh_import/model_number.h"
#include "compiler/base/memory.h"
#include "compiler/base/names.h"
#include "compiler/base/text.h"
#include "compiler/read/gltf_chunks.h"
#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The first buffer that reads as many bytes of the same file; itself, if it is that. */
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

/* Assimp reads a buffer when a view of it is met: views of buffers that are one file are of the
 * first of them.
 *     "buffers": [{ "uri": "a.bin" }, { "uri": "a.bin" }], "bufferViews": [{ "buffer": 1 }] becomes
 * "bufferViews": [{ "buffer": 0 }] */
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
