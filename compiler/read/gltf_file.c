#include "compiler/read/gltf_file.h"
#include "compiler/base/text.h"
#include "compiler/read/read.h"
#include <stdlib.h>
#include <string.h>

enum { MAX_DIGITS = 7 };

typedef struct {
    GltfBytes bytes;
    bool read;
    const char *why; /* reason why the buffer could not be read */
} Buffer;

/* An external file that a .gltf refers to; `why`: the reason why it could not be read. */
struct GltfBeside {
    GltfBytes bytes;
    const char *why;
};

struct GltfFile {
    const Tree *root; /* JSON of the file; NULL: unreadable */
    const char *why;  /* reason why the file is faulty */
    const char *binary;
    size_t binary_size;
    Buffer *buffers; /* indexed by buffer; NULL: no buffer has been requested */
};

static bool ends_in(const char *name, size_t size, const char *ending)
{
    const size_t end = strlen(ending);
    return size > end && !memcmp(name + size - end, ending, end);
}

bool gltf_file_has(const char *path)
{
    const char *mark = strstr(path, GLTF_IMAGES);
    return mark && (ends_in(path, (size_t)(mark - path), ".gltf") ||
                    ends_in(path, (size_t)(mark - path), ".glb"));
}

const Tree *gltf_file_value(const Tree *tree, const char *key)
{
    const Member *member = tree && tree->kind == TREE_object ? tree_find(tree, key) : NULL;
    return member ? member->value : NULL;
}

size_t gltf_file_whole(const Tree *tree, size_t without)
{
    double value;
    if (!tree)
        return without;
    return tree->kind == TREE_scalar && tree->plain && tree_number(tree, &value) && value >= 0 &&
                   value <= UINT32_MAX && value == (double)(size_t)value
               ? (size_t)value
               : SIZE_MAX;
}

const Tree *gltf_file_item(const Tree *root, const char *list, size_t index)
{
    const Tree *items = gltf_file_value(root, list);
    return items && items->kind == TREE_list && index < items->count ? items->items[index] : NULL;
}

static int digit_of(char c)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = c ? strchr(digits, c) : NULL;
    return at ? (int)(at - digits) : -1;
}

/* Decodes a data: URI: "data:image/png;base64,iVBORw0..." (RFC 2397, RFC 4648). */
static bool decode_data(Session *session, const Tree *uri, GltfBytes *bytes, const char **why)
{
    static const char mark[] = ";base64,";
    const char *from = strstr(uri->text, mark), *end = uri->text + uri->count;
    if (!from)
        return *why = "its data: address has no ;base64,", false;
    from += sizeof mark - 1;
    while (end > from && end[-1] == '=')
        end--;
    char *to = arena_alloc(session->arena, (size_t)(end - from) / 4 * 3 + 3);
    *bytes = (GltfBytes){to, 0};
    uint32_t bits = 0;
    for (size_t i = 0; from + i < end; i++) {
        const int digit = digit_of(from[i]);
        if (digit < 0)
            return *why = "its data: address is not base64", false;
        bits = bits << 6 | (uint32_t)digit;
        if (i % 4)
            to[bytes->size++] = (char)(bits >> (6 - 2 * (i % 4)));
    }
    return true;
}

static bool is_data(const Tree *uri) { return !strncmp(uri->text, "data:", 5); }

static GltfBeside read_file_beside(Session *session, const char *path)
{
    GltfBeside beside = {.why = NULL};
    session_depend_on(session, path);
    char *file = session_read_file(session, path, &beside.bytes.size, &beside.why);
    if (!file)
        return beside;
    beside.bytes.at = arena_string(session->arena, file, beside.bytes.size);
    beside.why = NULL;
    free(file);
    return beside;
}

/* Reads an external file once and caches the result, even a failure. `uri` is relative to the
 * glTF file. */
static bool read_beside(const GltfPlace *place, const char *uri, GltfBytes *bytes, const char **why)
{
    Session *session = place->session;
    GltfFiles *files = place->files;
    const char *path = session_path_beside(session, place->path, text_decoded(session->arena, uri));
    const size_t number = (size_t)names_add(session->arena, &files->beside_paths, path);
    if (number == files->beside_count) {
        const GltfBeside beside = read_file_beside(session, path);
        ARENA_PUSH(session->arena, files->beside, files->beside_count, files->beside_capacity,
                   beside);
    }
    *bytes = files->beside[number].bytes;
    *why = files->beside[number].why;
    return bytes->at != NULL;
}

/* Reads a buffer: an external file, a data: URI, or the binary chunk of a .glb. */
static bool read_buffer(const GltfPlace *place, const GltfFile *file, size_t number, Buffer *buffer)
{
    GltfBytes *bytes = &buffer->bytes;
    const char **why = &buffer->why;
    const Tree *uri = gltf_file_value(gltf_file_item(file->root, "buffers", number), "uri");
    if (uri && uri->kind != TREE_scalar)
        return *why = "its buffer's uri is not a string", false;
    if (uri)
        return is_data(uri) ? decode_data(place->session, uri, bytes, why)
                            : read_beside(place, uri->text, bytes, why);
    *bytes = (GltfBytes){file->binary, file->binary_size};
    return (!number && file->binary) ||
           (*why = "its buffer has no uri, and the file no binary chunk", false);
}

