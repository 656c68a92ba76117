#include "compiler/read/gltf_chunks.h"
#include <string.h>

enum {
    HEADER = 12,
    CHUNK = 8,
    CHUNK_JSON = 0x4E4F534A,
    CHUNK_BINARY = 0x004E4942,
    GLB_VERSION = 2
};

static uint32_t word_at(const char *bytes)
{
    const unsigned char *at = (const unsigned char *)bytes;
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

/* A .glb has a header of twelve bytes (`glTF`, version, total length), then chunks. A chunk
 * consists of its length, its type and its bytes: first JSON, then optionally a binary buffer.
 *     67 6C 54 46  02 00 00 00  44 00 00 00 | 30 00 00 00 4A 53 4F 4E {"asset": ...} */
const char *gltf_chunks_of(Arena *arena, const char *bytes, size_t size, GltfChunks *chunks)
{
    *chunks = (GltfChunks){0};
    if (size < HEADER || memcmp(bytes, "glTF", 4) != 0)
        return "it does not start with the glTF magic number";
    Text why = text_new(arena);
    if (word_at(bytes + 4) != GLB_VERSION)
        return text_format(&why, "it has version %u; only version 2 is supported",
                           (unsigned)word_at(bytes + 4)),
               why.at;
    if (word_at(bytes + 8) != size)
        return text_format(&why, "its header says %u bytes, and it has %zu",
                           (unsigned)word_at(bytes + 8), size),
               why.at;
    for (size_t at = HEADER; at < size;) {
        const size_t left = size - at, length = left < CHUNK ? 0 : word_at(bytes + at);
        if (left < CHUNK || length > left - CHUNK)
            return text_format(&why, "the chunk at byte %zu is longer than the file", at), why.at;
        const uint32_t kind = word_at(bytes + at + 4);
        if ((kind == CHUNK_JSON) != (at == HEADER))
            return "its first chunk, and no other, is JSON";
        if (kind == CHUNK_JSON)
            chunks->text = bytes + at + CHUNK, chunks->size = length;
        else if (kind == CHUNK_BINARY && !chunks->binary)
            chunks->binary = bytes + at + CHUNK, chunks->binary_size = length;
        at += CHUNK + length;
    }
    return chunks->text ? NULL : "it has no chunk of JSON";
}

static bool ends_in(const char *name, size_t size, const char *ending)
{
    const size_t end = strlen(ending);
    return size > end && !memcmp(name + size - end, ending, end);
}

bool gltf_chunks_open(Session *session, uint32_t file)
{
    Source *source = &session->sources[file];
    GltfChunks chunks;
    if (!ends_in(source->name, strlen(source->name), ".glb"))
        return true;
    const char *why = gltf_chunks_of(session->arena, source->text, source->size, &chunks);
    if (why) {
        *source = (Source){.name = source->name, .text = ""};
        diag_add(session, (Span){0, 0, file}, DIAG_gltf_binary, why);
        return false;
    }
    *source = (Source){.name = source->name,
                       .text = arena_string(session->arena, chunks.text, chunks.size),
                       .size = chunks.size,
                       .binary = chunks.binary,
                       .binary_size = chunks.binary_size};
    return true;
}

const char *gltf_chunks_picture(Session *session, uint32_t file, const char *number)
{
    const char *name = session->sources[file].name, *slash = strrchr(name, '/');
    Text text = text_new(session->arena);
    text_format(&text, "%s%s%s", slash ? slash + 1 : name, GLTF_IMAGES, number);
    return text.at;
}
