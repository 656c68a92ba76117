/* Lists the buffer files of a .gltf or .glb, whose URIs are relative to the file. Embedded data,
 * network URIs and errors are ignored: reading the mesh reports errors. URIs are not
 * percent-decoded, to match assimp 5.2. */
#include "compiler/base/file.h"
#include "compiler/base/text.h"
#include "compiler/read/gltf_chunks.h"
#include "runtime/mesh_import/model.h"
#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_PATH = 4096 };

/* Resolves a URI relative to the file `path`. Returns false if the URI names no file. */
static bool file_beside(const char *path, const char *uri, char *to, size_t capacity)
{
    const char *slash = strrchr(path, '/');
    if (!*uri || strchr(uri, ':'))
        return false;
    const int folder = slash && uri[0] != '/' ? (int)(slash - path) + 1 : 0;
    const int size = snprintf(to, capacity, "%.*s%s", folder, path, uri);
    return size > 0 && (size_t)size < capacity;
}

void model_files(const char *path, WatchList *files)
{
    const char *dot = strrchr(path, '.'), *why;
    char file[LONGEST_PATH];
    size_t size = 0;
    const bool binary = dot && text_same(dot, ".glb");
    char *text = dot && (binary || text_same(dot, ".gltf")) ? file_read(path, &size, &why) : NULL;
    Arena arena = {0};
    GltfChunks chunks = {.text = text, .size = size};
    const bool whole = text && (!binary || !gltf_chunks_of(&arena, text, size, &chunks));
    cJSON *json = whole ? cJSON_ParseWithLength(chunks.text, chunks.size) : NULL;
    const cJSON *buffer;
    cJSON_ArrayForEach(buffer, cJSON_GetObjectItem(json, "buffers"))
    {
        const char *uri = cJSON_GetStringValue(cJSON_GetObjectItem(buffer, "uri"));
        if (uri && file_beside(path, uri, file, sizeof file))
            watch_list_add(files, file);
    }
    cJSON_Delete(json);
    arena_free(&arena);
    free(text);
}