/* Returns a buffer's content, which is read once; NULL and *why on failure. */
static const Buffer *buffer_of(const GltfPlace *place, GltfFile *file, size_t number,
                               const char **why)
{
    if (!gltf_file_item(file->root, "buffers", number))
        return *why = "its bufferView names no buffer", NULL;
    if (!file->buffers)
        file->buffers = ARENA_ARRAY(place->session->arena, Buffer,
                                    gltf_file_value(file->root, "buffers")->count);
    Buffer *buffer = &file->buffers[number];
    if (!buffer->read && !read_buffer(place, file, number, buffer))
        buffer->bytes = (GltfBytes){0};
    else if (!buffer->read)
        buffer->why = NULL;
    buffer->read = true;
    *why = buffer->why;
    return buffer->why ? NULL : buffer;
}

static bool read_view(const GltfPlace *place, GltfFile *file, const Tree *index, GltfBytes *bytes,
                      const char **why)
{
    const Tree *view = gltf_file_item(file->root, "bufferViews", gltf_file_whole(index, SIZE_MAX));
    const size_t number = gltf_file_whole(gltf_file_value(view, "buffer"), SIZE_MAX);
    if (!view)
        return *why = "its bufferView does not exist", false;
    const Buffer *buffer = buffer_of(place, file, number, why);
    if (!buffer)
        return false;
    const size_t offset = gltf_file_whole(gltf_file_value(view, "byteOffset"), 0),
                 length = gltf_file_whole(gltf_file_value(view, "byteLength"), SIZE_MAX);
    if (offset > buffer->bytes.size || length > buffer->bytes.size - offset)
        return *why = "its bufferView exceeds its buffer", false;
    *bytes = (GltfBytes){buffer->bytes.at + offset, length};
    return true;
}

/* Indexes the sources that the session has opened since the last call. */
static void index_sources(Session *session, GltfFiles *files)
{
    for (; files->indexed < session->source_count; files->indexed++) {
        const uint32_t number = (uint32_t)files->indexed;
        const char *path = session_path_beside(session, "", session->sources[number].name);
        if ((size_t)names_add(session->arena, &files->source_paths, path) == files->source_count)
            ARENA_PUSH(session->arena, files->sources, files->source_count, files->source_capacity,
                       number);
    }
}

/* Finds the source with this path among the documents already read, or reads it. */
static bool find_source(Session *session, GltfFiles *files, const char *path, uint32_t *found,
                        const char **why)
{
    index_sources(session, files);
    const int known = names_find(&files->source_paths, path);
    if (known >= 0)
        return *found = files->sources[known], true;
    session_depend_on(session, path);
    size_t size;
    char *text = session_read_file(session, path, &size, why);
    if (!text)
        return false;
    const Source source = {
        .name = path, .text = arena_string(session->arena, text, size), .size = size};
    free(text);
    *found = (uint32_t)session->source_count;
    ARENA_PUSH(session->arena, session->sources, session->source_count, session->source_capacity,
               source);
    return gltf_chunks_open(session, *found) || (*why = "the file is broken", false);
}

static GltfFile *file_of(Session *session, GltfFiles *files, const char *path)
{
    uint32_t source = 0;
    const size_t number = (size_t)names_add(session->arena, &files->paths, path);
    if (number < files->count)
        return files->at[number];
    GltfFile *file = ARENA_NEW(session->arena, GltfFile);
    ARENA_PUSH(session->arena, files->at, files->count, files->capacity, file);
    *file = (GltfFile){.why = "the file is broken"};
    if (!find_source(session, files, path, &source, &file->why))
        return file;
    file->root = read_json_of(session, source);
    file->binary = session->sources[source].binary;
    file->binary_size = session->sources[source].binary_size;
    return file;
}

bool gltf_file_picture(Session *session, GltfFiles *files, const char *path, GltfBytes *picture,
                       const char **why)
{
    const char *mark = strstr(path, GLTF_IMAGES), *number = mark + sizeof GLTF_IMAGES - 1;
    const size_t digits = strspn(number, "0123456789");
    const GltfPlace place = {session, files,
                             arena_string(session->arena, path, (size_t)(mark - path))};
    GltfFile *file = file_of(session, files, place.path);
    if (!file->root)
        return *why = file->why, false;
    const Tree *image = digits && digits <= MAX_DIGITS && !number[digits]
                            ? gltf_file_item(file->root, "images", strtoul(number, NULL, 10))
                            : NULL;
    const Tree *uri = gltf_file_value(image, "uri"), *view = gltf_file_value(image, "bufferView");
    if (!image)
        return *why = "the list images of the file has no such item", false;
    if (view)
        return read_view(&place, file, view, picture, why);
    if (!uri || uri->kind != TREE_scalar)
        return *why = "the file has neither its uri nor its bufferView", false;
    return is_data(uri) ? decode_data(session, uri, picture, why)
                        : read_beside(&place, uri->text, picture, why);
}

const Tree *gltf_file_root(const GltfPlace *place, const char **why)
{
    const GltfFile *file = file_of(place->session, place->files, place->path);
    *why = file->why;
    return file->root;
}

bool gltf_file_view(const GltfPlace *place, const Tree *index, GltfBytes *bytes, const char **why)
{
    return read_view(place, file_of(place->session, place->files, place->path), index, bytes, why);
}

bool gltf_file_buffer(const GltfPlace *place, size_t number, GltfBytes *bytes, const char **why)
{
    GltfFile *file = file_of(place->session, place->files, place->path);
    const Buffer *buffer = buffer_of(place, file, number, why);
    if (buffer)
        *bytes = buffer->bytes;
    return buffer != NULL;
}
