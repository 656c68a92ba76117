/* A glTF's materials by numbers. Assimp counts materials as it meets them, and tells of each its name alone: names may be missing, or two the same. So
 * it is given the file with the materials' numbers for names.
 *     "materials": [{ "name": "Bark" }, {}]     becomes     "materials": [{ "name": "0" }, { "name": "1" }] */
#include "runtime/scene/model_number.h"
#include "compiler/base/memory.h"
#include "compiler/front/gltf_chunks.h"
#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
    const bool vertices = model_number_vertices(json);
    if (count || vertices)
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
    char *text = gltf_chunks_of(&arena, bytes, size, &chunks) ? NULL : model_number_text(chunks.text, chunks.size);
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
    return end > name && !*end && number >= 0 && number < MODEL_NO_MATERIAL ? (int)number : MODEL_NO_MATERIAL;
}
